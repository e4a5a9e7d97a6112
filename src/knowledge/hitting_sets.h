#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "knowledge/steps.h"

namespace partonomy::knowledge {

/// The set of least weight (then least size, then first in lexicographic order) that shares an element with each of
/// `sets` and does not contain all of any of `forbidden`; elements are indices into `weights`. nullopt when there is
/// none. Ascending. Branch and bound: exponential in the size of the answer, fast for the dozens of small sets that
/// explanations have. Throws OutOfSteps.
[[nodiscard]] std::optional<std::vector<std::size_t>> minimum_hitting_set(
    const std::vector<std::vector<std::size_t>>& sets, const std::vector<std::vector<std::size_t>>& forbidden,
    const std::vector<double>& weights, Steps* steps = nullptr);

}  // namespace partonomy::knowledge
