// The same bytes on any number of threads: on clean and noisy meshes large enough for work to be shared, on solids that
// reach into each other, on a comb whose teeth are parted from their rail, and on organic chairs and tables.

#include <gtest/gtest.h>

#include <atomic>
#include <filesystem>
#include <random>
#include <thread>

#include "base/ranges.h"
#include "mesh/parallel.h"
#include "mesh/read_mesh.h"
#include "shape/find_parts.h"
#include "shape/pieces.h"
#include "shape/ray_tree.h"
#include "shape/shapes.h"

namespace partonomy {
namespace {

/// Embree's first device sets for how many threads the whole process is good, and most tests ask for one.
class SeveralThreads : public testing::Environment {
    void SetUp() override { const RayTree first(shapes::cylinder(1, 1, 6, 1), 2); }
};
const auto* const several_threads = testing::AddGlobalTestEnvironment(new SeveralThreads);

void expect_the_same_on_any_number_of_threads(const TriangleMesh& mesh) {
    const std::vector<PartRegion> one = find_parts(mesh, {.threads = 1});
    for (const int threads : {2, 3, 0}) {
        SCOPED_TRACE(testing::Message() << threads << " threads");
        const std::vector<PartRegion> more = find_parts(mesh, {.threads = threads});
        ASSERT_EQ(more.size(), one.size());
        for (std::size_t k = 0; k < one.size(); ++k) {
            EXPECT_EQ(more[k].region.triangles, one[k].region.triangles);
            EXPECT_EQ(more[k].region.memberships, one[k].region.memberships);
            EXPECT_EQ(more[k].box.centre, one[k].box.centre);
            EXPECT_EQ(more[k].box.axes, one[k].box.axes);
            EXPECT_EQ(more[k].box.lengths, one[k].box.lengths);
            EXPECT_EQ(more[k].fit, one[k].fit);
        }
    }
}

TriangleMesh cube_with_parts() {
    return shapes::join({{Vec3(0, 0, 0), Vec3(1, 1, 1), 0},
                         {Vec3(0.1, 0.7, 1), Vec3(0.9, 0.9, 1.7), 1},
                         {Vec3(1, 0.1, 0.5), Vec3(1.5, 0.9, 0.64), 2},
                         {Vec3(0.1, 0.1, -0.8), Vec3(0.4, 0.4, 0), 3}},
                        0.022)
        .mesh;
}

/// Each vertex moves by itself.
void add_grains(TriangleMesh& mesh, double level) {
    std::mt19937 random(11);
    std::normal_distribution<double> shift(0, level * compute_bounds(mesh).diagonal());
    for (Vec3& p : mesh.positions) p += Vec3(shift(random), shift(random), shift(random));
}

/// The surface swings in waves, so that joints are torn open and free pieces are large.
void add_waves(TriangleMesh& mesh, double level) {
    const double size = compute_bounds(mesh).diagonal();
    for (Vec3& p : mesh.positions) {
        const Vec3 q = p / size;
        p += level * size *
             Vec3(std::sin(31 * q.y() + 17 * q.z()), std::sin(23 * q.z() + 41 * q.x()),
                  std::sin(37 * q.x() + 29 * q.y()));
    }
}

TEST(Threads, ShareWork) {
    if (std::thread::hardware_concurrency() < 2) GTEST_SKIP() << "there is but one core";
    std::atomic<int> pieces = 0;
    for_each_range(100'000, 2, [&](std::size_t, std::size_t) { ++pieces; });
    EXPECT_GT(pieces, 1);
}

TEST(Threads, CleanMeshIsCutTheSame) { expect_the_same_on_any_number_of_threads(cube_with_parts()); }

TEST(Threads, NoisyMeshesAreCutTheSame) {
    for (const double level : {0.002, 0.01}) {
        SCOPED_TRACE(level);
        TriangleMesh grains = cube_with_parts(), waves = grains;
        add_grains(grains, level);
        expect_the_same_on_any_number_of_threads(grains);
        add_waves(waves, level);
        expect_the_same_on_any_number_of_threads(waves);
        add_grains(waves, level / 4);
        expect_the_same_on_any_number_of_threads(waves);
    }
}

TEST(Threads, SolidsThatReachIntoEachOtherAreCutTheSame) {
    TriangleMesh all;
    for (const double step : {10.0, 0.02}) {  // twelve triangles a box, and many
        SCOPED_TRACE(step);
        all = {};
        for (const auto& [low, high] : {std::pair(Vec3(0, 0, 0.4), Vec3(1, 1, 0.5)),
                                        {Vec3(0, 0, 0), Vec3(0.1, 0.1, 0.45)},
                                        {Vec3(0.9, 0, 0), Vec3(1, 0.1, 0.45)},
                                        {Vec3(0, 0.9, 0), Vec3(0.1, 1, 1.2)},
                                        {Vec3(0.9, 0.9, 0), Vec3(1, 1, 1.2)},
                                        {Vec3(0.05, 0.92, 0.8), Vec3(0.95, 0.98, 1.1)}}) {
            const TriangleMesh box = shapes::join({{low, high, 0}}, step).mesh;
            const auto first = static_cast<std::int32_t>(all.positions.size());
            all.positions.insert(all.positions.end(), box.positions.begin(), box.positions.end());
            for (const auto& [a, b, c] : box.triangles) {
                all.input_faces.push_back(all.input_face_count++);
                all.triangles.push_back({a + first, b + first, c + first});
            }
        }
        expect_the_same_on_any_number_of_threads(all);
    }
}

TEST(Threads, CombIsCutTheSame) {
    std::vector<shapes::Block> blocks{{Vec3(0, 0, 0), Vec3(2, 0.05, 0.4), 0}};
    for (int k = 0; k < 6; ++k)
        blocks.push_back({Vec3(0.1 + 0.35 * k, 0, 0.4), Vec3(0.2 + 0.35 * k, 0.05, 1.4), k + 1});
    TriangleMesh comb = shapes::join(blocks, 0.012).mesh;
    expect_the_same_on_any_number_of_threads(comb);
    add_grains(comb, 0.001);
    expect_the_same_on_any_number_of_threads(comb);
}

TEST(Threads, OrganicMeshesAreCutTheSame) {
    const std::filesystem::path folder = std::filesystem::path(PARTONOMY_SHARED_DATA) / "lpsb";
    if (!std::filesystem::exists(folder)) GTEST_SKIP() << "the shared test data is not there: " << folder;
    int count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().extension() != ".off" || ++count % 5 != 0) continue;
        SCOPED_TRACE(entry.path());
        expect_the_same_on_any_number_of_threads(read_mesh(entry.path()).mesh);
    }
    EXPECT_GT(count, 10);
}

TEST(Pieces, AreThoseThatAWalkFinds) {
    TriangleMesh mesh = cube_with_parts();
    const Adjacency adjacency = build_adjacency(mesh);
    const auto seed = std::random_device{}();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    std::vector<int> color(mesh.triangles.size());
    for (int& c : color) c = static_cast<int>(random() % 3) - 1;  // -1: in no piece
    const auto alike = [&](std::int32_t i, std::int32_t j) { return color[i] >= 0 && color[i] == color[j]; };
    std::vector<std::int32_t> expected(color.size(), -1), lowest;
    for (std::size_t start = 0; start < color.size(); ++start) {
        if (color[start] < 0 || expected[start] >= 0) continue;
        std::vector<std::int32_t> queue{static_cast<std::int32_t>(start)};
        expected[start] = static_cast<std::int32_t>(lowest.size());
        for (std::size_t at = 0; at < queue.size(); ++at)
            for (const std::int32_t j : adjacency.neighbours[queue[at]])
                if (j >= 0 && expected[j] < 0 && alike(queue[at], j)) {
                    expected[j] = expected[start];
                    queue.push_back(j);
                }
        lowest.push_back(static_cast<std::int32_t>(start));
    }
    for (const int threads : {1, 2, 3, 0}) {
        const Pieces pieces = find_pieces(adjacency, threads, alike);
        EXPECT_EQ(pieces.piece_of, expected);
        EXPECT_EQ(pieces.lowest, lowest);
        const Groups groups = group_members(pieces.piece_of, pieces.size(), threads);
        ASSERT_EQ(groups.size(), lowest.size());
        std::size_t members = 0;
        for (std::size_t k = 0; k < groups.size(); ++k) {
            const auto group = groups[k];
            ASSERT_FALSE(group.empty());
            EXPECT_EQ(group.front(), lowest[k]);
            EXPECT_TRUE(std::ranges::is_sorted(group));
            for (const std::int32_t i : group) EXPECT_EQ(expected[i], static_cast<std::int32_t>(k));
            members += group.size();
        }
        EXPECT_EQ(members, static_cast<std::size_t>(std::ranges::count_if(expected, [](auto p) { return p >= 0; })));
    }
}

TEST(Adjacency, IsTheSameOnAnyNumberOfThreads) {
    TriangleMesh mesh = cube_with_parts();
    for (std::size_t t = 0; t < 2000; ++t) {  // edges with more than two triangles
        mesh.triangles.push_back(mesh.triangles[7 * t]);
        mesh.input_faces.push_back(mesh.input_face_count++);
    }
    const Adjacency one = build_adjacency(mesh, 1);
    for (const int threads : {2, 3, 0}) EXPECT_EQ(build_adjacency(mesh, threads).neighbours, one.neighbours);
}

}  // namespace
}  // namespace partonomy
