#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <random>

#include "mesh/shapes.h"
#include "mesh/weld.h"

namespace partonomy {
namespace {

using test::box;
using test::cleaned;
using test::joined;
using test::soup_of;

/// Every face gets points of its own, as in an STL file.
PolygonSoup exploded(const PolygonSoup& soup) {
    PolygonSoup result = soup;
    result.positions.clear();
    for (std::size_t i = 0; i < soup.corners.size(); ++i) {
        result.positions.push_back(soup.positions[static_cast<std::size_t>(soup.corners[i])]);
        result.corners[i] = static_cast<std::int32_t>(i);
    }
    return result;
}

void turn_face(PolygonSoup& soup, std::size_t f) {
    std::reverse(soup.corners.begin() + soup.face_starts[f], soup.corners.begin() + soup.face_starts[f + 1]);
}

/// The upper side of a box in two halves, and the sides beside it whole: their upper edges are cut.
TEST(CleanMesh, TJunctionsAreClosed) {
    PolygonSoup soup =
        soup_of({{0, 0, 0},
                 {1, 0, 0},
                 {0, 1, 0},
                 {1, 1, 0},
                 {0, 0, 1},
                 {1, 0, 1},
                 {0, 1, 1},
                 {1, 1, 1},
                 {0.5, 0, 1},
                 {0.5, 1, 1}},
                {{0, 2, 3, 1}, {4, 8, 9, 6}, {8, 5, 7, 9}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
    MeshReport report;
    const TriangleMesh mesh = cleaned(soup, report);
    EXPECT_EQ(validate(mesh), "");
    ASSERT_EQ(report.notes.size(), 1U);
    EXPECT_TRUE(report.notes[0].starts_with("2 edges run along several shorter ones")) << report.notes[0];
    EXPECT_EQ(report.boundary_edges, 0);
    EXPECT_EQ(report.flipped_triangles, 0);
    EXPECT_EQ(mesh.triangles.size(), 16U);
    EXPECT_TRUE(std::ranges::is_sorted(mesh.input_faces));
    for (const double area : compute_geometry(mesh).areas) EXPECT_GT(area, 0.1);
}

/// Triangles of a box cut at random, at points of their longest sides, and not their neighbours; each gets its label.
TEST(CleanMesh, TJunctionsOfAllKindsAreClosed) {
    for (unsigned seed = 1; seed <= 20; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> share(0.2, 0.8);
        MeshReport report;
        const TriangleMesh whole = cleaned(box({-1, 2, 0}, {3, 3, 1}), report);
        std::vector<Vec3> points = whole.positions;
        std::vector<std::vector<std::int32_t>> faces;
        for (const auto& [a, b, c] : whole.triangles) {
            if (random() % 2 == 0) {
                faces.push_back({a, b, c});
                continue;
            }
            // One to three points on one side.
            std::vector<double> places(1 + random() % 3);
            for (double& place : places) place = share(random);
            std::ranges::sort(places);
            std::int32_t last = a;
            for (const double place : places) {
                const Vec3 rounding = 1e-9 * Vec3(share(random), share(random), share(random));
                points.push_back(rounding + points[static_cast<std::size_t>(a)] +
                                 place * (points[static_cast<std::size_t>(b)] - points[static_cast<std::size_t>(a)]));
                faces.push_back({last, static_cast<std::int32_t>(points.size()) - 1, c});
                last = faces.back()[1];
            }
            faces.push_back({last, b, c});
        }
        const PolygonSoup soup = soup_of(points, faces);
        const TriangleMesh mesh = cleaned(soup, report);
        EXPECT_EQ(validate(mesh), "");
        EXPECT_EQ(report.degenerate_faces, 0);
        double area = 0;
        for (const double each : compute_geometry(mesh).areas) area += each;
        EXPECT_NEAR(area, 2 * (4 + 4 + 1), 1e-7);
        for (const double each : compute_geometry(mesh).areas) EXPECT_GT(each, 1e-6);  // none of rounding
        // A side that was cut at different places from both sides has no row of edges from end to end on either.
        EXPECT_LE(report.boundary_edges, 5 * 6);
        EXPECT_EQ(mesh.input_face_count, soup.face_count());
    }
}

/// Boards that are laid edge to edge, shifted: no edge of either ends where one of the other does.
TEST(CleanMesh, WhatOnlyComesNearIsNotCut) {
    const PolygonSoup sheets = joined(soup_of({{0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0}}, {{0, 1, 2, 3}}),
                                      soup_of({{1, 1, 0}, {3, 1, 0}, {3, 2, 0}, {1, 2, 0}}, {{0, 1, 2, 3}}));
    MeshReport report;
    EXPECT_EQ(cleaned(sheets, report).triangles.size(), 4U);
    EXPECT_TRUE(report.notes.empty());
    EXPECT_EQ(report.boundary_edges, 8);
}

TEST(CleanMesh, LeavesAGoodBoxAlone) {
    MeshReport report;
    const TriangleMesh mesh = cleaned(box(), report);
    EXPECT_EQ(validate(mesh), "");
    EXPECT_EQ(mesh.positions.size(), 8U);
    EXPECT_EQ(mesh.triangles.size(), 12U);
    EXPECT_EQ(mesh.input_faces, (std::vector<std::int32_t>{0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 5, 5}));
    EXPECT_EQ(report.input_vertices, 8);
    EXPECT_EQ(report.input_faces, 6);
    EXPECT_EQ(report.shells, 1);
    EXPECT_TRUE(report.sentences().empty());
    EXPECT_DOUBLE_EQ(compute_topology(mesh).volume, 1);
}

TEST(CleanMesh, WeldsExactAndCloseCopies) {
    MeshReport report;
    PolygonSoup soup = exploded(box());
    EXPECT_EQ(cleaned(soup, report).positions.size(), 8U);
    EXPECT_EQ(report.welded_vertices, 16);
    EXPECT_EQ(report.sentences().size(), 1U);
    std::mt19937 random(5);
    std::uniform_real_distribution<double> shake(-2e-8, 2e-8);
    for (Vec3& p : soup.positions) p += Vec3(shake(random), shake(random), shake(random));
    const TriangleMesh mesh = cleaned(soup, report);
    EXPECT_EQ(mesh.positions.size(), 8U);
    EXPECT_EQ(compute_topology(mesh).euler, 2);
    EXPECT_EQ(clean_mesh(soup, "t", report, {.weld_tolerance = 0}).positions.size(), 24U);
    EXPECT_EQ(report.boundary_edges, 24);
}

TEST(CleanMesh, FarAwayPointsThatNoFaceUsesDoNotWidenTheTolerance) {
    PolygonSoup soup = box();
    soup.positions.emplace_back(1e9, 1e9, 1e9);
    MeshReport report;
    EXPECT_EQ(cleaned(soup, report).positions.size(), 8U);
    EXPECT_EQ(report.unused_vertices, 1);
}

/// A second opinion: every pair of points compared.
TEST(WeldPoints, AgreesWithComparingAllPairs) {
    constexpr unsigned seed = 11;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    for (const double distance : {0.0, 0.003, 0.05}) {
        std::uniform_int_distribution<int> step(0, 40);
        std::vector<Vec3> points;
        for (int i = 0; i < 600; ++i) points.push_back(Vec3(step(random), step(random), step(random) / 4) * 0.025);
        const std::vector<std::int32_t> merged = weld_points(points, std::vector<bool>(points.size(), true), distance);
        for (std::size_t i = 0; i < points.size(); ++i) {
            std::int32_t expected = static_cast<std::int32_t>(i);
            for (std::size_t j = 0; j < i; ++j) {
                if (merged[j] != static_cast<std::int32_t>(j)) continue;  // only representatives attract
                if (points[j] == points[i] || (points[j] - points[i]).squaredNorm() < distance * distance) {
                    expected = static_cast<std::int32_t>(j);
                    break;
                }
            }
            EXPECT_EQ(merged[i], expected);
        }
    }
}

TEST(CleanMesh, DegenerateFacesKeepTheirNumber) {
    MeshReport report;
    const TriangleMesh mesh = cleaned(
        soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 0, 0}}, {{0, 1, 3}, {0, 1}, {}, {0, 1, 2}, {1, 1, 2}, {3}}),
        report);
    EXPECT_EQ(mesh.triangles.size(), 1U);
    EXPECT_EQ(mesh.input_faces[0], 3);
    EXPECT_EQ(mesh.input_face_count, 6);
    EXPECT_EQ(report.degenerate_faces, 5);
}

TEST(CleanMesh, DuplicatesAreLeftOutWhateverTheirWinding) {
    PolygonSoup soup = box();
    soup = joined(soup, box());
    MeshReport report;
    EXPECT_EQ(cleaned(soup, report).triangles.size(), 12U);
    EXPECT_EQ(report.duplicate_faces, 12);
    EXPECT_EQ(cleaned(joined(box(), box(), true), report).triangles.size(), 12U);
    EXPECT_EQ(
        cleaned(soup_of({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}, {2, 1, 0}, {1, 2, 0}}), report).triangles.size(),
        1U);
    EXPECT_EQ(report.duplicate_faces, 2);
}

TEST(CleanMesh, MixedWindingAgreesAgainAndFacesOutward) {
    for (unsigned mask = 0; mask < 64; ++mask) {
        SCOPED_TRACE(mask);
        PolygonSoup soup = box();
        for (std::size_t f = 0; f < 6; ++f)
            if (mask >> f & 1) turn_face(soup, f);
        MeshReport report;
        const TriangleMesh mesh = cleaned(soup, report);
        const Topology topology = compute_topology(mesh);
        EXPECT_EQ(topology.disagreeing_edges, 0);
        EXPECT_DOUBLE_EQ(topology.volume, 1);
        EXPECT_EQ(report.flipped_triangles, 2 * std::popcount(mask));
    }
}

TEST(CleanMesh, SheetsFollowTheirMajority) {
    // Three quads in a row; the middle one is turned.
    MeshReport report;
    const TriangleMesh mesh =
        cleaned(soup_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}, {3, 1, 0}},
                        {{4, 5, 1, 0}, {1, 2, 6, 5}, {2, 3, 7, 6}}),
                report);
    for (const Vec3& normal : compute_geometry(mesh).normals) EXPECT_EQ(normal, Vec3(0, 0, 1));
    EXPECT_EQ(report.flipped_triangles, 2);
    EXPECT_EQ(report.boundary_edges, 8);
}

TEST(CleanMesh, ABoxWithoutBottomStillFacesOutward) {
    PolygonSoup soup = box();
    soup.corners.erase(soup.corners.begin(), soup.corners.begin() + 4);
    soup.face_starts.pop_back();
    for (std::size_t f = 0; f < 5; ++f) turn_face(soup, f);
    MeshReport report;
    const TriangleMesh mesh = cleaned(soup, report);
    EXPECT_EQ(report.flipped_triangles, 10);
    EXPECT_EQ(report.boundary_edges, 4);
    EXPECT_EQ(compute_geometry(mesh).normals[0], Vec3(0, 0, 1));
}

TEST(CleanMesh, CavitiesStayAndSolidsInsideFaceOutward) {
    const PolygonSoup outer = box(), inner = box(Vec3(0.25, 0.25, 0.25), Vec3(0.75, 0.75, 0.75));
    MeshReport report;
    EXPECT_DOUBLE_EQ(compute_topology(cleaned(joined(outer, inner, true), report)).volume, 1 - 0.125);
    EXPECT_EQ(report.cavities, 1);
    EXPECT_EQ(report.shells, 2);
    EXPECT_EQ(report.flipped_triangles, 0);
    EXPECT_DOUBLE_EQ(compute_topology(cleaned(joined(outer, inner), report)).volume, 1 + 0.125);
    EXPECT_EQ(report.cavities, 0);
    // The whole file inside out: the cavity is still one.
    PolygonSoup inside_out = joined(joined(PolygonSoup{{}, {}, {0}, {}}, outer, true), inner);
    EXPECT_DOUBLE_EQ(compute_topology(cleaned(inside_out, report)).volume, 1 - 0.125);
    EXPECT_EQ(report.flipped_triangles, 24);
    // Beside each other, opposite windings mean nothing.
    const PolygonSoup beside = joined(outer, box(Vec3(2, 0, 0), Vec3(3, 1, 1)), true);
    EXPECT_DOUBLE_EQ(compute_topology(cleaned(beside, report)).volume, 2);
}

TEST(CleanMesh, OneSidedSurfacesAreReported) {
    std::vector<Vec3> points;
    std::vector<std::vector<std::int32_t>> faces;
    constexpr int n = 12;
    for (int i = 0; i < n; ++i) {
        const double angle = 2 * 3.14159265358979 * i / n;
        const Vec3 out(std::cos(angle), std::sin(angle), 0);
        const Vec3 across = std::cos(angle / 2) * Vec3(0, 0, 1) + std::sin(angle / 2) * out;
        points.push_back(3 * out + across);
        points.push_back(3 * out - across);
    }
    for (int i = 0; i < n; ++i) {
        const int a = 2 * i, b = 2 * ((i + 1) % n);
        faces.push_back(i + 1 < n ? std::vector<std::int32_t>{a, a + 1, b + 1, b}
                                  : std::vector<std::int32_t>{a, a + 1, b, b + 1});
    }
    MeshReport report;
    const TriangleMesh mesh = cleaned(soup_of(points, faces), report);
    EXPECT_EQ(mesh.triangles.size(), 24U);
    EXPECT_EQ(report.one_sided_shells, 1);
    EXPECT_EQ(report.boundary_edges, 24);
}

TEST(CleanMesh, ReportReadsLikeSentences) {
    MeshReport report;
    report.welded_vertices = 1;
    report.degenerate_faces = 2;
    report.boundary_edges = 3;
    EXPECT_EQ(report.sentences(),
              (std::vector<std::string>{"1 vertex lay at the place of another one and was merged into it.",
                                        "2 faces have no area and will carry no label.",
                                        "The surface is open: 3 edges have a triangle on one side only."}));
}

TEST(CleanMesh, TinyAndFarAwayObjectsWork) {
    for (const double size : {1e-9, 1e-3, 1e6, 1e40}) {
        MeshReport report;
        const TriangleMesh mesh = cleaned(box(Vec3::Constant(-size), Vec3::Constant(size)), report);
        EXPECT_EQ(mesh.triangles.size(), 12U) << size;
        EXPECT_EQ(mesh.positions.size(), 8U) << size;
    }
    MeshReport report;
    EXPECT_EQ(cleaned(box(Vec3::Constant(1e6), Vec3::Constant(1e6 + 1)), report).positions.size(), 8U);
}

}  // namespace
}  // namespace partonomy
