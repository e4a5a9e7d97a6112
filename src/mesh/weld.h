#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// For each point the index of the first point, in file order, that it is merged into (itself for most); -1 for points
/// that are not `used`. Two points merge when they are equal or closer than `distance` (>= 0); a point joins the first
/// representative found within reach, so chains of close points do not creep. O(#points) unless many points crowd
/// within a few `distance`s of each other. Deterministic.
[[nodiscard]] std::vector<std::int32_t> weld_points(std::span<const Vec3> points, const std::vector<bool>& used,
                                                    double distance);

}  // namespace partonomy
