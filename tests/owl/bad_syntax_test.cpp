// What a user can do wrong in OWL/XML, functional and Manchester syntax: one clear sentence each, that names file and
// line.

#include <gtest/gtest.h>

#include <filesystem>

#include "base/errors.h"
#include "base/files.h"
#include "owl/ontology.h"
#include "owl/refused.h"
#include "owl/zoo.h"

namespace partonomy::owl {
namespace {

std::string sentence(const std::string& text) { return owl::sentence(text, "bad.owl"); }
void expect_refused(const std::vector<Bad>& cases) { owl::expect_refused(cases, "bad.owl"); }

/// What a test adds begins on line 3.
const std::string functional =
    "Prefix(:=<http://e/>)\n"
    "Ontology(<http://e> Declaration(Class(:Seat)) Declaration(Class(:Leg)) Declaration(ObjectProperty(:p)) "
    "Declaration(DataProperty(:d)) Declaration(NamedIndividual(:x))\n";

TEST(BadFunctional, Sentences) {
    expect_refused({
        {functional + "SubClassOf(:Seat :Leg)\n", "bad.owl:4: ", "before the Ontology( of line 2 is closed"},
        {functional + "SubClassOf(:Seat\n:Leg", "bad.owl:4: ", "before the SubClassOf( of line 3 is closed"},
        {functional + "SubClassOf(:Seat :Leg))\n)", "bad.owl:4: ", "')' stands after the end of the ontology"},
        {functional + "SubClasOf(:Seat :Leg))", "bad.owl:3: ", "an axiom such as SubClassOf"},
        {functional + "SubClassOf(:Seat))", "bad.owl:3: ", "SubClassOf wants 2 parts, here are 1"},
        {functional + "SubClassOf(:Seat ObjectSomeValueFrom(:p :Leg)))",
         "bad.owl:3: ", "a class expression is expected where ObjectSomeValueFrom stands"},
        {functional + "SubClassOf(:Seat\n:Legg))", "bad.owl:4: ", "Legg is used as a class but not declared"},
        {functional + "SubClassOf(:Seat :Legg))", "bad.owl:3: ", "(did you mean Leg?)"},
        {functional + "SubClassOf(:Seat :p))",
         "bad.owl:3: ", "p is an object property, but stands where a class is expected"},
        {functional + "SubClassOf(:Seat ObjectSomeValuesFrom(:d :Leg)))",
         "bad.owl:3: ", "d is a data property, but stands where an object property is expected"},
        {functional + "SubClassOf(:Seat \"Leg\"))", "bad.owl:3: ", "a class is expected where a literal stands"},
        {functional + "SubClassOf(:Seat (:Leg)))", "bad.owl:3: ", "a list in parentheses stands"},
        {functional + "SubClassOf(:Seat ObjectMinCardinality(two :p)))", "bad.owl:3: ", "'two' is no name"},
        {functional + "SubClassOf(:Seat ObjectMinCardinality(-2 :p)))", "bad.owl:3: ", "wants a whole number"},
        {functional + "SubClassOf(:Seat ObjectMinCardinality(99999999999 :p)))", "bad.owl:3: ", "wants a whole number"},
        {functional + "SubClassOf(:Seat DataSomeValuesFrom(:d :d DataOneOf(\"1\"))))",
         "bad.owl:3: ", "for which OWL 2 has no data ranges"},
        {functional + "DataPropertyRange(:d DatatypeRestriction(xsd:double xsd:minInclusive)))",
         "bad.owl:3: ", "wants at least 3 parts"},
        {functional + "DataPropertyRange(:d DatatypeRestriction(xsd:double xsd:minInclusive \"tall\"^^xsd:double)))",
         "bad.owl:3: ", "wants a number"},
        {functional + "DataPropertyAssertion(:e :x \"1\"))",
         "bad.owl:3: ", "e is used as a data property but not declared"},
        {functional + "DataPropertyAssertion(:d :x :x))", "bad.owl:3: ", "a literal is expected where x stands"},
        {functional + "ObjectPropertyAssertion(:p :x \"1\"))",
         "bad.owl:3: ", "an individual is expected where a literal"},
        {functional + "HasKey(:Seat () ()))", "bad.owl:3: ", "names no property"},
        {functional + "Declaration(Chair(:c)))", "bad.owl:3: ", "or another kind of entity"},
        {functional + "Declaration(Class(:a :b)))", "bad.owl:3: ", "Class wants one name"},
        {functional + "SubClassOf(:Seat e:Leg))", "bad.owl:3: ", "the prefix 'e:' of 'e:Leg' is not declared"},
        {functional + "SubClassOf(:Seat <http://e/a b>))", "bad.owl:3: ", "an IRI cannot hold a space"},
        {functional + "SubClassOf(:Seat <http://e/a", "bad.owl:3: ", "is not closed by '>'"},
        {functional + "AnnotationAssertion(rdfs:label :Seat \"open))", "bad.owl:3: ", "never closed"},
        {functional + "AnnotationAssertion(rdfs:label :Seat \"x\"^^))", "bad.owl:3: ", "a datatype such as xsd:double"},
        {functional + "AnnotationAssertion(rdfs:label :Seat \"x\"@))", "bad.owl:3: ", "a language such as @en"},
        {functional + "AnnotationAssertion(rdfs:label \"x\" \"x\"))",
         "bad.owl:3: ", "an IRI is expected where a literal"},
        {functional + "Import(<http://e/other>))", "bad.owl:3: ", "cannot be found"},
        {functional + "DLSafeRule(Body()))", "bad.owl:3: ", "DLSafeRule wants 2 parts"},
        {functional + "DLSafeRule(Head() Body()))", "bad.owl:3: ", "the Body of a rule is expected"},
        {functional + "DLSafeRule(Body(ClassAtom(:Seat \"x\")) Head()))", "bad.owl:3: ", "wants a thing"},
        {functional + "DLSafeRule(Body(BuiltInAtom(swrlb:add)) Head()))",
         "bad.owl:3: ", "BuiltInAtom wants at least 2"},
        {functional + "DLSafeRule(Body(Atom(:Seat :x)) Head()))", "bad.owl:3: ", "an atom of a rule is expected"},
        {"Prefix(:=http://e/)", "bad.owl:1: ", "wants an IRI in < >"},
        {"Prefix(e=<http://e/>)", "bad.owl:1: ", "a prefix is declared as"},
        {"\nPrefix(:=<http://e/>)", "bad.owl:2: ", "Ontology( is expected where the end of the file stands"},
        {"Ontology(<http://e>\n\x01)", "bad.owl:2: ", "a control character"},
        {"Ontology(<http://e>\n{)", "bad.owl:2: ", "'{' stands"},
    });
}

const std::string manchester =
    "Prefix: : <http://e/> Ontology: <http://e>\n"
    "Class: Seat Class: Leg ObjectProperty: p DataProperty: d Individual: x\n";

TEST(BadManchester, Sentences) {
    expect_refused({
        {manchester + "Class: Seat SubClassOf:", "bad.owl:3: ",
         "a class, property or datatype is expected where the end"},
        {manchester + "Class: Seat SubclassOf: Leg", "bad.owl:3: ", "(did you mean SubClassOf:?)"},
        {manchester + "Class: Seat Facts: p x", "bad.owl:3: ", "'Facts:' does not belong here"},
        {manchester + "Class: Seat SubClassOf: Leg Leg", "bad.owl:3: ", "or a comma, is expected in a Class frame"},
        {manchester + "Class: Seat SubClassOf:\n Legg", "bad.owl:4: ", "Legg is used as a class but not declared"},
        {manchester + "Class: Seat SubClassOf: p sme Leg", "bad.owl:3: ", "where 'sme' stands"},
        {manchester + "Class: Seat SubClassOf: p some", "bad.owl:3: ", "is expected where the end of the file stands"},
        {manchester + "Class: Seat SubClassOf: p min Leg", "bad.owl:3: ", "a whole number is expected after 'min'"},
        {manchester + "Class: Seat SubClassOf: p min 1.5 Leg", "bad.owl:3: ", "wants a whole number"},
        {manchester + "Class: Seat SubClassOf: (Leg and p some Seat", "bad.owl:3: ", "')' is expected"},
        {manchester + "Class: Seat SubClassOf: (Leg and\n (p some Seat)\nClass: Leg", "bad.owl:5: ", "'(' in line 3"},
        {manchester + "Class: Seat SubClassOf: Leg and (d < 0.03)",
         "bad.owl:3: ", "in square brackets: d some xsd:double[< 0.03]"},
        {manchester + "Class: Seat SubClassOf: d >= 2", "bad.owl:3: ", "d some xsd:double[>= 2]"},
        {manchester + "Class: Seat SubClassOf: d some xsd:double[< 0,03]", "bad.owl:3: ", "write 0.03 for 0,03"},
        {manchester + "Class: Seat SubClassOf: d some xsd:double[>= 1.5, 2]", "bad.owl:3: ", "a facet such as '>='"},
        {manchester + "Class: Seat SubClassOf: {x, y", "bad.owl:3: ", "'}' is expected"},
        {manchester + "Class: Seat SubClassOf: Leg and or Leg", "bad.owl:3: ", "is expected where 'or' stands"},
        {manchester + "Class: Seat SubClassOf: d some Leg",
         "bad.owl:3: ", "Leg is a class, but stands where a datatype is expected"},
        {manchester + "Class: Seat SubClassOf: d some xsd:double[> 3", "bad.owl:3: ", "']' is expected"},
        {manchester + "Class: Seat SubClassOf: d some xsd:double[about 3]", "bad.owl:3: ", "a facet such as '>='"},
        {manchester + "Class: Seat SubClassOf: d some xsd:double[> \"tall\"]", "bad.owl:3: ", "wants a number"},
        {manchester + "Class: Seat SubClassOf: d value 12x", "bad.owl:3: ", "'12x' is no number"},
        {manchester + "Class: Seat SubClassOf: inverse d some Leg",
         "bad.owl:3: ", "d is a data property, but stands where an object property is expected"},
        {manchester + "Class: Seat SubClassOf: q some Leg", "bad.owl:3: ", "q is used as an object property"},
        {manchester + "ObjectProperty: p Characteristics: Function", "bad.owl:3: ", "is no characteristic"},
        {manchester + "DataProperty: d Characteristics: Transitive", "bad.owl:3: ", "which can be Functional"},
        {manchester + "ObjectProperty: p SubPropertyOf: d", "bad.owl:3: ", "d is a data property"},
        {manchester + "ObjectProperty: p SubPropertyChain: p", "bad.owl:3: ", "at least two object properties"},
        {manchester + "Individual: x Facts: e 3", "bad.owl:3: ", "e is used as a data property but not declared"},
        {manchester + "Individual: x Facts: p 3", "bad.owl:3: ", "p is an object property"},
        {manchester + "Individual: x Facts: inverse p x", "bad.owl:3: ", "not an inverse"},
        {manchester + "DisjointClasses: Seat", "bad.owl:3: ", "at least two members"},
        {manchester + "Rule: Seat(?x)", "bad.owl:3: ", "'->' is expected"},
        {manchester + "Rule: Seat(?x, ?y) -> Leg(?x)", "bad.owl:3: ", "stands where an object property is expected"},
        {manchester + "Rule: Seat(?) -> Leg(?x)", "bad.owl:3: ", "begins a variable"},
        {manchester + "Rule: Seat(3) -> Leg(?x)", "bad.owl:3: ", "wants a thing"},
        {manchester + "Class: e:Seat", "bad.owl:3: ", "the prefix 'e:' of 'e:Seat' is not declared"},
        {"Prefix: core: <https://w3id.org/partonomy/core#>\nOntology: <http://e>\nClass: cor:Seat",
         "bad.owl:3: ", "the prefix 'cor:' of 'cor:Seat' is not declared; did you mean \"core:\"?"},
        {"Prefix: core: <https://w3id.org/partonomy/core#>\nOntology: <http://e>\nClass: hasShape",
         "bad.owl:3: ", "the prefix ':' of 'hasShape' is not declared; did you mean \"core:hasShape\"?"},
        {"Ontology: <http://e>\nClass: core:Region", "bad.owl:2: ", "https://w3id.org/partonomy/core# is what core:"},
        {manchester + "Class: Seat Annotations: rdfs:label \"open", "bad.owl:3: ", "never closed"},
        {manchester + "Class: Seat Annotations: rdfs:label", "bad.owl:3: ", "an individual is expected where the end"},
        {manchester + "Seat SubClassOf: Leg", "bad.owl:3: ", "where 'Seat' stands"},
        {"Ontology: <http://e>\nClass: Seat", "bad.owl:2: ", "the prefix ':' of 'Seat' is not declared"},
        {"Prefix: e <http://e/>", "bad.owl:1: ", "a prefix is declared as"},
        {"Prefix: e: http://e/", "bad.owl:1: ", "wants an IRI in < >"},
        {"Ontology: <http://e>\nImport: <http://e/other>", "bad.owl:2: ", "cannot be found"},
    });
}

const std::string owl_xml =
    "<Ontology xmlns=\"http://www.w3.org/2002/07/owl#\" xml:base=\"http://e/\" ontologyIRI=\"http://e\">\n"
    "<Declaration><Class IRI=\"Seat\"/></Declaration><Declaration><ObjectProperty IRI=\"p\"/></Declaration>"
    "<Declaration><DataProperty IRI=\"d\"/></Declaration>\n";

TEST(BadOwlXml, Sentences) {
    const std::string end = "</Ontology>";
    const std::string seat = "<Class IRI=\"Seat\"/>";
    std::string bomb = "<!DOCTYPE Ontology [\n<!ENTITY a0 \"lollollollollollollollollollollollollol\">\n";
    for (int i = 1; i < 12; ++i) {
        bomb += "<!ENTITY a" + std::to_string(i) + " \"";
        for (int k = 0; k < 10; ++k) bomb += "&a" + std::to_string(i - 1) + ";";
        bomb += "\">\n";
    }
    expect_refused({
        {owl_xml, "bad.owl:3: ", "the tag of line 1 is closed; is the file cut off?"},
        {owl_xml + "<SubClassOf>\n</SubClassof>" + end, "bad.owl:4: ", "closed by another name"},
        {owl_xml + "<SubClasOf>" + seat + seat + "</SubClasOf>" + end, "bad.owl:3: ", "an axiom such as SubClassOf"},
        {owl_xml + "<SubClassOf>" + seat + "</SubClassOf>" + end,
         "bad.owl:3: ", "SubClassOf wants 2 parts, here are 1"},
        {owl_xml + "<SubClassOf>" + seat + "\n<Class IRI=\"Seatt\"/></SubClassOf>" + end,
         "bad.owl:4: ", "(did you mean Seat?)"},
        {owl_xml + "<SubClassOf>" + seat + "<ObjectProperty IRI=\"p\"/></SubClassOf>" + end,
         "bad.owl:3: ", "a class is expected where ObjectProperty p stands"},
        {owl_xml + "<SubClassOf>" + seat + "<Class/></SubClassOf>" + end,
         "bad.owl:3: ", "Class wants the attribute IRI"},
        {owl_xml + "<SubClassOf>" + seat + "words</SubClassOf>" + end, "bad.owl:3: ", "text stands where an element"},
        {owl_xml + "<SubClassOf>" + seat +
             "<ObjectMinCardinality><ObjectProperty IRI=\"p\"/></ObjectMinCardinality>"
             "</SubClassOf>" +
             end,
         "bad.owl:3: ", "wants the attribute cardinality"},
        {owl_xml + "<SubClassOf>" + seat +
             "<ObjectMinCardinality cardinality=\"x\"><ObjectProperty IRI=\"p\"/>"
             "</ObjectMinCardinality></SubClassOf>" +
             end,
         "bad.owl:3: ", "wants a whole number"},
        {owl_xml + "<ClassAssertion>" + seat + "<AnonymousIndividual/></ClassAssertion>" + end,
         "bad.owl:3: ", "nodeID"},
        {owl_xml + "<Declaration><Class abbreviatedIRI=\"e:x\"/></Declaration>" + end,
         "bad.owl:3: ", "the prefix of 'e:x' is not declared"},
        {owl_xml + "<SubClassOf><Class IRI=\"Seat\"><Class IRI=\"Seat\"/></Class>" + seat + "</SubClassOf>" + end,
         "bad.owl:3: ", "Class holds no other element"},
        {owl_xml + "<x xmlns=\"http://other/\"/>" + end, "bad.owl:3: ", "is none of OWL/XML"},
        {owl_xml + "<Ontology/>" + end, "bad.owl:3: ", "inside another"},
        {owl_xml + "<Prefix name=\"e\"/>" + end, "bad.owl:3: ", "Prefix wants the attributes"},
        {owl_xml +
             "<Annotation><AnnotationProperty IRI=\"n\"/><Literal datatypeIRI=\"http://e/a "
             "b\">x</Literal></Annotation>" +
             end,
         "bad.owl:3: ", "an IRI cannot hold a space"},
        {owl_xml + "<Annotation><AnnotationProperty IRI=\"n\"/><Literal xml:lang=\"a b\">x</Literal></Annotation>" +
             end,
         "bad.owl: ", "'a b' is no language"},
        {owl_xml + "<Import>http://e/other</Import>" + end, "bad.owl:3: ", "cannot be found"},
        {owl_xml + "<Declaration><Class IRI=\"a b\"/></Declaration>" + end,
         "bad.owl:3: ", "an IRI cannot hold a space"},
        {"<!DOCTYPE Ontology [\n<!ENTITY e SYSTEM \"file:///etc/passwd\">]>" + owl_xml + end,
         "bad.owl:2: ", "lives in another file"},
        {"<!DOCTYPE Ontology SYSTEM \"http://e/owl.dtd\">\n" + owl_xml + end,
         "bad.owl:1: ", "the document type lives in another file"},
        {bomb + "]>\n" + owl_xml + "<Annotation><AnnotationProperty IRI=\"n\"/><Literal>&a11;</Literal></Annotation>" +
             end,
         "bad.owl:", "blow up"},
    });
}

TEST(BadSyntax, WhatIsTooDeepIsRefusedNotCrashed) {
    constexpr int depth = 200'000;
    std::string calls = functional + "SubClassOf(:Seat ";
    std::string groups = calls;
    std::string annotations = functional + "SubClassOf(";
    std::string words = manchester + "Class: Seat SubClassOf: ";
    std::string brackets = words;
    std::string chain = words;
    std::string notes = manchester + "Class: Seat ";
    std::string elements = owl_xml + "<SubClassOf>";
    for (int i = 0; i < depth; ++i) {
        calls += "ObjectComplementOf(";
        groups += "(";
        annotations += "Annotation(";
        words += "not ";
        brackets += "(";
        chain += "p some ";
        notes += "Annotations: ";
        elements += "<ObjectComplementOf>";
    }
    expect_refused({
        {calls, "bad.owl:3: ", "nested more than 500 deep"},
        {groups, "bad.owl:3: ", "nested more than 500 deep"},
        {annotations, "bad.owl:3: ", "nested more than 500 deep"},
        {words, "bad.owl:3: ", "nested more than 500 deep"},
        {brackets, "bad.owl:3: ", "nested more than 500 deep"},
        {chain, "bad.owl:3: ", "nested more than 500 deep"},
        {notes, "bad.owl:3: ", "nested more than 100 deep"},
        {elements, "bad.owl:3: ", "nested more than 500 deep"},
    });
}

/// A small file cut off after every byte is refused, or says less; never a crash.
TEST(BadSyntax, CutOffAnywhere) {
    for (const char* path :
         {"functional/tiny.ofn", "functional/annotated.ofn", "functional/rule.ofn", "manchester/tiny.omn",
          "manchester/data.omn", "manchester/rule.omn", "manchester/annotated.omn", "owl_xml/tiny.owx",
          "owl_xml/entities.owx", "owl_xml/data.owx"}) {
        const std::string text = read_file(std::string(PARTONOMY_SOURCE_DIR "/fuzz/corpus/") + path);
        EXPECT_EQ(sentence(text), "(no error)") << path;
        for (std::size_t size = 0; size < text.size(); ++size) {
            const std::string said = sentence(text.substr(0, size));
            EXPECT_TRUE(said == "(no error)" || said.starts_with("bad.owl:")) << path << " " << size << ": " << said;
        }
    }
    for (const std::string syntax : {"ofn", "omn", "owx"}) {
        const std::string text = zoo::text(syntax);
        for (std::size_t size = 0; size + 12 < text.size(); size += 101) {
            const std::string said = sentence(text.substr(0, size));
            EXPECT_TRUE(said.starts_with("bad.owl:") || (said == "(no error)" && syntax == "omn"))
                << size << ": " << said;
        }
    }
}

/// What the fuzzers of single readers start from and what they once found.
TEST(BadSyntax, FuzzCorpusReplays) {
    std::size_t count = 0;
    for (const char* target : {"functional", "manchester", "owl_xml", "turtle", "n_triples", "rdf_xml"}) {
        const std::string folder = std::string(PARTONOMY_SOURCE_DIR "/fuzz/corpus/") + target;
        for (const auto& file : std::filesystem::directory_iterator(folder)) {
            SCOPED_TRACE(file.path().filename().string());
            ++count;
            const std::string said = sentence(read_file(file.path()));
            EXPECT_TRUE(said == "(no error)" || said.starts_with("bad.owl:")) << said;
        }
    }
    EXPECT_GE(count, 28U);
}

}  // namespace
}  // namespace partonomy::owl
