#include "algorithms/relation_formula.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>

#include "algorithms/solids.h"
#include "base/errors.h"
#include "shape/membership.h"

namespace partonomy {
namespace {

using solids::block;
using solids::Stage;

/// A stick of 0.8 x 0.1 x 0.1 over a cube of 0.2, and another cube far from both.
struct Boxes {
    Stage stage{
        {block({0, 0, 0.5}, {0.8, 0.1, 0.6}), block({0, 0, 0}, {0.2, 0.2, 0.2}), block({1.8, 0.8, 0.8}, {2, 1, 1})}};
    Boxes() { stage.finish(); }
};

std::optional<double> value(const std::string& text, const Stage& stage, const std::vector<int>& regions) {
    return parse_relation_formula(text)->value(stage.scene, stage.at(regions));
}

std::string error_of(const std::string& text) {
    try {
        static_cast<void>(parse_relation_formula(text));
    } catch (const OntologyError& error) {
        return error.what();
    }
    ADD_FAILURE() << text << " was accepted";
    return {};
}

TEST(RelationFormula, SumsDifferencesProductsAndRatios) {
    const Boxes boxes;
    const Stage& stage = boxes.stage;
    const std::vector<int> pair{0, 1};
    EXPECT_NEAR(*value("length ratio", stage, pair), 4, 1e-9);
    EXPECT_NEAR(*value("length ratio / thickness ratio", stage, pair), 8, 1e-9);  // how much slimmer
    EXPECT_NEAR(*value("length ratio - thickness ratio", stage, pair), 3.5, 1e-9);
    EXPECT_NEAR(*value("2 * (length ratio + 1) - 3", stage, pair), 7, 1e-9);
    EXPECT_NEAR(*value("-length ratio * thickness ratio", stage, pair), -2, 1e-9);
    EXPECT_NEAR(*value("rise - 0.1", stage, pair), 0.25, 1e-9);
    EXPECT_NEAR(*value("gap + side step", stage, pair), 0.3 / stage.scene.diagonal, 1e-9);
    EXPECT_NEAR(*value("opening angle / 2", stage, {0, 1, 2}), *value("opening angle", stage, {0, 1, 2}) / 2, 1e-9);
}

TEST(RelationFormula, UnitsAndRegionsAreThoseOfItsMeasures) {
    EXPECT_EQ(parse_relation_formula("gap + side step")->unit, "diagonal");
    EXPECT_EQ(parse_relation_formula("gap / side step")->unit, "1");
    EXPECT_EQ(parse_relation_formula("rise * drop")->unit, "height2");
    EXPECT_EQ(parse_relation_formula("rise / gap")->unit, "height/diagonal");
    EXPECT_EQ(parse_relation_formula("opening angle / 2")->arity, 3U);
    EXPECT_EQ(parse_relation_formula("rise - drop")->arity, 2U);
    EXPECT_TRUE(parse_relation_formula("length ratio / thickness ratio")->by_size);
    EXPECT_FALSE(parse_relation_formula("length ratio * rise")->by_size);
    EXPECT_EQ(parse_relation_formula("gap").get(), find_relation_measure("gap"));  // the measure itself
}

TEST(RelationFormula, WhatCannotBeToldStaysOpen) {
    const Boxes boxes;
    const Stage& stage = boxes.stage;
    EXPECT_EQ(value("ahead + 1", stage, {0, 1}), std::nullopt);                    // no front
    EXPECT_EQ(value("1 / footprint overlap", stage, {0, 2}), std::nullopt);        // by zero
    EXPECT_EQ(value("plane offset - plane offset", stage, {0, 1}), std::nullopt);  // both infinite
    const std::vector<knowledge::Criterion> open{{"ahead * 0", -1, -1, 1, 1}};
    EXPECT_EQ(relation_score(open, stage.scene, stage.at({0, 1})), std::nullopt);
}

TEST(RelationFormula, ErrorsNameWhatIsWrong) {
    const auto expect_error = [](const std::string& text, const std::string& words) {
        EXPECT_NE(error_of(text).find(words), std::string::npos) << error_of(text);
    };
    expect_error("opening angle - angle", "\"opening angle\" measures 3 regions, but \"angle\" 2");
    expect_error("gap / length", "\"length\" is measured of one region");
    expect_error("gap - rise", "it subtracts diagonal and height");
    expect_error("angle + gap", "it adds degrees and diagonal");
    expect_error("0.5", "no measure is in it");
    expect_error("length-ratio", "there is no measure \"length-ratio\"; did you mean \"length ratio\"?");
    expect_error("gap -", "ends where a measure or a number should stand");
    expect_error("", "ends where a measure or a number should stand");
}

/// A second opinion on shortcuts: by the trapezoid on the value itself, for combinations at random.
TEST(RelationFormula, ShortcutsChangeNothing) {
    constexpr unsigned seed = 31;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto any = [&] { return static_cast<double>(random() % 1000) / 1000; };
    const std::vector<std::string> names{
        "rise",         "side step",       "gap",        "length ratio", "level overlap",
        "plane offset", "thickness ratio", "area ratio", "angle",        "shape difference"};
    int shortcuts = 0, related = 0;
    for (int round = 0; round < 40; ++round) {
        std::vector<solids::Block> blocks;
        for (int i = 0; i < 5; ++i) {
            const Vec3 low(2 * any(), any(), any());
            blocks.push_back(block(low, low + Vec3(0.05 + any(), 0.05 + any() / 2, 0.05 + any() / 4)));
        }
        Stage stage(blocks);
        stage.finish();
        const std::string a = names[random() % names.size()], b = names[random() % names.size()];
        // Divided by one, so that any two can be added.
        for (const std::string& text : {a + " * " + b, a + " / " + b, fmt::format("{} / {} - {}", a, a, any()),
                                        fmt::format("-{} * {}", any(), a)}) {
            const double middle = 2 * any() - 1;
            const std::vector<knowledge::Criterion> criteria{
                {text, middle - 0.5, middle - 0.2, middle + 0.2, middle + 0.5}};
            const RelationTest test(criteria);
            for (int target = 0; target < 5; ++target)
                for (int reference = 0; reference < 5; ++reference) {
                    if (target == reference) continue;
                    const std::vector<int> pair{target, reference};
                    const std::optional<double> x = value(text, stage, pair),
                                                score = test.score(stage.scene, stage.at(pair));
                    const Surround one = surround_of(stage.places[static_cast<std::size_t>(target)]),
                                   other = surround_of(stage.places[static_cast<std::size_t>(reference)]);
                    const std::array<const Surround*, 2> each{&one, &other};
                    shortcuts += test.prospect(stage.scene, each) != RelationTest::Prospect::open;
                    ASSERT_EQ(x.has_value(), score.has_value()) << text;
                    if (!x) continue;
                    const knowledge::Criterion& c = criteria[0];
                    EXPECT_EQ(*score, (Trapezoid{c.a1, c.a2, c.a3, c.a4}(*x))) << text;
                    related += *score >= 0.5;
                }
        }
    }
    EXPECT_GT(shortcuts, 100);
    EXPECT_GT(related, 100);
}

}  // namespace
}  // namespace partonomy
