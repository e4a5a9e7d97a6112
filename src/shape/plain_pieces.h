#pragma once

#include <optional>

#include "shape/surface.h"

namespace partonomy {

/// A piece with walls that are nearly flat and an outline without corners that turn in, as narrow and as long
/// everywhere.
struct PlainPiece {
    double narrow = 0, wide = 0;  ///< across the thickness: the shorter and the longer way from side to side
    Vec3 along = Vec3::Zero();    ///< unit direction of the longer way
};

/// What the triangles are the walls of, when it is a slab (two walls), a bar (four) or a block (six): told by their
/// places and normals alone, so this costs no ray. `thickness` is the distance between the walls, `area` that of all
/// triangles, of which there is at least one. Sizes in the units of the mesh.
[[nodiscard]] std::optional<PlainPiece> as_plain_piece(const Surface& surface,
                                                       const std::vector<std::int32_t>& triangles, double thickness,
                                                       double area);

}  // namespace partonomy
