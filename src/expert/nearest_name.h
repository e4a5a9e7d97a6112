#pragma once

#include <optional>
#include <vector>

#include "expert/session.h"

namespace partonomy {

/// A name that a region was refused, and by which answers (indices into the knowledge), the surest first.
struct NearestName {
    owl::Iri iri;
    std::vector<std::size_t> refused_by;
    double likeness = 0;  ///< how much of what was answered speaks for the name, [0, 1]
};

/// The one of `names` that the region is likest. Of the answers about it the surest that do not exclude each other or
/// the name are kept; each counts by what its score has beyond 0.5, for the name where the name asks for it, against it
/// where it is one of those that refuse it. Of equal ones the first. What a person said is surer than all else. nullopt
/// when there is none but such as nothing refuses.
[[nodiscard]] std::optional<NearestName> nearest_name(const Session& session, const knowledge::Knowledge& knowledge,
                                                      int region, const std::vector<owl::Iri>& names);

/// A region that was refused a name.
struct NearestRegion {
    int region = 0;
    NearestName refused;
};

/// The regions that are likest to what the name asks for and are refused it, at most `most`, the likest first: those of
/// which as much speaks for it as against it, or more.
[[nodiscard]] std::vector<NearestRegion> nearest_regions(const Session& session, const knowledge::Knowledge& knowledge,
                                                         const owl::Iri& name, std::size_t most);

}  // namespace partonomy
