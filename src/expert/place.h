#pragma once

#include "expert/annotate.h"

namespace partonomy {

/// What an object's up axis and unit are, in the words of the command line, and how sure that is.
struct Placing {
    std::string up = "z", unit = "m";               ///< unit "unknown" when none can be trusted
    double up_confidence = 1, unit_confidence = 1;  ///< [0, 1]; 1 when it was given
};

/// Which of them to find; what is not to be found is taken from the object.
struct PlacingOptions {
    std::string up = "auto", unit = "auto";  ///< "auto" or as given
    int threads = 1;
};

/// The up direction to cut a mesh with while nothing is known of it: the one it would rest on most firmly.
[[nodiscard]] Vec3 resting_up(const TriangleMesh& mesh);

/// Finds up axis and unit of an object: the ones with which it stands firmly and is something that the ontology knows,
/// of a size that is typical for it. Leaves the object placed that way. The mesh is cut again only when the axis found
/// is another one than it was cut with. Without a unit that can be trusted, none is set.
[[nodiscard]] Placing find_placement(const knowledge::Domain& domain, const Catalogue& catalogue, Object& object,
                                     const PlacingOptions& options);

}  // namespace partonomy
