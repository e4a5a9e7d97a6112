#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// One thing of a scene, or a part of it.
struct ScenePiece {
    std::vector<std::int32_t> triangles;  ///< ascending
    bool is_plain = true;                 ///< no large sides meet in a concave crease: nothing more to cut
};

/// Cuts a scene where one thing ends and the next begins: between shells, and along concave creases that lead all
/// around a piece of the surface. Every triangle is in one piece; pieces are sorted by their lowest triangle.
[[nodiscard]] std::vector<ScenePiece> scene_pieces(const TriangleMesh& mesh, const Adjacency& adjacency,
                                                   const TriangleGeometry& geometry);

}  // namespace partonomy
