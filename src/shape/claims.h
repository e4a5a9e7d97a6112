#pragma once

#include <cstdint>
#include <vector>

#include "shape/cores.h"

namespace partonomy {

/// A partition in the making: per fine triangle the number of its part, or -1.
struct Parts {
    std::vector<Core> parts;  ///< `triangles` are those of the core only
    std::vector<std::int32_t> part_of;
};

/// Cuts sticks where a board crosses them, such as a chair's rear legs that run on as back posts: what lies between the
/// board's walls becomes free, and the pieces above and below become sticks of their own.
void cut_at_boards(const Surface& surface, const Vec3& up, Parts& parts);

/// Frees parts that are but the thick rim of a board: they lie between its walls, along it, and do not end at it.
void absorb_rims(const Surface& surface, const Vec3& up, Parts& parts);

/// Boards take the free triangles that lie between their walls, continued: the rim, and the places where another part
/// stands on the other side. Level boards come first, so that a seat keeps its corners where legs are flush with it.
void claim_slabs(const Surface& surface, const Vec3& up, Parts& parts);

/// Free pieces that face themselves across their own thickness become parts: sticks whose walls are not parallel.
void found_new_parts(const Surface& surface, Parts& parts);

/// Joins a part to the one that most of it faces: two walls of one stick are one stick.
void merge_parts(const Surface& surface, Parts& parts);

/// Gives every triangle that is still free to the part that reaches it first; concave creases are far to cross.
void fill(const Surface& surface, Parts& parts);

/// Moves the borders between parts to creases nearby.
void settle_borders(const Surface& surface, Parts& parts);

}  // namespace partonomy
