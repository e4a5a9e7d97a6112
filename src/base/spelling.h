#pragma once

#include <cstddef>
#include <string>

namespace partonomy {

/// Letters to insert, leave out or exchange to turn one word into the other (Levenshtein): what "did you mean" goes by.
[[nodiscard]] std::size_t edit_distance(const std::string& a, const std::string& b);

}  // namespace partonomy
