/* partonomy check, and what it shares with tree: faults and remarks on ontologies, with their places. */

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "app/run_program.h"
#include "base/files.h"

namespace partonomy {
namespace {

using nlohmann::json;

TEST(Check, FurnitureIsFine) {
    const TemporaryFolder folder;
    const ProgramResult text = run_partonomy({"check", furniture_path()}, folder.path());
    EXPECT_EQ(text.exit_code, 0) << text.out << text.err;
    EXPECT_NE(text.out.find("nothing wrong found"), std::string::npos) << text.out;
    const ProgramResult result = run_partonomy({"check", furniture_path(), "--json"}, folder.path());
    EXPECT_EQ(result.exit_code, 0);
    const json report = json::parse(result.out);
    const auto hierarchy = report.at("hierarchy").get<std::vector<std::vector<std::string>>>();
    const auto has = [&](const std::vector<std::string>& pair) {
        return std::find(hierarchy.begin(), hierarchy.end(), pair) != hierarchy.end();
    };
    EXPECT_TRUE(has({"Armchair", "Chair"}));
    EXPECT_TRUE(has({"Chair", "Furniture"}));
    EXPECT_TRUE(has({"FootIncompatibleFurnitures", "PlaceForOne"}));
    EXPECT_FALSE(has({"Chair", "Armchair"}));
    EXPECT_TRUE(report.at("unsatisfiable").empty());
    EXPECT_TRUE(report.at("ok").get<bool>());
    for (const json& finding : report.at("findings")) EXPECT_EQ(finding.at("severity"), "remark") << finding;
}

std::string check_slimness(const std::string& characteristics, const std::string& measure, const std::string& from) {
    const TemporaryFolder folder;
    folder.write("o.omn",
                 "Prefix: : <urn:s#>\nPrefix: core: <https://w3id.org/partonomy/core#>\nOntology: <urn:s>\n"
                 "Import: <https://w3id.org/partonomy/core>\n"
                 "Class: :S SubClassOf: core:Feature DisjointUnionOf: :Slender, :Stocky\n"
                 "Class: :Slender SubClassOf: :S Annotations: core:measure \"" +
                     measure + "\", core:membership \"" + from +
                     " inf inf\"\n"
                     "Class: :Stocky SubClassOf: :S Annotations: core:measure \"l0/l2\", core:membership \"-inf -inf 5 "
                     "7\"\n"
                     "ObjectProperty: :hasS\n" +
                     characteristics +
                     "Range: :S\n"
                     "Class: :Handle SubClassOf: core:Region EquivalentTo: core:Region and (:hasS some :Slender)\n"
                     "Class: :Head SubClassOf: core:Region EquivalentTo: core:Region and (:hasS some :Stocky) and "
                     "(core:hasShape some core:Board)\n"
                     "Class: :Hammer SubClassOf: core:Object EquivalentTo: core:Object and (core:hasPart some :Handle) "
                     "and (core:hasPart some :Head)\n");
    return run_partonomy({"check", "o.omn"}, folder.path()).out;
}

TEST(Check, AForgottenTickAWrongMeasureAndAGap) {
    const std::string functional = "Characteristics: Functional\n";
    const std::string fine = check_slimness(functional, "l0/l2", "5 7");
    EXPECT_NE(fine.find("nothing wrong found"), std::string::npos) << fine;
    EXPECT_EQ(fine.find("neither"), std::string::npos) << fine;
    const std::string unticked = check_slimness("", "l0/l2", "5 7");
    EXPECT_NE(unticked.find("no functional property has the range S; tick Functional on hasS"), std::string::npos)
        << unticked;
    EXPECT_NE(unticked.find("1 thing is wrong"), std::string::npos) << unticked;
    const std::string misnamed = check_slimness(functional, "l0/lx", "5 7");
    EXPECT_NE(misnamed.find("there is no measure \"lx\""), std::string::npos) << misnamed;
    EXPECT_NE(misnamed.find("1 thing is wrong"), std::string::npos) << misnamed;
    const std::string gap = check_slimness(functional, "l0/l2", "12 13");
    EXPECT_NE(gap.find("between 6 and 12.5 of l0/l2 neither Slender nor Stocky fits"), std::string::npos) << gap;
    EXPECT_NE(gap.find("nothing wrong found"), std::string::npos) << gap;
}

TEST(Check, ValuesThatBothFit) {
    const TemporaryFolder folder;
    const auto check = [&](const std::string& other) {
        folder.write("o.omn",
                     "Prefix: : <urn:s#>\nPrefix: core: <https://w3id.org/partonomy/core#>\nOntology: <urn:s>\n"
                     "Import: <https://w3id.org/partonomy/core>\n"
                     "Class: :Run SubClassOf: core:Feature DisjointUnionOf: :Climbing, :Crossing\n"
                     "Class: :Climbing Annotations: core:measure \"inclination\", core:membership \"" +
                         other +
                         "\"\n"
                         "Class: :Crossing Annotations: core:measure \"inclination\", core:membership \"-inf -inf 35 "
                         "45\"\n"
                         "ObjectProperty: :hasRun Characteristics: Functional Range: :Run\n"
                         "Class: :Rail SubClassOf: core:Region EquivalentTo: core:Region and (:hasRun some :Climbing)\n"
                         "Class: :Ladder SubClassOf: core:Object EquivalentTo: core:Object and (core:hasPart some "
                         ":Rail)\n");
        return run_partonomy({"check", "o.omn"}, folder.path());
    };
    const ProgramResult fine = check("35 45 inf inf");
    EXPECT_EQ(fine.exit_code, 0) << fine.out;
    const ProgramResult wrong = check("-inf -inf 35 45");
    EXPECT_EQ(wrong.exit_code, 1);
    EXPECT_NE(wrong.out.find("wrong: o.omn:7: up to 35 of inclination both Climbing (line 6) and Crossing fit fully, "
                             "though a part has one Run only; let their memberships meet"),
              std::string::npos)
        << wrong.out;
}

TEST(Check, MisspeltPropertiesGetTheNearestName) {
    const std::map<std::string, std::string> nearest{{"core:heigth some xsd:double[>= 1.0]", "height"},
                                                     {":heigth some xsd:double[>= 1.0]", "height"},
                                                     {"core:hasCompact some core:Compact", "hasCompactness"}};
    for (const auto& [wrong, right] : nearest) {
        const TemporaryFolder folder;
        folder.write("o.omn",
                     "Prefix: : <urn:s#>\nPrefix: core: <https://w3id.org/partonomy/core#>\n"
                     "Prefix: xsd: <http://www.w3.org/2001/XMLSchema#>\nOntology: <urn:s>\n"
                     "Import: <https://w3id.org/partonomy/core>\n"
                     "Class: :Handle SubClassOf: core:Region EquivalentTo: core:Region and (" +
                         wrong + ")\n");
        const ProgramResult result = run_partonomy({"check", "o.omn"}, folder.path());
        EXPECT_EQ(result.exit_code, 1);
        EXPECT_NE(result.err.find("did you mean " + right + "?"), std::string::npos) << result.err;
    }
}

TEST(Check, NamesWhatIsWrong) {
    const TemporaryFolder folder;
    folder.write(
        "o.ttl",
        "@prefix : <http://example.org/d#> .\n@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
        "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n@prefix core: <https://w3id.org/partonomy/core#> .\n"
        "<http://example.org/d> a owl:Ontology ; owl:imports <https://w3id.org/partonomy/core> .\n"
        ":Both a owl:Class ; rdfs:subClassOf core:Region ; owl:equivalentClass [ owl:intersectionOf ( core:Region\n"
        "  [ a owl:Restriction ; owl:onProperty core:hasShape ; owl:someValuesFrom core:Board ]\n"
        "  [ a owl:Restriction ; owl:onProperty core:hasShape ; owl:someValuesFrom core:Cube ] ) ] .\n"
        ":Leg a owl:Class ; rdfs:subClassOf core:Region .\n"
        ":Thing a owl:Class ; rdfs:subClassOf core:Object ; owl:equivalentClass\n"
        "  [ a owl:Restriction ; owl:onProperty core:hasPart ; owl:someValuesFrom :Leg ] .\n");
    const ProgramResult result = run_partonomy({"check", "o.ttl"}, folder.path());
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find("wrong: o.ttl:6: no region can ever be a Both"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("\n    o.ttl:6: Both EquivalentTo: "), std::string::npos) << "the cause: " << result.out;
    EXPECT_NE(result.out.find("Leg has only necessary conditions"), std::string::npos) << result.out;
}

/// An ontology of jars in Manchester syntax; `axioms` is what comes below the import, from line 6 on.
std::string jars(const std::string& axioms) {
    return "Prefix: : <http://example.org/jars#>\nPrefix: core: <https://w3id.org/partonomy/core#>\n"
           "Prefix: xsd: <http://www.w3.org/2001/XMLSchema#>\n"
           "Ontology: <http://example.org/jars>\n    Import: <https://w3id.org/partonomy/core>\n" +
           axioms;
}

const std::string waiting_jars = jars(
    "Class: :Pot\n    SubClassOf: core:Region\n    EquivalentTo: core:Region and (core:hasShape some core:Cube) and "
    "(core:isTargetRegion some (core:Connected and (inverse (core:isReferenceRegion) some :Grip)))\n"
    "Class: :Grip\n    SubClassOf: core:Region\n    EquivalentTo: core:Region and (core:hasShape some core:Stick) and "
    "(core:isTargetRegion some (core:Connected and (inverse (core:isReferenceRegion) some :Pot)))\n"
    "Class: :Jar\n    SubClassOf: core:Object\n    EquivalentTo: core:Object and (core:hasPart some :Pot)\n");

/// Words of its own over extent: values Tall, Middling and Low, of which only one is asked for.
const std::string sized_jars = jars(
    "Class: :Stature\n    SubClassOf: core:Feature\n    DisjointUnionOf: :Tall, :Middling, :Low\n"
    "Class: :Tall\n    Annotations: core:measure \"extent\", core:membership \"0.4 0.5 inf inf\"\n"
    "Class: :Middling\n    Annotations: core:measure \"extent\", core:membership \"0.06 0.08 0.4 0.5\"\n"
    "Class: :Low\n    Annotations: core:measure \"extent\", core:membership \"-inf -inf 0.06 0.08\"\n"
    "ObjectProperty: :hasStature\n    Characteristics: Functional\n    Range: :Stature\n"
    "Class: :Pot\n    SubClassOf: core:Region\n    EquivalentTo: core:Region and (:hasStature some :Tall)\n"
    "Class: :Pots\n    SubClassOf: core:CompositePart\n    EquivalentTo: core:CompositePart and (core:hasPart some "
    ":Pot)\n"
    "Class: :Jar\n    SubClassOf: core:Object\n    EquivalentTo: core:Object and (core:hasPart exactly 1 :Pots)\n");

TEST(Check, NamesThatWaitForEachOther) {
    const TemporaryFolder folder;
    folder.write("jars.omn", waiting_jars);
    const ProgramResult result = run_partonomy({"check", "jars.omn"}, folder.path());
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find("Grip and Pot wait for each other (Grip in line 11, Pot in line 8)"), std::string::npos)
        << result.out;
    const std::size_t grip = waiting_jars.rfind(" and (core:isTargetRegion");
    const std::string mended = waiting_jars.substr(0, grip) + waiting_jars.substr(waiting_jars.find('\n', grip));
    folder.write("jars.omn", mended);
    const ProgramResult fine = run_partonomy({"check", "jars.omn"}, folder.path());
    EXPECT_EQ(fine.exit_code, 0) << fine.out;
}

TEST(Check, SidesOfARelation) {
    const TemporaryFolder folder;
    const auto check = [&](const std::string& relation) {
        folder.write("pots.omn",
                     "Prefix: : <http://x.org/p#>\nPrefix: core: <https://w3id.org/partonomy/core#>\n"
                     "Ontology: <http://x.org/p>\n  Import: <https://w3id.org/partonomy/core>\n"
                     "Class: :Pot\n  SubClassOf: core:Region\n  EquivalentTo: core:Region and (core:hasShape some "
                     "core:Cube)\n"
                     "Class: :Grip\n  SubClassOf: core:Region\n  EquivalentTo: core:Region and (core:hasShape some "
                     "core:Stick) and (" +
                         relation +
                         ")\n"
                         "Class: :Jar\n  SubClassOf: core:Object\n  EquivalentTo: core:Object and (core:hasPart some "
                         ":Grip) and (core:hasPart some :Pot)\n");
        return run_partonomy({"check", "pots.omn"}, folder.path());
    };
    const auto expect = [&](const std::string& relation, int exit_code, const std::string& told) {
        const ProgramResult result = check(relation);
        EXPECT_EQ(result.exit_code, exit_code) << relation << "\n" << result.out;
        EXPECT_NE(result.out.find(told), std::string::npos) << relation << "\n" << result.out;
    };
    for (const std::string own : {"isTargetRegion", "isReferenceRegion"}) {
        const std::string other = own == "isTargetRegion" ? "isReferenceRegion" : "isTargetRegion";
        const auto related = [&](const std::string& to) {
            return "core:" + own + " some (core:LongerThan and (" + to + "))";
        };
        expect(related("inverse (core:" + other + ") some :Pot"), 0, "nothing wrong found");
        expect(related("inverse (core:" + own + ") some :Pot"), 1,
               "inverse (" + own + ") is the part itself once more");
        expect(related("core:" + other + " some :Pot"), 1, "write inverse (" + other + ") some Pot");
        const std::string unnamed = "core:" + own + " some core:LongerThan";
        const std::string remark = "remark: pots.omn:10: in \"" + own +
                                   " some LongerThan\" the other side is not named, so any part whatever will do; "
                                   "name it by and (inverse (" +
                                   other + ") some …) if that is not meant";
        expect(unnamed, 0, remark);
        expect(related("inverse (core:" + other + ") some (" + unnamed + ")"), 0, remark);
        for (const std::string& meant :
             {"not (" + unnamed + ")", "core:" + own + " max 0 core:LongerThan",
              "core:" + own + " min 2 core:LongerThan", related("inverse (core:" + other + ") some core:Region")}) {
            const ProgramResult result = check(meant);
            EXPECT_EQ(result.out.find("other side"), std::string::npos) << meant << "\n" << result.out;
        }
    }
    const auto between = [](int count) {
        return "core:isTargetRegion some (core:Between and (inverse (core:isReferenceRegion) min " +
               std::to_string(count) + " :Pot))";
    };
    expect(between(2), 0, "nothing wrong found");
    expect(between(3), 1, "since Between links one target and two references; ask for no more of either");
    expect("core:isReferenceRegion some (core:Between and (inverse (core:isReferenceRegion) some :Pot))", 0,
           "nothing wrong found");  // the other reference, which may be a Pot
}

TEST(Check, SidesOfARelationInARule) {
    const TemporaryFolder folder;
    folder.write("pots.omn",
                 "Prefix: : <http://x.org/p#>\nPrefix: core: <https://w3id.org/partonomy/core#>\n"
                 "Ontology: <http://x.org/p>\n  Import: <https://w3id.org/partonomy/core>\n"
                 "Class: :Pot\n  SubClassOf: core:Region\n  EquivalentTo: core:Region and (core:hasShape some "
                 "core:Cube)\n"
                 "Class: :Jar\n  SubClassOf: core:Object\n  EquivalentTo: core:Object and (core:hasPart some "
                 "(:Pot and (core:isTargetRegion some core:Connected)))\n");
    const ProgramResult result = run_partonomy({"check", "pots.omn"}, folder.path());
    EXPECT_NE(result.out.find("remark: pots.omn:10: in \"isTargetRegion some Connected\" the other side is not named"),
              std::string::npos)
        << result.out;
    EXPECT_EQ(result.exit_code, 0) << result.out;
}

TEST(Check, ARelationWithoutAnAlgorithmHasALineAndARowInTheCatalogue) {
    const TemporaryFolder folder;
    folder.write("o.omn",
                 "Prefix: : <urn:s#>\nPrefix: core: <https://w3id.org/partonomy/core#>\nOntology: <urn:s>\n"
                 "Import: <https://w3id.org/partonomy/core>\n"
                 "Class: :Fits SubClassOf: core:Relation\n"
                 "Class: :Box EquivalentTo: core:Region and core:hasShape some core:Cube\n"
                 "Class: :Lid EquivalentTo: core:Region and core:hasShape some core:Board and core:isTargetRegion some "
                 "(:Fits and inverse core:isReferenceRegion some :Box)\n"
                 "Class: :Crate EquivalentTo: core:Object and core:hasPart some :Lid\n");
    const std::string statement = "isTargetRegion some (Fits and (inverse (isReferenceRegion) some Box))";
    const ProgramResult check = run_partonomy({"check", "o.omn"}, folder.path());
    EXPECT_EQ(check.exit_code, 1);
    EXPECT_NE(
        check.out.find("wrong: o.omn:5: Fits has no core:criterion, so no algorithm answers \"" + statement + "\""),
        std::string::npos)
        << check.out;
    for (const std::vector<std::string>& words :
         {std::vector<std::string>{"catalogue", "o.omn"}, {"catalogue", "--ontology", "o.omn"}}) {
        const ProgramResult catalogue = run_partonomy(words, folder.path());
        EXPECT_EQ(catalogue.exit_code, 0) << catalogue.err;
        EXPECT_NE(catalogue.out.find("\nnone      " + statement), std::string::npos) << catalogue.out;
        EXPECT_NE(catalogue.out.find("\nSI        Board "), std::string::npos) << catalogue.out;
    }
}

TEST(Check, RemarksAreFew) {
    const TemporaryFolder folder;
    const ProgramResult furniture = run_partonomy({"check", furniture_path()}, folder.path());
    std::size_t remarks = 0;
    for (std::size_t i = 0; (i = furniture.out.find("remark: ", i)) != std::string::npos; ++i) ++remarks;
    EXPECT_LE(remarks, 6U) << furniture.out;
    EXPECT_NE(furniture.out.find(" more concepts may hold together with others; check --all lists them"),
              std::string::npos)
        << furniture.out;
    std::string twin = sized_jars;
    for (std::size_t at = 0; (at = twin.find("Tall", at)) != std::string::npos;) twin.replace(at, 4, "Hollow");
    folder.write("jars.omn", twin);
    const ProgramResult result = run_partonomy({"check", "jars.omn"}, folder.path());
    EXPECT_EQ(result.exit_code, 0) << result.out;
    EXPECT_NE(result.out.find("Hollow of this ontology and core:Hollow are two things of one name"), std::string::npos)
        << result.out;
}

TEST(Check, DoesNotRemarkOnWhatCannotBeAvoided) {
    const TemporaryFolder folder;
    folder.write("jars.omn", sized_jars);
    const ProgramResult result = run_partonomy({"check", "jars.omn"}, folder.path());
    EXPECT_EQ(result.exit_code, 0) << result.out;
    EXPECT_EQ(result.out.find("remark"), std::string::npos) << result.out;
    EXPECT_NE(result.out.find("of these without anything Incompatible"), std::string::npos) << result.out;
}

TEST(Check, TellsWhatIsWrittenInstead) {
    const TemporaryFolder folder;
    const auto refusal = [&](const std::string& from, const std::string& to) {
        std::string text = sized_jars;
        for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
            text.replace(at, from.size(), to);
        folder.write("jars.omn", text);
        const ProgramResult result = run_partonomy({"check", "jars.omn"}, folder.path());
        EXPECT_EQ(result.exit_code, 1);
        return result.out + result.err;
    };
    EXPECT_NE(refusal(":hasStature some :Tall", "core:Connected some :Pot")
                  .find("is written isTargetRegion some (Connected and (inverse (isReferenceRegion) some Body))"),
              std::string::npos);
    EXPECT_NE(refusal(":hasStature some :Tall", "core:extent some xsd:double[>= 0.5]").find("its numbers are area, "),
              std::string::npos);
    EXPECT_NE(refusal("extent", "heigth").find("\"top height\""), std::string::npos);
}

TEST(Check, FindingsAsJson) {
    const TemporaryFolder folder;
    const std::string start =
        "@prefix : <http://example.org/d#> .\n@prefix owl: <http://www.w3.org/2002/07/owl#> .\n"
        "@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .\n@prefix core: <https://w3id.org/partonomy/core#> .\n"
        "<http://example.org/d> a owl:Ontology ; owl:imports <https://w3id.org/partonomy/core> .\n"
        ":Leg a owl:Class ; core:colour \"#ff0000\" ; rdfs:subClassOf core:Region ; owl:equivalentClass\n"
        "  [ a owl:Restriction ; owl:onProperty core:hasShape ; owl:someValuesFrom core:Stick ] .\n"
        ":Stool a owl:Class ; rdfs:subClassOf core:Object ; owl:equivalentClass\n"
        "  [ a owl:Restriction ; owl:onProperty core:hasPart ; owl:someValuesFrom :Leg ] .\n";
    folder.write("typo.ttl", start);
    ProgramResult result = run_partonomy({"check", "typo.ttl", "--json"}, folder.path());
    EXPECT_EQ(result.exit_code, 1);
    json report = json::parse(result.out);
    EXPECT_FALSE(report.at("ok").get<bool>());
    EXPECT_EQ(report.at("findings").at(0), (json{{"kind", "unknown term"},
                                                 {"severity", "wrong"},
                                                 {"concepts", {"colour"}},
                                                 {"file", "typo.ttl"},
                                                 {"line", 6},
                                                 {"what", "core:colour is no term of the core ontology"},
                                                 {"advice", "did you mean core:color?"},
                                                 {"causes", json::array()}}));

    folder.write("torn.ttl", start +
                                 "core:Region rdfs:subClassOf :Leg .\n"
                                 ":Leg rdfs:subClassOf [ owl:complementOf :Leg ] .\n");
    result = run_partonomy({"check", "torn.ttl", "--json"}, folder.path());
    EXPECT_EQ(result.exit_code, 1);
    report = json::parse(result.out);
    const json& torn = report.at("findings").at(1);
    EXPECT_EQ(torn.at("kind"), "contradiction");
    EXPECT_EQ(torn.at("causes").at(0).size(), 2U) << torn;
    EXPECT_EQ(run_partonomy({"tree", "torn.ttl"}, folder.path()).exit_code, 1);

    folder.write("refused.ttl",
                 start +
                     ":Seat a owl:Class ; rdfs:subClassOf core:Object ;\n  owl:equivalentClass\n"
                     "  [ a owl:Restriction ; owl:onProperty core:hasShape ; owl:someValuesFrom core:Board ] .\n");
    result = run_partonomy({"check", "refused.ttl"}, folder.path());
    EXPECT_EQ(result.exit_code, 1);
    EXPECT_NE(result.out.find("wrong: refused.ttl:11: \"Seat EquivalentTo"), std::string::npos) << result.out;
}

TEST(Tree, AsksWhatAnnotateAsksWhereNoShapeIsNamed) {
    const TemporaryFolder folder;
    folder.write("jars.omn", sized_jars);
    const ProgramResult result = run_partonomy({"tree", "jars.omn", "-o", "tree.json"}, folder.path());
    EXPECT_EQ(result.exit_code, 0);
    EXPECT_NE(result.err.find("the mesh is cut into parts first"), std::string::npos) << result.err;
    EXPECT_GE(json::parse(read_file(folder.path() / "tree.json")).at("nodes").size(), 3U);
    std::string undefined = sized_jars;
    const std::string condition = " and (:hasStature some :Tall)";
    undefined.erase(undefined.find(condition), condition.size());
    folder.write("jars.omn", undefined);
    const ProgramResult empty = run_partonomy({"tree", "jars.omn", "-o", "tree.json"}, folder.path());
    EXPECT_NE(empty.err.find("the tree asks nothing: "), std::string::npos) << empty.err;
}

}  // namespace
}  // namespace partonomy
