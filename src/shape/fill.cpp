// Who gets what is left: fillets, the ends of legs, small bits between parts.
//
// All parts grow over the free triangles at once, along the surface, nearest first (Dijkstra). A step over a concave
// bend is long, in proportion to the part's thickness. Between exact planes a board hardly grows out of its slab along
// a flat face. Ties go by triangle number. Free pieces that do not touch are filled side by side. Cost: O(m log m) for
// m free triangles.

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/ranges.h"
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

/// Lets parts grow over one free piece after the other.
class Growth {
public:
    Growth(const Surface& surface, Parts& parts, std::vector<float>& best) : s_(surface), parts_(parts), best_(best) {}

    void over(std::span<const std::int32_t> piece) {
        for (const std::int32_t i : piece) {
            best_[i] = std::numeric_limits<float>::infinity();
            for (const std::int32_t from : s_.adjacency.neighbours[i])
                if (from >= 0 && parts_.part_of[from] >= 0) reach(from, i, 0);
        }
        while (!queue_.empty()) {
            std::pop_heap(queue_.begin(), queue_.end(), std::greater<>());
            const Step step = queue_.back();
            queue_.pop_back();
            if (parts_.part_of[step.triangle] >= 0) continue;
            parts_.part_of[step.triangle] = step.part;
            for (const std::int32_t j : s_.adjacency.neighbours[step.triangle])
                if (j >= 0 && parts_.part_of[j] < 0) reach(step.triangle, j, step.cost);
        }
    }

private:
    void reach(std::int32_t from, std::int32_t j, double cost) {
        const Core& part = parts_.parts[parts_.part_of[from]];
        const Vec3 way = s_.geometry.barycentres[j] - s_.geometry.barycentres[from];
        const double turn = 1 - s_.geometry.normals[from].dot(s_.geometry.normals[j]);
        const bool is_concave = way.dot(s_.geometry.normals[from] - s_.geometry.normals[j]) > 0;
        const double crease = is_concave ? concave * turn * part.thickness : 0;
        const double u = (s_.geometry.barycentres[j] - part.middle).dot(part.normal);
        const bool outside = part.is_exact && turn < flat_turn && std::abs(u) > 1.05 * part.half;
        const double total = cost + (outside ? outside_exact : 1) * way.norm() + crease;
        if (total > static_cast<double>(best_[j])) return;
        best_[j] = std::nextafter(static_cast<float>(total), std::numeric_limits<float>::infinity());
        queue_.push_back({total, j, parts_.part_of[from]});
        std::push_heap(queue_.begin(), queue_.end(), std::greater<>());
    }

    const Surface& s_;
    Parts& parts_;
    std::vector<float>& best_;  ///< cost of the best way to each free triangle, rounded up: ties stay in the queue
    std::vector<Step> queue_;   ///< a heap
};

}  // namespace

void fill(const Surface& s, const Groups& free_pieces, Parts& parts) {
    std::vector<float> best(s.count());
    // Parts are all around a piece, so pieces know nothing of each other.
    for_each_range(
        free_pieces.size(), s.threads,
        [&](std::size_t begin, std::size_t end) {
            Growth growth(s, parts, best);
            for (std::size_t k = begin; k < end; ++k)
                if (parts.part_of[free_pieces[k].front()] < 0) growth.over(free_pieces[k]);
        },
        1);
}

}  // namespace partonomy
