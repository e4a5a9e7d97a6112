#include <gtest/gtest.h>

#include "base/errors.h"
#include "brute.h"

using namespace partonomy;
using namespace partonomy::knowledge;

namespace {

/// The truth of each object class, in the order Q0, Q1, Q2.
std::vector<bool> row_of(const brute::Classes& classes) {
    std::vector<bool> row;
    for (const auto& [iri, holds] : classes) row.push_back(holds);
    return row;
}

unsigned parts_that_matter(const Space& objects) {
    std::map<std::string, unsigned> caps;
    for (const Variable& variable : objects.variables) {
        unsigned& cap = caps[to_manchester(*variable.part_class)];
        cap = std::max(cap, variable.threshold);
    }
    unsigned sum = 0;
    for (const auto& [name, cap] : caps) sum += cap;
    return sum;
}

}  // namespace

TEST(Random, SpacesAreWhatPartsRealise) {
    int exact = 0;
    for (unsigned seed = 0; seed < 150; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const brute::Random ontology(random, seed % 3 == 0);
        const std::vector<char> kept(ontology.ontology.result.axioms.size(), 1);
        Domain domain;
        try {
            domain = compile(ontology.ontology.result);
        } catch (const OntologyError&) {  // an inconsistent layer
            std::size_t objects = 0;
            brute::for_each_object(ontology, {}, kept, {}, 2, [&](const brute::Classes&) { ++objects; });
            EXPECT_TRUE(objects == 0 || brute::all_regions(ontology, kept).empty());
            continue;
        }
        EXPECT_EQ(domain.regions.size, brute::all_regions(ontology, kept).size());
        const unsigned enough = parts_that_matter(domain.objects());
        std::set<std::vector<bool>> rows;
        brute::for_each_object(ontology, {}, kept, {}, static_cast<int>(std::min(enough, 4U)),
                               [&](const brute::Classes& classes) { rows.insert(row_of(classes)); });
        const auto ours = brute::rows_in(domain.objects(), domain.objects().all());
        EXPECT_TRUE(std::ranges::includes(ours, rows));
        if (enough <= 4) {
            EXPECT_EQ(ours, rows);
        }
        exact += enough <= 4;
    }
    EXPECT_GT(exact, 40);
}

TEST(Random, ConclusionsAreEntailments) {
    int checked = 0;
    for (unsigned seed = 1000; seed < 1200; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const brute::Random ontology(random, seed % 3 == 0);
        const std::vector<char> kept(ontology.ontology.result.axioms.size(), 1);
        Domain domain;
        try {
            domain = compile(ontology.ontology.result);
        } catch (const OntologyError&) {
            continue;
        }
        Knowledge knowledge = brute::random_knowledge(random, ontology);
        const unsigned enough = parts_that_matter(domain.objects());
        if (!knowledge.complete && enough > 2) knowledge.complete = true;
        const Conclusions conclusions = conclude(domain, knowledge);
        std::set<std::vector<bool>> rows;
        brute::for_each_object(ontology, knowledge, kept, std::vector<char>(knowledge.answers.size(), 1),
                               knowledge.complete ? 0 : static_cast<int>(enough),
                               [&](const brute::Classes& classes) { rows.insert(row_of(classes)); });
        if (std::ranges::any_of(conclusions.regions, [](const auto& set) { return set.is_empty(); })) {
            EXPECT_TRUE(rows.empty());
            EXPECT_TRUE(conclusions.contradiction);
            continue;
        }
        EXPECT_EQ(brute::rows_in(*conclusions.objects, conclusions.object), rows);
        EXPECT_EQ(conclusions.contradiction, rows.empty());
        ++checked;
    }
    EXPECT_GT(checked, 80);
}

TEST(Random, ExplanationsAreMinimal) {
    int checked = 0;
    for (unsigned seed = 2000; seed < 2400 && checked < 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const brute::Random ontology(random, seed % 3 == 0, 2);
        Domain domain;
        try {
            domain = compile(ontology.ontology.result);
        } catch (const OntologyError&) {
            continue;
        }
        const int enough = static_cast<int>(parts_that_matter(domain.objects()));
        if (enough > 3) continue;
        const Knowledge knowledge = brute::random_knowledge(random, ontology);
        const Conclusions conclusions = conclude(domain, knowledge);
        if (conclusions.contradiction) continue;
        const auto classes = entailed(*conclusions.objects, conclusions.object);
        if (classes.empty()) continue;
        const Iri goal =
            conclusions.objects->concepts[static_cast<std::size_t>(classes[random() % classes.size()])].iri;
        const Explanation explanation = explain(domain, knowledge, goal);

        std::vector<char> kept(domain.ontology.axioms.size(), 0), answers(knowledge.answers.size(), 0);
        for (const std::size_t i : explanation.axioms) kept[i] = 1;
        for (const std::size_t i : explanation.answers) answers[i] = 1;
        const auto follows = [&](bool complete) {
            bool all = true;
            brute::for_each_object(ontology, knowledge, kept, answers, complete ? 0 : enough,
                                   [&](const brute::Classes& each) { all &= each.at(goal); });
            return all;
        };
        EXPECT_TRUE(follows(explanation.needs_completeness));
        for (const std::size_t i : explanation.axioms) {
            kept[i] = 0;
            EXPECT_FALSE(follows(explanation.needs_completeness)) << "axiom " << i << " is not needed";
            kept[i] = 1;
        }
        for (const std::size_t i : explanation.answers) {
            answers[i] = 0;
            EXPECT_FALSE(follows(explanation.needs_completeness)) << "answer " << i << " is not needed";
            answers[i] = 1;
        }
        if (explanation.needs_completeness) {
            EXPECT_FALSE(follows(false));
        }
        ++checked;
    }
    EXPECT_GE(checked, 50);
}
