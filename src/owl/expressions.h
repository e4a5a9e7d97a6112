#pragma once

#include <map>
#include <string>
#include <vector>

#include "owl/declarations.h"
#include "owl/rdf_graph.h"

namespace partonomy::owl {

/// Names of anonymous individuals, one for all documents read together: "_:label" where the document gives a label,
/// "_:g1", "_:g2" … for the others, in the order in which they are asked for.
class AnonymousNames {
public:
    /// Takes in the labels of a document. Of documents that share a label the one asked first keeps it.
    void reserve(const Graph& graph);
    [[nodiscard]] Iri name(const Graph& graph, Node node);

private:
    using Place = std::pair<const Graph*, Node>;
    std::map<Iri, Place> owners_;
    std::map<Place, Iri> names_;
    int count_ = 0;
};

/// Reads class expressions, data ranges, property expressions and lists out of a graph, and marks their triples as
/// used. Every function takes the line on which its node is mentioned, for error sentences, and throws OntologyError.
class Expressions {
public:
    Expressions(const Graph& graph, const Declarations& declarations, AnonymousNames& names);

    [[nodiscard]] ClassPointer class_expression(Node node, long line);
    /// The expression that `triple` (owl:unionOf, owl:oneOf …) describes, whatever its subject.
    [[nodiscard]] ClassPointer described_by(const Triple& triple);
    [[nodiscard]] DataRange data_range(Node node, long line);
    [[nodiscard]] PropertyExpression object_property(Node node, long line);
    [[nodiscard]] PropertyExpression data_property(Node node, long line);
    [[nodiscard]] Iri individual(Node node, long line) const;
    [[nodiscard]] Literal literal(Node node) const;
    [[nodiscard]] std::vector<Node> list(Node head, long line);

    /// Whether the node is a property over data; throws when it is no declared property.
    [[nodiscard]] bool is_data_property(Node node, long line) const;

    /// Whether the node, of which the document leaves open what it is, is a datatype or made of datatypes or literals.
    [[nodiscard]] bool is_data_range(Node node) const;

    /// A blank node that stands for a class expression, data range, inverse property or list.
    [[nodiscard]] bool is_structure(Node node) const;

    [[nodiscard]] const Term& term(Node node) const { return graph_.terms[node]; }
    [[nodiscard]] const std::vector<std::uint32_t>& about(Node node) const { return by_subject_[node]; }
    [[nodiscard]] std::string shown(Node node) const;  ///< for error sentences
    [[noreturn]] void fail(long line, const std::string& sentence) const;
    /// Says that `node` is no `kind`, with the declared name that may be meant.
    /// "; its numbers are area, …" where a property was meant, to end a sentence about a name that core lacks.
    [[nodiscard]] std::string numbers_of_core(EntityKind kind) const;
    [[noreturn]] void reject_undeclared(Node node, EntityKind kind, long line) const;

    std::vector<char> used;  ///< by triple

private:
    struct Made {
        ClassPointer expression;
        std::size_t size = 0;  ///< nodes, shared ones counted again: what walking it would cost
    };
    /// Marks a node as being read: meeting it again inside is a cycle.
    struct Nested {
        Nested(Expressions& reader, Node at_node, long line, const char* what);
        ~Nested() {
            owner.open_[node] = 0;
            --owner.depth_;
        }
        Nested(const Nested&) = delete;
        Nested& operator=(const Nested&) = delete;
        Expressions& owner;
        Node node;
    };
    Made make(Node node, long line);
    Made restriction(Node node, long line);
    Made connective(const Triple& triple);
    [[nodiscard]] Iri datatype(Node node, long line) const;
    DataRange data_connective(const Triple& triple);
    DataRange data_one_of(const Triple& triple);
    DataRange datatype_restriction(const Triple& on_datatype, const Triple& facets);
    void add_facet(Node node, long line, DataRange& range);
    void take_class(Node node, long line, Made& made, ClassExpression& expression);
    void filler(const Triple& on_property, const Triple& value, bool over_data, Made& made,
                ClassExpression& expression);
    void bound(const Triple& on_property, const Triple& value, const Triple* qualifier, bool over_data, Made& made,
               ClassExpression& expression);
    [[nodiscard]] std::uint32_t count(const Triple& triple) const;
    Made sized(ClassExpression&& expression, std::size_t size, long line) const;

    const Graph& graph_;
    const Declarations& declarations_;
    AnonymousNames& names_;
    std::vector<std::vector<std::uint32_t>> by_subject_;
    std::map<Node, Made> made_;
    std::vector<char> open_;  ///< nodes being read: meeting one again is a cycle
    int depth_ = 0;
    std::size_t data_ranges_ = 0;  ///< read so far, shared ones counted again
};

}  // namespace partonomy::owl
