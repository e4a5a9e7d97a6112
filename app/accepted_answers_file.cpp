#include "app/accepted_answers_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "base/files.h"
#include "base/spelling.h"

namespace partonomy::app {
namespace {

using nlohmann::json;

json parse(const std::string& text, const std::string& path) {
    try {
        return json::parse(text);
    } catch (const json::parse_error& error) {
        const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        throw UsageError(
            at(path, 1 + std::count(text.begin(), end, '\n'),
               "is no JSON; right would be [{\"part\": 3, \"feature\": \"Shape\", \"value\": \"Stick\"}]"));
    }
}

}  // namespace

std::vector<LearnedAnswer> load_accepted_answers(const std::string& path) {
    const json list = parse(read_file(path), path);
    if (!list.is_array())
        throw UsageError(at(path, 0,
                            "is no list of answers; right would be [{\"part\": 3, \"feature\": \"Shape\", \"value\": "
                            "\"Stick\"}]"));
    std::vector<LearnedAnswer> answers;
    for (const json& each : list) {
        const auto wrong = [&](const std::string& what) {
            throw UsageError(at(path, 0, fmt::format("answer {}: {}", answers.size() + 1, what)));
        };
        if (!each.is_object()) wrong("is no {\"part\": …, \"feature\": …, \"value\": …}");
        LearnedAnswer answer;
        for (const auto& [key, value] : each.items()) {
            static const std::vector<std::string> keys{"part",  "feature",  "value",   "yes",
                                                       "score", "accepted", "measured"};
            if (std::ranges::find(keys, key) == keys.end())
                wrong(fmt::format("\"{}\" means nothing here{}", key, did_you_mean({key}, keys, Nearness::any)));
            if (key == "part") {
                if (!value.is_number_integer() || value < 0 || value > 1'000'000'000)
                    wrong("\"part\" should be the number of a part");
                answer.part = value.get<int>();
            } else if (key == "yes") {
                if (!value.is_boolean()) wrong("\"yes\" should be true or false");
                answer.yes = value.get<bool>();
            } else if (key == "feature" || key == "value") {
                if (!value.is_string()) wrong(fmt::format("\"{}\" should be a text", key));
                (key == "feature" ? answer.feature : answer.value) = value.get<std::string>();
            }
        }
        for (const char* key : {"part", "feature", "value"})
            if (!each.contains(key)) wrong(fmt::format("has no \"{}\"", key));
        answers.push_back(std::move(answer));
    }
    return answers;
}

}  // namespace partonomy::app
