#pragma once

#include <cstddef>
#include <string>

namespace partonomy {

/// Letters to insert, leave out or exchange to turn one word into the other (Levenshtein): what "did you mean" goes by.
[[nodiscard]] std::size_t edit_distance(const std::string& a, const std::string& b);

/// "a Leg", "an Armrest".
[[nodiscard]] std::string with_article(const std::string& name);

/// How far a word is from a name of one or more words: the edit distance to the name, or to the nearest of its words
/// (which counts one more), where two neighbours that changed places count as one letter.
[[nodiscard]] std::size_t distance_in_words(const std::string& word, const std::string& name);

}  // namespace partonomy
