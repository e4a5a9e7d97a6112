#pragma once

#include "mesh/triangle_mesh.h"

namespace partonomy {

// What large meshes need on several threads; threads <= 0: all cores. The answers are the same on any number.

[[nodiscard]] Adjacency build_adjacency(const TriangleMesh& mesh, int threads);
[[nodiscard]] TriangleGeometry compute_geometry(const TriangleMesh& mesh, int threads);
void compute_geometry(const TriangleMesh& mesh, int threads, TriangleGeometry& geometry);  ///< over what was there
[[nodiscard]] Bounds compute_bounds(const TriangleMesh& mesh, int threads);
[[nodiscard]] Bounds compute_used_bounds(const TriangleMesh& mesh, int threads);

}  // namespace partonomy
