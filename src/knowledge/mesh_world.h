#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "knowledge/closed_world.h"
#include "knowledge/explain.h"

namespace partonomy::knowledge {

/// Names in the closed world of a mesh begin with this: …#object, …#part1, …#part1.Shape.
inline constexpr const char* mesh_prefix = "https://w3id.org/partonomy/mesh#";

/// A mesh as a knowledge base about named things: the object, its regions, a value of each feature for each region,
/// composite parts, what the answers say of them, and a few things of which nothing is known, so that what hangs on
/// properties that nothing measures stays open.
struct MeshWorld {
    ClosedWorld world;  ///< axioms: those of the domain's ontology (in fewer words, in the same places) come first
    Iri object;
    std::vector<Iri> regions, composites;
    /// By concept of the theory (theory.h): an open restriction in the words of this world, null for names.
    std::vector<owl::ClassPointer> open;
    std::size_t first_answer = 0;  ///< Knowledge::answers[i] is the axiom first_answer + i

    /// An axiom that says that a composite part is there, that it has a region, or that it has another composite part.
    struct Told {
        std::size_t axiom, composite;
        int region = -1, inner = -1;
    };
    std::vector<Told> told_composites;
};

/// The closed world of a mesh whose regions are all known (design §5). `composites` are those that there are.
/// Restrictions on relations between regions become classes, of which a region is told to be a member or not.
[[nodiscard]] MeshWorld make_mesh_world(const Domain& domain, const Knowledge& knowledge,
                                        const std::vector<CompositePart>& composites = {});

/// The composite parts that a mesh's world is told of: none in an ontology without them; nullopt while it is not
/// certain which there are.
[[nodiscard]] std::optional<std::vector<CompositePart>> composites_for_world(const Domain& domain,
                                                                             const Knowledge& knowledge);

/// Every composite part that there might be if nothing were known of any region: one for each kind of group and each
/// region that may be the first of one, with all that may belong to it then; by group, then by first region.
[[nodiscard]] std::vector<CompositePart> candidate_composites(const Domain& domain, const Knowledge& knowledge);

/// Whether conclusions, explanations and corrections need the closed world of the mesh: the ontology says something
/// that configuration spaces leave open, and all regions are known. Where it has composite parts, there must be no
/// doubt which of them there are, too; else what spaces leave open stays open.
[[nodiscard]] bool needs_mesh_world(const Domain& domain, const Knowledge& knowledge);

/// Answers what the whole ontology says about one mesh, in which all regions are known.
class MeshReasoner {
public:
    /// The domain must outlive it; `composites` are those that there are. With `to_explain` they follow from answers
    /// and axioms, so that explanations hold whatever composite parts there are without the rest; only explanations may
    /// be asked for then. Throws OntologyError for what cannot be grounded.
    MeshReasoner(const Domain& domain, const Knowledge& knowledge, const std::vector<CompositePart>& composites = {},
                 bool to_explain = false);
    ~MeshReasoner();

    /// Takes away what the closed world rules out of what is possible for the regions; an empty set tells nothing.
    /// False when the axioms and what is known contradict each other.
    [[nodiscard]] bool narrow(std::vector<ConfigurationSet>& regions);
    /// The same for the object, a set of `objects`, when its regions are in these sets.
    [[nodiscard]] bool narrow(const std::vector<ConfigurationSet>& regions, const Space& objects,
                              ConfigurationSet& object);

    /// The same for the composite parts.
    void narrow(std::vector<CompositePart>& composites);

    /// As explain(), all_explanations() and corrections() in explain.h; completeness is always taken as given. Where an
    /// explanation speaks of a composite part, the answers that make it one belong to it. Corrections take the
    /// composite parts as given.
    [[nodiscard]] Explanation explain(const Iri& concept_iri, int region,
                                      std::uint64_t steps = ExplanationOptions{}.steps);
    [[nodiscard]] Explanations explain_all(const Iri& concept_iri, int region, const ExplanationOptions& options);
    [[nodiscard]] std::vector<Correction> correct(const Iri& concept_iri, const std::vector<double>& costs, int region,
                                                  const ExplanationOptions& options);

private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace partonomy::knowledge
