// One inward ray per triangle: the simplified shape diameter function of paper §6.4.
//
// Rays start on the surface itself. The triangle they start on is passed by its number and neighbours are passed
// because the ray meets them from outside or not at all, so no offset has to be guessed.

#include "shape/thickness.h"

#include <limits>

#include "shape/ranges.h"

namespace partonomy {

Thickness measure_thickness(const TriangleMesh& mesh, const TriangleGeometry& geometry, int threads) {
    return measure_thickness(RayScene(mesh, threads), geometry, threads);
}

Thickness measure_thickness(const RayScene& scene, const TriangleGeometry& geometry, int threads) {
    const std::size_t count = geometry.normals.size();
    Thickness thickness;
    thickness.distances.resize(count);
    thickness.opposites.resize(count);
    for_each_range(count, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const WallHit hit =
                geometry.areas[i] > 0
                    ? scene.exit_wall({geometry.barycentres[i], -geometry.normals[i], static_cast<std::int32_t>(i)})
                    : WallHit{std::numeric_limits<float>::infinity(), -1};
            thickness.distances[i] = hit.distance;
            thickness.opposites[i] = hit.triangle;
        }
    });
    return thickness;
}

}  // namespace partonomy
