/* Relations between regions, from axioms over questions to names: T of arity 2 and 3. */

#include "algorithms/relations.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <memory>
#include <random>
#include <set>

#include "base/errors.h"
#include "examples/objects.h"
#include "examples/solid.h"
#include "examples/transforms.h"
#include "expert/furniture.h"
#include "expert/session.h"
#include "shape/part_box.h"

namespace partonomy {
namespace {

using Names = std::vector<std::string>;

/// An ontology on top of paper-furniture.ttl, in Manchester syntax: frames after the prologue.
struct OnFurniture {
    knowledge::Domain domain;
    Catalogue catalogue;
    explicit OnFurniture(const std::string& frames) {
        // Of its own, since imports are looked for beside the file; tests with the same frames run side by side.
        const std::filesystem::path folder =
            std::filesystem::temp_directory_path() / ("partonomy-relations-" + std::to_string(::getpid()) + "-" +
                                                      std::to_string(std::hash<std::string>{}(frames)));
        std::filesystem::create_directories(folder);
        const std::filesystem::path file = folder / "o.omn";
        std::ofstream(file) << "Prefix: : <http://example.org/r#>\n"
                               "Prefix: f: <https://w3id.org/partonomy/paper-furniture#>\n"
                               "Prefix: core: <https://w3id.org/partonomy/core#>\n"
                               "Ontology: <http://example.org/r>\n"
                               "Import: <https://w3id.org/partonomy/paper-furniture>\n"
                            << frames;
        owl::LoadOptions options;
        options.import_folders.emplace_back(PARTONOMY_SOURCE_DIR "/ontologies");
        domain = knowledge::compile(owl::load_ontology(file, options));
        std::filesystem::remove_all(folder);
        catalogue = make_catalogue(domain);
    }
    [[nodiscard]] Annotation annotate(const TriangleMesh& mesh, const AnnotateOptions& options = {}) const {
        return partonomy::annotate(domain, catalogue, make_object(mesh, {}), options);
    }
};

std::ptrdiff_t count(const Annotation& annotation, const std::string& name) {
    return std::ranges::count_if(
        annotation.parts, [&](const AnnotatedPart& part) { return std::ranges::count(part.concepts, name) > 0; });
}

std::ptrdiff_t traced(const Annotation& annotation, const std::string& kind) {
    return std::ranges::count(annotation.trace, kind, &TraceEntry::kind);
}

const char* const seat_and_backrest =
    "Class: :HighBackrest EquivalentTo: f:Backrest and (core:isTargetRegion some (core:UpFrom and "
    "(inverse (core:isReferenceRegion) some f:Seat)))\n"
    "Class: :FirmSeat EquivalentTo: f:Seat and (core:isTargetRegion min 3 (core:Connected and "
    "(inverse (core:isReferenceRegion) some f:Leg)))\n"
    "Class: :FirmChair EquivalentTo: f:Chair and (core:hasPart some :FirmSeat) and (core:hasPart some :HighBackrest)\n"
    "Class: :LowBackrest EquivalentTo: f:Furniture and (core:hasPart some (f:Backrest and "
    "(not (core:isTargetRegion some (core:UpFrom and (inverse (core:isReferenceRegion) some f:Seat))))))\n"
    "    SubClassOf: core:Incompatible\n";

TEST(Relations, AboveASeatAndTouchingThreeLegs) {
    const OnFurniture ontology(seat_and_backrest);
    EXPECT_TRUE(ontology.domain.warnings.empty());
    for (const Strategy strategy : {Strategy::expert, Strategy::naive, Strategy::segment_then_identify})
        for (const char* name : {"chair", "chair2"}) {
            SCOPED_TRACE(name);
            const Annotation annotation = ontology.annotate(paper_object(name).mesh, {strategy, {}});
            EXPECT_EQ(annotation.classes, Names{"FirmChair"});
            EXPECT_EQ(count(annotation, "HighBackrest"), 1);
            EXPECT_EQ(count(annotation, "FirmSeat"), 1);
            EXPECT_TRUE(annotation.consistent);
            EXPECT_EQ(traced(annotation, "T"), annotation.questions.at("T"));
            EXPECT_EQ(annotation.questions.at("T"), 4);  // one seat above; three of the legs
            EXPECT_TRUE(std::ranges::any_of(annotation.trace, [](const TraceEntry& entry) {
                return entry.kind == "T" && entry.question.find("is it above part") != std::string::npos;
            }));
            for (const TraceEntry& entry : annotation.trace) {  // what a relation says does not follow from a shape
                if (entry.kind != "SF" && entry.kind != "SI") continue;
                for (const std::string& text : entry.inferred)
                    EXPECT_EQ(text.find("is it above"), std::string::npos) << entry.question << " => " << text;
            }
        }
}

TEST(Relations, NothingIsAskedWhereNoNameHangsOnThem) {
    const OnFurniture ontology("Class: :X EquivalentTo: f:Chair and (core:hasPart min 2 f:Backrest)\n");
    const Annotation with = ontology.annotate(paper_object("chair").mesh);
    const Annotation without = OnFurniture("").annotate(paper_object("chair").mesh);
    EXPECT_EQ(with.questions, without.questions);
    EXPECT_EQ(with.questions.at("T"), 0);
}

/// A box between two corners, outward.
void add_box(Solid& solid, const std::string& label, const Vec3& low, const Vec3& high) {
    solid.begin_part(label);
    std::vector<Solid::Vertex> base{solid.at(low.x(), low.y(), low.z()), solid.at(high.x(), low.y(), low.z()),
                                    solid.at(high.x(), high.y(), low.z()), solid.at(low.x(), high.y(), low.z())};
    solid.prism(base, high.z());
    solid.face(base, true);
}

/// A seat on four legs, each part a box of its own; a bar between the rear legs, or beside one of them.
TriangleMesh stool(bool bar_between) {
    Solid solid;
    add_box(solid, "Seat", {0, 0, 0.40}, {0.5, 0.5, 0.44});
    for (const double x : {0.0, 0.46})
        for (const double y : {0.0, 0.46}) add_box(solid, "Leg", {x, y, 0}, {x + 0.04, y + 0.04, 0.40});
    const double from = bar_between ? 0.04 : 0.54;
    add_box(solid, "Bar", {from, 0.465, 0.2}, {from + 0.42, 0.495, 0.23});
    return std::move(solid).finish("stool", "Stool").mesh;
}

TEST(Relations, BetweenTwoLegs) {
    const OnFurniture ontology(
        "Class: :Stretcher EquivalentTo: core:Region and (core:hasShape some core:Stick) and "
        "(core:isTargetRegion some (core:Between and (inverse (core:isReferenceRegion) min 2 f:Leg)))\n"
        "Class: :BracedLeg EquivalentTo: f:Leg and (core:isReferenceRegion some (core:Between and "
        "(inverse (core:isTargetRegion) some :Stretcher)))\n"
        "Class: :SideBar EquivalentTo: core:Region and (core:hasPosition some core:Central) and "
        "(core:isTargetRegion some (core:Beside and (inverse (core:isReferenceRegion) some f:Leg))) and "
        "(not (:Stretcher))\n"
        "Class: :BracedStool EquivalentTo: f:Stool and (core:hasPart min 2 :BracedLeg)\n");
    const Annotation between = ontology.annotate(stool(true));
    EXPECT_EQ(count(between, "Stretcher"), 1);
    EXPECT_EQ(count(between, "SideBar"), 0);
    EXPECT_EQ(between.classes, Names{"BracedStool"});
    EXPECT_GE(count(between, "BracedLeg"), 2);
    const Annotation beside = ontology.annotate(stool(false));
    EXPECT_EQ(count(beside, "SideBar"), 1);
    EXPECT_EQ(count(beside, "Stretcher"), 0);
    EXPECT_EQ(count(beside, "BracedLeg"), 0);
    EXPECT_EQ(beside.classes, Names{"Stool"});
    for (const bool bar_between : {true, false}) {  // it does not matter how the object is turned
        ExampleObject turned;
        turned.mesh = stool(bar_between);
        const Annotation annotation = ontology.annotate(rotated_about_z(turned, 33).mesh);
        EXPECT_EQ(count(annotation, "Stretcher"), bar_between ? 1 : 0);
        EXPECT_EQ(count(annotation, "SideBar"), bar_between ? 0 : 1);
    }
}

TEST(Relations, ABackrestThatIsNotAboveItsSeat) {
    const OnFurniture ontology(seat_and_backrest);
    Solid solid;
    add_box(solid, "Seat", {0, 0, 0.40}, {0.5, 0.5, 0.44});
    for (const double x : {0.0, 0.46})
        for (const double y : {0.0, 0.46}) add_box(solid, "Leg", {x, y, 0}, {x + 0.04, y + 0.04, 0.40});
    add_box(solid, "Backrest", {2.0, 0.46, 0.5}, {2.5, 0.5, 0.9});  // far to the side
    const Annotation annotation = ontology.annotate(std::move(solid).finish("odd", "Chair").mesh);
    EXPECT_EQ(count(annotation, "Backrest"), 1);
    EXPECT_EQ(count(annotation, "HighBackrest"), 0);
    ASSERT_EQ(annotation.diagnosis.size(), 1U);
    EXPECT_EQ(annotation.diagnosis[0].concept_name, "LowBackrest");
    EXPECT_TRUE(std::ranges::any_of(annotation.diagnosis[0].answers, [](const std::string& answer) {
        return answer.find("is it above a Seat: no") != std::string::npos;
    }));
}

TEST(Relations, WithoutAlgorithmTheyStayOpen) {
    const OnFurniture ontology(
        "Class: :Mirrors SubClassOf: core:Relation\n"
        "Class: :TwinLeg EquivalentTo: f:Leg and (core:isTargetRegion some (:Mirrors and "
        "(inverse (core:isReferenceRegion) some f:Leg)))\n"
        "Class: :TwinChair EquivalentTo: f:Chair and (core:hasPart some :TwinLeg)\n");
    ASSERT_EQ(ontology.domain.warnings.size(), 1U);
    EXPECT_NE(ontology.domain.warnings[0].find("Mirrors"), std::string::npos) << ontology.domain.warnings[0];
    const Annotation annotation = ontology.annotate(paper_object("chair").mesh);
    EXPECT_EQ(annotation.classes, Names{"Chair"});
    EXPECT_EQ(annotation.questions.at("T"), 0);
    EXPECT_EQ(count(annotation, "Leg"), 4);
    EXPECT_EQ(count(annotation, "TwinLeg"), 0);
}

TEST(Relations, AMeasureOfAnotherNumberOfRegionsIsRefused) {
    const std::string frames =
        "Class: :Odd Annotations: core:measure \"opening angle\", core:membership \"100 140 inf inf\" "
        "SubClassOf: core:Relation\n";
    try {
        const OnFurniture ontology(frames);
        FAIL();
    } catch (const OntologyError& error) {
        EXPECT_NE(std::string(error.what()).find("o.omn:6: Odd links 2 regions"), std::string::npos) << error.what();
    }
}

TEST(Relations, BadKnobsAreRefusedWithFileAndLine) {
    const std::string use =
        " SubClassOf: core:Relation\nClass: :OddLeg EquivalentTo: f:Leg and (core:isTargetRegion some :Odd)\n"
        "Class: :OddChair EquivalentTo: f:Chair and (core:hasPart some :OddLeg)\n";
    const std::vector<std::pair<std::string, std::string>> faults{
        {"core:criterion \"side stepp -inf -inf 0.1 0.3\"",
         "o.omn:6: Odd: there is no measure \"side stepp\"; did you mean \"side step\"?"},
        {"core:measure \"gap\", core:membership \"0.3 0.1 inf inf\"",
         "o.omn:6: membership \"0.3 0.1 inf inf\" of Odd has its numbers out of order; they should ascend"},
        {"core:measure \"gap\", core:membership \"0.1 0.3\"", "of Odd should be four numbers"},
        {"core:arity 4, core:criterion \"gap -inf -inf 0.1 0.3\"",
         "o.omn:6: arity \"4\" of Odd should be 2 or 3: the number of regions that it links"},
        {"core:arity 3, core:criterion \"gap -inf -inf 0.1 0.3\"",
         "o.omn:6: Odd links 3 regions (core:arity, 2 without it), but \"gap\" measures 2; change one of them"},
        {"core:criterion \"opening angle / gap 0.1 0.3 inf inf\"",
         "o.omn:6: Odd: the measure \"opening angle / gap\" cannot be read: \"opening angle\" measures 3 regions, but "
         "\"gap\" 2"},
        {"core:criterion \"gap - length 0.1 0.3 inf inf\"",
         "o.omn:6: Odd: \"length\" is measured of one region, and a relation needs what is measured between regions"}};
    for (const auto& [knobs, words] : faults) {
        SCOPED_TRACE(knobs);
        try {
            const OnFurniture ontology("Class: :Odd Annotations: " + knobs + use);
            ADD_FAILURE() << "accepted";
        } catch (const OntologyError& error) {
            EXPECT_NE(std::string(error.what()).find(words), std::string::npos) << error.what();
        }
    }
}

TEST(Relations, EachWaitsForTheOther) {
    const OnFurniture ontology(  // a seat below a backrest that is above a seat: nothing proves either
        "Class: :A EquivalentTo: f:Seat and (core:isReferenceRegion some (core:UpFrom and (inverse "
        "(core:isTargetRegion) "
        "some :B)))\n"
        "Class: :B EquivalentTo: f:Backrest and (core:isTargetRegion some (core:UpFrom and (inverse "
        "(core:isReferenceRegion) some :A)))\n"
        "Class: :C EquivalentTo: f:Chair and (core:hasPart some :A)\n");
    const Annotation annotation = ontology.annotate(paper_object("chair").mesh);
    EXPECT_EQ(annotation.classes, Names{"Chair"});
    EXPECT_GT(annotation.questions.at("T"), 0);
}

/// A seat on four legs with knobs on it and beside it.
TriangleMesh knobbed_stool(int on, int beside) {
    Solid solid;
    add_box(solid, "Seat", {0, 0, 0.40}, {0.5, 0.5, 0.44});
    for (const double x : {0.0, 0.46})
        for (const double y : {0.0, 0.46}) add_box(solid, "Leg", {x, y, 0}, {x + 0.04, y + 0.04, 0.40});
    for (int i = 0; i < on; ++i) {
        const double x = 0.04 + 0.12 * (i % 4), y = 0.04 + 0.12 * (i / 4);
        add_box(solid, "Knob", {x, y, 0.45}, {x + 0.06, y + 0.06, 0.51});
    }
    for (int i = 0; i < beside; ++i) {
        const double y = 0.15 * i;
        add_box(solid, "Foot", {1.6, y, 0.45}, {1.66, y + 0.06, 0.51});
    }
    return std::move(solid).finish("stool", "Stool").mesh;
}

TEST(Relations, OneFindAllInsteadOfManyQuestions) {
    const OnFurniture ontology(
        "Class: :Knob EquivalentTo: core:Region and (core:hasShape some core:Cube) and (core:isTargetRegion some "
        "(core:UpFrom and (inverse (core:isReferenceRegion) some f:Seat)))\n"
        "Class: :KnobbedStool EquivalentTo: f:Furniture and (core:hasPart min 4 :Knob)\n");
    const Annotation many = ontology.annotate(knobbed_stool(12, 3));
    EXPECT_EQ(count(many, "Seat"), 1);
    EXPECT_EQ(count(many, "Knob"), 12);
    EXPECT_EQ(many.questions.at("TF"), 1);  // who is above the seat
    EXPECT_EQ(many.questions.at("T"), 0);
    EXPECT_EQ(traced(many, "TF"), 1);
    EXPECT_TRUE(std::ranges::any_of(many.trace, [](const TraceEntry& entry) {
        return entry.kind == "TF" && entry.question.find("which parts: is it above part") == 0 &&
               entry.answer == "12 regions";
    }));
    const Annotation few = ontology.annotate(knobbed_stool(2, 0));
    EXPECT_EQ(count(few, "Knob"), 2);
    EXPECT_EQ(few.questions.at("TF"), 0);
    EXPECT_EQ(few.questions.at("T"), 2);
}

TEST(Relations, WhatWasAskedIsNotAskedAgain) {
    const char* const knob =
        "Class: :Knob EquivalentTo: core:Region and (core:hasShape some core:Cube) and (core:isTargetRegion some "
        "(core:UpFrom and (inverse (core:isReferenceRegion) some f:Seat)))\n"
        "Class: :KnobbedStool EquivalentTo: f:Furniture and (core:hasPart min 4 :Knob)\n";
    const OnFurniture once(knob);
    const OnFurniture twice(std::string(knob) +  // another name that hangs on the same relation
                            "Class: :Lump EquivalentTo: core:Region and (core:hasCompactness some core:Compact) and "
                            "(core:isTargetRegion some (core:UpFrom and (inverse (core:isReferenceRegion) some "
                            "(f:Seat and (core:hasShape some core:Board)))))\n"
                            "Class: :LumpyStool EquivalentTo: f:Furniture and (core:hasPart some :Lump)\n");
    const TriangleMesh mesh = knobbed_stool(12, 3);
    const Annotation first = once.annotate(mesh), second = twice.annotate(mesh);
    EXPECT_EQ(count(second, "Lump"), 12);
    EXPECT_EQ(first.questions.at("TF"), second.questions.at("TF"));
    EXPECT_EQ(first.questions.at("T"), second.questions.at("T"));
}

TEST(Relations, MeasuresOfBoxes) {
    Solid solid;
    add_box(solid, "a", {0, 0, 0}, {1, 1, 1});
    add_box(solid, "b", {0, 0, 1.25}, {1, 1, 2});
    add_box(solid, "c", {2, 0, 0}, {3, 1, 1});
    Object object;
    object.mesh = std::move(solid).finish("boxes", "").mesh;
    object.geometry = compute_geometry(object.mesh);
    object.low = 0;
    object.high = 2;
    std::vector<PartRegion> parts(3);
    for (int t = 0; t < 36; ++t) parts[static_cast<std::size_t>(t / 12)].region.triangles.push_back(t);
    std::vector<RegionPlace> places;
    const Scene scene = scene_of(object);
    for (PartRegion& part : parts) {
        part.box = measure_part(object.mesh, object.geometry, part.region.triangles, object.is_noisy).box;
        places.push_back(place_of(scene, part));
    }
    const RegionPlace *a = &places[0], *b = &places[1], *c = &places[2];
    const double diagonal = std::sqrt(9.0 + 1 + 4);
    const auto measured = [&](const char* name, const std::vector<const RegionPlace*>& regions) {
        return find_relation_measure(name)->value(scene, regions).value();
    };
    EXPECT_NEAR(measured("gap", {a, b}), 0.25 / diagonal, 1e-12);
    EXPECT_NEAR(measured("gap", {b, a}), 0.25 / diagonal, 1e-12);
    EXPECT_NEAR(measured("gap", {a, c}), 1 / diagonal, 1e-12);
    EXPECT_NEAR(measured("rise", {b, a}), (1.625 - 1) / 2, 1e-12);
    EXPECT_NEAR(measured("rise", {a, b}), (0.5 - 2) / 2, 1e-12);
    EXPECT_NEAR(measured("side step", {a, b}), 0, 1e-12);
    EXPECT_NEAR(measured("side step", {a, c}), 1 / diagonal, 1e-12);
    EXPECT_NEAR(measured("level overlap", {a, c}), 1, 1e-12);
    EXPECT_NEAR(measured("level overlap", {a, b}), 0, 1e-12);
    EXPECT_NEAR(measured("footprint overlap", {a, b}), 1, 1e-12);
    EXPECT_NEAR(measured("opening angle", {a, b, c}), 90, 1e-9);
    EXPECT_FALSE(relation_score(std::span(&touching(), 1), scene, std::vector<const RegionPlace*>{a, b, c}));
}

// The second opinion: points all over both triangles.
TEST(Relations, GapIsThatOfTheNearestPoints) {
    std::mt19937 random(7);
    const auto coordinate = [&] { return static_cast<double>(random() % 1000) / 1000; };
    int apart = 0, touching_pairs = 0;
    for (int round = 0; round < 200; ++round) {
        SCOPED_TRACE("round " + std::to_string(round));
        Object object;
        const double offset = 0.8 * coordinate();
        for (int v = 0; v < 6; ++v)
            object.mesh.positions.emplace_back(coordinate() + (v < 3 ? 0 : offset), coordinate(), coordinate());
        object.mesh.positions.emplace_back(100, 0, 0);  // a diagonal of which all of this is near
        object.mesh.triangles = {{0, 1, 2}, {3, 4, 5}};
        object.geometry = compute_geometry(object.mesh);
        std::vector<PartRegion> parts(2);
        for (int t = 0; t < 2; ++t) parts[static_cast<std::size_t>(t)].region.triangles = {t};
        const Scene scene = scene_of(object);
        const RegionPlace a = place_of(scene, parts[0]), b = place_of(scene, parts[1]);
        const double gap = *find_relation_measure("gap")->value(scene, std::array{&a, &b}) * scene.diagonal;
        constexpr int steps = 24;
        const auto points = [&](std::size_t t) {
            std::vector<Vec3> all;
            const auto& corners = object.mesh.triangles[t];
            const auto at = [&](std::size_t i) { return object.mesh.positions[static_cast<std::size_t>(corners[i])]; };
            for (int i = 0; i <= steps; ++i)
                for (int j = 0; i + j <= steps; ++j)
                    all.emplace_back((i * at(0) + j * at(1) + (steps - i - j) * at(2)) / steps);
            return all;
        };
        double sampled = 1e9;
        const std::vector<Vec3> others = points(1);
        for (const Vec3& p : points(0))
            for (const Vec3& q : others) sampled = std::min(sampled, (p - q).norm());
        EXPECT_LE(gap, sampled + 1e-9);
        EXPECT_GE(gap, sampled - 2 * 1.8 / steps);  // no point is further from a sample than an edge over the steps
        (gap > 0 ? apart : touching_pairs) += 1;
    }
    EXPECT_GT(apart, 50);
    EXPECT_GT(touching_pairs, 5);
}

/// What is known of each region: wanted concepts that hold, and those that do not.
std::vector<std::string> names_of(const Session& session) {
    std::vector<std::string> all;
    for (int region = 0; region < session.region_count(); ++region) {
        std::string& names = all.emplace_back();
        for (const knowledge::ConceptId c : session.wanted()) {
            const knowledge::Concept& each = session.domain().regions.concepts[static_cast<std::size_t>(c)];
            const knowledge::ConfigurationSet& set = session.possible(region);
            const char* truth = set.is_subset_of(each.where) ? " is " : set.intersects(each.where) ? " may be " : "";
            if (*truth != 0) names.append(truth).append(owl::local_name(each.iri));
        }
    }
    return all;
}

TEST(Relations, WhatAPersonSaysLateCountsAsIfItHadBeenSaidAtFirst) {
    const OnFurniture ontology(
        std::string(seat_and_backrest) +
        "Class: :Stretcher EquivalentTo: core:Region and (core:hasShape some core:Stick) and "
        "(core:isTargetRegion some (core:Between and (inverse (core:isReferenceRegion) min 2 f:Leg)))\n"
        "Class: :BracedLeg EquivalentTo: f:Leg and (core:isReferenceRegion some (core:Between and "
        "(inverse (core:isTargetRegion) some :Stretcher)))\n");
    constexpr auto criterion = knowledge::SplitCriterion::gain_per_cost;
    int corrections = 0, changed_others = 0;
    for (const TriangleMesh& mesh : {paper_object("chair").mesh, stool(true)}) {
        const Object object = make_object(mesh, {});
        const Cut cut = cut_of(object);
        const auto session = [&] {
            auto made = std::make_unique<Session>(ontology.domain, ontology.catalogue, object, cut);
            made->adopt_rest();
            return made;
        };
        const auto asked = session();
        ask_on(*asked, criterion);
        const std::vector<std::string> before = names_of(*asked);
        for (const knowledge::Answer& answer : asked->knowledge().answers) {
            const auto& variable =
                ontology.domain.regions.variables[static_cast<std::size_t>(answer.question.variable)];
            if (variable.kind == knowledge::VariableKind::relation) continue;
            SCOPED_TRACE("part " + std::to_string(answer.region + 1) + ", " +
                         to_text(ontology.domain.regions, answer.question, ontology.domain));
            const auto early = session(), late = session();
            early->correct(answer.region, answer.question, !answer.yes);
            ask_on(*early, criterion);
            ask_on(*late, criterion);
            const std::size_t asked_before = late->trace.size();
            late->correct(answer.region, answer.question, !answer.yes);
            ask_on(*late, criterion);
            EXPECT_EQ(names_of(*late), names_of(*early));
            std::set<std::string> questions;  // T is not asked twice, nor is anything of the other regions
            for (std::size_t i = 0; i < late->trace.size(); ++i) {
                const TraceEntry& entry = late->trace[i];
                const bool is_asked_again = !questions.insert(entry.kind + entry.question).second;
                const bool may_be =
                    entry.kind == "known" || entry.region == "part " + std::to_string(answer.region + 1);
                EXPECT_TRUE(may_be || !is_asked_again || i < asked_before) << entry.kind << " " << entry.question;
            }
            ++corrections;
            const std::vector<std::string> after = names_of(*late);
            for (std::size_t region = 0; region < after.size(); ++region)
                changed_others += static_cast<int>(region) != answer.region && after[region] != before[region];
        }
    }
    EXPECT_GT(corrections, 20);
    EXPECT_GT(changed_others, 10);
}

}  // namespace
}  // namespace partonomy
