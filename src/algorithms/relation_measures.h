#pragma once

#include <vector>

#include "algorithms/relations.h"

namespace partonomy {

// The built-in measures by family, in the order in which the catalogue prints them.

void add_place_measures(std::vector<RelationMeasure>& measures);    ///< above, beside, in front, between, in a row …
void add_contact_measures(std::vector<RelationMeasure>& measures);  ///< gap, contact, inside, around
void add_likeness_measures(
    std::vector<RelationMeasure>& measures);                     ///< angles, planes, mirror images, shape, size, ratios
void add_plan_measures(std::vector<RelationMeasure>& measures);  ///< in metres: what stands on what, how far apart

}  // namespace partonomy
