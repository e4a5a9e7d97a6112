#pragma once

#include <memory>

#include "knowledge/explain.h"
#include "knowledge/theory.h"

// Inside of the knowledge folder: explanations and corrections by a SAT solver, for theories that ObjectClauses can
// express; what they say of a concept of one region holds for any theory. What the functions promise stands in
// explain.h.

namespace partonomy::knowledge {

/// Axioms that define the goal (a concept of the theory), and what its definition rests on, as flags by axiom.
[[nodiscard]] std::vector<char> defining_axioms(const Theory& theory, int goal, std::size_t axiom_count);

/// What explain() says when it finds nothing in time: "why … was not found within … steps of search".
[[noreturn]] void refuse_to_search_on(const Iri& concept_iri, std::uint64_t steps);

[[nodiscard]] Explanation one_reason(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri,
                                     int region, std::uint64_t steps);
[[nodiscard]] Explanations all_reasons(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri,
                                       int region, const ExplanationOptions& options);
[[nodiscard]] std::vector<Correction> cheapest_changes(const Domain& domain, const Knowledge& knowledge,
                                                       const Iri& concept_iri, const std::vector<double>& costs,
                                                       int region, const ExplanationOptions& options);

class ObjectClauses;
/// The literal of an answer about a part of `object`.
[[nodiscard]] int literal_of(const Domain& domain, ObjectClauses& object, std::size_t part, const Answer& answer);

/// Whether a concept of objects (a contradiction for -1) follows from some answers and some of the axioms, asked again
/// and again with fewer axioms. For theories without composite parts.
class FromAxioms {
public:
    /// `answers`: which of the knowledge's; with them and all axioms nothing but the goal may contradict. Throws
    /// OntologyError when there would be too many parts.
    FromAxioms(const Domain& domain, const Knowledge& knowledge, int goal, const std::vector<char>& answers,
               bool complete);
    ~FromAxioms();
    /// `axioms`: by axiom of the ontology.
    [[nodiscard]] bool follows(const std::vector<char>& axioms);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace partonomy::knowledge
