/* Traffic signs: what shape cannot tell apart, colour does. */

#include "examples/signs.h"

#include <gtest/gtest.h>

#include <random>

#include "algorithms/appearance.h"
#include "examples/transforms.h"
#include "expert/annotate.h"

namespace partonomy {
namespace {

using Names = std::vector<std::string>;

struct TrafficSigns {
    knowledge::Domain domain =
        knowledge::compile(owl::load_ontology(PARTONOMY_SOURCE_DIR "/ontologies/traffic-signs.omn"));
    Catalogue catalogue = make_catalogue(domain);

    static const TrafficSigns& get() {
        static const TrafficSigns signs;
        return signs;
    }
    [[nodiscard]] Annotation annotate(const PaintedObject& painted, bool with_colors = true,
                                      Strategy strategy = Strategy::expert) const {
        Object object = make_object(painted.object.mesh, {});
        if (with_colors) paint(object, appearance_of(painted));
        AnnotateOptions options;
        options.strategy = strategy;
        return partonomy::annotate(domain, catalogue, object, options);
    }
};

double area_rightly_named(const PaintedObject& painted, const Annotation& annotation) {
    const TriangleGeometry geometry = compute_geometry(painted.object.mesh);
    double right = 0, all = 0;
    for (std::size_t t = 0; t < geometry.areas.size(); ++t) {
        const std::string& truth = painted.object.labels[t];
        all += geometry.areas[t];
        right += (annotation.labels[t] == (truth.empty() ? "-" : truth)) * geometry.areas[t];
    }
    return right / all;
}

Names expected_classes(const ExampleObject& object) {
    Names names;
    if (!object.object_class.empty()) names.push_back(object.object_class);
    if (!object.incompatibility.empty()) names.push_back(object.incompatibility);
    std::ranges::sort(names);
    return names;
}

void expect_right(const PaintedObject& painted, const Annotation& annotation, double least_area) {
    SCOPED_TRACE(painted.object.name);
    Names classes = annotation.classes;
    std::ranges::sort(classes);
    EXPECT_EQ(classes, expected_classes(painted.object));
    EXPECT_EQ(annotation.consistent, painted.object.incompatibility.empty());
    EXPECT_GE(area_rightly_named(painted, annotation), least_area);
    if (painted.object.incompatibility.empty()) return;
    ASSERT_EQ(annotation.diagnosis.size(), 1U);
    EXPECT_EQ(annotation.diagnosis[0].concept_name, painted.object.incompatibility);
    EXPECT_FALSE(annotation.diagnosis[0].parts.empty());
    EXPECT_FALSE(annotation.diagnosis[0].corrections.empty());
}

std::vector<PaintedObject> right_and_wrong() {
    std::vector<PaintedObject> all = signs();
    for (PaintedObject& wrong : wrong_signs()) all.push_back(std::move(wrong));
    return all;
}

TEST(TrafficSigns, EachIsNamedByEachStrategyAndTheExpertAsksLess) {
    const TrafficSigns& traffic = TrafficSigns::get();
    int expert = 0, naive = 0;
    for (const PaintedObject& painted : right_and_wrong()) {
        const Annotation annotation = traffic.annotate(painted);
        expect_right(painted, annotation, 1);
        const Annotation asked_all = traffic.annotate(painted, true, Strategy::naive);
        expect_right(painted, asked_all, 1);
        expect_right(painted, traffic.annotate(painted, true, Strategy::segment_then_identify), 1);
        EXPECT_LT(annotation.questions.at("SF"), asked_all.questions.at("SF"));
        EXPECT_LT(2 * annotation.questions.at("SI"), asked_all.questions.at("SI"));
        expert += annotation.questions.at("SI");
        naive += asked_all.questions.at("SI");
    }
    EXPECT_LT(3 * expert, naive) << expert << " and " << naive;  // docs/appearance.md tells the numbers
}

/// Each triangle cut until no edge is longer than `longest`, so that noise has something to shake; paints follow.
PaintedObject refined(PaintedObject painted, int times) {
    for (int i = 0; i < times; ++i) {
        painted.object = subdivided(painted.object);
        std::vector<int> paint_of;
        std::vector<std::array<TexturePoint, 3>> points;
        for (const int paint : painted.paint_of) paint_of.insert(paint_of.end(), 4, paint);
        painted.paint_of = std::move(paint_of);
        if (!painted.points.empty()) painted.points.clear();
    }
    return painted;
}

TEST(TrafficSigns, StayWhatTheyAreWhenTurnedScaledAndShaken) {
    const TrafficSigns& traffic = TrafficSigns::get();
    constexpr unsigned seed = 20241122;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> degrees(0, 360), size(0.2, 5);
    std::normal_distribution<double> normal;
    for (const PaintedObject& painted : right_and_wrong()) {
        PaintedObject turned = painted;
        turned.object = scaled(rotated_about_z(turned.object, degrees(random)), size(random));
        expect_right(turned, traffic.annotate(turned), 1);
        if (!painted.points.empty()) continue;  // places in the image do not follow refined()
        PaintedObject shaken = refined(turned, 3);
        const double noise = 0.005 * compute_bounds(shaken.object.mesh).diagonal();
        for (Vec3& p : shaken.object.mesh.positions)
            p += noise / std::sqrt(3.0) * Vec3(normal(random), normal(random), normal(random));
        expect_right(shaken, traffic.annotate(shaken), 0.9);
    }
}

TEST(TrafficSigns, FacesInAnyOrder) {
    const TrafficSigns& traffic = TrafficSigns::get();
    for (const PaintedObject& painted : right_and_wrong()) {
        if (!painted.points.empty()) continue;
        PaintedObject mixed = painted;
        mixed.object = with_permuted_faces(mixed.object, 5);
        mixed.paint_of = mixed.object.parts;  // part i has paint i
        expect_right(mixed, traffic.annotate(mixed), 1);
    }
}

TEST(TrafficSigns, StayOpenWithoutColours) {
    const TrafficSigns& traffic = TrafficSigns::get();
    for (const PaintedObject& painted : signs()) {
        const Annotation annotation = traffic.annotate(painted, false);
        ASSERT_FALSE(annotation.open_questions.empty());
        EXPECT_NE(annotation.open_questions[0].find("no colours"), std::string::npos) << annotation.open_questions[0];
        EXPECT_TRUE(std::ranges::any_of(annotation.open_questions, [](const std::string& text) {
            return text.find("is assumed to be") != std::string::npos;
        })) << painted.object.name;
    }
}

TEST(TrafficSigns, FindAllOfAColour) {
    const TrafficSigns& traffic = TrafficSigns::get();
    const auto colour = traffic.domain.regions.find_variable(std::string(owl::core_prefix) + "Colour");
    ASSERT_TRUE(colour);
    const auto& values = traffic.domain.regions.variables[static_cast<std::size_t>(*colour)].values;
    const auto red = static_cast<int>(std::ranges::find(values, "Red") - values.begin());
    const PaintedObject no_entry = signs().front();
    Object object = make_object(no_entry.object.mesh, {});
    {
        const Cut uncoloured = cut_of(object);
        const Session blind(traffic.domain, traffic.catalogue, object, uncoloured);
        EXPECT_FALSE(blind.find_all_cost({*colour, red}));
    }
    paint(object, appearance_of(no_entry));
    const Cut cut = cut_of(object);
    Session session(traffic.domain, traffic.catalogue, object, cut);
    EXPECT_TRUE(session.find_all_cost({*colour, red}));
    ASSERT_EQ(session.find_all({*colour, red}), 1);
    for (const std::int32_t t : session.part(0).region.triangles)
        EXPECT_EQ(no_entry.object.labels[static_cast<std::size_t>(t)], "RedField");
    EXPECT_EQ(session.part(0).region.triangles.size(),
              static_cast<std::size_t>(std::ranges::count(no_entry.object.labels, "RedField")));
}

}  // namespace
}  // namespace partonomy
