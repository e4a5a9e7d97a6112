#include <gtest/gtest.h>

#include <filesystem>

#include "mesh/read_mesh.h"

namespace partonomy {
namespace {

const std::filesystem::path data = PARTONOMY_SHARED_DATA;

TEST(SharedData, BenchmarkMeshesAreClosed) {
    if (!std::filesystem::exists(data / "lpsb"))
        GTEST_SKIP() << "test data beside the project is absent: " << data / "lpsb";
    int count = 0;
    for (const char* folder : {"chair", "table"})
        for (const auto& entry : std::filesystem::directory_iterator(data / "lpsb" / folder)) {
            if (entry.path().extension() != ".off") continue;
            SCOPED_TRACE(entry.path().filename());
            ++count;
            const LoadedMesh loaded = read_mesh(entry.path());
            EXPECT_EQ(validate(loaded.mesh), "");
            EXPECT_EQ(loaded.report.boundary_edges, 0);
            EXPECT_EQ(loaded.report.shells, 1);
            EXPECT_EQ(loaded.sha256.size(), 64U);
            EXPECT_GT(compute_topology(loaded.mesh).volume, 0);
        }
    EXPECT_EQ(count, 20);
}

TEST(SharedData, Fig16IsOneClosedSurface) {
    if (!std::filesystem::exists(data / "fig16"))
        GTEST_SKIP() << "test data beside the project is absent: " << data / "fig16";
    for (const char* name : {"fig16_75k.ply", "fig16_75k_n05.ply", "fig16_75k_n10.ply"}) {
        const LoadedMesh loaded = read_mesh(data / "fig16" / name);
        EXPECT_EQ(loaded.mesh.triangles.size(), 75520U);
        EXPECT_EQ(loaded.mesh.positions.size(), 37762U);
        EXPECT_TRUE(loaded.report.sentences().empty());
        EXPECT_EQ(compute_topology(loaded.mesh).euler, 2);
    }
}

}  // namespace
}  // namespace partonomy
