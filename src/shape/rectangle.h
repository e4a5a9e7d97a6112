#pragma once

#include <limits>
#include <vector>

namespace partonomy {

/// A point or direction in the plane.
struct Planar {
    double x, y;
};

/// A rectangle in the plane, turned any way; its place is not kept.
struct Rectangle {
    Planar side{1, 0};             ///< unit direction of one side
    double width = 0, height = 0;  ///< along and across `side`
    double area = std::numeric_limits<double>::infinity();
};

/// Puts the corners of the points' convex hull into `hull`, counter-clockwise, without corners of 180 degrees. Leaves
/// the points sorted. At least one point. O(n log n).
void convex_hull(std::vector<Planar>& points, std::vector<Planar>& hull);

/// The smallest rectangle around a convex polygon. Sides are counted as at least a billionth of `size` in the area, so
/// that flat polygons are told apart; infinite area for a polygon that is a point. O(n).
[[nodiscard]] Rectangle smallest_rectangle(const std::vector<Planar>& hull, double size);

/// Area of a polygon that runs counter-clockwise.
[[nodiscard]] double area_of(const std::vector<Planar>& polygon);

[[nodiscard]] double perimeter_of(const std::vector<Planar>& polygon);

}  // namespace partonomy
