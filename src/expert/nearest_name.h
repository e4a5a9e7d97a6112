#pragma once

#include <optional>
#include <vector>

#include "expert/session.h"

namespace partonomy {

/// A name that a region was refused, and by which answers (indices into the knowledge), the surest first.
struct NearestName {
    owl::Iri iri;
    std::vector<std::size_t> refused_by;
};

/// The one of `names` that takes least to be had: of the answers about the region, the surest that do not exclude each
/// other or the name are kept, and what the others have beyond a score of 0.5 is the price; of equal ones the first.
/// What a person said is surer than all else. nullopt when there is none but such as nothing refuses.
[[nodiscard]] std::optional<NearestName> nearest_name(const Session& session, const knowledge::Knowledge& knowledge,
                                                      int region, const std::vector<owl::Iri>& names);

}  // namespace partonomy
