// Fresh noise of two kinds on a cube that carries two boards and a stick, as in Fig. 16 of the paper: waves of many
// lengths along the normals (a scan of a dented thing), and each vertex by itself (a bad scan). Told as root mean
// square of the shift, relative to the diagonal of the bounding box.

#include <gtest/gtest.h>

#include <map>

#include "shape/calm.h"
#include "shape/find_parts.h"
#include "shape/shapes.h"

namespace partonomy {
namespace {

using shapes::Labelled;

constexpr int cube = 0, upright = 1, level = 2, stick = 3;

const std::vector<shapes::Block> cube_with_parts_blocks{{Vec3(0, 0, 0), Vec3(1, 1, 1), cube},
                                                        {Vec3(0.1, 0.7, 1), Vec3(0.9, 0.9, 1.7), upright},
                                                        {Vec3(1, 0.1, 0.5), Vec3(1.5, 0.9, 0.64), level},
                                                        {Vec3(0.1, 0.1, -0.8), Vec3(0.4, 0.4, 0), stick}};

Labelled cube_with_parts() { return shapes::join(cube_with_parts_blocks, 0.022); }

std::vector<Vec3> vertex_normals(const TriangleMesh& mesh) {
    std::vector<Vec3> normals(mesh.positions.size(), Vec3::Zero());
    for (const auto& t : mesh.triangles) {
        const Vec3 &a = mesh.positions[static_cast<std::size_t>(t[0])],
                   &b = mesh.positions[static_cast<std::size_t>(t[1])],
                   &c = mesh.positions[static_cast<std::size_t>(t[2])];
        for (const std::int32_t v : t) normals[static_cast<std::size_t>(v)] += (b - a).cross(c - a);
    }
    for (Vec3& normal : normals) normal.normalize();
    return normals;
}

/// `longest` wave, over the diagonal.
void add_waves_up_to(double longest, TriangleMesh& mesh, double level_of_noise, std::mt19937& random) {
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> phase(0, 2 * std::numbers::pi);
    const double size = compute_bounds(mesh).diagonal();
    std::vector<double> height(mesh.positions.size(), 0.0);
    for (double length = longest; length > 0.03; length /= 2)
        for (int k = 0; k < 8; ++k) {
            Vec3 wave(normal(random), normal(random), normal(random));
            wave *= 2 * std::numbers::pi / (length * size * wave.norm());
            const double start = phase(random);
            for (std::size_t v = 0; v < height.size(); ++v)
                height[v] += length * std::sin(mesh.positions[v].dot(wave) + start);
        }
    double sum = 0;
    for (const double h : height) sum += h * h;
    const double scale = level_of_noise * size / std::sqrt(sum / static_cast<double>(height.size()));
    const std::vector<Vec3> normals = vertex_normals(mesh);
    for (std::size_t v = 0; v < height.size(); ++v) mesh.positions[v] += scale * height[v] * normals[v];
}

void add_waves(TriangleMesh& mesh, double level_of_noise, std::mt19937& random) {
    add_waves_up_to(0.5, mesh, level_of_noise, random);
}

/// These turn the walls by up to half a right angle: rays go astray.
void add_short_waves(TriangleMesh& mesh, double level_of_noise, std::mt19937& random) {
    add_waves_up_to(0.2, mesh, level_of_noise, random);
}

void add_grains(TriangleMesh& mesh, double level_of_noise, std::mt19937& random) {
    std::normal_distribution<double> normal(0, level_of_noise * compute_bounds(mesh).diagonal() / std::sqrt(3.0));
    for (Vec3& point : mesh.positions) point += Vec3(normal(random), normal(random), normal(random));
}

struct Noise {
    const char* name;
    void (*add)(TriangleMesh&, double, std::mt19937&);
    double level, accuracy;
};

class FreshNoise : public testing::TestWithParam<Noise> {};

TEST_P(FreshNoise, FourRegionsWithTheRightShapes) {
    const Labelled clean = cube_with_parts();
    const std::map<int, char> shapes = {{cube, 'C'}, {upright, 'B'}, {level, 'B'}, {stick, 'S'}};
    for (const unsigned seed : {1U, 2U, 3U}) {
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        TriangleMesh mesh = clean.mesh;
        GetParam().add(mesh, GetParam().level, random);
        const std::vector<PartRegion> parts = find_parts(mesh);
        EXPECT_EQ(parts.size(), 4U);
        std::size_t good = 0;
        for (const PartRegion& part : parts) {
            std::map<int, std::size_t> votes;
            for (const std::int32_t t : part.region.triangles) ++votes[clean.parts[static_cast<std::size_t>(t)]];
            const auto best = std::max_element(votes.begin(), votes.end(),
                                               [](const auto& a, const auto& b) { return a.second < b.second; });
            good += best->second;
            const Vec3& l = part.box.lengths;
            EXPECT_EQ(l[1] > 2 * l[2] ? 'B' : l[0] > 2 * l[1] ? 'S' : 'C', shapes.at(best->first)) << best->first;
        }
        EXPECT_GE(static_cast<double>(good) / static_cast<double>(mesh.triangles.size()), GetParam().accuracy);
    }
}

INSTANTIATE_TEST_SUITE_P(Kinds, FreshNoise,
                         testing::Values(Noise{"Waves05", add_waves, 0.005, 0.99},
                                         Noise{"Waves10", add_waves, 0.01, 0.98},
                                         Noise{"Grains05", add_grains, 0.005, 0.99},
                                         Noise{"Grains10", add_grains, 0.01, 0.985}),
                         [](const auto& noise) { return std::string(noise.param.name); });

struct OtherShape {
    const char* name;
    std::vector<shapes::Block> blocks;
};

class OtherShapesUnderNoise : public testing::TestWithParam<OtherShape> {};

TEST_P(OtherShapesUnderNoise, KeepTheirParts) {
    const Labelled clean = shapes::join(GetParam().blocks, 0.015);
    const std::size_t parts = GetParam().blocks.size();
    for (const auto add : {add_waves, add_grains})
        for (const unsigned seed : {21U, 22U, 23U, 24U}) {
            SCOPED_TRACE(testing::Message() << (add == add_waves ? "waves" : "grains") << ", seed " << seed);
            std::mt19937 random(seed);
            TriangleMesh mesh = clean.mesh;
            add(mesh, 0.01, random);
            const std::vector<PartRegion> regions = find_parts(mesh);
            EXPECT_EQ(regions.size(), parts);
            std::size_t good = 0;
            for (const PartRegion& region : regions) {
                std::map<int, std::size_t> votes;
                std::size_t most = 0;
                for (const std::int32_t t : region.region.triangles)
                    most = std::max(most, ++votes[clean.parts[static_cast<std::size_t>(t)]]);
                good += most;
            }
            EXPECT_GE(static_cast<double>(good) / static_cast<double>(mesh.triangles.size()), 0.97);
        }
}

INSTANTIATE_TEST_SUITE_P(
    Kinds, OtherShapesUnderNoise,
    testing::Values(OtherShape{"ThinBoard", {{Vec3(0, 0, 0), Vec3(1, 0.7, 0.05), 0}}},
                    OtherShape{"ThinStick", {{Vec3(0, 0, 0), Vec3(1, 0.08, 0.08), 0}}},
                    OtherShape{
                        "CubeOnCube",
                        {{Vec3(0, 0, 0), Vec3(0.6, 0.6, 0.6), 0}, {Vec3(0.15, 0.15, 0.6), Vec3(0.45, 0.45, 0.9), 1}}},
                    OtherShape{"BoardOnBoard",
                               {{Vec3(0, 0, 0), Vec3(1, 0.6, 0.1), 0}, {Vec3(0.45, 0, 0.1), Vec3(0.55, 0.6, 0.8), 1}}},
                    OtherShape{"FlushBoards",
                               {{Vec3(0, 0, 0), Vec3(1, 0.5, 0.12), 0}, {Vec3(0, 0.38, 0.12), Vec3(1, 0.5, 0.7), 1}}},
                    OtherShape{"TableWithFlushLegs",
                               {{Vec3(0, 0, 0.6), Vec3(1, 0.7, 0.7), 0},
                                {Vec3(0, 0, 0), Vec3(0.14, 0.14, 0.6), 1},
                                {Vec3(0.86, 0, 0), Vec3(1, 0.14, 0.6), 2},
                                {Vec3(0, 0.56, 0), Vec3(0.14, 0.7, 0.6), 3},
                                {Vec3(0.86, 0.56, 0), Vec3(1, 0.7, 0.6), 4}}}),
    [](const auto& shape) { return std::string(shape.param.name); });

struct TornShape {
    const char* name;
    void (*add)(TriangleMesh&, double, std::mt19937&);
    unsigned seed;
    double step;
    std::vector<shapes::Block> blocks;
};

class NoiseDoesNotTear : public testing::TestWithParam<TornShape> {};

/// Each was cut into too many parts or too few once, or into parts with the wrong corner.
TEST_P(NoiseDoesNotTear, ThePart) {
    const Labelled clean = shapes::join(GetParam().blocks, GetParam().step);
    std::mt19937 random(GetParam().seed);
    TriangleMesh mesh = clean.mesh;
    GetParam().add(mesh, 0.01, random);
    const std::vector<PartRegion> regions = find_parts(mesh);
    EXPECT_EQ(regions.size(), GetParam().blocks.size());
    std::size_t good = 0;
    for (const PartRegion& region : regions) {
        std::map<int, std::size_t> votes;
        std::size_t most = 0;
        for (const std::int32_t t : region.region.triangles)
            most = std::max(most, ++votes[clean.parts[static_cast<std::size_t>(t)]]);
        good += most;
    }
    EXPECT_GE(static_cast<double>(good) / static_cast<double>(mesh.triangles.size()), 0.97);
}

const std::vector<shapes::Block> l_of_sticks{{Vec3(0, 0, 0), Vec3(1, 0.15, 0.15), 0},
                                             {Vec3(0, 0, 0.15), Vec3(0.15, 0.15, 0.8), 1}};
const std::vector<shapes::Block> table_with_inset_legs{{Vec3(0, 0, 0.6), Vec3(1, 0.7, 0.7), 0},
                                                       {Vec3(0.05, 0.05, 0), Vec3(0.17, 0.17, 0.6), 1},
                                                       {Vec3(0.83, 0.05, 0), Vec3(0.95, 0.17, 0.6), 2},
                                                       {Vec3(0.05, 0.53, 0), Vec3(0.17, 0.65, 0.6), 3},
                                                       {Vec3(0.83, 0.53, 0), Vec3(0.95, 0.65, 0.6), 4}};

const std::vector<shapes::Block> cube_on_cube{{Vec3(0, 0, 0), Vec3(0.6, 0.6, 0.6), 0},
                                              {Vec3(0.15, 0.15, 0.6), Vec3(0.45, 0.45, 0.9), 1}};
INSTANTIATE_TEST_SUITE_P(
    Shapes, NoiseDoesNotTear,
    testing::Values(TornShape{"Stick", add_waves, 316, 0.015, {{Vec3(0, 0, 0), Vec3(1, 0.08, 0.08), 0}}},
                    TornShape{
                        "TOfSticks",
                        add_waves,
                        306,
                        0.015,
                        {{Vec3(0, 0, 0), Vec3(1, 0.15, 0.15), 0}, {Vec3(0.45, 0, 0.15), Vec3(0.6, 0.15, 0.8), 1}}},
                    TornShape{"LOfSticksInWaves", add_waves, 320, 0.015, l_of_sticks},
                    TornShape{"LOfSticksInGrains", add_grains, 320, 0.015, l_of_sticks},
                    TornShape{"CubeOnCube", add_waves, 404, 0.015, cube_on_cube},
                    TornShape{"CubeWithoutWallsOfItsOwn", add_waves, 2016, 0.015, cube_on_cube},
                    TornShape{"CubeInShortWaves", add_short_waves, 2003, 0.015, cube_on_cube},
                    TornShape{"HalfACubeInShortWaves", add_short_waves, 2009, 0.015, cube_on_cube},
                    TornShape{"LegOfATable", add_waves, 305, 0.015, table_with_inset_legs},
                    TornShape{"AnotherLegOfATable", add_waves, 320, 0.015, table_with_inset_legs},
                    TornShape{"BoardBesideACube", add_waves, 305, 0.022, cube_with_parts_blocks},
                    TornShape{"StickUnderACube", add_short_waves, 2000, 0.022, cube_with_parts_blocks}),
    [](const auto& shape) { return std::string(shape.param.name); });

TEST(NoisyMesh, IsCutTheSameOnAnyNumberOfThreads) {
    TriangleMesh mesh = cube_with_parts().mesh;
    std::mt19937 random(5);
    add_grains(mesh, 0.005, random);
    const std::vector<PartRegion> one = find_parts(mesh, {.threads = 1}), two = find_parts(mesh, {.threads = 2});
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
        EXPECT_EQ(one[k].region.triangles, two[k].region.triangles);
        EXPECT_EQ(one[k].box.lengths, two[k].box.lengths);
        EXPECT_EQ(one[k].fit, two[k].fit);
    }
}

TEST(Roughness, TellsNoiseFromShape) {
    const auto measure = [](const TriangleMesh& mesh) {
        return roughness(build_adjacency(mesh), compute_geometry(mesh));
    };
    EXPECT_LT(measure(shapes::cylinder(0.05, 1, 12, 10)), 0.1);
    const Labelled clean = cube_with_parts();
    EXPECT_LT(measure(clean.mesh), 0.1);
    std::mt19937 random(7);
    TriangleMesh rough = clean.mesh;
    add_grains(rough, 0.002, random);
    EXPECT_GT(measure(rough), 3);
}

TEST(Calm, LeavesCleanMeshesAloneAndCalmsRoughOnes) {
    TriangleMesh mesh = cube_with_parts().mesh;
    const Adjacency adjacency = build_adjacency(mesh);
    TriangleGeometry geometry = compute_geometry(mesh);
    const std::vector<Vec3> before = mesh.positions;
    const Calming untouched = calm(mesh, adjacency, geometry);
    EXPECT_EQ(untouched.grain, 0);
    EXPECT_TRUE(untouched.mesh.positions.empty());
    std::mt19937 random(8);
    add_grains(mesh, 0.005, random);
    geometry = compute_geometry(mesh);
    const double rough = roughness(adjacency, geometry);
    const Calming calming = calm(mesh, adjacency, geometry);
    EXPECT_GT(calming.grain, 0);
    EXPECT_TRUE(calming.is_blurred);
    EXPECT_LT(roughness(adjacency, geometry), 3);
    EXPECT_GT(rough, 20);
    double off = 0;  // root mean square distance from the clean surface's vertices
    for (std::size_t v = 0; v < before.size(); ++v) off += (calming.mesh.positions[v] - before[v]).squaredNorm();
    EXPECT_LT(std::sqrt(off / static_cast<double>(before.size())), 0.6 * 0.005 * compute_bounds(mesh).diagonal());
}

}  // namespace
}  // namespace partonomy
