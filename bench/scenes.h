#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy::bench {

struct Scene {
    TriangleMesh mesh;
    std::vector<int> parts;  ///< of each triangle
};

/// A cube that carries an upright board, a level board and a stick, as in Fig. 16 of the paper: one closed surface of
/// about so many triangles, in even squares.
[[nodiscard]] Scene figure_16(std::size_t triangles);

/// Moves the vertices along their normals by waves of many lengths, from half the diagonal down to a few edges, each as
/// steep as the others. `level` is the root mean square of the way, relative to the diagonal.
void add_noise(TriangleMesh& mesh, double level, std::uint32_t seed);

}  // namespace partonomy::bench
