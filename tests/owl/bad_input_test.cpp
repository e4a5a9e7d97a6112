// What a user can do wrong: one clear sentence each, that names file and line.

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/errors.h"
#include "base/files.h"
#include "owl/ontology.h"
#include "owl/rdf_graph.h"
#include "owl/refused.h"
#include "owl/zoo.h"

namespace partonomy::owl {
namespace {

/// Line 1 declares the prefixes, line 2 the entities; what a test adds begins on line 3.
const std::string head =
    "@prefix : <http://e/> . @prefix owl: <http://www.w3.org/2002/07/owl#> . @prefix rdf: "
    "<http://www.w3.org/1999/02/22-rdf-syntax-ns#> . @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> . @prefix "
    "xsd: "
    "<http://www.w3.org/2001/XMLSchema#> .\n"
    ":Seat a owl:Class . :Leg a owl:Class . :p a owl:ObjectProperty . :d a owl:DatatypeProperty . :x a "
    "owl:NamedIndividual .\n";

const std::string xml_head =
    "<rdf:RDF xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\" xmlns:owl=\"http://www.w3.org/2002/07/owl#\" "
    "xmlns:rdfs=\"http://www.w3.org/2000/01/rdf-schema#\">\n";

std::string sentence(const std::string& text) { return owl::sentence(text, "bad.ttl"); }
void expect_refused(const std::vector<Bad>& cases) { owl::expect_refused(cases, "bad.ttl"); }

TEST(BadInput, TurtleSyntax) {
    expect_refused({
        {head + ":Seat rdfs:subClassOf :Leg\n:Leg rdfs:subClassOf :Seat .", "bad.ttl:4: ", "should end with '.'"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction .\n",
         "bad.ttl:3: ", "the '[' of line 3 should be closed by ']'"},
        {head + ":Seat owl:disjointUnionOf ( :Leg\n.\n", "bad.ttl:4: ", "the '(' of line 3 should be closed by ')'"},
        {head + ":Seat foo:bar :Leg .", "bad.ttl:3: ", "the prefix of 'foo:bar' is not declared"},
        {head + ":Seat rdf2:label :Leg .", "bad.ttl:3: ", "the prefix of 'rdf2:label' is not declared; did you mean"},
        {"\n:Seat a owl:Class .", "bad.ttl:2: ", "the prefix of ':Seat' is not declared"},
        {head + ":Seat rdfs:label \"open .\n", "bad.ttl:3: ", "the string is not closed on its line"},
        {head + ":Seat rdfs:label \"\"\"open .\n\n", "bad.ttl:3: ", "never closed"},
        {head + ":Seat rdfs:label \"a\\qb\" .\n", "bad.ttl:3: ", "a backslash in a string"},
        {head + ":Seat rdfs:label \"\\uD800\" .\n", "bad.ttl:3: ", "names no character"},
        {head + ":Seat rdfs:seeAlso <http://e/a b> .\n", "bad.ttl:3: ", "an IRI cannot hold a space"},
        {head + ":Seat rdfs:seeAlso <http://e/a\n", "bad.ttl:3: ", "is not closed"},
        {head + "Seat a owl:Class .", "bad.ttl:3: ", "'Seat' begins no statement of Turtle"},
        {head + ":Seat rdfs:subClassOf .", "bad.ttl:3: ", "a value should stand where '.' stands"},
        {head + ":Seat \"x\" :Leg .", "bad.ttl:3: ", "a property should stand where '\"x\"' stands"},
        {head + "\"x\" a :Leg .", "bad.ttl:3: ", "not with the literal"},
        {head + ":Seat { :p :Leg } .", "bad.ttl:3: ", "'{' cannot stand here"},
        {head + "<< :a :b :c >> :p :d .", "bad.ttl:3: ", "RDF-star"},
        {"@prefix : http://e/ .", "bad.ttl:1: ", "wants an IRI in < >"},
        {"@prefix e <http://e/> .", "bad.ttl:1: ", "a prefix is declared as"},
        {"@prefix e: <http://e/>\n:A :b :c .",
         "bad.ttl:2: ", "the declaration of the prefix 'e:' before it should end"},
    });
}

TEST(BadInput, Formats) {
    expect_refused({
        {"", "bad.ttl: ", "holds no statement"},
        {" \n\t# only a comment\n", "bad.ttl: ", "holds no statement"},
        {"@prefix : <http://e/> .", "bad.ttl: ", "holds no statement"},
        {"<http://e/a> <http://e/b> <http://e/c> .", "bad.ttl: ", "holds statements but no ontology"},
        {std::string("\n@pre\0fix", 9), "bad.ttl:2: ", "it is no text"},
        {"\n\n:caf\xe9 a :b .", "bad.ttl:3: ", "not UTF-8"},
        {"{ \"@context\": {} }", "bad.ttl:1: ", "JSON is not read"},
        {"<!DOCTYPE html>\n<html><p>not found</p></html>", "bad.ttl:2: ", "the root element 'html' is neither RDF/XML"},
        {"OFF\n8 6 0\n", "bad.ttl:1: ", "is no ontology; one in Turtle"},
    });
}

TEST(BadInput, RdfXmlSyntax) {
    expect_refused({
        {xml_head + "<owl:Class rdf:about=\"http://e/A\">\n</owl:Clas></rdf:RDF>",
         "bad.ttl:3: ", "closed by another name"},
        {xml_head + "<owl:Class rdf:about=\"http://e/A\">\n\n",
         "bad.ttl:4: ", "the tag of line 2 is closed; is the file cut off?"},
        {xml_head + "<owl:Class rdf:about=\"http://e/A\n", "bad.ttl:2: ", "is the file cut off?"},
        {xml_head + "<foo:Class/></rdf:RDF>", "bad.ttl:2: ", "no xmlns declaration"},
        {xml_head + "<owl:Class about=\"http://e/A\"/></rdf:RDF>", "bad.ttl:2: ", "rdf:about may be meant"},
        {xml_head + "<owl:Class rdf:about=\"&e;A\"/></rdf:RDF>", "bad.ttl:2: ", "used but not declared"},
        {xml_head + "<owl:Class rdf:about=\"http://e/A\">words</owl:Class></rdf:RDF>",
         "bad.ttl:2: ", "text stands where"},
        {xml_head + "<owl:Class rdf:about=\"http://e/A\"><owl:Class rdf:about=\"http://e/B\"/></owl:Class></rdf:RDF>",
         "bad.ttl:2: ", "stands where a property is expected"},
        {xml_head + "<owl:Class rdf:about=\"http://e/A\"><rdfs:subClassOf><owl:Class/>\n<owl:Class/></rdfs:subClassOf>"
                    "</owl:Class></rdf:RDF>",
         "bad.ttl:3: ", "holds one value"},
        {xml_head + "</rdf:RDF>\ntrailing", "bad.ttl:3: ", "XML"},
        {xml_head + "</rdf:RDF>", "bad.ttl: ", "holds no statement"},
    });
}

TEST(BadInput, NothingElsewhereIsEverRead) {
    const std::string body = xml_head + "<owl:Class rdf:about=\"&e;\"/></rdf:RDF>";
    std::string bomb = "<!DOCTYPE x [\n<!ENTITY a0 \"lollollollollollollollollollollollollol\">\n";
    for (int i = 1; i < 12; ++i) {
        bomb += "<!ENTITY a" + std::to_string(i) + " \"";
        for (int k = 0; k < 10; ++k) bomb += "&a" + std::to_string(i - 1) + ";";
        bomb += "\">\n";
    }
    bomb +=
        "]>\n" + xml_head + "<owl:Class rdf:about=\"http://e\"><rdfs:label>&a11;</rdfs:label></owl:Class></rdf:RDF>";
    expect_refused({
        {"<!DOCTYPE rdf:RDF [\n<!ENTITY e SYSTEM \"file:///etc/passwd\">]>" + body,
         "bad.ttl:2: ", "lives in another file"},
        {"<!DOCTYPE rdf:RDF [\n<!ENTITY % e SYSTEM \"http://e/x.dtd\"> %e; ]>" + body,
         "bad.ttl:2: ", "lives in another file"},
        {"<!DOCTYPE rdf:RDF SYSTEM \"http://e/owl.dtd\">\n" + body,
         "bad.ttl:1: ", "the document type lives in another file"},
        {bomb, "bad.ttl:", "blow up"},
    });
}

TEST(BadInput, NoOwl2) {
    expect_refused({
        {head + ":Seat rdfs:subClassOf\n :Legg .", "bad.ttl:3: ", "Legg is used as a class but not declared"},
        {head + ":Seat rdfs:subClassOf :Legg .", "bad.ttl:3: ", "(did you mean Leg?)"},
        {head + "@prefix core: <https://w3id.org/partonomy/core#> . core:Region a owl:Class . core:Below a owl:Class ; "
                "core:alsoCalled \"Under\" .\n:Seat rdfs:subClassOf core:Under .",
         "bad.ttl:4: ", "(did you mean core:Below?)"},
        {head + "@prefix core: <https://w3id.org/partonomy/core#> . core:Region a owl:Class . core:LongerThan a "
                "owl:Class ; core:converse \"ShorterThan\" .\n:Seat rdfs:subClassOf core:ShorterThan .",
         "bad.ttl:4: ", "(did you mean core:LongerThan, with isTargetRegion and isReferenceRegion exchanged?)"},
        {head + ":Seat rdfs:subClassOf :p .",
         "bad.ttl:3: ", "p is an object property, but stands where a class is expected"},
        {head + ":Seat rdfs:subClassOf \"Leg\" .", "bad.ttl:3: ", "the literal \"Leg\" stands where"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ;\n owl:someValuesFrom :Leg ] .",
         "bad.ttl:4: ", "no owl:onProperty"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ;\n owl:onProperty :p ] .", "bad.ttl:4: ", "says nothing"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ;\n owl:onProperty :q ; owl:someValuesFrom :Leg ] .",
         "bad.ttl:4: ", "q is used as an object property but not declared"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ;\n owl:minCardinality "
                "\"1.5\"^^xsd:decimal ] .",
         "bad.ttl:4: ", "wants a whole number"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:cardinality -1 ] .",
         "bad.ttl:3: ", "wants a whole number"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:cardinality 99999999999 ] .",
         "bad.ttl:3: ", "wants a whole number"},
        {head +
             ":Seat rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:cardinality 1 ; owl:onClass :Leg ] .",
         "bad.ttl:3: ", "goes with a qualified cardinality only"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:qualifiedCardinality 1 ] .",
         "bad.ttl:3: ", "needs owl:onClass"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :d ; owl:qualifiedCardinality 1 ; "
                "owl:onClass :Leg ] .",
         "bad.ttl:3: ", "owl:onDataRange"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :d ; owl:someValuesFrom :Leg ] .",
         "bad.ttl:3: ", "Leg is a class, but stands where a datatype is expected"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:hasValue 3 ] .",
         "bad.ttl:3: ", "is an individual"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:hasSelf false ] .",
         "bad.ttl:3: ", "has the value true"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :p ; owl:someValuesFrom :Leg ; "
                "owl:allValuesFrom :Leg ] .",
         "bad.ttl:3: ", "write two restrictions"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ; owl:onProperties ( :p ) ; owl:someValuesFrom :Leg ] .",
         "bad.ttl:3: ", "wants a data range of several values"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :d ; owl:someValuesFrom [ owl:onDatatype "
                "xsd:double ; "
                "owl:withRestrictions ( [ xsd:minInclusive \"tall\" ] ) ] ] .",
         "bad.ttl:3: ", "wants a number"},
        {head + ":Seat rdfs:subClassOf [ a owl:Restriction ; owl:onProperty :d ; owl:someValuesFrom [ owl:onDatatype "
                "xsd:double ; "
                "owl:withRestrictions ( [ xsd:least 1 ] ) ] ] .",
         "bad.ttl:3: ", "xsd:least is no facet"},
        {head + ":Seat owl:equivalentClass [ owl:intersectionOf () ] .", "bad.ttl:3: ", "empty list"},
        {head + ":Seat owl:equivalentClass [ owl:intersectionOf :Leg ] .",
         "bad.ttl:3: ", "a list of RDF is expected where Leg"},
        {head + ":Seat owl:equivalentClass [ owl:unionOf ( :Leg ) ; owl:complementOf :Leg ] .",
         "bad.ttl:3: ", "one is right"},
        {head + ":Seat owl:equivalentClass [] .", "bad.ttl:3: ", "says nothing"},
        {head + ":Seat owl:disjointUnionOf _:l .\n_:l rdf:first :Leg .", "bad.ttl:3: ", "a list is broken"},
        {head + ":Seat owl:disjointUnionOf _:l . _:l rdf:first :Leg ; rdf:rest _:l .",
         "bad.ttl:3: ", "a list contains itself"},
        {head + ":Seat owl:disjointUnionOf _:l . _:l rdf:first :Leg , :Seat ; rdf:rest () .",
         "bad.ttl:3: ", "two values of rdf:first"},
        {head + ":Seat rdfs:subClassOf _:a . _:a owl:complementOf _:b .\n_:b owl:complementOf _:a .",
         "bad.ttl:4: ", "contains itself"},
        {head + ":Seat owl:hasKey ( ) .", "bad.ttl:3: ", "owl:hasKey has an empty list"},
        {head + ":Seat owl:hasKey ( :q ) .", "bad.ttl:3: ", "q is used as an object property but not declared"},
        {head + ":Seat owl:equivalentClas :Leg .", "bad.ttl:3: ", "owl:equivalentClas is no property of OWL 2"},
        {head + ":x a owl:Chair .", "bad.ttl:3: ", "owl:Chair is no word of OWL 2"},
        {head + ":x a :Chair .", "bad.ttl:3: ", "Chair is used as a class but not declared"},
        {head + ":x :p 3 .", "bad.ttl:3: ", "p is an object property; its value is an individual"},
        {head + ":x :d :Leg .", "bad.ttl:3: ", "d is a data property; its value is a literal"},
        {head + ":p a owl:DatatypeProperty .", "bad.ttl:3: ", "both an object property and a data property"},
        {head + ":d a owl:TransitiveProperty .", "bad.ttl:3: ", "both an object property and a data property"},
        {head + ":q a owl:FunctionalProperty .", "bad.ttl:3: ", "q is used as"},
        {head + ":p owl:propertyChainAxiom ( :p ) .", "bad.ttl:3: ", "at least two"},
        {head + "[] a owl:AllDisjointClasses .", "bad.ttl:3: ", "needs owl:members beside it"},
        {head + "[] a owl:AllDifferent ; owl:members ( :x ) .", "bad.ttl:3: ", "at least two members"},
        {head + "[] a owl:NegativePropertyAssertion ; owl:sourceIndividual :x ; owl:assertionProperty :p ; "
                "owl:targetValue 1 .",
         "bad.ttl:3: ", "p is an object property, but stands where a data property is expected"},
        {head + "[] a owl:NegativePropertyAssertion ; owl:sourceIndividual :x ; owl:assertionProperty :d .",
         "bad.ttl:3: ", "owl:targetIndividual or owl:targetValue"},
        {head + "[] a owl:Axiom ; owl:annotatedSource :Seat ; owl:annotatedProperty rdfs:subClassOf ; "
                "owl:annotatedTarget :Leg .",
         "bad.ttl:3: ", "the axiom that is annotated here is not in the file"},
        {head + "[ a owl:Restriction ; owl:onProperty :p ; owl:someValuesFrom :Leg ] .",
         "bad.ttl:3: ", "belongs to no axiom"},
        {head + ":Seat owl:someValuesFrom :Leg .", "bad.ttl:3: ", "has no meaning for Seat"},
        {head + ":Seat owl:imports <https://w3id.org/partonomy/core> .", "bad.ttl:3: ", "belongs to an ontology"},
        {head + ":s a rdfs:Datatype ; owl:equivalentClass :Leg .",
         "bad.ttl:3: ", "Leg is a class, but stands where a datatype is expected"},
        {head + ":d rdfs:range _:r . _:r owl:datatypeComplementOf _:r .",
         "bad.ttl:3: ", "a data range contains itself"},
        {head + ":d rdfs:range [ owl:unionOf () ] .", "bad.ttl:3: ", "owl:unionOf has an empty list"},
        {head + ":d rdfs:range [ owl:complementOf xsd:double ] .", "bad.ttl:3: ", "has no place in a data range"},
        {head + ":r a rdf:Property .", "bad.ttl:3: ", "rdf:Property says too little of r"},
        {head + ":Seat rdfs:label \"" + std::string(10, 'x') + "\" ; rdfs:seeAlso <http://e/" + std::string(5000, 'x') +
             "> .",
         "bad.ttl:3: ", "is too long"},
    });
}

TEST(BadInput, WhatIsTooDeepIsRefusedNotCrashed) {
    constexpr int depth = 200'000;
    std::string brackets = head + ":Seat rdfs:subClassOf ";
    std::string lists = brackets;
    std::string elements = xml_head;
    std::string labels = head + ":Seat rdfs:subClassOf _:0 .\n";
    for (int i = 0; i < depth; ++i) {
        brackets += "[ owl:complementOf ";
        lists += "( ";
        elements += "<owl:Class><owl:complementOf>";
        labels += "_:" + std::to_string(i) + " owl:complementOf _:" + std::to_string(i + 1) + " .\n";
    }
    std::string closed = elements;
    for (int i = 0; i < depth; ++i) closed += "</owl:complementOf></owl:Class>";
    expect_refused({
        {brackets, "bad.ttl:3: ", "nested more than 500 deep"},
        {lists, "bad.ttl:3: ", "nested more than 500 deep"},
        {elements, "bad.ttl:2: ", "is the file cut off?"},
        {closed + "</rdf:RDF>", "bad.ttl:2: ", "belongs to no axiom"},
        {labels, "bad.ttl:5", "nested more than 500 deep"},
    });
}

TEST(BadInput, WhatIsTooLargeIsRefusedUnread) {
    const std::string said = sentence(head + "# " + std::string(max_document, 'x'));
    EXPECT_EQ(said, "bad.ttl: holds 32 MB; at most 32 MB are read, so split it into ontologies that import each other");
}

TEST(BadInput, SharedExpressionsDoNotBlowUp) {
    std::string text = head + ":Seat rdfs:subClassOf _:0 .\n";
    for (int i = 0; i < 60; ++i) {
        const std::string next = "_:" + std::to_string(i + 1);
        text += "_:" + std::to_string(i) + " owl:unionOf ( " + next + " " + next + " ) .\n";
    }
    expect_refused({{text + "_:60 owl:complementOf :Leg .", "bad.ttl:", "when written out"}});
}

TEST(BadInput, LongThingsAreFine) {
    std::string text = head + ":Seat rdfs:comment \"" + std::string(20'000'000, 'x') + "\" .\n:x :p :x";
    for (int i = 0; i < 50'000; ++i) text += " , :y" + std::to_string(i);
    text += " .\n:Seat owl:equivalentClass [ owl:oneOf ( ";
    for (int i = 0; i < 50'000; ++i) text += ":y" + std::to_string(i) + " ";
    const Ontology ontology = parse_ontology(text + ") ] .", "long.ttl");
    EXPECT_EQ(ontology.annotations.at("http://e/Seat").front().literal.value.size(), 20'000'000U);
    EXPECT_EQ(ontology.axioms.size(), 50'002U);
}

/// A file cut off anywhere is refused, or says less; never a crash.
TEST(BadInput, CutOff) {
    const std::string turtle = zoo::text("ttl");
    const std::string xml = zoo::text("rdf");
    for (std::size_t size = 0; size < turtle.size(); size += 7) {
        const std::string said = sentence(turtle.substr(0, size));
        EXPECT_TRUE(said == "(no error)" || said.starts_with("bad.ttl:")) << said;
    }
    for (std::size_t size = 0; size < xml.size() - 12; size += 11) {
        EXPECT_TRUE(sentence(xml.substr(0, size)).starts_with("bad.ttl:")) << size;
    }
}

TEST(BadInput, Files) {
    EXPECT_THROW((void)load_ontology("/nowhere/at/all.ttl"), FileError);
    EXPECT_THROW((void)load_ontology(std::filesystem::temp_directory_path()), FileError);
}

/// What the fuzzer starts from and what it once found.
TEST(BadInput, FuzzCorpusReplays) {
    std::size_t count = 0;
    for (const auto& file : std::filesystem::directory_iterator(PARTONOMY_SOURCE_DIR "/fuzz/corpus/ontology")) {
        SCOPED_TRACE(file.path().filename().string());
        ++count;
        try {
            for (const Axiom& axiom : parse_ontology(read_file(file.path()), "fuzz").axioms) {
                EXPECT_FALSE(to_manchester(axiom).empty());
            }
        } catch (const OntologyError& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with("fuzz:")) << error.what();
        }
    }
    EXPECT_GE(count, 25U);
}

}  // namespace
}  // namespace partonomy::owl
