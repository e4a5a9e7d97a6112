/* Whatever is wrong with the input: one clear sentence, exit code 1, and nothing half-written. */

#include <gtest/gtest.h>

#include <algorithm>

#include "app/run_program.h"

namespace partonomy {
namespace {

namespace fs = std::filesystem;

const char* const triangle_off = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";

struct Case {
    std::string name;
    std::string file, bytes;            ///< what is written, and under which name
    std::vector<std::string> mentions;  ///< what the sentence must hold
};

void expect_one_sentence(const ProgramResult& result, const std::vector<std::string>& mentions) {
    EXPECT_EQ(result.exit_code, 1) << result.out << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
    EXPECT_TRUE(result.err.starts_with("partonomy: ")) << result.err;
    EXPECT_EQ(result.err.find("internal error"), std::string::npos) << result.err;
    for (const std::string& text : mentions)
        EXPECT_NE(result.err.find(text), std::string::npos) << text << "\nnot in\n" << result.err;
}

TEST(BadMesh, OneSentenceAndNoOutput) {
    const std::string binary_stl_truncated =
        std::string(80, ' ') + std::string("\x0a\0\0\0", 4) + std::string(60, '\0');
    const std::vector<Case> cases = {
        {"empty", "m.off", "", {"m.off", "empty"}},
        {"wrong format", "m.off", "hello, this is no mesh\n", {"m.off"}},
        {"png named off", "m.off", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), {"m.off"}},
        {"truncated", "m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n", {"m.off"}},
        {"not a number", "m.off", "OFF\n3 1 0\n0 0 0\n1 zero 0\n0 1 0\n3 0 1 2\n", {"m.off:4", "zero"}},
        {"nan", "m.off", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", {"m.off:4"}},
        {"index out of range", "m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n", {"m.off:6", "7"}},
        {"negative index", "m.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n", {"m.off:6", "-2"}},
        {"huge count", "m.off", "OFF\n4000000000 4000000000 0\n0 0 0\n", {"m.off"}},
        {"no faces", "m.off", "OFF\n3 0 0\n0 0 0\n1 0 0\n0 1 0\n", {"m.off", "face"}},
        {"no area", "m.off", "OFF\n3 1 0\n0 0 0\n0 0 0\n0 0 0\n3 0 1 2\n", {"m.off"}},
        {"obj index", "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", {"m.obj:4", "9"}},
        {"obj zero index", "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", {"m.obj:4"}},
        {"obj without faces", "m.obj", "v 0 0 0\nv 1 0 0\n", {"m.obj"}},
        {"ascii stl", "m.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0\n", {"m.stl"}},
        {"binary stl", "m.stl", binary_stl_truncated, {"m.stl"}},
        {"ply without end_header", "m.ply", "ply\nformat ascii 1.0\nelement vertex 3\n", {"m.ply"}},
        {"ply truncated",
         "m.ply",
         "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face "
         "1\n"
         "property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n",
         {"m.ply"}},
        {"ply binary truncated",
         "m.ply",
         "ply\nformat binary_little_endian 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float "
         "z\n"
         "element face 1\nproperty list uchar int vertex_indices\nend_header\nabcdefgh",
         {"m.ply"}},
    };
    for (const Case& bad : cases) {
        SCOPED_TRACE(bad.name);
        const TemporaryFolder folder;
        folder.write(bad.file, bad.bytes);
        const ProgramResult result =
            run_partonomy({"annotate", bad.file, "--ontology", furniture_path(), "-o", "out"}, folder.path());
        expect_one_sentence(result, bad.mentions);
        EXPECT_FALSE(fs::exists(folder.path() / "out" / "m")) << "half-written output";
    }
}

TEST(BadMesh, MissingOrFolder) {
    const TemporaryFolder folder;
    expect_one_sentence(run_partonomy({"annotate", "nowhere.off", "--ontology", furniture_path()}, folder.path()),
                        {"nowhere.off", "no such file"});
    expect_one_sentence(run_partonomy({"annotate", ".", "--ontology", furniture_path()}, folder.path()), {"folder"});
}

TEST(BadMesh, TheOthersAreStillDone) {
    const TemporaryFolder folder;
    folder.write("good.off", triangle_off);
    folder.write("bad.off", "OFF\n");
    const ProgramResult result =
        run_partonomy({"annotate", "bad.off", "good.off", "--ontology", furniture_path(), "-o", "out"}, folder.path());
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_TRUE(fs::exists(folder.path() / "out/good/annotation.json"));
    EXPECT_FALSE(fs::exists(folder.path() / "out/bad"));
}

TEST(BadOntology, OneSentenceWithFileAndLine) {
    const std::string prefixes =
        "@prefix : <http://example.org/d#> .\n@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
        "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n@prefix core: <https://w3id.org/partonomy/core#> .\n";
    const std::string importing =
        prefixes + "<http://example.org/d> a owl:Ontology ; owl:imports <https://w3id.org/partonomy/core> .\n";
    const std::vector<Case> cases = {
        {"empty", "o.ttl", "", {"o.ttl"}},
        {"not an ontology", "o.ttl", "this is\nno ontology", {"o.ttl:1", "is no ontology", "Manchester"}},
        {"a note", "o.txt", "\nLamps: to do", {"o.txt:2", "is no ontology"}},
        {"core forgotten",
         "o.ttl",
         prefixes + ":Leg a owl:Class ; rdfs:subClassOf core:Region .\n",
         {"o.ttl:5", "which is not imported; import <https://w3id.org/partonomy/core>"}},
        {"no such name in core",
         "o.ttl",
         importing + ":Leg a owl:Class ; rdfs:subClassOf core:Regoin .\n",
         {"o.ttl:6", "core ontology has no such; mend its name (did you mean Region?)"}},
        {"a second trapezoid",
         "o.ttl",
         importing + ":Weight a owl:Class ; rdfs:subClassOf core:Feature .\n:Light a owl:Class ; rdfs:subClassOf "
                     ":Weight ; core:measure \"volume\" ;\n  core:membership \"0 0 1 2\" ;\n  core:membership \"0 0 3 "
                     "4\" .\n:hasWeight a owl:ObjectProperty , owl:FunctionalProperty ; rdfs:range :Weight .\n"
                     ":Part a owl:Class ; rdfs:subClassOf core:Region ; owl:equivalentClass [ a owl:Restriction ; "
                     "owl:onProperty :hasWeight ; owl:someValuesFrom :Light ] .\n"
                     ":Whole a owl:Class ; rdfs:subClassOf core:Object ; owl:equivalentClass [ a owl:Restriction ; "
                     "owl:onProperty core:hasPart ; owl:someValuesFrom :Part ] .\n",
         {"o.ttl:9", "core:criterion", "is a second one beside \"0 0 1 2\""}},
        {"binary", "o.ttl", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), {"o.ttl"}},
        {"syntax error", "o.ttl", importing + ":Seat a owl:Class\n:Leg a owl:Class .\n", {"o.ttl:7"}},
        {"unclosed", "o.ttl", importing + ":Seat a owl:Class ; rdfs:label \"seat", {"o.ttl"}},
        {"unknown prefix", "o.ttl", importing + "nowhere:Seat a owl:Class .\n", {"o.ttl:6", "nowhere"}},
        {"missing import",
         "o.ttl",
         prefixes + "<http://example.org/d> a owl:Ontology ;\n  owl:imports <http://example.org/other> .\n",
         {"o.ttl:6", "http://example.org/other"}},
        {"cannot be grounded",
         "o.ttl",
         importing + ":Chair a owl:Class ;\n  rdfs:subClassOf core:Object ;\n"
                     "  owl:equivalentClass [ a owl:Restriction ; owl:onProperty core:hasShape ; owl:someValuesFrom "
                     "core:Board ] "
                     ".\n",
         {"o.ttl:8", "Chair", "hasShape"}},
        {"broken xml",
         "o.owl",
         "<?xml version=\"1.0\"?>\n<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">\n<oops>\n",
         {"o.owl"}},
        {"external entity",
         "o.owl",
         "<?xml version=\"1.0\"?>\n<!DOCTYPE r [ <!ENTITY x SYSTEM \"file:///etc/passwd\"> ]>\n"
         "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">&x;</rdf:RDF>\n",
         {"o.owl", "entit"}},
    };
    for (const Case& bad : cases) {
        SCOPED_TRACE(bad.name);
        const TemporaryFolder folder;
        folder.write("m.off", triangle_off);
        folder.write(bad.file, bad.bytes);
        const ProgramResult result =
            run_partonomy({"annotate", "m.off", "--ontology", bad.file, "-o", "out"}, folder.path());
        expect_one_sentence(result, bad.mentions);
        EXPECT_FALSE(fs::exists(folder.path() / "out")) << "half-written output";
    }
    const TemporaryFolder folder;
    folder.write("m.off", triangle_off);
    expect_one_sentence(run_partonomy({"annotate", "m.off", "--ontology", "nowhere.ttl"}, folder.path()),
                        {"nowhere.ttl", "no such file"});
}

TEST(BadUsage, OneSentence) {
    const TemporaryFolder folder;
    folder.write("m.off", triangle_off);
    fs::create_directories(folder.path() / "sub");
    fs::copy_file(folder.path() / "m.off", folder.path() / "sub/m.off");
    const std::vector<std::pair<std::vector<std::string>, std::string>> cases = {
        {{}, "subcommand"},
        {{"annotate", "m.off"}, "--ontology"},
        {{"annotate", "--ontology", furniture_path()}, "MESH"},
        {{"annotate", "m.off", "--ontology", furniture_path(), "--up", "w"}, "--up w"},
        {{"annotate", "m.off", "--ontology", furniture_path(), "--unit", "feet"}, "--unit feet"},
        {{"annotate", "m.off", "--ontology", furniture_path(), "--strategy", "guess"}, "--strategy guess"},
        {{"annotate", "m.off", "--ontology", furniture_path(), "--format", "docx"}, "docx"},
        {{"annotate", "m.off", "--ontology", furniture_path(), "--threads", "-1"}, "--threads"},
        {{"annotate", "m.off", "--ontology", furniture_path(), "--nonsense"}, "--nonsense"},
        {{"annotate", "m.off", "--ontolgy", furniture_path()},
         "\"--ontolgy\" is no option of annotate; did you mean \"--ontology\"?"},
        {{"annotate", "m.off", "--ontology", furniture_path(), "--otput=x"}, "did you mean \"--output\"?"},
        {{"annotat", "m.off"}, "\"annotat\" is no command; did you mean \"annotate\"?"},
        {{"annotate", "m.off", "sub/m.off", "--ontology", furniture_path()}, "sub/m.off"},
        {{"annotate", "m.off", "--ontology", furniture_path(), "-o", "m.off"}, "m.off"},
        {{"explain", "sub"}, "annotation.json"},
        {{"eval", "sub", "--truth", "m.off"}, "labels.txt"},
        {{"tree", furniture_path(), "-o", "tree.docx"}, "tree.docx"},
        {{"check", "nowhere.ttl"}, "nowhere.ttl"},
    };
    for (const auto& [arguments, mention] : cases) {
        SCOPED_TRACE(mention);
        expect_one_sentence(run_partonomy(arguments, folder.path()), {mention});
    }
}

/// Old results survive a run that fails.
TEST(BadMesh, OldOutputSurvives) {
    const TemporaryFolder folder;
    folder.write("m.off", triangle_off);
    ASSERT_NE(
        run_partonomy({"annotate", "m.off", "--ontology", furniture_path(), "-o", "out"}, folder.path()).exit_code, 1);
    folder.write("out/m/notes.txt", "mine");
    folder.write("m.off", "OFF\n3 1 0\n0 0 0\n");
    ASSERT_EQ(
        run_partonomy({"annotate", "m.off", "--ontology", furniture_path(), "-o", "out"}, folder.path()).exit_code, 1);
    EXPECT_TRUE(fs::exists(folder.path() / "out/m/labels.txt"));
    EXPECT_TRUE(fs::exists(folder.path() / "out/m/notes.txt"));
}

}  // namespace
}  // namespace partonomy
