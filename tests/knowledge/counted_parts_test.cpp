#include "knowledge/counted_parts.h"

#include <gtest/gtest.h>

#include "mini.h"

using namespace mini;
using namespace partonomy::knowledge;

namespace {

/// "Leg 2..4", "Leg 1..", "Leg ..0"; and whether that is all.
std::pair<std::string, bool> counts(ClassPointer definition) {
    Ontology ontology;
    ontology.same("Whole", std::move(definition));
    const CountedParts found = counted_parts(ontology.result, iri("Whole"));
    std::string text;
    for (const CountedPart& part : found.parts)
        text += (text.empty() ? "" : ", ") + partonomy::owl::local_name(part.iri) + " " +
                (part.at_least ? std::to_string(*part.at_least) : "") + ".." +
                (part.at_most ? std::to_string(*part.at_most) : "");
    return {text, found.is_all};
}

using Found = std::pair<std::string, bool>;

TEST(CountedParts, WhatADefinitionAsksFor) {
    EXPECT_EQ(counts(some("hasPart", "Leg")), (Found{"Leg 1..", true}));
    EXPECT_EQ(counts(at_least(3, name("Leg"))), (Found{"Leg 3..", true}));
    EXPECT_EQ(counts(at_most(0, name("Leg"))), (Found{"Leg ..0", true}));
    EXPECT_EQ(counts(exactly(2, name("Leg"))), (Found{"Leg 2..2", true}));
    EXPECT_EQ(counts(exactly(0, name("Leg"))), (Found{"Leg ..0", true}));
    EXPECT_EQ(counts(both({name("Chair"), some("hasPart", "Back"), at_most(2, name("Leg"))})),
              (Found{"Back 1.., Leg ..2", true}));
    EXPECT_EQ(counts(at_least(0, name("Leg"))), (Found{"", true}));
    EXPECT_EQ(counts(name("Chair")), (Found{"", true}));
}

TEST(CountedParts, BehindANegation) {
    EXPECT_EQ(counts(no(some("hasPart", "Leg"))), (Found{"Leg ..0", true}));
    EXPECT_EQ(counts(no(at_least(3, name("Leg")))), (Found{"Leg ..2", true}));
    EXPECT_EQ(counts(no(at_most(3, name("Leg")))), (Found{"Leg 4..", true}));
    EXPECT_EQ(counts(no(no(some("hasPart", "Leg")))), (Found{"Leg 1..", true}));
    EXPECT_EQ(counts(no(either({some("hasPart", "Leg"), some("hasPart", "Back")}))),
              (Found{"Leg ..0, Back ..0", true}));
    EXPECT_EQ(counts(no(exactly(2, name("Leg")))), (Found{"", false}));
    EXPECT_EQ(counts(no(at_least(0, name("Leg")))), (Found{"", false}));
}

TEST(CountedParts, WhatIsNoMatterOfNumbers) {
    EXPECT_EQ(counts(either({some("hasPart", "Leg"), some("hasPart", "Back")})), (Found{"", false}));
    EXPECT_EQ(counts(both({some("hasPart", "Leg"), at_least(1, no(name("Back")))})), (Found{"Leg 1..", false}));
    EXPECT_EQ(counts(some("hasShape", "Board")), (Found{"", true}));
}

}  // namespace
