#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "report/part_names.h"
#include "report/write.h"
#include "zoo.h"

namespace partonomy {
namespace {

std::vector<std::string> keys_of(const nlohmann::ordered_json& json) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : json.items()) keys.push_back(key);
    return keys;
}

TEST(Colors, OwnColorElsePaletteById) {
    AnnotatedPart part;
    part.color = "#0aFf10";
    EXPECT_EQ(color_of(part), (std::array<std::uint8_t, 3>{10, 255, 16}));
    for (const char* broken : {"", "red", "#12345", "#12345g", "#+12345", "0123456"}) {
        part.color = broken;
        part.id = 3;
        AnnotatedPart plain;
        plain.id = 3;
        EXPECT_EQ(color_of(part), color_of(plain)) << broken;
    }
    std::set<std::array<std::uint8_t, 3>> seen{unlabelled_color, {255, 255, 255}, {0, 0, 0}};
    part.color.clear();
    for (part.id = 1; part.id <= 18; ++part.id) EXPECT_TRUE(seen.insert(color_of(part)).second) << part.id;
    for (const int id : {0, -1, std::numeric_limits<int>::min(), std::numeric_limits<int>::max()}) {
        part.id = id;
        EXPECT_EQ(color_of(part), color_of(part));
    }
}

TEST(PartNames, NumberedOnlyWhereNeededAndAllDifferent) {
    zoo::Annotated object = zoo::bench();
    EXPECT_EQ(part_names(object.annotation), (std::vector<std::string>{"Seat", "Backrest", "Leg 1", "Leg 2"}));
    object.annotation.parts[0].concepts = {"Leg 1"};
    object.annotation.parts[1].concepts.clear();
    EXPECT_EQ(part_names(object.annotation), (std::vector<std::string>{"Leg 1", "unnamed", "Leg 1'", "Leg 2"}));
}

TEST(PartNames, OfCompositePartsAndCounted) {
    zoo::Annotated object = zoo::made_up_bench();
    EXPECT_EQ(composite_names(object.annotation), (std::vector<std::string>{"LegPair", "Back", "Top"}));
    object.annotation.composites[1].concepts = {"LegPair"};
    EXPECT_EQ(composite_names(object.annotation), (std::vector<std::string>{"LegPair 1", "LegPair 2", "Top"}));
    EXPECT_EQ(counted({"Seat", "Leg", "Leg"}), "Leg x2, Seat");
    EXPECT_EQ(counted({}), "");
}

TEST(Labels, OneLineAFaceWhateverTheNameHolds) {
    zoo::Annotated object = zoo::broken_bench();
    object.annotation.labels[1] = "";
    object.annotation.labels[2] = "a\nb";
    const std::string text = to_labels(object.annotation);
    EXPECT_EQ(std::ranges::count(text, '\n'), 30);
    EXPECT_TRUE(text.starts_with("Seat\n-\na b\nSeat\n"));
    EXPECT_TRUE(text.ends_with("Leg\n-\n-\n-\n-\n-\n-\n"));
}

TEST(Json, HoldsWhatTheDesignPromisesInStableOrder) {
    const zoo::Annotated object = zoo::broken_bench();
    const std::string text = to_json(object.annotation);
    EXPECT_EQ(text, to_json(object.annotation));
    const auto json = nlohmann::ordered_json::parse(text);
    EXPECT_EQ(keys_of(json),
              (std::vector<std::string>{"mesh", "ontology", "strategy", "object", "parts", "composites", "questions",
                                        "trace", "knowledge", "diagnosis", "open_questions", "timings_ms"}));
    EXPECT_EQ(json["mesh"]["file"], "bench.off");
    EXPECT_EQ(json["mesh"]["sha256"], std::string(64, 'a'));
    EXPECT_EQ(json["mesh"]["faces"], 30);
    EXPECT_EQ(json["ontology"]["iri"], "https://w3id.org/partonomy/furniture");
    EXPECT_EQ(json["ontology"]["sha256"], std::string(64, 'b'));
    EXPECT_EQ(json["object"]["classes"], (std::vector<std::string>{"Bench", "FootIncompatibleFurnitures"}));
    EXPECT_EQ(json["object"]["consistent"], false);
    EXPECT_EQ(json["object"]["score"], 0.9);
    ASSERT_EQ(json["parts"].size(), 4U);
    const auto& seat = json["parts"][0];
    EXPECT_EQ(keys_of(seat), (std::vector<std::string>{"id", "concepts", "faces", "triangles", "area", "score",
                                                       "features", "measurements", "color"}));
    EXPECT_EQ(seat["id"], 1);
    EXPECT_EQ(seat["concepts"], (std::vector<std::string>{"Seat", "Support"}));
    EXPECT_EQ(seat["faces"], 6);
    EXPECT_EQ(seat["features"]["Shape"], "Board");
    EXPECT_EQ(seat["measurements"]["thickness"], 0.05);
    EXPECT_EQ(seat["color"], "#4e79a7");
    EXPECT_EQ(json["questions"], (nlohmann::ordered_json{{"SF", 1}, {"SI", 2}, {"T", 0}, {"TF", 0}, {"read_off", 0}}));
    ASSERT_EQ(json["trace"].size(), 2U);
    EXPECT_EQ(json["trace"][0]["question"], "find all Board in the mesh");
    EXPECT_EQ(json["trace"][0]["region"], "mesh");
    EXPECT_EQ(json["trace"][0]["answer"], "4 regions");
    EXPECT_EQ(json["trace"][0]["inferred"][0], "part 1 is a Seat");
    EXPECT_EQ(json["trace"][1]["inferred"], nlohmann::ordered_json::array());
    EXPECT_EQ(json["trace"][1]["ms"], 0.02);
    ASSERT_EQ(json["diagnosis"].size(), 1U);
    EXPECT_EQ(json["diagnosis"][0]["concept"], "FootIncompatibleFurnitures");
    EXPECT_EQ(json["diagnosis"][0]["parts"], (std::vector<int>{4}));
    EXPECT_EQ(json["diagnosis"][0]["corrections"].size(), 2U);
    EXPECT_TRUE(json["diagnosis"][0].contains("axioms"));
    EXPECT_EQ(keys_of(json["timings_ms"]), (std::vector<std::string>{"read", "ask"}));
}

TEST(Json, StaysValidForTheEmptyAndTheAwkward) {
    const auto empty = nlohmann::json::parse(to_json(Annotation{}));
    EXPECT_TRUE(empty["parts"].is_array());
    EXPECT_TRUE(empty["timings_ms"].is_object());
    EXPECT_EQ(empty["questions"]["TF"], 0);
    Annotation annotation;
    annotation.mesh_file = "caf\xE9 \"x\"\n.off";  // Latin-1, not UTF-8
    annotation.score = std::nan("");
    annotation.parts.resize(1);
    annotation.parts[0].area = std::numeric_limits<double>::infinity();
    const auto json = nlohmann::json::parse(to_json(annotation));
    EXPECT_EQ(json["mesh"]["file"], "caf\xEF\xBF\xBD \"x\"\n.off");
    EXPECT_TRUE(json["object"]["score"].is_null());
    EXPECT_TRUE(json["parts"][0]["area"].is_null());
    EXPECT_TRUE(json["parts"][0]["features"].is_object());
}

TEST(Trace, TellsQuestionsConclusionPartsAndDiagnosis) {
    const std::string text = to_trace(zoo::broken_bench().annotation);
    std::size_t from = 0;
    for (const char* piece : {"bench.off, 30 faces, up z, unit m",
                              "Questions (SF 1, SI 2)",
                              "1  SF ",
                              "find all Board in the mesh",
                              "4 regions",
                              "0.98",
                              "=> part 1 is a Seat",
                              "2  SI ",
                              "is part 2 Vertical",
                              "yes",
                              "1.00",
                              "Conclusion: Bench, FootIncompatibleFurnitures, score 0.90, INCOMPATIBLE",
                              "Parts\n",
                              "Seat",
                              "Support",
                              "Orientation=Horizontal Shape=Board",
                              "length=1.2",
                              "Backrest",
                              "Leg",
                              "Diagnosis\n",
                              "FootIncompatibleFurnitures, because of part 4 (Leg)",
                              "part 4 is a Board",
                              "furniture.ttl:120",
                              "1. part 4 is a Stick",
                              "2. part 4 does not exist",
                              "Still open\n",
                              "Modular",
                              "Timings\n",
                              "1.50 ms"}) {
        const std::size_t found = text.find(piece, from);
        EXPECT_NE(found, std::string::npos) << piece << " is missing, or not in order, in\n" << text;
        if (found != std::string::npos) from = found;
    }
    EXPECT_EQ(text.find(" \n"), std::string::npos) << "blanks at the end of a line";
}

TEST(Trace, TellsWhatCompositePartsAreMadeOf) {
    const std::string trace = to_trace(zoo::made_up_bench().annotation);
    EXPECT_NE(trace.find("\nComposite parts\n"
                         "  LegPair: part 3 (Leg), part 4 (Leg)\n"
                         "  Back: part 2 (Backrest)\n"
                         "  Top, also Upper: part 1 (Seat), part 2 (Backrest)\n"),
              std::string::npos)
        << trace;
}

TEST(Trace, OfNothing) {
    const std::string text = to_trace(Annotation{});
    EXPECT_NE(text.find("none was asked"), std::string::npos);
    EXPECT_NE(text.find("not recognised"), std::string::npos);
    EXPECT_EQ(text.find("Diagnosis"), std::string::npos);
}

}  // namespace
}  // namespace partonomy
