#pragma once

#include "shape/cells.h"

namespace partonomy {

/// Which component each triangle belongs to, or -1, and in it which cell. Components can be divided side by side: each
/// looks at the cells of its own triangles only.
struct Division {
    std::vector<std::int32_t> component_of, cell_of;

    Division(const Surface& s, const std::vector<Sampled>& sampled)
        : component_of(s.count(), -1), cell_of(sampled.empty() ? 0 : s.count(), -1) {
        for (std::size_t k = 0; k < sampled.size(); ++k)
            for (const std::int32_t i : sampled[k].component.triangles) component_of[i] = static_cast<std::int32_t>(k);
    }
};

/// Cuts a component where it changes between board and stick, where a stick turns a corner, and where a narrow board
/// ends at a wide one; adds the pieces. `component` is its number in the division.
void divide_component(const Surface& surface, bool slanted, Division& division, std::size_t component, Sampled sampled,
                      std::vector<Core>& pieces);

}  // namespace partonomy
