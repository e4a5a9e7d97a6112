#pragma once

#include <string>
#include <vector>

#include "knowledge/explain.h"

namespace partonomy::knowledge {

/// A concept of objects that an object is not, or not for sure, and what keeps it from it.
struct NearMiss {
    Iri iri;
    std::vector<std::string> lacks;     ///< "1 Seat", "2 Leg (part 3 may be one)"
    std::vector<std::string> too_many;  ///< "1 Backrest"
    double likeness = 0;                ///< of the parts that count for it: how many are as they should be, [0, 1]
};

/// What an object that is not recognised comes nearest to: concepts of objects of which at least one part is there, the
/// likest first, and of those that come nearest the most specific first; else in the order of their names. No
/// diagnoses, and none of `left_out`.
[[nodiscard]] std::vector<NearMiss> near_misses(const Domain& domain, const Conclusions& known,
                                                const std::vector<Iri>& left_out = {});

}  // namespace partonomy::knowledge
