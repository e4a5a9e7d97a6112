#pragma once

#include <memory>
#include <string>
#include <vector>

#include "knowledge/decision_tree.h"
#include "knowledge/explanations.h"

namespace partonomy::knowledge {

/// One learned answer about one region.
struct Answer {
    int region = -1;
    Question question;  ///< over Domain::regions
    bool yes = true;
};

/// What is known about an object: its regions, the answers, and whether more regions may still turn up.
struct Knowledge {
    int region_count = 0;
    bool complete = false;  ///< every part of the object is among the regions
    std::vector<Answer> answers;
    /// Pairs of regions that touch; others do not. Only looked at where the ontology has composite parts.
    std::vector<std::pair<int, int>> connected = {};
};

/// A composite part of one mesh: which regions make it up, and what it can still be.
struct CompositePart {
    int group = -1;             ///< into Domain::composites
    std::vector<int> regions;   ///< ascending
    ConfigurationSet possible;  ///< of its space
};

/// What follows from knowledge, layer by layer.
struct Conclusions {
    std::vector<ConfigurationSet> regions;  ///< per region: what is still possible (empty: contradiction)
    std::shared_ptr<const Space> objects;   ///< those configurations of an object that regions like these can make up
    ConfigurationSet object;                ///< what is still possible of them (incompatible ones included)
    std::vector<CompositePart> composites;  ///< that there are in any case; by group, then by regions
    std::string left_aside;                 ///< why the closed world of the mesh was not looked at; mostly empty
    bool contradiction = false;             ///< some set is empty: answers and axioms cannot all hold
    std::vector<Iri> diagnoses;  ///< incompatible concepts that the object or a part of it is entailed to be; sorted
};

/// Propagates answers to part counts and part counts to the object, exactly: an object configuration remains when some
/// choice of one remaining configuration for each region (and of any further regions, unless the knowledge is complete)
/// realises it. Throws std::invalid_argument for an answer about a region or a question that there is not.
[[nodiscard]] Conclusions conclude(const Domain& domain, const Knowledge& knowledge);

/// The second half of conclude(): what follows when `regions` are what is possible for each of the regions; the answers
/// play no role beyond what the closed world of the mesh says of them.
[[nodiscard]] Conclusions conclude_object(const Domain& domain, const Knowledge& knowledge,
                                          std::vector<ConfigurationSet> regions);

/// Concepts of a layer that hold in every remaining configuration; none when none remains.
[[nodiscard]] std::vector<ConceptId> entailed(const Space& space, const ConfigurationSet& set);

/// A set of answers and axioms from which nothing can be taken away. That the values of a range concept exclude each
/// other is taken for granted and not listed.
struct Explanation {
    std::vector<std::size_t> answers;  ///< indices into Knowledge::answers
    std::vector<std::size_t> axioms;   ///< indices into Ontology::axioms
    bool needs_completeness = false;   ///< it also rests on "there are no other parts"
    bool is_minimal = true;            ///< false: a limit of steps was reached, and some of it may not be needed
    bool operator==(const Explanation&) const = default;
};

/// Why the object is a `concept_iri` (an Incompatible one, or any concept of the object layer that is entailed), or,
/// with an empty IRI, why the knowledge is contradictory. Minimal: nothing can be left out, but where a limit of steps
/// was reached (Explanation::is_minimal). Explanations that do
/// without "there are no other parts", and those by the concept's own definition, come first. Of a concept of regions
/// the reason for `region` is told, by default for the first region that is entailed to be one. Of the options only the
/// steps count. Throws std::invalid_argument when it is not entailed; OntologyError when concepts count thousands of
/// parts, or when the steps run out before there is any explanation.
[[nodiscard]] Explanation explain(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri,
                                  int region = -1, const ExplanationOptions& options = {});

/// All minimal explanations, the smallest first.
struct Explanations {
    std::vector<Explanation> sets;
    bool is_complete = true;  ///< false when there may be more: a limit was reached
};
[[nodiscard]] Explanations all_explanations(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri,
                                            int region = -1, const ExplanationOptions& options = {});

/// The regions to blame for an incompatible concept: those that make true the hasPart restrictions written in the
/// concept's own definition (the classes it names, such as Chair, are context and not to blame). Ascending.
[[nodiscard]] std::vector<int> culprits(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri);

/// Answers to turn round together, so that a conclusion no longer follows; a part of them would not do.
struct Correction {
    std::vector<std::size_t> answers;  ///< indices into Knowledge::answers, ascending
    double cost = 0;                   ///< the sum of their `costs`: low where fuzzy scores were near the boundary
};

/// The cheapest corrections of `concept_iri` (of a contradiction when empty), by ascending cost, then number of
/// changes. `costs` holds the cost of turning each answer round (same order as Knowledge::answers). What they lead to
/// is free of every other Incompatible concept too that does not follow already, wherever that is possible. None when
/// only another mesh or another ontology would help. Throws as explain() does.
[[nodiscard]] std::vector<Correction> corrections(const Domain& domain, const Knowledge& knowledge,
                                                  const Iri& concept_iri, const std::vector<double>& costs,
                                                  int region = -1, const ExplanationOptions& options = {});

}  // namespace partonomy::knowledge
