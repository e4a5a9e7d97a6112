#pragma once

#include <string>
#include <vector>

#include "owl/rdf_graph.h"

namespace partonomy::owl {

/// An annotation of an axiom, annotation or ontology, in nodes.
struct Note {
    Node property = 0;
    Node value = 0;
    long line = 0;
    std::vector<Note> notes;
};

/// Says the constructs of OWL 2 in triples, as tables 1 and 2 of "Mapping to RDF Graphs" (W3C, 2012) do: what the
/// readers of functional syntax, OWL/XML and Manchester syntax share.
class Statements {
public:
    explicit Statements(Graph& graph) : graph_(graph) {}

    void say(Node subject, Word predicate, Node object, long line) {
        graph_.add(subject, graph_.word(predicate), object, line);
    }
    void say(Node subject, Word predicate, Word object, long line) {
        say(subject, predicate, graph_.word(object), line);
    }

    /// A new blank node of a type; Word::none for a type that is left open.
    Node typed(Word type, long line);
    Node list(const std::vector<Node>& members, long line);
    /// owl:intersectionOf, owl:unionOf, owl:oneOf … of `type` owl:Class or rdfs:Datatype.
    Node connective(Word type, Word word, const std::vector<Node>& members, long line);
    Node complement(Word type, Word word, Node operand, long line);
    /// A restriction on `property`; a cardinality is qualified when `filler` (owl:onClass, owl:onDataRange) is no
    /// Word::none.
    Node restriction(Node property, Word word, Node value, long line);
    Node cardinality(Node property, Word word, const std::string& number, Word filler_word, Node filler, long line);
    Node inverse(Node property, long line);
    Node datatype_restriction(Node datatype, const std::vector<std::pair<Node, Node>>& facets, long line);
    /// "abc@en"^^rdf:PlainLiteral and "abc"^^rdf:PlainLiteral are said as "abc"@en and "abc".
    Node literal(const std::string& value, const std::string& datatype, const std::string& language);

    /// A triple that is an axiom, with the annotations of the axiom.
    void axiom(Node subject, Node predicate, Node object, long line, const std::vector<Note>& notes);
    void axiom(Node subject, Word predicate, Node object, long line, const std::vector<Note>& notes) {
        axiom(subject, graph_.word(predicate), object, line, notes);
    }
    /// Axioms between each member and the next: equivalence and sameness of several things.
    void chain(Word predicate, const std::vector<Node>& members, long line, const std::vector<Note>& notes);
    /// Two members by one triple of `predicate`, more by a node of `type` with a list of `members_word`.
    void pairwise(Word predicate, Word type, Word members_word, const std::vector<Node>& members, long line,
                  const std::vector<Note>& notes);
    void negative_assertion(Node subject, Node property, Word target_word, Node target, long line,
                            const std::vector<Note>& notes);
    /// What `notes` say of `subject`, an ontology or the blank node of an axiom.
    void annotate(Node subject, const std::vector<Note>& notes);

    /// A SWRL rule of atoms, which are nodes.
    void rule(const std::vector<Node>& body, const std::vector<Node>& head, long line, const std::vector<Note>& notes);
    Node atom(Word type, Word predicate_word, Node predicate, const std::vector<Node>& arguments, long line);
    Node built_in(Node iri, const std::vector<Node>& arguments, long line);
    Node variable(const Iri& iri, long line);

    /// Notes that `node`, if it is a name, has to be declared as `kind`.
    void expect(Node node, EntityKind kind, long line) {
        if (graph_.terms[node].kind == TermKind::iri) graph_.uses.push_back({node, kind, line});
    }

private:
    Node atoms(const std::vector<Node>& members, long line);
    void reify(Word type, Node subject, Node predicate, Node object, const std::vector<Note>& notes, long line);

    Graph& graph_;
};

/// How the variable ?x of a rule is named in full where the syntax has no more to say.
[[nodiscard]] Iri variable_iri(const std::string& name);

}  // namespace partonomy::owl
