// The hull by Andrew's monotone chain (1979); the rectangle by rotating callipers (Toussaint 1983): one of its sides
// lies on an edge of the hull, and the points farthest along, across and against the edge only move forward as it
// turns.

#include "shape/rectangle.h"

#include <algorithm>
#include <cmath>

namespace partonomy {

void convex_hull(std::vector<Planar>& points, std::vector<Planar>& hull) {
    std::sort(points.begin(), points.end(),
              [](const Planar& a, const Planar& b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
    hull.resize(2 * points.size() + 1);
    std::size_t k = 0;
    const auto add = [&](const Planar& p, std::size_t fewest) {
        const auto turns_left = [&] {
            const Planar &o = hull[k - 2], &a = hull[k - 1];
            return (a.x - o.x) * (p.y - o.y) - (a.y - o.y) * (p.x - o.x) > 0;
        };
        while (k >= fewest && !turns_left()) --k;
        hull[k++] = p;
    };
    for (const Planar& p : points) add(p, 2);
    const std::size_t lower = k + 1;
    for (std::size_t i = points.size() - 1; i-- > 0;) add(points[i], lower);
    hull.resize(k > 1 ? k - 1 : 1);
}

Rectangle smallest_rectangle(const std::vector<Planar>& hull, double size) {
    const std::size_t corners = hull.size();
    Rectangle best;
    std::size_t right = 0, top = 0, left = 0;
    bool is_first = true;
    for (std::size_t e = 0; e < corners; ++e) {
        const Planar &from = hull[e], &to = hull[e + 1 == corners ? 0 : e + 1];
        const double x = to.x - from.x, y = to.y - from.y, length = std::sqrt(x * x + y * y);
        if (length <= 1e-12 * size) continue;
        const double slack = 1e-12 * size * length;
        // Moves on to the corner that is farthest in a direction; how far, times `length`.
        const auto advance = [&](std::size_t& at, double dx, double dy) {
            const auto along = [&](std::size_t i) { return (hull[i].x - from.x) * dx + (hull[i].y - from.y) * dy; };
            double here = along(at);
            for (std::size_t steps = 0; steps < corners; ++steps) {
                const std::size_t next = at + 1 == corners ? 0 : at + 1;
                const double there = along(next);
                if (there < here - slack) break;
                at = next, here = there;
            }
            return here;
        };
        if (is_first) right = top = left = e;
        is_first = false;
        const double end = advance(right, x, y);
        if (top == e) top = right;
        const double height = advance(top, -y, x) / length;
        if (left == e) left = top;
        const double width = (end + advance(left, -x, -y)) / length;
        const double area = (width + 1e-9 * size) * (height + 1e-9 * size);
        if (area < best.area) best = {{x / length, y / length}, width, height, area};
    }
    return best;
}

double area_of(const std::vector<Planar>& polygon) {
    double twice = 0;
    for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
        const Planar &o = polygon[0], &a = polygon[i], &b = polygon[i + 1];
        twice += (a.x - o.x) * (b.y - o.y) - (a.y - o.y) * (b.x - o.x);
    }
    return twice / 2;
}

double perimeter_of(const std::vector<Planar>& polygon) {
    double sum = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Planar &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
        sum += std::hypot(b.x - a.x, b.y - a.y);
    }
    return sum;
}

}  // namespace partonomy
