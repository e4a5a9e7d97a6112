#include "report/samples.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>
#include <random>

namespace partonomy {
namespace {

using Triangle = std::array<Vec3, 3>;

/// How far inside the triangle a place is, in samples: the distance to the nearest edge's line, negative outside.
double inside(const Triangle& triangle, double x, double y) {
    const auto& [a, b, c] = triangle;
    const double turn = (b.x() - a.x()) * (c.y() - a.y()) - (c.x() - a.x()) * (b.y() - a.y()) > 0 ? 1 : -1;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &from = triangle[i], &to = triangle[(i + 1) % 3];
        const double dx = to.x() - from.x(), dy = to.y() - from.y();
        least = std::min(least, turn * (dx * (y - from.y()) - dy * (x - from.x())) / std::hypot(dx, dy));
    }
    return least;
}

double depth_at(const Triangle& triangle, double x, double y) {
    const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    return triangle[0].z() - (normal.x() * (x - triangle[0].x()) + normal.y() * (y - triangle[0].y())) / normal.z();
}

TEST(Samples, ShowWhatIsInFront) {
    constexpr int columns = 61, rows = 43;
    int compared = 0;
    for (unsigned seed = 0; seed < 40; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 generator(seed);
        std::uniform_real_distribution<double> x(-20, 80), y(-20, 60), depth(-1, 1);
        std::vector<Triangle> triangles(1 + seed);
        Samples samples(columns, rows);
        samples.clear();
        for (std::size_t t = 0; t < triangles.size(); ++t) {
            for (Vec3& corner : triangles[t]) corner = Vec3(x(generator), y(generator), depth(generator));
            samples.add(triangles[t], static_cast<std::int32_t>(t));
        }
        for (int v = 0; v < rows; ++v)
            for (int u = 0; u < columns; ++u) {
                std::int32_t front = -1;
                double nearest = std::numeric_limits<double>::infinity(), second = nearest;
                bool is_clear = true;
                for (std::size_t t = 0; t < triangles.size(); ++t) {
                    const double within = inside(triangles[t], u, v);
                    is_clear = is_clear && std::abs(within) > 1e-5;
                    if (within <= 0) continue;
                    const double there = depth_at(triangles[t], u, v);
                    second = std::min(second, std::max(there, nearest));
                    if (there < nearest) nearest = there, front = static_cast<std::int32_t>(t);
                }
                if (!is_clear || second - nearest < 1e-4) continue;
                ++compared;
                ASSERT_EQ(samples.row(v)[u], front) << u << ", " << v;
            }
    }
    EXPECT_GT(compared, 40 * columns * rows * 9 / 10);
}

TEST(Samples, NeighboursLeaveNoGap) {
    // A fan around a point, its triangles sharing edges at all angles.
    Samples samples(50, 50);
    for (unsigned seed = 0; seed < 20; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 generator(seed);
        std::uniform_real_distribution<double> place(20, 30);
        const Vec3 middle(place(generator), place(generator), 0);
        samples.clear();
        constexpr int count = 37;
        const auto rim = [&](int k) {
            const double angle = 2 * 3.14159265358979 * (k % count) / count + seed;
            return Vec3(middle.x() + 60 * std::cos(angle), middle.y() + 60 * std::sin(angle), 0);
        };
        for (int k = 0; k < count; ++k) samples.add({middle, rim(k), rim(k + 1)}, k);
        for (int y = 0; y < 50; ++y)
            for (int x = 0; x < 50; ++x) ASSERT_GE(samples.row(y)[x], 0) << x << ", " << y;
    }
}

TEST(Samples, TheEarlierOfTwoAtTheSameDepthStays) {
    Samples samples(8, 8);
    samples.clear();
    const Triangle all{Vec3(-9, -9, 1), Vec3(30, -9, 1), Vec3(-9, 30, 1)};
    samples.add(all, 4);
    samples.add(all, 2);
    EXPECT_EQ(samples.row(3)[3], 4);
    EXPECT_EQ(samples.row(0)[7], 4);
}

TEST(Samples, EdgeOnTrianglesCoverNothing) {
    Samples samples(8, 8);
    samples.clear();
    samples.add({Vec3(0, 2, 0), Vec3(7, 2, 0), Vec3(3, 2, 5)}, 0);
    for (int x = 0; x < 8; ++x) EXPECT_EQ(samples.row(2)[x], -1) << x;
}

}  // namespace
}  // namespace partonomy
