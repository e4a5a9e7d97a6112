// CGAL searches the optimal box by evolution; ours is hardly ever larger, never by more than 1 %, and as small on
// average.

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/optimal_bounding_box.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "shape/oriented_box.h"

namespace partonomy {
namespace {

double cgal_volume(const std::vector<Vec3>& points) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    std::vector<Kernel::Point_3> copies;
    for (const Vec3& p : points) copies.emplace_back(p.x(), p.y(), p.z());
    std::array<Kernel::Point_3, 8> box;
    CGAL::get_default_random() = CGAL::Random(1);  // else it starts from the clock
    CGAL::oriented_bounding_box(copies, box);
    const auto edge = [&](std::size_t to) { return std::sqrt(CGAL::squared_distance(box[0], box[to])); };
    return edge(1) * edge(3) * edge(5);
}

/// Clouds, points on a sphere, boxes with some points astray, and round sticks; stretched and turned.
std::vector<Vec3> random_points(std::mt19937& random, int kind, int count) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform(-1, 1);
    const Vec3 shape(1, std::exp(normal(random)), std::exp(normal(random)));
    const Eigen::Matrix3d turn = Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random))
                                     .normalized()
                                     .toRotationMatrix();
    const auto sign = [&] { return uniform(random) > 0 ? 1.0 : -1.0; };
    std::vector<Vec3> points;
    for (int k = 0; k < count; ++k) {
        Vec3 p(normal(random), normal(random), normal(random));
        if (kind == 1) p.normalize();
        if (kind == 2) p = Vec3(k % 3 == 0 ? uniform(random) : sign(), sign(), sign());
        if (kind == 3) p = Vec3(std::cos(3.1416 * uniform(random)), std::sin(3.1416 * uniform(random)), sign());
        points.emplace_back(turn * p.cwiseProduct(shape));
    }
    return points;
}

TEST(SmallestBox, IsAsSmallAsTheOptimum) {
    constexpr unsigned seed = 17;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    int sets = 0, larger = 0;
    double excess = 0;
    for (const int count : {5, 8, 12, 20, 50, 200, 1000})
        for (int round = 0; round < 12; ++round) {
            const std::vector<Vec3> points = random_points(random, round % 4, count);
            const double ratio = smallest_box(points).volume() / cgal_volume(points);
            EXPECT_LE(ratio, 1.01) << count << " points, round " << round;
            larger += ratio > 1.0001;
            excess += ratio - 1;
            ++sets;
        }
    EXPECT_LE(larger, sets / 25) << "larger than CGAL's by more than 0.01 %, of " << sets;
    EXPECT_LE(excess / sets, 0) << "mean";
}

}  // namespace
}  // namespace partonomy
