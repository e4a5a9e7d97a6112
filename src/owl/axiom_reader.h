#pragma once

#include <map>
#include <set>
#include <tuple>

#include "owl/expressions.h"

namespace partonomy::owl {

/// Turns the triples of one document into axioms and annotations, which it adds to an ontology. The members stand in
/// map_axioms.cpp (what a predicate or type makes), map_nodes.cpp (axioms that are nodes of their own), map_rules.cpp
/// and map_annotations.cpp.
class AxiomReader {
public:
    AxiomReader(const Graph& graph, const Declarations& declarations, AnonymousNames& names, Ontology& ontology)
        : graph_(graph),
          declarations_(declarations),
          names_(names),
          read_(graph, declarations, names),
          ontology_(ontology) {}

    void read();

private:
    // What a triple says by its predicate or, for rdf:type, its object.
    void statement(const Triple& triple);
    void type(const Triple& triple);
    void class_assertion(const Triple& triple);
    void characteristic(const Triple& triple);
    void class_axiom(AxiomKind kind, const Triple& triple);
    void disjoint_union(const Triple& triple);
    void property_axiom(const Triple& triple, AxiomKind object_kind, AxiomKind data_kind);
    void property_chain(const Triple& triple);
    void has_key(const Triple& triple);
    void domain_or_range(const Triple& triple);
    void individuals_axiom(AxiomKind kind, const Triple& triple);
    void import(const Triple& triple);
    void assertion(const Triple& triple);
    void property_assertion(const Triple& triple);
    void check_uses() const;
    void refuse_unused() const;

    // Axioms that are nodes of their own.
    void members(const Triple& triple);
    void negative_assertion(const Triple& triple);

    void rule(const Triple& triple);
    std::vector<RuleAtom> atoms(const Triple& triple);
    RuleAtom atom(Node node, long line);
    void atom_predicate(RuleAtom& atom, const Triple& predicate, Word type);
    void atom_arguments(RuleAtom& atom, const Triple& type, bool takes_list);
    RuleTerm rule_term(Node node, long line);
    void check_arguments(const RuleAtom& atom, long line) const;

    // Annotations of entities, and those of axioms and annotations, which are nodes of their own.
    void annotate(const Triple& triple);
    [[nodiscard]] Annotation annotation(const Triple& triple);
    void reified(const Triple& triple);
    void attach_annotations();
    void attach(Node node, Node subject, Node property, Node target, long line);
    std::vector<Annotation> notes_of(Node node, int depth);
    std::size_t find_triple(Node subject, Node predicate, Node object);
    Axiom* find_equal_axiom(const Triple& triple);
    [[nodiscard]] bool is_ontology(Node node) const;

    [[nodiscard]] const Term& term(Node node) const { return read_.term(node); }
    [[nodiscard]] Word word(Node node) const { return term(node).word; }
    [[nodiscard]] bool is_annotation_property(Node node) const;
    /// The one triple of `word` that `triple`'s subject has. When it has none: null, or refused by `name`.
    const Triple* find_only(const Triple& triple, Word word);
    const Triple& only(const Triple& triple, Word word, const char* name);
    /// A new axiom on the triple's line. It is found again by the triple, for its annotations.
    Axiom& add(AxiomKind kind, const Triple& triple);
    /// The triple's place in the graph; `none` for one that only says an annotated axiom again.
    [[nodiscard]] std::size_t index(const Triple& triple) const;
    void use(const Triple& triple);
    Iri individual(Node node, long line);

    struct Reified {
        Node node = 0;  ///< the owl:Axiom or owl:Annotation
        Node subject = 0, property = 0, target = 0;
        long line = 0;
    };
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    const Graph& graph_;
    const Declarations& declarations_;
    AnonymousNames& names_;
    Expressions read_;
    Ontology& ontology_;
    std::size_t first_axiom_ = 0;  ///< of this document
    std::set<Node> variables_;     ///< of rules
    std::set<Node> nodes_;         ///< that are axioms or annotations
    std::vector<Reified> reified_;
    std::map<Node, std::vector<std::size_t>> notes_;           ///< triples that annotate a node of `nodes_`
    std::map<std::tuple<Node, Node, Node>, Node> note_nodes_;  ///< the owl:Annotation of a triple of `notes_`
    std::map<Node, std::size_t> axiom_of_node_;
    // What follows is filled where annotated axioms have to be found again.
    std::map<std::size_t, std::size_t> axiom_of_triple_;
    std::map<std::size_t, std::pair<Iri, std::size_t>> annotation_of_triple_;  ///< subject, position
    std::map<std::tuple<Node, Node, Node>, std::size_t> triples_;
    std::map<std::string, std::size_t> axioms_by_text_;
};

/// owl:, rdf:, rdfs: and swrl: are no place for names of one's own.
[[nodiscard]] bool is_reserved(const Iri& iri);

}  // namespace partonomy::owl
