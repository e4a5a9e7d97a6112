#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "algorithms/object.h"

namespace partonomy {

/// A region and what is measured on it; several cuts share it.
struct MeasuredRegion {
    PartRegion part;
    RegionMeasurements measurements;  ///< its span is the part's
};

/// One way to cut an object: disjoint regions.
using Cut = std::vector<std::shared_ptr<const MeasuredRegion>>;

/// What the ontology says of a cut.
struct Verdict {
    struct Named {
        std::string name;  ///< local name of the concept; empty: nothing that the ontology names
        double fuzzy = 0;  ///< membership in the concept, [0, 1]: the least certain answer that it rests on
    };
    std::vector<Named> regions;  ///< in the order of the cut
    bool is_recognised = true;   ///< a class of the object is known
    bool is_consistent = true;
};

/// An edit of the cut that made it likelier.
struct Edit {
    std::string what;           ///< "took in a piece without a name"
    std::int32_t triangle = 0;  ///< of the region that it is about
};

struct FinalLabelling {
    Cut cut;
    std::vector<Edit> edits;  ///< at least one
    int trials = 0;           ///< cuts that were judged
};

/// Mends a cut by what the ontology says of it: pieces without a name join a neighbour, parts that fit no box well are
/// cut as `find_pieces` would, as long as that makes the whole clearly likelier. nullopt when nothing does; where every
/// region has a name and fits well, at once. `cut` is what `first` was said of.
[[nodiscard]] std::optional<FinalLabelling> find_final_labelling(const Object& object, const Cut& cut,
                                                                 const Verdict& first,
                                                                 const std::function<Verdict(const Cut&)>& judge,
                                                                 int threads = 1);

/// The object's regions as a cut.
[[nodiscard]] Cut cut_of(const Object& object);

}  // namespace partonomy
