#pragma once

#include <string>
#include <unordered_map>
#include <vector>

#include "owl/rdf_graph.h"

namespace partonomy::owl {

/// What each IRI is, over a document and all that it imports: OWL tells `some` over objects from `some` over data by
/// it.
struct Declarations {
    Declarations();  ///< knows what OWL 2 itself declares: owl:Thing, rdfs:label, xsd:double …

    /// Takes in the declarations of a document; `entities` grows by them. Throws OntologyError when an IRI is declared
    /// both an object and a data property, or both a class and a datatype.
    void collect(const Graph& graph, std::vector<Entity>& entities);

    [[nodiscard]] bool has(const Iri& iri, EntityKind kind) const;

    /// " (did you mean Seat?)" for the declared name most like `iri`'s, or one that is also called so (core:alsoCalled,
    /// or core:converse from the other side of a relation); empty when none is near. Of a name that is written as one
    /// of the core ontology's, what is also called so comes first.
    [[nodiscard]] std::string suggestion(const Iri& iri, EntityKind kind) const;

    /// Names of the core ontology of one kind; sorted.
    [[nodiscard]] std::vector<Iri> names_of_core(EntityKind kind) const;

private:
    void add(const Iri& iri, EntityKind kind) { kinds_[iri] |= 1U << static_cast<unsigned>(kind); }
    /// Names, empty when there is none.
    [[nodiscard]] std::string by_spelling(const Iri& iri, EntityKind kind) const;
    [[nodiscard]] std::string by_other_name(const std::string& name, EntityKind kind) const;

    struct OtherName {
        std::string name;
        Iri of;
        bool is_converse = false;
    };
    static constexpr unsigned built_in = 1U << 8;
    std::unordered_map<Iri, unsigned> kinds_;  ///< a bit for each EntityKind, and built_in
    std::vector<OtherName> other_names_;
};

class AnonymousNames;

/// Adds what `graph` says to `ontology`: axioms, annotations, and individuals that are used without a declaration.
/// Throws OntologyError for anything that is no OWL 2.
void map_axioms(const Graph& graph, const Declarations& declarations, AnonymousNames& names, Ontology& ontology);

}  // namespace partonomy::owl
