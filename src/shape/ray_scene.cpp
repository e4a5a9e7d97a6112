// Rays inside the solid, by Embree.
//
// Embree says which triangle is met; the distance is computed again in double precision from that triangle's plane.
// Rays that meet a wall from its outer side (shells that overlap, or the surface next to the start when normals are
// smoothed) go on behind it.

#include "shape/ray_scene.h"

#include <embree3/rtcore.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace partonomy {

namespace {

constexpr int max_passed_walls = 64;    // a ray that passes more walls than this from outside is lost, not endless
constexpr float self_distance = 1e-6F;  // of the mesh size: nearer hits of a ray that starts on a wall are that wall

constexpr float infinity = std::numeric_limits<float>::infinity();

/// Where a ray begins to see: not on the triangle that it starts on.
float first_distance(const InnerRay& ray) { return ray.self >= 0 ? self_distance : 0; }

float just_behind(float distance) { return std::nextafter(distance * 1.000001F, infinity); }

}  // namespace

RayScene::RayScene(const TriangleMesh& mesh, int threads) : RayScene(mesh, nullptr, nullptr, threads) {}

RayScene::RayScene(const TriangleMesh& mesh, std::shared_ptr<const RayTree> tree, const Refinement* refinement,
                   int threads)
    : mesh_(mesh),
      tree_(tree ? std::move(tree) : std::make_shared<const RayTree>(mesh, threads)),
      refinement_(refinement && !refinement->rounds.empty() ? refinement : nullptr) {}

struct RayScene::Met {
    std::int32_t triangle;
    float distance, u, v;  // as Embree measures
};

std::optional<WallHit> RayScene::judge(const InnerRay& ray, const Met& met) const {
    const auto caller = [&](std::int32_t i) { return refinement_ && i >= 0 ? refinement_->mesh.input_faces[i] : i; };
    const std::int32_t self = caller(ray.self);
    if (met.triangle == self) return std::nullopt;
    if (const std::int32_t start = self >= 0 ? self : caller(ray.near); !solids_.empty() && start >= 0) {
        const std::int32_t own = solids_[start], other = solids_[met.triangle];
        if (own >= 0 && other >= 0 && own != other) return std::nullopt;
    }
    const auto& triangle = mesh_.triangles[met.triangle];
    const Vec3& a = mesh_.positions[triangle[0]];
    const Vec3 normal = (mesh_.positions[triangle[1]] - a).cross(mesh_.positions[triangle[2]] - a);
    const double along = normal.dot(ray.direction);
    if (along <= 0) return std::nullopt;
    // A wall that is nearly parallel to the ray has no exact crossing with its plane.
    const double exact = normal.dot(a - ray.origin) / along;
    const bool is_usable = along * along > 1e-6 * normal.squaredNorm() && exact >= 0;
    const double distance = is_usable ? exact : static_cast<double>(met.distance) / tree_->scale();
    const auto u = static_cast<double>(met.u), v = static_cast<double>(met.v);
    return WallHit{static_cast<float>(distance),
                   refinement_ ? refinement_->piece_at(met.triangle, u, v) : met.triangle};
}

WallHit RayScene::exit_wall(const InnerRay& ray) const {
    const Eigen::Vector3f start = tree_->place(ray.origin).cast<float>(), direction = ray.direction.cast<float>();
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    float near = first_distance(ray);
    for (int passed = 0; passed < max_passed_walls; ++passed) {
        RTCRayHit shot{};
        shot.ray.org_x = start.x();
        shot.ray.org_y = start.y();
        shot.ray.org_z = start.z();
        shot.ray.dir_x = direction.x();
        shot.ray.dir_y = direction.y();
        shot.ray.dir_z = direction.z();
        shot.ray.tnear = near;
        shot.ray.tfar = infinity;
        shot.ray.mask = ~0U;
        shot.hit.geomID = RTC_INVALID_GEOMETRY_ID;
        rtcIntersect1(tree_->handle(), &context, &shot);
        if (shot.hit.geomID == RTC_INVALID_GEOMETRY_ID) break;
        const Met met{static_cast<std::int32_t>(shot.hit.primID), shot.ray.tfar, shot.hit.u, shot.hit.v};
        if (const auto hit = judge(ray, met)) return *hit;
        near = just_behind(met.distance);
    }
    return {infinity, -1};
}

void RayScene::exit_walls(std::span<const InnerRay> rays, std::span<WallHit> hits) const {
    constexpr std::size_t most = 16;
    if (rays.size() > most || hits.size() != rays.size())
        throw std::invalid_argument("exit_walls takes up to 16 rays and as many hits.");
    if (rays.empty()) return;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit16 shots;
    alignas(64) std::array<int, most> open{};  // -1 for rays that go on
    for (std::size_t i = 0; i < most; ++i) {
        const InnerRay& ray = rays[std::min(i, rays.size() - 1)];  // Embree looks at closed lanes, too
        const Eigen::Vector3f start = tree_->place(ray.origin).cast<float>();
        const Eigen::Vector3f direction = ray.direction.cast<float>();
        shots.ray.org_x[i] = start.x();
        shots.ray.org_y[i] = start.y();
        shots.ray.org_z[i] = start.z();
        shots.ray.dir_x[i] = direction.x();
        shots.ray.dir_y[i] = direction.y();
        shots.ray.dir_z[i] = direction.z();
        shots.ray.tnear[i] = first_distance(ray);
        shots.ray.tfar[i] = infinity;
        shots.ray.time[i] = 0;
        shots.ray.mask[i] = ~0U;
        shots.ray.id[i] = 0;
        shots.ray.flags[i] = 0;
        shots.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
        shots.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
    }
    std::fill_n(open.begin(), rays.size(), -1);
    std::ranges::fill(hits, WallHit{infinity, -1});
    std::size_t going = rays.size();
    for (int passed = 0; passed < max_passed_walls && going > 0; ++passed) {
        rtcIntersect16(open.data(), tree_->handle(), &context, &shots);
        for (std::size_t i = 0; i < rays.size(); ++i) {
            if (open[i] == 0) continue;
            std::optional<WallHit> hit = WallHit{infinity, -1};
            if (shots.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID) {
                const Met met{static_cast<std::int32_t>(shots.hit.primID[i]), shots.ray.tfar[i], shots.hit.u[i],
                              shots.hit.v[i]};
                hit = judge(rays[i], met);
                shots.ray.tnear[i] = just_behind(met.distance);
                shots.ray.tfar[i] = infinity;
                shots.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
            }
            if (!hit) continue;
            hits[i] = *hit;
            open[i] = 0;
            --going;
        }
    }
}

}  // namespace partonomy
