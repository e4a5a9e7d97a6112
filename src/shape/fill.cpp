// Who gets what is left: fillets, the ends of legs, small bits between parts.
//
// All parts grow over the free triangles at once, along the surface, nearest first (Dijkstra). A step over a concave
// bend is long, in proportion to the part's thickness. Between exact planes a board hardly grows out of its slab along
// a flat face. Ties go by triangle number. Cost: O(m log m) for m free triangles.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

#include "shape/claims.h"

namespace partonomy {

namespace {

struct Step {
    double cost;
    std::int32_t triangle;
    std::int32_t part;
    bool operator>(const Step& other) const {
        if (cost != other.cost) return cost > other.cost;
        return triangle != other.triangle ? triangle > other.triangle : part > other.part;
    }
};

constexpr double outside_exact = 20, flat_turn = 1e-4;
constexpr double concave = 5;  // thicknesses that a right angle inward is long

}  // namespace

void fill(const Surface& s, Parts& parts) {
    std::priority_queue<Step, std::vector<Step>, std::greater<>> queue;
    std::vector<float> best(s.count(), std::numeric_limits<float>::infinity());  // rounded up: ties stay in the queue
    const auto push = [&](std::int32_t from, double cost) {
        const std::int32_t part = parts.part_of[from];
        for (const std::int32_t j : s.adjacency.neighbours[from]) {
            if (j < 0 || parts.part_of[j] >= 0) continue;
            const Vec3 way = s.geometry.barycentres[j] - s.geometry.barycentres[from];
            const double turn = 1 - s.geometry.normals[from].dot(s.geometry.normals[j]);
            const bool is_concave = way.dot(s.geometry.normals[from] - s.geometry.normals[j]) > 0;
            const double crease = is_concave ? concave * turn * parts.parts[part].thickness : 0;
            const double u = (s.geometry.barycentres[j] - parts.parts[part].middle).dot(parts.parts[part].normal);
            const bool outside =
                parts.parts[part].is_exact && turn < flat_turn && std::abs(u) > 1.05 * parts.parts[part].half;
            const double total = cost + (outside ? outside_exact : 1) * way.norm() + crease;
            if (total > static_cast<double>(best[j])) continue;
            best[j] = std::nextafter(static_cast<float>(total), std::numeric_limits<float>::infinity());
            queue.push({total, j, part});
        }
    };
    for (std::size_t i = 0; i < s.count(); ++i)
        if (parts.part_of[i] >= 0) push(static_cast<std::int32_t>(i), 0);
    while (!queue.empty()) {
        const Step step = queue.top();
        queue.pop();
        if (parts.part_of[step.triangle] >= 0) continue;
        parts.part_of[step.triangle] = step.part;
        push(step.triangle, step.cost);
    }
}

}  // namespace partonomy
