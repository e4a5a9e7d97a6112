#pragma once

#include <cstdint>
#include <vector>

#include "shape/cores.h"
#include "shape/pieces.h"

namespace partonomy {

/// A partition in the making: per fine triangle the number of its part, or -1.
struct Parts {
    std::vector<Core> parts;  ///< `triangles` are those of the core only
    std::vector<std::int32_t> part_of;
};

/// Settles what is a board's and what is not, level boards first, so that a seat keeps its corners where legs are flush
/// with it. Frees parts that are but the thick rim of a board; cuts sticks where a board crosses them, such as a
/// chair's rear legs that run on as back posts; then boards take the free triangles that lie between their walls,
/// continued.
void claim(const Surface& surface, const Vec3& up, Parts& parts);

/// The triangles without a part, in pieces that hang together.
[[nodiscard]] Groups free_pieces(const Surface& surface, const Parts& parts);

/// Free pieces that face themselves across their own thickness become parts: sticks whose walls are not parallel.
void found_new_parts(const Surface& surface, const Groups& free_pieces, Parts& parts);

/// Joins a part to the one that most of it faces: two walls of one stick are one stick.
void merge_parts(const Surface& surface, Parts& parts);

/// Gives every triangle that is still free to the part that reaches it first; concave creases are far to cross. Pieces
/// that have become parts are passed.
void fill(const Surface& surface, const Groups& free_pieces, Parts& parts);

/// Joins pieces that are one box within the noise of the mesh, which tore them apart.
void rejoin_torn_parts(const Surface& surface, Parts& parts);

/// Parts off what stands out of a part's box and has a box of its own: two parts that noise joined.
void part_protrusions(const Surface& surface, Parts& parts);

/// Makes one bar of two halves that the end of another stick parts.
void join_halved_bars(const Surface& surface, Parts& parts);

/// Gives the corner where two sticks meet end to end to the level one.
void give_corners_to_level_sticks(const Surface& surface, const Vec3& up, Parts& parts);

/// Moves the borders between parts to creases nearby.
void settle_borders(const Surface& surface, Parts& parts);

}  // namespace partonomy
