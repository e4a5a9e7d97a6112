/* Models as they come, from the furniture of Sweet Home 3D: many shells, sheets, duplicated faces, mixed winding. A
 * sample goes through the whole program; bench/real_models.py takes all of them. */

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <filesystem>

#include "run_program.h"

namespace partonomy {
namespace {

namespace fs = std::filesystem;

TEST(RealModels, ASampleIsAnnotatedOrRefusedWithAReasonInTime) {
    if (!fs::exists("/usr/share/sweethome3d/furniture")) GTEST_SKIP() << "sweethome3d-furniture is not installed";
    const TemporaryFolder folder;
    const std::string script = std::string("python3 " PARTONOMY_SOURCE_DIR "/bench/real_models.py extract ");
    ASSERT_EQ(std::system((script + folder.path().string() + " --every 30 > /dev/null").c_str()), 0);
    int models = 0, annotated = 0;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder.path())) {
        if (entry.path().extension() != ".obj") continue;
        SCOPED_TRACE(entry.path().filename());
        ++models;
        const auto start = std::chrono::steady_clock::now();
        const ProgramResult result = run_partonomy({"annotate", entry.path().string(), "--ontology",
                                                    PARTONOMY_SOURCE_DIR "/ontologies/furniture.ttl",
                                                    "--up", "y", "--format", "json,labels", "-o", "out"},
                                                   folder.path());
        EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(10));
        EXPECT_TRUE(result.exit_code >= 0 && result.exit_code <= 2) << result.exit_code;
        EXPECT_TRUE(result.exit_code != 1 || !result.err.empty());
        annotated += fs::exists(folder.path() / "out" / entry.path().stem() / "annotation.json");
    }
    EXPECT_EQ(models, 28);
    EXPECT_GE(annotated, models - 1);
}

}  // namespace
}  // namespace partonomy
