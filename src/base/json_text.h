#pragma once

#include <concepts>
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace partonomy {

/// JSON written as it comes, without a tree of values in memory: a member or an item at a time, commas and line breaks
/// put in. Keys keep their order. Numbers are the shortest that read back as the same double; one that is not finite
/// becomes null. Bytes that are not UTF-8 become U+FFFD.
class JsonText {
public:
    /// Spaces a level, one member a line; 0: everything in one line, without spaces.
    explicit JsonText(int indent = 0) : indent_(indent) {}

    /// An object or an array as the next item; what it holds is written until end().
    JsonText& object() { return before_item().open('{'); }
    JsonText& array() { return before_item().open('['); }
    /// The same as a member of the open object.
    JsonText& object(std::string_view key) { return name(key).open('{'); }
    JsonText& array(std::string_view key) { return name(key).open('['); }
    /// An object as the next item, with all that it holds in one line.
    JsonText& object_in_line();
    /// Closes what was opened last.
    JsonText& end();

    /// The next item of the open array.
    template <typename Value>
    JsonText& item(const Value& value) {
        before_item();
        write(value);
        return *this;
    }
    /// The next member of the open object.
    template <typename Value>
    JsonText& member(std::string_view key, const Value& value) {
        name(key);
        write(value);
        return *this;
    }

    /// The same of what is JSON already.
    JsonText& raw_item(std::string_view json) {
        before_item().text_ += json;
        return *this;
    }
    JsonText& raw_member(std::string_view key, std::string_view json) {
        name(key).text_ += json;
        return *this;
    }

    /// The text so far; complete once everything is closed.
    [[nodiscard]] const std::string& text() const { return text_; }

private:
    JsonText& name(std::string_view key);
    JsonText& before_item();
    JsonText& open(char bracket);
    void new_line();

    void write(std::nullptr_t) { text_ += "null"; }
    void write(bool value) { text_ += value ? "true" : "false"; }
    void write(double value);
    void write(std::integral auto value) { write_integer(static_cast<std::int64_t>(value)); }
    void write(std::string_view value);
    void write(const std::string& value) { write(std::string_view(value)); }
    void write(const char* value) { write(std::string_view(value)); }
    template <typename First, typename Second>
    void write(const std::pair<First, Second>& pair) {
        array_of([&] { item(pair.first).item(pair.second); });
    }
    template <typename Value>
    void write(const std::vector<Value>& values) {
        array_of([&] {
            for (const Value& value : values) item(value);
        });
    }
    template <typename Value>
    void write(const std::map<std::string, Value>& values) {
        open('{');
        for (const auto& [key, value] : values) member(key, value);
        end();
    }
    void array_of(const auto& write_items) {
        open('[');
        write_items();
        end();
    }
    void write_integer(std::int64_t value);

    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    std::string text_;
    std::string open_;  ///< brackets
    int indent_;
    std::size_t in_line_ = none;  ///< brackets open around an object that stays in one line
    bool is_empty_ = true;        ///< what was opened last holds nothing yet
};

/// A text as JSON, in quotes.
[[nodiscard]] std::string quoted_json(std::string_view text);

}  // namespace partonomy
