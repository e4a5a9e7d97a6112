#pragma once

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// Moves the vertices of a rough mesh to where the surface was before the noise, about; triangles stay as they are.
/// `geometry` is brought up to date. Returns the thickness below which noise may hide everything; 0 when the mesh was
/// clean and is unchanged.
double calm(TriangleMesh& mesh, const Adjacency& adjacency, TriangleGeometry& geometry);

/// How far neighbouring triangles turn to and fro, in degrees: half of the triangles have both a convex and a concave
/// edge of at least so much. Flat, cylindrical and creased surfaces have none of it, whatever their triangles.
[[nodiscard]] double roughness(const Adjacency& adjacency, const TriangleGeometry& geometry);

}  // namespace partonomy
