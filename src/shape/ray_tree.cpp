// A tree of medium quality is what "build + one ray per triangle" costs least with: on 75,520 triangles the low quality
// saves 10 ms of building and loses it again in rays. Robust traversal leaves no pinholes along shared edges.

#include "shape/ray_tree.h"

#include <embree3/rtcore.h>

#include <string>

#include "base/errors.h"
#include "base/ranges.h"
#include "mesh/parallel.h"

namespace partonomy {

namespace {

/// One device for the whole process: making one costs as much as the tree of a small mesh. Embree limits all of TBB to
/// the threads of its devices, so one that builds on a single thread is made only when nothing else may use more. The
/// cache is for subdivision surfaces, which no mesh of ours has.
RTCDevice device(int threads) {
    static const RTCDevice shared = rtcNewDevice(threads == 1 ? "threads=1,set_affinity=0,tessellation_cache_size=0"
                                                              : "set_affinity=0,tessellation_cache_size=0");
    if (shared == nullptr)
        throw Error("Embree cannot start (error " + std::to_string(static_cast<int>(rtcGetDeviceError(nullptr))) +
                    "), so no ray can be shot");
    return shared;
}

}  // namespace

RayTree::RayTree(const TriangleMesh& mesh, int threads) {
    if (!mesh.triangles.empty()) {
        const Bounds bounds = compute_used_bounds(mesh, threads);
        middle_ = bounds.middle();
        const double diagonal = (bounds.high / 2 - bounds.low / 2).stableNorm() * 2;
        if (diagonal > 0) scale_ = 1 / diagonal;
    }
    RTCGeometry geometry = rtcNewGeometry(device(threads), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), mesh.positions.size()));
    auto* corners = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles.size()));
    if ((points == nullptr && !mesh.positions.empty()) || (corners == nullptr && !mesh.triangles.empty())) {
        rtcReleaseGeometry(geometry);
        throw Error("there is not enough memory for the rays' tree over " + std::to_string(mesh.triangles.size()) +
                    " triangles");
    }
    for_each_range(mesh.positions.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const Vec3 p = place(mesh.positions[v]);
            for (std::size_t k = 0; k < 3; ++k) points[3 * v + k] = static_cast<float>(p[k]);
        }
    });
    for_each_range(mesh.triangles.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t)
            for (std::size_t k = 0; k < 3; ++k) corners[3 * t + k] = static_cast<std::uint32_t>(mesh.triangles[t][k]);
    });
    rtcCommitGeometry(geometry);
    scene_ = rtcNewScene(device(threads));
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(scene_, RTC_BUILD_QUALITY_MEDIUM);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
}

RayTree::~RayTree() { rtcReleaseScene(scene_); }

std::optional<double> RayTree::first_hit(const Vec3& origin, const Vec3& direction) const {
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    const Vec3 from = place(origin);
    RTCRayHit ray{};
    ray.ray.org_x = static_cast<float>(from[0]);
    ray.ray.org_y = static_cast<float>(from[1]);
    ray.ray.org_z = static_cast<float>(from[2]);
    ray.ray.dir_x = static_cast<float>(direction[0]);
    ray.ray.dir_y = static_cast<float>(direction[1]);
    ray.ray.dir_z = static_cast<float>(direction[2]);
    ray.ray.tfar = std::numeric_limits<float>::infinity();
    ray.ray.mask = ~0U;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    rtcIntersect1(scene_, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
    return static_cast<double>(ray.ray.tfar) / scale_;
}

}  // namespace partonomy
