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

TEST(Hierarchy, EqualsHermits) {
    const std::string python = PARTONOMY_SOURCE_DIR "/.venv/bin/python";
    if (!std::filesystem::exists(python)) GTEST_SKIP() << "no Python environment: run ./dev setup";
    const TemporaryFolder folder;
    const std::string answer = (folder.path() / "hermit.json").string();
    const std::string command = python +
                                " " PARTONOMY_SOURCE_DIR "/tests/owl/hermit_hierarchy.py " PARTONOMY_SOURCE_DIR
                                "/ontologies/core.ttl " +
                                furniture_path() + " > " + answer + " 2> " + answer + ".err";
    ASSERT_EQ(std::system(command.c_str()), 0) << read_file(answer + ".err");
    const json hermit = json::parse(read_file(answer));
    EXPECT_EQ(hermit.at("consistent"), true);
    EXPECT_TRUE(hermit.at("unsatisfiable").empty());

    const ProgramResult result = run_partonomy({"check", furniture_path(), "--json"}, folder.path());
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const Pairs ours = pairs_of(json::parse(result.out).at("hierarchy"));
    EXPECT_GT(ours.size(), 40U);
    EXPECT_EQ(ours, pairs_of(hermit.at("hierarchy")));
}

}  // namespace
}  // namespace partonomy
