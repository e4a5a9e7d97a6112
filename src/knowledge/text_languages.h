#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <utility>
#include <vector>

// Inside the closed-world reasoner: sets of strings, and how they cut all strings into cells.

namespace partonomy::knowledge::closed {

/// Without bound: infinitely many, or more than anybody counts.
inline constexpr std::uint64_t uncountable = std::numeric_limits<std::uint64_t>::max();

/// Saturating arithmetic on how many literals there are.
[[nodiscard]] std::uint64_t saturating_sum(std::uint64_t a, std::uint64_t b);
[[nodiscard]] std::uint64_t saturating_product(std::uint64_t a, std::uint64_t b);

/// Ranges of code points, first and last, ascending and apart.
using Characters = std::vector<std::pair<char32_t, char32_t>>;

/// Sets of strings, each given by a pattern or by lengths, and the cells into which they cut all strings.
class TextLanguages {
public:
    struct Cell {
        std::vector<bool> inside;    ///< by language
        std::uint64_t capacity = 0;  ///< how many strings it has, `uncountable` when infinite
    };

    /// The number of the language. Throws CannotGround for what is no regular expression of XML Schema, or one that is
    /// not supported (\w, \p), or too large.
    std::size_t add_pattern(const std::string& pattern);
    /// Strings of `least` to `most` characters.
    std::size_t add_length(std::uint64_t least, std::uint64_t most);

    /// All strings, cut by all languages; every string is in exactly one cell. Throws CannotGround when that takes too
    /// many states.
    [[nodiscard]] std::vector<Cell> cut() const;

    /// By language, whether the string is in it.
    [[nodiscard]] std::vector<bool> inside(const std::string& text) const;

private:
    friend class PatternParser;
    /// A set of positions of an automaton (Glushkov): where a word may begin, end, and whether it may be empty.
    struct Part {
        std::vector<int> first, last;
        bool nullable = true;
    };
    int add_position(const Characters& characters);
    [[nodiscard]] Part one_of(const Characters& characters);
    [[nodiscard]] Part sequence(const Part& a, const Part& b);
    [[nodiscard]] Part either(const Part& a, const Part& b) const;
    [[nodiscard]] Part repeated(const Part& a);
    std::size_t add_language(const Part& part);
    /// Positions that may be read after one of these, ascending.
    [[nodiscard]] std::vector<int> after(const std::vector<int>& positions) const;
    [[nodiscard]] std::vector<int> begin() const;
    [[nodiscard]] std::vector<bool> ends_at(const std::vector<int>& positions) const;
    [[nodiscard]] std::vector<bool> has_empty() const;

    std::vector<Characters> positions_;     ///< the characters that are read on the way into each position
    std::vector<std::vector<int>> follow_;  ///< by position
    std::vector<Part> languages_;
};

/// All characters of XML less `some`; `some` need not be sorted.
[[nodiscard]] Characters complement(Characters some);

/// The code points of UTF-8 text; what is broken becomes U+FFFD.
[[nodiscard]] std::u32string code_points(const std::string& text);

/// Parses a pattern of XML Schema into `languages`.
class PatternParser {
public:
    PatternParser(TextLanguages& languages, const std::string& pattern);
    [[nodiscard]] TextLanguages::Part parse();

private:
    using Part = TextLanguages::Part;
    [[nodiscard]] Part alternatives();
    [[nodiscard]] Part branch();
    [[nodiscard]] Part piece();
    [[nodiscard]] Part atom();
    [[nodiscard]] Characters escaped();
    [[nodiscard]] Characters bracketed();
    [[nodiscard]] std::pair<std::uint64_t, std::uint64_t> quantity();
    [[nodiscard]] bool at_end() const { return next_ == pattern_.size(); }
    [[nodiscard]] char32_t peek() const { return at_end() ? 0 : pattern_[next_]; }
    [[noreturn]] void fail(const std::string& why) const;

    TextLanguages& languages_;
    std::string shown_;
    std::u32string pattern_;
    std::size_t next_ = 0;
    int depth_ = 0;
};

}  // namespace partonomy::knowledge::closed
