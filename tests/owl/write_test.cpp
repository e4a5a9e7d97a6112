// What we write is read back as the same, by us and by the OWL API.

#include "owl/write.h"

#include <gtest/gtest.h>

#include "base/errors.h"
#include "base/files.h"
#include "owl/canonical.h"
#include "owl/random_ontology.h"
#include "owl/zoo.h"

namespace partonomy::owl {
namespace {

/// Axioms with their annotations, individuals by name: our writers keep the labels of anonymous ones.
std::set<std::string> exact_axioms(const Ontology& ontology) {
    std::set<std::string> texts;
    for (const Axiom& axiom : ontology.axioms) texts.insert(text_of(axiom, true));
    return texts;
}

TEST(Write, ZooComesBackWhole) {
    const Ontology zoo = parse_ontology(zoo::text("ttl"), "zoo.ttl");
    for (const std::string& text : {write_turtle(zoo), write_functional(zoo)}) {
        const Ontology back = parse_ontology(text, "back");
        EXPECT_EQ(differences(everything_in(zoo), everything_in(back)), "") << text;
        EXPECT_EQ(differences(exact_axioms(zoo), exact_axioms(back)), "") << text;
        ASSERT_EQ(back.axioms.size(), zoo.axioms.size());
        for (std::size_t i = 0; i < back.axioms.size(); ++i)
            EXPECT_EQ(to_manchester(back.axioms[i]), to_manchester(zoo.axioms[i])) << "the order is kept, too";
    }
    EXPECT_EQ(write_turtle(zoo), write_turtle(parse_ontology(write_turtle(zoo), "back")));
    EXPECT_EQ(write_functional(zoo), write_functional(parse_ontology(write_functional(zoo), "back")));
}

TEST(Write, RandomOntologiesComeBackWhole) {
    for (unsigned seed = 0; seed < 150; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        const Ontology made = RandomOntology(seed).make(80);
        for (const std::string& text : {write_turtle(made), write_functional(made)}) {
            const Ontology back = parse_ontology(text, "back");
            const std::string changed = differences(exact_axioms(made), exact_axioms(back));
            ASSERT_EQ(changed, "") << text;
            std::set<std::string> whole = everything_in(made);
            ASSERT_EQ(differences(whole, everything_in(back)), "") << text;
        }
    }
}

TEST(Write, ImportsAreKeptOrMerged) {
    const std::string path = PARTONOMY_SOURCE_DIR "/ontologies/furniture.ttl";
    const Ontology furniture = load_ontology(path);
    for (const auto writer : {&write_turtle, &write_functional}) {
        const std::string kept = writer(furniture, {.merge_imports = false});
        const std::string merged = writer(furniture, {.merge_imports = true});
        EXPECT_LT(kept.size(), merged.size());
        const Ontology with_import = parse_ontology(kept, "kept");
        EXPECT_EQ(with_import.imports.size(), 1U);
        const Ontology alone = parse_ontology(merged, "merged");
        EXPECT_TRUE(alone.imports.empty());
        EXPECT_EQ(differences(everything_in(furniture), everything_in(with_import)), "");
        EXPECT_EQ(differences(everything_in(furniture), everything_in(alone)), "");
    }
}

TEST(Write, WhatHasSeveralFormsIsWrittenInTheOneThatTriplesHave) {
    const std::string head =
        "Prefix(:=<http://e/>)\nOntology(<http://e>\nDeclaration(ObjectProperty(:p)) Declaration(ObjectProperty(:q)) "
        "Declaration(Class(:A)) Declaration(Class(:B)) Declaration(Class(:C))\n";
    const auto said = [&](const std::string& axiom) {
        const Ontology ontology = parse_ontology(head + axiom + ")", "o.ofn");
        EXPECT_EQ(exact_axioms(parse_ontology(write_turtle(ontology), "back")), exact_axioms(ontology)) << axiom;
        std::string all;
        for (const Axiom& one : ontology.axioms) all += to_manchester(one) + "; ";
        return all;
    };
    EXPECT_EQ(said("EquivalentClasses(:A :B :C)"), "A EquivalentTo: B; B EquivalentTo: C; ");
    EXPECT_EQ(said("SameIndividual(:x :y :z)"), "x SameAs: y; y SameAs: z; ");
    EXPECT_EQ(said("DisjointClasses(:A :B)"), "A DisjointWith: B; ");
    EXPECT_EQ(said("ObjectPropertyAssertion(ObjectInverseOf(:p) :x :y)"), "y Facts: p x; ");
    EXPECT_EQ(said("InverseObjectProperties(ObjectInverseOf(:p) :q)"), "q InverseOf: inverse (p); ");
    EXPECT_EQ(said("InverseObjectProperties(ObjectInverseOf(:p) ObjectInverseOf(:q))"), "p InverseOf: q; ");
    EXPECT_EQ(said("SubClassOf(:A ObjectMinCardinality(2 :p owl:Thing))"), "A SubClassOf: p min 2 Thing; ");
}

TEST(Write, AnOntologyWithoutNameOrAxioms) {
    for (const auto writer : {&write_turtle, &write_functional}) {
        const Ontology empty = parse_ontology(writer(Ontology(), {}), "empty");
        EXPECT_TRUE(empty.iri.empty());
        EXPECT_TRUE(empty.axioms.empty());
        Ontology noted;
        noted.annotations[""].push_back({"http://www.w3.org/2000/01/rdf-schema#label",
                                         {"no name", "http://www.w3.org/2001/XMLSchema#string", {}},
                                         {},
                                         {}});
        const Ontology back = parse_ontology(writer(noted, {}), "noted");
        ASSERT_EQ(back.annotations.count(""), 1U);
        EXPECT_EQ(back.annotations.at("")[0].literal.value, "no name");
    }
}

}  // namespace
}  // namespace partonomy::owl
