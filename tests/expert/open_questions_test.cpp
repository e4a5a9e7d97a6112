// What cannot be measured stays open, and what hangs on it is told as open: a sheet without thickness is neither solid
// nor hollow, and an object without a unit no length.

#include <gtest/gtest.h>

#include <algorithm>

#include "examples/solid.h"
#include "expert/annotate.h"
#include "report/write.h"

namespace partonomy {
namespace {

const char* const head =
    "Prefix: : <urn:signs#>\nPrefix: core: <https://w3id.org/partonomy/core#>\n"
    "Prefix: xsd: <http://www.w3.org/2001/XMLSchema#>\n"
    "Ontology: <urn:signs>\n Import: <https://w3id.org/partonomy/core>\n"
    "DataProperty: core:length\n"
    "Class: :Plate SubClassOf: core:Region EquivalentTo: core:Region and (core:hasShape some core:Board) and "
    "(core:hasHollowness some core:Hollow) and (core:length some xsd:double[>= 1.0])\n";

const std::string blanks = std::string(head) +
                           "Class: :Label SubClassOf: core:Region EquivalentTo: core:Region and (core:hasShape some "
                           "core:Board) and (not :Plate)\n"
                           "Class: :Sign SubClassOf: core:Object EquivalentTo: core:Object and (core:hasPart some "
                           "(core:hasShape some core:Board))\n"
                           "Class: :Blank SubClassOf: core:Incompatible EquivalentTo: core:Object and (core:hasPart "
                           "some :Label)\n";

const std::string badges = std::string(head) +
                           "Class: :Cover SubClassOf: core:Region EquivalentTo: core:Region and (core:hasShape some "
                           "core:Board)\n"
                           "Class: :Badge SubClassOf: core:CompositePart EquivalentTo: core:CompositePart and "
                           "(core:hasPart some :Plate)\n"
                           "Class: :Sign SubClassOf: core:Object EquivalentTo: core:Object and (core:hasPart some "
                           ":Badge)\n";

/// A square of 2 m, as a sheet or of some thickness.
Annotation annotate_square(const std::string& ontology, double thickness, bool has_unit) {
    Solid solid;
    solid.begin_part("Plate");
    std::vector<Solid::Vertex> base{solid.at(0, 0, 0), solid.at(2, 0, 0), solid.at(2, 2, 0), solid.at(0, 2, 0)};
    if (thickness > 0) {
        solid.face(base, true);
        solid.prism(base, thickness);
    } else {
        solid.face(base);
    }
    const ExampleObject square = std::move(solid).finish("square", "Sign");
    const knowledge::Domain domain = knowledge::compile(owl::parse_ontology(ontology, "signs.omn"));
    Placement placement;
    if (!has_unit) placement.metres_per_unit.reset();
    return annotate(domain, make_catalogue(domain), make_object(square.mesh, placement), {});
}

bool has(const std::vector<std::string>& lines, const std::string& text) {
    return std::ranges::any_of(lines, [&](const std::string& line) { return line.find(text) != std::string::npos; });
}

TEST(OpenQuestions, WhatRestsOnAnAssumptionIsNotProven) {
    const Annotation annotation = annotate_square(blanks, 0, false);
    ASSERT_EQ(annotation.parts.size(), 1U);
    EXPECT_EQ(annotation.parts[0].concepts, std::vector<std::string>{"Label"});
    EXPECT_EQ(annotation.classes, std::vector<std::string>{"Sign"});
    EXPECT_EQ(annotation.perhaps, std::vector<std::string>{"Blank"});
    EXPECT_TRUE(annotation.consistent);
    EXPECT_TRUE(annotation.diagnosis.empty());
    const std::string all = testing::PrintToString(annotation.open_questions);
    EXPECT_TRUE(has(annotation.open_questions, "perhaps Blank, if part 1 is a Label")) << all;
    EXPECT_TRUE(has(annotation.open_questions, "part 1 is assumed to be a Label: ")) << all;
    EXPECT_TRUE(has(annotation.open_questions, "its Hollowness cannot be measured, since it is a sheet")) << all;
    EXPECT_TRUE(has(annotation.open_questions, "its length cannot be measured while the unit is unknown")) << all;
    EXPECT_NE(to_json(annotation).find("\"perhaps\": [\n"), std::string::npos);
}

TEST(OpenQuestions, WhatIsProvenIsIncompatible) {
    const Annotation annotation = annotate_square(blanks, 0.05, true);
    EXPECT_EQ(annotation.classes, (std::vector<std::string>{"Blank", "Sign"}));
    EXPECT_TRUE(annotation.perhaps.empty());
    EXPECT_FALSE(annotation.consistent);
    ASSERT_EQ(annotation.diagnosis.size(), 1U);
    EXPECT_EQ(annotation.diagnosis[0].concept_name, "Blank");
}

TEST(OpenQuestions, ACompositePartThatThereMayBeIsTold) {
    const Annotation annotation = annotate_square(badges, 0, true);
    EXPECT_TRUE(annotation.composites.empty());
    EXPECT_TRUE(has(annotation.open_questions, "Badge: open, because part 1 may be a Plate"))
        << testing::PrintToString(annotation.open_questions);
    const Annotation thick = annotate_square(badges, 0.05, true);
    EXPECT_FALSE(has(thick.open_questions, "Badge")) << testing::PrintToString(thick.open_questions);
}

/// What can be measured of a sheet is asked, though some of what it might be called by cannot.
TEST(OpenQuestions, OneThatCannotBeAnsweredLeavesTheOthers) {
    std::string text =
        "Prefix: : <urn:sheets#>\nPrefix: core: <https://w3id.org/partonomy/core#>\n"
        "Ontology: <urn:sheets>\n Import: <https://w3id.org/partonomy/core>\n"
        "Class: :Some SubClassOf: core:Object EquivalentTo: core:Object and (core:hasPart some "
        "core:Region)\n";
    const std::vector<std::pair<std::string, std::string>> words{
        {"Hollowness", "Hollow"}, {"Hollowness", "Solid"}, {"Section", "Angular"},       {"Orientation", "Horizontal"},
        {"Taper", "Even"},        {"Bend", "Straight"},    {"SurfaceType", "Rectangle"}, {"Slope", "Level"}};
    for (const auto& [range, word] : words)
        text += "Class: :A" + word + " EquivalentTo: core:Region and (core:has" + range + " some core:" + word + ")\n";
    const Annotation annotation = annotate_square(text, 0, true);
    ASSERT_EQ(annotation.parts.size(), 1U);
    std::vector<std::string> concepts = annotation.parts[0].concepts;
    std::ranges::sort(concepts);
    EXPECT_EQ(concepts,
              (std::vector<std::string>{"AAngular", "AEven", "AHorizontal", "ALevel", "ARectangle", "AStraight"}));
}

}  // namespace
}  // namespace partonomy
