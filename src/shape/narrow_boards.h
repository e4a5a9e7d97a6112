#pragma once

#include <utility>
#include <vector>

#include "shape/cells.h"
#include "shape/sets.h"

namespace partonomy {

/// A component that was cut into cells.
struct CellMap {
    const Surface& surface;
    const Core& component;
    const std::vector<std::int32_t>& seeds;
    const std::vector<Cell>& cells;
    const std::vector<std::int32_t>& cell_of;       ///< per triangle
    const std::vector<std::int32_t>& component_of;  ///< per triangle
    std::int32_t own;                               ///< number of the component

    [[nodiscard]] bool is_own(std::int32_t triangle) const { return triangle >= 0 && component_of[triangle] == own; }
};

/// Two pieces that stay apart, by a cell of each: a narrow board and the wide one at its end.
using PartedBoards = std::pair<std::int32_t, std::int32_t>;

/// Marks the cells on the narrow side of a gap in the widths of boards. False: there is no gap.
bool tell_narrow_boards(std::vector<Cell>& cells);

/// Joins marked and unmarked pieces on one side of a bend again unless one is a narrow board that ends at the other, as
/// a slat at its rail; `sides` of the cells. Returns what stays apart.
std::vector<PartedBoards> part_narrow_boards(const CellMap& map, const std::vector<std::int32_t>& sides, Sets& pieces);

}  // namespace partonomy
