#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "app/run_program.h"
#include "base/files.h"
#include "examples/lamps.h"
#include "examples/objects.h"
#include "knowledge/closed_world.h"
#include "mesh/write_off.h"

namespace partonomy {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

TEST(Export, ClosesTheWorldOfAnAnnotatedMesh) {
    const TemporaryFolder folder;
    folder.write("chair.off", to_off(paper_object("chair").mesh));
    ASSERT_EQ(
        run_partonomy({"annotate", "chair.off", "--ontology", furniture_path(), "-o", "out"}, folder.path()).exit_code,
        0);
    ProgramResult result = run_partonomy({"export", "--closed", "out/chair", "-o", "mesh.ofn"}, folder.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const knowledge::ClosedWorld world{owl::load_ontology(folder.path() / "mesh.ofn"), {}};
    const std::vector<owl::Iri> types =
        knowledge::ClosedReasoner(world).types("https://w3id.org/partonomy/mesh#object");
    EXPECT_TRUE(std::ranges::count(types, "https://w3id.org/partonomy/furniture#Chair")) << types.size();
    result = run_partonomy({"export", "out/chair"}, folder.path());
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.err.find("--closed"), std::string::npos);
}

TEST(Export, ChangesTheSyntaxAndNothingElse) {
    const TemporaryFolder folder;
    const auto hierarchy = [&](const std::string& path) {
        const ProgramResult result = run_partonomy({"check", path, "--json"}, folder.path());
        EXPECT_EQ(result.exit_code, 0) << result.err;
        return json::parse(result.out).at("hierarchy");
    };
    const json expected = hierarchy(furniture_path());
    for (const std::string name : {"out.ttl", "out.ofn"}) {
        const ProgramResult result = run_partonomy({"export", furniture_path(), "-o", name}, folder.path());
        ASSERT_EQ(result.exit_code, 0) << result.err;
        EXPECT_NE(read_file(folder.path() / name).find("w3id.org/partonomy/core>"), std::string::npos)
            << "the import is kept";
        EXPECT_EQ(hierarchy(name), expected);
        ASSERT_EQ(run_partonomy({"export", name, "--merge-imports", "--format", "functional", "-o", "merged.owl"},
                                folder.path())
                      .exit_code,
                  0);
        EXPECT_EQ(read_file(folder.path() / "merged.owl").find("Import("), std::string::npos);
        EXPECT_EQ(hierarchy("merged.owl"), expected);
    }
    EXPECT_EQ(run_partonomy({"export", furniture_path()}, folder.path()).out, read_file(folder.path() / "out.ttl"));
    const ProgramResult unclear = run_partonomy({"export", furniture_path(), "-o", "out.owl"}, folder.path());
    EXPECT_EQ(unclear.exit_code, 1);
    EXPECT_NE(unclear.err.find("cannot tell the format"), std::string::npos) << unclear.err;
}

TEST(Export, ClosesTheWorldOfNamedIndividuals) {
    const TemporaryFolder folder;
    write_file(folder.path() / "in.ofn",
               "Prefix(:=<http://a.b/c#>) Ontology(<http://a.b/c> Declaration(Class(:Leg))\n"
               "ClassAssertion(:Leg :left) ClassAssertion(:Leg :right))");
    ASSERT_EQ(run_partonomy({"export", "in.ofn", "--closed", "-o", "out.ofn"}, folder.path()).exit_code, 0);
    const std::string text = read_file(folder.path() / "out.ofn");
    EXPECT_NE(text.find("EquivalentClasses(owl:Thing ObjectOneOf("), std::string::npos) << text;
    EXPECT_NE(text.find("DifferentIndividuals("), std::string::npos) << text;
    const ProgramResult nobody = run_partonomy({"export", furniture_path(), "--closed"}, folder.path());
    EXPECT_EQ(nobody.exit_code, 1);
    EXPECT_NE(nobody.err.find("names no individual"), std::string::npos) << nobody.err;
    EXPECT_TRUE(nobody.out.empty());
}

TEST(Tree, JsonAndDot) {
    const TemporaryFolder folder;
    for (const char* criterion : {"dichotomy", "gain-per-cost"}) {
        ASSERT_EQ(run_partonomy({"tree", furniture_path(), "-o", "tree.json", "--criterion", criterion}, folder.path())
                      .exit_code,
                  0);
        const json tree = json::parse(read_file(folder.path() / "tree.json"));
        EXPECT_FALSE(tree.at("nodes").empty());
    }
    ASSERT_EQ(run_partonomy({"tree", furniture_path(), "-o", "tree.dot"}, folder.path()).exit_code, 0);
    EXPECT_TRUE(read_file(folder.path() / "tree.dot").starts_with("digraph"));
}

TEST(Catalogue, ListsAlgorithmsAndMeasures) {
    const TemporaryFolder folder;
    const ProgramResult result = run_partonomy({"catalogue", furniture_path()}, folder.path());
    EXPECT_EQ(result.exit_code, 0);
    for (const char* text : {"SF", "SI", "Board", "M43", "inclination", "needs a unit"})
        EXPECT_NE(result.out.find(text), std::string::npos) << text;
}

/// Without an ontology: all that the built-in core has.
TEST(Catalogue, OfTheBuiltInCoreAndAsJson) {
    const TemporaryFolder folder;
    const ProgramResult text = run_partonomy({"catalogue"}, folder.path());
    EXPECT_EQ(text.exit_code, 0) << text.err;
    const ProgramResult result = run_partonomy({"catalogue", "--json"}, folder.path());
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const auto listed = nlohmann::json::parse(result.out);
    std::map<std::string, std::set<std::string>> concepts;  // by signature
    for (const auto& algorithm : listed.at("algorithms")) {
        const std::string name = algorithm.at("concept");
        concepts[algorithm.at("signature")].insert(name);
        EXPECT_GT(algorithm.at("cost"), 0) << name;
        EXPECT_FALSE(algorithm.at("method").get<std::string>().empty()) << name;
        EXPECT_TRUE(algorithm.at("origin") == "own" || algorithm.at("origin") == "derived") << name;
        EXPECT_TRUE(algorithm.at("needs_unit").is_boolean()) << name;
        EXPECT_NE(text.out.find(name), std::string::npos) << name;
    }
    for (const char* name : {"Board", "Vertical", "M43"}) EXPECT_TRUE(concepts["SI"].contains(name)) << name;
    for (const char* name : {"UpFrom", "Between", "SameSize"}) EXPECT_TRUE(concepts["T"].contains(name)) << name;
    EXPECT_EQ(concepts["T"], concepts["TF"]);
    EXPECT_TRUE(concepts["SF"].contains("Board"));
    EXPECT_GE(listed.at("relation_measures").size(), 20U);
    EXPECT_GE(listed.at("measures").size(), 16U);
}

TEST(Explain, OnePartOrAll) {
    const TemporaryFolder folder;
    folder.write("bench.off", to_off(paper_objects().front().mesh));
    ASSERT_EQ(
        run_partonomy({"annotate", "bench.off", "--ontology", furniture_path(), "-o", "out"}, folder.path()).exit_code,
        0);
    const ProgramResult all = run_partonomy({"explain", "out/bench"}, folder.path());
    EXPECT_EQ(all.exit_code, 0) << all.err;
    const ProgramResult one = run_partonomy({"explain", "out/bench", "--part", "1"}, folder.path());
    EXPECT_EQ(one.exit_code, 0);
    EXPECT_NE(one.out.find("part 1 is a"), std::string::npos);
    EXPECT_EQ(one.out.find("part 2 is a"), std::string::npos);
    EXPECT_EQ(run_partonomy({"explain", "out/bench", "--part", "9"}, folder.path()).exit_code, 1);
    EXPECT_EQ(run_partonomy({"explain", "out/bench/annotation.json"}, folder.path()).out, all.out);
    const ProgramResult other = run_partonomy({"explain", "bench.off"}, folder.path());
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_NE(other.err.find("bench.off: is not an annotation"), std::string::npos) << other.err;
}

TEST(Explain, EveryMinimalExplanation) {
    const TemporaryFolder folder;
    folder.write("strange.off", to_off(paper_objects().back().mesh));
    ASSERT_EQ(run_partonomy({"annotate", "strange.off", "--ontology", furniture_path(), "-o", "out"}, folder.path())
                  .exit_code,
              2);
    const ProgramResult one = run_partonomy({"explain", "out/strange"}, folder.path());
    EXPECT_EQ(one.exit_code, 2) << one.err;
    EXPECT_NE(one.out.find("what would repair it"), std::string::npos) << one.out;
    EXPECT_EQ(one.out.find("explanation 1 of"), std::string::npos);
    const ProgramResult all = run_partonomy({"explain", "out/strange", "--all"}, folder.path());
    EXPECT_EQ(all.exit_code, 2) << all.err;
    EXPECT_NE(all.out.find("FootIncompatibleFurnitures: explanation 2 of"), std::string::npos) << all.out;
    EXPECT_NE(all.out.find("furniture.ttl:"), std::string::npos);
    folder.write("other.ttl", read_file(furniture_path()) + "# changed\n");
    const ProgramResult other = run_partonomy({"explain", "out/strange", "--all", "-O", "other.ttl"}, folder.path());
    EXPECT_EQ(other.exit_code, 1);
    EXPECT_NE(other.err.find("annotate again"), std::string::npos) << other.err;
}

TEST(Explain, SaysFirstWhatThereIsTooMuchOf) {
    const TemporaryFolder folder;
    folder.write("twin.off", to_off(lamps().back().mesh));
    std::string text = read_file(std::filesystem::path(PARTONOMY_SOURCE_DIR) / "ontologies/lamps.omn");
    text +=
        "\nClass: :TwoStems\n    Annotations: rdfs:comment \"One hand only: saw one off.\"\n    SubClassOf: "
        "core:Incompatible\n    EquivalentTo: :TwinLamp and (core:hasPart min 2 :Stem)\n";
    folder.write("lamps.omn", text);
    ASSERT_EQ(run_partonomy({"annotate", "twin.off", "--ontology", "lamps.omn", "-o", "out"}, folder.path()).exit_code,
              2);
    const ProgramResult result = run_partonomy({"explain", "out/twin"}, folder.path());
    EXPECT_EQ(result.exit_code, 2);
    EXPECT_NE(result.out.find("\n  1 too many: 2 Stem (parts "), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("\n  it is defined as TwinLamp and (hasPart min 2 Stem) (lamps.omn:"), std::string::npos);
    EXPECT_LT(result.out.find("too many"), result.out.find("answers that lead to it"));
    EXPECT_LT(result.out.find("impossible: TwoStems"), result.out.find("\npart 1 is")) << "first what is wrong";
    EXPECT_NE(result.out.find("\n  One hand only: saw one off.\n"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find(" is an Arm "), std::string::npos) << result.out;
}

TEST(Explain, SaysFirstWhatIsMissing) {
    const TemporaryFolder folder;
    folder.write("twin.off", to_off(lamps().back().mesh));
    const std::string lamp = read_file(std::filesystem::path(PARTONOMY_SOURCE_DIR) / "ontologies/lamps.omn");
    const auto why = [&](const std::string& rule) {
        folder.write("lamps.omn", lamp +
                                      "\nClass: :Bulb\n    EquivalentTo: :Pole and (core:hasShape some core:Cube)\n" +
                                      "\nClass: :Wrong\n    SubClassOf: core:Incompatible\n    EquivalentTo: "
                                      ":TwinLamp and " +
                                      rule + "\n");
        EXPECT_EQ(run_partonomy({"annotate", "twin.off", "-O", "lamps.omn", "-o", "out"}, folder.path()).exit_code, 2);
        return run_partonomy({"explain", "out/twin"}, folder.path()).out;
    };
    for (const char* none : {"(core:hasPart max 0 :Bulb)", "(not (core:hasPart some :Bulb))"})
        EXPECT_NE(why(none).find("impossible: Wrong, because of the object as a whole\n"
                                 "  1 missing: 0 Bulb, where at least 1 is needed\n"),
                  std::string::npos)
            << why(none);
    const std::string guarded = why("(core:hasPart min 2 :Stem) and (core:hasPart max 0 :Bulb)");
    EXPECT_EQ(guarded.find("too many"), std::string::npos) << guarded;
    EXPECT_NE(guarded.find("\n  its Stem: part"), std::string::npos) << guarded;
}

TEST(Eval, AgainstTheTruthOfTheExamples) {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "truth");
    std::vector<std::string> annotate = {"annotate"};
    for (const ExampleObject& object : paper_objects()) {
        folder.write(object.name + ".off", to_off(object.mesh));
        std::string labels;
        for (const std::string& label : object.labels) labels += (label == "Leg" ? "foot" : label) + "\n";
        folder.write("truth/" + object.name + ".labels.txt", labels);
        annotate.push_back(object.name + ".off");
    }
    annotate.insert(annotate.end(), {"--ontology", furniture_path(), "-o", "out", "-q"});
    ASSERT_EQ(run_partonomy(annotate, folder.path()).exit_code, 2);  // strange-object2 is among them
    const ProgramResult result =
        run_partonomy({"eval", "out", "--truth", "truth", "--names", "foot=Leg", "--json"}, folder.path());
    ASSERT_EQ(result.exit_code, 0) << result.err;
    const json report = json::parse(result.out);
    EXPECT_EQ(report.at("meshes").size(), 7U);
    EXPECT_NEAR(report.at("mean_area_accuracy").get<double>(), 1, 1e-12);
    for (const json& mesh : report.at("meshes")) EXPECT_DOUBLE_EQ(mesh.at("boundary").at("f").get<double>(), 1) << mesh;
    double right = 0;
    for (const auto& [truth, row] : report.at("confusion").items())
        for (const auto& [answer, share] : row.items())
            if (answer == truth) right += share.get<double>();
    EXPECT_NEAR(right, 1, 1e-9) << "the mean of confusions that each add up to 1";

    EXPECT_NEAR(report.at("mean").at("face_accuracy").get<double>(), 1, 1e-12);
    EXPECT_NEAR(report.at("mean").at("iou").at("Leg").get<double>(), 1, 1e-12);
    EXPECT_FALSE(report.contains("classes"));

    std::string classes;
    for (const ExampleObject& object : paper_objects()) classes += object.name + ".off " + object.object_class + "\n";
    classes.replace(classes.find(' ') + 1, classes.find('\n') - classes.find(' ') - 1, "Spoon");
    folder.write("classes.txt", classes);
    const ProgramResult with_classes = run_partonomy(
        {"eval", "out", "--truth", "truth", "--names", "foot=Leg", "--classes", "classes.txt"}, folder.path());
    EXPECT_NE(with_classes.out.find("\nmean                        1.0000    1.0000    0.0000    1.0000  "),
              std::string::npos)
        << with_classes.out;
    EXPECT_NE(with_classes.out.find("\nclasses: 6 of 7 right; " + paper_objects().front().name + " as "),
              std::string::npos)
        << with_classes.out;
    folder.write("classes.txt", "chair\n");
    const ProgramResult torn =
        run_partonomy({"eval", "out", "--truth", "truth", "--classes", "classes.txt"}, folder.path());
    EXPECT_EQ(torn.exit_code, 1);
    EXPECT_NE(torn.err.find("classes.txt:1: a line should be"), std::string::npos) << torn.err;

    EXPECT_FALSE(fs::exists(folder.path() / "pictures"));
    const ProgramResult pictures = run_partonomy(
        {"eval", "out", "--truth", "truth", "--names", "foot=Leg", "--pictures", "pictures", "--worst", "3"},
        folder.path());
    ASSERT_EQ(pictures.exit_code, 0) << pictures.err;
    for (const char* name : {"confusion.png", "worst.png"})
        EXPECT_EQ(read_file(folder.path() / "pictures" / name).substr(1, 3), "PNG") << name;
    folder.write("taken", "a file");
    const ProgramResult refused =
        run_partonomy({"eval", "out", "--truth", "truth", "--names", "foot=Leg", "--pictures", "taken"}, folder.path());
    EXPECT_EQ(refused.exit_code, 1);
    EXPECT_NE(refused.err.find("taken"), std::string::npos) << refused.err;
}

/// The truth speaks of the back, the program of the pieces that it is made of; one mesh has no truth.
TEST(Eval, WholesAndMeshesWithoutATruth) {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "truth");
    const ExampleObject chair = headrest_chair();
    folder.write("chair.off", to_off(chair.mesh));
    folder.write("other.off", to_off(headrest_chair(false).mesh));
    std::string labels;
    for (const std::string& label : chair.labels) labels += (label == "Leg" || label == "Seat" ? label : "Back") + "\n";
    folder.write("truth/chair_labels.txt", labels);
    ASSERT_EQ(run_partonomy({"annotate", "chair.off", "other.off", "--ontology",
                             PARTONOMY_SOURCE_DIR "/ontologies/furniture-headrest.omn", "-o", "out", "-q"},
                            folder.path())
                  .exit_code,
              2);  // a headrest without a backrest
    const ProgramResult result = run_partonomy({"eval", "out", "--truth", "truth", "--json"}, folder.path());
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NEAR(json::parse(result.out).at("mean_area_accuracy").get<double>(), 1, 1e-12);
    EXPECT_NE(result.err.find("holds no truth for other"), std::string::npos) << result.err;
    EXPECT_EQ(run_partonomy({"eval", "out/other", "--truth", "truth"}, folder.path()).exit_code, 1);

    std::string strange;
    for (std::size_t k = 0; k < chair.labels.size(); ++k) strange += "thing\n";
    folder.write("truth/chair_labels.txt", strange);
    const ProgramResult unknown = run_partonomy({"eval", "out/chair", "--truth", "truth"}, folder.path());
    EXPECT_NE(unknown.err.find("BackPanel"), std::string::npos) << unknown.err;
    EXPECT_EQ(run_partonomy({"eval", "out", "--truth", "truth", "--names", "thing=Leg", "--names", "thing=Seat"},
                            folder.path())
                  .exit_code,
              1);
}

/// A truth of "-" only is no truth to compare with, but something that must not be recognised.
TEST(Eval, MeshesOfNoKindAreCountedByThemselves) {
    const TemporaryFolder folder;
    fs::create_directories(folder.path() / "truth");
    const std::string ontology = PARTONOMY_SOURCE_DIR "/ontologies/lamps.omn";
    const ExampleObject lamp = lamps().front();
    folder.write("lamp.off", to_off(lamp.mesh));
    folder.write("other.off", to_off(lamp.mesh));
    folder.write("chair.off", to_off(paper_objects().front().mesh));
    std::string labels, none;
    for (const std::string& label : lamp.labels) labels += label + "\n", none += "-\n";
    folder.write("truth/lamp.txt", labels);
    folder.write("truth/other.txt", none);
    none.clear();
    for (int i = 0; i < paper_objects().front().mesh.input_face_count; ++i) none += "-\n";
    folder.write("truth/chair.txt", none);
    (void)run_partonomy({"annotate", "lamp.off", "chair.off", "other.off", "--ontology", ontology, "-o", "out", "-q"},
                        folder.path());
    const ProgramResult all =
        run_partonomy({"eval", "out", "--truth", "truth", "--pictures", "pictures"}, folder.path());
    EXPECT_EQ(all.exit_code, 0) << all.err;
    EXPECT_NE(all.out.find("mean                        1.0000"), std::string::npos) << all.out;
    EXPECT_NE(
        all.out.find("2 meshes of no kind: 1 rightly not recognised, 1 recognised (other as " + lamp.object_class),
        std::string::npos)
        << all.out;
    EXPECT_EQ(all.err.find("--names"), std::string::npos) << all.err;
    const json report = json::parse(run_partonomy({"eval", "out", "--truth", "truth", "--json"}, folder.path()).out);
    EXPECT_EQ(report.at("meshes").size(), 1U);
    EXPECT_EQ(report.at("no_kind").at("rightly_not_recognised"), (std::vector<std::string>{"chair"}));
    const ProgramResult one =
        run_partonomy({"eval", "out/chair", "--truth", "truth", "--pictures", "none"}, folder.path());
    EXPECT_EQ(one.exit_code, 0) << one.err;
    EXPECT_EQ(one.out, "1 mesh of no kind: 1 rightly not recognised\n");
}

/// The pieces of a hood are helpers: its faces are called by the hood, and count.
TEST(Annotate, PiecesThatAreHelpersAreCalledByTheirWhole) {
    const TemporaryFolder folder;
    std::string text = read_file(std::filesystem::path(PARTONOMY_SOURCE_DIR) / "ontologies/lamps.omn");
    for (const std::string piece : {"HoodWall", "HoodTop"}) {
        const std::size_t at = text.find("Class: :" + piece + "\n");
        ASSERT_NE(at, std::string::npos);
        text.insert(text.find('\n', at) + 1, "    Annotations: core:helper true\n");
    }
    folder.write("lamps.omn", text);
    for (const ExampleObject& each : lamps())
        if (each.name == "desk-lamp") folder.write("desk-lamp.off", to_off(each.mesh));
    const ProgramResult result =
        run_partonomy({"annotate", "desk-lamp.off", "--ontology", "lamps.omn", "-o", "out"}, folder.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("DeskLamp"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find(": Arm, Base, Pole; wholes: Hood, Stem;"), std::string::npos) << result.out;
    const std::string labels = read_file(folder.path() / "out/desk-lamp/labels.txt");
    EXPECT_NE(labels.find("\nHood\n"), std::string::npos);
    EXPECT_EQ(labels.find("-\n"), std::string::npos);
    const json annotation = json::parse(read_file(folder.path() / "out/desk-lamp/annotation.json"));
    EXPECT_TRUE(annotation.at("open_questions").empty()) << annotation.at("open_questions");
    EXPECT_GT(annotation.at("object").at("score").get<double>(), 0.5);
}

TEST(Explain, SaysHowFarOffARelationIs) {
    const TemporaryFolder folder;
    folder.write("lamp.off", to_off(lamps().front().mesh));
    std::string text = read_file(std::filesystem::path(PARTONOMY_SOURCE_DIR) / "ontologies/lamps.omn");
    text +=
        "\nClass: :LowLamp\n    SubClassOf: core:Object\n    EquivalentTo: core:Object and (core:hasPart some (:Shade "
        "and "
        "(core:isTargetRegion some (core:Below and (inverse (core:isReferenceRegion) some :Base)))))\n";
    folder.write("lamps.omn", text);
    ASSERT_EQ(run_partonomy({"annotate", "lamp.off", "--ontology", "lamps.omn", "-o", "out"}, folder.path()).exit_code,
              0);
    const ProgramResult result = run_partonomy({"explain", "out/lamp"}, folder.path());
    const std::size_t yes = result.out.find("a Base: yes [part "), no = result.out.find("a Base: no [part ");
    ASSERT_NE(yes, std::string::npos) << result.out;
    ASSERT_NE(no, std::string::npos) << result.out;
    const auto line = [&](std::size_t at) { return result.out.substr(at, result.out.find('\n', at) - at); };
    EXPECT_NE(line(yes).find("rise 0."), std::string::npos) << line(yes);
    EXPECT_NE(line(yes).find("(wanted >= 0), side step 0 (wanted <= 0.1)]"), std::string::npos) << line(yes);
    EXPECT_NE(line(no).find("drop -0."), std::string::npos) << line(no);
    const ProgramResult folder_of_one = run_partonomy({"explain", "out"}, folder.path());
    EXPECT_EQ(folder_of_one.exit_code, 1);
    EXPECT_NE(folder_of_one.err.find("name one of them: out/lamp"), std::string::npos) << folder_of_one.err;
}

/// A stick of 1 m along x.
const char* const lying_bar =
    "OFF\n8 6 0\n0 0 0\n1 0 0\n1 .1 0\n0 .1 0\n0 0 .1\n1 0 .1\n1 .1 .1\n0 .1 .1\n"
    "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n";

/// Fences, which have posts.
const std::string fence = R"(Prefix: : <http://example.org/posts#>
Prefix: core: <https://w3id.org/partonomy/core#>
Ontology: <http://example.org/posts>
    Import: <https://w3id.org/partonomy/core>
Class: :Fence
    SubClassOf: core:Object
    EquivalentTo: core:Object and (core:hasPart some :Post)
)";

/// A lying stick where posts stand: what was measured of it, and what it would be.
TEST(Explain, SaysWhatWasMeasuredAndWhatRefusesTheNearestName) {
    const TemporaryFolder folder;
    folder.write("posts.omn", fence + R"(Class: :Post
    SubClassOf: core:Region
    EquivalentTo: core:Region and (core:hasShape some core:Stick) and (core:hasOrientation some core:Vertical)
Class: :Plate
    SubClassOf: core:Region
    EquivalentTo: core:Region and (core:hasShape some core:Board) and (core:hasOrientation some core:Vertical)
)");
    folder.write("bar.off", lying_bar);
    EXPECT_EQ(run_partonomy({"annotate", "bar.off", "--ontology", "posts.omn", "-o", "out"}, folder.path()).exit_code,
              2);
    const ProgramResult result = run_partonomy({"explain", "out/bar", "--part", "1"}, folder.path());
    EXPECT_NE(result.out.find("Shape: Stick [l0/l1 10 (wanted >= 2), l1/l2 1 (wanted <= 2)]"), std::string::npos)
        << result.out;
    EXPECT_NE(result.out.find("it would be a Post, but for\n    is it horizontal: yes (1.00) [inclination 0 degrees "
                              "(wanted <= 45)]\n"),
              std::string::npos)
        << result.out;
    const json annotation = json::parse(read_file(folder.path() / "out/bar/annotation.json"));
    EXPECT_EQ(annotation.at("parts").at(0).at("nearest").at("concept"), "Post");
    const std::string trace = read_file(folder.path() / "out/bar/trace.txt");
    EXPECT_NE(trace.find("[inclination 0 degrees (wanted "), std::string::npos) << trace;
}

/// A post that must be near a plate where there is none: it would be a Post all the same, and it is said why not.
TEST(Explain, SaysThatNobodyIsOnTheOtherSide) {
    const TemporaryFolder folder;
    folder.write("posts.omn", fence + R"(Class: :Ball
    SubClassOf: core:Region
    EquivalentTo: core:Region and (core:hasShape some core:Cube)
Class: :Plate
    SubClassOf: core:Region
    EquivalentTo: core:Region and (core:hasShape some core:Board)
Class: :Post
    SubClassOf: core:Region
    EquivalentTo: core:Region and (core:hasShape some core:Stick) and (core:hasOrientation some core:Horizontal)
        and (core:isTargetRegion some (core:Close and (inverse (core:isReferenceRegion) some :Plate)))
)");
    folder.write("bar.off", lying_bar);
    EXPECT_EQ(run_partonomy({"annotate", "bar.off", "--ontology", "posts.omn", "-o", "out"}, folder.path()).exit_code,
              2);
    const ProgramResult result = run_partonomy({"explain", "out/bar"}, folder.path());
    EXPECT_NE(result.out.find("it would be a Post, but for\n    is it close to a Plate: no (1.00) [no other part is a "
                              "Plate]\n"),
              std::string::npos)
        << result.out;
}

TEST(Annotate, AForgottenUnitIsDoubted) {
    const TemporaryFolder folder;
    TriangleMesh mesh = paper_objects().front().mesh;
    for (Vec3& p : mesh.positions) p *= 1000;  // millimetres
    folder.write("bench.off", to_off(mesh));
    const std::vector<std::string> command{"annotate", "bench.off", "--ontology", furniture_path(), "-o", "out"};
    const ProgramResult doubted = run_partonomy(command, folder.path());
    EXPECT_NE(doubted.err.find("m long, since no --unit was told"), std::string::npos) << doubted.err;
    std::vector<std::string> told = command;
    told.insert(told.end(), {"--unit", "mm"});
    EXPECT_EQ(run_partonomy(told, folder.path()).err.find("--unit"), std::string::npos);
}

}  // namespace
}  // namespace partonomy
