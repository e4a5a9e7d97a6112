#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace partonomy {

using Weighted = std::pair<double, double>;  ///< value, weight

/// The value below which a share of the weight lies. Reorders the values, of which there must be some. O(n).
[[nodiscard]] inline double quantile(std::vector<Weighted>& values, double share) {
    double wanted = 0;
    for (const auto& [value, weight] : values) wanted += share * weight;
    auto first = values.begin(), last = values.end();
    while (last - first > 1) {
        const auto middle = first + (last - first) / 2;
        std::nth_element(first, middle, last);
        double below = 0;
        for (auto at = first; at < middle; ++at) below += at->second;
        if (below >= wanted) {
            last = middle;
        } else {
            wanted -= below;
            first = middle;
        }
    }
    return first->first;
}

}  // namespace partonomy
