#include <gtest/gtest.h>

#include "base/errors.h"
#include "knowledge/explain.h"
#include "mini.h"

using namespace mini;
using namespace partonomy::knowledge;

namespace {

/// Fig. 3 (b): a back is a backrest and perhaps a headrest. Regions: kind of region is one feature.
Ontology furniture() {
    Ontology ontology;
    ontology.range("Kind", {"SeatKind", "LegKind", "RestKind", "HeadKind"});
    for (const char* name : {"Seat", "Leg", "Rest", "Head"})
        ontology.same(name, both({mini::name("Region"), some("hasKind", std::string(name) + "Kind")}));
    ontology
        .same("Chair",
              both({name("Object"), exactly(1, name("Seat")), some("hasPart", "Back"), at_least(3, name("Leg"))}))
        .same("Stool",
              both({name("Object"), some("hasPart", "Seat"), at_most(0, name("Rest")), at_most(0, name("Head"))}));
    return ontology;
}

Ontology with_back() {
    Ontology ontology = furniture();
    ontology.same("Back", both({name("CompositePart"), exactly(1, name("Rest")), at_most(1, name("Head"))}))
        .same("HeadBack", both({name("Back"), some("hasPart", "Head")}))
        .same("Recliner", both({name("Chair"), some("hasPart", "HeadBack")}))
        .same("HeadAlone", both({name("CompositePart"), some("hasPart", "Head"), at_most(0, name("Rest"))}))
        .sub("HeadAlone", "Incompatible");
    return ontology;
}

/// One region of each given kind (0 seat, 1 leg, 2 rest, 3 head, -1 unknown).
Knowledge regions(const std::vector<int>& kinds, std::vector<std::pair<int, int>> connected) {
    Knowledge knowledge{static_cast<int>(kinds.size()), true, {}, std::move(connected)};
    for (std::size_t i = 0; i < kinds.size(); ++i)
        if (kinds[i] >= 0) knowledge.answers.push_back({static_cast<int>(i), {0, kinds[i]}, true});
    return knowledge;
}

std::vector<std::string> names(const Space& space, const ConfigurationSet& set) {
    std::vector<std::string> result;
    for (const ConceptId c : entailed(space, set)) result.push_back(owl::local_name(space.concepts[c].iri));
    return result;
}

using Names = std::vector<std::string>;

}  // namespace

TEST(Composites, BackOfBackrestAndHeadrest) {
    const Domain domain = compile(with_back().result);
    ASSERT_EQ(domain.composites.size(), 1U);  // the same regions: one kind of group
    EXPECT_EQ(domain.composites[0].layer, 2);
    EXPECT_EQ(domain.layer(iri("Back")), 2);
    EXPECT_EQ(domain.layer(iri("HeadAlone")), 2);
    EXPECT_EQ(domain.layer(iri("Chair")), 3);
    EXPECT_EQ(domain.layer(iri("Seat")), 1);
    EXPECT_TRUE(domain.unsatisfiable().empty());
    EXPECT_TRUE(domain.warnings.empty()) << domain.warnings.front();
    EXPECT_TRUE(is_below(domain, "HeadBack", "Back"));
    EXPECT_TRUE(is_below(domain, "HeadBack", "CompositePart"));
    EXPECT_TRUE(is_below(domain, "HeadAlone", "Incompatible"));
    EXPECT_TRUE(is_below(domain, "Recliner", "Chair"));
    EXPECT_FALSE(is_below(domain, "Chair", "Recliner"));

    const auto seat_legs_rest_head = {0, 1, 1, 1, 2, 3};
    Conclusions chair = conclude(domain, regions(seat_legs_rest_head, {{0, 1}, {0, 4}, {4, 5}}));
    EXPECT_EQ(names(domain.objects(), chair.object), (Names{"Chair", "Recliner"}));
    ASSERT_EQ(chair.composites.size(), 1U);
    EXPECT_EQ(chair.composites[0].regions, (std::vector<int>{4, 5}));
    EXPECT_EQ(names(domain.composites[0].space, chair.composites[0].possible), (Names{"Back", "HeadBack"}));
    EXPECT_TRUE(chair.diagnoses.empty());

    chair = conclude(domain, regions(seat_legs_rest_head, {{0, 4}, {0, 5}}));  // not one group: they do not touch
    EXPECT_EQ(names(domain.objects(), chair.object), (Names{"Chair"}));
    ASSERT_EQ(chair.composites.size(), 2U);
    EXPECT_EQ(names(domain.composites[0].space, chair.composites[1].possible), (Names{"HeadAlone"}));
    EXPECT_EQ(chair.diagnoses, (std::vector<Iri>{iri("HeadAlone")}));
}

TEST(Composites, OpenRegionsKeepTheirGroupsOpen) {
    const Domain domain = compile(with_back().result);
    const std::vector<std::pair<int, int>> touching{{0, 1}, {0, 2}, {0, 3}, {0, 4}, {4, 5}};
    Conclusions known = conclude(domain, regions({0, 1, 1, 1, 2, -1}, touching));
    EXPECT_EQ(names(domain.objects(), known.object), Names{});  // the last may be another rest: two rests are no back
    EXPECT_TRUE(known.composites.empty());
    Knowledge knowledge = regions({0, 1, 1, 1, 2, -1}, touching);
    knowledge.answers.push_back({5, {0, 2}, false});
    knowledge.answers.push_back({5, {0, 0}, false});
    known = conclude(domain, knowledge);  // a leg or a head: a chair in any case
    EXPECT_EQ(names(domain.objects(), known.object), (Names{"Chair"}));
    knowledge.complete = false;  // another head may turn up between the two
    EXPECT_EQ(names(domain.objects(), conclude(domain, knowledge).object), Names{});
}

TEST(Composites, ALayerCanBeTakenAway) {
    Ontology flat = furniture();  // Fig. 3 (a): the back is a region, and the chair is written as before
    flat.same("Back", both({name("Region"), some("hasKind", "RestKind")}));
    const Domain domain = compile(flat.result);
    EXPECT_TRUE(domain.composites.empty());
    EXPECT_EQ(domain.layer(iri("Back")), 1);
    EXPECT_EQ(domain.layer(iri("Chair")), 2);
    const Conclusions known = conclude(domain, regions({0, 1, 1, 1, 2}, {}));
    EXPECT_EQ(names(*known.objects, known.object), (Names{"Chair"}));
}

TEST(Composites, FoundWithoutTheirCoreClass) {
    Ontology ontology = furniture();
    ontology.same("Back", both({exactly(1, name("Rest")), at_most(1, name("Head"))}));
    const Domain domain = compile(ontology.result);
    EXPECT_EQ(domain.layer(iri("Back")), 2);  // since chairs have one as a part
    EXPECT_EQ(domain.layer(iri("Chair")), 3);
    Ontology reversed;  // what is a Back is one, too, wherever it is written
    reversed.range("Kind", {"RestKind", "HeadKind"})
        .same("HeadBack", both({name("Back"), some("hasPart", some("hasKind", "HeadKind"))}))
        .same("Back", some("hasPart", some("hasKind", "RestKind")))
        .same("Chair", some("hasPart", "Back"));
    EXPECT_EQ(compile(reversed.result).layer(iri("HeadBack")), 2);
}

TEST(Composites, LayersOnLayers) {
    Ontology ontology = with_back();
    ontology.same("Top", both({name("CompositePart"), some("hasPart", "Back"), some("hasPart", "Seat")}))
        .same("Throne", both({name("Object"), some("hasPart", both({name("Top"), some("hasPart", "HeadBack")}))}));
    const Domain domain = compile(ontology.result);
    ASSERT_EQ(domain.composites.size(), 2U);
    EXPECT_EQ(domain.layer(iri("Top")), 3);
    EXPECT_EQ(domain.layer(iri("Throne")), 4);
    const Conclusions known = conclude(domain, regions({0, 2, 3}, {{0, 1}, {1, 2}}));
    EXPECT_EQ(names(domain.objects(), known.object), (Names{"Throne"}));
    ASSERT_EQ(known.composites.size(), 2U);
    EXPECT_EQ(known.composites[1].regions, (std::vector<int>{0, 1, 2}));  // a region that a back has, the top has, too
    EXPECT_EQ(names(domain.objects(), conclude(domain, regions({0, 2, 3}, {{1, 2}})).object), Names{});
}

TEST(Composites, HeadrestWithoutBackrestIsExplained) {
    Ontology ontology = with_back();
    const std::size_t axiom = ontology.result.axioms.size();
    ontology.same("BareHeadFurniture", both({name("Object"), some("hasPart", "Head"), no(some("hasPart", "Back"))}))
        .sub("BareHeadFurniture", "Incompatible");
    const Domain domain = compile(ontology.result);
    const Knowledge knowledge = regions({0, 1, 1, 1, 3}, {{0, 1}, {0, 2}, {0, 3}, {0, 4}});
    const Conclusions known = conclude(domain, knowledge);
    EXPECT_EQ(known.diagnoses, (std::vector<Iri>{iri("BareHeadFurniture"), iri("HeadAlone")}));
    const Explanation alone = explain(domain, knowledge, iri("HeadAlone"));
    EXPECT_EQ(alone.answers, (std::vector<std::size_t>{0, 4}));  // what it touches is no rest
    EXPECT_EQ(culprits(domain, knowledge, iri("HeadAlone")), (std::vector<int>{4}));
    const Explanation bare = explain(domain, knowledge, iri("BareHeadFurniture"));
    EXPECT_TRUE(bare.needs_completeness);
    EXPECT_TRUE(std::ranges::count(bare.axioms, axiom) == 1);
    EXPECT_EQ(culprits(domain, knowledge, iri("BareHeadFurniture")), (std::vector<int>{4}));
    const auto mended = corrections(domain, knowledge, iri("HeadAlone"), {0.5, 0.5, 0.5, 0.5, 0.1});
    ASSERT_FALSE(mended.empty());
    EXPECT_EQ(mended[0].answers, (std::vector<std::size_t>{4}));
}

TEST(Composites, WhatDoesNotFitIsRefused) {
    const auto refusal = [](Ontology ontology) -> std::string {
        try {
            (void)compile(ontology.result);
        } catch (const OntologyError& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_NE(refusal(with_back().same("X", both({name("CompositePart"), some("hasKind", "SeatKind")})))
                  .find("hasKind is a feature of regions, and here a composite part is meant"),
              std::string::npos);
    EXPECT_NE(refusal(with_back().same("X", both({name("Back"), name("Seat")})))
                  .find("Seat is a region where a composite part is meant"),
              std::string::npos);
    EXPECT_NE(refusal(with_back().same("X", some("hasPart", either({name("Back"), name("Seat")})))).find("is meant"),
              std::string::npos);
    EXPECT_NE(refusal(with_back()
                          .same("A", both({name("CompositePart"), some("hasPart", "Rest"), at_most(0, name("B"))}))
                          .same("A1", both({name("A"), some("hasPart", "Head")}))
                          .same("B", both({name("CompositePart"), some("hasPart", "A1")})))
                  .find("mini.ttl"),
              std::string::npos);
}

TEST(Composites, WhatCanNeverBeProvedIsTold) {
    Ontology ontology = with_back();
    ontology.sub("Cover", "CompositePart").same("Padded", either({name("Back"), name("Cover")}));
    const Domain domain = compile(ontology.result);
    ASSERT_EQ(domain.warnings.size(), 1U);
    EXPECT_NE(domain.warnings[0].find("Cover has only necessary conditions, so no composite part can"),
              std::string::npos);
    const Conclusions known = conclude(domain, regions({0, 2}, {{0, 1}}));
    ASSERT_EQ(known.composites.size(), 1U);
    EXPECT_EQ(names(domain.composites[0].space, known.composites[0].possible), (Names{"Back", "Padded"}));
}
