#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// A convex, flat polygon.
using Polygon = std::vector<Vec3>;

/// What of the polygon lies where normal · p <= limit.
[[nodiscard]] inline Polygon clipped(const Polygon& polygon, const Vec3& normal, double limit) {
    Polygon result;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        const double from = normal.dot(a) - limit, to = normal.dot(b) - limit;
        if (from <= 0) result.push_back(a);
        if ((from < 0 && to > 0) || (from > 0 && to < 0)) result.push_back(a + from / (from - to) * (b - a));
    }
    return result;
}

/// Area of a polygon, and its mean times its area.
struct Moment {
    double area = 0;
    Vec3 first = Vec3::Zero();
};
[[nodiscard]] inline Moment moment_of(const Polygon& polygon) {
    Moment moment;
    for (std::size_t i = 2; i < polygon.size(); ++i) {
        const Vec3 &a = polygon[0], &b = polygon[i - 1], &c = polygon[i];
        const double area = (b - a).cross(c - a).norm() / 2;
        moment.area += area;
        moment.first += area * (a + b + c) / 3;
    }
    return moment;
}

}  // namespace partonomy
