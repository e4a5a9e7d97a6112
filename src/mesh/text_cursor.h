#pragma once

#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// Walks over the text of a mesh file word by word and knows its line, which is only counted when an error asks for it.
/// `read` takes one value from the current line and answers whether there was one; it never crosses a line end.
class TextCursor {
public:
    /// Text from `comment` to the end of its line counts as blank; '\0' for formats without comments.
    TextCursor(std::string_view bytes, const std::string& name, char comment)
        : begin_(bytes.data()), here_(bytes.data()), end_(bytes.data() + bytes.size()), name_(name), comment_(comment) {
        line_break_ = bytes.find('\n') == std::string_view::npos ? '\r' : '\n';
        if (bytes.starts_with("\xEF\xBB\xBF")) here_ += 3;
    }

    /// Skips blanks and a comment; true when nothing is left on this line.
    [[nodiscard]] bool at_line_end() {
        while (here_ < end_ && is_blank(*here_)) ++here_;
        if (here_ == end_ || *here_ == line_break_) return true;
        if (comment_ == '\0' || *here_ != comment_) return false;
        to_line_end();
        return true;
    }

    /// Skips blanks, comments and empty lines; false at the end of the file.
    [[nodiscard]] bool find_content() {
        while (at_line_end()) {
            if (here_ == end_) return false;
            ++here_;
        }
        return true;
    }

    /// Goes on at a position of the same text.
    void go_to(const char* position) { here_ = position; }

    void next_line() {
        to_line_end();
        if (here_ < end_) ++here_;
    }

    /// The next word of this line; empty at its end.
    [[nodiscard]] std::string_view word() {
        if (at_line_end()) return {};
        const char* start = here_;
        while (here_ < end_ && !is_blank(*here_) && *here_ != line_break_) ++here_;
        return {start, static_cast<std::size_t>(here_ - start)};
    }

    /// A number of type double or an integer type, followed by a blank or the end of the line. When false, the cursor
    /// stands before the offending word.
    template <class Number>
    [[nodiscard]] bool read(Number& value) {
        if (at_line_end()) return false;
        const char* stop = parse_number(here_, end_, value);
        if (stop == nullptr || (stop < end_ && !is_blank(*stop) && *stop != line_break_ && *stop != comment_))
            return false;
        here_ = stop;
        return true;
    }

    /// The number at the start of [begin, end), a leading plus sign allowed; the position after it, null when there is
    /// none. "nan" and "inf" are read as such, for the caller to refuse.
    template <class Number>
    [[nodiscard]] static const char* parse_number(const char* begin, const char* end, Number& value) {
        if (begin < end && *begin == '+' && begin + 1 < end && begin[1] != '-') ++begin;
        const auto [stop, error] = std::from_chars(begin, end, value);
        if (error == std::errc()) return stop;
        if constexpr (std::is_floating_point_v<Number>) {
            if (error == std::errc::result_out_of_range) {  // too small is as good as zero, too large is infinite
                value = is_tiny(begin, stop) ? Number(0) : std::numeric_limits<Number>::infinity();
                return stop;
            }
        }
        return nullptr;
    }

    [[nodiscard]] std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - here_); }
    [[nodiscard]] const char* position() const { return here_; }
    [[nodiscard]] const std::string& name() const { return name_; }

    /// The 1-based line of a position in the text.
    [[nodiscard]] long line_of(const char* position) const;

    /// Throws a MeshError that names the current line.
    [[noreturn]] void fail(const std::string& sentence) const { fail_at(here_, sentence); }
    [[noreturn]] void fail_at(const char* position, const std::string& sentence) const;

    /// Throws: what stands here instead of what `sentence` says was needed.
    [[noreturn]] void fail_here(const std::string& needed);

private:
    [[nodiscard]] bool is_blank(char c) const {
        return c == ' ' || c == '\t' || (c == '\r' && line_break_ != '\r') || c == '\v' || c == '\f';
    }
    void to_line_end() {
        if (here_ == end_) return;
        const void* found = std::memchr(here_, line_break_, bytes_left());
        here_ = found == nullptr ? end_ : static_cast<const char*>(found);
    }
    static bool is_tiny(const char* begin, const char* end);

    const char* begin_;
    const char* here_;
    const char* end_;
    const std::string& name_;
    char comment_;
    char line_break_;
};

/// No coordinate of a mesh is larger: products of three of them must stay finite.
inline constexpr double largest_coordinate = 1e60;

/// Why a vertex cannot be used ("coordinate y of vertex 3 is nan, ..."), empty when it can.
/// `vertex_number` counts as the format does.
[[nodiscard]] std::string what_is_wrong_with(const Vec3& point, std::int64_t vertex_number);

[[nodiscard]] inline bool is_usable(const Vec3& point) {
    return std::abs(point.x()) <= largest_coordinate && std::abs(point.y()) <= largest_coordinate &&
           std::abs(point.z()) <= largest_coordinate;
}

/// The three coordinates of a vertex from the current line. Throws MeshError when there are fewer, or not finite ones.
[[nodiscard]] Vec3 read_point(TextCursor& cursor, std::int64_t vertex_number);

}  // namespace partonomy
