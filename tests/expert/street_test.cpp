// Streets made by code (examples/street.h): every kind of element is found and named, the scene is recognised, and each
// seeded fault is found with the part to blame.

#include "examples/street.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <set>

#include "examples/transforms.h"
#include "expert/annotate.h"
#include "knowledge/domain.h"
#include "owl/ontology.h"

namespace partonomy {
namespace {

struct Recogniser {
    knowledge::Domain domain = knowledge::compile(owl::load_ontology(PARTONOMY_SOURCE_DIR "/ontologies/street.ttl"));
    Catalogue catalogue = make_catalogue(domain);
    [[nodiscard]] Annotation annotate(const TriangleMesh& mesh) const {
        return partonomy::annotate(domain, catalogue, make_object(mesh, {}, 2, domain.is_about_scenes));
    }
};

const Recogniser& recogniser() {
    static const Recogniser made;
    return made;
}

/// Share of the faces of each kind that carry its name.
std::map<std::string, double> accuracies(const ExampleObject& scene, const Annotation& annotation) {
    std::map<std::string, std::pair<int, int>> counts;
    for (std::size_t i = 0; i < scene.labels.size(); ++i) {
        auto& [right, all] = counts[scene.labels[i]];
        right += annotation.labels[i] == scene.labels[i];
        ++all;
    }
    std::map<std::string, double> result;
    for (const auto& [label, count] : counts) result[label] = static_cast<double>(count.first) / count.second;
    return result;
}

void expect_all_named(const ExampleObject& scene, const Annotation& annotation) {
    for (const auto& [label, accuracy] : accuracies(scene, annotation)) EXPECT_GE(accuracy, 0.95) << label;
    EXPECT_NE(std::ranges::find(annotation.classes, scene.object_class), annotation.classes.end());
}

/// Faults by the true label of the part to blame.
std::multiset<std::pair<std::string, std::string>> faults(const ExampleObject& scene, const Annotation& annotation) {
    std::multiset<std::pair<std::string, std::string>> result;
    for (const Diagnosis& diagnosis : annotation.diagnosis) {
        EXPECT_EQ(diagnosis.parts.size(), 1U) << diagnosis.concept_name;
        EXPECT_FALSE(diagnosis.answers.empty()) << diagnosis.concept_name;
        EXPECT_FALSE(diagnosis.axioms.empty()) << diagnosis.concept_name;
        const AnnotatedPart& part = annotation.parts[static_cast<std::size_t>(diagnosis.parts.at(0) - 1)];
        result.emplace(diagnosis.concept_name, scene.labels[static_cast<std::size_t>(part.triangles.front())]);
    }
    return result;
}

TEST(Street, EveryKindOfElementIsNamed) {
    for (const std::uint64_t seed : {1, 2, 3, 4, 5, 6}) {
        SCOPED_TRACE(seed);
        const ExampleObject scene =
            street({.seed = seed, .triangles = seed == 1 ? 200'000U : 20'000U, .has_trees = seed != 4});
        const Annotation annotation = recogniser().annotate(scene.mesh);
        expect_all_named(scene, annotation);
        EXPECT_TRUE(annotation.consistent);
    }
}

TEST(Street, CoarseMeshesAndEveryStyleOfBuilding) {
    for (const BuildingStyle style : {BuildingStyle::slabs, BuildingStyle::solid, BuildingStyle::carved}) {
        SCOPED_TRACE(static_cast<int>(style));
        const ExampleObject scene = street({.seed = 11, .triangles = 0, .buildings_a_side = 3, .style = style});
        const Annotation annotation = recogniser().annotate(scene.mesh);
        expect_all_named(scene, annotation);
        EXPECT_TRUE(annotation.consistent);
    }
}

TEST(Street, EverySeededFaultIsFoundAndNoOther) {
    const std::map<std::string, std::string> culprits = {{"DoorOntoNothing", "Door"}, {"LampInRoad", "LampPole"},
                                                         {"TreeInRoad", "Trunk"},     {"CarOnPavement", "Car"},
                                                         {"BlockedDoor", "Door"},     {"RooflessWall", "Wall"}};
    for (const std::uint64_t seed : {21, 22, 23}) {
        SCOPED_TRACE(seed);
        for (const auto& [fault, culprit] : culprits) {
            SCOPED_TRACE(fault);
            const ExampleObject scene =
                street({.seed = seed, .triangles = 5'000, .buildings_a_side = 2, .faults = {fault}});
            const Annotation annotation = recogniser().annotate(scene.mesh);
            expect_all_named(scene, annotation);
            const auto found = faults(scene, annotation);
            EXPECT_GE(found.size(), 1U);
            EXPECT_LE(found.size(), fault == "RooflessWall" ? 4U : 1U);  // a building has up to four walls
            for (const auto& each : found) EXPECT_EQ(each, std::pair(fault, culprit));
        }
    }
}

TEST(Street, AllFaultsAtOnce) {
    const ExampleObject scene = street(
        {.seed = 31,
         .triangles = 20'000,
         .faults = {"DoorOntoNothing", "LampInRoad", "TreeInRoad", "CarOnPavement", "BlockedDoor", "RooflessWall"}});
    std::set<std::string> names;
    for (const auto& [name, label] : faults(scene, recogniser().annotate(scene.mesh))) names.insert(name);
    EXPECT_EQ(names, (std::set<std::string>{"BlockedDoor", "CarOnPavement", "DoorOntoNothing", "LampInRoad",
                                            "RooflessWall", "TreeInRoad"}));
}

TEST(Street, AnswersTurnWithTheSceneAndDoNotDependOnItsTriangles) {
    const ExampleObject scene =
        street({.seed = 41, .triangles = 6'000, .buildings_a_side = 2, .faults = {"LampInRoad", "DoorOntoNothing"}});
    const Annotation annotation = recogniser().annotate(scene.mesh);
    const auto expected = faults(scene, annotation);
    EXPECT_EQ(expected.size(), 2U);
    const ExampleObject others[] = {rotated_about_z(scene, 33), rotated_about_z(scene, 90), subdivided(scene),
                                    with_permuted_faces(scene, 5), translated(scene, {500, -300, 20})};
    for (const ExampleObject& other : others) {
        SCOPED_TRACE(&other - others);
        const Annotation same = recogniser().annotate(other.mesh);
        expect_all_named(other, same);
        EXPECT_EQ(same.parts.size(), annotation.parts.size());
        EXPECT_EQ(same.classes, annotation.classes);
        EXPECT_EQ(faults(other, same), expected);
    }
}

/// Everything that stood upright still does, and what lay level follows the slope; or all of it tilts.
TEST(Street, OnASlopeEverythingIsNamedAndEveryFaultIsFound) {
    const std::string all_faults[] = {"DoorOntoNothing", "LampInRoad",  "TreeInRoad",
                                      "CarOnPavement",   "BlockedDoor", "RooflessWall"};
    const Eigen::Vector2d slopes[] = {{0.02, 0}, {0, -0.05}, {0.05, 0.03}, {-0.1, 0.02}};
    for (std::size_t i = 0; i < 8; ++i) {
        SCOPED_TRACE(i);
        const Eigen::Vector2d& slope = slopes[i / 2];
        const bool is_tilted = i % 2 == 1;
        const std::string fault = i < 6 ? all_faults[i] : "";
        ExampleObject scene = street({.seed = 51 + i,
                                      .triangles = 5'000,
                                      .buildings_a_side = 3,
                                      .faults = fault.empty() ? std::vector<std::string>{} : std::vector{fault}});
        const Eigen::AngleAxisd tilt(std::atan(slope.norm()), Vec3(-slope.y(), slope.x(), 0).normalized());
        for (Vec3& p : scene.mesh.positions) {
            if (is_tilted)
                p = tilt * p;
            else
                p.z() += slope.dot(p.head<2>());
        }
        const Annotation annotation = recogniser().annotate(scene.mesh);
        expect_all_named(scene, annotation);
        std::set<std::string> names;
        for (const auto& [name, label] : faults(scene, annotation)) names.insert(name);
        EXPECT_EQ(names, fault.empty() ? std::set<std::string>{} : std::set{fault});
    }
}

TEST(Street, AnUnknownFaultIsRefused) {
    EXPECT_THROW(static_cast<void>(street({.faults = {"Flood"}})), std::exception);
}

}  // namespace
}  // namespace partonomy
