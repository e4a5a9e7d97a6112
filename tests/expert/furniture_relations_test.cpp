/* furniture-relations.omn, a layer on top of furniture.ttl: parts must be where they serve. An armchair made by code,
 * and the same with one part in a wrong place. */

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "examples/solid.h"
#include "examples/transforms.h"
#include "expert/furniture.h"

namespace partonomy {
namespace {

using Names = std::vector<std::string>;

struct WithRelations {
    knowledge::Domain domain =
        knowledge::compile(owl::load_ontology(PARTONOMY_SOURCE_DIR "/ontologies/furniture-relations.omn"));
    Catalogue catalogue = make_catalogue(domain);
    [[nodiscard]] Annotation annotate(const TriangleMesh& mesh) const {
        return partonomy::annotate(domain, catalogue, make_object(mesh, {}));
    }
    static const WithRelations& get() {
        static const WithRelations ontology;
        return ontology;
    }
};

void add_box(Solid& solid, const std::string& part, const Vec3& low, const Vec3& high) {
    solid.begin_part(part);
    const std::vector<Solid::Vertex> base{solid.at(low.x(), low.y(), low.z()), solid.at(high.x(), low.y(), low.z()),
                                          solid.at(high.x(), high.y(), low.z()), solid.at(low.x(), high.y(), low.z())};
    solid.face(base, true);
    solid.prism(base, high.z());
}

/// Each part a box of its own; the labels are what a good armchair's parts are, whatever is wrong with them.
ExampleObject armchair(const std::string& wrong = {}) {
    Solid solid;
    add_box(solid, "Seat", {0, 0, 0.40}, {0.5, 0.5, 0.44});
    for (const double x : {0.0, 0.46})
        for (const double y : {0.0, 0.46}) {
            const double aside = wrong == "LegAwayFromSeat" && x > 0 && y > 0 ? 1 : 0;
            add_box(solid, aside > 0 ? "wrong" : "Leg", {x + aside, y, 0}, {x + 0.04 + aside, y + 0.04, 0.40});
        }
    const bool is_low = wrong == "BackrestNotAboveSeat";
    add_box(solid, is_low ? "wrong" : "Backrest", {0, is_low ? 1.6 : 0.46, 0.52}, {0.5, is_low ? 1.64 : 0.5, 0.92});
    for (const double x : {-0.06, 0.52}) {
        const bool is_wrong = wrong == "ArmrestNotBesideSeat" && x > 0;
        const double aside = is_wrong ? 0.4 : 0;
        add_box(solid, is_wrong ? "wrong" : "Armrest", {x + aside, 0.06, 0.44}, {x + aside + 0.04, 0.44, 0.66});
    }
    return std::move(solid).finish("armchair", "Armchair", wrong);
}

/// True labels of the parts that the first diagnosis blames.
std::set<std::string> blamed(const ExampleObject& object, const Annotation& annotation) {
    std::set<std::string> labels;
    for (const int id : annotation.diagnosis.at(0).parts)
        for (const std::int32_t t : annotation.parts.at(static_cast<std::size_t>(id - 1)).triangles)
            labels.insert(object.labels[static_cast<std::size_t>(t)]);
    return labels;
}

TEST(FurnitureRelations, AGoodArmchair) {
    for (const double degrees : {0.0, 33.0}) {
        const ExampleObject object = rotated_about_z(armchair(), degrees);
        const Annotation annotation = WithRelations::get().annotate(object.mesh);
        EXPECT_EQ(annotation.classes, Names{"Armchair"});
        EXPECT_TRUE(annotation.consistent);
        const std::map<std::string, std::string> names{
            {"Seat", "Seat"}, {"Leg", "StandingLeg"}, {"Backrest", "RaisedBackrest"}, {"Armrest", "SideArmrest"}};
        for (std::size_t t = 0; t < object.labels.size(); ++t)
            EXPECT_EQ(annotation.labels[t], names.at(object.labels[t])) << t;
    }
}

TEST(FurnitureRelations, StretchersNeedNotStand) {
    Solid solid;
    add_box(solid, "Seat", {0, 0, 0.40}, {0.5, 0.5, 0.44});
    for (const double x : {0.0, 0.46}) {
        for (const double y : {0.0, 0.46}) add_box(solid, "Leg", {x, y, 0}, {x + 0.04, y + 0.04, 0.40});
        add_box(solid, "Leg", {x + 0.01, 0.04, 0.15}, {x + 0.03, 0.46, 0.17});
    }
    add_box(solid, "Backrest", {0, 0.46, 0.52}, {0.5, 0.5, 0.92});
    const ExampleObject object = std::move(solid).finish("chair", "Chair", {});
    const Annotation annotation = WithRelations::get().annotate(object.mesh);
    EXPECT_EQ(annotation.classes, Names{"Chair"});
    EXPECT_TRUE(annotation.consistent);
}

TEST(FurnitureRelations, APartInAWrongPlaceIsBlamed) {
    for (const std::string wrong : {"LegAwayFromSeat", "BackrestNotAboveSeat", "ArmrestNotBesideSeat"})
        for (const double degrees : {0.0, 33.0}) {
            SCOPED_TRACE(wrong);
            const ExampleObject object = rotated_about_z(armchair(wrong), degrees);
            const Annotation annotation = WithRelations::get().annotate(object.mesh);
            EXPECT_FALSE(annotation.consistent);
            ASSERT_EQ(annotation.diagnosis.size(), 1U);
            EXPECT_EQ(annotation.diagnosis[0].concept_name, wrong);
            EXPECT_EQ(blamed(object, annotation), std::set<std::string>{"wrong"});
            EXPECT_FALSE(annotation.diagnosis[0].corrections.empty());
        }
}

/// The paper's objects stay what they are; what is well placed is told of each of their parts.
TEST(FurnitureRelations, TheLayerLeavesOtherObjectsAsTheyAre) {
    for (const ExampleObject& object : paper_objects()) {
        SCOPED_TRACE(object.name);
        const Annotation with = WithRelations::get().annotate(object.mesh);
        const Annotation without = Furniture::get().annotate(object.mesh);
        EXPECT_EQ(with.classes, without.classes);
        EXPECT_EQ(with.consistent, without.consistent);
    }
}

}  // namespace
}  // namespace partonomy
