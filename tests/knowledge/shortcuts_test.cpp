#include <gtest/gtest.h>

#include <random>

#include "base/errors.h"
#include "brute.h"
#include "knowledge/decision_tree.h"
#include "knowledge/object_test.h"

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
