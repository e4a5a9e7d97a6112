/* Tiny random worlds against the enumeration of all their interpretations: what HermiT cannot judge (comparisons in
   rules, properties that OWL 2 DL keeps apart), and a second road for all the rest. */

#include "closed_oracle.h"

#include <gtest/gtest.h>

#include <iostream>

#include "closed_answer.h"
#include "closed_random.h"
#include "owl/write.h"

using namespace partonomy;
using knowledge::ClosedWorld;

namespace {

bool agree(const ClosedWorld& world) { return our_answer(world) == closed_oracle::ask(world); }

ClosedWorld shrunk(ClosedWorld world) {
    for (std::size_t i = 0; i < world.ontology.axioms.size();) {
        ClosedWorld smaller = world;
        smaller.ontology.axioms.erase(smaller.ontology.axioms.begin() + static_cast<std::ptrdiff_t>(i));
        if (agree(smaller)) {
            ++i;
        } else {
            world = smaller;
            i = 0;
        }
    }
    return world;
}

}  // namespace

TEST(ClosedWorldOracle, AgreesOnTinyRandomWorlds) {
    const char* text = std::getenv("PARTONOMY_TINY_WORLDS");
    const unsigned wanted = text == nullptr ? 500 : static_cast<unsigned>(std::atoi(text));
    closed_random::Census census;
    unsigned consistent = 0;
    std::size_t entailments = 0;
    for (unsigned seed = 1; seed <= wanted; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        closed_random::Shape shape;
        shape.small_data = shape.built_ins = true;
        shape.individuals = seed % 25 == 0 ? 2 : 1;
        shape.classes = shape.individuals == 2 ? 1 : 2;
        shape.properties = 1;
        shape.data_properties = seed % 25 == 5 ? 2 : 1;
        shape.axioms = 2 + seed % 7;
        const ClosedWorld world = closed_random::Generator(seed, shape).world();
        closed_random::count(world, census);
        const ClosedAnswer truth = closed_oracle::ask(world);
        consistent += truth.consistent;
        entailments += truth.entailed.size();
        if (our_answer(world) == truth) continue;
        const ClosedWorld small = shrunk(world);
        FAIL() << owl::write_functional(knowledge::closed_ontology(small)) << "ours:  " << line_of(our_answer(small))
               << "\ntruth: " << line_of(closed_oracle::ask(small));
    }
    std::cout << wanted << " worlds, " << consistent << " consistent, " << entailments << " entailments\n";
    for (const char* name : {"equal", "notEqual", "lessThan", "lessThanOrEqual", "greaterThan", "greaterThanOrEqual"})
        EXPECT_GT(census[std::string("compare ") + name], 0) << name;
}
