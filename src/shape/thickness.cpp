// One inward ray per triangle: the simplified shape diameter function of paper §6.4.
//
// Rays start on the surface itself. The triangle they start on is passed by its number and neighbours are passed
// because the ray meets them from outside or not at all, so no offset has to be guessed.

#include "shape/thickness.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/ranges.h"

namespace partonomy {

namespace {

constexpr std::size_t packet = 16;  // triangles that follow each other are mostly near each other

}  // namespace

Thickness measure_thickness(const TriangleMesh& mesh, const TriangleGeometry& geometry, int threads) {
    return measure_thickness(RayScene(mesh, threads), geometry, threads);
}

Thickness measure_thickness(const RayScene& scene, const TriangleGeometry& geometry, int threads) {
    const std::size_t count = geometry.normals.size();
    Thickness thickness;
    thickness.distances.resize(count);
    thickness.opposites.resize(count);
    // Packets begin at multiples of their size, so that they hold the same rays on any number of threads.
    for_each_range(
        (count + packet - 1) / packet, threads,
        [&](std::size_t begin, std::size_t end) {
            std::array<InnerRay, packet> rays;
            std::array<WallHit, packet> hits;
            for (std::size_t p = begin; p < end; ++p) {
                const std::size_t first = p * packet, last = std::min(count, first + packet);
                std::size_t shot = 0;
                for (std::size_t i = first; i < last; ++i)
                    if (geometry.areas[i] > 0)
                        rays[shot++] = {geometry.barycentres[i], -geometry.normals[i], static_cast<std::int32_t>(i)};
                scene.exit_walls({rays.data(), shot}, {hits.data(), shot});
                shot = 0;
                for (std::size_t i = first; i < last; ++i) {
                    const WallHit hit =
                        geometry.areas[i] > 0 ? hits[shot++] : WallHit{std::numeric_limits<float>::infinity(), -1};
                    thickness.distances[i] = hit.distance;
                    thickness.opposites[i] = hit.triangle;
                }
            }
        },
        128);
    return thickness;
}

}  // namespace partonomy
