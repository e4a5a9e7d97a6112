// Answers are likelihoods: where borderline answers about one region contradict each other, the least certain one is
// left out, and the trace says so. What contradicts the axioms for sure is a contradiction.

#include <gtest/gtest.h>

#include <algorithm>

#include "examples/solid.h"
#include "expert/annotate.h"

namespace partonomy {
namespace {

/// What is stretched is a stick: true of everything well above 2, and of nothing in between.
const char* const ontology = R"(
Prefix: : <urn:doubts#>
Prefix: core: <https://w3id.org/partonomy/core#>
Prefix: owl: <http://www.w3.org/2002/07/owl#>
Ontology: <urn:doubts>
 Import: <https://w3id.org/partonomy/core>
AnnotationProperty: core:criterion
AnnotationProperty: core:cost
Class: :Reach SubClassOf: core:Feature DisjointUnionOf: :Stretched, :Stocky
ObjectProperty: :hasReach SubPropertyOf: core:hasFeature Characteristics: Functional Domain: core:Region Range: :Reach
Class: :Stretched Annotations: core:criterion "l0/l1 1.2 1.7 inf inf", core:cost 0
Class: :Stocky Annotations: core:criterion "l0/l1 -inf -inf 1.2 1.7", core:cost 0
Class: core:Region SubClassOf: :hasReach some :Reach
Class: :Pole SubClassOf: core:Region EquivalentTo: core:Region and (:hasReach some :Stretched)
Class: :Post SubClassOf: core:Region EquivalentTo: core:Region and (core:hasShape some core:Stick)
Class: :Lump SubClassOf: core:Region EquivalentTo: core:Region and (core:hasShape some core:Cube)
Class: :Rod SubClassOf: core:Object EquivalentTo: core:Object and (core:hasPart some :Post)
Class: :Pole SubClassOf: :Post
)";

Annotation annotate_bar(double length) {
    Solid solid;
    solid.begin_part("Bar");
    solid.prism({solid.at(0, 0, 0), solid.at(length, 0, 0), solid.at(length, 1, 0), solid.at(0, 1, 0)}, 1);
    const knowledge::Domain domain = knowledge::compile(owl::parse_ontology(ontology, "doubts.omn"));
    return annotate(domain, make_catalogue(domain), make_object(std::move(solid).finish("bar", "Rod").mesh, {}), {});
}

std::size_t left_out(const Annotation& annotation) {
    std::size_t count = 0;
    for (const TraceEntry& entry : annotation.trace)
        count += static_cast<std::size_t>(std::ranges::count_if(
            entry.inferred, [](const std::string& text) { return text.starts_with("left out: "); }));
    return count;
}

TEST(Doubts, TheLeastCertainAnswerGivesWay) {
    const Annotation annotation = annotate_bar(1.8);  // stretched 1, cube 0.7, stick 0.3
    ASSERT_EQ(annotation.parts.size(), 1U);
    EXPECT_TRUE(annotation.consistent);
    EXPECT_EQ(annotation.parts[0].concepts.front(), "Pole");
    EXPECT_EQ(left_out(annotation), 1U);
}

TEST(Doubts, WhatAgreesIsLeftAlone) {
    for (const double length : {1.0, 3.0}) {
        const Annotation annotation = annotate_bar(length);
        EXPECT_TRUE(annotation.consistent);
        EXPECT_EQ(left_out(annotation), 0U);
        EXPECT_EQ(annotation.parts[0].concepts.front(), length > 2 ? "Pole" : "Lump");
    }
}

TEST(Doubts, WhatContradictsForSureIsTold) {
    const Annotation annotation = annotate_bar(1.6);  // stretched 0.8, cube 0.9: neither is borderline
    EXPECT_FALSE(annotation.consistent);
    EXPECT_EQ(left_out(annotation), 0U);
}

}  // namespace
}  // namespace partonomy
