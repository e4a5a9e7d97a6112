#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// Appends the triangles of one polygon, given by the vertex indices of its corners in order; concave and slightly bent
/// polygons are fine, repeated corners and triangles without area are left out. Appends nothing when the polygon has no
/// area. Triangles turn as the polygon does.
void triangulate_polygon(std::span<const Vec3> positions, std::span<const std::int32_t> corners,
                         std::vector<std::array<std::int32_t, 3>>& triangles);

/// Whether a triangle is so thin that its normal would be noise: height below 1e-12 of its longest edge.
[[nodiscard]] bool has_no_area(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace partonomy
