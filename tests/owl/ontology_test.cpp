// The ontologies that ship with Partonomy, wording and look-up; and HermiT's opinion on core and furniture.

#include "owl/ontology.h"

#include <gtest/gtest.h>

#include "base/files.h"

namespace partonomy::owl {
namespace {

const std::string ontologies = PARTONOMY_SOURCE_DIR "/ontologies/";
const std::string head =
    "@prefix : <http://e/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix rdfs: "
    "<http://www.w3.org/2000/01/rdf-schema#> . @prefix xsd: <http://www.w3.org/2001/XMLSchema#> .\n"
    ":A a owl:Class . :B a owl:Class . :C a owl:Class . :p a owl:ObjectProperty . :d a owl:DatatypeProperty .\n";

TEST(Ontology, CoreIsBuiltInByteForByte) { EXPECT_EQ(core_ontology_text(), read_file(ontologies + "core.ttl")); }

TEST(Ontology, FurnitureReads) {
    const Ontology ontology = load_ontology(ontologies + "furniture.ttl");
    EXPECT_EQ(ontology.iri, "https://w3id.org/partonomy/furniture");
    ASSERT_EQ(ontology.imports.size(), 1U);
    EXPECT_EQ(ontology.imports[0].first, core_iri);
    EXPECT_NE(ontology.find(ontology.iri + "#Chair", EntityKind::klass), nullptr);
    EXPECT_EQ(ontology.find(ontology.iri + "#Chair", EntityKind::object_property), nullptr);
    EXPECT_EQ(ontology.label(ontology.iri + "#Chair"), "chair");
    EXPECT_EQ(ontology.find(std::string(core_prefix) + "hasShape", EntityKind::object_property)->source.file,
              "core.ttl (built in)");

    // Each axiom of a class can be found in the file: its line, or the line above for the first of a list, names it.
    for (const Axiom& axiom : ontology.axioms) EXPECT_GT(axiom.source.line, 0) << to_manchester(axiom);
}

TEST(Ontology, SameBytesSameOntology) {
    const Ontology one = load_ontology(ontologies + "furniture.ttl");
    const Ontology two = load_ontology(ontologies + "furniture.ttl");
    ASSERT_EQ(one.axioms.size(), two.axioms.size());
    for (std::size_t i = 0; i < one.axioms.size(); ++i) {
        EXPECT_EQ(to_manchester(one.axioms[i]), to_manchester(two.axioms[i]));
        EXPECT_EQ(one.axioms[i].source.line, two.axioms[i].source.line);
    }
}

TEST(Ontology, LabelsByLanguage) {
    const Ontology ontology = parse_ontology(head +
                                                 ":A rdfs:label \"plain\" , \"english\"@EN , \"deutsch\"@de . :B "
                                                 "rdfs:label \"bé\"@fr . :C rdfs:label \"c\" .",
                                             "o.ttl");
    EXPECT_EQ(ontology.label("http://e/A"), "english");
    EXPECT_EQ(ontology.label("http://e/A", "de"), "deutsch");
    EXPECT_EQ(ontology.label("http://e/A", "es"), "plain");
    EXPECT_EQ(ontology.label("http://e/B"), "B");
    EXPECT_EQ(ontology.label("http://e/C"), "c");
    EXPECT_EQ(ontology.label("http://e/none"), "none");
}

TEST(Ontology, LocalNames) {
    EXPECT_EQ(local_name("https://e.org/furniture#Seat"), "Seat");
    EXPECT_EQ(local_name("https://e.org/furniture/Seat"), "Seat");
    EXPECT_EQ(local_name("urn:x"), "urn:x");
    EXPECT_EQ(local_name("http://e/"), "");
}

TEST(Ontology, UndeclaredIndividualsAreEntitiesAndUnknownPropertiesAnnotations) {
    const Ontology ontology = parse_ontology(head + ":x a :A ; :p :y ; :heard :z ; :d 1 .\n[] :p :x .", "o.ttl");
    EXPECT_NE(ontology.find("http://e/x", EntityKind::individual), nullptr);
    EXPECT_NE(ontology.find("http://e/y", EntityKind::individual), nullptr);
    EXPECT_EQ(ontology.find("http://e/z", EntityKind::individual), nullptr);
    ASSERT_EQ(ontology.annotations.at("http://e/x").size(), 1U);
    EXPECT_EQ(ontology.annotations.at("http://e/x")[0].iri, "http://e/z");
    EXPECT_EQ(ontology.annotations.at("http://e/x")[0].source.line, 3);
    ASSERT_EQ(ontology.axioms.size(), 4U);
    EXPECT_TRUE(ontology.axioms[3].individuals[0].starts_with("_:"));
}

TEST(Ontology, ManchesterParentheses) {
    const auto said = [](const std::string& expression) {
        const Ontology ontology = parse_ontology(head + ":A owl:equivalentClass " + expression + " .", "o.ttl");
        return to_manchester(*ontology.axioms.at(0).classes.at(1));
    };
    EXPECT_EQ(said("[ owl:unionOf ( :A [ owl:intersectionOf ( :B :C ) ] ) ]"), "A or (B and C)");
    EXPECT_EQ(said("[ owl:intersectionOf ( :A [ owl:unionOf ( :B :C ) ] ) ]"), "A and (B or C)");
    EXPECT_EQ(said("[ owl:complementOf [ owl:complementOf :B ] ]"), "not (not B)");
    EXPECT_EQ(said("[ owl:onProperty :p ; owl:someValuesFrom [ owl:onProperty [ owl:inverseOf :p ] ; owl:allValuesFrom "
                   "[ owl:unionOf ( :A :B ) ] ] ]"),
              "p some (inverse (p) only (A or B))");
    EXPECT_EQ(said("[ owl:onProperty :d ; owl:someValuesFrom [ owl:onDatatype xsd:double ; owl:withRestrictions "
                   "( [ xsd:minExclusive 0.4 ] [ xsd:maxInclusive 0.48 ] ) ] ]"),
              "d some xsd:double[> 0.4, <= 0.48]");
    EXPECT_EQ(said("[ owl:onProperty :d ; owl:hasValue \"say \\\"hi\\\"\" ]"), "d value \"say \\\"hi\\\"\"");
}

}  // namespace
}  // namespace partonomy::owl
