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

    /// " (did you mean Seat?)" for the declared name most like `iri`'s, empty when none is near.
    [[nodiscard]] std::string suggestion(const Iri& iri, EntityKind kind) const;

    /// Names of the core ontology of one kind; sorted.
    [[nodiscard]] std::vector<Iri> names_of_core(EntityKind kind) const;

private:
    void add(const Iri& iri, EntityKind kind) { kinds_[iri] |= 1U << static_cast<unsigned>(kind); }
    static constexpr unsigned built_in = 1U << 8;
    std::unordered_map<Iri, unsigned> kinds_;  ///< a bit for each EntityKind, and built_in
};

class AnonymousNames;

/// Adds what `graph` says to `ontology`: axioms, annotations, and individuals that are used without a declaration.
/// Throws OntologyError for anything that is no OWL 2.
void map_axioms(const Graph& graph, const Declarations& declarations, AnonymousNames& names, Ontology& ontology);

}  // namespace partonomy::owl
