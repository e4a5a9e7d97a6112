/* HermiT's second opinion on the class hierarchy (paper §5.1 uses it as its reasoner). */

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <set>

#include "app/run_program.h"
#include "base/files.h"

namespace partonomy {
namespace {

using nlohmann::json;
using Pairs = std::set<std::pair<std::string, std::string>>;

Pairs pairs_of(const json& hierarchy) {
    Pairs pairs;
    for (const json& pair : hierarchy) pairs.emplace(pair[0], pair[1]);
    return pairs;
}

/// HermiT's hierarchy of some files, and ours of the last one.
void expect_hermits_hierarchy(const std::vector<std::string>& files, const std::string& ours_of) {
    const std::string python = PARTONOMY_SOURCE_DIR "/.venv/bin/python";
    if (!std::filesystem::exists(python)) GTEST_SKIP() << "no Python environment: run ./dev setup";
    const TemporaryFolder folder;
    const std::string answer = (folder.path() / "hermit.json").string();
    std::string command = python + " " PARTONOMY_SOURCE_DIR "/tests/owl/hermit_hierarchy.py";
    for (const std::string& file : files) command += " " + file;
    command += " > " + answer + " 2> " + answer + ".err";
    ASSERT_EQ(std::system(command.c_str()), 0) << read_file(answer + ".err");
    const json hermit = json::parse(read_file(answer));
    EXPECT_EQ(hermit.at("consistent"), true);
    EXPECT_TRUE(hermit.at("unsatisfiable").empty());

    const ProgramResult result = run_partonomy({"check", ours_of, "--json"}, folder.path());
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Pairs ours = pairs_of(json::parse(result.out).at("hierarchy"));
    EXPECT_GT(ours.size(), 40U);
    EXPECT_EQ(ours, pairs_of(hermit.at("hierarchy")));
}

TEST(Hierarchy, EqualsHermits) {
    expect_hermits_hierarchy({PARTONOMY_SOURCE_DIR "/ontologies/core.ttl", furniture_path()}, furniture_path());
}

TEST(Hierarchy, OfThePapersFurnitureEqualsHermits) {
    const std::string path = PARTONOMY_SOURCE_DIR "/ontologies/paper-furniture.ttl";
    expect_hermits_hierarchy({PARTONOMY_SOURCE_DIR "/ontologies/core.ttl", path}, path);
}

/// HermiT's loader reads no Manchester syntax, so these go through our own export.
TEST(Hierarchy, OfEveryOtherOntologyEqualsHermits) {
    for (const char* name : {"furniture-headrest.omn", "furniture-relations.omn", "inspection.omn", "lamps.omn",
                             "street.ttl", "traffic-signs.omn"}) {
        SCOPED_TRACE(name);
        const std::string path = std::string(PARTONOMY_SOURCE_DIR "/ontologies/") + name;
        const TemporaryFolder folder;
        const std::string merged = (folder.path() / "merged.ttl").string();
        ASSERT_EQ(run_partonomy({"export", path, "--merge-imports", "-o", merged}, folder.path()).exit_code, 0);
        expect_hermits_hierarchy({merged}, path);
    }
}

}  // namespace
}  // namespace partonomy
