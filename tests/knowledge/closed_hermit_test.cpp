/* HermiT's second opinion on random closed knowledge bases: consistency, and every entailed class, property and
   equality assertion, on the exported closed ontology. */

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <set>

#include "base/errors.h"
#include "closed_answer.h"
#include "closed_random.h"
#include "hermit.h"
#include "owl/write.h"

using namespace partonomy;
using knowledge::ClosedWorld;

namespace {

/// One line of HermitJudge for each world.
std::vector<std::string> hermit_on(const std::vector<ClosedWorld>& worlds) {
    std::vector<std::string> texts;
    for (const ClosedWorld& world : worlds) texts.push_back(owl::write_functional(knowledge::closed_ontology(world)));
    return hermit::judge(texts);
}

std::string ours_on(const ClosedWorld& world) { return line_of(our_answer(world)); }

ClosedWorld without(const ClosedWorld& world, std::size_t axiom) {
    ClosedWorld result = world;
    result.ontology.axioms.erase(result.ontology.axioms.begin() + static_cast<std::ptrdiff_t>(axiom));
    return result;
}

bool is_judged(const std::string& line) { return !line.starts_with("failed"); }

/// Drops axioms while HermiT and we still disagree.
ClosedWorld shrunk(ClosedWorld world) {
    for (bool is_smaller = true; is_smaller;) {
        is_smaller = false;
        std::vector<ClosedWorld> smaller;
        for (std::size_t i = 0; i < world.ontology.axioms.size(); ++i) smaller.push_back(without(world, i));
        const std::vector<std::string> theirs = hermit_on(smaller);
        for (std::size_t i = 0; i < smaller.size() && !is_smaller; ++i) {
            try {
                if (!is_judged(theirs[i]) || ours_on(smaller[i]) == theirs[i]) continue;
            } catch (const OntologyError&) {
                continue;
            }
            world = smaller[i];
            is_smaller = true;
        }
    }
    return world;
}

unsigned environment(const char* name, unsigned otherwise) {
    const char* value = std::getenv(name);
    return value == nullptr ? otherwise : static_cast<unsigned>(std::atoi(value));
}

}  // namespace

TEST(ClosedWorldHermit, AgreesOnRandomKnowledgeBases) {
    if (!hermit::is_there()) GTEST_SKIP() << "no HermiT: run ./dev setup";
    const unsigned first = environment("PARTONOMY_SEED", 1), wanted = environment("PARTONOMY_WORLDS", 1200);
    std::cout << "seeds " << first << " to " << first + wanted - 1 << "\n";
    std::vector<ClosedWorld> worlds;
    closed_random::Census census;
    for (unsigned seed = first; seed < first + wanted; ++seed) {
        closed_random::Shape shape;
        shape.individuals = 1 + static_cast<int>(seed % 4);
        shape.axioms = 2 + seed % 11;
        worlds.push_back(closed_random::Generator(seed, shape).world());
    }
    const std::vector<std::string> theirs = hermit_on(worlds);
    std::map<std::string, int> failures;
    unsigned judged = 0, consistent = 0, entailments = 0, shown = 0, disagreements = 0;
    for (std::size_t i = 0; i < worlds.size(); ++i) {
        const std::string ours = ours_on(worlds[i]);
        if (!is_judged(theirs[i])) {
            ++failures[theirs[i].substr(0, 100)];
            continue;
        }
        ++judged;
        closed_random::count(worlds[i], census);
        consistent += ours != "inconsistent";
        entailments += static_cast<unsigned>(std::ranges::count(ours, '(') + std::ranges::count(ours, '='));
        if (ours == theirs[i]) continue;
        ++disagreements;
        if (++shown > environment("PARTONOMY_SHOWN", 3)) continue;
        const ClosedWorld small = shrunk(worlds[i]);
        ADD_FAILURE() << "seed " << first + i << "\n"
                      << owl::write_functional(knowledge::closed_ontology(small)) << "ours:   " << ours_on(small)
                      << "\ntheirs: " << hermit_on({small})[0];
    }
    std::cout << judged << " judged, " << consistent << " consistent, " << entailments << " entailments, "
              << disagreements << " disagreements\n";
    for (const auto& [why, count] : failures) std::cout << count << " x " << why << "\n";
    EXPECT_EQ(disagreements, 0U);
    if (wanted >= 1200) {
        EXPECT_GE(judged, 1000U);
        std::pair<int, std::string> rarest{judged, ""};
        for (const std::string& construct : closed_random::all_constructs(false)) {
            EXPECT_GT(census[construct], 0) << construct;
            rarest = std::min(rarest, {census[construct], construct});
        }
        std::cout << "the rarest of " << closed_random::all_constructs(false).size() << " constructs: " << rarest.second
                  << ", " << rarest.first << " times\n";
    }
}
