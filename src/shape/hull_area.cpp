// Convex hull by monotone chain. Before sorting, all points inside the octagon of the extreme points in eight
// directions go (Akl and Toussaint 1978): of a scan's thousands of points some hundred remain.

#include "shape/hull_area.h"

#include <algorithm>
#include <array>

namespace partonomy {

namespace {

using Point = Eigen::Vector2d;

double cross(const Point& o, const Point& a, const Point& b) {
    return (a - o).x() * (b - o).y() - (a - o).y() * (b - o).x();
}

void drop_inner_points(std::vector<Point>& points) {
    static const std::array<Point, 8> directions = {Point(1, 0),  Point(1, 1),   Point(0, 1),  Point(-1, 1),
                                                    Point(-1, 0), Point(-1, -1), Point(0, -1), Point(1, -1)};
    std::array<Point, 8> ends;
    ends.fill(points.front());
    for (const Point& p : points)
        for (std::size_t k = 0; k < ends.size(); ++k)
            if (p.dot(directions[k]) > ends[k].dot(directions[k])) ends[k] = p;
    std::erase_if(points, [&](const Point& p) {
        for (std::size_t k = 0; k < ends.size(); ++k) {
            const Point &a = ends[k], &b = ends[(k + 1) % ends.size()];
            if (a != b && cross(a, b, p) <= 0) return false;
        }
        return true;
    });
}

}  // namespace

double hull_area(std::vector<Point> points) {
    if (points.size() < 3) return 0;
    drop_inner_points(points);
    std::sort(points.begin(), points.end(),
              [](const Point& a, const Point& b) { return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y(); });
    std::vector<Point> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t start = hull.size();
        for (const Point& p : points) {
            while (hull.size() >= start + 2 && cross(hull[hull.size() - 2], hull.back(), p) <= 0) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();  // the next side begins with it
        std::reverse(points.begin(), points.end());
    }
    double twice = 0;
    for (std::size_t k = 2; k < hull.size(); ++k) twice += cross(hull[0], hull[k - 1], hull[k]);
    return twice / 2;
}

}  // namespace partonomy
