#include "knowledge/relations.h"

#include <gtest/gtest.h>

#include <map>
#include <random>

#include "base/errors.h"
#include "knowledge/closed_world.h"
#include "knowledge/decision_tree.h"
#include "mini.h"

using namespace mini;
using namespace partonomy::knowledge;

namespace {

ClassPointer counted(ClassKind kind, const std::string& property, ClassPointer c, unsigned n = 0) {
    return make(kind, property, {std::move(c)}, n);
}

/// Kind of region is one feature; Above and Near link two regions, Amid three.
Ontology start() {
    Ontology ontology;
    ontology.range("F", {"a", "b", "c"})
        .same("P0", both({name("Region"), some("hasF", "a")}))
        .same("P1", both({name("Region"), some("hasF", "b")}));
    for (const char* relation : {"Above", "Near", "Amid"})
        ontology.sub(relation, "Relation").note(relation, "criterion", "any 0 1 2 3");
    ontology.note("Amid", "arity", "3");
    return ontology;
}

ClassPointer above_a_p0() {
    return some("isTargetRegion", both({name("Above"), inverse(some("isReferenceRegion", "P0"))}));
}

/// Statements about one region that speak of relations.
class Expressions {
public:
    explicit Expressions(std::mt19937& random) : random_(random) {}
    ClassPointer region() {
        const std::string role = pick(3) != 0 ? "isTargetRegion" : "isReferenceRegion";
        return restriction(role, node(2));
    }

private:
    std::size_t pick(std::size_t n) { return random_() % n; }
    ClassPointer restriction(const std::string& property, ClassPointer c) {
        switch (pick(5)) {
            case 0:
                return counted(ClassKind::all_values_from, property, c);
            case 1:
                return counted(ClassKind::min_cardinality, property, c, 1 + static_cast<unsigned>(pick(2)));
            case 2:
                return counted(ClassKind::max_cardinality, property, c, static_cast<unsigned>(pick(2)));
            case 3:
                return counted(ClassKind::exact_cardinality, property, c, static_cast<unsigned>(pick(3)));
            default:
                return counted(ClassKind::some_values_from, property, c);
        }
    }
    ClassPointer node(int depth) {
        const char* const relations[] = {"Above", "Near", "Amid", "Relation"};
        auto relation = name(relations[pick(4)]);
        const ClassPointer part = pick(3) == 0 ? no(name("P0")) : name(pick(2) == 0 ? "P0" : "P1");
        const ClassPointer linked = inverse(restriction(pick(4) == 0 ? "isTargetRegion" : "isReferenceRegion", part));
        if (depth > 0 && pick(4) == 0) return either({node(depth - 1), both({relation, linked})});
        if (depth > 0 && pick(5) == 0) return both({relation, no(node(depth - 1))});
        return both({relation, linked});
    }
    std::mt19937& random_;
};

owl::Axiom assertion(owl::AxiomKind kind, const ClassPointer& c, const std::string& property,
                     const std::vector<std::string>& individuals) {
    owl::Axiom axiom{};
    axiom.kind = kind;
    if (c) axiom.classes = {c};
    if (!property.empty()) axiom.properties.push_back({iri(property), false});
    for (const std::string& each : individuals) axiom.individuals.push_back(iri(each));
    axiom.source = {"facts", 1};
    return axiom;
}

}  // namespace

TEST(Relations, AreFeaturesOfARegion) {
    Ontology ontology = start();
    ontology.same("X", both({name("P1"), above_a_p0()}))
        .same("Y", both({name("P0"), above_a_p0()}))
        .same("Z", both({name("P1"), counted(ClassKind::max_cardinality, "isTargetRegion",
                                             both({name("Above"), inverse(some("isReferenceRegion", "P0"))}), 1)}))
        .same("Q", both({name("Object"), some("hasPart", "X"), some("hasPart", no(above_a_p0()))}));
    const Domain domain = compile(ontology.result);
    ASSERT_EQ(domain.relations.size(), 3U);
    EXPECT_EQ(domain.relations[1].arity, 3U);  // Above, Amid, Near
    ASSERT_EQ(domain.relational.size(), 2U);   // the same restriction is one feature; Z counts to two
    EXPECT_EQ(domain.regions.size, 3U * 2U * 2U);
    EXPECT_EQ(count(domain.regions, "X"), 2U);
    const Variable& variable = domain.regions.variables[1];
    EXPECT_EQ(variable.kind, VariableKind::relation);
    EXPECT_TRUE(variable.answerable);
    EXPECT_TRUE(domain.regions.concepts[*domain.regions.find(iri("X"))].relational);
    EXPECT_FALSE(domain.regions.concepts[*domain.regions.find(iri("P0"))].relational);
    EXPECT_EQ(domain.layer(iri("Above")), 0);
    EXPECT_TRUE(is_below(domain, "Above", "Relation"));
    EXPECT_TRUE(domain.warnings.empty()) << domain.warnings.front();
    CompileOptions options;
    options.listing_limit = 0;
    const Domain compiled = compile(ontology.result, options);
    EXPECT_EQ(compiled.regions.size, domain.regions.size);
    EXPECT_EQ(count(compiled.regions, "X"), 2U);
}

TEST(Relations, WhatCannotBeGroundedIsRefused) {
    const auto refusal = [](const ClassPointer& c) -> std::string {
        Ontology ontology = start();
        ontology.same("X", c).same("Q", both({name("Object"), some("hasPart", "P0")}));
        try {
            (void)compile(ontology.result);
        } catch (const OntologyError& error) {
            return error.what();
        }
        return "";
    };
    const auto has = [](const std::string& text, const char* words) { return text.find(words) != std::string::npos; };
    EXPECT_TRUE(has(refusal(some("isTargetRegion", both({name("Above"), name("Near")}))), "each is of one relation"));
    EXPECT_TRUE(has(refusal(some("isTargetRegion", name("P0"))), "P0 is no relation"));
    EXPECT_TRUE(has(refusal(some("isTargetRegion", some("isReferenceRegion", "P0"))), "says nothing of a relation"));
    EXPECT_TRUE(has(refusal(both({name("Object"), some("isTargetRegion", "Above")})), "links regions"));
    Ontology arity = start();
    arity.note("Near", "arity", "4").same("Q", some("hasPart", "P0"));
    EXPECT_THROW((void)compile(arity.result), OntologyError);
}

// The second opinion: the same axioms over named regions and nodes in a closed world.
TEST(Relations, AnswersAreEntailments) {
    int decided = 0, open = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        Ontology ontology = start();
        const ClassPointer expression = Expressions(random).region();
        ontology.same("X", both({name("Region"), expression})).same("Q", both({name("Object"), some("hasPart", "X")}));
        Domain domain;
        try {
            domain = compile(ontology.result);
        } catch (const OntologyError& error) {
            EXPECT_NE(std::string(error.what()).find("no node can be"), std::string::npos) << error.what();
            continue;
        }
        // What is known of each region, and which nodes there are.
        const int count = 2 + static_cast<int>(random() % 3);
        const bool all_known = random() % 2 == 0;
        std::vector<ConfigurationSet> regions;
        for (int r = 0; r < count; ++r) {
            const auto value = random() % 3;
            regions.push_back(domain.regions.holds[0][value]);
            if (!all_known && random() % 2 == 0) regions.back() |= domain.regions.holds[0][(value + 1) % 3];
        }
        std::map<RelationTuple, bool> nodes;
        for (std::size_t relation = 0; relation < 3; ++relation)
            for (int t = 0; t < count; ++t)
                for (int a = 0; a < count; ++a)
                    for (int b = domain.relations[relation].arity == 3 ? a + 1 : count - 1; b < count; ++b) {
                        const bool binary = domain.relations[relation].arity == 2;
                        if (t == a || (!binary && t == b)) continue;
                        nodes[{relation, binary ? std::vector{t, a} : std::vector{t, a, b}}] = random() % 3 == 0;
                    }

        ClosedWorld world{ontology.result, {}};
        auto& axioms = world.ontology.axioms;
        std::erase_if(axioms, [&](const owl::Axiom& axiom) {  // P0 and P1 by name only, and nothing of their features
            const auto text = to_manchester(axiom);
            return text.find("hasF") != std::string::npos || text.find("Feature") != std::string::npos ||
                   axiom.kind == owl::AxiomKind::disjoint_union;
        });
        axioms.push_back(assertion(owl::AxiomKind::disjoint_classes, name("P0"), "", {}));
        axioms.back().classes.push_back(name("P1"));
        for (int r = 0; r < count; ++r) {
            const std::string individual = "r" + std::to_string(r);
            world.individuals.push_back(iri(individual));
            axioms.push_back(assertion(owl::AxiomKind::class_assertion, name("Region"), "", {individual}));
            for (const char* p : {"P0", "P1"}) {
                const ConfigurationSet& where = domain.regions.concepts[*domain.regions.find(iri(p))].where;
                if (regions[static_cast<std::size_t>(r)].is_subset_of(where))
                    axioms.push_back(assertion(owl::AxiomKind::class_assertion, name(p), "", {individual}));
                else if (!regions[static_cast<std::size_t>(r)].intersects(where))
                    axioms.push_back(assertion(owl::AxiomKind::class_assertion, no(name(p)), "", {individual}));
            }
        }
        int number = 0;
        for (const auto& [tuple, holds] : nodes) {
            if (!holds) continue;
            const std::string node = "n" + std::to_string(number++);
            world.individuals.push_back(iri(node));
            for (std::size_t relation = 0; relation < 3; ++relation) {
                const ClassPointer c = name(owl::local_name(domain.relations[relation].iri));
                axioms.push_back(
                    assertion(owl::AxiomKind::class_assertion, relation == tuple.relation ? c : no(c), "", {node}));
            }
            for (int r = 0; r < count; ++r)
                for (const bool target : {true, false}) {
                    const auto place = std::ranges::find(tuple.regions, r) - tuple.regions.begin();
                    const bool linked =
                        static_cast<std::size_t>(place) < tuple.regions.size() && target == (place == 0);
                    axioms.push_back(assertion(linked ? owl::AxiomKind::object_property_assertion
                                                      : owl::AxiomKind::negative_object_property_assertion,
                                               nullptr, target ? "isTargetRegion" : "isReferenceRegion",
                                               {"r" + std::to_string(r), node}));
                }
        }
        std::vector<std::string> all;  // links start at regions and end at nodes
        for (int r = 0; r < count; ++r) all.push_back("r" + std::to_string(r));
        for (int n = 0; n < number; ++n) all.push_back("n" + std::to_string(n));
        for (const std::string& from : all)
            for (const std::string& to : all)
                for (const char* property : {"isTargetRegion", "isReferenceRegion"})
                    if (from[0] == 'n' || to[0] == 'r')
                        axioms.push_back(assertion(owl::AxiomKind::negative_object_property_assertion, nullptr,
                                                   property, {from, to}));
        ClosedReasoner reasoner(std::move(world));
        ASSERT_TRUE(reasoner.is_consistent());

        const auto score = [&](const RelationTuple& tuple) -> std::optional<double> {
            return nodes.at(tuple) ? 0.9 : 0.2;
        };
        const ConfigurationSet& x = domain.regions.concepts[*domain.regions.find(iri("X"))].where;
        for (int r = 0; r < count; ++r) {
            ConfigurationSet set = regions[static_cast<std::size_t>(r)];
            for (std::size_t v = 0; v < domain.regions.variables.size(); ++v) {
                if (domain.regions.variables[v].kind != VariableKind::relation) continue;
                const RelationAnswer answer = answer_relation(
                    domain, domain.relational[static_cast<std::size_t>(domain.regions.variables[v].index)], r, regions,
                    true, score);
                if (answer.truth != Truth::open) set &= domain.regions.holds[v][answer.truth == Truth::yes ? 0 : 1];
                EXPECT_GE(answer.score, 0.5);
            }
            const bool yes = set.is_subset_of(x), no_x = !set.intersects(x);
            const Iri individual = iri("r" + std::to_string(r));
            const bool entailed = reasoner.is_entailed(expression, individual);
            const bool excluded = reasoner.is_entailed(no(expression), individual);
            if (all_known) {
                EXPECT_EQ(yes, entailed);
                EXPECT_EQ(no_x, excluded);
            } else {  // nothing that does not follow
                EXPECT_TRUE(!yes || entailed);
                EXPECT_TRUE(!no_x || excluded);
            }
            (yes || no_x ? decided : open) += 1;
        }
    }
    EXPECT_GT(decided, 400);
    EXPECT_GT(open, 20);
}

/// A question about a relation is worded from either side.
TEST(Relations, InWords) {
    const auto worded = [](const std::string& question, const std::string& role, const std::string& other,
                           unsigned count = 0) {
        Ontology ontology = start();
        const owl::ClassPointer node = both({name("Above"), inverse(some(other, "P0"))});
        const owl::ClassPointer relation =
            count > 0 ? mini::make(owl::ClassKind::min_cardinality, role, {node}, count) : some(role, node);
        if (!question.empty()) ontology.note("Above", "question", question);
        ontology.same("X", both({name("P1"), relation})).same("Q", both({name("Object"), some("hasPart", "X")}));
        const Domain domain = compile(ontology.result);
        for (std::size_t v = 0; v < domain.regions.variables.size(); ++v)
            if (domain.regions.variables[v].kind == VariableKind::relation)
                return to_text(domain.regions, {static_cast<VariableId>(v), 0}, domain);
        return std::string();
    };
    EXPECT_EQ(worded("is it above", "isTargetRegion", "isReferenceRegion"), "is it above a P0");
    EXPECT_EQ(worded("is it above", "isReferenceRegion", "isTargetRegion"), "is a P0 above it");
    EXPECT_EQ(worded("has it the size of", "isReferenceRegion", "isTargetRegion"), "has a P0 the size of it");
    EXPECT_EQ(worded("higher than", "isReferenceRegion", "isTargetRegion"), "higher than this (asked of a P0)");
    EXPECT_EQ(worded("", "isTargetRegion", "isReferenceRegion").substr(0, 10), "is it so: ");
    EXPECT_EQ(worded("does it touch", "isTargetRegion", "isReferenceRegion", 2), "does it touch at least 2 P0");
    EXPECT_EQ(worded("does it touch", "isReferenceRegion", "isTargetRegion", 2).substr(0, 10), "is it so: ");
}

TEST(Relations, AsksNoMoreThanItNeeds) {
    Ontology ontology = start();
    ontology.same("X", both({name("P1"), above_a_p0()})).same("Q", both({name("Object"), some("hasPart", "X")}));
    const Domain domain = compile(ontology.result);
    const auto& is = domain.regions.holds[0];
    std::vector<RelationTuple> asked;
    const auto never = [&](const RelationTuple& tuple) -> std::optional<double> {
        asked.push_back(tuple);
        return 0.1;
    };
    const std::vector<ConfigurationSet> regions{is[1], is[2], is[0], domain.regions.all()};
    RelationAnswer answer = answer_relation(domain, domain.relational[0], 0, regions, true, never);
    EXPECT_EQ(answer.truth, Truth::no);
    EXPECT_DOUBLE_EQ(answer.score, 0.9);
    EXPECT_EQ(asked, (std::vector<RelationTuple>{{0, {0, 2}}, {0, {0, 3}}}));  // the sure one first, none of the other
    EXPECT_EQ(answer_relation(domain, domain.relational[0], 0, regions, false, never).truth, Truth::open);
    const auto always = [](const RelationTuple&) -> std::optional<double> { return 0.8; };
    answer = answer_relation(domain, domain.relational[0], 0, regions, false, always);
    EXPECT_EQ(answer.truth, Truth::yes);
    EXPECT_DOUBLE_EQ(answer.score, 0.8);
    EXPECT_EQ(answer_relation(domain, domain.relational[0], 0, {is[1], domain.regions.all()}, true, always).truth,
              Truth::open);  // it may be above a P0
}
