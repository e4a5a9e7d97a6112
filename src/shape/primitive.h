#pragma once

#include <span>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

enum class SurfaceKind { flat, cylinder, sphere, cone, torus, freeform };

/// A surface that points were fitted with. What a field means depends on the kind.
struct Primitive {
    SurfaceKind kind = SurfaceKind::freeform;
    Vec3 point = Vec3::Zero();  ///< on the plane or the axis; the middle of a sphere or torus
    Vec3 axis = Vec3::UnitZ();  ///< unit: normal of a plane, axis of a cylinder, cone or torus
    double radius = 0;          ///< of a cylinder or sphere; of a cone at `point`; of a torus from axis to tube middle
    double slope = 0;           ///< of a cone: growth of its radius per length along `axis`; of a torus: tube radius
    double residual = 0;        ///< root mean square distance of the points, the farthest twentieth left out

    [[nodiscard]] double distance(const Vec3& point) const;  ///< from the surface, without sign; not for freeform
    [[nodiscard]] Vec3 normal(const Vec3& point) const;      ///< unit, on either side
};

/// Points on a surface, with unit normals, spread evenly by area.
struct PointSet {
    std::vector<Vec3> points, normals;
};

/// Every kind of primitive that can be fitted and whose normals are those of the points within 25 degrees on average.
/// Simple kinds first: flat, cylinder, sphere, cone, torus. At least 3 points.
[[nodiscard]] std::vector<Primitive> fit_primitives(const PointSet& set);

/// The residual up to which a primitive fits: a share of the root of the area, `size`, or of its radius where that is
/// small, and `noise`, which does not count.
[[nodiscard]] double tolerance(const Primitive& primitive, double size, double noise);

/// Root mean square distance of all points.
[[nodiscard]] double residual_of(const PointSet& set, const Primitive& primitive);

/// The simplest kind that fits hardly worse than the best one, and well enough; freeform when none does.
[[nodiscard]] Primitive fit_primitive(const PointSet& set, double size, double noise);

}  // namespace partonomy
