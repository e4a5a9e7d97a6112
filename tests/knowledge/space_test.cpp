#include <gtest/gtest.h>

#include "base/errors.h"
#include "mini.h"

using namespace mini;
using knowledge::compile;
using knowledge::Domain;
using knowledge::VariableKind;

namespace {

/// Paper Fig. 5: seat and foot, two combinations that are neither.
Ontology figure_5() {
    Ontology ontology = shapes();
    ontology
        .same("Seat", both({name("Region"), some("hasShape", either({name("Board"), name("Cube")})),
                            some("hasOrientation", "Horizontal")}))
        .same("Foot", both({some("hasOrientation", "Vertical"), some("hasShape", no(name("Cube")))}))
        .same("FloatingCube", both({some("hasShape", "Cube"), some("hasOrientation", "Vertical")}))
        .sub("FloatingCube", "Incompatible")
        .same("LyingStick", both({some("hasShape", "Stick"), some("hasOrientation", "Horizontal")}))
        .sub("LyingStick", "Incompatible")
        .same("Chair", both({name("Object"), some("hasPart", "Seat"), at_least(3, name("Foot"))}));
    return ontology;
}

}  // namespace

TEST(Space, PaperFigure5) {
    const Domain domain = compile(figure_5().result);
    EXPECT_EQ(domain.regions.product, 6U);
    EXPECT_EQ(domain.regions.size, 6U);
    EXPECT_EQ(domain.regions.possible.count(), 4U);
    EXPECT_EQ(count(domain.regions, "Seat"), 2U);
    EXPECT_EQ(count(domain.regions, "Foot"), 2U);
    EXPECT_EQ(domain.regions.variables[0].values, (std::vector<std::string>{"Board", "Cube", "Stick"}));
    const auto seat = domain.regions.find(iri("Seat"));
    for (std::size_t i = 0; i < 6; ++i) {
        const bool board_or_cube = domain.regions.holds[0][0].has(i) || domain.regions.holds[0][1].has(i);
        EXPECT_EQ(domain.regions.concepts[*seat].where.has(i), board_or_cube && domain.regions.holds[1][0].has(i));
    }
    EXPECT_EQ(domain.layer(iri("Foot")), 1);  // found from what the definition mentions
    EXPECT_EQ(domain.layer(iri("Chair")), 2);
    EXPECT_EQ(domain.layer(iri("Board")), 0);
    EXPECT_EQ(domain.layer(iri("nobody")), -1);
    EXPECT_TRUE(domain.regions.concepts[*domain.regions.find(iri("LyingStick"))].incompatible);
    EXPECT_TRUE(domain.warnings.empty()) << domain.warnings.front();
}

TEST(Space, ObjectsAreWhatPartsCanBe) {
    const Domain domain = compile(figure_5().result);
    // seat or none, three feet or fewer: 2 x 2, each realised also without impossible regions
    EXPECT_EQ(domain.objects().product, 4U);
    EXPECT_EQ(domain.objects().size, 4U);
    EXPECT_EQ(domain.objects().possible.count(), 4U);
    EXPECT_EQ(domain.part_conditions.size(), 2U);
    EXPECT_EQ(domain.part_conditions[1].count(), 2U);
}

TEST(Space, ACompactSeatIsASeat) {
    Ontology ontology = shapes();
    ontology.same("Seat", some("hasShape", "Board"))
        .same("Bench", both({some("hasPart", "Seat"), at_most(1, name("Seat")),
                             some("hasPart", both({name("Seat"), some("hasOrientation", "Vertical")}))}));
    const Domain domain = compile(ontology.result);
    // atoms: 1 seat, 2 seats, 1 vertical seat; without a seat there is no vertical one
    EXPECT_EQ(domain.objects().product, 8U);
    EXPECT_EQ(domain.objects().size, 5U);
}

TEST(Space, NumbersAreCutWhereAxiomsMentionThem) {
    Ontology ontology = shapes();
    ontology.measured("height", "top height")
        .measured("width")
        .same("Low", number("height", {{"maxInclusive", "0.4"}}))
        .same("Middle", number("height", {{"minExclusive", "0.4"}, {"maxExclusive", "0.8"}}))
        .same("Wide", number("width", {{"minInclusive", "1"}}))
        .same("Anything", number("height", {}))
        .same("Chair", some("hasPart", "Low"));
    const Domain domain = compile(ontology.result);
    ASSERT_EQ(domain.numbers.size(), 2U);
    EXPECT_EQ(domain.regions.product, 6U * 3U * 2U);
    EXPECT_EQ(domain.regions.variables[2].values, (std::vector<std::string>{"<= 0.4", "> 0.4, < 0.8", ">= 0.8"}));
    EXPECT_EQ(domain.regions.variables[3].values, (std::vector<std::string>{"< 1", ">= 1"}));
    EXPECT_EQ(count(domain.regions, "Low"), 12U);
    EXPECT_EQ(count(domain.regions, "Anything"), 36U);
    EXPECT_TRUE(domain.regions.variables[2].answerable);
    EXPECT_FALSE(domain.regions.variables[3].answerable);
    EXPECT_TRUE(domain.numbers[0].intervals[0].has(0.4));
    EXPECT_FALSE(domain.numbers[0].intervals[1].has(0.4));
    ASSERT_FALSE(domain.warnings.empty());
    EXPECT_NE(domain.warnings[0].find("width has no core:measure"), std::string::npos);
}

TEST(Space, WithoutUnionThereIsAnotherValue) {
    Ontology ontology;
    ontology.range("Texture", {"Wood", "Cloth"}, false)
        .same("Soft", some("hasTexture", no(name("Wood"))))
        .same("Sofa", some("hasPart", "Soft"));
    const Domain domain = compile(ontology.result);
    EXPECT_EQ(domain.regions.variables[0].values, (std::vector<std::string>{"Cloth", "Wood", "other"}));
    EXPECT_EQ(count(domain.regions, "Soft"), 2U);
    EXPECT_FALSE(domain.ranges[0].covered);
}

TEST(Space, PrimitiveConceptsAreFreeAndTold) {
    Ontology ontology = shapes();
    ontology.sub("Leg", "Region")
        .sub(name("Leg"), some("hasOrientation", "Vertical"))
        .sub(name("Leg"), some("hasShape", "Stick"))
        .same("Table", both({name("Object"), some("hasPart", "Leg")}));
    const Domain domain = compile(ontology.result);
    EXPECT_EQ(domain.regions.product, 12U);
    EXPECT_EQ(domain.regions.size, 7U);  // only a vertical stick may be a leg, or not
    EXPECT_FALSE(domain.regions.concepts[*domain.regions.find(iri("Leg"))].provable);
    EXPECT_TRUE(domain.objects().concepts[*domain.objects().find(iri("Table"))].provable);
    EXPECT_NE(std::ranges::find(domain.warnings,
                                "Leg has only necessary conditions, so no region can ever be proved to be a Leg; did "
                                "you mean EquivalentTo?"),
              domain.warnings.end());
}

TEST(Space, SufficientConditionsProve) {
    Ontology ontology = shapes();
    ontology.sub(some("hasShape", "Stick"), name("Leg")).sub("Leg", "Region").same("Table", some("hasPart", "Leg"));
    const Domain domain = compile(ontology.result);
    EXPECT_TRUE(domain.regions.concepts[*domain.regions.find(iri("Leg"))].provable);
    EXPECT_EQ(domain.regions.size, 10U);
}

TEST(Space, AxiomsThatConstrain) {
    Ontology ontology = shapes();
    ontology
        .sub(some("hasShape", "Stick"), some("hasOrientation", "Vertical"))  // no lying sticks
        .same("Seat", some("hasShape", "Board"))
        .same("Wall", some("hasOrientation", "Vertical"))
        .disjoint(name("Seat"), name("Wall"))  // no upright boards
        .same("Chair", both({name("Object"), some("hasPart", "Seat")}))
        .sub("Chair", "Furniture")
        .sub("Furniture", "Object")
        .sub(name("Furniture"), at_most(1, name("Seat")));
    const Domain domain = compile(ontology.result);
    EXPECT_EQ(domain.regions.size, 4U);
    EXPECT_TRUE(is_below(domain, "Chair", "Furniture"));
    EXPECT_TRUE(is_below(domain, "Chair", "Object"));
    // no seat (Furniture free: 2), one seat (a chair, so furniture: 1), two seats: impossible
    EXPECT_EQ(domain.objects().size, 3U);
}

TEST(Space, OnlyAndCardinalities) {
    Ontology ontology = shapes();
    ontology.same("Seat", only("hasShape", name("Board")))
        .same("AllSeats", only("hasPart", name("Seat")))
        .same("NoOther", at_most(0, no(name("Seat"))))
        .same("Pair", exactly(2, name("Thing")))
        .same("Lonely", both({name("Object"), at_most(0, name("Thing"))}))
        .same("Never", at_least(1, both({name("Seat"), no(name("Seat"))})))
        .same("Always", at_least(0, name("Seat")));
    const Domain domain = compile(ontology.result);
    EXPECT_TRUE(is_below(domain, "AllSeats", "NoOther"));
    EXPECT_TRUE(is_below(domain, "NoOther", "AllSeats"));
    EXPECT_TRUE(is_below(domain, "Lonely", "AllSeats"));
    EXPECT_FALSE(is_below(domain, "Pair", "AllSeats"));
    EXPECT_TRUE(is_below(domain, "Object", "Always"));
    EXPECT_EQ(domain.unsatisfiable(), (std::vector{iri("Never")}));
}

TEST(Space, SynonymsAndUnions) {
    Ontology ontology = shapes();
    ontology.same("Seat", some("hasShape", "Board"))
        .same("Assise", name("Seat"))
        .same("Wall", some("hasShape", "Stick"))
        .axiom(owl::AxiomKind::disjoint_union, {name("Slab"), name("Seat"), name("Wall")})
        .same("Chair", some("hasPart", "Slab"));
    const Domain domain = compile(ontology.result);
    EXPECT_EQ(count(domain.regions, "Assise"), 2U);
    EXPECT_EQ(count(domain.regions, "Slab"), 4U);
    EXPECT_EQ(domain.most_specific({iri("Seat"), iri("Assise"), iri("Slab")}),
              (std::vector{iri("Seat"), iri("Assise")}));
}

TEST(Space, ADiagnosisDoesNotHideTheClass) {
    Ontology ontology = shapes();
    ontology.same("Chair", some("hasPart", some("hasShape", "Board")))
        .same("Broken", both({name("Chair"), some("hasPart", some("hasShape", "Cube"))}))
        .sub("Broken", "Incompatible");
    const Domain domain = compile(ontology.result);
    EXPECT_EQ(domain.most_specific({iri("Chair"), iri("Broken")}), (std::vector{iri("Chair"), iri("Broken")}));
    EXPECT_TRUE(is_below(domain, "Broken", "Incompatible"));
}

TEST(Space, KnobsAreRead) {
    Ontology ontology = shapes();
    ontology.note("Board", "criterion", "top height -inf -inf 0.5 1")
        .note("Board", "criterion", "l0/l1 1.5 2 inf inf")
        .note("Board", "cost", "2.5")
        .note("Cube", "measure", "end height")
        .note("Cube", "membership", "0 1 2 3")
        .note("Stick", "question", "does it look like a stick")
        .same("Chair", some("hasPart", some("hasShape", "Board")));
    const Domain domain = compile(ontology.result);
    const auto& values = domain.ranges[0].values;
    ASSERT_EQ(values[0].criteria.size(), 2U);
    EXPECT_EQ(values[0].criteria[0].measure, "top height");
    EXPECT_EQ(values[0].criteria[0].a4, 1);
    EXPECT_EQ(values[0].cost, 2.5);
    EXPECT_EQ(values[1].criteria[0].measure, "end height");
    EXPECT_EQ(values[2].question, "does it look like a stick");
}

TEST(Space, WhatADomainDoesNotSpeakOfIsNoFeatureOfIt) {
    const auto domain_of = [](const std::string& condition) {
        return compile(owl::parse_ontology(
            "Prefix: : <urn:test#>\nPrefix: core: <https://w3id.org/partonomy/core#>\n"
            "Ontology: <urn:test>\nImport: <https://w3id.org/partonomy/core>\n"
            "Class: Plate\n  EquivalentTo: core:Region and (" +
                condition + ")\nClass: Thing\n  EquivalentTo: core:Object and (core:hasPart some Plate)\n",
            "small.omn"));
    };
    const auto names = [](const Domain& domain) {
        std::vector<std::string> found;
        for (const knowledge::Variable& variable : domain.regions.variables)
            found.push_back(owl::local_name(variable.iri));
        return found;
    };
    const Domain one = domain_of("core:hasShape some core:Board");
    EXPECT_EQ(names(one), std::vector<std::string>{"Shape"});
    EXPECT_TRUE(one.warnings.empty());
    EXPECT_TRUE(one.numbers.empty());
    ASSERT_EQ(one.relations.size(), 1U);  // which parts make up one composite part
    EXPECT_EQ(one.relations[0].iri, std::string(owl::core_prefix) + "Connected");
    // A sibling of what is named comes with it.
    EXPECT_EQ(names(domain_of("core:hasOrientation some core:Vertical and core:hasShape some core:Shape")),
              (std::vector<std::string>{"Shape", "Orientation"}));
    // The hierarchy still tells all that core says.
    const auto hierarchy = one.hierarchy();
    const auto is_told = [&](const char* sub, const char* super) {
        return std::ranges::find(hierarchy, std::pair<owl::Iri, owl::Iri>{std::string(owl::core_prefix) + sub,
                                                                          std::string(owl::core_prefix) + super}) !=
               hierarchy.end();
    };
    EXPECT_TRUE(is_told("Vertical", "Orientation"));
    EXPECT_TRUE(is_told("Orientation", "Feature"));
    EXPECT_TRUE(is_told("UpFrom", "Relation"));
}

/// A module of core says the same of what the domain speaks of as the whole.
TEST(Space, OfAModuleOfCoreIsThatOfTheWhole) {
    for (const char* name : {"furniture.ttl", "paper-furniture.ttl", "furniture-headrest.omn"}) {
        SCOPED_TRACE(name);
        const std::string path = std::string(PARTONOMY_SOURCE_DIR "/ontologies/") + name;
        owl::LoadOptions some;
        some.whole_core = false;
        const owl::Ontology whole = owl::load_ontology(path), module = owl::load_ontology(path, some);
        EXPECT_LT(module.axioms.size(), whole.axioms.size());
        std::set<std::string> axioms;  // each with its place
        const auto words = [](const owl::Axiom& axiom) {
            return at(axiom.source.file, axiom.source.line, to_manchester(axiom));
        };
        for (const owl::Axiom& axiom : whole.axioms) axioms.insert(words(axiom));
        for (const owl::Axiom& axiom : module.axioms) EXPECT_TRUE(axioms.contains(words(axiom))) << words(axiom);
        const Domain one = compile(whole), other = compile(module);
        ASSERT_EQ(one.regions.variables.size(), other.regions.variables.size());
        for (std::size_t v = 0; v < one.regions.variables.size(); ++v) {
            EXPECT_EQ(one.regions.variables[v].iri, other.regions.variables[v].iri);
            EXPECT_EQ(one.regions.variables[v].values, other.regions.variables[v].values);
        }
        ASSERT_EQ(one.regions.concepts.size(), other.regions.concepts.size());
        for (std::size_t c = 0; c < one.regions.concepts.size(); ++c)
            EXPECT_EQ(one.regions.concepts[c].where, other.regions.concepts[c].where) << one.regions.concepts[c].iri;
        EXPECT_EQ(one.objects().size, other.objects().size);
        EXPECT_EQ(one.warnings, other.warnings);
    }
}
