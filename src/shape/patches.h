#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "shape/primitive.h"

namespace partonomy {

/// A connected piece of a surface that is a plane, cylinder, sphere, cone or torus, or none of these.
struct Patch {
    std::vector<std::int32_t> triangles;  ///< ascending
    Primitive primitive;
    double area = 0;
};

/// A surface to be cut into patches. All must outlive the call.
struct PatchSurface {
    const TriangleMesh& mesh;  ///< noise taken out (calm.h)
    const TriangleGeometry& geometry;
    const Adjacency& adjacency;
    double noise = 0;  ///< how far the surface still is from what it was before the noise, in units of the mesh
};

/// Cuts triangles of a surface (ascending) into patches, in the order of their lowest triangle. Each of the triangles
/// is in one patch. O(n log n) for n triangles.
[[nodiscard]] std::vector<Patch> find_patches(const PatchSurface& surface, std::span<const std::int32_t> triangles);

/// How well a flat patch fills its smallest rectangle and its smallest circle, holes filled; 0 when it is not flat.
struct Outline {
    double rectangle = 0, disc = 0;
};
[[nodiscard]] Outline outline_of(const PatchSurface& surface, const Patch& patch);

}  // namespace partonomy
