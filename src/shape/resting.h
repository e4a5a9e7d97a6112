#pragma once

#include <array>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// The six directions along the axes, in the order of the scores below: x, -x, y, -y, z, -z.
[[nodiscard]] const std::array<Vec3, 6>& axis_directions();

/// How firmly a mesh would stand on flat ground if each of the axis directions was up: 0 it would topple, 1 it stands
/// on all of its outline. O(#V).
[[nodiscard]] std::array<double, 6> resting_scores(const TriangleMesh& mesh, const TriangleGeometry& geometry);

}  // namespace partonomy
