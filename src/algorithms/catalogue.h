#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/derive.h"
#include "algorithms/formula.h"
#include "algorithms/object.h"
#include "knowledge/decision_tree.h"

namespace partonomy {

/// The signatures of elementary algorithms (paper §3.4.1).
enum class Signature {
    find_all,      ///< SF: all regions that are C, inside a region
    is_a,          ///< SI: is a region a C
    related,       ///< T: are these regions in a relation
    find_related,  ///< TF: all regions that are in a relation to these
};

/// What one TF costs, over one T of the same relation.
inline constexpr double find_related_cost = 4;

/// Where an algorithm comes from: it was made for its question, or out of another algorithm (paper §3.4.2).
enum class Origin { own, derived };

/// One elementary algorithm: it answers one question.
struct ElementaryAlgorithm {
    Signature signature;
    knowledge::Question question;  ///< over Domain::regions
    std::string name;              ///< local name of the concept: "Board", "height <= 0.55"
    std::string method;            ///< how it answers, in words
    double cost;                   ///< relative: an `is a` is 1 unless core:cost says otherwise
    bool needs_metres;
    Origin origin = Origin::own;
    std::vector<Formula> formulas = {};          ///< SI: of the concept's criteria, in their order; or of the number
    AppearanceNeed look = AppearanceNeed::none;  ///< what the file must tell for an answer
    std::optional<Grain> grain = {};             ///< SF that is derived from the `is a`: what it browses
};

/// All elementary algorithms for a domain: an `is a` for every elementary concept with criteria and every number that
/// axioms mention, a `find all` for the box shapes and for colours and derived ones for other concepts, a T and a TF
/// for every statement about relations all of which have criteria.
struct Catalogue {
    std::vector<ElementaryAlgorithm> algorithms;
    [[nodiscard]] const ElementaryAlgorithm* find(Signature signature, knowledge::Question question) const;
    bool has_own_find_all = false;
    /// Cost of the question's `find all`, where it is worth asking while `parts` parts are not yet regions: an own one
    /// always is; a derived one when there are no own ones, and when it finds surfaces inside of parts or costs less
    /// than asking `is a` of each part. nullopt otherwise.
    [[nodiscard]] std::optional<double> cutting_cost(knowledge::Question question, std::size_t parts) const;
};

/// Throws OntologyError when core:measure or core:criterion names a measure that does not exist (with the nearest right
/// name), combines measures that do not go together, or names one of another number of regions than the relation's.
[[nodiscard]] Catalogue make_catalogue(const knowledge::Domain& domain);

/// All elementary concepts and relations of the built-in core ontology, with one statement about each relation: that
/// there is one. It has neither parts nor objects.
[[nodiscard]] knowledge::Domain make_core_domain();

/// The algorithms for that domain: all that there are, whether or not an ontology uses them.
[[nodiscard]] Catalogue make_core_catalogue();

/// Score in [0, 1] of "the region is what the question says": >= 0.5 means yes. nullopt when nothing can tell: no
/// algorithm, or no unit. (SI of paper §6.3: the lowest of the concept's trapezoids.)
[[nodiscard]] std::optional<double> is_a(const knowledge::Domain& domain, const Catalogue& catalogue,
                                         knowledge::Question question, const Object& object,
                                         const RegionMeasurements& region);

}  // namespace partonomy
