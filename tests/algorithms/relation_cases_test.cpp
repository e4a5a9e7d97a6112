/* Every relation of core.ttl on regions of which the truth is known by construction: some that are in it, some that are
 * not, and some on the border, turned about up, moved, scaled, and with noise of 0.5 % of the diagonal. */

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>
#include <set>

#include "algorithms/measures.h"
#include "algorithms/solids.h"
#include "base/files.h"
#include "knowledge/theory.h"
#include "shape/membership.h"

namespace partonomy {
namespace {

using solids::block;
using solids::Stage;

const std::string core_support = std::string(owl::core_prefix) + "Support";

const knowledge::Relation& relation(const std::string& name) {
    static const std::vector<knowledge::Relation> all =
        knowledge::find_relations(owl::parse_ontology(owl::core_ontology_text(), "core.ttl"));
    for (const knowledge::Relation& each : all)
        if (owl::local_name(each.iri) == name) return each;
    throw std::invalid_argument(name);
}

enum class Truth { yes, no, border, unknown };

/// Regions 0 (the target), 1 (and 2) are asked about; the others are what the object needs besides.
struct Case {
    std::string relation;
    Truth truth;
    std::function<void(Stage&, int)> build;  ///< with faces cut into so many steps
};

/// Boxes only.
Case boxes(const std::string& relation, Truth truth, std::vector<solids::Block> blocks) {
    return {relation, truth, [blocks](Stage& stage, int steps) {
                for (const solids::Block& each : blocks) stage.add(each, steps);
            }};
}

solids::Block tilted(solids::Block box, double degrees, const Vec3& axis) {
    box.axes = Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis).toRotationMatrix() * box.axes;
    return box;
}

/// A plate under everything: the object's box is 2 by 1 by what stands on it, its diagonal near 2.45 with height 1.
solids::Block plate() { return block({0, 0, -0.1}, {2, 1, 0}); }
solids::Block mast() { return block({1.9, 0.9, 0}, {2, 1, 0.9}); }
/// Stands up at the back, so that the front is towards low y.
solids::Block back() { return block({0, 0.9, 0}, {2, 1, 0.9}); }

std::vector<Case> cases() {
    const double diagonal = std::sqrt(4.0 + 1 + 1);
    const auto cube = [](double x, double y, double z) { return block({x, y, z}, {x + 0.2, y + 0.2, z + 0.2}); };
    const auto gap_of = [&](double share) {
        return std::vector{cube(0.5, 0.4, 0.3), cube(0.7 + share * diagonal, 0.4, 0.3), plate(), mast()};
    };
    const auto stick = [](double x, double y, double z, double length = 0.6) {
        return block({x, y, z}, {x + length, y + 0.1, z + 0.1});
    };
    const auto board = [](double x, double y, double z, double thickness = 0.1) {
        return block({x, y, z}, {x + 0.6, y + 0.5, z + thickness});
    };
    const Vec3 x = Vec3::UnitX(), z = Vec3::UnitZ();
    std::vector<Case> all{
        boxes("Connected", Truth::yes, gap_of(0)),
        boxes("Connected", Truth::no, gap_of(0.05)),
        boxes("Connected", Truth::border, gap_of(0.01)),
        boxes("Close", Truth::yes, gap_of(0.02)),
        boxes("Close", Truth::no, gap_of(0.15)),
        boxes("Close", Truth::border, gap_of(0.075)),
        boxes("Far", Truth::yes, gap_of(0.3)),
        boxes("Far", Truth::no, gap_of(0.1)),
        boxes("Far", Truth::border, gap_of(0.2)),
        // A board on edge along a stick; on its end.
        boxes("TouchesAlong", Truth::yes, {stick(0.5, 0.4, 0.1), board(0.5, 0.5, 0.1), plate(), mast()}),
        boxes("TouchesAlong", Truth::no,
              {block({0.5, 0.4, 0.1}, {0.6, 0.5, 0.9}), board(0.5, 0.4, 0), plate(), mast()}),
        boxes("TouchesAlong", Truth::no, {cube(0.5, 0.2, 0.3), cube(0.9, 0.6, 0.3), plate(), mast()}),
        boxes("UpFrom", Truth::yes, {cube(0.5, 0.4, 0.6), cube(0.5, 0.4, 0.1), plate(), mast()}),
        boxes("UpFrom", Truth::no, {cube(0.5, 0.4, 0.1), cube(0.5, 0.4, 0.6), plate(), mast()}),
        boxes("UpFrom", Truth::no, {cube(0.1, 0.4, 0.6), cube(1.5, 0.4, 0.1), plate(), mast()}),
        boxes("UpFrom", Truth::border, {cube(0.5, 0.4, 0.2), cube(0.5, 0.4, 0.1), plate(), mast()}),
        boxes("Below", Truth::yes, {cube(0.5, 0.4, 0.1), cube(0.5, 0.4, 0.6), plate(), mast()}),
        boxes("Below", Truth::no, {cube(0.5, 0.4, 0.6), cube(0.5, 0.4, 0.1), plate(), mast()}),
        boxes("Below", Truth::border, {cube(0.5, 0.4, 0.1), cube(0.5, 0.4, 0.2), plate(), mast()}),
        boxes("Beside", Truth::yes, {cube(0.5, 0.4, 0.3), cube(0.8, 0.4, 0.3), plate(), mast()}),
        boxes("Beside", Truth::no, {cube(0.5, 0.4, 0.1), cube(0.5, 0.4, 0.5), plate(), mast()}),
        boxes("Beside", Truth::no, {cube(0.1, 0.4, 0.1), cube(1.6, 0.4, 0.1), plate(), mast()}),
        boxes("Beside", Truth::border, {cube(0.5, 0.4, 0.1), cube(0.8, 0.4, 0.23), plate(), mast()}),
        boxes("InFrontOf", Truth::yes, {cube(0.5, 0.1, 0), cube(0.5, 0.6, 0), plate(), back()}),
        boxes("InFrontOf", Truth::no, {cube(0.5, 0.6, 0), cube(0.5, 0.1, 0), plate(), back()}),
        boxes("InFrontOf", Truth::border, {cube(0.5, 0.4, 0), cube(0.9, 0.5, 0), plate(), back()}),
        boxes("InFrontOf", Truth::unknown, {cube(0.9, 0.1, 0), cube(0.9, 0.7, 0), plate()}),
        boxes("Behind", Truth::yes, {cube(0.5, 0.6, 0), cube(0.5, 0.1, 0), plate(), back()}),
        boxes("Behind", Truth::no, {cube(0.5, 0.1, 0), cube(0.5, 0.6, 0), plate(), back()}),
        boxes("Behind", Truth::border, {cube(0.5, 0.5, 0), cube(0.9, 0.4, 0), plate(), back()}),
        boxes("Behind", Truth::unknown, {cube(0.9, 0.7, 0), cube(0.9, 0.1, 0), plate()}),
        boxes("Between", Truth::yes, {cube(0.8, 0.4, 0.3), cube(0.2, 0.4, 0.3), cube(1.4, 0.4, 0.3), plate(), mast()}),
        boxes("Between", Truth::no, {cube(0.2, 0.4, 0.3), cube(0.8, 0.4, 0.3), cube(1.4, 0.4, 0.3), plate(), mast()}),
        boxes("Inside", Truth::yes, {cube(0.5, 0.4, 0.3), block({0.3, 0.2, 0}, {1, 0.8, 0.8}), plate(), mast()}),
        boxes("Inside", Truth::no, {block({0.3, 0.2, 0}, {1, 0.8, 0.8}), cube(0.5, 0.4, 0.3), plate(), mast()}),
        boxes("Inside", Truth::no, {cube(0.5, 0.4, 0.3), block({0.6, 0.2, 0}, {1, 0.8, 0.8}), plate(), mast()}),
        // Four of the cube's sides end after 0.76 of their length, the fifth is inside: 0.8 of it.
        boxes("Inside", Truth::border,
              {block({0.5, 0.4, 0.3}, {0.7, 0.6, 0.5}), block({0.3, 0.2, 0}, {0.5 + 0.2 * 0.95, 0.8, 0.8}), plate(),
               mast()}),
        {"Around", Truth::yes,
         [cube](Stage& stage, int steps) {
             stage.add_ring({0.6, 0.5, 0.3}, 0.25, 0.05);
             for (const solids::Block& each : {cube(0.5, 0.4, 0.2), plate(), mast()}) stage.add(each, steps);
         }},
        {"Around", Truth::no,  // the other way round
         [cube](Stage& stage, int steps) {
             stage.add(cube(0.5, 0.4, 0.2), steps);
             stage.add_ring({0.6, 0.5, 0.3}, 0.25, 0.05);
             for (const solids::Block& each : {plate(), mast()}) stage.add(each, steps);
         }},
        {"Around", Truth::no,  // beside it
         [cube](Stage& stage, int steps) {
             stage.add_ring({1.3, 0.5, 0.3}, 0.25, 0.05);
             for (const solids::Block& each : {cube(0.5, 0.4, 0.2), plate(), mast()}) stage.add(each, steps);
         }},
        {"Around", Truth::no,  // above it
         [cube](Stage& stage, int steps) {
             stage.add_ring({0.6, 0.5, 0.7}, 0.25, 0.05);
             for (const solids::Block& each : {cube(0.5, 0.4, 0.2), plate(), mast()}) stage.add(each, steps);
         }},
        boxes("Parallel", Truth::yes, {board(0.2, 0.2, 0.1), board(1, 0.2, 0.6), plate(), mast()}),
        boxes("Parallel", Truth::yes, {board(0.2, 0.2, 0.1), stick(1, 0.2, 0.6), plate(), mast()}),
        boxes("Parallel", Truth::no, {board(0.2, 0.2, 0.1), tilted(board(1, 0.2, 0.3), 40, x), plate(), mast()}),
        boxes("Parallel", Truth::border, {stick(0.2, 0.2, 0.1), tilted(stick(1, 0.4, 0.3), 10, z), plate(), mast()}),
        boxes("Orthogonal", Truth::yes, {stick(0.2, 0.2, 0.1), tilted(stick(0.8, 0.4, 0.3), 90, z), plate(), mast()}),
        boxes("Orthogonal", Truth::yes, {block({0.5, 0.5, 0}, {0.6, 0.6, 0.8}), board(1, 0.2, 0.6), plate(), mast()}),
        boxes("Orthogonal", Truth::no, {board(0.2, 0.2, 0.1), board(1, 0.2, 0.6), plate(), mast()}),
        boxes("Orthogonal", Truth::border,
              {stick(0.2, 0.2, 0.1), tilted(stick(0.8, 0.4, 0.3), 80, z), plate(), mast()}),
        boxes("Coplanar", Truth::yes, {board(0.2, 0.2, 0.3), board(1, 0.2, 0.3), plate(), mast()}),
        boxes("Coplanar", Truth::yes, {board(0.2, 0.2, 0.3), board(1, 0.2, 0.3, 0.2), plate(), mast()}),
        boxes("Coplanar", Truth::no, {board(0.2, 0.2, 0.3), board(1, 0.2, 0.6), plate(), mast()}),
        boxes("Coplanar", Truth::no, {stick(0.2, 0.2, 0.3), stick(1, 0.2, 0.3), plate(), mast()}),
        boxes("Coplanar", Truth::border, {board(0.2, 0.2, 0.3), board(1, 0.2, 0.3 + 0.02 * diagonal), plate(), mast()}),
        boxes("Collinear", Truth::yes, {stick(0.2, 0.4, 0.3), stick(1.1, 0.4, 0.3), plate(), mast()}),
        boxes("Collinear", Truth::no, {stick(0.2, 0.4, 0.3), stick(1.1, 0.6, 0.3), plate(), mast()}),
        boxes("Collinear", Truth::no, {board(0.2, 0.2, 0.3), board(1, 0.2, 0.3), plate(), mast()}),
        boxes("Collinear", Truth::border,
              {stick(0.2, 0.4, 0.3), stick(1.1, 0.4 + 0.02 * diagonal, 0.3), plate(), mast()}),
        boxes("Aligned", Truth::yes, {cube(0.2, 0.4, 0.3), stick(1.1, 0.45, 0.35), plate(), mast()}),
        boxes("Aligned", Truth::yes, {cube(0.2, 0.4, 0), cube(0.2, 0.4, 0.7), plate(), mast()}),
        boxes("Aligned", Truth::no, {cube(0.2, 0.4, 0.3), cube(0.8, 0.1, 0.3), plate(), mast()}),
        boxes("Aligned", Truth::border, {cube(0.2, 0.4, 0.3), cube(0.8, 0.4 + 0.02 * diagonal, 0.3), plate(), mast()}),
        boxes("Symmetric", Truth::yes,
              {tilted(stick(0.2, 0.4, 0.3), 30, z), tilted(stick(1.2, 0.4, 0.3), -30, z), plate(), mast()}),
        boxes("Symmetric", Truth::no,
              {tilted(stick(0.2, 0.4, 0.3), 30, z), tilted(stick(1.2, 0.4, 0.3), 30, z), plate(), mast()}),
        boxes("Symmetric", Truth::no, {cube(0.2, 0.4, 0.3), cube(1.4, 0.4, 0.3), plate(), mast()}),
        boxes("Symmetric", Truth::border,
              {cube(0.2, 0.4, 0.3), cube(1.6, 0.4, 0.3 + 0.02 * diagonal), plate(), mast()}),
        boxes("SameShape", Truth::yes, {stick(0.2, 0.4, 0.3), block({1, 0.2, 0.1}, {1.2, 0.4, 1.3}), plate(), mast()}),
        boxes("SameShape", Truth::no, {stick(0.2, 0.4, 0.3), cube(1, 0.4, 0.3), plate(), mast()}),
        boxes("SameShape", Truth::border,
              {stick(0.2, 0.4, 0.3), stick(1, 0.4, 0.3, 0.6 * std::exp(0.2)), plate(), mast()}),
        boxes("SameSize", Truth::yes, {stick(0.2, 0.4, 0.3), block({1, 0.2, 0.1}, {1.1, 0.3, 0.7}), plate(), mast()}),
        boxes("SameSize", Truth::no, {stick(0.2, 0.4, 0.3), block({1, 0.2, 0.1}, {1.2, 0.4, 1.3}), plate(), mast()}),
        boxes("SameSize", Truth::border,
              {stick(0.2, 0.4, 0.3), stick(1, 0.4, 0.3, 0.6 * std::exp(0.2)), plate(), mast()}),
    };
    return all;
}

std::optional<double> score(const Case& test, const solids::Motion& motion, int steps, std::mt19937& random) {
    Stage stage({});
    test.build(stage, steps);
    stage.move(motion, random);
    stage.finish();
    const knowledge::Relation& asked = relation(test.relation);
    std::vector<int> regions(asked.arity);
    std::iota(regions.begin(), regions.end(), 0);
    return relation_score(asked.criteria, stage.scene, stage.at(regions));
}

TEST(RelationCases, TruthIsKnown) {
    constexpr unsigned seed = 11;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const std::vector<Case> all = cases();
    for (std::size_t i = 0; i < all.size(); ++i) {
        SCOPED_TRACE("case " + std::to_string(i) + ": " + all[i].relation);
        for (int round = 0; round < 4; ++round) {
            const auto found = score(all[i], solids::random_motion(random, 0), round == 0 ? 1 : 3, random);
            if (all[i].truth == Truth::unknown) {
                EXPECT_FALSE(found);
                continue;
            }
            ASSERT_TRUE(found);
            const double expected = all[i].truth == Truth::yes ? 1 : all[i].truth == Truth::no ? 0 : 0.5;
            EXPECT_NEAR(*found, expected, all[i].truth == Truth::border ? 0.02 : 0.1);
        }
    }
}

TEST(RelationCases, NoiseDoesNotTurnThemRound) {
    constexpr unsigned seed = 12;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    for (const Case& each : cases()) {
        SCOPED_TRACE(each.relation);
        if (each.truth == Truth::border) continue;
        for (int round = 0; round < 3; ++round) {
            const auto found = score(each, solids::random_motion(random, 0.005), 8, random);
            if (each.truth == Truth::unknown) {
                EXPECT_FALSE(found);
                continue;
            }
            ASSERT_TRUE(found);
            EXPECT_EQ(*found >= 0.5, each.truth == Truth::yes) << *found;
        }
    }
}

/// Not a relation between regions, since the ground is none.
TEST(RelationCases, OnTheGround) {
    constexpr unsigned seed = 13;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const auto ranges = knowledge::find_ranges(owl::parse_ontology(owl::core_ontology_text(), "core.ttl"));
    const auto support = std::ranges::find(ranges, core_support, &knowledge::RangeConcept::iri);
    ASSERT_NE(support, ranges.end());
    for (const auto& [height, expected] : {std::pair(0.0, 1.0), {0.015, 1.0}, {0.03, 0.5}, {0.1, 0.0}, {0.5, 0.0}})
        for (const double noise : {0.0, 0.0, 0.005}) {
            if (noise > 0 && expected == 0.5) continue;
            Stage stage({block({0.1, 0.1, height}, {0.3, 0.3, height + 0.2}), block({0.5, 0.5, 0}, {0.6, 0.6, 1})}, 6);
            stage.move(solids::random_motion(random, noise), random);
            stage.finish();
            stage.object.low = stage.scene.low.z();
            stage.object.high = stage.scene.high.z();
            const RegionMeasurements region = measure_region(stage.object, stage.parts[0]);
            for (const knowledge::ElementaryConcept& value : support->values) {
                const knowledge::Criterion& c = value.criteria.at(0);
                const double score =
                    Trapezoid{c.a1, c.a2, c.a3, c.a4}(*evaluate(*find_measure(c.measure), stage.object, region));
                EXPECT_NEAR(score, value.iri.ends_with("OnGround") ? expected : 1 - expected, noise > 0 ? 0.49 : 0.02)
                    << height << " " << noise;
            }
        }
}

/// docs/relations.md has a row for each relation, with its regions, cost and criteria.
TEST(RelationCases, TheDocumentListsThem) {
    const std::string text = read_file(PARTONOMY_SOURCE_DIR "/docs/relations.md");
    std::size_t rows = 0;
    for (std::size_t at = text.find("\n| `"); at != std::string::npos; at = text.find("\n| `", at + 1)) ++rows;
    const std::vector<knowledge::Relation> all =
        knowledge::find_relations(owl::parse_ontology(owl::core_ontology_text(), "core.ttl"));
    EXPECT_EQ(rows, all.size());
    for (const knowledge::Relation& each : all) {
        std::string row = fmt::format("| `{}` | {} | {} | ", owl::local_name(each.iri), each.arity, *each.cost);
        for (const knowledge::Criterion& c : each.criteria)
            row +=
                fmt::format("{}`{} {} {} {} {}`", row.ends_with("| ") ? "" : ", ", c.measure, c.a1, c.a2, c.a3, c.a4);
        EXPECT_NE(text.find(row + " | "), std::string::npos) << row;
    }
}

/// No relation of core.ttl is left out.
TEST(RelationCases, CoverTheCore) {
    std::map<std::string, std::set<Truth>> tested;
    for (const Case& each : cases()) tested[each.relation].insert(each.truth);
    const std::vector<knowledge::Relation> all =
        knowledge::find_relations(owl::parse_ontology(owl::core_ontology_text(), "core.ttl"));
    EXPECT_GE(all.size(), 20U);
    for (const knowledge::Relation& each : all) {
        const std::set<Truth>& truths = tested[owl::local_name(each.iri)];
        EXPECT_TRUE(truths.contains(Truth::yes) && truths.contains(Truth::no)) << each.iri;
    }
}

}  // namespace
}  // namespace partonomy
