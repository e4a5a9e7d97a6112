/* Objects of too many kinds to list: a solver says of them what counting says. */

#include <gtest/gtest.h>

#include <optional>
#include <random>

#include "base/errors.h"
#include "brute.h"
#include "knowledge/explain.h"
#include "knowledge/lint.h"
#include "mini.h"

using namespace mini;
using namespace partonomy::knowledge;

TEST(ObjectSolver, SaysWhatCountingSays) {
    int solved = 0, explained = 0, corrected = 0;
    for (unsigned seed = 7000; seed < 7200; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const brute::Random ontology(random, seed % 4 == 0);
        CompileOptions few;
        few.configuration_limit = 1;
        std::optional<Domain> counted, asked;
        try {
            counted = compile(ontology.ontology.result);
            asked = compile(ontology.ontology.result, few);
        } catch (const partonomy::OntologyError&) {
            continue;
        }
        Knowledge knowledge = brute::random_knowledge(random, ontology);
        knowledge.complete = seed % 3 == 0;
        const Conclusions listed = conclude(*counted, knowledge), ours = conclude(*asked, knowledge);
        if (!ours.objects->diagram) continue;
        ++solved;
        ASSERT_EQ(ours.object.is_empty(), listed.object.is_empty());
        EXPECT_EQ(ours.diagnoses, listed.diagnoses);
        if (listed.object.is_empty()) continue;
        ASSERT_EQ(ours.objects->concepts.size(), listed.objects->concepts.size());
        for (std::size_t c = 0; c < listed.objects->concepts.size(); ++c) {
            const Concept &theirs = listed.objects->concepts[c], &mine = ours.objects->concepts[c];
            ASSERT_EQ(mine.iri, theirs.iri);
            EXPECT_EQ(ours.object.is_subset_of(mine.where), listed.object.is_subset_of(theirs.where)) << mine.iri;
            EXPECT_EQ(ours.object.intersects(mine.where), listed.object.intersects(theirs.where)) << mine.iri;
            if (!listed.object.is_subset_of(theirs.where)) continue;
            const Explanation why = explain(*asked, knowledge, mine.iri);
            Knowledge rest{knowledge.region_count, why.needs_completeness, {}, {}};
            for (const std::size_t i : why.answers) rest.answers.push_back(knowledge.answers[i]);
            const Conclusions from_those = conclude(*counted, rest);
            EXPECT_TRUE(from_those.object.is_subset_of(from_those.objects->concepts[c].where)) << mine.iri;
            ++explained;
            const std::vector<double> costs(knowledge.answers.size(), 1);
            for (const Correction& each : corrections(*asked, knowledge, mine.iri, costs)) {
                Knowledge turned = knowledge;
                for (const std::size_t i : each.answers) turned.answers[i].yes = !turned.answers[i].yes;
                const Conclusions after = conclude(*counted, turned);
                EXPECT_FALSE(!after.object.is_empty() && after.object.is_subset_of(after.objects->concepts[c].where))
                    << mine.iri;
                ++corrected;
            }
        }
        for (std::size_t v = 0; v < listed.objects->variables.size(); ++v)
            for (const std::size_t k : {0U, 1U})
                EXPECT_EQ(ours.object.intersects(ours.objects->holds[v][k]),
                          listed.object.intersects(listed.objects->holds[v][k]))
                    << v;
    }
    EXPECT_GT(solved, 60);
    EXPECT_GT(explained, 20);
    EXPECT_GT(corrected, 5);
}

/// Forty classes of parts, each counted to three: more than a word holds, and 4^40 combinations.
TEST(ObjectSolver, FortyClassesOfPartsAreNotTooMany) {
    Ontology ontology;
    std::vector<std::string> values;
    for (int i = 0; i < 40; ++i) values.push_back("v" + std::to_string(i));
    ontology.range("F", values);
    for (int i = 0; i < 40; ++i) {
        const std::string n = std::to_string(i);
        ontology.same("P" + n, both({name("Region"), some("hasF", "v" + n)}));
        ontology.same("O" + n, both({name("Object"), at_least(3, name("P" + n)),
                                     at_most(1, name("P" + std::to_string((i + 1) % 40)))}));
    }
    const Domain domain = compile(ontology.result);
    ASSERT_NE(domain.objects().diagram, nullptr);
    EXPECT_FALSE(domain.objects().all().is_empty());
    Knowledge knowledge{3, false, {{0, {0, 7}, true}, {1, {0, 7}, true}, {2, {0, 7}, true}}, {}};
    const Iri o7 = iri("O7");
    const auto is_one = [&](const Conclusions& known) {
        return known.object.is_subset_of(known.objects->concepts[*known.objects->find(o7)].where);
    };
    EXPECT_FALSE(is_one(conclude(domain, knowledge))) << "there may be two P8";
    knowledge.complete = true;
    EXPECT_TRUE(is_one(conclude(domain, knowledge)));
    const Explanation why = explain(domain, knowledge, o7);
    EXPECT_EQ(why.answers, (std::vector<std::size_t>{0, 1, 2}));
    EXPECT_TRUE(why.needs_completeness);
    EXPECT_EQ(corrections(domain, knowledge, o7, {1, 2, 3}).at(0).answers, (std::vector<std::size_t>{0}));
}
