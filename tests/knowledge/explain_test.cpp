#include "knowledge/explain.h"

#include <gtest/gtest.h>

#include "mini.h"

using namespace mini;
using namespace partonomy::knowledge;

namespace {

Domain benches() {
    Ontology ontology = shapes();
    ontology
        .same("Seat", both({some("hasShape", "Board"), some("hasOrientation", "Horizontal")}))  // line 9
        .same("Foot", some("hasOrientation", "Vertical"))                                       // line 10
        .same("Bench", both({some("hasPart", "Seat"), at_least(2, name("Foot"))}))              // line 11
        .same("CubeFoot", both({name("Bench"), some("hasPart", both({name("Foot"), some("hasShape", "Cube")}))}))
        .sub("CubeFoot", "Incompatible")
        .same("NoFoot", both({some("hasPart", "Seat"), at_most(0, name("Foot"))}))
        .sub("NoFoot", "Incompatible")
        .same("LyingCube", both({some("hasShape", "Cube"), some("hasOrientation", "Horizontal")}))
        .sub("LyingCube", "Incompatible");
    return compile(ontology.result);
}

constexpr Question board{0, 0}, cube{0, 1}, stick{0, 2}, horizontal{1, 0}, vertical{1, 1};

/// A seat, a board and a cube as feet, and the answers that say so.
Knowledge bench_with_cube() {
    return {3,
            true,
            {{0, board, true},
             {0, horizontal, true},
             {1, board, true},
             {1, vertical, true},
             {2, board, false},
             {2, stick, false},
             {2, vertical, true}}};
}

std::vector<std::string> names(const Space& space, const std::vector<ConceptId>& ids) {
    std::vector<std::string> result;
    for (const ConceptId id : ids) result.push_back(owl::local_name(space.concepts[static_cast<std::size_t>(id)].iri));
    return result;
}

std::vector<std::string> classes(const Conclusions& conclusions) {
    return names(*conclusions.objects, entailed(*conclusions.objects, conclusions.object));
}

}  // namespace

TEST(Explain, ConcludesFromParts) {
    const Domain domain = benches();
    Knowledge knowledge{2, false, {{0, board, true}, {0, horizontal, true}, {1, vertical, true}}};
    EXPECT_TRUE(classes(conclude(domain, knowledge)).empty());  // another foot may turn up
    knowledge.complete = true;
    EXPECT_TRUE(classes(conclude(domain, knowledge)).empty());
    const Conclusions two = conclude(domain, knowledge);
    EXPECT_FALSE(two.object.intersects(two.objects->concepts[*two.objects->find(iri("Bench"))].where));
    knowledge.region_count = 3;
    knowledge.answers.push_back({2, vertical, true});
    EXPECT_EQ(classes(conclude(domain, knowledge)), (std::vector<std::string>{"Bench"}));
    EXPECT_TRUE(conclude(domain, knowledge).diagnoses.empty());
}

TEST(Explain, EitherOfTwoIsAConclusionToo) {
    Ontology ontology = shapes();
    ontology.same("A", either({some("hasPart", some("hasOrientation", "Vertical")),
                               some("hasPart", some("hasOrientation", "Horizontal"))}));
    const Domain domain = compile(ontology.result);
    EXPECT_EQ(classes(conclude(domain, {1, false, {}})).size(), 1U);
    EXPECT_EQ(classes(conclude(domain, {0, false, {}})).size(), 0U);
}

TEST(Explain, MinimalReasonsForADiagnosis) {
    const Domain domain = benches();
    const Knowledge knowledge = bench_with_cube();
    EXPECT_EQ(conclude(domain, knowledge).diagnoses, (std::vector{iri("CubeFoot")}));
    const Explanation explanation = explain(domain, knowledge, iri("CubeFoot"));
    EXPECT_EQ(explanation.answers, (std::vector<std::size_t>{0, 1, 3, 4, 5, 6}));  // not that the other foot is a board
    EXPECT_EQ(explanation.axioms, (std::vector<std::size_t>{8, 9, 10, 11}));
    EXPECT_FALSE(explanation.needs_completeness);
    EXPECT_EQ(culprits(domain, knowledge, iri("CubeFoot")), (std::vector{2}));
}

TEST(Explain, AbsenceNeedsCompleteness) {
    const Domain domain = benches();
    const Knowledge knowledge{
        2, true, {{0, board, true}, {0, horizontal, true}, {1, vertical, false}, {1, board, true}}};
    EXPECT_EQ(conclude(domain, knowledge).diagnoses, (std::vector{iri("NoFoot")}));
    const Explanation explanation = explain(domain, knowledge, iri("NoFoot"));
    EXPECT_TRUE(explanation.needs_completeness);
    EXPECT_EQ(explanation.answers.size(), 3U);  // that one is no foot, and that the other is a seat
    EXPECT_THROW((void)explain(domain, knowledge, iri("Bench")), std::invalid_argument);
}

TEST(Explain, DiagnosesOfRegions) {
    const Domain domain = benches();
    const Knowledge knowledge{2, false, {{0, board, true}, {1, cube, true}, {1, horizontal, true}}};
    EXPECT_EQ(conclude(domain, knowledge).diagnoses, (std::vector{iri("LyingCube")}));
    EXPECT_EQ(culprits(domain, knowledge, iri("LyingCube")), (std::vector{1}));
    EXPECT_EQ(explain(domain, knowledge, iri("LyingCube")).answers, (std::vector<std::size_t>{1, 2}));
    EXPECT_EQ(corrections(domain, knowledge, iri("LyingCube"), {1, 1, 1}).size(), 2U);
}

TEST(Explain, Contradictions) {
    const Domain domain = benches();
    Knowledge knowledge{1, false, {{0, vertical, true}, {0, board, true}, {0, stick, true}}};
    EXPECT_TRUE(conclude(domain, knowledge).contradiction);
    const Explanation explanation = explain(domain, knowledge, "");
    EXPECT_EQ(explanation.answers, (std::vector<std::size_t>{1, 2}));
    EXPECT_TRUE(explanation.axioms.empty());  // that shapes exclude each other goes without saying
    knowledge.answers.pop_back();
    EXPECT_THROW((void)explain(domain, knowledge, ""), std::invalid_argument);
}

TEST(Explain, ContradictionWithAnAxiom) {
    Ontology ontology = shapes();
    ontology.same("Chair", some("hasPart", some("hasShape", "Board")))
        .sub(name("Chair"), at_most(1, some("hasShape", "Stick")));
    const Domain domain = compile(ontology.result);
    const Knowledge knowledge{4, false, {{0, board, true}, {1, stick, true}, {2, stick, true}, {3, stick, true}}};
    const Conclusions conclusions = conclude(domain, knowledge);
    EXPECT_TRUE(conclusions.contradiction);
    EXPECT_TRUE(conclusions.object.is_empty());
    const Explanation explanation = explain(domain, knowledge, "");
    ASSERT_EQ(explanation.answers.size(), 3U);  // the board, and two of the three sticks
    EXPECT_EQ(explanation.answers[0], 0U);
    EXPECT_EQ(explanation.axioms, (std::vector<std::size_t>{8, 9}));
    const Explanations all = all_explanations(domain, knowledge, "");
    EXPECT_TRUE(all.is_complete);
    EXPECT_EQ(all.sets.size(), 3U);
}

TEST(Explain, CorrectionsAreVerifiedAndRanked) {
    const Domain domain = benches();
    const Knowledge knowledge = bench_with_cube();
    const std::vector<double> costs{0.9, 0.8, 0.7, 0.6, 0.5, 0.1, 0.4};
    const auto found = corrections(domain, knowledge, iri("CubeFoot"), costs);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(found[0].answers, (std::vector<std::size_t>{5}));  // it was a stick after all
    for (std::size_t i = 1; i < found.size(); ++i) EXPECT_LE(found[i - 1].cost, found[i].cost);
    for (const Correction& correction : found) {
        Knowledge changed = knowledge;
        for (const std::size_t i : correction.answers) {
            changed.answers[i].yes = !changed.answers[i].yes;
            EXPECT_NE(i, 2U) << "the board among the feet is innocent";
        }
        EXPECT_FALSE(conclude(domain, changed).contradiction);
        EXPECT_TRUE(std::ranges::count(conclude(domain, changed).diagnoses, iri("CubeFoot")) == 0);
    }
}

TEST(Explain, RefusesAnswersAboutNothing) {
    const Domain domain = benches();
    EXPECT_THROW((void)conclude(domain, {1, false, {{1, board, true}}}), std::invalid_argument);
    EXPECT_THROW((void)conclude(domain, {1, false, {{0, {7, 0}, true}}}), std::invalid_argument);
    EXPECT_THROW((void)conclude(domain, {1, false, {{0, {0, 9}, true}}}), std::invalid_argument);
    EXPECT_THROW((void)corrections(domain, {1, false, {{0, board, true}}}, iri("Bench"), {}), std::invalid_argument);
}
