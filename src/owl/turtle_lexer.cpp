#include "owl/turtle_lexer.h"

#include <cstdint>
#include <cstring>

#include "base/errors.h"
#include "owl/rdf_graph.h"
#include "owl/source_text.h"

namespace partonomy::owl {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool is_digit(char c) { return c >= '0' && c <= '9'; }
/// Letters beyond ASCII are all taken as letters of names: the grammar's exceptions (×, ÷, …) help nobody.
bool is_name_char(char c) {
    return is_letter(c) || is_digit(c) || c == '_' || c == '-' || static_cast<unsigned char>(c) >= 0x80;
}
bool is_hex(char c) { return is_digit(c) || (c >= 'a' && c <= 'f') || (c >= 'A' && c <= 'F'); }
bool is_one_of(char c, const char* set) { return c != '\0' && std::strchr(set, c) != nullptr; }

}  // namespace

void TurtleLexer::fail(long where, const std::string& sentence) const {
    throw OntologyError(at(file_, where, sentence));
}

std::string TurtleLexer::shown() const {
    return kind == TurtleToken::end ? "the end of the file" : quoted_token(text_, begin_, at_);
}

void TurtleLexer::next() {
    if (at_ == 0 && text_.starts_with("\xEF\xBB\xBF")) at_ = 3;
    at_ = skip_blanks(text_, at_, at_line_);
    begin_ = at_;
    line = at_line_;
    text.clear();
    local.clear();
    if (at_ >= text_.size()) {
        kind = TurtleToken::end;
        return;
    }
    const char c = peek();
    if (c == '<') {
        if (peek(1) == '<') fail(line, "'<<' begins a triple of RDF-star, which OWL 2 does not have");
        read_iri();
    } else if (c == '"' || c == '\'') {
        read_string(c);
    } else if (c == '@') {
        read_at_word();
    } else if (c == '^') {
        if (peek(1) != '^') fail(line, "'^' alone has no meaning; a datatype is written '^^xsd:double'");
        kind = TurtleToken::datatype;
        at_ += 2;
    } else if (is_one_of(c, ";,[]()") || (c == '.' && !is_digit(peek(1)))) {
        kind = TurtleToken::mark;
        text = c;
        ++at_;
    } else if (is_digit(c) || is_one_of(c, "+-.")) {
        read_number();
    } else {
        read_word();
    }
}

void TurtleLexer::read_code_point(std::size_t digits) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < digits; ++i) {
        const char c = peek();
        if (!is_hex(c)) fail(at_line_, "'\\u' wants four hexadecimal digits, '\\U' eight");
        value = value * 16 + static_cast<std::uint32_t>(is_digit(c) ? c - '0' : (c | 0x20) - 'a' + 10);
        ++at_;
    }
    if (value == 0 || !append_utf8(text, value)) fail(at_line_, "the escape names no character of Unicode");
}

void TurtleLexer::read_iri() {
    kind = TurtleToken::iri;
    ++at_;
    for (;;) {
        const char c = peek();
        if (c == '>') break;
        if (c == '\0' || c == '\n')
            fail(line, "the IRI " + shown() + " is not closed; it should end with '>' on its line");
        if (c == '\\') {
            ++at_;
            const char letter = peek();
            if (letter != 'u' && letter != 'U') fail(line, "an IRI has no escapes but '\\u' and '\\U'");
            ++at_;
            read_code_point(letter == 'u' ? 4 : 8);
            const char last = text.back();
            if (is_one_of(last, "<>\"{}|^`\\") || (last >= 0 && last <= ' '))
                fail(line, "an IRI cannot hold this escaped character");
            continue;
        }
        if (is_one_of(c, "<\"{}|^`") || (c >= 0 && c <= ' ')) {
            fail(line, std::string("an IRI cannot hold ") +
                           (c == ' '                   ? "a space"
                            : is_one_of(c, "<\"{}|^`") ? std::string("'") + c + "'"
                                                       : "a control character") +
                           "; the '>' that ends " + shown() + " may be missing");
        }
        text += c;
        ++at_;
    }
    ++at_;
}

void TurtleLexer::read_escape() {
    constexpr const char* letters = "tbnrf\"'\\";
    constexpr const char* values = "\t\b\n\r\f\"'\\";
    ++at_;
    const char c = peek();
    if (c == 'u' || c == 'U') {
        ++at_;
        read_code_point(c == 'u' ? 4 : 8);
        return;
    }
    if (!is_one_of(c, letters))
        fail(at_line_, "a backslash in a string must be doubled or begin an escape such as \\n or \\u00e9");
    text += values[std::strchr(letters, c) - letters];
    ++at_;
}

void TurtleLexer::read_string(char quote) {
    kind = TurtleToken::string;
    const bool is_long = peek(1) == quote && peek(2) == quote;
    at_ += is_long ? 3 : 1;
    for (;;) {
        if (at_ >= text_.size()) fail(line, "the string that begins here is never closed");
        const char c = peek();
        if (c == quote && (!is_long || (peek(1) == quote && peek(2) == quote))) break;
        if (c == '\\') {
            read_escape();
            continue;
        }
        if (c == '\n') {
            if (!is_long)
                fail(line,
                     "the string is not closed on its line; a text of several lines stands between \"\"\" and \"\"\"");
            ++at_line_;
        }
        text += c;
        ++at_;
    }
    at_ += is_long ? 3 : 1;
}

void TurtleLexer::read_at_word() {
    std::size_t end = at_ + 1;
    while (end < text_.size() &&
           (is_letter(text_[end]) || ((is_digit(text_[end]) || text_[end] == '-') && end > at_ + 1)))
        ++end;
    text = std::string(text_.substr(at_ + 1, end - at_ - 1));
    at_ = end;
    if (text.empty() || text.back() == '-') fail(line, "'@' begins a language such as @en, or @prefix or @base");
    kind = text == "prefix" || text == "base" ? TurtleToken::directive : TurtleToken::language;
}

void TurtleLexer::read_number() {
    std::size_t end = at_;
    const auto digits = [&] {
        const std::size_t from = end;
        while (end < text_.size() && is_digit(text_[end])) ++end;
        return end - from;
    };
    const auto here = [&](std::size_t ahead = 0) { return end + ahead < text_.size() ? text_[end + ahead] : '\0'; };
    if (is_one_of(here(), "+-")) ++end;
    kind = TurtleToken::integer;
    std::size_t count = digits();
    if (here() == '.' && (is_digit(here(1)) ||
                          (count > 0 && is_one_of(here(1), "eE") && (is_digit(here(2)) || is_one_of(here(2), "+-"))))) {
        kind = TurtleToken::decimal;
        ++end;
        count += digits();
    }
    if (count == 0) fail(line, between("'", std::string(text_.substr(at_, 1)), "' begins no number"));
    if (is_one_of(here(), "eE")) {
        kind = TurtleToken::floating;
        ++end;
        if (is_one_of(here(), "+-")) ++end;
        if (digits() == 0) fail(line, "the exponent of a number has no digits");
    }
    text = std::string(text_.substr(at_, end - at_));
    at_ = end;
}

/// The end of a name's part from `from` on: dots belong to it unless they are last; only local parts have ':' and
/// escapes.
std::size_t TurtleLexer::name_end(std::size_t from, bool is_local) const {
    std::size_t end = from;
    std::size_t last = from;
    while (end < text_.size()) {
        const char c = text_[end];
        if (is_name_char(c) || (is_local && c == ':')) {
            last = ++end;
        } else if (c == '.') {
            ++end;
        } else if (is_local && c == '%') {
            if (end + 2 >= text_.size() || !is_hex(text_[end + 1]) || !is_hex(text_[end + 2])) break;
            last = end += 3;
        } else if (is_local && c == '\\') {
            if (end + 1 >= text_.size() || !is_one_of(text_[end + 1], "_~.-!$&'()*+,;=/?#@%")) break;
            last = end += 2;
        } else {
            break;
        }
    }
    return last;
}

std::string TurtleLexer::unescaped_local(std::string_view raw) const {
    if (raw.find('\\') == std::string_view::npos) return std::string(raw);
    std::string out;
    for (std::size_t i = 0; i < raw.size(); ++i) {
        if (raw[i] == '\\') ++i;
        out += raw[i];
    }
    return out;
}

void TurtleLexer::read_word() {
    const bool is_blank = peek() == '_' && peek(1) == ':';
    const std::size_t end = is_blank ? name_end(at_ + 2, false) : name_end(at_, false);
    if (is_blank) {
        kind = TurtleToken::blank;
        text = std::string(text_.substr(at_ + 2, end - at_ - 2));
        at_ = end;
        if (text.empty()) fail(line, "'_:' wants a label for the blank node, such as _:x1");
        return;
    }
    text = std::string(text_.substr(at_, end - at_));
    if (end < text_.size() && text_[end] == ':') {
        kind = TurtleToken::name;
        const std::size_t stop = name_end(end + 1, true);
        local = unescaped_local(text_.substr(end + 1, stop - end - 1));
        at_ = stop;
        return;
    }
    kind = TurtleToken::keyword;
    at_ = end;
    if (text.empty()) {
        ++at_;
        while (at_ < text_.size() && (text_[at_] & 0xC0) == 0x80) ++at_;
        const std::string what = shown();
        fail(line, static_cast<unsigned char>(what[1]) < ' ' || what[1] == 127
                       ? "a control character stands where a term should be"
                       : what + " cannot stand here");
    }
}

}  // namespace partonomy::owl
