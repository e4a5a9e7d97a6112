// Six syntaxes: every kind of axiom, the lines, the terms; and raptor2's second opinion on the triples.

#include <gtest/gtest.h>
#include <raptor2.h>

#include <algorithm>
#include <fstream>
#include <set>

#include "base/files.h"
#include "owl/canonical.h"
#include "owl/ontology.h"
#include "owl/rdf_graph.h"
#include "owl/zoo.h"

namespace partonomy::owl {
namespace {

std::vector<std::string> wordings(const Ontology& ontology, bool with_lines) {
    std::vector<std::string> lines;
    for (const Axiom& axiom : ontology.axioms) {
        lines.push_back((with_lines ? std::to_string(axiom.source.line) + " " : "") + to_manchester(axiom));
    }
    return lines;
}

/// Turtle as N-Triples, by raptor2.
std::string as_ntriples(const std::string& turtle) {
    raptor_world* world = raptor_new_world();
    raptor_parser* parser = raptor_new_parser(world, "turtle");
    void* bytes = nullptr;
    std::size_t size = 0;
    raptor_iostream* out = raptor_new_iostream_to_string(world, &bytes, &size, nullptr);
    raptor_serializer* serializer = raptor_new_serializer(world, "ntriples");
    raptor_serializer_start_to_iostream(serializer, nullptr, out);
    raptor_parser_set_statement_handler(parser, serializer, [](void* to, raptor_statement* triple) {
        raptor_serializer_serialize_statement(static_cast<raptor_serializer*>(to), triple);
    });
    raptor_uri* base = raptor_new_uri(world, reinterpret_cast<const unsigned char*>("file:///same"));
    raptor_parser_parse_start(parser, base);
    EXPECT_EQ(
        raptor_parser_parse_chunk(parser, reinterpret_cast<const unsigned char*>(turtle.data()), turtle.size(), 1), 0);
    raptor_serializer_serialize_end(serializer);
    raptor_free_iostream(out);
    std::string text(static_cast<char*>(bytes), size);
    raptor_free_memory(bytes);
    raptor_free_uri(base);
    raptor_free_serializer(serializer);
    raptor_free_parser(parser);
    raptor_free_world(world);
    return text;
}

TEST(Syntax, TurtleGivesEveryKindOfAxiomOnItsLine) {
    const Ontology ontology = parse_ontology(zoo::text("ttl"), "zoo.ttl");
    EXPECT_EQ(wordings(ontology, true), std::vector<std::string>(std::begin(zoo::axioms), std::end(zoo::axioms)));
    std::set<AxiomKind> kinds;
    std::set<ClassKind> class_kinds;
    for (const Axiom& axiom : ontology.axioms) {
        EXPECT_EQ(axiom.source.file, "zoo.ttl");
        kinds.insert(axiom.kind);
        for (const ClassPointer& expression : axiom.classes) {
            class_kinds.insert(expression->kind);
            for (const ClassPointer& operand : expression->operands) class_kinds.insert(operand->kind);
        }
    }
    EXPECT_EQ(kinds.size(), static_cast<std::size_t>(AxiomKind::rule) + 1);
    EXPECT_EQ(class_kinds.size(), static_cast<std::size_t>(ClassKind::data_exact_cardinality) + 1);
}

TEST(Syntax, AllSaySameAxiomsAnnotationsAndEntities) {
    const std::set<std::string> turtle = everything_in(parse_ontology(zoo::text("ttl"), "zoo.ttl"));
    EXPECT_GT(turtle.size(), 90U);
    for (const std::string syntax : {"rdf", "owx", "ofn", "omn"}) {
        EXPECT_EQ(differences(turtle, everything_in(parse_ontology(zoo::text(syntax), "zoo.owl"))), "") << syntax;
    }
    EXPECT_EQ(differences(turtle, everything_in(parse_ontology(as_ntriples(zoo::text("ttl")), "zoo.nt"))), "");
}

/// The line of each axiom holds a word that the axiom is recognised by.
TEST(Syntax, LinesOfAllSyntaxes) {
    for (const std::string syntax : {"owx", "ofn", "omn"}) {
        const std::string text = zoo::text(syntax);
        std::vector<std::string> lines;
        for (std::size_t from = 0; from < text.size(); from = text.find('\n', from) + 1)
            lines.push_back(text.substr(from, text.find('\n', from) - from));
        for (const Axiom& axiom : parse_ontology(text, "zoo." + syntax).axioms) {
            ASSERT_GT(axiom.source.line, 0);
            const std::string& line = lines.at(static_cast<std::size_t>(axiom.source.line) - 1);
            const std::string call = functional_text(axiom).substr(0, functional_text(axiom).find('('));
            if (syntax == "omn") {
                const std::string first =
                    axiom.kind == AxiomKind::sub_class_of && axiom.classes[1]->kind == ClassKind::has_self ? "Self"
                    : axiom.kind == AxiomKind::data_property_assertion ? axiom.literal.value
                                                                       : "";
                EXPECT_NE(line.find(first), std::string::npos) << to_manchester(axiom) << " at " << axiom.source.line;
                EXPECT_NE(line.find_first_not_of(' '), std::string::npos) << to_manchester(axiom);
            } else {
                EXPECT_NE(line.find(call), std::string::npos) << to_manchester(axiom) << " at " << axiom.source.line;
            }
        }
    }
}

TEST(Syntax, EveryLineOfRdfXmlIsThatOfTheProperty) {
    const std::string text = zoo::text("rdf");
    std::vector<std::string> lines;
    for (std::size_t from = 0; from < text.size(); from = text.find('\n', from) + 1) {
        lines.push_back(text.substr(from, text.find('\n', from) - from));
    }
    for (const Axiom& axiom : parse_ontology(text, "zoo.owl").axioms) {
        const std::string& line = lines.at(static_cast<std::size_t>(axiom.source.line) - 1);
        const std::string said = to_manchester(axiom);
        const char* wanted = axiom.kind == AxiomKind::sub_class_of                ? "<rdfs:subClassOf"
                             : axiom.kind == AxiomKind::disjoint_union            ? "<owl:disjointUnionOf"
                             : axiom.kind == AxiomKind::object_property_assertion ? "<p"
                             : axiom.kind == AxiomKind::class_assertion           ? "<rdf:type"
                             : axiom.kind == AxiomKind::data_property_range       ? "<rdfs:range"
                                                                                  : "<";
        EXPECT_NE(line.find(wanted), std::string::npos) << said << " at line " << axiom.source.line;
    }
}

/// As Protégé's Turtle writer lays a class out: predicate and first value on one line, nested values below.
TEST(Syntax, LinesOfTurtleAsProtegeWritesIt) {
    const Ontology ontology = parse_ontology(R"(@prefix : <https://example.org/f#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
@prefix rdf: <http://www.w3.org/1999/02/22-rdf-syntax-ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@base <https://example.org/f> .

<https://example.org/f> rdf:type owl:Ontology .
###  https://example.org/f#Leg
:Leg rdf:type owl:Class ;
     owl:equivalentClass [ owl:intersectionOf ( :Region
                                                [ rdf:type owl:Restriction ;
                                                  owl:onProperty :hasShape ;
                                                  owl:someValuesFrom :Stick
                                                ]
                                              ) ;
                           rdf:type owl:Class
                         ] ;
     rdfs:subClassOf :Region ,
                     [ rdf:type owl:Restriction ;
                       owl:onProperty :hasShape ;
                       owl:someValuesFrom :Stick
                     ] ;
     rdfs:comment "a # in a string, and ; . too"@en .
:hasShape rdf:type owl:ObjectProperty .
:Region rdf:type owl:Class .
:Stick rdf:type owl:Class ;
     rdfs:subClassOf

       :Region .
)",
                                             "f.ttl");
    const std::vector<std::string> expected = {
        "10 Leg EquivalentTo: Region and (hasShape some Stick)",
        "18 Leg SubClassOf: Region",
        "19 Leg SubClassOf: hasShape some Stick",
        "27 Stick SubClassOf: Region",
    };
    EXPECT_EQ(wordings(ontology, true), expected);
}

// A second opinion: raptor2 reads the same triples. Blank nodes have other names there, so triples with one are
// compared with it left out.

std::string shown(raptor_term* term) {
    if (term->type == RAPTOR_TERM_TYPE_BLANK) return "_";
    if (term->type == RAPTOR_TERM_TYPE_URI) return reinterpret_cast<char*>(raptor_uri_as_string(term->value.uri));
    const raptor_term_literal_value& literal = term->value.literal;
    const std::string language = literal.language != nullptr ? reinterpret_cast<const char*>(literal.language) : "";
    const std::string type = literal.datatype != nullptr
                                 ? reinterpret_cast<char*>(raptor_uri_as_string(literal.datatype))
                             : language.empty() ? "http://www.w3.org/2001/XMLSchema#string"
                                                : "http://www.w3.org/1999/02/22-rdf-syntax-ns#langString";
    return std::string(reinterpret_cast<char*>(literal.string), literal.string_len) + "|" + type + "|" + language;
}

std::vector<std::string> raptor_triples(const std::string& text, const char* syntax) {
    std::vector<std::string> triples;
    raptor_world* world = raptor_new_world();
    raptor_parser* parser = raptor_new_parser(world, syntax);
    raptor_parser_set_statement_handler(parser, &triples, [](void* list, raptor_statement* triple) {
        static_cast<std::vector<std::string>*>(list)->push_back(shown(triple->subject) + " " +
                                                                shown(triple->predicate) + " " + shown(triple->object));
    });
    raptor_uri* base = raptor_new_uri(world, reinterpret_cast<const unsigned char*>("file:///same"));
    raptor_parser_parse_start(parser, base);
    EXPECT_EQ(raptor_parser_parse_chunk(parser, reinterpret_cast<const unsigned char*>(text.data()), text.size(), 1),
              0);
    raptor_free_uri(base);
    raptor_free_parser(parser);
    raptor_free_world(world);
    std::ranges::sort(triples);
    return triples;
}

std::vector<std::string> our_triples(const std::string& text) {
    const Graph graph = read_document(text, "same");
    const auto show = [&](Node node) {
        const Term& term = graph.terms[node];
        return term.kind == TermKind::blank ? "_"
               : term.kind == TermKind::iri ? term.value
                                            : term.value + "|" + term.datatype + "|" + term.language;
    };
    std::vector<std::string> triples;
    for (const Triple& triple : graph.triples) {
        triples.push_back(show(triple.subject) + " " + show(triple.predicate) + " " + show(triple.object));
    }
    std::ranges::sort(triples);
    return triples;
}

/// The triples that only one of two sorted lists has.
std::string differences(const std::vector<std::string>& ours, const std::vector<std::string>& theirs) {
    std::vector<std::string> only;
    std::string text;
    std::ranges::set_difference(ours, theirs, std::back_inserter(only));
    for (const std::string& triple : only) text += "only ours: " + triple + "\n";
    only.clear();
    std::ranges::set_difference(theirs, ours, std::back_inserter(only));
    for (const std::string& triple : only) text += "only raptor's: " + triple + "\n";
    return text;
}

TEST(Syntax, RaptorReadsTheSameTriples) {
    EXPECT_EQ(differences(our_triples(zoo::text("ttl")), raptor_triples(zoo::text("ttl"), "turtle")), "");
    EXPECT_EQ(differences(our_triples(zoo::text("rdf")), raptor_triples(zoo::text("rdf"), "rdfxml")), "");
    for (const char* name : {"core.ttl", "furniture.ttl"}) {
        const std::string text = read_file(std::string(PARTONOMY_SOURCE_DIR "/ontologies/") + name);
        EXPECT_EQ(differences(our_triples(text), raptor_triples(text, "turtle")), "") << name;
    }
}

/// The corners of both grammars, chosen where raptor2 follows the recommendation.
TEST(Syntax, RaptorAgreesOnTheCorners) {
    const std::string turtle = R"(PREFIX e: <http://e.org/a/b>
@prefix : <http://e.org/#> .
@base <http://e.org/x/y/z?q> .
<> e:p <#f>, <../up>, <./same>, <//other/host>, </root>, <?query>, <deep/er> ;; .
:a.b :p-q :c%20d , :with\,comma , "tab\tnew\nline\u00e9\U0001F600" , 'single' , """long "quoted" ""x""" , '''it's''' ;
   :n 1 , -2 , +3 , 1.5 , .5 , 1e3 , -1.5E-2 , true , false , "x"@en-gb , "y"^^e:T , "z"^^<http://t> .
_:a1 :k _:b , _:a1 , [] , [ ] , ( ) , ( ( 1 ) [ :p :q ; ] "x"@fr ) .
[ :only :this ] .
[ :p :q ] :r :s .
( 1 2 ) :r :s .
:é :p :日本 .
)";
    EXPECT_EQ(differences(our_triples(turtle), raptor_triples(turtle, "turtle")), "");

    const std::string xml =
        R"(<rdf:RDF xmlns="http://e.org/#" xmlns:e="http://e.org/#" xmlns:rdf="http://www.w3.org/1999/02/22-rdf-syntax-ns#"
  xml:base="http://e.org/x/y" xml:lang="en">
<T rdf:ID="one" xml:lang="" e:attr="v &amp; w"><p xml:lang="de">none</p><p>some <![CDATA[<b>]]> text</p><p rdf:nodeID="n"/></T>
<rdf:Description rdf:nodeID="n" xml:lang="" rdf:type="http://e.org/K"><q rdf:resource="" e:a="1"/><q e:a="2"/><q/></rdf:Description>
<rdf:Seq rdf:about="../up"><rdf:li>1</rdf:li><rdf:_7>7</rdf:_7><rdf:li rdf:resource="#r"/></rdf:Seq>
<T><p rdf:parseType="Resource"><p><T xml:base="http://f.org/" rdf:about="g"/></p></p><p rdf:parseType="Collection"/></T>
<T xml:lang="fr"><p rdf:datatype="http://t">&#233; &lt;</p><p><!-- c --><T/><?pi?></p></T>
</rdf:RDF>)";
    EXPECT_EQ(differences(our_triples(xml), raptor_triples(xml, "rdfxml")), "");
}

TEST(Syntax, NTriplesIsTurtle) {
    const Ontology ontology = parse_ontology(
        "# a comment\n"
        "<https://e.org/o> <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> <http://www.w3.org/2002/07/owl#Ontology> "
        ".\n"
        "<https://e.org/A> <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> <http://www.w3.org/2002/07/owl#Class> .\n"
        "_:x <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> <http://www.w3.org/2002/07/owl#Class> .\n"
        "_:x <http://www.w3.org/2002/07/owl#complementOf> <https://e.org/A> .\n"
        "<https://e.org/A> <http://www.w3.org/2000/01/rdf-schema#subClassOf> _:x .\n",
        "o.nt");
    EXPECT_EQ(wordings(ontology, true), std::vector<std::string>{"6 A SubClassOf: not A"});
}

/// What begins with an IRI that could be the tag of an XML element.
TEST(Syntax, NTriplesWithAnyKindOfIri) {
    for (const std::string iri : {"urn:t", "a:b", "mailto:someone", "#t"}) {
        const std::string type = " <http://www.w3.org/1999/02/22-rdf-syntax-ns#type> ";
        const Ontology ontology =
            parse_ontology("<" + iri + ">" + type + "<http://www.w3.org/2002/07/owl#Class> .", "o.nt");
        ASSERT_EQ(ontology.entities.size(), 1U) << iri;
    }
}

}  // namespace
}  // namespace partonomy::owl
