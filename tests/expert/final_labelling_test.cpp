/* Final labelling: the ontology mends the cut. The truth of every shape is known by construction. */

#include "expert/final_labelling.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <set>

#include "examples/blocks.h"
#include "expert/furniture.h"
#include "report/write.h"
#include "shape/part_box.h"
#include "shape/solids.h"

namespace partonomy {
namespace {

const std::string head = R"(
Prefix: : <http://example.org/t#>
Prefix: core: <https://w3id.org/partonomy/core#>
Prefix: owl: <http://www.w3.org/2002/07/owl#>
Ontology: <http://example.org/t>
    Import: <https://w3id.org/partonomy/core>
Class: :Top
    EquivalentTo: core:Region and (core:hasShape some core:Board) and (core:hasPosition some core:Up)
Class: :Leg
    EquivalentTo: core:Region and (core:hasShape some core:Stick) and (core:hasPosition some core:Down)
Class: :Table
    EquivalentTo: core:Object and (core:hasPart some :Top) and (core:hasPart min 3 :Leg)
)";
const std::string with_collars = head + R"(
Class: :Collar
    EquivalentTo: core:Region and (core:hasShape some core:Cube) and (not (core:hasPosition some core:Down))
)";

struct Domain {
    explicit Domain(const std::string& text)
        : domain(knowledge::compile(owl::parse_ontology(text, "table.omn"))), catalogue(make_catalogue(domain)) {}
    knowledge::Domain domain;
    Catalogue catalogue;
};

/// A top on four legs, each with a collar twice as thick as the leg below the top; one closed surface.
ExampleObject table_with_collars() {
    Shape shape;
    shape.blocks.push_back({Vec3(0, 0, 0.6), Vec3(1.2, 1.2, 0.65), "Top", 0});
    int part = 1;
    for (const double x : {0.15, 0.95})
        for (const double y : {0.15, 0.95}) {
            shape.blocks.push_back({Vec3(x, y, 0.5), Vec3(x + 0.1, y + 0.1, 0.6), "Collar", part++});
            shape.blocks.push_back({Vec3(x + 0.025, y + 0.025, 0), Vec3(x + 0.075, y + 0.075, 0.5), "Leg", part++});
        }
    ShapeScene scene;
    scene.shapes.push_back(shape);
    return scene.mesh(0.025);
}

std::map<std::string, int> counts(const Annotation& annotation) {
    std::map<std::string, int> count;
    for (const AnnotatedPart& part : annotation.parts) ++count[part.concepts.empty() ? "-" : part.concepts.front()];
    return count;
}

bool is_mended(const Annotation& annotation) {
    return std::ranges::count(annotation.trace, "FL", &TraceEntry::kind) > 0;
}

double share_right(const ExampleObject& object, const Annotation& annotation, const std::string& collar) {
    const TriangleGeometry geometry = compute_geometry(object.mesh);
    double right = 0, all = 0;
    for (std::size_t t = 0; t < geometry.areas.size(); ++t) {
        all += geometry.areas[t];
        const std::string& truth = object.labels[t] == "Collar" ? collar : object.labels[t];
        if (annotation.labels[t] == truth) right += geometry.areas[t];
    }
    return right / all;
}

/// Whether the triangles of each part hang together over edges.
void expect_connected(const TriangleMesh& mesh, const Annotation& annotation) {
    const Adjacency adjacency = build_adjacency(mesh);
    for (const AnnotatedPart& part : annotation.parts) {
        const std::set<std::int32_t> own(part.triangles.begin(), part.triangles.end());
        std::set<std::int32_t> reached{part.triangles.front()};
        std::vector<std::int32_t> queue{part.triangles.front()};
        for (std::size_t at = 0; at < queue.size(); ++at)
            for (const std::int32_t n : adjacency.neighbours[static_cast<std::size_t>(queue[at])])
                if (own.contains(n) && reached.insert(n).second) queue.push_back(n);
        EXPECT_EQ(reached.size(), own.size()) << "part " << part.id;
    }
}

TEST(FinalLabelling, TheOntologyDecidesWhetherACollarIsAPart) {
    const ExampleObject table = table_with_collars();
    const Object object = make_object(table.mesh, {});
    const Domain plain(head), collars(with_collars);
    const Annotation apart = annotate(collars.domain, collars.catalogue, object);
    EXPECT_EQ(counts(apart), (std::map<std::string, int>{{"Top", 1}, {"Leg", 4}, {"Collar", 4}}));
    EXPECT_FALSE(is_mended(apart));
    EXPECT_GT(share_right(table, apart, "Collar"), 0.99);
    const Annotation joined = annotate(plain.domain, plain.catalogue, object);
    EXPECT_EQ(counts(joined), (std::map<std::string, int>{{"Top", 1}, {"Leg", 4}}));
    EXPECT_TRUE(is_mended(joined));
    EXPECT_GT(share_right(table, joined, "Leg"), 0.99);
    EXPECT_EQ(joined.classes, std::vector<std::string>{"Table"});
    expect_connected(table.mesh, joined);
    AnnotateOptions as_cut;
    as_cut.mend = false;
    EXPECT_EQ(counts(annotate(plain.domain, plain.catalogue, object, as_cut)),
              (std::map<std::string, int>{{"Top", 1}, {"Leg", 4}, {"-", 4}}));
}

TEST(FinalLabelling, WordsOfOnesOwnInsteadOfShapesServeAsWell) {
    const Domain own(R"(
Prefix: : <http://example.org/t#>
Prefix: core: <https://w3id.org/partonomy/core#>
Prefix: owl: <http://www.w3.org/2002/07/owl#>
Prefix: xsd: <http://www.w3.org/2001/XMLSchema#>
Ontology: <http://example.org/t>
    Import: <https://w3id.org/partonomy/core>
Class: :Build
    SubClassOf: core:Feature
    DisjointUnionOf: :Slim, :Broad
Class: :Slim
    Annotations: core:measure "l1/l0", core:membership "-inf -inf 0.3 0.5", core:question "is it slim"
Class: :Broad
    Annotations: core:measure "l1/l0", core:membership "0.3 0.5 inf inf", core:question "is it broad"
ObjectProperty: :hasBuild
    Characteristics: Functional
    Range: :Build
Class: :Top
    EquivalentTo: core:Region and (:hasBuild some :Broad) and (core:length some xsd:double[>= 0.5])
Class: :Leg
    EquivalentTo: core:Region and (:hasBuild some :Slim) and (core:hasPosition some core:Down)
Class: :Table
    EquivalentTo: core:Object and (core:hasPart some :Top) and (core:hasPart min 3 :Leg)
)");
    const ExampleObject table = table_with_collars();
    const Annotation joined = annotate(own.domain, own.catalogue, make_object(table.mesh, {}));
    EXPECT_EQ(counts(joined), (std::map<std::string, int>{{"Top", 1}, {"Leg", 4}}));
    EXPECT_TRUE(is_mended(joined));
    EXPECT_GT(share_right(table, joined, "Leg"), 0.99);
}

TEST(FinalLabelling, ABottleThatIsNothingAsOneStickIsCutAgain) {
    const Domain bottles(R"(
Prefix: : <http://example.org/b#>
Prefix: core: <https://w3id.org/partonomy/core#>
Prefix: owl: <http://www.w3.org/2002/07/owl#>
Ontology: <http://example.org/b>
    Import: <https://w3id.org/partonomy/core>
Class: :Body
    EquivalentTo: core:Region and (core:hasTaper some core:Even) and (core:hasPosition some core:Down)
Class: :Neck
    EquivalentTo: core:Region and (not :Body) and (core:hasPosition some core:Up) and (not (core:hasPosition some core:Down))
Class: :Bottle
    EquivalentTo: core:Object and (core:hasPart exactly 1 :Body) and (core:hasPart exactly 1 :Neck)
)");
    for (const double neck : {0.4, 0.45}) {
        SCOPED_TRACE("neck " + std::to_string(neck));
        solids::Outline corners{{0, 0}, {1, 0}, {1, 3.2}, {neck, 4.1}, {neck, 5.6}, {0, 5.6}};
        solids::Outline profile = solids::polygon(corners, 0.1);
        while (profile.back().x() == 0 && profile.back().y() < 5.6) profile.pop_back();
        const TriangleMesh bottle = solids::revolve(profile, 64, true);
        ASSERT_EQ(find_parts(bottle).size(), 1U);
        const Annotation annotation = annotate(bottles.domain, bottles.catalogue, make_object(bottle, {}));
        EXPECT_EQ(counts(annotation), (std::map<std::string, int>{{"Body", 1}, {"Neck", 1}}));
        EXPECT_EQ(annotation.classes, std::vector<std::string>{"Bottle"});
    }
}

TEST(FinalLabelling, IsTheSameOnTwoThreadsAndCountsWhatItAsked) {
    const ExampleObject table = table_with_collars();
    const Object object = make_object(table.mesh, {});
    const Domain plain(head);
    AnnotateOptions one, two;
    two.threads = 2;
    Annotation a = annotate(plain.domain, plain.catalogue, object, one);
    Annotation b = annotate(plain.domain, plain.catalogue, object, two);
    EXPECT_EQ(a.part_of_face, b.part_of_face);
    EXPECT_EQ(a.labels, b.labels);
    EXPECT_EQ(a.questions, b.questions);
    AnnotateOptions as_cut;
    as_cut.mend = false;
    const Annotation before = annotate(plain.domain, plain.catalogue, object, as_cut);
    EXPECT_GT(a.questions.at("SI"), before.questions.at("SI"));
    const auto edits = std::ranges::find(a.trace, "FL", &TraceEntry::kind);
    ASSERT_NE(edits, a.trace.end());
    EXPECT_NE(edits->inferred.front().find("took in a piece without a name"), std::string::npos);
}

TEST(FinalLabelling, WhatIsNoPartIsCutAgain) {
    const ExampleObject table = table_with_collars();
    Object object = make_object(table.mesh, {});
    std::vector<std::int32_t> all(table.mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    PartBox box = measure_part(object.mesh, object.geometry, all, false);
    object.candidates = {{{std::move(all), std::move(box.memberships)}, box.box, box.fit}};
    for (const auto& [text, collars] : {std::pair{with_collars, "Collar"}, std::pair{head, "Leg"}}) {
        const Domain domain(text);
        const Annotation annotation = annotate(domain.domain, domain.catalogue, object);
        EXPECT_EQ(annotation.classes, std::vector<std::string>{"Table"});
        EXPECT_GT(share_right(table, annotation, collars), 0.98) << collars;
        expect_connected(table.mesh, annotation);
    }
}

class RightCut : public testing::TestWithParam<const char*> {};

TEST_P(RightCut, StaysAsItIs) {
    const Annotation annotation = Furniture::get().annotate(paper_object(GetParam()).mesh);
    EXPECT_FALSE(is_mended(annotation));
    EXPECT_EQ(annotation.labels, paper_object(GetParam()).labels);
}

INSTANTIATE_TEST_SUITE_P(Paper, RightCut, paper_object_names, [](const auto& name) {
    std::string word = name.param;
    std::erase(word, '-');
    return word;
});

/// A body that is nothing the ontology knows, with a bar at its side, in one closed surface: as a whole it would be
/// called what the bar is.
TEST(FinalLabelling, AHandleDoesNotSwallowAMuchLargerBody) {
    const Domain mugs(R"(
Prefix: : <http://example.org/m#>
Prefix: core: <https://w3id.org/partonomy/core#>
Prefix: owl: <http://www.w3.org/2002/07/owl#>
Ontology: <http://example.org/m>
    Import: <https://w3id.org/partonomy/core>
Class: :Wall
    EquivalentTo: core:Region and (core:hasHollowness some core:Hollow)
Class: :Reach
    SubClassOf: core:Feature
    DisjointUnionOf: :Long, :Short
Class: :Long
    Annotations: core:measure "l0/l1", core:membership "1.08 1.12 inf inf"
Class: :Short
    Annotations: core:measure "l0/l1", core:membership "-inf -inf 1.08 1.12"
ObjectProperty: :hasReach
    Characteristics: Functional
    Range: :Reach
Class: :Handle
    EquivalentTo: core:Region and (:hasReach some :Long)
Class: :Mug
    EquivalentTo: core:Object and (core:hasPart some :Wall) and (core:hasPart some :Handle)
)");
    Shape shape;
    shape.blocks.push_back({Vec3(0, 0, 0), Vec3(1, 1, 1), "-", 0});
    shape.blocks.push_back({Vec3(1, 0.4, 0.2), Vec3(1.2, 0.6, 0.8), "Handle", 1});
    ShapeScene scene;
    scene.shapes.push_back(shape);
    const ExampleObject mug = scene.mesh(0.05);
    const Annotation annotation = annotate(mugs.domain, mugs.catalogue, make_object(mug.mesh, {}));
    EXPECT_GT(share_right(mug, annotation, ""), 0.95);
    ASSERT_FALSE(annotation.nearest.empty());
    EXPECT_EQ(annotation.nearest.front().concept_name, "Mug");
    EXPECT_EQ(annotation.nearest.front().lacks, std::vector<std::string>{"1 Wall"});
}

}  // namespace
}  // namespace partonomy
