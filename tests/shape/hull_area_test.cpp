#include "shape/hull_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

namespace partonomy {
namespace {

using Points = std::vector<Eigen::Vector2d>;

TEST(HullArea, OfSimpleShapes) {
    EXPECT_EQ(hull_area({}), 0);
    EXPECT_EQ(hull_area({{0, 0}, {1, 1}}), 0);
    EXPECT_EQ(hull_area({{0, 0}, {1, 1}, {2, 2}, {3, 3}}), 0);
    EXPECT_DOUBLE_EQ(hull_area({{0, 0}, {2, 0}, {0, 3}}), 3);
    EXPECT_DOUBLE_EQ(hull_area({{0, 0}, {2, 0}, {2, 2}, {0, 2}, {1, 1}, {1, 2}, {0, 0}}), 4);
}

/// A point of the hull is one that some direction has furthest; the polygon of those is the hull.
TEST(HullArea, EqualsTheAreaSweptByManyDirections) {
    std::mt19937 random(7);
    std::normal_distribution<double> normal;
    for (int round = 0; round < 20; ++round) {
        SCOPED_TRACE(round);
        Points points;
        for (int i = 0; i < 200; ++i) points.emplace_back(3 * normal(random), normal(random));
        Points ends;
        for (int k = 0; k < 20000; ++k) {
            const Eigen::Vector2d way(std::cos(k * 2 * std::numbers::pi / 20000),
                                      std::sin(k * 2 * std::numbers::pi / 20000));
            const auto end = *std::max_element(points.begin(), points.end(),
                                               [&](const auto& a, const auto& b) { return a.dot(way) < b.dot(way); });
            if (ends.empty() || ends.back() != end) ends.push_back(end);
        }
        double twice = 0;
        for (std::size_t i = 0; i < ends.size(); ++i) {
            const auto &a = ends[i], &b = ends[(i + 1) % ends.size()];
            twice += a.x() * b.y() - a.y() * b.x();
        }
        EXPECT_NEAR(hull_area(points), twice / 2, 1e-3 * twice);
    }
}

}  // namespace
}  // namespace partonomy
