#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "shape/ray_tree.h"
#include "shape/refine.h"

namespace partonomy {

/// A wall met by a ray from inside.
struct WallHit {
    float distance = 0;          ///< along the unit direction, in mesh units
    std::int32_t triangle = -1;  ///< -1 when the ray leaves without meeting a wall
};

/// A ray inside the solid.
struct InnerRay {
    Vec3 origin, direction;  ///< of unit length
    std::int32_t self = -1;  ///< triangle that it starts on and passes, -1 for none
    std::int32_t near = -1;  ///< without self: a triangle of the solid that it travels in, -1 when that is not known
};

/// Rays that travel inside the solid that a mesh bounds.
class RayScene {
public:
    /// Builds the tree; threads <= 0: all cores. Hits are the same on any number of threads. The mesh must outlive
    /// this.
    explicit RayScene(const TriangleMesh& mesh, int threads = 1);
    /// With a tree of the mesh that is already there (or nullptr), and a refinement (or nullptr): rays meet the few
    /// large triangles of `mesh`, but `self` and hits are told in the small ones of the refinement, which must outlive
    /// this.
    RayScene(const TriangleMesh& mesh, std::shared_ptr<const RayTree> tree, const Refinement* refinement, int threads);

    /// Tells solids apart: a number for each triangle of the mesh, -1 where it bounds no solid of its own. A ray in one
    /// solid passes the walls of others, as the end of a handle does that reaches into the wall of a mug.
    void tell_apart(std::vector<std::int32_t> solids) { solids_ = std::move(solids); }

    /// The first wall that the ray leaves the solid through: the triangle's front looks along `direction`. Walls met
    /// from outside and the triangle that the ray starts on are passed.
    /// Safe to call from several threads.
    [[nodiscard]] WallHit exit_wall(const InnerRay& ray) const;

    /// exit_wall for up to 16 rays that are near each other, in a third of the time. `hits` has the size of `rays`.
    void exit_walls(std::span<const InnerRay> rays, std::span<WallHit> hits) const;

private:
    /// What the ray's hit on triangle `met` is to the caller; nullopt for a wall to pass.
    struct Met;
    [[nodiscard]] std::optional<WallHit> judge(const InnerRay& ray, const Met& met) const;
    const TriangleMesh& mesh_;
    std::shared_ptr<const RayTree> tree_;
    const Refinement* refinement_;
    std::vector<std::int32_t> solids_;  ///< empty: one for all
};

}  // namespace partonomy
