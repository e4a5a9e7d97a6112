#include <gtest/gtest.h>

#include "knowledge/explain.h"
#include "mini.h"

using namespace partonomy;
using namespace partonomy::knowledge;

namespace {

const std::string path = PARTONOMY_SOURCE_DIR "/ontologies/paper-furniture.ttl";

const Domain& furniture() {
    static const Domain domain = compile(owl::load_ontology(path));
    return domain;
}

Iri term(const std::string& name) { return "https://w3id.org/partonomy/paper-furniture#" + name; }
Iri core(const std::string& name) { return owl::core_prefix + name; }

struct Part {
    std::string shape, orientation, compactness, position, modular;
};

const Part seat{"Board", "Horizontal", "Compact", "Central", "M43"},
    long_seat{"Board", "Horizontal", "Elongated", "Central", "M43"},
    low_seat{"Board", "Horizontal", "Elongated", "Central", "M27"}, back{"Board", "Vertical", "Compact", "Up", "M43"},
    leg{"Stick", "Vertical", "Elongated", "Down", "M27"}, board_leg{"Board", "Vertical", "Compact", "Down", "M27"},
    rest{"Stick", "Horizontal", "Elongated", "Central", "M43"}, top{"Board", "Horizontal", "Compact", "Up", "M43"};

/// Everything about each part, as the answers of `is a` algorithms would tell it; heights and widths above the cuts.
Knowledge known(const std::vector<Part>& parts) {
    const Space& space = furniture().regions;
    Knowledge knowledge{static_cast<int>(parts.size()), true, {}};
    for (std::size_t i = 0; i < parts.size(); ++i) {
        for (const std::string& value :
             {parts[i].shape, parts[i].orientation, parts[i].compactness, parts[i].position, parts[i].modular})
            for (std::size_t v = 0; v < space.variables.size(); ++v) {
                const auto k = std::ranges::find(space.variables[v].values, value);
                if (k == space.variables[v].values.end()) continue;
                knowledge.answers.push_back(
                    {static_cast<int>(i),
                     {static_cast<int>(v), static_cast<int>(k - space.variables[v].values.begin())},
                     true});
            }
        for (const char* number : {"height", "width"})
            knowledge.answers.push_back({static_cast<int>(i), {*space.find_variable(core(number)), 0}, false});
    }
    return knowledge;
}

std::vector<std::string> classes(const Knowledge& knowledge) {
    std::vector<Iri> iris;
    const Conclusions conclusions = conclude(furniture(), knowledge);
    for (const ConceptId id : entailed(*conclusions.objects, conclusions.object))
        iris.push_back(conclusions.objects->concepts[static_cast<std::size_t>(id)].iri);
    std::vector<std::string> names;
    for (const Iri& iri : furniture().most_specific(iris)) names.push_back(owl::local_name(iri));
    return names;
}

using Names = std::vector<std::string>;

}  // namespace

TEST(Furniture, Sizes) {
    const Domain& domain = furniture();
    EXPECT_EQ(domain.regions.product, 3U * 2 * 2 * 3 * 2 * 2 * 2);  // five range concepts, height and width cut once
    EXPECT_EQ(domain.regions.size, domain.regions.product);
    EXPECT_EQ(mini::count(domain.regions, "Leg"), 999999U);
    EXPECT_EQ(domain.regions.concepts[*domain.regions.find(term("Leg"))].where.count(), 288U / 3);
    EXPECT_EQ(domain.regions.concepts[*domain.regions.find(term("Seat"))].where.count(),
              288U / 2 / 3 * 2 / 3 + 288U / 2 / 3 / 3 / 4);
    EXPECT_EQ(domain.objects().product, 2048U);
    EXPECT_EQ(domain.objects().variables.size(), domain.part_conditions.size());
    EXPECT_LT(domain.objects().size, 1000U);
    EXPECT_TRUE(domain.unsatisfiable().empty());
    for (const std::string& warning : domain.warnings) ADD_FAILURE() << warning;
}

/// What HermiT says about paper-furniture.ttl and what it uses of core.ttl (tests/app asks it about the whole).
TEST(Furniture, Hierarchy) {
    std::vector<std::pair<Iri, Iri>> expected;
    const auto below = [&](const Iri& sub, const std::vector<Iri>& supers) {
        for (const Iri& super : supers) expected.emplace_back(sub, super);
    };
    for (const RangeConcept& range : furniture().ranges) {
        below(range.iri, {core("Feature")});
        for (const ElementaryConcept& value : range.values) below(value.iri, {core("Feature"), range.iri});
    }
    below(core("Connected"), {core("Relation")});
    for (const char* part : {"Armrest", "BackPost", "Backrest", "Leg", "Seat", "Tabletop"})
        below(term(part), {core("Region")});
    below(term("Furniture"), {core("Object")});
    for (const char* object : {"Bench", "Chair", "Couch", "Stool", "Table"})
        below(term(object), {core("Object"), term("Furniture")});
    below(term("Armchair"), {core("Object"), term("Furniture"), term("Chair")});
    below(term("FootIncompatibleFurnitures"), {core("Object"), core("Incompatible"), term("Furniture"), term("Chair")});
    below(term("FloatingFurnitures"), {core("Object"), core("Incompatible"), term("Furniture")});
    below(term("BackrestWithoutSeat"), {core("Object"), core("Incompatible")});
    std::ranges::sort(expected);
    owl::LoadOptions module;
    module.whole_core = false;
    EXPECT_EQ(compile(owl::load_ontology(path, module)).hierarchy(), expected);
}

TEST(Furniture, ObjectsAreRecognised) {
    EXPECT_EQ(classes(known({seat, back, leg, leg, leg, leg})), (Names{"Chair"}));
    EXPECT_EQ(classes(known({seat, back, leg, leg, rest, rest})), (Names{"Armchair"}));
    EXPECT_EQ(classes(known({seat, leg, leg, leg})), (Names{"Stool"}));
    EXPECT_EQ(classes(known({low_seat, board_leg, board_leg})), (Names{"Bench"}));
    EXPECT_EQ(classes(known({long_seat, back, board_leg, board_leg})), (Names{"Couch"}));
    EXPECT_EQ(classes(known({top, leg, leg, leg, leg})), (Names{"Table"}));
    EXPECT_EQ(classes(known({seat, back, leg, leg, board_leg})), (Names{"Chair", "FootIncompatibleFurnitures"}));
    EXPECT_EQ(classes(known({back, leg})), (Names{"BackrestWithoutSeat"}));
    EXPECT_EQ(classes(known({leg})), (Names{}));
    EXPECT_EQ(furniture().layer(term("Chair")), 2);
}

TEST(Furniture, BoardsAmongTheFeetAreToBlame) {
    const Knowledge knowledge = known({seat, back, leg, leg, leg, board_leg, rest, rest, leg});
    const Iri diagnosis = term("FootIncompatibleFurnitures");
    EXPECT_EQ(conclude(furniture(), knowledge).diagnoses, (std::vector{diagnosis}));
    EXPECT_EQ(culprits(furniture(), knowledge, diagnosis), (std::vector{5}));
    const Explanation explanation = explain(furniture(), knowledge, diagnosis);
    EXPECT_TRUE(explanation.needs_completeness);  // one seat only
    bool board_named = false;
    for (const std::size_t i : explanation.answers)
        board_named |= knowledge.answers[i].region == 5 && knowledge.answers[i].question == Question{0, 0};
    EXPECT_TRUE(board_named);
    Names axioms;
    for (const std::size_t i : explanation.axioms) {
        const owl::Axiom& axiom = furniture().ontology.axioms[i];
        EXPECT_GT(axiom.source.line, 0);
        axioms.push_back(owl::local_name(axiom.classes[0]->iri));
    }
    std::ranges::sort(axioms);
    EXPECT_EQ(axioms, (Names{"Backrest", "Chair", "FootIncompatibleFurnitures", "Furniture", "Leg", "Seat"}));
    const auto fixes = corrections(furniture(), knowledge, diagnosis, std::vector<double>(knowledge.answers.size(), 1));
    EXPECT_FALSE(fixes.empty());
}

TEST(Furniture, ThePaperTree) {
    PlanOptions options;
    options.criterion = SplitCriterion::dichotomy;
    const Space& space = furniture().regions;
    const auto find_all = [&](Question question) -> std::optional<double> {
        return question.variable == *space.find_variable(core("Shape")) ? std::optional(1.0) : std::nullopt;
    };
    const DecisionTree tree = build_tree(space, options, find_all);
    EXPECT_FALSE(tree.nodes[0].segmented);
    EXPECT_EQ(tree.nodes[0].configurations.count(), 288U);
    std::size_t leaves = 0;
    for (const TreeNode& node : tree.nodes) leaves += node.question ? 0 : node.configurations.count();
    EXPECT_EQ(leaves, 288U);
    EXPECT_EQ(to_text(space, *tree.nodes[0].question, furniture()), "is it a board");
    options.criterion = SplitCriterion::gain_per_cost;
    for (std::size_t c = 0; c < space.concepts.size(); ++c) options.wanted.push_back(static_cast<ConceptId>(c));
    EXPECT_LT(build_tree(space, options, find_all).nodes.size(), 60U);
}
