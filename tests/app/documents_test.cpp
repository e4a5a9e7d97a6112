/* The documents cannot rot: every command line in them is run, every file that they link to exists. */

#include <gtest/gtest.h>

#include <cstdlib>
#include <nlohmann/json.hpp>
#include <regex>
#include <sstream>

#include "app/run_program.h"
#include "base/files.h"
#include "examples/objects.h"
#include "mesh/write_off.h"

namespace partonomy {
namespace {

namespace fs = std::filesystem;
const fs::path project = PARTONOMY_SOURCE_DIR;

std::vector<fs::path> documents() {
    std::vector<fs::path> paths = {project / "README.md", project / "CONTRIBUTING.md", project / "CHANGELOG.md"};
    for (const fs::directory_entry& entry : fs::directory_iterator(project / "docs"))
        if (entry.path().extension() == ".md") paths.push_back(entry.path());
    return paths;
}

TEST(Documents, CommandsOfTheReadmeRun) {
    const TemporaryFolder folder;
    fs::create_directory_symlink(fs::path(PARTONOMY_BINARY).parent_path(), folder.path() / "build");
    fs::create_directory_symlink(project / "ontologies", folder.path() / "ontologies");
    std::istringstream readme(read_file(project / "README.md"));
    int commands = 0;
    for (std::string line; std::getline(readme, line);) {
        if (!line.starts_with("build/")) continue;
        ++commands;
        const std::string run = "cd " + folder.path().string() + " && " + line + " > log 2>&1";
        EXPECT_EQ(std::system(run.c_str()), 0) << line << "\n" << read_file(folder.path() / "log");
    }
    EXPECT_GE(commands, 5);
}

TEST(Documents, LinkedFilesExist) {
    const std::regex link(R"(\]\(([^)#:]+)[^)]*\))");
    int links = 0;
    for (const fs::path& document : documents()) {
        const std::string text = read_file(document);
        for (auto it = std::sregex_iterator(text.begin(), text.end(), link); it != std::sregex_iterator();
             ++it, ++links)
            EXPECT_TRUE(fs::exists(document.parent_path() / (*it)[1].str())) << document << " links to " << (*it)[1];
    }
    EXPECT_GE(links, 8);
}

/// The table of strategies in docs/expert-system.md says what the program counts.
TEST(Documents, TableOfStrategiesIsMeasured) {
    const std::regex row(R"(\| ([a-z0-9]+) \| (\d+) \| (\d+ / \d+) \| \d+ / \d+ \| (\d+ / \d+) \| (\d+ / \d+) \|)");
    const std::string text = read_file(project / "docs/expert-system.md");
    const TemporaryFolder folder;
    int rows = 0;
    for (auto it = std::sregex_iterator(text.begin(), text.end(), row); it != std::sregex_iterator(); ++it, ++rows) {
        const ExampleObject object = paper_object((*it)[1]);
        EXPECT_EQ(std::to_string(object.part_count), (*it)[2]);
        folder.write("mesh.off", to_off(object.mesh));
        int column = 3;
        for (const char* strategy : {"expert", "naive", "segment-then-identify"}) {
            ASSERT_EQ(run_partonomy({"annotate", "mesh.off", "--ontology", furniture_path(), "-o", "out", "-q",
                                     "--strategy", strategy, "--format", "json"},
                                    folder.path())
                          .exit_code,
                      0);
            const auto questions =
                nlohmann::json::parse(read_file(folder.path() / "out/mesh/annotation.json")).at("questions");
            EXPECT_EQ(questions.at("SF").dump() + " / " + questions.at("SI").dump(), (*it)[column++].str())
                << object.name << " " << strategy;
        }
    }
    EXPECT_EQ(rows, 5);
}

TEST(Documents, SizesOfTheTreesAreMeasured) {
    const std::string text = read_file(project / "docs/decision-tree.md");
    for (const char* criterion : {"dichotomy", "gain-per-cost"}) {
        std::smatch said;
        ASSERT_TRUE(std::regex_search(
            text, said, std::regex(std::string(criterion) + R"( tree [0-9.]+ ms \((\d+ nodes, depth \d+)\))")))
            << criterion;
        const ProgramResult tree = run_partonomy({"tree", furniture_path(), "--criterion", criterion}, project);
        EXPECT_NE((tree.out + tree.err).find(said[1].str()), std::string::npos) << criterion << ": " << tree.err;
    }
}

TEST(Documents, ReadmeShowsTheTwoCommands) {
    const std::string readme = read_file(project / "README.md");
    EXPECT_NE(readme.find("./dev demo"), std::string::npos);
    EXPECT_NE(readme.find("./dev test"), std::string::npos);
}

}  // namespace
}  // namespace partonomy
