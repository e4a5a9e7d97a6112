/* Points spread evenly over a region: what the measures of form look at.
 *
 * A box may have twelve triangles or twelve thousand, and noise may fold them; points at equal steps of area, on the
 * surface that calm() leaves, see the same shape in all of them. Within a triangle the points follow a sequence that
 * fills it evenly. O(#T) for the calm surface, once an object; O(#T of the region) for the points. */

#include <Eigen/Geometry>
#include <cmath>

#include "algorithms/form.h"
#include "shape/calm.h"

namespace partonomy {
namespace {

constexpr int sample_count = 3000;
constexpr double left_over = 0.3;  // noise that smoothing leaves, of what it took

SurfaceSamples take_samples(const CalmSurface& surface, const Object& object, std::span<const std::int32_t> triangles) {
    SurfaceSamples samples;
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
    Calming calming = calm(object.mesh, surface->adjacency, surface->geometry);
    if (calming.mesh.triangles.empty()) {
        surface->mesh = object.mesh;
    } else {
        surface->mesh = std::move(calming.mesh);
        double moved = 0;
        for (std::size_t v = 0; v < object.mesh.positions.size(); ++v)
            moved += (surface->mesh.positions[v] - object.mesh.positions[v]).squaredNorm();
        surface->noise = left_over * std::sqrt(moved / static_cast<double>(object.mesh.positions.size()));
    }
    object.calm = std::move(surface);
    return *object.calm;
}

const SurfaceSamples& samples_of(const Object& object, const RegionMeasurements& region) {
    if (!region.samples)
        region.samples =
            std::make_shared<const SurfaceSamples>(take_samples(calm_surface(object), object, region.triangles));
    return *region.samples;
}

}  // namespace partonomy
