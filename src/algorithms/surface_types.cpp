/* What a region's surface is made of: planes, cylinders, spheres, cones, tori.
 *
 * The region is cut into patches (shape/patches.h), once, when a question needs it; the share of a kind is the area of
 * its patches over that of the region. Round patches count together when they are concentric: an egg is well fitted by
 * several tori, each a little different, and is none. What noise made another kind of patch counts where it lies on the
 * cylinder, cone or sphere all the same, as the tip of a long cone does. A whole part has all of its sides: a long
 * round stick is cylinder but for its ends. A region that is one patch is of one kind altogether. How well the largest
 * flat patch fills its smallest rectangle and circle tells rectangles from discs: a square fills 0.64 of its circle, a
 * disc 0.79 of its rectangle. How far a cylinder or cone goes round is the share of directions from its axis in which
 * triangles lie, so that facets of any width count whole: a hole has 360 degrees, a rounded corner 90. */

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "algorithms/form.h"

namespace partonomy {
namespace {

PatchSurface patch_surface(const Object& object, const RegionMeasurements& region) {
    const CalmSurface& calm = surface_of(object, region);
    return {calm.mesh, calm.geometry, calm.adjacency, calm.noise};
}

double area_of(const std::vector<Patch>& patches) {
    double area = 0;
    for (const Patch& patch : patches) area += patch.area;
    return area;
}

/// Whether two patches of one round kind have one axis or middle, as pieces of one cylinder and both sides of a pipe.
bool are_concentric(const Primitive& a, const Primitive& b) {
    constexpr double alike = 0.15;  // of the radius
    const double radius = std::max(a.radius, b.radius);
    const Vec3 way = b.point - a.point;
    if (a.kind == SurfaceKind::sphere) return way.norm() <= alike * radius;
    if (a.axis.cross(b.axis).norm() > alike) return false;
    if (a.kind != SurfaceKind::torus) return a.axis.cross(way).norm() <= alike * radius;
    return way.norm() <= alike * radius && std::abs(a.radius - b.radius) <= alike * radius &&
           std::abs(a.slope - b.slope) <= alike * a.slope;
}

/// Whether a curved patch of another kind lies on a cylinder, cone or sphere.
bool lies_on(const CalmSurface& calm, const Patch& patch, const Primitive& primitive) {
    constexpr double most_turned = 0.44;  // radians on average, as where primitives are fitted
    if (patch.primitive.kind == SurfaceKind::flat || primitive.kind == SurfaceKind::torus) return false;
    double squares = 0, turned = 0, area = 0;
    for (const std::int32_t triangle : patch.triangles) {
        const auto t = static_cast<std::size_t>(triangle);
        const Vec3& middle = calm.geometry.barycentres[t];
        const double distance = primitive.distance(middle);
        const double cosine = std::abs(primitive.normal(middle).dot(calm.geometry.normals[t]));
        area += calm.geometry.areas[t];
        squares += calm.geometry.areas[t] * distance * distance;
        turned += calm.geometry.areas[t] * std::acos(std::min(1.0, cosine));
    }
    return area > 0 && turned <= most_turned * area &&
           std::sqrt(squares / area) <= 2 * tolerance(primitive, std::sqrt(patch.area), calm.noise);
}

}  // namespace

const std::vector<Patch>& patches_of(const Object& object, const RegionMeasurements& region) {
    if (!region.patches)
        region.patches =
            std::make_shared<const std::vector<Patch>>(find_patches(patch_surface(object, region), region.triangles));
    return *region.patches;
}

double kind_share(const Object& object, const RegionMeasurements& region, SurfaceKind kind) {
    const std::vector<Patch>& patches = patches_of(object, region);
    double largest = 0;
    for (const Patch& patch : patches) {
        if (patch.primitive.kind != kind) continue;
        double area = 0;
        for (const Patch& other : patches)
            if (other.primitive.kind != kind
                    ? kind != SurfaceKind::flat && lies_on(surface_of(object, region), other, patch.primitive)
                    : kind == SurfaceKind::flat || are_concentric(patch.primitive, other.primitive))
                area += other.area;
        largest = std::max(largest, area);
    }
    return largest / area_of(patches);
}

double primitive_share(const Object& object, const RegionMeasurements& region) {
    double most = 0;
    for (const SurfaceKind kind :
         {SurfaceKind::flat, SurfaceKind::cylinder, SurfaceKind::sphere, SurfaceKind::cone, SurfaceKind::torus})
        most = std::max(most, kind_share(object, region, kind));
    return most;
}

double arc(const Object& object, const RegionMeasurements& region) {
    constexpr int directions = 720;
    const auto is_round = [](const Patch& patch) {
        return patch.primitive.kind == SurfaceKind::cylinder || patch.primitive.kind == SurfaceKind::cone;
    };
    const Patch* largest = nullptr;
    for (const Patch& patch : patches_of(object, region))
        if (is_round(patch) && (!largest || patch.area > largest->area)) largest = &patch;
    if (!largest) return 0;
    const TriangleMesh& mesh = surface_of(object, region).mesh;
    const Vec3 axis = largest->primitive.axis, x = axis.unitOrthogonal(), y = axis.cross(x);
    const auto direction_of = [&](std::int32_t vertex) {
        const Vec3 way = mesh.positions[static_cast<std::size_t>(vertex)] - largest->primitive.point;
        return std::atan2(way.dot(y), way.dot(x)) / (2 * std::numbers::pi) * directions;
    };
    std::array<bool, directions> is_met{};
    for (const Patch& patch : patches_of(object, region)) {
        if (&patch != largest &&
            !(patch.primitive.kind == largest->primitive.kind && are_concentric(largest->primitive, patch.primitive)))
            continue;
        for (const std::int32_t triangle : patch.triangles) {
            const auto& corners = mesh.triangles[static_cast<std::size_t>(triangle)];
            for (std::size_t e = 0; e < 3; ++e) {
                const double from = direction_of(corners[e]);
                const double way = std::remainder(direction_of(corners[(e + 1) % 3]) - from, directions);
                const int steps = static_cast<int>(std::ceil(std::abs(way)));
                for (int i = 0; i < steps; ++i) {
                    const double at = from + way * (i + 0.5) / steps;
                    is_met[static_cast<std::size_t>(std::floor(at - directions * std::floor(at / directions))) %
                           directions] = true;
                }
            }
        }
    }
    return 360.0 / directions * static_cast<double>(std::ranges::count(is_met, true));
}

Outline largest_outline(const Object& object, const RegionMeasurements& region) {
    const Patch* largest = nullptr;
    for (const Patch& patch : patches_of(object, region))
        if (patch.primitive.kind == SurfaceKind::flat && (!largest || patch.area > largest->area)) largest = &patch;
    return largest ? outline_of(patch_surface(object, region), *largest) : Outline{};
}

}  // namespace partonomy
