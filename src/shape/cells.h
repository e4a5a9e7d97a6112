#pragma once

#include <cstdint>
#include <vector>

#include "shape/cores.h"

namespace partonomy {

/// A patch of a component around one sampled triangle, both walls.
struct Cell {
    double thickness = 0;
    double ratio = 0;  ///< width / thickness
    double reach = 0;  ///< length / thickness
    Vec3 along = Vec3::Zero();
    double area = 0;
    Solidity kind = Solidity::unknown;
    bool is_junction = false;  ///< around it, sticks run in different directions
    bool is_narrow = false;    ///< a board, on the narrow side of a gap in the widths of its component
    std::vector<std::int32_t> neighbours;
};

/// What is as narrow as thick is a stick or a cube, what is twice as wide a board, and what is narrower no part.
[[nodiscard]] Solidity kind_of(double ratio, double reach, double least_ratio);

constexpr double narrowest = 0.7, narrowest_slanted = 0.4;  ///< width / thickness of a stick, at least

/// The middle one of the distances between opposite walls; of one triangle at least.
[[nodiscard]] double median_thickness(const Surface& surface, const std::vector<std::int32_t>& triangles);

/// A component and what its sampled triangles, the seeds of its cells, see around them.
struct Sampled {
    Core component;
    std::vector<std::int32_t> seeds;
    std::vector<Cell> cells;
};

/// Triangles spread evenly over the area of a component: the seeds of its cells.
[[nodiscard]] std::vector<std::int32_t> choose_seeds(const Surface& surface, const Core& component, double total_area);

/// Looks around from the seeds of all components; one loop over all of them keeps every thread busy. `slanted`: the
/// walls are not parallel, as those of a stick with three sides.
void look_around(const Surface& surface, std::vector<Sampled>& components, bool slanted);

}  // namespace partonomy
