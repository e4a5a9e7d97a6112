#pragma once

#include <span>
#include <string>

#include "algorithms/relations.h"

namespace partonomy {

/// What T measured: "angle 21.4 degrees (wanted <= 10), line offset 0.04 (wanted <= 0.02)"; wanted is where the score
/// of the trapezoid is at least 0.5. Empty without criteria; "?" for what nothing can tell.
[[nodiscard]] std::string relation_in_numbers(std::span<const knowledge::Criterion> criteria, const Scene& scene,
                                              RelationMeasure::Regions regions);

}  // namespace partonomy
