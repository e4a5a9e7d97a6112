#include "base/json_text.h"

#include <charconv>
#include <cmath>

namespace partonomy {
namespace {

/// Length of the UTF-8 sequence that `text` starts with; 0 when it is none: broken off, overlong, or a surrogate.
std::size_t sequence_length(std::string_view text) {
    const auto byte = [&](std::size_t i) { return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U; };
    const auto continues = [&](std::size_t from, std::size_t to) {
        for (std::size_t i = from; i < to; ++i)
            if ((byte(i) & 0xc0U) != 0x80U) return false;
        return true;
    };
    const unsigned first = byte(0), second = byte(1);
    if (first < 0x80) return 1;
    if (first >= 0xc2 && first < 0xe0) return continues(1, 2) ? 2 : 0;
    if (first >= 0xe0 && first < 0xf0) {
        const bool is_overlong = first == 0xe0 && second < 0xa0, is_surrogate = first == 0xed && second >= 0xa0;
        return !is_overlong && !is_surrogate && continues(1, 3) ? 3 : 0;
    }
    if (first >= 0xf0 && first < 0xf5) {
        const bool is_overlong = first == 0xf0 && second < 0x90, is_beyond = first == 0xf4 && second >= 0x90;
        return !is_overlong && !is_beyond && continues(1, 4) ? 4 : 0;
    }
    return 0;
}

bool is_plain(char c) { return static_cast<signed char>(c) >= 0x20 && c != '"' && c != '\\'; }

}  // namespace

JsonText& JsonText::open(char bracket) {
    text_ += bracket;
    open_ += bracket;
    is_empty_ = true;
    return *this;
}

JsonText& JsonText::object_in_line() {
    before_item();
    if (in_line_ == none) in_line_ = open_.size();
    return open('{');
}

JsonText& JsonText::end() {
    const char bracket = open_.back();
    open_.pop_back();
    if (!is_empty_ && in_line_ == none) new_line();
    if (in_line_ == open_.size()) in_line_ = none;
    text_ += bracket == '{' ? '}' : ']';
    is_empty_ = false;
    return *this;
}

void JsonText::new_line() {
    if (indent_ == 0) return;
    text_ += '\n';
    text_.append(open_.size() * static_cast<std::size_t>(indent_), ' ');
}

JsonText& JsonText::before_item() {
    if (open_.empty()) return *this;
    if (!is_empty_) text_ += in_line_ == none || indent_ == 0 ? "," : ", ";
    is_empty_ = false;
    if (in_line_ == none) new_line();
    return *this;
}

JsonText& JsonText::name(std::string_view key) {
    before_item();
    write(key);
    text_ += indent_ == 0 ? ":" : ": ";
    return *this;
}

void JsonText::write_integer(std::int64_t value) {
    char buffer[24];
    text_.append(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
}

void JsonText::write(double value) {
    if (!std::isfinite(value)) return write(nullptr);
    char buffer[64];
    const double size = std::abs(value);
    const auto form =
        value == 0 || (size >= 1e-4 && size < 1e15) ? std::chars_format::fixed : std::chars_format::scientific;
    const char* end = std::to_chars(buffer, buffer + sizeof buffer, value, form).ptr;
    const std::string_view digits(buffer, static_cast<std::size_t>(end - buffer));
    text_.append(digits);
    if (digits.find_first_of(".e") == std::string_view::npos) text_ += ".0";
}

void JsonText::write(std::string_view value) {
    constexpr char hex[] = "0123456789abcdef";
    text_ += '"';
    while (!value.empty()) {
        std::size_t plain = 0;
        while (plain < value.size() && is_plain(value[plain])) ++plain;
        text_.append(value.substr(0, plain));
        value.remove_prefix(plain);
        if (value.empty()) break;
        const char c = value[0];
        std::size_t length = 1;
        switch (c) {
            case '"':
                text_ += "\\\"";
                break;
            case '\\':
                text_ += "\\\\";
                break;
            case '\n':
                text_ += "\\n";
                break;
            case '\t':
                text_ += "\\t";
                break;
            case '\r':
                text_ += "\\r";
                break;
            default:
                if (static_cast<unsigned char>(c) < 0x20) {
                    text_ += "\\u00";
                    text_ += hex[c >> 4];
                    text_ += hex[c & 15];
                } else if (length = sequence_length(value); length == 0) {
                    length = 1;
                    text_ += "\xef\xbf\xbd";
                } else {
                    text_.append(value.substr(0, length));
                }
        }
        value.remove_prefix(length);
    }
    text_ += '"';
}

std::string quoted_json(std::string_view text) { return JsonText().item(text).text(); }

}  // namespace partonomy
