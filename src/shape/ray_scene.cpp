// Rays inside the solid, by Embree.
//
// Embree works in single precision, so the mesh is moved to the middle of its bounding box and scaled to unit size
// first; the distance of a hit is computed again in double precision from the plane of the triangle that was met. Rays
// that meet a wall from its outer side (shells that overlap, or the surface next to the start when normals are
// smoothed) go on behind it. A tree of medium quality is what "build + one ray per triangle" costs least with: on
// 75,520 triangles the low quality saves 10 ms of building and loses it again in rays.

#include "shape/ray_scene.h"

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

namespace partonomy {

namespace {

constexpr int max_passed_walls = 64;    // a ray that passes more walls than this from outside is lost, not endless
constexpr float self_distance = 1e-6F;  // of the mesh size: nearer hits of a ray that starts on a wall are that wall

/// One device for the whole process: making one costs as much as the tree of a small mesh. Embree limits all of TBB to the
/// threads of its devices, so one that builds on a single thread is made only when nothing else may use more.
RTCDevice device(int threads) {
    static const RTCDevice shared = rtcNewDevice(threads == 1 ? "threads=1,set_affinity=0" : "set_affinity=0");
    return shared;
}

}  // namespace

struct RayScene::Tree {
    RTCScene scene = nullptr;
    const TriangleMesh* mesh = nullptr;
    Vec3 centre = Vec3::Zero();
    double scale = 1;  // mesh units -> Embree units
};

RayScene::RayScene(const TriangleMesh& mesh, int threads) : tree(std::make_unique<Tree>()) {
    const Bounds bounds = compute_bounds(mesh);
    tree->mesh = &mesh;
    tree->centre = (bounds.low + bounds.high) / 2;
    tree->scale = bounds.diagonal() > 0 ? 1 / bounds.diagonal() : 1;
    tree->scene = rtcNewScene(device(threads));
    rtcSetSceneFlags(tree->scene, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(tree->scene, RTC_BUILD_QUALITY_MEDIUM);
    RTCGeometry geometry = rtcNewGeometry(device(threads), RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* points = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                               3 * sizeof(float), mesh.positions.size()));
    for (const Vec3& position : mesh.positions) {
        const Vec3 p = (position - tree->centre) * tree->scale;
        for (int k = 0; k < 3; ++k) *points++ = static_cast<float>(p[k]);
    }
    auto* corners = static_cast<std::uint32_t*>(rtcSetNewGeometryBuffer(
        geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(std::uint32_t), mesh.triangles.size()));
    for (const auto& triangle : mesh.triangles)
        for (const std::int32_t corner : triangle) *corners++ = static_cast<std::uint32_t>(corner);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(tree->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(tree->scene);
}

RayScene::~RayScene() { rtcReleaseScene(tree->scene); }

WallHit RayScene::exit_wall(const Vec3& origin, const Vec3& direction, std::int32_t self) const {
    const Vec3 start = (origin - tree->centre) * tree->scale;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    float near = self >= 0 ? self_distance : 0;
    for (int passed = 0; passed < max_passed_walls; ++passed) {
        RTCRayHit ray{};
        ray.ray.org_x = static_cast<float>(start.x());
        ray.ray.org_y = static_cast<float>(start.y());
        ray.ray.org_z = static_cast<float>(start.z());
        ray.ray.dir_x = static_cast<float>(direction.x());
        ray.ray.dir_y = static_cast<float>(direction.y());
        ray.ray.dir_z = static_cast<float>(direction.z());
        ray.ray.tnear = near;
        ray.ray.tfar = std::numeric_limits<float>::infinity();
        ray.ray.mask = ~0U;
        ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(tree->scene, &context, &ray);
        if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID) return {std::numeric_limits<float>::infinity(), -1};
        const auto met = static_cast<std::int32_t>(ray.hit.primID);
        const auto& triangle = tree->mesh->triangles[met];
        const Vec3& a = tree->mesh->positions[triangle[0]];
        const Vec3 normal = (tree->mesh->positions[triangle[1]] - a).cross(tree->mesh->positions[triangle[2]] - a);
        const double along = normal.dot(direction);
        if (met != self && along > 0) {
            const double exact = normal.dot(a - origin) / along;
            const double rough = static_cast<double>(ray.ray.tfar) / tree->scale;
            // A wall that is nearly parallel to the ray has no exact crossing with its plane.
            const bool usable = along > 1e-3 * normal.norm() && exact >= 0;
            return {static_cast<float>(usable ? exact : rough), met};
        }
        near = std::nextafter(ray.ray.tfar * 1.000001F, std::numeric_limits<float>::infinity());
    }
    return {std::numeric_limits<float>::infinity(), -1};
}

}  // namespace partonomy
