#pragma once

#include <cstdint>
#include <memory>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// A wall met by a ray from inside.
struct WallHit {
    float distance = 0;          ///< along the unit direction, in mesh units
    std::int32_t triangle = -1;  ///< -1 when the ray leaves without meeting a wall
};

/// The triangles of a mesh in Embree's tree, for rays that travel inside the solid.
class RayScene {
public:
    /// Builds the tree; threads <= 0: all cores. Hits are the same on any number of threads.
    explicit RayScene(const TriangleMesh& mesh, int threads = 1);
    ~RayScene();
    RayScene(const RayScene&) = delete;
    RayScene& operator=(const RayScene&) = delete;

    /// The first wall that the ray leaves the solid through: the triangle's front looks along `direction`. Walls met
    /// from outside and the triangle `self` that the ray starts on are passed. `direction` is a unit vector.
    /// Safe to call from several threads.
    [[nodiscard]] WallHit exit_wall(const Vec3& origin, const Vec3& direction, std::int32_t self = -1) const;

private:
    struct Tree;
    std::unique_ptr<Tree> tree;
};

}  // namespace partonomy
