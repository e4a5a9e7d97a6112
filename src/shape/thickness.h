#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "shape/ray_scene.h"

namespace partonomy {

/// What one inward ray per triangle meets (paper §6.4): the simplified shape diameter function.
struct Thickness {
    std::vector<float> distances;         ///< #T from the barycentre to the opposite wall; infinity when nothing is met
    std::vector<std::int32_t> opposites;  ///< #T triangle met, or -1
};

/// Shoots from each barycentre against the normal, by Embree. A hit counts when it meets a wall from inside.
/// threads <= 0: all cores. Same result on any number of threads.
[[nodiscard]] Thickness measure_thickness(const TriangleMesh& mesh, const TriangleGeometry& geometry, int threads = 1);

/// The same with a tree that is already there.
[[nodiscard]] Thickness measure_thickness(const RayScene& scene, const TriangleGeometry& geometry, int threads = 1);

}  // namespace partonomy
