#pragma once

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// A rough mesh with its noise taken out.
struct Calming {
    TriangleMesh mesh;        ///< the same triangles, vertices moved; empty when the mesh was clean
    double grain = 0;         ///< small pieces thinner than this may be folds of noise; 0 when the mesh was clean
    bool is_blurred = false;  ///< so rough that sharp creases are spread over some triangles now
};

/// Moves the vertices of a rough mesh to where the surface was before the noise, about. `geometry` becomes that of the
/// calmed mesh; with a clean mesh it stays. threads <= 0: all cores; same result on any number. It is calm once its
/// roughness is below `calm_degrees`.
[[nodiscard]] Calming calm(const TriangleMesh& mesh, const Adjacency& adjacency, TriangleGeometry& geometry,
                           int threads = 1, double calm_degrees = 3);

/// How far neighbouring triangles turn to and fro, in degrees: half of the triangles have both a convex and a concave
/// edge of at least so much. Flat, cylindrical and creased surfaces have none of it, whatever their triangles.
[[nodiscard]] double roughness(const Adjacency& adjacency, const TriangleGeometry& geometry, int threads = 1);

}  // namespace partonomy
