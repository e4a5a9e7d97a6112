#include "bench/embree_reference.h"

#include <embree3/rtcore.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <string>

#include "base/ranges.h"

namespace partonomy::bench {
namespace {

double ms_since(std::chrono::steady_clock::time_point start) {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

EmbreeTimes time_embree(const TriangleMesh& mesh, const TriangleGeometry& geometry, int threads) {
    EmbreeTimes times;
    const std::string config = "threads=" + std::to_string(threads) + ",set_affinity=0";
    RTCDevice device = rtcNewDevice(config.c_str());
    auto start = std::chrono::steady_clock::now();
    RTCScene scene = rtcNewScene(device);
    RTCGeometry triangles = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(
        triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, 3 * sizeof(float), mesh.positions.size()));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        for (int i = 0; i < 3; ++i)
            vertices[3 * v + static_cast<std::size_t>(i)] = static_cast<float>(mesh.positions[v][i]);
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(
        triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, 3 * sizeof(unsigned), mesh.triangles.size()));
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) indices[3 * t + i] = static_cast<unsigned>(mesh.triangles[t][i]);
    rtcCommitGeometry(triangles);
    rtcAttachGeometry(scene, triangles);
    rtcReleaseGeometry(triangles);
    rtcCommitScene(scene);
    times.build = ms_since(start);

    start = std::chrono::steady_clock::now();
    std::atomic<std::size_t> met = 0;
    for_each_range(mesh.triangles.size(), threads, [&](std::size_t begin, std::size_t end) {
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        std::size_t hits = 0;
        for (std::size_t t = begin; t < end; ++t) {
            RTCRayHit ray{};
            const Vec3& from = geometry.barycentres[t];
            const Vec3& normal = geometry.normals[t];
            ray.ray.org_x = static_cast<float>(from[0]);
            ray.ray.org_y = static_cast<float>(from[1]);
            ray.ray.org_z = static_cast<float>(from[2]);
            ray.ray.dir_x = static_cast<float>(-normal[0]);
            ray.ray.dir_y = static_cast<float>(-normal[1]);
            ray.ray.dir_z = static_cast<float>(-normal[2]);
            ray.ray.tnear = 1e-6F;
            ray.ray.tfar = std::numeric_limits<float>::infinity();
            ray.ray.mask = ~0U;
            ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
            rtcIntersect1(scene, &context, &ray);
            hits += ray.hit.geomID != RTC_INVALID_GEOMETRY_ID;
        }
        met += hits;
    });
    times.rays = ms_since(start);
    rtcReleaseScene(scene);
    rtcReleaseDevice(device);
    return met > 0 ? times : EmbreeTimes{};
}

}  // namespace partonomy::bench
