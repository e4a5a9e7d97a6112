#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>
#include <set>

#include "examples/objects.h"
#include "examples/transforms.h"
#include "mesh/read_mesh.h"
#include "mesh/write_off.h"

namespace partonomy {
namespace {

struct Expected {
    const char* name;
    const char* object_class;
    int parts, triangles, euler;
    double seat_top, height;
    std::map<std::string, int> part_labels;
};

// Parts and triangles are the paper's Table 1.
const std::vector<Expected> expected{
    {"bench", "Bench", 4, 36, 2, 0.27, 0.7, {{"Seat", 1}, {"Backrest", 1}, {"Leg", 2}}},
    {"bench2", "Bench", 6, 52, 2, 0.27, 0.7, {{"Seat", 1}, {"Backrest", 1}, {"Leg", 4}}},
    {"chair", "Chair", 6, 52, 2, 0.43, 0.88, {{"Seat", 1}, {"Backrest", 1}, {"Leg", 4}}},
    {"chair2", "Chair", 8, 82, 0, 0.43, 0.9, {{"Seat", 1}, {"Backrest", 1}, {"BackPost", 2}, {"Leg", 4}}},
    {"couch", "Couch", 6, 52, 2, 0.43, 0.85, {{"Seat", 1}, {"Backrest", 1}, {"Leg", 4}}},
    {"curved-bench", "Bench", 29, 2542, 2, 0.27, 0.72, {{"Seat", 1}, {"Backrest", 14}, {"Leg", 14}}},
    {"strange-object2", "Chair", 9, 100, 0, 0.43, 0.9, {{"Seat", 1}, {"Backrest", 1}, {"BackPost", 2}, {"Leg", 5}}},
};

void expect_closed(const TriangleMesh& mesh, int euler) {
    EXPECT_EQ(validate(mesh), "");
    const Topology topology = compute_topology(mesh);
    EXPECT_EQ(topology.boundary_edges, 0);
    EXPECT_EQ(topology.non_manifold_edges, 0);
    EXPECT_EQ(topology.disagreeing_edges, 0);
    EXPECT_EQ(topology.shells, 1);
    EXPECT_EQ(topology.euler, euler);
    EXPECT_GT(topology.volume, 0);
}

TEST(PaperObjects, HaveTheCountsOfTable1AndAreClosed) {
    const std::vector<ExampleObject> objects = paper_objects();
    ASSERT_EQ(objects.size(), expected.size());
    for (std::size_t i = 0; i < objects.size(); ++i) {
        const ExampleObject& object = objects[i];
        const Expected& want = expected[i];
        SCOPED_TRACE(want.name);
        EXPECT_EQ(object.name, want.name);
        EXPECT_EQ(object.object_class, want.object_class);
        EXPECT_EQ(object.incompatibility.empty(), object.name != "strange-object2");
        EXPECT_EQ(object.part_count, want.parts);
        EXPECT_EQ(object.mesh.triangles.size(), static_cast<std::size_t>(want.triangles));
        expect_closed(object.mesh, want.euler);
        const Bounds bounds = compute_bounds(object.mesh);
        EXPECT_EQ(bounds.low.z(), 0);
        EXPECT_DOUBLE_EQ(bounds.high.z(), want.height);
        std::map<std::string, std::set<int>> parts;
        double seat_top = 0;
        for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t) {
            parts[object.labels[t]].insert(object.parts[t]);
            for (const std::int32_t v : object.mesh.triangles[t])
                if (object.labels[t] == "Seat")
                    seat_top = std::max(seat_top, object.mesh.positions[static_cast<std::size_t>(v)].z());
        }
        std::map<std::string, int> counts;
        for (const auto& [label, numbers] : parts) counts[label] = static_cast<int>(numbers.size());
        EXPECT_EQ(counts, want.part_labels);
        EXPECT_DOUBLE_EQ(seat_top, want.seat_top);
    }
}

TEST(PaperObjects, EveryPartIsConnected) {
    for (const ExampleObject& object : paper_objects()) {
        SCOPED_TRACE(object.name);
        const Adjacency adjacency = build_adjacency(object.mesh);
        std::set<int> begun;
        std::vector<bool> seen(object.mesh.triangles.size(), false);
        for (std::size_t seed = 0; seed < seen.size(); ++seed) {
            if (seen[seed]) continue;
            EXPECT_TRUE(begun.insert(object.parts[seed]).second) << object.parts[seed];
            std::vector<std::size_t> open{seed};
            seen[seed] = true;
            while (!open.empty()) {
                const std::size_t t = open.back();
                open.pop_back();
                for (const std::int32_t n : adjacency.neighbours[t]) {
                    const auto other = static_cast<std::size_t>(n);
                    if (seen[other] || object.parts[other] != object.parts[t]) continue;
                    seen[other] = true;
                    open.push_back(other);
                }
            }
        }
        EXPECT_EQ(begun.size(), static_cast<std::size_t>(object.part_count));
    }
}

/// Worked out by hand: a U of 1.2 x 0.4 x 0.27 around a gap of 1.12 x 0.4 x 0.23, and a gable of 1.2 x 0.43 / 2 x 0.04.
TEST(PaperObjects, VolumeOfTheBench) {
    EXPECT_NEAR(compute_topology(paper_object("bench").mesh).volume,
                1.2 * 0.4 * 0.27 - 1.12 * 0.4 * 0.23 + 1.2 * 0.43 / 2 * 0.04, 1e-12);
}

/// No triangle cuts through another one: each edge is asked against each triangle without a common corner.
TEST(PaperObjects, DoNotCrossThemselves) {
    for (const ExampleObject& object : paper_objects()) {
        if (object.mesh.triangles.size() > 200) continue;  // the curved bench is cut from one grid
        SCOPED_TRACE(object.name);
        const auto& positions = object.mesh.positions;
        const auto volume = [&](std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d) {
            const Vec3& o = positions[static_cast<std::size_t>(a)];
            const double v =
                (positions[static_cast<std::size_t>(b)] - o)
                    .dot(
                        (positions[static_cast<std::size_t>(c)] - o).cross(positions[static_cast<std::size_t>(d)] - o));
            return std::abs(v) < 1e-12 ? 0.0 : v;
        };
        for (const auto& s : object.mesh.triangles)
            for (std::size_t e = 0; e < 3; ++e)
                for (const auto& [a, b, c] : object.mesh.triangles) {
                    const std::int32_t p = s[e], q = s[(e + 1) % 3];
                    if (p == a || p == b || p == c || q == a || q == b || q == c) continue;
                    if (volume(p, a, b, c) * volume(q, a, b, c) >= 0) continue;
                    const double u = volume(p, q, a, b), v = volume(p, q, b, c), w = volume(p, q, c, a);
                    EXPECT_FALSE((u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0));
                }
    }
}

TEST(PaperObjects, ReadBackAsWritten) {
    for (const ExampleObject& object : paper_objects()) {
        SCOPED_TRACE(object.name);
        MeshReport report;
        const TriangleMesh mesh = clean_mesh(parse_mesh(to_off(object.mesh), object.name), object.name, report);
        EXPECT_EQ(mesh.positions, object.mesh.positions);
        EXPECT_EQ(mesh.triangles, object.mesh.triangles);
        EXPECT_EQ(mesh.input_faces, object.mesh.input_faces);
        EXPECT_TRUE(report.sentences().empty());
    }
}

TEST(Transforms, KeepTheSurfaceAndItsLabels) {
    for (const ExampleObject& object : paper_objects()) {
        SCOPED_TRACE(object.name);
        const Topology before = compute_topology(object.mesh);
        const auto area_of = [](const ExampleObject& o) {
            std::map<std::string, double> areas;
            const TriangleGeometry geometry = compute_geometry(o.mesh);
            for (std::size_t t = 0; t < o.labels.size(); ++t) areas[o.labels[t]] += geometry.areas[t];
            return areas;
        };
        const auto areas = area_of(object);
        for (const ExampleObject& changed :
             {rotated_about_z(object, 37), translated(object, Vec3(3, -2, 5)), mirrored(object),
              with_permuted_faces(object, 4), subdivided(object), scaled(scaled(object, 3), 1.0 / 3)}) {
            expect_closed(changed.mesh, static_cast<int>(before.euler));
            EXPECT_NEAR(compute_topology(changed.mesh).volume, before.volume, 1e-9);
            const auto changed_areas = area_of(changed);
            ASSERT_EQ(changed_areas.size(), areas.size());
            for (const auto& [label, area] : areas) EXPECT_NEAR(changed_areas.at(label), area, 1e-9);
        }
        EXPECT_EQ(subdivided(object).mesh.triangles.size(), 4 * object.mesh.triangles.size());
        EXPECT_NE(with_permuted_faces(object, 4).mesh.triangles, object.mesh.triangles);
    }
}

}  // namespace
}  // namespace partonomy
