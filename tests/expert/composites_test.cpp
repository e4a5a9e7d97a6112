/* Composite parts through the whole program: an ontology that adds a layer to furniture.ttl, and a mesh with a
 * headrest.
 */

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "algorithms/relations.h"
#include "examples/objects.h"
#include "expert/furniture.h"
#include "report/write.h"

namespace partonomy {
namespace {

using Names = std::vector<std::string>;

/// furniture-headrest.omn, which imports furniture.ttl.
struct WithHeadrest {
    knowledge::Domain domain =
        knowledge::compile(owl::load_ontology(PARTONOMY_SOURCE_DIR "/ontologies/furniture-headrest.omn"));
    Catalogue catalogue = make_catalogue(domain);
    static const WithHeadrest& get() {
        static const WithHeadrest ontology;
        return ontology;
    }
    [[nodiscard]] Annotation annotate(const TriangleMesh& mesh, const AnnotateOptions& options = {}) const {
        return partonomy::annotate(domain, catalogue, make_object(mesh, {}), options);
    }
};

std::set<int> parts_with(const Annotation& annotation, const std::set<std::string>& names) {
    std::set<int> ids;
    for (const AnnotatedPart& part : annotation.parts)
        if (!part.concepts.empty() && names.contains(part.concepts.front())) ids.insert(part.id);
    return ids;
}

TEST(CompositeParts, ABackWithItsHeadrest) {
    for (const Strategy strategy : {Strategy::expert, Strategy::naive, Strategy::segment_then_identify}) {
        const ExampleObject object = headrest_chair();
        const Annotation annotation = WithHeadrest::get().annotate(object.mesh, {strategy, {}});
        EXPECT_EQ(annotation.classes, Names{object.object_class});
        EXPECT_TRUE(annotation.consistent);
        EXPECT_EQ(annotation.labels, object.labels);
        ASSERT_EQ(annotation.composites.size(), 1U);
        EXPECT_EQ(annotation.composites[0].concepts, (Names{"BackWithHeadrest", "Back", "BackUnit"}));
        const std::set<int> parts(annotation.composites[0].parts.begin(), annotation.composites[0].parts.end());
        EXPECT_EQ(parts, parts_with(annotation, {"BackPanel", "Headrest", "BackPost"}));
        EXPECT_EQ(parts.size(), 6U);
        EXPECT_EQ(annotation.questions.at("TF"), 1);
        EXPECT_EQ(std::ranges::count(annotation.trace, "TF", &TraceEntry::kind), 1);
        EXPECT_NE(to_json(annotation).find("\"BackWithHeadrest\""), std::string::npos);
    }
}

TEST(CompositeParts, WithoutTheLayerItIsAChair) {
    const ExampleObject object = headrest_chair();
    const Annotation annotation = Furniture::get().annotate(object.mesh);
    EXPECT_EQ(annotation.classes, Names{"Chair"});
    EXPECT_TRUE(annotation.composites.empty());
    EXPECT_EQ(annotation.questions.at("TF"), 0);
}

TEST(CompositeParts, TheLayerLeavesOtherObjectsAsTheyAre) {
    for (const ExampleObject& object : paper_objects()) {
        SCOPED_TRACE(object.name);
        const Annotation with = WithHeadrest::get().annotate(object.mesh);
        const Annotation without = Furniture::get().annotate(object.mesh);
        EXPECT_EQ(with.all_classes, without.all_classes);
        EXPECT_EQ(with.consistent, without.consistent);
        ASSERT_EQ(with.composites.size(), object.name == "curved-bench" ? 14U : 1U);  // its slats stand apart
        for (const AnnotatedComposite& composite : with.composites) EXPECT_EQ(composite.concepts.front(), "Back");
    }
}

TEST(CompositeParts, HeadrestWithoutBackrestIsImpossible) {
    const ExampleObject object = headrest_chair(false);
    const Annotation annotation = WithHeadrest::get().annotate(object.mesh);
    EXPECT_EQ(annotation.classes, Names{"Chair"});
    EXPECT_FALSE(annotation.consistent);
    ASSERT_EQ(annotation.diagnosis.size(), 1U);
    const Diagnosis& diagnosis = annotation.diagnosis[0];
    EXPECT_EQ(diagnosis.concept_name, "HeadrestWithoutBackrest");
    EXPECT_EQ(std::set(diagnosis.parts.begin(), diagnosis.parts.end()),
              parts_with(annotation, {"Headrest", "BackPost"}));
    EXPECT_TRUE(std::ranges::any_of(diagnosis.axioms, [](const std::string& axiom) {
        return axiom.starts_with("HeadrestWithoutBackrest EquivalentTo") &&
               axiom.find("furniture-headrest.omn") != std::string::npos;
    }));
    EXPECT_FALSE(diagnosis.corrections.empty());
}

TEST(CompositeParts, PartsOfSeveralShellsTouchWhereTheyMeet) {
    ExampleObject object = headrest_chair();  // each part a shell of its own
    TriangleMesh apart = object.mesh;
    std::vector<Vec3> positions;
    for (std::size_t t = 0; t < apart.triangles.size(); ++t)
        for (std::int32_t& v : apart.triangles[t]) {
            positions.push_back(object.mesh.positions[static_cast<std::size_t>(v)]);
            v = static_cast<std::int32_t>(positions.size()) - 1;
        }
    apart.positions = std::move(positions);
    const Object whole = make_object(object.mesh, {}), pieces = [&] {
        Object result = make_object(object.mesh, {});
        result.mesh = apart;
        return result;
    }();
    for (const PartRegion& a : whole.candidates)
        for (const PartRegion& b : whole.candidates) {
            if (&a == &b) continue;
            const auto touch = [&](const Object& in) {
                const Scene scene = scene_of(in);
                const RegionPlace x = place_of(scene, a), y = place_of(scene, b);
                return relation_score(std::span(&touching(), 1), scene, std::array{&x, &y}).value();
            };
            EXPECT_EQ(touch(whole) >= 0.5, touch(pieces) >= 0.5);
        }
}

}  // namespace
}  // namespace partonomy
