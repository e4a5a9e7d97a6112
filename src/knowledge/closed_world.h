#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "knowledge/clauses.h"
#include "owl/ontology.h"

namespace partonomy::knowledge {

using owl::Iri;

/// A knowledge base over finitely many individuals: those that the ontology names, those added here, and no others.
struct ClosedWorld {
    owl::Ontology ontology;
    /// Pairwise different, whether the ontology names them or not. Any other two names may mean the same individual, as
    /// in OWL, unless an axiom says or implies otherwise.
    std::vector<Iri> individuals;

    /// An object property of which everything is known: who of `among` is its subject or object can be so in a
    /// `possible` pair only. (That a pair is related is for an assertion to say.)
    struct Known {
        Iri property;
        std::vector<Iri> among;  ///< some of `individuals`
        std::vector<std::pair<Iri, Iri>> possible;
    };
    std::vector<Known> known = {};
};

/// Every individual that the ontology names, sorted: as ClosedWorld::individuals it is the unique name assumption.
[[nodiscard]] std::vector<Iri> individuals_of(const owl::Ontology& ontology);

struct GroundOptions {
    std::size_t max_clauses = 30'000'000;  ///< more are refused
    /// Above this many names that may be equal, a DifferentIndividuals axiom is taken as given (no selector turns it
    /// off).
    std::size_t max_equalities = 60;
};

/// A closed world as clauses: which interpretations over the given individuals are models. Literals of classes,
/// properties and expressions are made when first asked for, with the clauses that define them.
///
/// Every axiom has a selector: its clauses bind only while that literal is true, so assume all selectors to ask what
/// the ontology says, and look for them in Solver::core() to learn which axioms are to blame. Datatype definitions are
/// part of the language and bind always.
class GroundedWorld {
public:
    /// Throws OntologyError with file, line and the axiom for what cannot be grounded: a rule's built-in that computes,
    /// a datatype or facet that is not supported, more than `max_clauses` clauses; UsageError when there is no
    /// individual. `questions` are class expressions that will be asked for though no axiom has them.
    explicit GroundedWorld(ClosedWorld world, const GroundOptions& options = {},
                           std::vector<owl::ClassPointer> questions = {});
    ~GroundedWorld();
    GroundedWorld(GroundedWorld&&) noexcept;
    GroundedWorld& operator=(GroundedWorld&&) noexcept;

    [[nodiscard]] const owl::Ontology& ontology() const;
    [[nodiscard]] const std::vector<Iri>& individuals() const;  ///< all, sorted
    [[nodiscard]] const std::vector<Iri>& classes() const;      ///< named, sorted, without owl:Thing and owl:Nothing
    [[nodiscard]] const std::vector<Iri>& object_properties() const;  ///< sorted, without top and bottom
    [[nodiscard]] const std::vector<Iri>& data_properties() const;

    [[nodiscard]] const Clauses& clauses() const;
    [[nodiscard]] const std::vector<int>& selectors() const;  ///< one for each axiom of the ontology

    /// A literal that is true exactly when the individual is in the class. Throws UsageError for an unknown individual,
    /// and for a restriction of a data property that is neither in the ontology nor among the questions.
    [[nodiscard]] int is_a(const Iri& individual, const owl::ClassExpression& expression);
    [[nodiscard]] int is_a(const Iri& individual, const Iri& named_class);
    [[nodiscard]] int related(const Iri& subject, const owl::PropertyExpression& property, const Iri& object);
    /// No literal when the ontology does not mention `value` beside the property or one that depends on it.
    [[nodiscard]] std::optional<int> has_value(const Iri& subject, const Iri& data_property, const owl::Literal& value);
    [[nodiscard]] int same(const Iri& a, const Iri& b);

private:
    struct Machine;
    std::unique_ptr<Machine> machine_;
};

/// Answers questions about a closed world. A conclusion is an entailment: true in every model.
class ClosedReasoner {
public:
    /// Throws as GroundedWorld does.
    explicit ClosedReasoner(ClosedWorld world, const GroundOptions& options = {});
    ~ClosedReasoner();
    ClosedReasoner(ClosedReasoner&&) noexcept;
    ClosedReasoner& operator=(ClosedReasoner&&) noexcept;

    [[nodiscard]] GroundedWorld& grounded();

    [[nodiscard]] bool is_consistent();
    /// Whether the individual can be, or has to be, in the class. In an inconsistent world it can be in none and is in
    /// all.
    [[nodiscard]] bool is_satisfiable(const owl::ClassPointer& expression, const Iri& individual);
    [[nodiscard]] bool is_entailed(const owl::ClassPointer& expression, const Iri& individual);

    // The following throw OntologyError when the world is inconsistent, since then everything follows.

    /// Named classes that the individual is in, sorted, without owl:Thing.
    [[nodiscard]] std::vector<Iri> types(const Iri& individual);
    /// (individual, class) for all individuals, sorted.
    [[nodiscard]] std::vector<std::pair<Iri, Iri>> all_types();
    struct Relation {
        Iri subject, property, object;
        auto operator<=>(const Relation&) const = default;
    };
    [[nodiscard]] std::vector<Relation> relations();  ///< sorted
    /// Pairs of names, first below second, that mean the same individual; sorted.
    [[nodiscard]] std::vector<std::pair<Iri, Iri>> same_individuals();
    /// (below, above) for different named classes such that every member of the first is one of the second in every
    /// model over these individuals; sorted. A class that never has members is below all.
    [[nodiscard]] std::vector<std::pair<Iri, Iri>> hierarchy();

private:
    struct State;
    std::unique_ptr<State> state_;
};

/// The same knowledge base as plain OWL 2, for any reasoner: the ontology with declarations of the individuals added,
/// closed by "owl:Thing EquivalentTo {all individuals}", DifferentIndividuals of ClosedWorld::individuals, and
/// "p only {…}" for properties of which everything is known. Facets of
/// xsd:double and xsd:float become literals of that datatype; anonymous individuals get names. Throws UsageError when
/// there is no individual.
[[nodiscard]] owl::Ontology closed_ontology(const ClosedWorld& world);

}  // namespace partonomy::knowledge
