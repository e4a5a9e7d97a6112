#include "base/errors.h"

#include <gtest/gtest.h>

#include "mini.h"

using namespace mini;
using owl::AxiomKind;

namespace {

std::string error_of(const owl::Ontology& ontology, std::size_t limit = 1 << 20) {
    knowledge::CompileOptions options;
    options.configuration_limit = limit;
    try {
        (void)knowledge::compile(ontology, options).objects();
    } catch (const OntologyError& error) {
        return error.what();
    }
    return "no error";
}

/// The last axiom of `ontology` is at fault; the sentence names its line and has `hint` in it.
void expect_refused(Ontology ontology, const std::string& hint) {
    const std::string place = "mini.ttl:" + std::to_string(ontology.result.axioms.size()) + ": ";
    ontology.same("SomeObject", some("hasPart", name("Thing")));
    const std::string error = error_of(ontology.result);
    EXPECT_TRUE(error.starts_with(place)) << error;
    EXPECT_NE(error.find(hint), std::string::npos) << error;
}

}  // namespace

TEST(Errors, NameAxiomFileAndLine) {
    expect_refused(shapes().same("Seat", some("hasShape", "Vertical")), "write hasOrientation some Vertical");
    expect_refused(shapes().same("Seat", both({name("Region"), name("Board")})), "write hasShape some Board");
    expect_refused(shapes().same("Back", both({name("Region"), some("hasPart", "Thing")})), "a region has no parts");
    expect_refused(shapes().same("Chair", both({name("Object"), some("hasShape", "Board")})),
                   "write hasPart some (hasShape some Board)");
    expect_refused(shapes().same("Chair", some("hasPart", name("Object"))), "object where a region is meant");
    expect_refused(shapes().same("Beach", at_least(100'000'000, some("hasShape", "Board"))), "count to 100000 at most");
    expect_refused(shapes().same("Bad", both({name("Incompatible"), some("hasShape", "Board")})),
                   "write SubClassOf: Incompatible");
    expect_refused(shapes().sub(some("hasShape", "Board"), name("Incompatible")), "needs a name");
    expect_refused(shapes().axiom(AxiomKind::symmetric_object_property, {}, "hasPart"), "one property each");
    expect_refused(shapes().note("height", "measure", "h").same("Seat", number("height", {{"maxInclusive", "1"}})),
                   "declare height functional");
    expect_refused(shapes().measured("height", "h").same("Seat", number("height", {{"maxInclusive", "tall"}})),
                   "\"tall\" is no number");
    expect_refused(shapes().measured("height", "h").same("Seat", number("height", {{"totalDigits", "3"}})),
                   "no bound of a number");
    expect_refused(shapes().sub("Board", "Stick"), "takes values away");
    expect_refused(shapes().sub("ThinBoard", "Board"), "ThinBoard is no value of Shape");
}

TEST(Errors, CircularDefinitions) {
    Ontology ontology = shapes();
    ontology.same("A", both({name("Region"), name("B"), some("hasShape", "Board")}))
        .same("B", both({name("A"), some("hasOrientation", "Vertical")}))
        .same("Chair", some("hasPart", "A"));
    const std::string error = error_of(ontology.result);
    EXPECT_NE(error.find("A is defined by itself through mini.ttl:10"), std::string::npos) << error;
    EXPECT_TRUE(error.starts_with("mini.ttl:9: ")) << error;
}

TEST(Errors, DeepDefinitionsAreRefusedNotCrashed) {
    constexpr int depth = 20'000;
    const auto named = [](int i) {
        std::string text = "A";
        return name(text += std::to_string(i));
    };
    for (const bool is_circle : {false, true}) {
        Ontology ontology = shapes();
        for (int i = 0; i < depth; ++i) {
            const bool is_last = i + 1 == depth;
            std::string text = "A";
            ontology.same(text += std::to_string(i),
                          both({name("Region"), no(named(is_last && is_circle ? 0 : i + 1))}));
        }
        ontology.sub(named(depth), name("Region")).same("Chair", some("hasPart", "A0"));
        const std::string error = error_of(ontology.result);
        EXPECT_NE(error.find("more than 500 deep"), std::string::npos) << error.substr(0, 500);
        EXPECT_LT(error.size(), 1000U);
    }
    Ontology synonyms = shapes();
    for (int i = 0; i < 3000; ++i) {
        std::string text = "A";
        synonyms.same(text += std::to_string(i), named(i + 1));
    }
    synonyms.same("A0", some("hasShape", "Board")).same("Chair", some("hasPart", "A0"));
    EXPECT_LT(error_of(synonyms.result).size(), 1000U);
}

TEST(Errors, AContradictionAmongManyRulesIsFound) {
    Ontology ontology;
    const auto has = [](int i, bool yes) {
        const std::string n = std::to_string(i);
        return some("hasF" + n, (yes ? "yes" : "no") + n);
    };
    for (int i = 0; i < 200; ++i) {
        const std::string n = std::to_string(i);
        ontology.range("F" + n, {"yes" + n, "no" + n});
    }
    for (int i = 0; i + 1 < 200; ++i) ontology.sub(both({name("Region"), has(i, true)}), has(i + 1, true));
    ontology.sub(name("Region"), has(20, true))
        .sub(name("Region"), has(23, false))
        .same("Chair", some("hasPart", "Thing"));
    const std::string error = error_of(ontology.result);
    EXPECT_NE(error.find("leaves no region possible"), std::string::npos) << error;
    EXPECT_EQ(std::ranges::count(error, '"'), 2 * 5) << "five axioms, no more: " << error;
}

TEST(Errors, InconsistentLayersAreBlamed) {
    Ontology ontology = shapes();
    ontology.same("Chair", some("hasPart", "Thing"))
        .sub(name("Region"), some("hasShape", "Board"))
        .sub(some("hasShape", "Board"), name("Nothing"));
    EXPECT_TRUE(error_of(ontology.result).starts_with("mini.ttl:11: ")) << error_of(ontology.result);
    Ontology objects = shapes();
    objects.same("Chair", some("hasPart", "Thing"))
        .sub(name("Object"), name("Chair"))
        .sub(name("Chair"), at_most(0, name("Thing")));
    EXPECT_NE(error_of(objects.result).find("leaves no object possible"), std::string::npos)
        << error_of(objects.result);
}

TEST(Errors, LimitsAndNoObjects) {
    Ontology ontology = shapes();
    EXPECT_NE(error_of(ontology.result).find("no concept describes an object"), std::string::npos);
    ontology.same("Chair", some("hasPart", "Thing"));
    EXPECT_EQ(error_of(ontology.result, 5), "no error");
    Ontology parts = shapes();
    for (unsigned i = 0; i < 12; ++i)
        parts.same(std::string(1, static_cast<char>('a' + i)),
                   at_least(5 + i, some("hasShape", i % 2 == 1 ? "Board" : "Cube")));
    EXPECT_EQ(error_of(parts.result, 100), "no error") << "a solver goes on";
    parts.same("Frame", both({name("CompositePart"), some("hasPart", some("hasShape", "Board"))}))
        .same("Framed", both({name("Object"), some("hasPart", "Frame")}));
    EXPECT_NE(error_of(parts.result, 100).find("more than 100 ways"), std::string::npos) << error_of(parts.result, 100);
}

TEST(Errors, KnobsOutOfOrder) {
    for (const std::string text : {"l0/l1 2 1 3 4", "1 2 3 4", "l0/l1 a b c d", "l0/l1 nan 1 2 3", ""}) {
        Ontology ontology = shapes();
        ontology.note("Board", "criterion", text).same("Chair", some("hasPart", "Thing"));
        const std::string error = error_of(ontology.result);
        EXPECT_TRUE(error.starts_with("mini.ttl:1000: ")) << error;
    }
    Ontology ontology = shapes();
    ontology.note("Board", "cost", "-1").same("Chair", some("hasPart", "Thing"));
    EXPECT_NE(error_of(ontology.result).find("above 0"), std::string::npos);
    for (const std::string text : {"0.5 0.6 1.2", "0.5 0.6 high 1.4", "0.6 0.5 1.2 1.4", "height 0.5 0.6 1.2 1.4", ""}) {
        Ontology tall = shapes();
        tall.note("Chair", "typicalHeight", text).same("Chair", some("hasPart", "Thing"));
        const std::string error = error_of(tall.result);
        EXPECT_TRUE(error.starts_with("mini.ttl:1000: typicalHeight")) << error;
    }
}

TEST(Errors, MoreConceptsThanCanBeCompiled) {
    Ontology ontology = shapes();
    ontology.same("Chair", some("hasPart", "C1"));
    for (int i = 0; i < 10'000; ++i) ontology.sub("C" + std::to_string(i), "Region");
    EXPECT_NE(error_of(ontology.result).find("more than 10000 cannot be compiled together"), std::string::npos);
}
