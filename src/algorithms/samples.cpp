/* Points spread evenly over a region: what the measures of form look at.
 *
 * A box may have twelve triangles or twelve thousand, and noise may fold them; points at equal steps of area, on the
 * surface with its noise taken out, see the same shape in all of them. Of a fine mesh sharpen() takes it out, so that
 * six sides stay six; of a coarse one, or one of slivers, calm(), since its facets are no creases. Within a triangle
 * the points follow a sequence that fills it evenly. O(#T) for the calm surface, once an object; O(#T of the region)
 * for the points. */

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "algorithms/form.h"
#include "shape/calm.h"
#include "shape/sharpen.h"

namespace partonomy {
namespace {

constexpr int sample_count = 3000;
constexpr double too_rough = 20;   // degrees from triangle to triangle: creases drown in it
constexpr double left_over = 0.3;  // noise that smoothing leaves, of what it took

/// As scans have them: neighbours tell more of the surface than of how it was cut into facets.
bool has_small_even_triangles(const Object& object) {
    constexpr std::size_t least_count = 1000;
    constexpr double most_uneven = 5;  // square of the longest side over twice the area; 1.2 where all sides are alike
    double sum = 0, area = 0;
    for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t) {
        const auto& corners = object.mesh.triangles[t];
        double longest = 0;
        for (std::size_t i = 0; i < 3; ++i)
            longest = std::max(longest, (object.mesh.positions[static_cast<std::size_t>(corners[(i + 1) % 3])] -
                                         object.mesh.positions[static_cast<std::size_t>(corners[i])])
                                            .squaredNorm());
        sum += longest / 2;
        area += object.geometry.areas[t];
    }
    return object.mesh.triangles.size() >= least_count && sum <= most_uneven * area;
}

double noise_left(const TriangleMesh& before, const TriangleMesh& after) {
    double moved = 0;
    for (std::size_t v = 0; v < before.positions.size(); ++v)
        moved += (after.positions[v] - before.positions[v]).squaredNorm();
    return left_over * std::sqrt(moved / static_cast<double>(before.positions.size()));
}

SurfaceSamples take_samples(const CalmSurface& surface, const Object& object, std::span<const std::int32_t> triangles) {
    SurfaceSamples samples;
    samples.is_blurred = surface.is_blurred;
    double total = 0;
    for (const std::int32_t t : triangles) total += surface.geometry.areas[static_cast<std::size_t>(t)];
    if (!(total > 0)) return samples;
    const double step = total / sample_count;
    double next = step / 2, sum = 0, u = 0.5, v = 0.5;
    for (const std::int32_t t : triangles) {
        const auto at = static_cast<std::size_t>(t);
        sum += surface.geometry.areas[at];
        for (; next < sum; next += step) {
            // Steps by the plastic number's powers fill a square evenly; folding it makes a triangle.
            u = std::fmod(u + 0.7548776662466927, 1.0), v = std::fmod(v + 0.5698402909980532, 1.0);
            const double a = u + v > 1 ? 1 - u : u, b = u + v > 1 ? 1 - v : v;
            const auto place = [&](const TriangleMesh& mesh) -> Vec3 {
                const auto& corners = mesh.triangles[at];
                const Vec3& first = mesh.positions[static_cast<std::size_t>(corners[0])];
                return first + a * (mesh.positions[static_cast<std::size_t>(corners[1])] - first) +
                       b * (mesh.positions[static_cast<std::size_t>(corners[2])] - first);
            };
            samples.points.push_back(place(surface.mesh));
            samples.origins.push_back(place(object.mesh));
            samples.normals.push_back(surface.geometry.normals[at]);
        }
    }
    return samples;
}

}  // namespace

const CalmSurface& calm_surface(const Object& object) {
    if (object.calm) return *object.calm;
    auto surface = std::make_shared<CalmSurface>();
    surface->adjacency = build_adjacency(object.mesh);
    surface->geometry = object.geometry;
    surface->mesh = calm(object.mesh, surface->adjacency, surface->geometry).mesh;
    if (surface->mesh.triangles.empty())
        surface->mesh = object.mesh;
    else {
        surface->noise = noise_left(object.mesh, surface->mesh);
        surface->is_blurred = true;
    }
    object.calm = std::move(surface);
    return *object.calm;
}

const CalmSurface& surface_of(const Object& object, const RegionMeasurements& region) {
    constexpr std::size_t fine_enough = 500;  // of fewer triangles, facets and noise look alike
    if (region.triangles.size() < fine_enough) return calm_surface(object);
    if (object.sharp) return *object.sharp;
    static_cast<void>(calm_surface(object));
    object.sharp = object.calm;
    if (object.calm->noise > 0 && has_small_even_triangles(object)) {
        auto surface = std::make_shared<CalmSurface>(
            CalmSurface{object.mesh, object.geometry, object.calm->adjacency});  // its noise follows below
        if (roughness(surface->adjacency, surface->geometry) > too_rough)
            surface->mesh = calm(object.mesh, surface->adjacency, surface->geometry, 1, too_rough).mesh;
        sharpen(surface->mesh, surface->geometry);
        surface->noise = noise_left(object.mesh, surface->mesh);
        object.sharp = std::move(surface);
    }
    return *object.sharp;
}

const SurfaceSamples& samples_of(const Object& object, const RegionMeasurements& region) {
    if (!region.samples)
        region.samples =
            std::make_shared<const SurfaceSamples>(take_samples(surface_of(object, region), object, region.triangles));
    return *region.samples;
}

}  // namespace partonomy
