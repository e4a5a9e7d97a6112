#pragma once

#include <span>
#include <string>

#include "algorithms/catalogue.h"
#include "algorithms/relations.h"

namespace partonomy {

/// What an answer rests on.
struct InNumbers {
    std::string text;  ///< empty where nothing can tell
    /// How far the measurement that decides is from where the answer would turn, as a share of the larger of the two:
    /// 0 on the border, 0.5 when it would have to be twice as large.
    double off = 0;
};

/// What T measured: "angle 21.4 degrees (wanted <= 10), line offset 0.04 (wanted <= 0.02)"; wanted is where the score
/// of the trapezoid is at least 0.5. Nothing without criteria; "?" for what nothing can tell.
[[nodiscard]] InNumbers relation_in_numbers(std::span<const knowledge::Criterion> criteria, const Scene& scene,
                                            RelationMeasure::Regions regions);

/// What `is a` measured, worded alike; of several criteria all when they hold, else the first that does not. Of a
/// measured number its value. Measures nothing that `is a` did not.
[[nodiscard]] InNumbers is_a_in_numbers(const knowledge::Domain& domain, const Catalogue& catalogue,
                                        knowledge::Question question, const Object& object,
                                        const RegionMeasurements& region);

}  // namespace partonomy
