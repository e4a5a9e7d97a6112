/* Corrections of what is wrong with an object: each mends it, and the first leave it what it is. The second opinion is
 * what follows from the answers when those of a correction are turned round. */

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/files.h"
#include "examples/lamps.h"
#include "examples/objects.h"
#include "expert/annotate.h"

namespace partonomy {
namespace {

using Names = std::vector<std::string>;

Names object_names(const knowledge::Conclusions& known) {
    Names names;
    for (const knowledge::ConceptId c : entailed(*known.objects, known.object))
        names.push_back(owl::local_name(known.objects->concepts[static_cast<std::size_t>(c)].iri));
    return names;
}

/// Looks at every diagnosis; returns whether the first correction of each leaves the object what it is.
bool expect_sound(const knowledge::Domain& domain, const Annotation& annotation) {
    bool keeps_all = true;
    const knowledge::Knowledge knowledge = recall(domain, static_cast<int>(annotation.parts.size()),
                                                  annotation.is_complete, annotation.answers, annotation.connected);
    Names classes = annotation.classes;
    for (const Diagnosis& diagnosis : annotation.diagnosis) std::erase(classes, diagnosis.concept_name);
    for (const Diagnosis& diagnosis : annotation.diagnosis) {
        SCOPED_TRACE(diagnosis.concept_name);
        EXPECT_EQ(diagnosis.corrections.size(), diagnosis.changes.size());
        EXPECT_LE(diagnosis.corrections.size(), 8U);
        std::pair<bool, double> before{false, 0};
        for (std::size_t k = 0; k < diagnosis.changes.size(); ++k) {
            SCOPED_TRACE(diagnosis.corrections[k]);
            if (!diagnosis.changes[k].part.empty()) {  // NumbersOfParts looks at these
                EXPECT_EQ(diagnosis.corrections[k].find("then it is not"), std::string::npos);
                before = {false, std::round(10 * diagnosis.changes[k].cost)};
                continue;
            }
            knowledge::Knowledge changed = knowledge;
            double cost = 0;
            for (const std::size_t i : diagnosis.changes[k].answers) {
                changed.answers[i].yes = !changed.answers[i].yes;
                cost += annotation.answers[i].score - 0.5;
            }
            EXPECT_NEAR(cost, diagnosis.changes[k].cost, 1e-9);
            const knowledge::Conclusions after = conclude(domain, changed);
            EXPECT_FALSE(after.contradiction);
            const Names names = object_names(after);
            EXPECT_EQ(std::ranges::count(names, diagnosis.concept_name), 0);
            const bool keeps = std::ranges::all_of(
                classes, [&](const std::string& name) { return std::ranges::find(names, name) != names.end(); });
            EXPECT_EQ(keeps, diagnosis.corrections[k].find("then it is not") == std::string::npos);
            const std::pair now{!keeps, std::round(10 * cost)};
            EXPECT_LE(before, now);
            before = now;
            if (k == 0) keeps_all &= keeps;
        }
        EXPECT_FALSE(diagnosis.changes.empty());
    }
    return keeps_all;
}

TEST(Corrections, LeaveTheObjectWhatItIsFirst) {
    const auto annotate_with = [](const knowledge::Domain& domain, const TriangleMesh& mesh) {
        const Catalogue catalogue = make_catalogue(domain);
        return annotate(domain, catalogue, make_object(mesh, {}));
    };
    int diagnosed = 0;
    const knowledge::Domain of_lamps =
        knowledge::compile(owl::load_ontology(PARTONOMY_SOURCE_DIR "/ontologies/lamps.omn"));
    for (const ExampleObject& lamp : lamps()) {
        if (lamp.incompatibility.empty()) continue;
        SCOPED_TRACE(lamp.name);
        const Annotation annotation = annotate_with(of_lamps, lamp.mesh);
        diagnosed += !annotation.diagnosis.empty();
        EXPECT_TRUE(expect_sound(of_lamps, annotation));
        EXPECT_NE(annotation.diagnosis.at(0).corrections.at(0).find("does it stand firmly: yes"), std::string::npos)
            << annotation.diagnosis.at(0).corrections.at(0);
    }
    const knowledge::Domain furniture =
        knowledge::compile(owl::load_ontology(PARTONOMY_SOURCE_DIR "/ontologies/paper-furniture.ttl"));
    for (const ExampleObject& object : paper_objects()) {
        SCOPED_TRACE(object.name);
        const Annotation annotation = annotate_with(furniture, object.mesh);
        diagnosed += !annotation.diagnosis.empty();
        expect_sound(furniture, annotation);
    }
    EXPECT_GE(diagnosed, 2);
}

/// Both arms are wrong: neither alone mends it, and to turn both costs more than to say that it is no such lamp.
TEST(Corrections, OfTwoPartsWithTheSameFault) {
    const std::string text = read_file(PARTONOMY_SOURCE_DIR "/ontologies/lamps.omn") +
                             "\nClass: :LongArm\n    SubClassOf: core:Incompatible\n    EquivalentTo: :TwinLamp and "
                             "(core:hasPart some (:Arm and (core:length some xsd:double[>= 0.01])))\n";
    const knowledge::Domain domain = knowledge::compile(owl::parse_ontology(text, "lamps.omn"));
    const Catalogue catalogue = make_catalogue(domain);
    const Annotation annotation = annotate(domain, catalogue, make_object(lamps().back().mesh, {}));
    ASSERT_EQ(annotation.diagnosis.size(), 1U);
    EXPECT_EQ(annotation.diagnosis[0].parts.size(), 2U);
    EXPECT_TRUE(expect_sound(domain, annotation));
    ASSERT_FALSE(annotation.diagnosis[0].changes.empty());
    EXPECT_EQ(annotation.diagnosis[0].changes[0].answers.size(), 2U) << annotation.diagnosis[0].corrections[0];
    EXPECT_NE(annotation.diagnosis[0].corrections[0].find("length"), std::string::npos)
        << "the rule asks for it; " << annotation.diagnosis[0].corrections[0];
}

/// A rule that counts parts is kept by a part more or less, by whatever words it says so. The second opinion is another
/// mesh, made with the part or without it.
TEST(Corrections, NumbersOfParts) {
    const std::string lamp = read_file(PARTONOMY_SOURCE_DIR "/ontologies/lamps.omn");
    const auto found = [&](const std::string& rule, const TriangleMesh& mesh) {
        const std::string text = lamp +
                                 "\nClass: :Bulb\n    EquivalentTo: core:Region and (core:hasShape some core:Cube) and "
                                 "(core:hasPosition some core:Down) and (not :HoodWall)\n"
                                 "Class: :Wrong\n    SubClassOf: core:Incompatible\n    EquivalentTo: :TwinLamp and " +
                                 rule + "\n";
        const knowledge::Domain domain = knowledge::compile(owl::parse_ontology(text, "lamps.omn"));
        const Catalogue catalogue = make_catalogue(domain);
        Annotation annotation = annotate(domain, catalogue, make_object(mesh, {}));
        for (const Diagnosis& diagnosis : annotation.diagnosis)
            if (diagnosis.concept_name == "Wrong") return diagnosis;
        return Diagnosis{};
    };
    const auto has = [](const Diagnosis& diagnosis, const std::string& words) {
        return std::ranges::any_of(diagnosis.corrections,
                                   [&](const std::string& text) { return text.starts_with(words); });
    };
    const auto all = [](const Diagnosis& diagnosis) {
        std::string text;
        for (const std::string& each : diagnosis.corrections) text += each + "\n";
        return text;
    };
    const TriangleMesh twin = lamps().back().mesh;
    for (const char* none : {"(core:hasPart max 0 :Bulb)", "(not (core:hasPart some :Bulb))",
                             "(not (core:hasPart min 1 :Bulb))", "(core:hasPart exactly 0 :Bulb)"}) {
        const Diagnosis missing = found(none, twin);
        EXPECT_TRUE(has(missing, "add one Bulb (cost 0.50)")) << none << "\n" << all(missing);
        ASSERT_EQ(missing.counts.size(), 1U) << none;
        EXPECT_EQ(missing.counts[0].part, "Bulb");
        EXPECT_EQ(missing.counts[0].at_most, 0U);
        EXPECT_TRUE(missing.counts_are_all);
    }
    const Diagnosis two = found("(core:hasPart max 1 :Bulb)", twin);
    EXPECT_TRUE(has(two, "add 2 Bulb (cost 1.00)")) << all(two);
    // One bulb alone would break another rule.
    const Diagnosis pair = found(
        "(core:hasPart max 0 :Bulb)\nClass: :OneBulb\n    SubClassOf: core:Incompatible\n"
        "    EquivalentTo: :TwinLamp and (core:hasPart exactly 1 :Bulb)",
        twin);
    EXPECT_TRUE(has(pair, "add 2 Bulb (cost 1.00)")) << all(pair);
    EXPECT_FALSE(has(pair, "add one Bulb")) << all(pair);
    const Diagnosis shades = found("(core:hasPart exactly 2 :Stem)", twin);
    EXPECT_TRUE(has(shades, "one more Stem (cost 0.50)")) << all(shades);
    EXPECT_EQ(shades.counts.at(0).at_least, 2U);
    EXPECT_EQ(shades.counts.at(0).at_most, 2U);
    const Diagnosis fewer = found("(core:hasPart min 2 :Arm)", twin);
    EXPECT_TRUE(has(fewer, "take away one Arm: part ")) << all(fewer);
    for (const Diagnosis::Change& change : fewer.changes) {
        EXPECT_TRUE(change.part.empty() || change.count == -1) << change.part;
    }
    // What the object needs is not taken away; what is no matter of numbers is not told as one.
    const Diagnosis base = found("(core:hasPart some :Base)", twin);
    EXPECT_FALSE(base.concept_name.empty());
    EXPECT_FALSE(has(base, "take away")) << all(base);
    const Diagnosis either = found("((core:hasPart max 0 :Bulb) or (core:hasPart min 9 :Arm))", twin);
    EXPECT_TRUE(either.counts.empty());
    EXPECT_FALSE(either.counts_are_all);
}

/// The twin lamp, by the ontology of lamps and what else a test says.
std::pair<knowledge::Domain, Annotation> twin_lamp_with(const std::string& text) {
    knowledge::Domain domain = knowledge::compile(
        owl::parse_ontology(read_file(PARTONOMY_SOURCE_DIR "/ontologies/lamps.omn") + text, "lamps.omn"));
    Annotation annotation = annotate(domain, make_catalogue(domain), make_object(lamps().back().mesh, {}));
    return {std::move(domain), std::move(annotation)};
}

/// What a rule rests on comes first, then what makes the object a case of it. The second opinion: the latter alone make
/// it that, and no break of the rule.
TEST(Corrections, WhatTheRuleRestsOnComesFirst) {
    const std::string text =
        "\nClass: :HighBulb\n    EquivalentTo: core:Region and (core:hasShape some core:Stick) and "
        "(core:height some xsd:double[>= 9.0])\n"
        "Class: :NoBulb\n    SubClassOf: core:Incompatible\n    EquivalentTo: :TwinLamp and "
        "(core:hasPart max 0 :HighBulb)\n"
        "Class: :TwoArms\n    SubClassOf: core:Incompatible\n    EquivalentTo: :TwinLamp and "
        "(core:hasPart min 2 :Arm)\n";
    const auto [domain, annotation] = twin_lamp_with(text);
    ASSERT_EQ(annotation.diagnosis.size(), 2U);
    for (const Diagnosis& diagnosis : annotation.diagnosis) {
        SCOPED_TRACE(diagnosis.concept_name);
        EXPECT_EQ(diagnosis.given, Names{"TwinLamp"});
        ASSERT_GT(diagnosis.answers_of_given, 0U);
        ASSERT_LT(diagnosis.answers_of_given, diagnosis.answers.size());
        EXPECT_TRUE(diagnosis.axioms.at(0).starts_with(diagnosis.concept_name)) << diagnosis.axioms.at(0);
        knowledge::Knowledge own =
            recall(domain, static_cast<int>(annotation.parts.size()), true, annotation.answers, annotation.connected);
        const auto end = diagnosis.answers.end() - static_cast<std::ptrdiff_t>(diagnosis.answers_of_given);
        const auto is_own = [&](const std::string& answer) {
            return std::find(diagnosis.answers.begin(), end, answer) != end;
        };
        std::size_t of_given = 0;
        std::vector<knowledge::Answer> others;
        for (std::size_t i = 0; i < own.answers.size(); ++i) {
            const std::string words = answer_in_words(domain, own.answers[i], annotation.answers[i]);
            of_given += std::find(end, diagnosis.answers.end(), words) != diagnosis.answers.end();
            if (!is_own(words)) others.push_back(own.answers[i]);
        }
        EXPECT_EQ(of_given, diagnosis.answers_of_given);
        EXPECT_EQ(std::ranges::count(object_names(conclude(domain, own)), diagnosis.concept_name), 1);
        own.answers = others;
        EXPECT_EQ(std::ranges::count(object_names(conclude(domain, own)), diagnosis.concept_name), 0);
    }
    const auto no_bulb = std::ranges::find(annotation.diagnosis, "NoBulb", &Diagnosis::concept_name);
    ASSERT_NE(no_bulb, annotation.diagnosis.end());
    ASSERT_EQ(no_bulb->nearest.size(), 3U) << "of four sticks, of which none is high";
    for (const Diagnosis::NearPart& near : no_bulb->nearest) {
        EXPECT_EQ(near.concept_name, "HighBulb");
        ASSERT_EQ(near.refused_by.size(), 1U) << near.part;
        EXPECT_NE(near.refused_by[0].find("height"), std::string::npos) << near.refused_by[0];
    }
    const auto two_arms = std::ranges::find(annotation.diagnosis, "TwoArms", &Diagnosis::concept_name);
    ASSERT_NE(two_arms, annotation.diagnosis.end());
    EXPECT_TRUE(two_arms->nearest.empty()) << "nothing is missing";
    for (const int part : two_arms->parts)
        EXPECT_TRUE(two_arms->answers[0].starts_with("part ")) << two_arms->answers[0] << part;
}

/// A rule that is broken in two ways: either alone was enough to know it, and to turn one of them mends nothing.
TEST(Corrections, OfARuleThatIsBrokenInTwoWays) {
    const std::string text =
        "\nClass: :BigBase\n    SubClassOf: core:Incompatible\n    EquivalentTo: :TwinLamp and "
        "(core:hasPart some (:Base and ((core:length some xsd:double[>= 0.01]) or (core:width some "
        "xsd:double[>= 0.02]) or (core:hasSection some core:Round))))\n";
    const auto [domain, annotation] = twin_lamp_with(text);
    ASSERT_EQ(annotation.diagnosis.size(), 1U);
    expect_sound(domain, annotation);
    Names together;
    for (const Diagnosis::Change& change : annotation.diagnosis[0].changes) {
        if (!change.lost.empty()) continue;
        Names features;
        for (const std::size_t i : change.answers) features.push_back(owl::local_name(annotation.answers[i].feature));
        std::ranges::sort(features);
        EXPECT_FALSE(features == Names{"length"} || features == Names{"width"} || features == Names{"Section"});
        if (features.size() > together.size()) together = features;
    }
    EXPECT_EQ(together, (Names{"Section", "length", "width"})) << testing::PrintToString(together);
}

/// What is missing may be one of several kinds, of which the object allows one.
TEST(Corrections, AddAPartOfTheRightKind) {
    const std::string text =
        "\nClass: :Bulb\n    EquivalentTo: core:Region and (core:hasShape some core:Cube) and "
        "(core:hasPosition some core:Down) and (not :HoodWall)\n"
        "Class: :Light\n    EquivalentTo: :Bulb or :Arm\n"
        "Class: :Bright\n    SubClassOf: core:Object\n    EquivalentTo: :TwinLamp and "
        "(core:hasPart max 0 :Bulb)\n"
        "Class: :Dim\n    SubClassOf: core:Incompatible\n    EquivalentTo: :Bright and "
        "(core:hasPart max 8 :Light)\n";
    const auto [domain, annotation] = twin_lamp_with(text);
    ASSERT_EQ(annotation.diagnosis.size(), 1U);
    const Diagnosis& dim = annotation.diagnosis[0];
    ASSERT_EQ(dim.counts.size(), 1U);
    const std::size_t arms = dim.counts[0].bearers.size();
    EXPECT_GT(arms, 0U) << "each Arm is a Light";
    const std::string wanted = std::to_string(9 - arms) + " more Arm (cost ";
    EXPECT_TRUE(std::ranges::any_of(dim.corrections, [&](const std::string& each) { return each.starts_with(wanted); }))
        << wanted << testing::PrintToString(dim.corrections);
}

}  // namespace
}  // namespace partonomy
