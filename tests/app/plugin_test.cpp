/* Measures from shared libraries: a good one of a region and one of two, and each thing that may be wrong with one. */

#include <gtest/gtest.h>

#include <map>
#include <nlohmann/json.hpp>

#include "app/run_program.h"
#include "base/files.h"
#include "examples/solid.h"
#include "mesh/write_off.h"

namespace partonomy {
namespace {

namespace fs = std::filesystem;

const char* const prefixes = R"(
@prefix : <http://example.org/plugin#> .
@prefix core: <https://w3id.org/partonomy/core#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
<http://example.org/plugin> a owl:Ontology ; owl:imports <https://w3id.org/partonomy/core> .
)";

/// Two values of a feature that the plugin measures, and an object that has a part of the first.
const std::string balance = std::string(prefixes) + R"(
:Balance a owl:Class ; rdfs:subClassOf core:Feature ; owl:disjointUnionOf ( :TopHeavy :Firm ) .
:hasBalance a owl:ObjectProperty , owl:FunctionalProperty ; rdfs:domain core:Region ; rdfs:range :Balance .
:TopHeavy a owl:Class ; core:measure "top heaviness" ; core:membership "0.55 0.65 inf inf" .
:Firm a owl:Class ; core:measure "top heaviness" ; core:membership "-inf -inf 0.55 0.65" .
:Spike a owl:Class ; owl:equivalentClass [ owl:intersectionOf ( core:Region
    [ a owl:Restriction ; owl:onProperty :hasBalance ; owl:someValuesFrom :TopHeavy ] ) ] .
:Block a owl:Class ; owl:equivalentClass [ owl:intersectionOf ( core:Region
    [ a owl:Restriction ; owl:onProperty :hasBalance ; owl:someValuesFrom :Firm ] ) ] .
:Thorn a owl:Class ; owl:equivalentClass [ owl:intersectionOf ( core:Object
    [ a owl:Restriction ; owl:onProperty core:hasPart ; owl:someValuesFrom :Spike ] ) ] .
:Lump a owl:Class ; owl:equivalentClass [ owl:intersectionOf ( core:Object
    [ a owl:Restriction ; owl:onProperty core:hasPart ; owl:someValuesFrom :Block ] ) ] .
)";

const std::string longer = std::string(prefixes) + R"(
:LongerThan a owl:Class ; rdfs:subClassOf core:Relation ; core:measure "relative length" ; core:membership "1.1 1.3 inf inf" .
:Long a owl:Class ; owl:equivalentClass [ owl:intersectionOf ( core:Region
    [ a owl:Restriction ; owl:onProperty core:isTargetRegion ; owl:someValuesFrom :LongerThan ] ) ] .
:Pair a owl:Class ; owl:equivalentClass [ owl:intersectionOf ( core:Object
    [ a owl:Restriction ; owl:onProperty core:hasPart ; owl:someValuesFrom :Long ] ) ] .
)";

/// A prism whose lid is larger than its base, or smaller.
TriangleMesh frustum(double base, double lid) {
    Solid solid;
    solid.begin_part("Frustum");
    const auto square = [&](double half, double z) {
        return std::vector{solid.at(-half, -half, z), solid.at(half, -half, z), solid.at(half, half, z),
                           solid.at(-half, half, z)};
    };
    // In eight layers, so that triangles lie in one half or the other.
    std::vector<Solid::Vertex> below = square(base, 0);
    solid.face(below, true);
    for (int layer = 1; layer <= 8; ++layer) {
        const std::vector<Solid::Vertex> above = square(base + (lid - base) * layer / 8, layer / 8.0);
        for (std::size_t i = 0; i < 4; ++i) solid.face({below[i], below[(i + 1) % 4], above[(i + 1) % 4], above[i]});
        below = above;
    }
    solid.face(below);
    return std::move(solid).finish("frustum", "").mesh;
}

std::string plugin(const std::string& fault) { return std::string(PARTONOMY_PLUGINS) + "/plugin_" + fault + ".so"; }

ProgramResult annotate(const TemporaryFolder& folder, const std::string& ontology, const std::string& plugin_file) {
    folder.write("o.ttl", ontology);
    return run_partonomy({"annotate", "mesh.off", "--ontology", "o.ttl", "-o", "out", "--format", "json,labels",
                          "--plugin", plugin_file},
                         folder.path());
}

TEST(Plugins, OneOfARegionDecidesANameLikeAnyMeasure) {
    for (const bool is_spike : {true, false}) {
        const TemporaryFolder folder;
        folder.write("mesh.off", to_off(is_spike ? frustum(0.15, 0.5) : frustum(0.5, 0.15)));
        const ProgramResult result = annotate(folder, balance, PARTONOMY_EXAMPLE_PLUGIN);
        EXPECT_EQ(result.exit_code, 0) << result.err;
        EXPECT_EQ(result.err.find("stays open"), std::string::npos) << result.err;
        const auto json = nlohmann::json::parse(read_file(folder.path() / "out/mesh/annotation.json"));
        EXPECT_EQ(json.at("object").at("classes"), nlohmann::json::array({is_spike ? "Thorn" : "Lump"}));
        EXPECT_GT(json.at("questions").at("SI"), 0);
    }
}

TEST(Plugins, OneBetweenRegions) {
    const TemporaryFolder folder;
    Solid solid;
    for (const double x : {0.0, 2.0}) {
        solid.begin_part("Stick");
        const double length = x > 0 ? 1.0 : 1.8;
        std::vector<Solid::Vertex> base{solid.at(x, 0, 0), solid.at(x + 0.2, 0, 0), solid.at(x + 0.2, 0.2, 0),
                                        solid.at(x, 0.2, 0)};
        solid.prism(base, length);
        solid.face(base, true);
    }
    folder.write("mesh.off", to_off(std::move(solid).finish("sticks", "").mesh));
    const ProgramResult result = annotate(folder, longer, plugin("pair"));
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const auto json = nlohmann::json::parse(read_file(folder.path() / "out/mesh/annotation.json"));
    EXPECT_EQ(json.at("object").at("classes"), nlohmann::json::array({"Pair"}));
    int longs = 0;
    for (const auto& part : json.at("parts")) longs += part.at("concepts") == nlohmann::json::array({"Long"});
    EXPECT_EQ(longs, 1);
}

TEST(Plugins, AreListedCheckedAndPlannedWith) {
    const TemporaryFolder folder;
    folder.write("o.ttl", balance);
    const ProgramResult listed =
        run_partonomy({"catalogue", "o.ttl", "--plugin", PARTONOMY_EXAMPLE_PLUGIN}, folder.path());
    EXPECT_EQ(listed.exit_code, 0) << listed.err;
    EXPECT_NE(listed.out.find("share of the surface in the upper half"), std::string::npos);
    EXPECT_NE(listed.out.find("TopHeavy"), std::string::npos);
    for (const char* command : {"tree", "check"}) {
        const ProgramResult with =
            run_partonomy({command, "o.ttl", "--plugin", PARTONOMY_EXAMPLE_PLUGIN}, folder.path());
        EXPECT_EQ(with.exit_code, 0) << command << with.err;
    }
    const ProgramResult without = run_partonomy({"tree", "o.ttl"}, folder.path());
    EXPECT_EQ(without.exit_code, 1);
    EXPECT_NE(without.err.find("top heaviness"), std::string::npos) << without.err;
}

/// What it says of one region stays open, and everything else is still written.
TEST(Plugins, FaultsWhileMeasuringCostOnlyTheirAnswers) {
    const std::map<std::string, std::string> faults{{"throws", "threw an exception: no luck today"},
                                                    {"nan", "returned nan, which is no number"},
                                                    {"infinite", "returned inf, which is no number"}};
    for (const auto& [fault, words] : faults) {
        SCOPED_TRACE(fault);
        const TemporaryFolder folder;
        folder.write("mesh.off", to_off(frustum(0.15, 0.5)));
        const ProgramResult result = annotate(folder, balance, plugin(fault));
        EXPECT_NE(result.exit_code, 1) << result.err;
        EXPECT_NE(result.err.find("plugin_" + fault + ".so: \"top heaviness\" " + words), std::string::npos)
            << result.err;
        const auto json = nlohmann::json::parse(read_file(folder.path() / "out/mesh/annotation.json"));
        EXPECT_EQ(json.at("parts").size(), 1U);
        EXPECT_FALSE(json.at("open_questions").empty());
        EXPECT_TRUE(fs::exists(folder.path() / "out/mesh/labels.txt"));
    }
}

TEST(Plugins, UnusableOnesAreRefusedWithOneSentence) {
    const std::map<std::string, std::string> faults{
        {"other_version", "made for version 99 of the plugin interface and this program has version 1"},
        {"no_name", "should have a name, a unit and a description"},
        {"four_regions", "measures 4 regions; it should be 1, 2 or 3"},
        {"no_measure", "has no function that measures"},
        {"nothing", "returns no algorithm"},
        {"taken", "there is a measure \"inclination\" already"},
        {"no_entry", "exports no function partonomy_algorithm"},
        {"entry_throws", "its function partonomy_algorithm throws"}};
    const TemporaryFolder folder;
    folder.write("o.ttl", balance);
    folder.write("text.so", "no library at all\n");
    const auto expect = [&](const std::string& file, const std::string& words) {
        const ProgramResult result = run_partonomy({"catalogue", "o.ttl", "--plugin", file}, folder.path());
        EXPECT_EQ(result.exit_code, 1) << file;
        EXPECT_NE(result.err.find(words), std::string::npos) << result.err;
        EXPECT_EQ(std::ranges::count(result.err, '\n'), 1) << result.err;
    };
    for (const auto& [fault, words] : faults) expect(plugin(fault), words);
    expect("text.so", "text.so: cannot be loaded as a plugin");
    expect("missing.so", "missing.so: there is no such plugin");
}

/// The document shows the file that these tests ran, and the whole interface.
TEST(Plugins, TheDocumentShowsWhatIsTested) {
    const std::string text = read_file(fs::path(PARTONOMY_SOURCE_DIR) / "docs/plugins.md");
    std::string example = read_file(fs::path(PARTONOMY_SOURCE_DIR) / "examples/plugin/top_heaviness.cpp");
    EXPECT_NE(text.find(example), std::string::npos) << "put the example into docs/plugins.md again";
}

}  // namespace
}  // namespace partonomy
