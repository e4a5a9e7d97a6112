#pragma once

#include <map>
#include <string>
#include <vector>

#include "owl/declarations.h"
#include "owl/rdf_graph.h"

namespace partonomy::owl {

/// Reads class expressions, data ranges, property expressions and lists out of a graph, and marks their triples as
/// used. Every function takes the line on which its node is mentioned, for error sentences, and throws OntologyError.
class Expressions {
public:
    Expressions(const Graph& graph, const Declarations& declarations);

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

    /// A blank node that stands for a class expression, data range, inverse property or list.
    [[nodiscard]] bool is_structure(Node node) const;

    [[nodiscard]] const Term& term(Node node) const { return graph_.terms[node]; }
    [[nodiscard]] const std::vector<std::uint32_t>& about(Node node) const { return by_subject_[node]; }
    [[nodiscard]] std::string shown(Node node) const;  ///< for error sentences
    [[noreturn]] void fail(long line, const std::string& sentence) const;

    std::vector<char> used;  ///< by triple

private:
    struct Made {
        ClassPointer expression;
        std::size_t size = 0;  ///< nodes, shared ones counted again: what walking it would cost
    };
    struct Nested;
    Made make(Node node, long line);
    Made restriction(Node node, long line);
    Made connective(const Triple& triple);
    void reject_undeclared(Node node, EntityKind kind, long line) const;
    void add_facet(Node node, long line, DataRange& range);
    [[nodiscard]] std::uint32_t count(const Triple& triple) const;
    Made sized(ClassExpression&& expression, std::size_t size, long line) const;

    const Graph& graph_;
    const Declarations& declarations_;
    std::vector<std::vector<std::uint32_t>> by_subject_;
    std::map<Node, Made> made_;
    std::vector<char> open_;  ///< nodes being read: meeting one again is a cycle
    int depth_ = 0;
};

}  // namespace partonomy::owl
