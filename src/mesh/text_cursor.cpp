#include "mesh/text_cursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>

#include "base/errors.h"

namespace partonomy {
namespace {

/// A word of the file as an error sentence can show it: short and printable.
std::string shown(std::string_view word) {
    std::string text;
    for (const char c : word.substr(0, 24)) text += c >= ' ' && c <= '~' ? c : '?';
    return word.size() > 24 ? text + "..." : text;
}

}  // namespace

long TextCursor::line_of(const char* position) const { return 1 + std::count(begin_, position, line_break_); }

void TextCursor::fail_at(const char* position, const std::string& sentence) const {
    throw MeshError(at(name_, line_of(position), sentence));
}

void TextCursor::fail_here(const std::string& needed) {
    if (at_line_end()) fail(fmt::format("{} ends too early; {}", here_ == end_ ? "the file" : "this line", needed));
    const char* start = here_;
    const std::string_view found = word();
    fail_at(start, fmt::format("'{}' cannot stand here; {}", shown(found), needed));
}

bool TextCursor::is_tiny(const char* begin, const char* end) {
    return std::abs(std::strtod(std::string(begin, end).c_str(), nullptr)) < 1;
}

std::string what_is_wrong_with(const Vec3& point, std::int64_t vertex_number) {
    for (int axis = 0; axis < 3; ++axis) {
        const double value = point[axis];
        if (std::abs(value) <= largest_coordinate) continue;
        if (std::isfinite(value))
            return fmt::format("coordinate {} of vertex {} is {}, further out than the {:g} that can be computed with",
                               "xyz"[axis], vertex_number, value, largest_coordinate);
        return fmt::format("coordinate {} of vertex {} is {}; every coordinate must be a finite number", "xyz"[axis],
                           vertex_number, value);
    }
    return {};
}

Vec3 read_point(TextCursor& cursor, std::int64_t vertex_number) {
    Vec3 point;
    for (int axis = 0; axis < 3; ++axis)
        if (!cursor.read(point[axis]))
            cursor.fail_here(fmt::format("vertex {} needs three numbers x y z", vertex_number));
    if (!is_usable(point)) cursor.fail(what_is_wrong_with(point, vertex_number));
    return point;
}

}  // namespace partonomy
