#include "report/picture_rays.h"

#include <embree3/rtcore.h>

#include <limits>

namespace partonomy {

PictureRays::PictureRays(const TriangleMesh& mesh, const RayTree* tree)
    : own_(tree ? nullptr : std::make_unique<const RayTree>(mesh)), tree_(tree ? tree : own_.get()) {}

void PictureRays::cast(const Camera& camera, RayPacket& packet) const {
    const Vec3 corner = -camera.right * (camera.center_x / camera.scale) -
                        camera.down * (camera.center_y / camera.scale) -
                        2 * camera.into;  // everything is within 1/2 of the middle
    const Eigen::Vector3f start = corner.cast<float>(), into = camera.into.cast<float>();
    const Eigen::Vector3f right = (camera.right / camera.scale).cast<float>();
    const Eigen::Vector3f down = (camera.down / camera.scale).cast<float>();
    RTCRayHit16 rays;
    alignas(64) std::array<int, RayPacket::size> valid;
    for (std::size_t i = 0; i < RayPacket::size; ++i) {
        const float x = packet.x[i], y = packet.y[i];
        valid[i] = -1;
        rays.ray.org_x[i] = start.x() + x * right.x() + y * down.x();
        rays.ray.org_y[i] = start.y() + x * right.y() + y * down.y();
        rays.ray.org_z[i] = start.z() + x * right.z() + y * down.z();
        rays.ray.dir_x[i] = into.x();
        rays.ray.dir_y[i] = into.y();
        rays.ray.dir_z[i] = into.z();
        rays.ray.tnear[i] = 0;
        rays.ray.tfar[i] = std::numeric_limits<float>::infinity();
        rays.ray.time[i] = 0;
        rays.ray.mask[i] = ~0U;
        rays.ray.id[i] = 0;
        rays.ray.flags[i] = 0;
        rays.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        rays.hit.primID[i] = RTC_INVALID_GEOMETRY_ID;
        rays.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid.data(), tree_->handle(), &context, &rays);
    for (std::size_t i = 0; i < RayPacket::size; ++i)
        packet.triangle[i] =
            rays.hit.geomID[i] == RTC_INVALID_GEOMETRY_ID ? -1 : static_cast<std::int32_t>(rays.hit.primID[i]);
}

}  // namespace partonomy
