#pragma once

#include <Eigen/Core>
#include <vector>

namespace partonomy {

/// Area of the convex hull of points in the plane; 0 for fewer than three. O(n) where few points are on the rim.
[[nodiscard]] double hull_area(std::vector<Eigen::Vector2d> points);

}  // namespace partonomy
