// CGAL searches the optimal box by evolution; ours must never be more than 1 % larger.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/optimal_bounding_box.h>
#include <gtest/gtest.h>

#include <random>

#include "shape/oriented_box.h"

namespace partonomy {
namespace {

double cgal_volume(const std::vector<Vec3>& points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_3> copies;
    for (const Vec3& p : points) copies.emplace_back(p.x(), p.y(), p.z());
    std::array<Kernel::Point_3, 8> box;
    CGAL::oriented_bounding_box(copies, box);
    const auto edge = [&](std::size_t to) { return std::sqrt(CGAL::squared_distance(box[0], box[to])); };
    return edge(1) * edge(3) * edge(5);
}

TEST(SmallestBox, IsAtMostOnePercentLargerThanTheOptimum) {
    constexpr unsigned seed = 17;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    for (const int count : {4, 5, 6, 8, 12, 20, 50, 200, 1000, 5000})
        for (int round = 0; round < 6; ++round) {
            const Vec3 shape(1, std::exp(normal(random)), std::exp(normal(random)));
            std::vector<Vec3> points;
            for (int k = 0; k < count; ++k)
                points.emplace_back(shape.x() * normal(random), shape.y() * normal(random), shape.z() * normal(random));
            EXPECT_LE(smallest_box(points).volume(), 1.01 * cgal_volume(points)) << count << " points, round " << round;
        }
}

}  // namespace
}  // namespace partonomy
