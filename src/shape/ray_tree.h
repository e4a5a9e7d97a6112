#pragma once

#include <optional>

#include "mesh/triangle_mesh.h"

struct RTCSceneTy;  // Embree's

namespace partonomy {

/// The triangles of a mesh in Embree's tree. Embree works in single precision, so they are moved to the middle of their
/// bounding box and scaled to a diagonal of 1 first. Needs the mesh only while it is built.
class RayTree {
public:
    /// threads <= 0: all cores. Throws Error when Embree cannot start or there is not enough memory.
    explicit RayTree(const TriangleMesh& mesh, int threads = 1);
    ~RayTree();
    RayTree(const RayTree&) = delete;
    RayTree& operator=(const RayTree&) = delete;

    /// A point of the mesh as the tree has it.
    [[nodiscard]] Vec3 place(const Vec3& point) const { return (point - middle_) * scale_; }
    [[nodiscard]] double scale() const { return scale_; }  ///< tree units per mesh unit

    /// How far the first triangle is that a ray meets, from whichever side, in mesh units; the direction has length 1.
    [[nodiscard]] std::optional<double> first_hit(const Vec3& origin, const Vec3& direction) const;

    /// For rtcIntersect…; primitive i is triangle i.
    [[nodiscard]] RTCSceneTy* handle() const { return scene_; }

private:
    RTCSceneTy* scene_ = nullptr;
    Vec3 middle_ = Vec3::Zero();
    double scale_ = 1;
};

}  // namespace partonomy
