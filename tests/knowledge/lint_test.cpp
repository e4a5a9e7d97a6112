#include "knowledge/lint.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <set>

#include "base/errors.h"
#include "knowledge/lint_gaps.h"
#include "mini.h"

using namespace partonomy;
using namespace partonomy::knowledge;

namespace {

/// Findings of one kind, in order.
std::vector<Finding> of_kind(const std::vector<Finding>& findings, FindingKind kind) {
    std::vector<Finding> result;
    std::ranges::copy_if(findings, std::back_inserter(result), [&](const Finding& each) { return each.kind == kind; });
    return result;
}

std::vector<std::string> names(const Finding& finding) {
    std::vector<std::string> result;
    for (const Iri& iri : finding.concepts) result.push_back(owl::local_name(iri));
    return result;
}

CompileOptions compiled() {
    CompileOptions options;
    options.listing_limit = 0;
    return options;
}

using mini::both;
using mini::name;
using mini::some;

/// Faults of every kind about regions; axiom n is on line n.
mini::Ontology faulty() {
    mini::Ontology ontology = mini::shapes();  // lines 1 to 8
    ontology
        .same("Seat", both({some("hasShape", "Board"), some("hasOrientation", "Vertical")}))        // 9
        .sub(some("hasShape", "Board"), some("hasOrientation", "Horizontal"))                       // 10
        .sub("Leg", "Region")                                                                       // 11
        .sub(name("Leg"), some("hasShape", "Stick"))                                                // 12
        .same("Top", both({name("Leg"), some("hasOrientation", "Horizontal")}))                     // 13
        .same("A", some("hasShape", "Cube"))                                                        // 14
        .same("B", mini::no(mini::either({some("hasShape", "Board"), some("hasShape", "Stick")})))  // 15
        .same("Upright", some("hasOrientation", "Vertical"))                                        // 16
        .same("Chair", both({some("hasPart", "Seat"), some("hasPart", "Top")}))                     // 17
        .same("Table", both({some("hasPart", "A"), some("hasPart", "B"), some("hasPart", "Upright")}));
    return ontology;
}

TEST(Lint, AGapBetweenMembershipsIsARemark) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const auto value = [](const char* name, double a1, double a2, double a3, double a4) {
        return ElementaryConcept{mini::iri(name), {{"l0/l2", a1, a2, a3, a4}}, {}, {}};
    };
    RangeConcept range{mini::iri("S"), mini::iri("hasS"), {}, true};
    range.values = {value("Slender", 12, 13, inf, inf), value("Stocky", -inf, -inf, 5, 7)};
    EXPECT_EQ(gap_between_values(range), "between 6 and 12.5 of l0/l2 neither Slender nor Stocky fits");
    RangeConcept closed = range;
    closed.values.push_back(value("Middling", 5, 7, 12, 13));
    EXPECT_EQ(gap_between_values(closed), "");
    closed.values[2].criteria.clear();  // known by exclusion
    EXPECT_EQ(gap_between_values(closed), "");
    range.covered = false;  // another value is left for it
    EXPECT_EQ(gap_between_values(range), "");
    range.covered = true;  // ratios below 1 and above 100 do not occur: nobody need fit them
    range.values = {value("Slender", 5, 7, 100, 100), value("Stocky", 1, 1, 5, 7)};
    EXPECT_EQ(gap_between_values(range), "");
}

TEST(Lint, NoMeasurementFitsTwoValuesFully) {
    constexpr double inf = std::numeric_limits<double>::infinity();
    const auto said = [](std::vector<Criterion> one, std::vector<Criterion> other) {
        RangeConcept range{mini::iri("S"), mini::iri("hasS"), {}, false};
        range.values = {{mini::iri("A"), std::move(one), {}, {}}, {mini::iri("B"), std::move(other), {}, {}}};
        const std::vector<ValuesThatBothFit> found = values_that_both_fit(range);
        return found.empty() ? "" : found.front().where;
    };
    EXPECT_EQ(said({{"tilt", -inf, -inf, 35, 45}}, {{"tilt", -inf, -inf, 35, 45}}), "up to 35 of tilt");
    EXPECT_EQ(said({{"tilt", 4, 7, inf, inf}}, {{"tilt", 2, 3, inf, inf}}), "from 7 of tilt on");
    EXPECT_EQ(said({{"tilt", 4, 7, inf, inf}}, {{"tilt", 2, 3, 9, 10}}), "between 7 and 9 of tilt");
    EXPECT_EQ(said({{"tilt", -inf, -inf, inf, inf}}, {{"tilt", -inf, -inf, inf, inf}}), "for any tilt");
    EXPECT_EQ(said({{"tilt", 1, 2, 2, 3}}, {{"tilt", 1, 2, 2, 3}}), "at 2 of tilt");
    // As it should be: slopes that cross, slopes that overlap, values that meet in a number.
    EXPECT_EQ(said({{"tilt", 4, 7, inf, inf}}, {{"tilt", -inf, -inf, 4, 7}}), "");
    EXPECT_EQ(said({{"tilt", 3, 7, inf, inf}}, {{"tilt", -inf, -inf, 5, 9}}), "");
    EXPECT_EQ(said({{"tilt", 5, 5, inf, inf}}, {{"tilt", -inf, -inf, 5, 5}}), "");
    EXPECT_EQ(said({{"tilt", 4, 7, inf, inf}}, {{"span", 4, 7, inf, inf}}), "");
    EXPECT_EQ(said({}, {}), "");  // known by exclusion, or told by a plugin
    // With two criteria one that parts them is enough.
    const Criterion level{"tilt", -inf, -inf, 4, 7}, aslant{"tilt", 4, 7, inf, inf}, wide{"span", 1, 2, inf, inf};
    EXPECT_EQ(said({level, wide}, {wide, aslant}), "");
    EXPECT_EQ(said({level, wide}, {wide, level}), "up to 4 of tilt and from 2 of span on");
    EXPECT_EQ(said({level, wide}, {level}), "");
}

}  // namespace

TEST(Lint, WhatStaysOpen) {
    mini::Ontology ontology = mini::shapes();  // lines 1 to 8
    ontology
        .same("Seat", both({name("Region"), some("madeOf", "Wood"), some("hasShape", "Board")}))  // 9
        .sub("Oak", "Wood")
        .same("Chair", both({name("Object"), some("hasPart", both({name("Seat"), name("Antique")}))}));
    for (const char* declared : {"Antique", "Forgotten", "Oak", "Wood"})
        ontology.result.entities.push_back({owl::EntityKind::klass, mini::iri(declared), {"mini.ttl", 99}});
    const std::vector<Finding> findings = lint(compile(ontology.result), {});
    const std::vector<Finding> open = of_kind(findings, FindingKind::unanswerable);
    ASSERT_EQ(open.size(), 1U);
    EXPECT_EQ(open[0].where.line, 9);
    EXPECT_EQ(open[0].what, "no algorithm tells madeOf, so what Seat asks of it stays open");
    std::vector<std::string> aside;
    for (const Finding& each : of_kind(findings, FindingKind::left_aside)) aside.push_back(names(each).front());
    EXPECT_EQ(aside, (std::vector<std::string>{"Antique", "Forgotten"}));
}

TEST(Lint, NamesFaultsWithPlacesAndCauses) {
    for (const CompileOptions& options : {CompileOptions{}, compiled()}) {
        const Domain domain = compile(faulty().result, options);
        ASSERT_EQ(domain.regions.diagram != nullptr, options.listing_limit == 0);
        const std::vector<Finding> findings = lint(domain);

        const auto unsatisfiable = of_kind(findings, FindingKind::unsatisfiable);
        ASSERT_EQ(unsatisfiable.size(), 2U);  // Seat, and Chair that has one
        EXPECT_EQ(names(unsatisfiable[0]), (std::vector<std::string>{"Seat"}));
        EXPECT_TRUE(unsatisfiable[0].is_wrong);
        EXPECT_EQ(unsatisfiable[0].where.line, 9);
        EXPECT_EQ(unsatisfiable[0].what, "no region can ever be a Seat");
        EXPECT_EQ(unsatisfiable[0].causes, (std::vector<std::vector<std::size_t>>{{8, 9}}));
        EXPECT_EQ(unsatisfiable[1].causes, (std::vector<std::vector<std::size_t>>{{8, 9, 16}}));

        const auto unprovable = of_kind(findings, FindingKind::unprovable);
        ASSERT_EQ(unprovable.size(), 2U);
        EXPECT_EQ(unprovable[0].where.line, 11);
        EXPECT_EQ(unprovable[0].what + "; " + unprovable[0].advice,
                  "Leg has only necessary conditions, so no region can ever be proved to be a Leg; did you mean "
                  "EquivalentTo?");
        EXPECT_EQ(unprovable[1].advice, "give Leg an EquivalentTo");

        const auto alike = of_kind(findings, FindingKind::indistinguishable);
        ASSERT_EQ(alike.size(), 1U);
        EXPECT_EQ(names(alike[0]), (std::vector<std::string>{"A", "B"}));
        EXPECT_TRUE(alike[0].is_wrong);

        const auto overlapping = of_kind(findings, FindingKind::overlapping);
        ASSERT_EQ(overlapping.size(), 2U);
        EXPECT_FALSE(overlapping[0].is_wrong);
        EXPECT_EQ(names(overlapping[0]), (std::vector<std::string>{"A", "Upright"}));
        // What is wrong comes first.
        EXPECT_TRUE(std::ranges::is_sorted(findings, {}, [](const Finding& each) { return !each.is_wrong; }));
    }
}

TEST(Lint, WhatNoAlgorithmAnswers) {
    mini::Ontology ontology = mini::shapes();
    ontology.range("Stuff", {"Oak", "Pine", "Steel"})
        .measured("width")
        .same("Wooden", mini::some("hasStuff", mini::either({mini::name("Oak"), mini::name("Pine")})))
        .same("Wide", mini::number("width", {{"minInclusive", "1"}}))
        .same("Chair", mini::both({mini::some("hasPart", "Wooden"), mini::some("hasPart", "Wide")}));
    const Domain domain = compile(ontology.result);
    LintOptions options;
    std::set<int> missing;  // values of Stuff without an algorithm
    options.can_answer = [&](Question question) { return question.variable != 2 || !missing.contains(question.value); };
    const auto found = [&] { return of_kind(lint(domain, options), FindingKind::unanswerable); };
    ASSERT_EQ(found().size(), 1U);
    EXPECT_EQ(found()[0].what,
              "width has no core:measure, so nothing can answer it and what Wide asks of it stays open");
    missing = {0};  // what is neither pine nor steel is oak
    EXPECT_EQ(found().size(), 1U);
    missing = {0, 1};
    ASSERT_EQ(found().size(), 2U);
    EXPECT_EQ(
        found()[0].what,
        "no algorithm can tell whether the Stuff of a region is Oak or Pine, so what Wooden asks of it stays open");
    EXPECT_TRUE(found()[0].is_wrong);
    const auto unused = of_kind(lint(domain, options), FindingKind::unused);
    ASSERT_FALSE(unused.empty());
    EXPECT_EQ(unused[0].what, "no axiom asks for Board, Cube and Stick of Shape") << unused[0].what;
}

TEST(Lint, SynonymsAreARemark) {
    mini::Ontology ontology = mini::shapes();
    ontology.same("Leg", mini::some("hasShape", "Stick"))
        .same("Foot", mini::name("Leg"))
        .same("Chair", mini::both({mini::some("hasPart", "Leg"), mini::some("hasPart", "Foot")}));
    const auto alike = of_kind(lint(compile(ontology.result)), FindingKind::indistinguishable);
    ASSERT_EQ(alike.size(), 1U);
    EXPECT_FALSE(alike[0].is_wrong);
}

TEST(Lint, UnknownCoreTerms) {
    mini::Ontology ontology = mini::shapes();
    ontology.same("Leg", mini::some("hasShape", "Stick"));
    EXPECT_TRUE(unknown_terms(ontology.result).empty());
    ontology.result.annotations[mini::iri("Leg")].push_back(
        {std::string(owl::core_prefix) + "colour", {"#ff0000", "", ""}, "", {"mini.ttl", 77}});
    auto other = mini::name("Leg");
    auto moved = std::make_shared<owl::ClassExpression>(*other);
    moved->iri = "http://w3id.org/partonomy/core#Board";
    ontology.sub(moved, mini::name("Leg"));
    const std::vector<Finding> found = unknown_terms(ontology.result);
    ASSERT_EQ(found.size(), 2U);
    EXPECT_EQ(found[0].where.line, 10);
    EXPECT_EQ(found[0].advice, "did you mean <https://w3id.org/partonomy/core#Board>?");
    EXPECT_EQ(found[1].where.line, 77);
    EXPECT_EQ(found[1].what + "; " + found[1].advice,
              "core:colour is no term of the core ontology; did you mean core:color?");
}

TEST(Lint, WhyAnOntologyIsRefused) {
    mini::Ontology ontology = mini::shapes();
    ontology.same("Chair", some("hasPart", "Thing"))
        .sub(name("Region"), some("hasShape", "Board"))
        .sub(name("Region"), some("hasOrientation", "Vertical"))
        .sub(some("hasShape", "Board"), name("Nothing"));
    std::string error;
    try {
        (void)compile(ontology.result);
    } catch (const OntologyError& e) {
        error = e.what();
    }
    EXPECT_TRUE(error.starts_with("mini.ttl:12: ")) << error;
    EXPECT_NE(error.find("mini.ttl:10"), std::string::npos) << error;
    EXPECT_EQ(error.find("mini.ttl:11"), std::string::npos) << "not to blame: " << error;
    const Finding finding = why_refused(ontology.result, error).at(0);
    EXPECT_EQ(finding.kind, FindingKind::contradiction);
    EXPECT_EQ(finding.causes, (std::vector<std::vector<std::size_t>>{{9, 11}}));
    const Finding refused =
        why_refused(mini::shapes().sub("Board", "Stick").result, "mini.ttl:9: something is wrong").at(0);
    EXPECT_EQ(refused.kind, FindingKind::refused);
    EXPECT_EQ(refused.where.line, 9);
    EXPECT_EQ(refused.what, "something is wrong");
}

/// Each fault by itself is refused in the same words, so nothing is a fault only because of another one.
TEST(Lint, AllRefusalsAtOnce) {
    const auto sound = [] {
        mini::Ontology ontology = mini::shapes();
        ontology.same("Seat", some("hasShape", "Board")).same("Chair", both({name("Object"), some("hasPart", "Seat")}));
        return ontology;
    };
    const std::vector<std::function<void(mini::Ontology&)>> faults{
        [](mini::Ontology& o) {
            o.same("Leg", both({name("Region"), name("Stick")}));
        },
        [](mini::Ontology& o) {
            o.same("Stool", both({name("Object"), name("Leg"), name("Seat")}));
        },
        [](mini::Ontology& o) {
            o.same("Back", both({name("Region"), some("hasShape", "Vertical")}));
        },
        [](mini::Ontology& o) { o.sub(name("Seat"), some("hasPart", "Leg")); },
        [](mini::Ontology& o) {
            o.same("Bed", both({name("Object"), mini::at_least(200000, mini::name("Seat"))}));
        }};
    mini::Ontology all = sound();
    std::vector<std::string> wanted;
    const auto without_line = [](const std::string& text) { return text.substr(text.find(": ") + 2); };
    for (const auto& fault : faults) {
        fault(all);
        mini::Ontology one = sound();
        one.same("Leg", both({name("Region"), some("hasShape", "Stick")}));
        fault(one);
        try {
            (void)compile(one.result);
            ADD_FAILURE() << "not refused";
        } catch (const OntologyError& error) {
            wanted.push_back(without_line(error.what()));
        }
    }
    std::string first;
    try {
        (void)compile(all.result);
    } catch (const OntologyError& error) {
        first = error.what();
    }
    std::vector<std::string> found;
    for (const Finding& finding : why_refused(all.result, first)) {
        EXPECT_EQ(finding.kind, FindingKind::refused);
        EXPECT_GT(finding.where.line, 0);
        found.push_back(finding.what);
    }
    EXPECT_EQ(found, wanted);
    EXPECT_EQ(all_refusals(sound().result), std::vector<std::string>{});
}

TEST(Lint, AForgottenRangeAndAWholeInARelationAreMended) {
    mini::Ontology ranged = mini::shapes();
    ranged.sub("Stance", "Feature")
        .axiom(owl::AxiomKind::disjoint_union, {name("Stance"), name("Steady"), name("Tippy")})
        .axiom(owl::AxiomKind::functional_object_property, {}, "hasStance")
        .same("Base", both({some("hasShape", "Board"), some("hasStance", "Tippy")}))
        .same("Lamp", some("hasPart", "Base"));
    const std::vector<std::string> refused = all_refusals(ranged.result);
    ASSERT_EQ(refused.size(), 1U);
    EXPECT_NE(refused[0].find("hasStance leads to Stance; give it the range Stance"), std::string::npos) << refused[0];

    mini::Ontology whole = mini::shapes();
    whole.sub("Stem", "CompositePart")
        .same("Pole", some("hasShape", "Stick"))
        .same("Stem", both({name("CompositePart"), some("hasPart", "Pole")}))
        .same("Seat", both({some("hasShape", "Board"), name("Stem")}))
        .same("Lamp", both({name("Object"), some("hasPart", "Stem")}));
    bool is_told = false;
    for (const std::string& text : all_refusals(whole.result))
        is_told |= text.find("Stem is a composite part where a region is meant; write Pole, of which it consists") !=
                   std::string::npos;
    EXPECT_TRUE(is_told);
}

TEST(Lint, KnobsOutsideOfTheNamespaceOfCoreAreRemarked) {
    mini::Ontology ontology = mini::shapes();
    ontology.same("Seat", some("hasShape", "Board")).same("Chair", both({name("Object"), some("hasPart", "Seat")}));
    owl::Annotation measure{"urn:test#measure", {"l0/l1", "", ""}, "", {"mini.ttl", 77}};
    ontology.result.annotations[mini::iri("Board")].push_back(measure);
    ontology.result.annotations[mini::iri("Stick")].push_back(measure);                   // told once
    owl::Annotation maker{"urn:test#maker", {"somebody", "", ""}, "", {"mini.ttl", 78}};  // no knob
    ontology.result.annotations[mini::iri("Board")].push_back(maker);
    ontology.note("Cube", "cost", "3");
    std::vector<Finding> findings;
    for (Finding& finding : unknown_terms(ontology.result))
        if (!finding.is_wrong) findings.push_back(std::move(finding));
    ASSERT_EQ(findings.size(), 1U);
    EXPECT_EQ(findings[0].what, "\"measure\" of Board is <urn:test#measure>, which nothing here reads");
    EXPECT_EQ(findings[0].advice, "write core:measure if that is meant");
    EXPECT_EQ(findings[0].where.line, 77);
}

TEST(Lint, IsQuickOnAThousandConcepts) {
    mini::Ontology ontology;
    for (int i = 0; i < 500; ++i) {
        const std::string n = std::to_string(i);
        ontology.range("F" + n, {"yes" + n, "no" + n});
    }
    const auto has = [](int i, bool yes) {
        const std::string n = std::to_string(i);
        return some("hasF" + n, (yes ? "yes" : "no") + n);
    };
    for (int i = 0; i + 3 < 500; ++i)
        ontology.sub(both({name("Region"), has(i, true), has(i + 1, false)}),
                     mini::either({has(i + 2, true), has(i + 3, true)}));
    for (int i = 0; i + 2 < 500; ++i) {
        const std::string n = std::to_string(i);
        ontology.same("P" + n, both({has(i, true), has(i + 1, i % 2 == 0)}))
            .same("Q" + n, both({has(i + 1, i % 2 == 0), has(i, true)}));
    }
    ontology.same("Chair", some("hasPart", "P0"));
    const Domain domain = compile(ontology.result);
    ASSERT_NE(domain.regions.diagram, nullptr);
    const std::vector<Finding> findings = lint(domain);
    EXPECT_EQ(of_kind(findings, FindingKind::indistinguishable).size(), 498U);
}

TEST(Lint, VeryManyConceptsAreNotCompared) {
    mini::Ontology ontology;
    for (int i = 0; i < 3001; ++i) ontology.sub("C" + std::to_string(i), "Region");
    ontology.same("Chair", some("hasPart", "C1"));
    const std::vector<Finding> findings = lint(compile(ontology.result));
    const std::vector<Finding> uncounted = of_kind(findings, FindingKind::uncounted);
    ASSERT_EQ(uncounted.size(), 1U);
    EXPECT_NE(uncounted[0].what.find("too many to compare"), std::string::npos) << uncounted[0].what;
    EXPECT_EQ(of_kind(findings, FindingKind::unprovable).size(), 3001U);
}
