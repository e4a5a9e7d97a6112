#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "shape/ray_scene.h"
#include "shape/thickness.h"

namespace partonomy {

/// What find_parts works on: the caller's surface, cut finer where its triangles are large, so that a box of 12
/// triangles and the same box of 12,000 look alike. Measurements are per fine triangle.
struct Surface {
    explicit Surface(const TriangleMesh& fine) : mesh(fine) {}

    const TriangleMesh& mesh;  ///< fine, and calm where the caller's is rough
    Adjacency adjacency;
    TriangleGeometry geometry;
    Thickness thickness;
    std::vector<char> creases;  ///< triangles in concave creases, where noise was taken out; empty for a clean mesh
    std::unique_ptr<RayScene> scene;  ///< the caller's triangles; hits are told in fine ones
    int threads = 1;                  ///< to use; <= 0: all cores
    double size = 0;                  ///< diagonal of the bounding box
    double grain = 0;                 ///< small pieces thinner than this may be folds of noise; 0 for a clean mesh

    [[nodiscard]] std::size_t count() const { return mesh.triangles.size(); }
    [[nodiscard]] bool in_crease(std::size_t i) const { return !creases.empty() && creases[i]; }
};

/// The triangles in concave creases, also where a crease is spread over some triangles.
[[nodiscard]] std::vector<char> find_creases(const Surface& surface);

}  // namespace partonomy
