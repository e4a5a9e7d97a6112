#pragma once

#include <cstdint>
#include <vector>

#include "shape/narrow_boards.h"

namespace partonomy {

/// For each cell the number of the straight side of its piece that it is on; 0 where a piece has no tight bend. A piece
/// is bent tightly when nearly all of it faces (a board) or runs along (a stick) one of a few directions.
[[nodiscard]] std::vector<std::int32_t> tell_sides_of_bends(const CellMap& map, Sets& pieces);

}  // namespace partonomy
