#include "base/spelling.h"

#include <algorithm>
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

}  // namespace partonomy
