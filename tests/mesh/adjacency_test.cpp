#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>

#include "mesh/parallel.h"
#include "mesh/shapes.h"

namespace partonomy {
namespace {

using test::box;
using test::cleaned;
using test::joined;

/// Every link goes both ways and over an edge with the same two ends.
void expect_mutual(const TriangleMesh& mesh, const Adjacency& adjacency) {
    ASSERT_EQ(adjacency.neighbours.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t e = 0; e < 3; ++e) {
            const std::int32_t other = adjacency.neighbours[t][e];
            if (other < 0) continue;
            const auto [low, high] = std::minmax(mesh.triangles[t][e], mesh.triangles[t][(e + 1) % 3]);
            bool found = false;
            for (std::size_t k = 0; k < 3; ++k) {
                const auto& back = mesh.triangles[static_cast<std::size_t>(other)];
                const auto [l, h] = std::minmax(back[k], back[(k + 1) % 3]);
                found |= l == low && h == high &&
                         adjacency.neighbours[static_cast<std::size_t>(other)][k] == static_cast<std::int32_t>(t);
            }
            EXPECT_TRUE(found) << t << " " << e;
        }
}

std::set<std::int32_t> reached(const Adjacency& adjacency, std::int32_t from) {
    std::set<std::int32_t> seen{from};
    std::vector<std::int32_t> open{from};
    while (!open.empty()) {
        const auto t = static_cast<std::size_t>(open.back());
        open.pop_back();
        for (const std::int32_t other : adjacency.neighbours[t])
            if (other >= 0 && seen.insert(other).second) open.push_back(other);
    }
    return seen;
}

TEST(BuildAdjacency, ClosedBoxHasNoOpenEdge) {
    MeshReport report;
    const TriangleMesh mesh = cleaned(box(), report);
    const Adjacency adjacency = build_adjacency(mesh);
    expect_mutual(mesh, adjacency);
    for (const auto& neighbours : adjacency.neighbours)
        for (const std::int32_t n : neighbours) EXPECT_GE(n, 0);
    EXPECT_EQ(reached(adjacency, 0).size(), 12U);
}

TEST(BuildAdjacency, OpenEdgesAreMinusOne) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}};
    mesh.triangles = {{0, 1, 2}, {2, 1, 3}};
    mesh.input_faces = {0, 1};
    mesh.input_face_count = 2;
    const Adjacency adjacency = build_adjacency(mesh);
    EXPECT_EQ(adjacency.neighbours[0], (std::array<std::int32_t, 3>{-1, 1, -1}));
    EXPECT_EQ(adjacency.neighbours[1], (std::array<std::int32_t, 3>{0, -1, -1}));
}

TEST(BuildAdjacency, BoxesThatTouchAlongAnEdgeStayTwoSolids) {
    for (const bool mirrored : {false, true}) {
        const PolygonSoup second = mirrored ? box(Vec3(-1, 1, 0), Vec3(0, 2, 1)) : box(Vec3(1, 1, 0), Vec3(2, 2, 1));
        MeshReport report;
        const TriangleMesh mesh = cleaned(joined(box(), second), report);
        EXPECT_EQ(report.non_manifold_edges, 1);
        EXPECT_EQ(report.shells, 1);
        const Adjacency adjacency = build_adjacency(mesh);
        expect_mutual(mesh, adjacency);
        EXPECT_EQ(reached(adjacency, 0).size(), 12U);
        EXPECT_EQ(reached(adjacency, 12).size(), 12U);
        EXPECT_EQ(*reached(adjacency, 12).begin(), 12);
    }
}

// Coordinates of single precision far from the origin turn what is thin by more than they turn what is thick.
TEST(BuildAdjacency, ThinSolidsSideBySideStayApartThoughCoordinatesAreRounded) {
    for (unsigned seed = 1; seed <= 100; ++seed) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> any(0, 1);
        PolygonSoup three = joined(joined(box(Vec3(0, 0, 0), Vec3(1, 1, 1)), box(Vec3(0, 0, 1), Vec3(1, 1, 1.04))),
                                   box(Vec3(1, 0, 1), Vec3(2, 1, 1.04)));
        const Eigen::AngleAxisd turn(6.3 * any(random), Vec3(any(random), any(random), any(random)).normalized());
        const Vec3 shift = 200 * Vec3(any(random), any(random), any(random)) - Vec3(100, 100, 100);
        for (Vec3& position : three.positions) position = (turn * position + shift).cast<float>().cast<double>();
        MeshReport report;
        const TriangleMesh mesh = cleaned(three, report);
        const Adjacency adjacency = build_adjacency(mesh);
        for (const std::int32_t first : {0, 12, 24}) EXPECT_EQ(reached(adjacency, first).size(), 12U) << first;
    }
}

TEST(BuildAdjacency, WedgesAroundOneEdgeArePairedWithThemselves) {
    // Five thin wedges around the z axis, each a closed tetrahedron-like prism with its own far corners.
    constexpr int wedges = 5;
    PolygonSoup soup = test::soup_of({{0, 0, 0}, {0, 0, 1}}, {});
    for (int w = 0; w < wedges; ++w) {
        const double angle = 1.2 * w + 0.3;
        const auto a = static_cast<std::int32_t>(soup.positions.size());
        soup.positions.emplace_back(std::cos(angle), std::sin(angle), 0.5);
        soup.positions.emplace_back(std::cos(angle + 0.4), std::sin(angle + 0.4), 0.5);
        for (const auto& face :
             std::vector<std::array<std::int32_t, 3>>{{0, a, 1}, {0, 1, a + 1}, {0, a + 1, a}, {1, a, a + 1}}) {
            soup.corners.insert(soup.corners.end(), face.begin(), face.end());
            soup.face_starts.push_back(static_cast<std::int64_t>(soup.corners.size()));
        }
    }
    MeshReport report;
    const TriangleMesh mesh = cleaned(soup, report);
    EXPECT_EQ(report.flipped_triangles, 0);
    const Adjacency adjacency = build_adjacency(mesh);
    expect_mutual(mesh, adjacency);
    for (std::int32_t w = 0; w < wedges; ++w)
        EXPECT_EQ(reached(adjacency, 4 * w), (std::set<std::int32_t>{4 * w, 4 * w + 1, 4 * w + 2, 4 * w + 3}));
}

/// A second opinion on random closed and open surfaces: a map from vertex pairs.
TEST(BuildAdjacency, AgreesWithAMapOfEdges) {
    constexpr unsigned seed = 17;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    TriangleMesh mesh;
    constexpr int n = 30;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) mesh.positions.emplace_back(x, y, 0);
    for (int y = 0; y + 1 < n; ++y)
        for (int x = 0; x + 1 < n; ++x) {
            const int v = y * n + x;
            if (random() % 10 == 0) continue;
            mesh.triangles.push_back({v, v + 1, v + n});
            mesh.triangles.push_back({v + 1, v + n + 1, v + n});
        }
    std::shuffle(mesh.triangles.begin(), mesh.triangles.end(), random);
    EXPECT_EQ(build_adjacency(mesh).neighbours, build_adjacency(mesh, 2).neighbours);
    std::map<std::pair<int, int>, std::vector<std::int32_t>> edges;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t e = 0; e < 3; ++e)
            edges[std::minmax({mesh.triangles[t][e], mesh.triangles[t][(e + 1) % 3]})].push_back(
                static_cast<std::int32_t>(t));
    const Adjacency adjacency = build_adjacency(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t e = 0; e < 3; ++e) {
            const auto& around = edges[std::minmax({mesh.triangles[t][e], mesh.triangles[t][(e + 1) % 3]})];
            const std::int32_t expected = around.size() < 2                           ? -1
                                          : around[0] == static_cast<std::int32_t>(t) ? around[1]
                                                                                      : around[0];
            EXPECT_EQ(adjacency.neighbours[t][e], expected);
        }
}

TEST(ComputeGeometry, AreasNormalsBarycentres) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {2, 0, 0}, {0, 3, 0}};
    mesh.triangles = {{0, 1, 2}, {0, 0, 1}};
    const TriangleGeometry geometry = compute_geometry(mesh);
    EXPECT_DOUBLE_EQ(geometry.areas[0], 3);
    EXPECT_EQ(geometry.normals[0], Vec3(0, 0, 1));
    EXPECT_TRUE(geometry.barycentres[0].isApprox(Vec3(2.0 / 3, 1, 0)));
    EXPECT_EQ(geometry.areas[1], 0);
    EXPECT_EQ(geometry.normals[1], Vec3(0, 0, 0));
    const Bounds bounds = compute_bounds(mesh);
    EXPECT_EQ(bounds.low, Vec3(0, 0, 0));
    EXPECT_EQ(bounds.high, Vec3(2, 3, 0));
}

TEST(Validate, NamesTheFirstBrokenPromise) {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.triangles = {{0, 1, 2}};
    mesh.input_faces = {0};
    mesh.input_face_count = 1;
    EXPECT_EQ(validate(mesh), "");
    mesh.input_faces = {1};
    EXPECT_NE(validate(mesh), "");
    mesh.input_faces = {0};
    mesh.triangles = {{0, 1, 3}};
    EXPECT_NE(validate(mesh), "");
    mesh.triangles = {{0, 1, 1}};
    EXPECT_NE(validate(mesh), "");
}

}  // namespace
}  // namespace partonomy
