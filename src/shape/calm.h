#pragma once

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// What was done to a rough mesh.
struct Calming {
    double grain = 0;         ///< small pieces thinner than this may be folds of noise; 0 when the mesh was clean
    bool is_blurred = false;  ///< so rough that sharp creases are spread over some triangles now
};

/// Moves the vertices of a rough mesh to where the surface was before the noise, about; triangles stay as they are.
/// `geometry` is brought up to date. A clean mesh is left unchanged.
Calming calm(TriangleMesh& mesh, const Adjacency& adjacency, TriangleGeometry& geometry);

/// How far neighbouring triangles turn to and fro, in degrees: half of the triangles have both a convex and a concave
/// edge of at least so much. Flat, cylindrical and creased surfaces have none of it, whatever their triangles.
[[nodiscard]] double roughness(const Adjacency& adjacency, const TriangleGeometry& geometry);

}  // namespace partonomy
