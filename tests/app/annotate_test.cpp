#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "app/run_program.h"
#include "base/files.h"
#include "examples/objects.h"
#include "mesh/write_off.h"

namespace partonomy {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const ExampleObject& object(const std::string& name) {
    static const std::vector<ExampleObject> objects = paper_objects();
    return *std::find_if(objects.begin(), objects.end(), [&](const ExampleObject& o) { return o.name == name; });
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    std::size_t start = 0;
    for (std::size_t end = text.find('\n'); end != std::string::npos; end = text.find('\n', start)) {
        lines.push_back(text.substr(start, end - start));
        start = end + 1;
    }
    return lines;
}

TEST(Annotate, MisspeltNamesAreToldAsByCheck) {
    const TemporaryFolder folder;
    folder.write("bench.off", to_off(object("bench").mesh));
    for (const char* wrong : {"core:isTargetRegion some (core:ShorterThan and (inverse (core:isReferenceRegion) "
                              "some core:Region))",
                              "core:hasShape some core:Stik", "core:heigth some xsd:double[>= 1.0]"}) {
        folder.write("o.omn",
                     "Prefix: : <urn:s#>\nPrefix: core: <https://w3id.org/partonomy/core#>\n"
                     "Prefix: xsd: <http://www.w3.org/2001/XMLSchema#>\nOntology: <urn:s>\n"
                     "Import: <https://w3id.org/partonomy/core>\n"
                     "Class: :CutShorterThan SubClassOf: core:Relation\n"
                     "Class: :Handle SubClassOf: core:Region EquivalentTo: core:Region and (" +
                         std::string(wrong) + ")\n");
        const ProgramResult checked = run_partonomy({"check", "o.omn"}, folder.path());
        const ProgramResult annotated =
            run_partonomy({"annotate", "bench.off", "--ontology", "o.omn", "-o", "out"}, folder.path());
        EXPECT_EQ(annotated.exit_code, 1);
        EXPECT_EQ(annotated.err, checked.err);
        EXPECT_NE(checked.err.find("did you mean"), std::string::npos) << checked.err;
    }
}

TEST(Annotate, ADoubtfulUnitIsToldWithWhatIsAsLikely) {
    const auto note = [](const std::string& length) {
        const TemporaryFolder folder;
        folder.write("o.omn",
                     "Prefix: : <urn:s#>\nPrefix: core: <https://w3id.org/partonomy/core#>\n"
                     "Prefix: xsd: <http://www.w3.org/2001/XMLSchema#>\nOntology: <urn:s>\n"
                     "Import: <https://w3id.org/partonomy/core>\n"
                     "Class: :Rod SubClassOf: core:Region EquivalentTo: core:Region and (core:length some "
                     "xsd:double[>= 1.0])\n"
                     "Class: :Pin SubClassOf: core:Object EquivalentTo: core:Object and (core:hasPart some :Rod)\n");
        folder.write("pin.off",
                     "OFF\n4 4 0\n0 0 0\n" + length + " 0 0\n0 5 0\n0 0 5\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n");
        return run_partonomy({"annotate", "pin.off", "--ontology", "o.omn", "-o", "out"}, folder.path()).err;
    };
    const std::string likely = note("263"), long_one = note("2630"), short_one = note("26");
    EXPECT_NE(likely.find("is it --unit mm (0.263 m) or --unit cm (2.63 m)?"), std::string::npos) << likely;
    EXPECT_NE(long_one.find("is it --unit mm (2.63 m)?"), std::string::npos) << long_one;
    EXPECT_EQ(short_one.find("--unit"), std::string::npos) << short_one;
}

TEST(Annotate, BenchEndToEnd) {
    const TemporaryFolder folder;
    folder.write("bench.off", to_off(object("bench").mesh));
    const ProgramResult result =
        run_partonomy({"annotate", "bench.off", "--ontology", furniture_path(), "-o", "out"}, folder.path());
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
    EXPECT_NE(result.out.find("Bench"), std::string::npos) << result.out;
    for (const char* name :
         {"labels.txt", "annotation.json", "annotation.ply", "annotation.glb", "preview.png", "trace.txt"})
        EXPECT_GT(fs::file_size(folder.path() / "out/bench" / name), 20U) << name;

    const std::vector<std::string> labels = lines_of(read_file(folder.path() / "out/bench/labels.txt"));
    EXPECT_EQ(labels, object("bench").labels);

    const json annotation = json::parse(read_file(folder.path() / "out/bench/annotation.json"));
    EXPECT_EQ(annotation.at("mesh").at("faces"), 36);
    EXPECT_EQ(annotation.at("mesh").at("sha256"), sha256(to_off(object("bench").mesh)));
    EXPECT_EQ(annotation.at("ontology").at("iri"), "https://w3id.org/partonomy/furniture");
    EXPECT_EQ(annotation.at("ontology").at("sha256"), sha256(read_file(furniture_path())));
    EXPECT_EQ(annotation.at("object").at("classes"), json::array({"Bench"}));
    EXPECT_EQ(annotation.at("object").at("consistent"), true);
    EXPECT_GT(annotation.at("object").at("score"), 0.9);
    ASSERT_EQ(annotation.at("parts").size(), 4U);
    std::int64_t faces = 0;
    for (const json& part : annotation.at("parts")) {
        for (const char* key : {"id", "concepts", "faces", "area", "score", "features", "measurements"})
            EXPECT_TRUE(part.contains(key)) << key;
        EXPECT_EQ(part.at("features").at("Shape"), "Board");
        faces += part.at("faces").get<std::int64_t>();
    }
    EXPECT_EQ(faces, 36);
    for (const char* key : {"SF", "SI", "T", "TF", "read_off"})
        EXPECT_TRUE(annotation.at("questions").contains(key)) << key;
    ASSERT_FALSE(annotation.at("trace").empty());
    for (const json& entry : annotation.at("trace"))
        for (const char* key : {"question", "region", "answer", "score", "inferred", "ms"})
            EXPECT_TRUE(entry.contains(key)) << key;
    EXPECT_TRUE(annotation.at("diagnosis").empty());
    EXPECT_FALSE(annotation.at("timings_ms").empty());
}

TEST(Annotate, ImpossibleObjectIsExplained) {
    const TemporaryFolder folder;
    folder.write("strange.off", to_off(object("strange-object2").mesh));
    const ProgramResult result = run_partonomy(
        {"annotate", "strange.off", "--ontology", furniture_path(), "-o", "out", "--quiet"}, folder.path());
    EXPECT_EQ(result.exit_code, 2) << result.err;
    EXPECT_EQ(result.out + result.err, "");
    const json annotation = json::parse(read_file(folder.path() / "out/strange/annotation.json"));
    EXPECT_EQ(annotation.at("object").at("classes"), json::array({"Chair", "FootIncompatibleFurnitures"}));
    EXPECT_EQ(annotation.at("object").at("consistent"), false);
    ASSERT_EQ(annotation.at("diagnosis").size(), 1U);
    const json& diagnosis = annotation.at("diagnosis")[0];
    EXPECT_EQ(diagnosis.at("concept"), "FootIncompatibleFurnitures");
    ASSERT_EQ(diagnosis.at("parts").size(), 1U);
    for (const json& part : annotation.at("parts"))
        if (part.at("id") == diagnosis.at("parts")[0]) {
            EXPECT_EQ(part.at("features").at("Shape"), "Board");
            EXPECT_EQ(part.at("concepts")[0], "Leg");
        }
    EXPECT_FALSE(diagnosis.at("axioms").empty());
    EXPECT_FALSE(diagnosis.at("corrections").empty());

    const ProgramResult why = run_partonomy({"explain", "out/strange"}, folder.path());
    EXPECT_EQ(why.exit_code, 2);
    EXPECT_NE(why.out.find("impossible: FootIncompatibleFurnitures"), std::string::npos) << why.out;
}

TEST(Annotate, SameBytesOnAnyNumberOfThreads) {
    const TemporaryFolder folder;
    folder.write("chair2.off", to_off(object("chair2").mesh));
    for (const char* threads : {"1", "2", "0"}) {
        ASSERT_EQ(run_partonomy({"annotate", "chair2.off", "--ontology", furniture_path(), "-o",
                                 std::string("out") + threads, "--threads", threads},
                                folder.path())
                      .exit_code,
                  0);
        for (const char* name : {"labels.txt", "annotation.ply", "annotation.glb", "preview.png"})
            EXPECT_EQ(sha256(read_file(folder.path() / (std::string("out") + threads) / "chair2" / name)),
                      sha256(read_file(folder.path() / "out1/chair2" / name)))
                << name << " on " << threads << " threads";
    }
}

TEST(Annotate, PartsWithoutANameAreCountedAndNamedOneByOne) {
    const TemporaryFolder folder;
    folder.write("chair.off", to_off(paper_object("chair").mesh));
    folder.write("legs.omn",
                 "Prefix: : <http://example.org/d#>\nPrefix: core: <https://w3id.org/partonomy/core#>\n"
                 "Ontology: <http://example.org/d>\nImport: <https://w3id.org/partonomy/core>\n"
                 "Class: :Leg\n SubClassOf: core:Region\n EquivalentTo: core:Region and core:hasShape some core:Stick\n"
                 "Class: :Legged\n SubClassOf: core:Object\n EquivalentTo: core:hasPart some :Leg\n");
    const ProgramResult result =
        run_partonomy({"annotate", "chair.off", "--ontology", "legs.omn", "-o", "out"}, folder.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.out.find("Leg x4, unnamed x2; "), std::string::npos) << result.out;
    const json annotation = json::parse(read_file(folder.path() / "out/chair/annotation.json"));
    std::vector<std::string> unnamed;
    for (const json& part : annotation.at("parts"))
        if (part.at("concepts").empty())
            unnamed.push_back("part " + part.at("id").dump() + " is nothing that the ontology names");
    EXPECT_EQ(annotation.at("open_questions").get<std::vector<std::string>>(), unnamed);
}

TEST(Annotate, TheSummaryTellsEveryName) {
    const TemporaryFolder folder;
    folder.write("chair.off", to_off(paper_object("chair").mesh));
    folder.write("legs.omn",
                 "Prefix: : <http://example.org/d#>\nPrefix: core: <https://w3id.org/partonomy/core#>\n"
                 "Ontology: <http://example.org/d>\nImport: <https://w3id.org/partonomy/core>\n"
                 "Class: :Flat\n EquivalentTo: core:Region and core:hasShape some core:Board\n"
                 "Class: :Thin\n EquivalentTo: core:Region and not core:hasShape some core:Cube\n"
                 "Class: :Top\n EquivalentTo: core:Region and core:hasPosition some core:Up\n"
                 "Class: :Thing\n EquivalentTo: core:Object and core:hasPart some :Thin and core:hasPart some :Top\n");
    const ProgramResult result =
        run_partonomy({"annotate", "chair.off", "--ontology", "legs.omn", "-o", "out"}, folder.path());
    // Thin is more general than Flat, so it is told only of the legs.
    EXPECT_NE(result.out.find("Flat, Flat+Top, Thin x4; "), std::string::npos) << result.out;
}

TEST(Annotate, OnlyTheFormatsAskedFor) {
    const TemporaryFolder folder;
    folder.write("bench.off", to_off(object("bench").mesh));
    ASSERT_EQ(
        run_partonomy({"annotate", "bench.off", "--ontology", furniture_path(), "-o", "out", "--format", "labels,json"},
                      folder.path())
            .exit_code,
        0);
    EXPECT_TRUE(fs::exists(folder.path() / "out/bench/labels.txt"));
    EXPECT_TRUE(fs::exists(folder.path() / "out/bench/annotation.json"));
    EXPECT_FALSE(fs::exists(folder.path() / "out/bench/preview.png"));
}

TEST(Annotate, AFaceThatRepeatsAnotherSharesItsLabel) {
    const TemporaryFolder folder;
    std::string off = to_off(object("bench").mesh);
    const std::size_t header_end = off.find("\n", 4);
    off.replace(4, header_end - 4, "20 37 0");
    folder.write("bench.off", off + off.substr(off.rfind("\n3 ") + 1));
    const ProgramResult result =
        run_partonomy({"annotate", "bench.off", "--ontology", furniture_path(), "-o", "out"}, folder.path());
    ASSERT_EQ(result.exit_code, 0) << result.err;
    EXPECT_NE(result.err.find("repeats"), std::string::npos) << result.err;
    const std::vector<std::string> labels = lines_of(read_file(folder.path() / "out/bench/labels.txt"));
    ASSERT_EQ(labels.size(), 37U);
    EXPECT_NE(labels[36], "-");
    EXPECT_EQ(labels[36], labels[35]);
}

TEST(Annotate, UnknownUnitLeavesSizesOpen) {
    const TemporaryFolder folder;
    TriangleMesh mesh = object("bench").mesh;
    for (Vec3& position : mesh.positions) position *= 7;  // no bench is 5 m high, nor 5 cm, 5 mm or 5 inches
    folder.write("bench.off", to_off(mesh));
    ASSERT_NE(run_partonomy({"annotate", "bench.off", "--ontology", furniture_path(), "-o", "out", "--unit", "auto"},
                            folder.path())
                  .exit_code,
              1);
    const json annotation = json::parse(read_file(folder.path() / "out/bench/annotation.json"));
    for (const json& part : annotation.at("parts")) EXPECT_FALSE(part.at("features").contains("Modular"));
    EXPECT_EQ(lines_of(read_file(folder.path() / "out/bench/labels.txt")), object("bench").labels);
    EXPECT_EQ(annotation.at("mesh").at("unit"), "unknown");
}

TEST(Annotate, UpAndUnitAreFoundAndTold) {
    const TemporaryFolder folder;
    TriangleMesh mesh = object("bench").mesh;
    for (Vec3& position : mesh.positions) position = 1000 * Vec3(position.y(), position.z(), position.x());  // y up, mm
    folder.write("bench.off", to_off(mesh));
    const ProgramResult result = run_partonomy(
        {"annotate", "bench.off", "--ontology", furniture_path(), "-o", "out", "--up", "auto", "--unit", "auto"},
        folder.path());
    EXPECT_EQ(result.exit_code, 0) << result.err;
    const json annotation = json::parse(read_file(folder.path() / "out/bench/annotation.json"));
    EXPECT_EQ(annotation.at("mesh").at("up"), "y");
    EXPECT_EQ(annotation.at("mesh").at("unit"), "mm");
    EXPECT_GT(annotation.at("mesh").at("up_confidence"), 0.5);
    EXPECT_GT(annotation.at("mesh").at("unit_confidence"), 0.7);
    EXPECT_EQ(annotation.at("trace").at(0).at("kind"), "auto");
    EXPECT_EQ(annotation.at("object").at("classes"), json({"Bench"}));
    EXPECT_EQ(lines_of(read_file(folder.path() / "out/bench/labels.txt")), object("bench").labels);
}

}  // namespace
}  // namespace partonomy
