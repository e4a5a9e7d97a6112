#pragma once

#include <cstdint>
#include <vector>

namespace partonomy {

/// A fuzzy map (paper §3.4.3): how much each triangle belongs to the region. Triangles that are not listed have
/// membership 0.
struct Region {
    std::vector<std::int32_t> triangles;  ///< ascending
    std::vector<float> memberships;       ///< same length, in (0, 1]
};

}  // namespace partonomy
