#include "mesh/triangulate.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

namespace partonomy {
namespace {

struct Cut {
    std::vector<std::array<std::int32_t, 3>> triangles;
    double area = 0;          ///< sum of the triangles' areas
    double vector_area = 0;   ///< length of the sum of their normals, weighted by area
    double polygon_area = 0;  ///< length of Newell's sum of the polygon
};

/// Triangles that overlap, or leave the polygon, have a larger sum of areas than the polygon's own.
Cut cut(const std::vector<Vec3>& points) {
    Cut result;
    std::vector<std::int32_t> corners;
    Vec3 sum = Vec3::Zero(), newell = Vec3::Zero();
    for (std::size_t i = 0; i < points.size(); ++i) {
        corners.push_back(static_cast<std::int32_t>(i));
        newell += points[i].cross(points[(i + 1) % points.size()]) / 2;
    }
    triangulate_polygon(points, corners, result.triangles);
    for (const auto& [a, b, c] : result.triangles) {
        const Vec3 cross = (points[static_cast<std::size_t>(b)] - points[static_cast<std::size_t>(a)])
                               .cross(points[static_cast<std::size_t>(c)] - points[static_cast<std::size_t>(a)]);
        result.area += cross.norm() / 2;
        sum += cross / 2;
    }
    result.vector_area = sum.norm();
    result.polygon_area = newell.norm();
    return result;
}

void expect_exact(const std::vector<Vec3>& points, std::size_t triangles) {
    const Cut result = cut(points);
    EXPECT_EQ(result.triangles.size(), triangles);
    EXPECT_NEAR(result.area, result.polygon_area, 1e-9 * result.polygon_area);
    EXPECT_NEAR(result.vector_area, result.polygon_area, 1e-9 * result.polygon_area);
}

std::vector<Vec3> tilted(std::vector<Vec3> points) {
    const Eigen::AngleAxisd turn(1.1, Vec3(1, 2, -0.5).normalized());
    for (Vec3& p : points) p = turn * p + Vec3(3, -2, 7);
    return points;
}

TEST(Triangulate, SmallShapes) {
    const std::vector<Vec3> square{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}};
    const std::vector<Vec3> dart{{0, 0, 0}, {2, -1, 0}, {0.5, 0, 0}, {2, 1, 0}};
    const std::vector<Vec3> u{{0, 0, 0}, {1, 0, 0}, {1, 3, 0}, {2, 3, 0}, {2, 0, 0}, {3, 0, 0}, {3, 4, 0}, {0, 4, 0}};
    for (const auto& shape : {square, dart, u}) {
        for (std::size_t turn = 0; turn < shape.size(); ++turn) {
            std::vector<Vec3> points = tilted(shape);
            std::rotate(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(turn), points.end());
            expect_exact(points, shape.size() - 2);
        }
    }
}

TEST(Triangulate, QuadTakesItsShorterDiagonal) {
    const Cut result = cut({{0, 0, 0}, {3, 0, 0}, {4, 1, 0}, {1, 1, 0}});
    ASSERT_EQ(result.triangles.size(), 2U);
    for (const auto& t : result.triangles) {
        EXPECT_NE(std::find(t.begin(), t.end(), 1), t.end());
        EXPECT_NE(std::find(t.begin(), t.end(), 3), t.end());
    }
}

TEST(Triangulate, CornersInLineKeepTheirPlace) {
    expect_exact({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {2, 2, 0}, {1, 2, 0}, {0, 2, 0}, {0, 1, 0}}, 6);
    expect_exact({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 2, 0}}, 2);
}

TEST(Triangulate, HoleJoinedByABridge) {
    const std::vector<Vec3> points{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0},
                                   {1, 1, 0}, {1, 3, 0}, {3, 3, 0}, {3, 1, 0}, {1, 1, 0}};
    const Cut result = cut(points);
    EXPECT_NEAR(result.area, 12, 1e-12);
    EXPECT_EQ(result.triangles.size(), 8U);
}

TEST(Triangulate, NothingWithoutArea) {
    EXPECT_TRUE(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1.5, 0, 0}}).triangles.empty());
    EXPECT_TRUE(cut({{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}).triangles.empty());
    EXPECT_TRUE(cut({{0, 0, 0}, {1, 0, 0}}).triangles.empty());
    EXPECT_TRUE(cut({}).triangles.empty());
}

TEST(Triangulate, StarsOfAllSizes) {
    constexpr unsigned seed = 7;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> radius(0.2, 1);
    for (const std::size_t n : {5U, 12U, 64U, 65U, 200U, 3000U}) {
        std::vector<Vec3> points;
        for (std::size_t i = 0; i < n; ++i) {
            const double angle = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
            points.push_back(radius(random) * Vec3(std::cos(angle), std::sin(angle), 0));
        }
        SCOPED_TRACE(n);
        expect_exact(tilted(points), n - 2);
    }
}

/// In a second; with quadratic steps it would take minutes.
TEST(Triangulate, LargeCombs) {
    std::vector<Vec3> comb;  // 20,000 teeth, every second corner is not convex
    for (int i = 0; i < 20000; ++i) comb.insert(comb.end(), {{i + 0.0, 1, 0}, {i + 0.5, 0.1, 0}});
    comb.insert(comb.end(), {{20000, 1, 0}, {20000, 0, 0}, {0, 0, 0}});
    std::reverse(comb.begin(), comb.end());
    expect_exact(comb, comb.size() - 2);
}

TEST(Triangulate, SelfCrossingPolygonsDoNotHang) {
    EXPECT_FALSE(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).triangles.empty());
    std::mt19937 random(3);
    std::uniform_real_distribution<double> place(-1, 1);
    for (int round = 0; round < 200; ++round) {
        std::vector<Vec3> points;
        for (int i = 0; i < 5 + round; ++i) points.emplace_back(place(random), place(random), place(random));
        EXPECT_LE(cut(points).triangles.size(), points.size() - 2);
    }
}

}  // namespace
}  // namespace partonomy
