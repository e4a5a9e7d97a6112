/* TF against T asked of everybody. */

#include "algorithms/related_index.h"

#include <gtest/gtest.h>

#include "algorithms/solids.h"
#include "knowledge/theory.h"

namespace partonomy {
namespace {

using solids::Stage;

/// Boxes of several kinds spread over a floor, some of them twins of others.
void fill(Stage& stage, int count, std::mt19937& random) {
    std::uniform_real_distribution<double> any(0, 1);
    stage.add(solids::block({0, 0, -0.1}, {12, 8, 0}));
    std::vector<solids::Block> blocks;
    for (int i = 1; i < count; ++i) {
        solids::Block block{Vec3(12 * any(random), 8 * any(random), 2 * any(random)),
                            Vec3(0.05 + 0.4 * any(random), 0.05 + 0.1 * any(random), 0.1)};
        if (any(random) < 0.5) block.axes = solids::block({0, 0, 0}, {1, 1, 1}, 360 * any(random)).axes;
        if (!blocks.empty() && any(random) < 0.3) {
            block = blocks[random() % blocks.size()];
            block.centre += Vec3(any(random), 0, any(random) < 0.5 ? 0.3 : 0);
        }
        blocks.push_back(block);
        stage.add(block);
    }
    stage.move(solids::random_motion(random, 0), random);
    stage.finish();
}

std::vector<const RegionPlace*> all_places(const Stage& stage) {
    std::vector<const RegionPlace*> places;
    for (const RegionPlace& place : stage.places) places.push_back(&place);
    return places;
}

/// What the index finds for one line of tuples is what T says of each.
void expect_same(const Stage& stage, const RelatedIndex& index, const knowledge::Relation& relation,
                 std::vector<int> line, int& related) {
    const auto open = std::ranges::find(line, -1) - line.begin();
    const std::vector<RelatedIndex::Related> found = index.find(relation.criteria, line);
    std::size_t next = 0;
    for (int region = 0; region < static_cast<int>(stage.places.size()); ++region) {
        std::vector<int> tuple = line;
        if (std::ranges::find(line, region) != line.end()) continue;
        tuple[static_cast<std::size_t>(open)] = region;
        const auto score = relation_score(relation.criteria, stage.scene, stage.at(tuple));
        const bool is_found = next < found.size() && found[next].region == region;
        if (is_found)
            EXPECT_EQ(found[next++].score, score) << relation.iri;
        else
            EXPECT_EQ(score, 0) << relation.iri;
        related += score.value_or(0) >= 0.5;
    }
    EXPECT_EQ(next, found.size());
}

TEST(RelatedIndex, FindsWhatAskingEverybodyFinds) {
    const std::vector<knowledge::Relation> relations =
        knowledge::find_relations(owl::parse_ontology(owl::core_ontology_text(), "core.ttl"));
    std::map<std::string, int> met;  // tuples in each relation, over all seeds
    for (unsigned seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        constexpr int count = 45;
        Stage stage({});
        fill(stage, count, random);
        const RelatedIndex index(stage.scene, all_places(stage));
        for (const knowledge::Relation& relation : relations) {
            int& related = met[owl::local_name(relation.iri)];
            for (int region = 0; region < count; ++region) {
                if (relation.arity == 2) {
                    expect_same(stage, index, relation, {region, -1}, related);
                    expect_same(stage, index, relation, {-1, region}, related);
                    continue;
                }
                for (int k = 0; k < 4; ++k) {
                    const int other = static_cast<int>(random() % count);
                    if (other == region) continue;
                    expect_same(stage, index, relation, {-1, region, other}, related);
                    expect_same(stage, index, relation, {region, -1, other}, related);
                }
            }
        }
    }
    for (const auto& [relation, tuples] : met) {
        const bool is_rare = relation == "Around" || relation == "Inside" ||   // loose boxes are beside each other,
                             relation == "InFrontOf" || relation == "Behind";  // and have no front
        EXPECT_TRUE(tuples > 0 || is_rare) << relation;
    }
}

TEST(RelatedIndex, OfNoRegionsOrOne) {
    std::mt19937 random(5);
    Stage stage({solids::block({0, 0, 0}, {1, 1, 1})});
    stage.finish();
    EXPECT_TRUE(RelatedIndex(stage.scene, {}).find(std::span(&touching(), 1), {-1, -1}).empty());
    EXPECT_TRUE(RelatedIndex(stage.scene, all_places(stage)).find(std::span(&touching(), 1), {0, -1}).empty());
}

}  // namespace
}  // namespace partonomy
