#include "shape/plain_pieces.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <random>

#include "shape/rectangle.h"

namespace partonomy {
namespace {

TEST(Rectangle, IsTheSmallestOfAllTurns) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 generator(seed);
        std::normal_distribution<double> place;
        std::vector<Planar> points(3 + seed % 40), hull;
        for (Planar& p : points) p = {place(generator), 0.3 * place(generator)};
        convex_hull(points, hull);
        const Rectangle rectangle = smallest_rectangle(hull, 1);
        EXPECT_NEAR(rectangle.area, rectangle.width * rectangle.height, 1e-6);
        EXPECT_GE(rectangle.area, area_of(hull) * (1 - 1e-9));
        const auto extent = [&](double dx, double dy) {
            double low = 1e9, high = -1e9;
            for (const Planar& p : points)
                low = std::min(low, p.x * dx + p.y * dy), high = std::max(high, p.x * dx + p.y * dy);
            return high - low;
        };
        EXPECT_NEAR(extent(rectangle.side.x, rectangle.side.y), rectangle.width, 1e-9);
        EXPECT_NEAR(extent(-rectangle.side.y, rectangle.side.x), rectangle.height, 1e-9);
        double smallest = 1e9;
        for (int k = 0; k < 2000; ++k) {
            const double angle = std::numbers::pi * k / 4000, c = std::cos(angle), s = std::sin(angle);
            smallest = std::min(smallest, extent(c, s) * extent(-s, c));
        }
        EXPECT_LE(rectangle.area, smallest * (1 + 1e-6));
        EXPECT_GE(rectangle.area, smallest * 0.97);
    }
}

TEST(Rectangle, HullHoldsAllPointsAndTurnsLeft) {
    for (unsigned seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 generator(seed);
        std::uniform_int_distribution<int> place(0, 6);  // many equal and collinear points
        std::vector<Planar> points(4 + seed % 60), hull;
        for (Planar& p : points) p = {double(place(generator)), double(place(generator))};
        convex_hull(points, hull);
        for (std::size_t i = 0; hull.size() > 2 && i < hull.size(); ++i) {
            const Planar &a = hull[i], &b = hull[(i + 1) % hull.size()], &c = hull[(i + 2) % hull.size()];
            const auto turn = [&](const Planar& p) { return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x); };
            EXPECT_GT(turn(c), 0);
            for (const Planar& p : points) EXPECT_GE(turn(p), 0);
        }
    }
}

/// A closed strip of walls between a polygon at the bottom and the same one at the top, turned any way, and its two
/// ends after them; four triangles a wall.
TriangleMesh prism(const std::vector<Planar>& outline, double height, unsigned seed) {
    std::mt19937 generator(seed);
    std::normal_distribution<double> place;
    const Eigen::Matrix3d turn =
        Eigen::Quaterniond(place(generator), place(generator), place(generator), place(generator))
            .normalized()
            .toRotationMatrix();
    TriangleMesh mesh;
    const auto count = static_cast<std::int32_t>(outline.size());
    for (const double z : {0.0, height / 2, height})
        for (const Planar& p : outline) mesh.positions.push_back(turn * Vec3(p.x, p.y, z));
    for (std::int32_t k = 0; k < count; ++k)
        for (const std::int32_t level : {0, count}) {
            const std::int32_t a = level + k, b = level + (k + 1) % count;
            mesh.triangles.push_back({a, b, b + count});
            mesh.triangles.push_back({a, b + count, a + count});
        }
    for (std::int32_t k = 1; k + 1 < count; ++k) {
        mesh.triangles.push_back({0, k + 1, k});
        mesh.triangles.push_back({2 * count, 2 * count + k, 2 * count + k + 1});
    }
    return mesh;
}

Surface measured(const TriangleMesh& mesh) {
    Surface s(mesh);
    s.geometry = compute_geometry(mesh);
    s.size = compute_bounds(mesh).diagonal();
    return s;
}

std::optional<PlainPiece> look_at(const TriangleMesh& mesh, std::int32_t begin, std::int32_t end, double thickness) {
    const Surface s = measured(mesh);
    std::vector<std::int32_t> triangles;
    double area = 0;
    for (std::int32_t t = begin; t < end; ++t) {
        triangles.push_back(t);
        area += s.geometry.areas[static_cast<std::size_t>(t)];
    }
    return as_plain_piece(s, triangles, thickness, area);
}

TEST(PlainPieces, BoardBetweenItsLargeFaces) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        const TriangleMesh mesh = prism({{0, 0}, {5, 0}, {5, 3}, {0, 3}}, 0.2, seed);
        const auto piece = look_at(mesh, 16, 20, 0.2);  // the two ends
        ASSERT_TRUE(piece);
        EXPECT_NEAR(piece->narrow, 3, 1e-9);
        EXPECT_NEAR(piece->wide, 5, 1e-9);
        const Vec3 side = (mesh.positions[1] - mesh.positions[0]).normalized();
        EXPECT_NEAR(std::abs(piece->along.dot(side)), 1, 1e-9);
    }
}

TEST(PlainPieces, StickBetweenItsFourWalls) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        const TriangleMesh mesh = prism({{0, 0}, {0.5, 0}, {0.5, 0.4}, {0, 0.4}}, 6, seed);
        const auto piece = look_at(mesh, 0, 16, 0.45);
        ASSERT_TRUE(piece);
        EXPECT_NEAR(piece->narrow, 0.5 * 0.4 / 0.45, 1e-9);
        EXPECT_NEAR(piece->wide, 6, 1e-9);
        EXPECT_NEAR(std::abs(piece->along.dot((mesh.positions[4] - mesh.positions[0]).normalized())), 1, 1e-9);
    }
}

TEST(PlainPieces, BlockBetweenItsSixWalls) {
    for (unsigned seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        const TriangleMesh mesh = prism({{0, 0}, {1.3, 0}, {1.3, 1.1}, {0, 1.1}}, 1, seed);
        const auto piece = look_at(mesh, 0, 20, 1.1);
        ASSERT_TRUE(piece);
        EXPECT_NEAR(piece->narrow, 1.1, 1e-9);
        EXPECT_NEAR(piece->wide, 1.3, 1e-9);
        const Vec3 side = (mesh.positions[1] - mesh.positions[0]).normalized();
        EXPECT_NEAR(std::abs(piece->along.dot(side)), 1, 1e-9);
        // Other parts may stand on its sides, but not hide one.
        EXPECT_TRUE(look_at(mesh, 1, 20, 1.1));
        EXPECT_FALSE(look_at(mesh, 0, 18, 1.1));
        // An angle is more than a block.
        const TriangleMesh angle = prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1.8, seed);
        EXPECT_FALSE(look_at(angle, 0, 32, 1));
    }
}

TEST(PlainPieces, WhatMayHaveToBeCutIsNone) {
    // A comb: a board with two posts as thick as it.
    const TriangleMesh comb = prism({{0, 0}, {1, 0}, {1, 3}, {4, 3}, {4, 0}, {5, 0}, {5, 5}, {0, 5}}, 0.3, 1);
    const auto ends = static_cast<std::int32_t>(comb.triangles.size());
    std::vector<std::int32_t> walls;
    double area = 0;  // the ends' triangles overlap where the outline turns in; their count does not matter here
    for (std::int32_t t = 32; t < ends; ++t) {
        walls.push_back(t);
        area += 2 * 19.0 / (ends - 32);
    }
    EXPECT_FALSE(as_plain_piece(measured(comb), walls, 0.3, area));
    // A triangle is no rectangle, a sphere-like drum has walls all around.
    const TriangleMesh wedge = prism({{0, 0}, {4, 0}, {2, 3}}, 0.3, 2);
    EXPECT_FALSE(look_at(wedge, 12, 14, 0.3));
    std::vector<Planar> circle;
    for (int k = 0; k < 24; ++k)
        circle.push_back({std::cos(2 * std::numbers::pi * k / 24), std::sin(2 * std::numbers::pi * k / 24)});
    EXPECT_FALSE(look_at(prism(circle, 3, 3), 0, 24 * 4, 2));
    // Walls of which a part is missing.
    const TriangleMesh board = prism({{0, 0}, {5, 0}, {5, 3}, {0, 3}}, 0.2, 4);
    EXPECT_FALSE(look_at(board, 16, 19, 0.2));
}

}  // namespace
}  // namespace partonomy
