#pragma once

#include <functional>
#include <string>
#include <vector>

#include "algorithms/solids.h"

// Regions of which it is known by construction whether they are in a relation of core.ttl.

namespace partonomy {

enum class RelationTruth { yes, no, border, unknown };

/// Regions 0 (the target), 1 (and 2) are asked about; the others are what the object needs besides.
struct RelationCase {
    std::string relation;
    RelationTruth truth;
    std::function<void(solids::Stage&, int)> build;  ///< with faces cut into so many steps
    double tolerance = 0.02;                         ///< of a border's score, 0.5
};

/// Of boxes, and of balls, rods, discs, rings and L-shapes.
[[nodiscard]] std::vector<RelationCase> relation_cases();

}  // namespace partonomy
