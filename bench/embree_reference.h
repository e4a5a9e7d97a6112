#pragma once

#include "mesh/triangle_mesh.h"

namespace partonomy::bench {

/// Milliseconds that Embree alone needs on a mesh.
struct EmbreeTimes {
    double build = 0;  ///< its tree, medium quality (Embree's default)
    double rays = 0;   ///< one inward ray per triangle, one at a time
    [[nodiscard]] double total() const { return build + rays; }
};

/// The unavoidable cost of a thickness for each triangle: what our times are compared with. On more than one thread it
/// shows what the machine gives to work that has hardly a serial part.
[[nodiscard]] EmbreeTimes time_embree(const TriangleMesh& mesh, const TriangleGeometry& geometry, int threads = 1);

}  // namespace partonomy::bench
