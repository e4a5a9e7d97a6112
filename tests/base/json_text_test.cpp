#include "base/json_text.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>

namespace partonomy {
namespace {

using Json = nlohmann::ordered_json;

/// The same value through both writers.
void write(JsonText& text, const Json& json) {
    if (json.is_object()) {
        text.object();
        for (const auto& [key, value] : json.items()) {
            if (value.is_object() || value.is_array()) {
                JsonText inner;
                write(inner, value);
                text.raw_member(key, inner.text());
            } else if (value.is_string()) {
                text.member(key, value.get<std::string>());
            } else if (value.is_number_integer()) {
                text.member(key, value.get<std::int64_t>());
            } else if (value.is_number()) {
                text.member(key, value.get<double>());
            } else if (value.is_boolean()) {
                text.member(key, value.get<bool>());
            } else {
                text.member(key, nullptr);
            }
        }
        text.end();
    } else if (json.is_array()) {
        text.array();
        for (const Json& value : json) write(text, value);
        text.end();
    } else if (json.is_string()) {
        text.item(json.get<std::string>());
    } else if (json.is_number_integer()) {
        text.item(json.get<std::int64_t>());
    } else if (json.is_number()) {
        text.item(json.get<double>());
    } else if (json.is_boolean()) {
        text.item(json.get<bool>());
    } else {
        text.item(nullptr);
    }
}

Json random_json(std::mt19937& random, int depth) {
    const auto pick = [&](unsigned n) { return static_cast<unsigned>(random()) % n; };
    switch (pick(depth > 0 ? 7 : 5)) {
        case 0:
            return nullptr;
        case 1:
            return pick(2) == 1;
        case 2:
            return static_cast<std::int64_t>(random()) - 2000000000;
        case 3:
            return std::ldexp(static_cast<double>(random()) - 2e9, static_cast<int>(pick(120)) - 90);
        case 4: {
            std::string words;
            for (unsigned i = pick(12); i > 0; --i) {
                const char* const pieces[] = {"a", "\"", "\\", "\n", "\x01", "é", "中", "𝄞", "/", "\x7f", "\t", " "};
                words += pieces[pick(12)];
            }
            return words;
        }
        case 5: {
            Json list = Json::array();
            for (unsigned i = pick(5); i > 0; --i) list.push_back(random_json(random, depth - 1));
            return list;
        }
        default: {
            Json object = Json::object();
            for (unsigned i = pick(5); i > 0; --i)
                object["k" + std::to_string(pick(9))] = random_json(random, depth - 1);
            return object;
        }
    }
}

TEST(JsonText, what_a_library_reads_back_is_what_was_written) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (int i = 0; i < 2000; ++i) {
        const Json json = random_json(random, 4);
        JsonText text;
        write(text, json);
        ASSERT_EQ(Json::parse(text.text()), json) << text.text();
    }
}

TEST(JsonText, one_member_a_line_when_indented) {
    JsonText json(2);
    json.object().member("name", "seat").array("empty").end().object("none").end();
    json.member("list", std::vector<int>{1, 2}).member("map", std::map<std::string, double>{{"x", 0.5}});
    json.array("lines").object_in_line().member("a", 1).member("b", std::vector<int>{1, 2}).end();
    json.object_in_line().end().end().end();
    EXPECT_EQ(json.text(), R"({
  "name": "seat",
  "empty": [],
  "none": {},
  "list": [
    1,
    2
  ],
  "map": {
    "x": 0.5
  },
  "lines": [
    {"a": 1, "b": [1, 2]},
    {}
  ]
})");
}

TEST(JsonText, numbers) {
    const auto text = [](double x) { return JsonText().item(x).text(); };
    EXPECT_EQ(text(0), "0.0");
    EXPECT_EQ(text(-3), "-3.0");
    EXPECT_EQ(text(0.1), "0.1");
    EXPECT_EQ(text(100000), "100000.0");
    EXPECT_EQ(text(1e300), "1e+300");
    EXPECT_EQ(text(std::numeric_limits<double>::infinity()), "null");
    EXPECT_EQ(text(std::numeric_limits<double>::quiet_NaN()), "null");
}

TEST(JsonText, bytes_that_are_not_utf8_are_replaced) {
    for (const char* bad : {"\xff", "\xc0\x80", "\xed\xa0\x80", "\xf5\x80\x80\x80", "\xe4\xb8", "\xc3"}) {
        const Json read = Json::parse(quoted_json(std::string("a") + bad + "z"));
        const std::string words = read.get<std::string>();
        EXPECT_EQ(words.front(), 'a');
        EXPECT_EQ(words.back(), 'z');
        EXPECT_NE(words.find("\xef\xbf\xbd"), std::string::npos);
    }
}

}  // namespace
}  // namespace partonomy
