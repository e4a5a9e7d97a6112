#include <gtest/gtest.h>

#include <random>

#include "base/errors.h"
#include "brute.h"
#include "knowledge/decision_tree.h"
#include "knowledge/object_test.h"
#include "knowledge/reasons.h"

// Short ways to answers that can be had the long way, too: counting for one question instead of listing every object,
// and planning in a small part of a space.

using namespace mini;
using namespace partonomy;
using namespace partonomy::knowledge;

namespace {

std::optional<Domain> random_domain(unsigned seed) {
    std::mt19937 random(seed);
    const brute::Random ontology(random, seed % 3 == 0);
    try {
        return compile(ontology.ontology.result);
    } catch (const OntologyError&) {
        return std::nullopt;
    }
}

ConfigurationSet random_subset(std::mt19937& random, const ConfigurationSet& of) {
    ConfigurationSet set(of.size());
    of.for_each([&](std::size_t i) {
        if (random() % 3 != 0) set.insert(i);
    });
    return set;
}

}  // namespace

TEST(ObjectTest, TellsWhatTheListedSpaceTells) {
    int pairs = 0, asked = 0;
    for (unsigned seed = 0; seed < 120; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::optional<Domain> domain = random_domain(seed);
        if (!domain) continue;
        std::mt19937 random(seed + 1);
        const Theory& theory = domain->grounding->theory;
        const Space& objects = domain->objects();
        for (const Concept& a : objects.concepts)
            for (const Concept& b : objects.concepts) {
                const std::vector<int> goals{theory.find(a.iri), theory.find(b.iri)};
                const auto test = ObjectTest::about(*domain, goals);
                if (!test) continue;
                EXPECT_EQ(test->is_below(goals[0], goals[1]), a.where.is_subset_of(b.where)) << a.iri << " " << b.iri;
                ++pairs;
                std::vector<ConfigurationSet> regions(1 + random() % 3);
                std::vector<ObjectTest::Types> types;
                for (ConfigurationSet& region : regions) {
                    region = random_subset(random, domain->regions.all());
                    types.push_back(test->types_of(region));
                }
                for (const bool complete : {true, false}) {
                    const Knowledge knowledge{static_cast<int>(regions.size()), complete, {}};
                    const Conclusions known = conclude_object(*domain, knowledge, regions);
                    const auto where = [&](const owl::Iri& iri) {
                        return known.objects->concepts[*known.objects->find(iri)].where;
                    };
                    const ObjectTest::Outcome outcome = test->ask(types, complete);
                    EXPECT_EQ(outcome.any, !known.object.is_empty());
                    EXPECT_EQ(outcome.other, !known.object.is_subset_of(where(a.iri) | where(b.iri)));
                    ++asked;
                }
            }
    }
    EXPECT_GT(pairs, 200);
    EXPECT_GT(asked, 400);
}

TEST(ObjectTest, TellsWithFewerAxiomsWhatListsAndTheSolverTell) {
    int asked = 0, followed = 0, free = 0;
    for (unsigned seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::optional<Domain> domain = random_domain(seed);
        if (!domain || domain->regions.diagram || domain->grounding->assembly.has_composites()) continue;
        std::mt19937 random(seed + 3);
        const Theory& theory = domain->grounding->theory;
        Knowledge knowledge{static_cast<int>(1 + random() % 3), random() % 2 == 0, {}};
        for (int i = 0; i < 6; ++i) {
            const auto variable = static_cast<VariableId>(random() % domain->regions.variables.size());
            const auto& values = domain->regions.variables[static_cast<std::size_t>(variable)].values;
            knowledge.answers.push_back({static_cast<int>(random() % static_cast<unsigned>(knowledge.region_count)),
                                         {variable, static_cast<ValueId>(random() % values.size())},
                                         random() % 2 == 0});
        }
        const Conclusions known = conclude(*domain, knowledge);
        if (known.contradiction) continue;
        for (const Concept& each : known.objects->concepts) {
            const int goal = theory.find(each.iri);
            FromAxioms by_solver(*domain, knowledge, goal, std::vector<char>(knowledge.answers.size(), 1),
                                 knowledge.complete);
            for (int i = 0; i < 6; ++i) {
                std::vector<char> axioms(domain->ontology.axioms.size(), 1);
                for (char& axiom : axioms)
                    if (i > 0 && random() % (i < 4 ? 6 : 2) == 0) axiom = 0;
                const Scope scope = cone(theory, goal, axioms, true);
                const Layer layer = build_regions(theory, scope, {});
                std::vector<ConfigurationSet> sets(static_cast<std::size_t>(knowledge.region_count), layer.space.all());
                bool is_told = true;  // by features alone, so that they mean the same in every scope
                for (const Answer& answer : knowledge.answers) {
                    const auto feature = static_cast<std::size_t>(answer.question.variable);
                    if (feature >= theory.feature_count()) is_told = false;
                    if (!is_told) break;
                    const ConfigurationSet yes = yes_set(layer.space, {layer.features[feature], answer.question.value});
                    ConfigurationSet& set = sets[static_cast<std::size_t>(answer.region)];
                    answer.yes ? set &= yes : set -= yes;
                }
                if (!is_told) break;
                const Assembly assembly = assemble(theory, scope, layer, 1 << 20);
                std::vector<Counts> counts = reachable_counts(assembly.parts, sets);
                if (!knowledge.complete)
                    counts =
                        with_any_more(assembly.parts, counts, types_within(assembly.parts, layer.space.all()), 1 << 20);
                const ObjectLayer listed = build_objects(theory, scope, {}, assembly.parts, counts, 1 << 20);
                const bool follows = listed.layer.concepts[goal].count() == listed.layer.space.size;
                EXPECT_EQ(by_solver.follows(axioms), follows) << each.iri;
                const auto test = ObjectTest::within(theory, scope, assembly.parts, std::vector{goal});
                if (test) {
                    std::vector<ObjectTest::Types> types;
                    for (const ConfigurationSet& set : sets) types.push_back(test->types_of(set));
                    const ObjectTest::Outcome outcome = test->ask(types, knowledge.complete);
                    EXPECT_EQ(outcome.any, listed.layer.space.size > 0);
                    EXPECT_EQ(!outcome.other, follows) << each.iri;
                }
                ++asked;
                followed += follows;
                for (std::size_t id = 0; id < theory.concepts.size(); ++id)
                    free += theory.concepts[id].level == Level::object && listed.layer.primitives[id] >= 0;
            }
        }
    }
    EXPECT_GT(asked, 500);
    EXPECT_GT(followed, 40);
    EXPECT_GT(free, 100);
}

TEST(Conclusions, AreThatPartOfAllObjects) {
    int checked = 0;
    for (unsigned seed = 200; seed < 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::optional<Domain> domain = random_domain(seed);
        if (!domain) continue;
        std::mt19937 random(seed);
        const std::vector<ConfigurationSet> regions(1, random_subset(random, domain->regions.all()));
        const Conclusions known = conclude_object(*domain, {1, false, {}}, regions);
        ASSERT_EQ(known.objects->concepts.size(), domain->objects().concepts.size());
        ASSERT_EQ(known.objects->variables.size(), domain->objects().variables.size());
        EXPECT_TRUE(std::ranges::includes(brute::rows_in(domain->objects(), domain->objects().all()),
                                          brute::rows_in(*known.objects, known.object)));
        ++checked;
    }
    EXPECT_GT(checked, 40);
}

TEST(Planner, AsksTheSameInPartOfASpace) {
    int questions = 0;
    for (unsigned seed = 0; seed < 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const std::optional<Domain> domain = random_domain(seed);
        if (!domain) continue;
        std::mt19937 random(seed + 2);
        const Space& space = domain->regions;
        PlanOptions options;
        if (seed % 2 == 0)
            for (std::size_t c = 0; c < space.concepts.size(); ++c) options.wanted.push_back(static_cast<ConceptId>(c));
        const ConfigurationSet within = random_subset(random, space.all());
        const Planner whole(space, options), part(space, options, within);
        for (int i = 0; i < 10; ++i) {
            const ConfigurationSet set = random_subset(random, within);
            const auto question = whole.best(set);
            EXPECT_EQ(part.best(set), question);
            EXPECT_EQ(part.is_decided(set), whole.is_decided(set));
            for (const Concept& each : space.concepts)
                EXPECT_EQ(part.best_about(set, each.where), whole.best_about(set, each.where));
            questions += question ? 1 : 0;
        }
    }
    EXPECT_GT(questions, 100);
}

TEST(Planner, AsksForAnExclusiveOr) {
    Ontology ontology;
    ontology.range("Side", {"Left", "Right"}).range("Tone", {"Dark", "Light"}).range("Kind", {"This", "That"});
    const ClassPointer left = some("hasSide", "Left"), dark = some("hasTone", "Dark");
    ontology.same("Odd", either({both({left, no(dark)}), both({no(left), dark})}));
    ontology.same("SomeObject", some("hasPart", name("Odd")));
    const Domain domain = compile(ontology.result);
    const Space& space = domain.regions;
    const ConfigurationSet& odd = space.concepts[*space.find(iri("Odd"))].where;
    const Planner planner(space, {});
    space.all().for_each([&](std::size_t target) {
        ConfigurationSet set = space.all();
        int asked = 0;
        while (const auto question = planner.best_about(set, odd)) {
            const ConfigurationSet yes = yes_set(space, *question);
            EXPECT_NE(space.variables[question->variable].iri, iri("Kind"));  // tells nothing
            if (yes.has(target))
                set &= yes;
            else
                set -= yes;
            ++asked;
        }
        EXPECT_EQ(asked, 2);
        EXPECT_TRUE(set.is_subset_of(odd) || !set.intersects(odd));
    });
}
