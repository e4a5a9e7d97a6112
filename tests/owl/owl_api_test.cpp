// Second opinions. The OWL API, with which Protégé saves, converts our ontologies, and we read what it wrote; it reads
// what we wrote, and finds the same axioms. Konclude classifies what we wrote. Both are skipped where they are not
// installed.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "base/files.h"
#include "owl/canonical.h"
#include "owl/random_ontology.h"
#include "owl/zoo.h"

namespace partonomy::owl {
namespace {

namespace fs = std::filesystem;

class OwlApi : public testing::Test {
protected:
    void SetUp() override {
        const fs::path packages = PARTONOMY_SOURCE_DIR "/.venv/lib";
        std::error_code error;
        for (fs::directory_iterator i(packages, error), end; !error && i != end; i.increment(error)) {
            const fs::path jar = i->path() / "site-packages/owlready2/hermit/HermiT.jar";
            if (fs::exists(jar))
                java = "java -Xmx1g -cp " + jar.string() + " " PARTONOMY_SOURCE_DIR "/tests/owl/OwlApi.java ";
        }
        if (java.empty()) GTEST_SKIP() << "no owlready2, which brings the OWL API: run ./dev setup";
        if (std::system("command -v javac > /dev/null 2>&1") != 0) GTEST_SKIP() << "no Java compiler";
        folder = fs::path(testing::TempDir()) /
                 (std::string("partonomy_owl_api_") + testing::UnitTest::GetInstance()->current_test_info()->name());
        fs::remove_all(folder);
        fs::create_directories(folder);
    }
    void TearDown() override {
        if (!folder.empty()) fs::remove_all(folder);
    }

    [[nodiscard]] std::string path(const std::string& name) const { return (folder / name).string(); }

    /// What the program prints.
    [[nodiscard]] std::string run(const std::string& arguments) const {
        const std::string command = java + arguments + " > " + path("out") + " 2> " + path("err");
        EXPECT_EQ(std::system(command.c_str()), 0) << read_file(path("err"));
        return read_file(path("out"));
    }

    std::string java;
    fs::path folder;
};

/// Manchester syntax as the OWL API 3 writes it has no general class axioms, no annotations of rules, and no disjoint
/// unions; they stand in our own zoo.omn.
std::set<std::string> without(const std::set<std::string>& axioms, const std::vector<std::string>& beginnings) {
    std::set<std::string> kept;
    for (const std::string& axiom : axioms) {
        if (std::ranges::none_of(beginnings, [&](const std::string& begin) { return axiom.starts_with(begin); }))
            kept.insert(axiom);
    }
    return kept;
}

TEST_F(OwlApi, WeReadWhatItConverts) {
    write_file(path("zoo.ttl"), zoo::text("ttl"));
    const Ontology furniture = load_ontology(PARTONOMY_SOURCE_DIR "/ontologies/furniture.ttl");
    write_file(path("furniture.ttl"), write_turtle(furniture, {.merge_imports = true}));
    const std::vector<std::string> lost = {"Rule ", "DisjointUnion(", "SubClassOf(ObjectSomeValuesFrom(",
                                           "SubClassOf(ObjectUnionOf("};
    for (const std::string name : {"zoo", "furniture"}) {
        const std::set<std::string> expected = axioms_of(load_ontology(path(name + ".ttl")));
        (void)run("convert " + path(name + ".ttl") + " " + path("converted"));
        for (const std::string type : {"ttl", "rdf", "owx", "ofn", "omn"}) {
            const std::set<std::string> found =
                axioms_of(parse_ontology(read_file(path("converted." + type)), "converted." + type));
            const bool is_lossy = type == "omn";
            EXPECT_EQ(
                differences(is_lossy ? without(expected, lost) : expected, is_lossy ? without(found, lost) : found), "")
                << name << " " << type;
        }
    }
}

TEST_F(OwlApi, ItReadsWhatWeWrite) {
    write_file(path("zoo.ttl"), zoo::text("ttl"));
    const Ontology zoo = load_ontology(path("zoo.ttl"));
    write_file(path("out.ttl"), write_turtle(zoo));
    write_file(path("out.ofn"), write_functional(zoo));
    std::string pairs = path("zoo.ttl") + " " + path("out.ttl") + " " + path("zoo.ttl") + " " + path("out.ofn");
    std::string expected = "same\nsame\n";
    for (unsigned seed = 1000; seed < 1020; ++seed) {
        const Ontology made = RandomOntology(seed, true).make(70);
        const std::string stem = path("seed" + std::to_string(seed));
        write_file(stem + ".ttl", write_turtle(made));
        write_file(stem + ".ofn", write_functional(made));
        pairs += " " + stem + ".ofn " + stem + ".ttl";
        expected += "same\n";
    }
    EXPECT_EQ(run("compare " + pairs), expected);
}

}  // namespace
}  // namespace partonomy::owl
