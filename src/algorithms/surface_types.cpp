/* What a region's surface is made of: planes, cylinders, spheres, cones, tori.
 *
 * The region is cut into patches (shape/patches.h), once, when a question needs it; the share of a kind is the area of
 * its patches over that of the region. A whole part has all of its sides: a long round stick is cylinder but for its
 * ends. A region that is one patch is of one kind altogether. How well the largest flat patch fills its smallest
 * rectangle and circle tells rectangles from discs: a square fills 0.64 of its circle, a disc 0.79 of its rectangle. */

#include <algorithm>
#include <array>

#include "algorithms/form.h"

namespace partonomy {
namespace {

PatchSurface surface_of(const Object& object) {
    const CalmSurface& calm = calm_surface(object);
    return {calm.mesh, calm.geometry, calm.adjacency, calm.noise};
}

double area_of(const std::vector<Patch>& patches) {
    double area = 0;
    for (const Patch& patch : patches) area += patch.area;
    return area;
}

}  // namespace

const std::vector<Patch>& patches_of(const Object& object, const RegionMeasurements& region) {
    if (!region.patches)
        region.patches = std::make_shared<const std::vector<Patch>>(find_patches(surface_of(object), region.triangles));
    return *region.patches;
}

double kind_share(const Object& object, const RegionMeasurements& region, SurfaceKind kind) {
    const std::vector<Patch>& patches = patches_of(object, region);
    double share = 0;
    for (const Patch& patch : patches)
        if (patch.primitive.kind == kind) share += patch.area;
    return share / area_of(patches);
}

double primitive_share(const Object& object, const RegionMeasurements& region) {
    double most = 0;
    for (const SurfaceKind kind :
         {SurfaceKind::flat, SurfaceKind::cylinder, SurfaceKind::sphere, SurfaceKind::cone, SurfaceKind::torus})
        most = std::max(most, kind_share(object, region, kind));
    return most;
}

Outline largest_outline(const Object& object, const RegionMeasurements& region) {
    const Patch* largest = nullptr;
    for (const Patch& patch : patches_of(object, region))
        if (patch.primitive.kind == SurfaceKind::flat && (!largest || patch.area > largest->area)) largest = &patch;
    return largest ? outline_of(surface_of(object), *largest) : Outline{};
}

}  // namespace partonomy
