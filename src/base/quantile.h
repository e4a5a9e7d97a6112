#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace partonomy {

using Weighted = std::pair<double, double>;  ///< value, weight

/// The value below which a share of the weight lies. Sorts the values, of which there must be some.
[[nodiscard]] inline double quantile(std::vector<Weighted>& values, double share) {
    std::ranges::sort(values);
    double total = 0, sum = 0;
    for (const auto& [value, weight] : values) total += weight;
    for (const auto& [value, weight] : values)
        if ((sum += weight) >= share * total) return value;
    return values.back().first;
}

}  // namespace partonomy
