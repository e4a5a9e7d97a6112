#include "base/spelling.h"

#include <algorithm>
#include <cctype>
#include <limits>
#include <utility>
#include <vector>

namespace partonomy {

std::size_t edit_distance(const std::string& a, const std::string& b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + (a[i - 1] != b[j - 1])});
            diagonal = above;
        }
    }
    return row.back();
}

std::string with_article(const std::string& name) {
    const bool vowel = !name.empty() && std::string("aeiouAEIOU").find(name[0]) != std::string::npos;
    return (vowel ? "an " : "a ") + name;
}

std::size_t distance_in_words(const std::string& word, const std::string& name) {
    const auto distance = [&word](const std::string& to) {
        std::size_t least = edit_distance(word, to);
        for (std::size_t i = 1; i < word.size(); ++i) {
            std::string swapped = word;
            std::swap(swapped[i - 1], swapped[i]);
            least = std::min(least, 1 + edit_distance(swapped, to));
        }
        return least;
    };
    std::size_t least = distance(name);
    for (std::size_t begin = 0, end = name.find(' '); end != std::string::npos; end = name.find(' ', begin)) {
        least = std::min(least, 1 + distance(name.substr(begin, end - begin)));
        begin = end + 1;
        if (name.find(' ', begin) == std::string::npos) least = std::min(least, 1 + distance(name.substr(begin)));
    }
    return least;
}

bool is_spelled_alike(const std::string& a, const std::string& b) {
    const auto letters = [](const std::string& word) {
        std::string found;
        for (const char c : word)
            if (c != ' ' && c != '-' && c != '_')
                found += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        return found;
    };
    return letters(a) == letters(b);
}

std::string did_you_mean(const std::vector<std::string>& words, std::span<const std::string> names, Nearness nearness) {
    constexpr std::size_t most = 4, longest = 150;  // names that are told; letters that are looked at
    std::size_t steps = 200'000'000;  // a tenth of a second: a file may declare thousands of long prefixes
    std::vector<std::string> nearest;
    std::size_t least = std::numeric_limits<std::size_t>::max();
    for (const std::string& word : words) {
        if (word.empty() || word.size() > longest) continue;
        const std::size_t limit =
            nearness == Nearness::any ? std::numeric_limits<std::size_t>::max() : 1 + word.size() / 3;
        for (const std::string& name : names) {
            const std::size_t needed = word.size() * word.size() * name.size();
            if (name.size() > longest || needed > steps) continue;
            steps -= needed;
            const std::size_t distance = is_spelled_alike(word, name) ? 0 : distance_in_words(word, name);
            if (distance > limit || distance > least) continue;
            if (distance < least) nearest.clear();
            least = distance;
            if (std::ranges::find(nearest, name) == nearest.end()) nearest.push_back(name);
        }
    }
    if (nearest.size() > most) nearest.resize(most);
    std::string text;
    for (const std::string& name : nearest) text += (text.empty() ? "\"" : " or \"") + name + "\"";
    return text.empty() ? "" : "; did you mean " + text + "?";
}

}  // namespace partonomy
