/* The regular expressions of XML Schema (Datatypes, appendix G): always anchored, with | ? * + {n,m}, groups, character
   classes with ranges, negation and subtraction, and the escapes \s \i \c \d. The classes \w and \p need tables of
   Unicode and are refused with advice. */

#include <algorithm>
#include <utility>

#include "knowledge/data_value.h"
#include "knowledge/text_languages.h"

namespace partonomy::knowledge::closed {
namespace {

constexpr int max_depth = 200;

const Characters& name_start_characters() {
    static const Characters set{{':', ':'},       {'A', 'Z'},       {'_', '_'},       {'a', 'z'},
                                {0xC0, 0xD6},     {0xD8, 0xF6},     {0xF8, 0x2FF},    {0x370, 0x37D},
                                {0x37F, 0x1FFF},  {0x200C, 0x200D}, {0x2070, 0x218F}, {0x2C00, 0x2FEF},
                                {0x3001, 0xD7FF}, {0xF900, 0xFDCF}, {0xFDF0, 0xFFFD}, {0x10000, 0xEFFFF}};
    return set;
}

Characters name_characters() {
    Characters set = name_start_characters();
    set.insert(set.end(), {{'-', '-'}, {'.', '.'}, {'0', '9'}, {0xB7, 0xB7}, {0x300, 0x36F}, {0x203F, 0x2040}});
    return set;
}

/// Decimal digits of all scripts of Unicode's basic plane: each script has ten in a row.
Characters digits() {
    Characters set;
    for (const char32_t zero :
         {0x30,   0x660,  0x6F0,  0x7C0,  0x966,  0x9E6,  0xA66,  0xAE6,  0xB66,  0xBE6,  0xC66,  0xCE6,  0xD66,
          0xDE6,  0xE50,  0xED0,  0xF20,  0x1040, 0x1090, 0x17E0, 0x1810, 0x1946, 0x19D0, 0x1A80, 0x1A90, 0x1B50,
          0x1BB0, 0x1C40, 0x1C50, 0xA620, 0xA8D0, 0xA900, 0xA9D0, 0xA9F0, 0xAA50, 0xABF0, 0xFF10})
        set.emplace_back(zero, zero + 9);
    return set;
}

}  // namespace

PatternParser::PatternParser(TextLanguages& languages, const std::string& pattern)
    : languages_(languages), shown_(pattern), pattern_(code_points(pattern)) {}

void PatternParser::fail(const std::string& why) const {
    throw CannotGround{"the pattern \"" + shown_ + "\" " + why + " at character " + std::to_string(next_ + 1)};
}

TextLanguages::Part PatternParser::parse() {
    Part part = alternatives();
    if (!at_end()) fail("has a ) without its (");
    return part;
}

TextLanguages::Part PatternParser::alternatives() {
    if (++depth_ > max_depth) fail("is nested too deep");
    Part part = branch();
    while (peek() == '|') {
        ++next_;
        part = languages_.either(part, branch());
    }
    --depth_;
    return part;
}

TextLanguages::Part PatternParser::branch() {
    Part part;
    while (!at_end() && peek() != '|' && peek() != ')') part = languages_.sequence(part, piece());
    return part;
}

std::pair<std::uint64_t, std::uint64_t> PatternParser::quantity() {
    const auto number = [&] {
        if (peek() < '0' || peek() > '9') fail("has { without a number");
        std::uint64_t value = 0;
        for (; peek() >= '0' && peek() <= '9'; ++next_)
            value = std::min<std::uint64_t>(1'000'000, value * 10 + (peek() - '0'));
        return value;
    };
    switch (peek()) {
        case '?':
            ++next_;
            return {0, 1};
        case '*':
            ++next_;
            return {0, uncountable};
        case '+':
            ++next_;
            return {1, uncountable};
        case '{':
            break;
        default:
            return {1, 1};
    }
    ++next_;
    const std::uint64_t least = number();
    std::uint64_t most = least;
    if (peek() == ',') {
        ++next_;
        most = peek() == '}' ? uncountable : number();
    }
    if (peek() != '}') fail("has { without its }");
    ++next_;
    if (most < least) fail("has a { } whose numbers are the wrong way round");
    return {least, most};
}

TextLanguages::Part PatternParser::piece() {
    const std::size_t begin = next_;
    Part part = atom();
    const std::size_t quantifier = next_;
    const auto [least, most] = quantity();
    const std::size_t end = next_;
    if (most == 0) return {};
    if (part.first.empty()) return part;  // repeats the empty string
    // Copies are made by reading the atom again.
    const auto again = [&] {
        next_ = begin;
        Part copy = atom();
        next_ = end;
        return copy;
    };
    if (quantifier == end) return part;
    Part result;
    bool is_used = false;
    const auto fresh = [&] { return std::exchange(is_used, true) ? again() : part; };
    for (std::uint64_t i = 0; i < least; ++i) result = languages_.sequence(result, fresh());
    if (most == uncountable) return languages_.sequence(result, languages_.repeated(fresh()));
    Part optional;  // (a(a(a)?)?)?, from the inside out
    for (std::uint64_t i = least; i < most; ++i) {
        optional = languages_.sequence(fresh(), optional);
        optional.nullable = true;
    }
    return languages_.sequence(result, optional);
}

TextLanguages::Part PatternParser::atom() {
    const char32_t c = peek();
    if (c == '(') {
        ++next_;
        Part part = alternatives();
        if (peek() != ')') fail("has a ( without its )");
        ++next_;
        return part;
    }
    if (c == '[') return languages_.one_of(bracketed());
    if (c == '\\') return languages_.one_of(escaped());
    if (c == '?' || c == '*' || c == '+' || c == '{' || c == '}' || c == ']')
        fail("has a " + std::string(1, static_cast<char>(c)) +
             " that stands for nothing; write \\ before it to mean itself");
    ++next_;
    if (c == '.') return languages_.one_of(complement({{'\n', '\n'}, {'\r', '\r'}}));
    return languages_.one_of({{c, c}});
}

Characters PatternParser::escaped() {
    ++next_;
    const char32_t c = peek();
    if (at_end()) fail("ends in a \\");
    ++next_;
    const Characters spaces{{'\t', '\n'}, {'\r', '\r'}, {' ', ' '}};
    switch (c) {
        case 'n':
            return {{'\n', '\n'}};
        case 'r':
            return {{'\r', '\r'}};
        case 't':
            return {{'\t', '\t'}};
        case 's':
            return spaces;
        case 'S':
            return complement(spaces);
        case 'i':
            return name_start_characters();
        case 'I':
            return complement(name_start_characters());
        case 'c':
            return name_characters();
        case 'C':
            return complement(name_characters());
        case 'd':
            return digits();
        case 'D':
            return complement(digits());
        default:
            break;
    }
    if (std::u32string_view(U"\\|.-^?*+{}()[]").find(c) != std::u32string_view::npos) return {{c, c}};
    if (c == 'w' || c == 'W' || c == 'p' || c == 'P')
        fail("uses \\" + std::string(1, static_cast<char>(c)) +
             ", which is not supported; write the characters out, like [A-Za-z0-9_],");
    fail("has an escape that XML Schema does not know");
}

Characters PatternParser::bracketed() {
    if (++depth_ > max_depth) fail("is nested too deep");
    ++next_;
    const bool is_negated = peek() == '^';
    if (is_negated) ++next_;
    Characters set, without;
    bool is_first = true;
    while (peek() != ']' || is_first) {
        if (at_end()) fail("has a [ without its ]");
        if (peek() == '-' && !is_first && next_ + 1 < pattern_.size() && pattern_[next_ + 1] == '[') {
            ++next_;
            without = bracketed();
            if (peek() != ']') fail("has something after a subtraction");
            break;
        }
        is_first = false;
        const auto member = [&]() -> Characters {
            if (peek() == '\\') return escaped();
            if (peek() == '[' || at_end()) fail("has a [ inside [ ]; write \\[ to mean itself");
            return {{pattern_[next_], pattern_[next_++]}};
        };
        Characters some = member();
        const bool is_range =
            peek() == '-' && next_ + 1 < pattern_.size() && pattern_[next_ + 1] != ']' && pattern_[next_ + 1] != '[';
        if (is_range) {
            ++next_;
            const Characters end = member();
            if (some.size() != 1 || end.size() != 1 || some[0].first != some[0].second ||
                end[0].first != end[0].second || end[0].first < some[0].first)
                fail("has a range whose ends are the wrong way round");
            some[0].second = end[0].first;
        }
        set.insert(set.end(), some.begin(), some.end());
    }
    ++next_;
    --depth_;
    if (is_negated) set = complement(set);
    if (without.empty()) return set;
    Characters outside = complement(set);
    outside.insert(outside.end(), without.begin(), without.end());
    return complement(outside);
}

}  // namespace partonomy::knowledge::closed
