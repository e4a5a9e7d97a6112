#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "algorithms/object.h"

namespace partonomy {

class TriangleTree;

/// What relations look at in the object as a whole: an upright frame of its own, so that answers turn with the object.
struct Scene {
    const Object* object = nullptr;  ///< must outlive this
    Eigen::Matrix3d frame;           ///< rows: the object's sides (its mirror plane, or the smallest upright box), up
    Vec3 low, high;                  ///< that box, in the frame
    double diagonal = 0;             ///< of that box
    /// Unit vector in the frame, to the side that the object faces; nullopt where its shape does not tell.
    std::optional<Vec3> front;
    [[nodiscard]] double height() const { return high.z() - low.z(); }
};
[[nodiscard]] Scene scene_of(const Object& object);

/// What relations look at in one region: T and TF read it, so it is made once. All coordinates are in the scene's
/// frame.
struct RegionPlace {
    const PartRegion* part = nullptr;  ///< must outlive this
    Vec3 low, high;                    ///< box along the frame's axes; the third coordinate is along up
    double area = 0;
    Vec3 centre;             ///< mean of the surface
    Eigen::Matrix3d spread;  ///< second moments of the surface about that mean, over its area
    /// Its triangles, sorted into boxes; made when a distance is asked for the first time.
    mutable std::shared_ptr<const TriangleTree> triangles;
    /// Corners of what it covers seen from above, counter-clockwise; made when relation_plan.cpp asks for the first
    /// time.
    mutable std::vector<Eigen::Vector2d> outline;
    [[nodiscard]] Vec3 middle() const { return (low + high) / 2; }
};
[[nodiscard]] RegionPlace place_of(const Scene& scene, const PartRegion& part);

/// Corners of a triangle in the scene's frame.
[[nodiscard]] std::array<Vec3, 3> corners_of(const Scene& scene, std::int32_t triangle);

}  // namespace partonomy
