#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace partonomy {

/// Letters to insert, leave out or exchange to turn one word into the other (Levenshtein): what "did you mean" goes by.
[[nodiscard]] std::size_t edit_distance(const std::string& a, const std::string& b);

/// "a Leg", "an Armrest".
[[nodiscard]] std::string with_article(const std::string& name);

/// How far a word is from a name of one or more words: the edit distance to the name, or to the nearest of its words
/// (which counts one more), where two neighbours that changed places count as one letter.
[[nodiscard]] std::size_t distance_in_words(const std::string& word, const std::string& name);

/// Whether two names differ in nothing but capitals, blanks, hyphens and underscores: "length-share", "length share".
[[nodiscard]] bool is_spelled_alike(const std::string& a, const std::string& b);

enum class Nearness {
    near,  ///< up to a third of the letters, and one more, may be wrong
    any,   ///< the nearest, however far
};

/// "; did you mean \"Seat\"?", or "; did you mean \"l0/l1\" or \"l0/l2\"?" where several are as near; empty when
/// none is near. `words`: what was written, in whatever ways it can be read. A name that is spelled alike is the only
/// one.
[[nodiscard]] std::string did_you_mean(const std::vector<std::string>& words, std::span<const std::string> names,
                                       Nearness nearness = Nearness::near);

}  // namespace partonomy
