#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "shape/oriented_box.h"
#include "shape/ray_tree.h"
#include "shape/region.h"

namespace partonomy {

/// A part as `is a` judges it.
struct PartRegion {
    Region region;
    OrientedBox box;  ///< the smallest; on a noisy mesh from wall to wall, not from one outermost point to another
    double fit = 1;   ///< mean fitting score of the triangles, in [0, 1] (paper §6.4, Table 4)
    bool is_noisy = false;  ///< whether the mesh is so rough that it had to be calmed
};

struct FindPartsOptions {
    Vec3 up = Vec3::UnitZ();
    int threads = 1;
    std::shared_ptr<const RayTree> tree = nullptr;  ///< of the mesh, where there is one already
    bool is_scene = false;  ///< many things that stand on or beside one another: each is cut for itself
    bool is_joined = true;  ///< false: parts that continue each other stay apart, for whoever mends a cut
};

/// What find_parts spends its time on, in milliseconds, in the order of work.
using StageTimes = std::vector<std::pair<std::string, double>>;

/// Cuts a mesh into board-, stick- and cube-like regions: `find all` of paper §6.4. Each triangle is in at most one
/// region; regions are connected, sorted by their lowest triangle, and nearly all of the surface is covered.
/// The result does not depend on the order of the triangles, on their subdivision, or on the number of threads.
[[nodiscard]] std::vector<PartRegion> find_parts(const TriangleMesh& mesh, const FindPartsOptions& options = {},
                                                 StageTimes* times = nullptr);

}  // namespace partonomy
