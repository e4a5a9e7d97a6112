#pragma once

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// Takes noise out of a mesh and keeps its creases: moves the vertices to where planes, round walls and sharp edges
/// were before the noise, about. `geometry` becomes that of the result, with its filtered normals. The same mesh on any
/// number of threads; threads <= 0: all cores. For meshes in which calm() finds noise; one that turns by more than some
/// 20 degrees from triangle to triangle should be relaxed first.
void sharpen(TriangleMesh& mesh, TriangleGeometry& geometry, int threads = 1);

}  // namespace partonomy
