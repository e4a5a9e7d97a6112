// Filling, beside its definition: again and again the cheapest step of all, looked for everywhere.

#include <gtest/gtest.h>

#include <limits>
#include <random>
#include <tuple>

#include "shape/claims.h"
#include "shape/shapes.h"

namespace partonomy {
namespace {

/// How far it is to a triangle over the edge from one of a part, to which it is `cost`.
double way(const Surface& s, const Core& part, double cost, std::int32_t from, std::int32_t to) {
    const Vec3 step = s.geometry.barycentres[to] - s.geometry.barycentres[from];
    const Vec3 &a = s.geometry.normals[from], &b = s.geometry.normals[to];
    const double turn = 1 - a.dot(b), above = (s.geometry.barycentres[to] - part.middle).dot(part.normal);
    const bool is_outside = part.is_exact && turn < 1e-4 && std::abs(above) > 1.05 * part.half;
    return cost + (is_outside ? 20 : 1) * step.norm() + (step.dot(a - b) > 0 ? 5 * turn * part.thickness : 0);
}

void fill_by_definition(const Surface& s, Parts& parts) {
    using Step = std::tuple<double, std::int32_t, std::int32_t>;  // cost, triangle, part
    std::vector<double> cost(s.count(), 0);                       // of those that are in a part
    for (;;) {
        Step best{std::numeric_limits<double>::infinity(), -1, -1};
        for (std::int32_t i = 0; i < static_cast<std::int32_t>(s.count()); ++i)
            for (const std::int32_t j : s.adjacency.neighbours[i]) {
                if (parts.part_of[i] >= 0 || j < 0 || parts.part_of[j] < 0) continue;
                const std::int32_t part = parts.part_of[j];
                best = std::min(best, Step{way(s, parts.parts[part], cost[j], j, i), i, part});
            }
        const auto [total, triangle, part] = best;
        if (triangle < 0) return;
        cost[triangle] = total;
        parts.part_of[triangle] = part;
    }
}

void expect_as_defined(const TriangleMesh& mesh, bool is_exact) {
    Surface s(mesh);
    s.adjacency = build_adjacency(mesh);
    s.geometry = compute_geometry(mesh);
    std::mt19937 random(3);
    for (int round = 0; round < 6; ++round) {
        SCOPED_TRACE(testing::Message() << "round " << round);
        Parts parts{std::vector<Core>(5), std::vector<std::int32_t>(s.count(), -1)};
        for (Core& part : parts.parts) {
            part.thickness = std::uniform_real_distribution(0.1, 2.0)(random);
            part.is_exact = is_exact;
            part.normal = Vec3::UnitZ();
            part.half = 0.1;
        }
        const auto seeds = static_cast<int>(s.count() / (round % 2 == 0 ? 4 : 40));
        for (int k = 0; k < seeds; ++k)
            parts.part_of[random() % s.count()] = static_cast<std::int32_t>(random() % parts.parts.size());
        Parts expected = parts;
        fill_by_definition(s, expected);
        for (const int threads : {1, 2}) {
            Parts filled = parts;
            s.threads = threads;
            fill(s, free_pieces(s, filled), filled);
            EXPECT_EQ(filled.part_of, expected.part_of);
        }
    }
}

/// Two boxes, one on the other: flat walls whose steps tie, creases, and parts that are exact or not.
TEST(Fill, TakesTheCheapestStepOfAll) {
    TriangleMesh mesh =
        shapes::join({{Vec3(0, 0, 0), Vec3(1, 1, 0.3), 0}, {Vec3(0.3, 0.3, 0.3), Vec3(0.7, 0.7, 1), 1}}, 0.1).mesh;
    expect_as_defined(mesh, false);
    expect_as_defined(mesh, true);
    std::mt19937 random(5);
    std::normal_distribution<double> shift(0, 0.02);
    for (Vec3& p : mesh.positions) p += Vec3(shift(random), shift(random), shift(random));
    expect_as_defined(mesh, false);
}

/// Pieces that no part touches stay free.
TEST(Fill, LeavesWhatNoPartReaches) {
    const TriangleMesh mesh = shapes::cylinder(1, 3, 12, 6);
    Surface s(mesh);
    s.adjacency = build_adjacency(mesh);
    s.geometry = compute_geometry(mesh);
    Parts parts{{}, std::vector<std::int32_t>(s.count(), -1)};
    fill(s, free_pieces(s, parts), parts);
    EXPECT_EQ(parts.part_of, std::vector<std::int32_t>(s.count(), -1));
}

}  // namespace
}  // namespace partonomy
