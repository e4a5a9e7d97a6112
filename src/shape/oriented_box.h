#pragma once

#include <Eigen/Core>
#include <span>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// A box at any angle, its sides sorted: lengths[0] >= lengths[1] >= lengths[2] (l0, l1, l2 of paper §6.3).
struct OrientedBox {
    Vec3 centre;
    Eigen::Matrix3d axes;  ///< columns: unit directions of the three lengths, right-handed
    Vec3 lengths;
    [[nodiscard]] double volume() const { return lengths.prod(); }
};

/// The smallest oriented box that holds all points, as found by a deterministic search. The points need not be on a
/// hull; one point or a flat set gives zero lengths. Throws std::invalid_argument when `points` is empty.
[[nodiscard]] OrientedBox smallest_box(std::span<const Vec3> points);

}  // namespace partonomy
