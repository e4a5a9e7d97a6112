#pragma once

#include <cstdint>
#include <vector>

#include "shape/find_parts.h"

namespace partonomy {

/// The box of a part and how well the part fills it. `triangles` must not be empty.
struct PartBox {
    OrientedBox box;
    double fit = 1;                  ///< area-weighted mean of the memberships
    std::vector<float> memberships;  ///< fitting score of each triangle, in (0, 1]
};

/// On a noisy mesh the sides of the box are where the walls are, not where the outermost points are. threads <= 0: all
/// cores; the same on any number.
[[nodiscard]] PartBox measure_part(const TriangleMesh& mesh, const TriangleGeometry& geometry,
                                   const std::vector<std::int32_t>& triangles, bool is_noisy, int threads = 1);

}  // namespace partonomy
