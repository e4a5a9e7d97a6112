#include "shape/oriented_box.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <stdexcept>

#include "shape/shapes.h"

namespace partonomy {
namespace {

void expect_holds(const OrientedBox& box, const std::vector<Vec3>& points) {
    const double slack = 1e-9 * (1 + box.lengths[0]);
    for (const Vec3& point : points) {
        const Vec3 p = box.axes.transpose() * (point - box.centre);
        for (int k = 0; k < 3; ++k) EXPECT_LE(std::abs(p[k]), box.lengths[k] / 2 + slack);
    }
    EXPECT_NEAR(box.axes.determinant(), 1, 1e-9);
    EXPECT_GE(box.lengths[0], box.lengths[1]);
    EXPECT_GE(box.lengths[1], box.lengths[2]);
}

std::vector<Vec3> corners(const Vec3& sides) {
    std::vector<Vec3> points;
    for (int k = 0; k < 8; ++k)
        points.emplace_back(k & 1 ? sides.x() : 0, k & 2 ? sides.y() : 0, k & 4 ? sides.z() : 0);
    return points;
}

TEST(SmallestBox, TurnedBoxesAreFoundExactly) {
    constexpr unsigned seed = 11;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (const Vec3& sides : {Vec3(1, 1, 1), Vec3(3, 2, 1), Vec3(10, 1, 1), Vec3(5, 4, 0.1), Vec3(1000, 1000, 1)})
        for (int round = 0; round < 20; ++round) {
            std::vector<Vec3> points = corners(sides);
            const Eigen::Quaterniond by = shapes::random_turn(random);
            for (Vec3& point : points) point = by * point + Vec3(7, -3, 2);
            const OrientedBox box = smallest_box(points);
            expect_holds(box, points);
            Vec3 sorted = sides;
            std::sort(sorted.data(), sorted.data() + 3, std::greater<>());
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(box.lengths[k], sorted[k], 1e-6 * sorted[0]);
        }
}

TEST(SmallestBox, ManyPointsInATurnedBox) {
    constexpr unsigned seed = 5;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> uniform;
    const Eigen::Quaterniond by = shapes::random_turn(random);
    std::vector<Vec3> points = corners({4, 2, 0.5});
    for (int k = 0; k < 30000; ++k)
        points.emplace_back(4 * uniform(random), 2 * uniform(random), 0.5 * uniform(random));
    for (Vec3& point : points) point = by * point;
    const OrientedBox box = smallest_box(points);
    expect_holds(box, points);
    EXPECT_NEAR(box.volume(), 4, 1e-6);
}

TEST(SmallestBox, FlatThinAndTinySets) {
    EXPECT_THROW((void)smallest_box({}), std::invalid_argument);
    const std::vector<Vec3> one{Vec3(1, 2, 3)};
    EXPECT_EQ(smallest_box(one).lengths, Vec3(0, 0, 0));
    EXPECT_EQ(smallest_box(one).centre, one.front());
    const std::vector<Vec3> same(5, Vec3(1, 1, 1));
    EXPECT_EQ(smallest_box(same).lengths, Vec3(0, 0, 0));
    const std::vector<Vec3> line{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)};
    EXPECT_NEAR(smallest_box(line).lengths[0], std::sqrt(12.0), 1e-9);
    EXPECT_NEAR(smallest_box(line).lengths[1], 0, 1e-9);
    std::vector<Vec3> flat{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0), Vec3(0, 1, 0)};
    const Eigen::Quaterniond by(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
    for (Vec3& point : flat) point = by * point;
    const OrientedBox box = smallest_box(flat);
    EXPECT_NEAR(box.lengths[0], 2, 1e-6);
    EXPECT_NEAR(box.lengths[1], 1, 1e-6);
    EXPECT_NEAR(box.lengths[2], 0, 1e-9);
}

TEST(SmallestBox, ScalesAndMovesWithItsPoints) {
    constexpr unsigned seed = 3;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<Vec3> points;
    for (int k = 0; k < 500; ++k) points.emplace_back(normal(random), 3 * normal(random), 0.2 * normal(random));
    const double volume = smallest_box(points).volume();
    for (Vec3& point : points) point = point * 1000 + Vec3(5000, 0, -3000);
    EXPECT_NEAR(smallest_box(points).volume(), volume * 1e9, 0.01 * volume * 1e9);
}

/// Sheets of a model file are flat but for rounding: each turn gains a little of next to nothing, and must not go on.
TEST(SmallestBox, NearlyFlatSheetsEndSoon) {
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (const double roughness : {1e-12, 1e-9, 1e-7, 1e-5}) {
        SCOPED_TRACE(roughness);
        std::vector<Vec3> points;
        for (int x = 0; x <= 20; ++x)
            for (int y = 0; y <= 10; ++y) {
                const double height = roughness * ((x * 7 + y * 13) % 5 - 2);
                points.push_back(turn * Vec3(x, y, height));
            }
        const OrientedBox box = smallest_box(points);
        EXPECT_NEAR(box.lengths[0], 20, 1e-3);
        EXPECT_NEAR(box.lengths[1], 10, 1e-3);
        EXPECT_LT(box.lengths[2], 10 * roughness + 1e-9);
    }
}

}  // namespace
}  // namespace partonomy
