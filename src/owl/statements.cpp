#include "owl/statements.h"

namespace partonomy::owl {

Node Statements::typed(Word type, long line) {
    const Node node = graph_.blank();
    if (type != Word::none) say(node, Word::rdf_type, type, line);
    return node;
}

Node Statements::list(const std::vector<Node>& members, long line) {
    Node rest = graph_.word(Word::rdf_nil);
    for (std::size_t i = members.size(); i-- > 0;) {
        const Node cell = graph_.blank();
        say(cell, Word::rdf_first, members[i], line);
        say(cell, Word::rdf_rest, rest, line);
        rest = cell;
    }
    return rest;
}

Node Statements::connective(Word type, Word word, const std::vector<Node>& members, long line) {
    const Node node = typed(type, line);
    say(node, word, list(members, line), line);
    return node;
}

Node Statements::complement(Word type, Word word, Node operand, long line) {
    const Node node = typed(type, line);
    say(node, word, operand, line);
    return node;
}

Node Statements::restriction(Node property, Word word, Node value, long line) {
    const Node node = typed(Word::owl_Restriction, line);
    say(node, Word::owl_onProperty, property, line);
    say(node, word, value, line);
    return node;
}

Node Statements::cardinality(Node property, Word word, const std::string& number, Word filler_word, Node filler,
                             long line) {
    const bool is_qualified = filler_word != Word::none;
    if (is_qualified && word == Word::owl_minCardinality) word = Word::owl_minQualifiedCardinality;
    if (is_qualified && word == Word::owl_maxCardinality) word = Word::owl_maxQualifiedCardinality;
    if (is_qualified && word == Word::owl_cardinality) word = Word::owl_qualifiedCardinality;
    const Node node =
        restriction(property, word, graph_.literal(number, std::string(xsd_prefix) + "nonNegativeInteger"), line);
    if (is_qualified) say(node, filler_word, filler, line);
    return node;
}

Node Statements::inverse(Node property, long line) {
    const Node node = graph_.blank();
    say(node, Word::owl_inverseOf, property, line);
    return node;
}

Node Statements::datatype_restriction(Node datatype, const std::vector<std::pair<Node, Node>>& facets, long line) {
    std::vector<Node> members;
    for (const auto& [facet, value] : facets) {
        members.push_back(graph_.blank());
        graph_.add(members.back(), facet, value, line);
    }
    const Node node = typed(Word::rdfs_Datatype, line);
    say(node, Word::owl_onDatatype, datatype, line);
    say(node, Word::owl_withRestrictions, list(members, line), line);
    return node;
}

Node Statements::literal(const std::string& value, const std::string& datatype, const std::string& language) {
    const std::string rdf = rdf_prefix;
    if (!language.empty()) return graph_.literal(value, rdf + "langString", language);
    if (datatype.empty()) return graph_.literal(value, std::string(xsd_prefix) + "string");
    const std::size_t cut = value.rfind('@');
    if (datatype != rdf + "PlainLiteral") return graph_.literal(value, datatype);
    if (cut == std::string::npos || cut + 1 == value.size())
        return graph_.literal(value.substr(0, cut), std::string(xsd_prefix) + "string");
    return graph_.literal(value.substr(0, cut), rdf + "langString", value.substr(cut + 1));
}

void Statements::reify(Word type, Node subject, Node predicate, Node object, const std::vector<Note>& notes,
                       long line) {
    const Node node = typed(type, line);
    say(node, Word::owl_annotatedSource, subject, line);
    say(node, Word::owl_annotatedProperty, predicate, line);
    say(node, Word::owl_annotatedTarget, object, line);
    annotate(node, notes);
}

void Statements::axiom(Node subject, Node predicate, Node object, long line, const std::vector<Note>& notes) {
    graph_.add(subject, predicate, object, line);
    if (!notes.empty()) reify(Word::owl_Axiom, subject, predicate, object, notes, line);
}

void Statements::annotate(Node subject, const std::vector<Note>& notes) {
    for (const Note& note : notes) {
        graph_.add(subject, note.property, note.value, note.line);
        if (!note.notes.empty()) reify(Word::owl_Annotation, subject, note.property, note.value, note.notes, note.line);
    }
}

void Statements::chain(Word predicate, const std::vector<Node>& members, long line, const std::vector<Note>& notes) {
    for (std::size_t i = 0; i + 1 < members.size(); ++i) axiom(members[i], predicate, members[i + 1], line, notes);
}

void Statements::pairwise(Word predicate, Word type, Word members_word, const std::vector<Node>& members, long line,
                          const std::vector<Note>& notes) {
    if (members.size() == 2) return axiom(members[0], predicate, members[1], line, notes);
    const Node node = typed(type, line);
    say(node, members_word, list(members, line), line);
    annotate(node, notes);
}

void Statements::negative_assertion(Node subject, Node property, Word target_word, Node target, long line,
                                    const std::vector<Note>& notes) {
    const Node node = typed(Word::owl_NegativePropertyAssertion, line);
    say(node, Word::owl_sourceIndividual, subject, line);
    say(node, Word::owl_assertionProperty, property, line);
    say(node, target_word, target, line);
    annotate(node, notes);
}

Node Statements::atoms(const std::vector<Node>& members, long line) {
    Node rest = graph_.word(Word::rdf_nil);
    for (std::size_t i = members.size(); i-- > 0;) {
        const Node cell = typed(Word::swrl_AtomList, line);
        say(cell, Word::rdf_first, members[i], line);
        say(cell, Word::rdf_rest, rest, line);
        rest = cell;
    }
    return rest;
}

void Statements::rule(const std::vector<Node>& body, const std::vector<Node>& head, long line,
                      const std::vector<Note>& notes) {
    const Node node = typed(Word::swrl_Imp, line);
    say(node, Word::swrl_body, atoms(body, line), line);
    say(node, Word::swrl_head, atoms(head, line), line);
    annotate(node, notes);
}

Node Statements::atom(Word type, Word predicate_word, Node predicate, const std::vector<Node>& arguments, long line) {
    const Node node = typed(type, line);
    if (predicate_word != Word::none) say(node, predicate_word, predicate, line);
    if (!arguments.empty()) say(node, Word::swrl_argument1, arguments[0], line);
    if (arguments.size() > 1) say(node, Word::swrl_argument2, arguments[1], line);
    return node;
}

Node Statements::built_in(Node iri, const std::vector<Node>& arguments, long line) {
    const Node node = typed(Word::swrl_BuiltinAtom, line);
    say(node, Word::swrl_builtin, iri, line);
    say(node, Word::swrl_arguments, list(arguments, line), line);
    return node;
}

Node Statements::variable(const Iri& iri, long line) {
    const Node node = graph_.iri(iri, line);
    say(node, Word::rdf_type, Word::swrl_Variable, line);
    return node;
}

Iri variable_iri(const std::string& name) { return "urn:swrl#" + name; }

}  // namespace partonomy::owl
