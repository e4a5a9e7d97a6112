/* Directions and levels of an object as it stands, from sums over its surface: which way is from side to side, and at
 * which height most of what looks up lies. Neither looks at parts, so they serve to tell parts apart. Cost: O(n). */

#include "algorithms/stance.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace partonomy {

const Vec3& sideways_of(const Object& object) {
    if (object.sideways) return *object.sideways;
    constexpr double least_correlation = 0.1;  // between height and the way back; tables have none
    Vec3& sideways = object.sideways.emplace(Vec3::Zero());
    const Vec3& up = object.placement.up;
    double area = 0;
    Vec3 sum = Vec3::Zero();
    Eigen::Matrix3d moments = Eigen::Matrix3d::Zero();  // exact, so that long triangles count as many small ones do
    for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t) {
        const Vec3& middle = object.geometry.barycentres[t];
        area += object.geometry.areas[t];
        sum += object.geometry.areas[t] * middle;
        Eigen::Matrix3d corners = 9 * middle * middle.transpose();
        for (const std::int32_t v : object.mesh.triangles[t]) {
            const Vec3& corner = object.mesh.positions[static_cast<std::size_t>(v)];
            corners += corner * corner.transpose();
        }
        moments += object.geometry.areas[t] / 12 * corners;
    }
    if (!(area > 0)) return sideways;
    const Vec3 centre = sum / area;
    const Eigen::Matrix3d spread = moments - area * centre * centre.transpose();
    Vec3 growth = spread * up;
    growth -= growth.dot(up) * up;
    if (!(growth.norm() > 0)) return sideways;
    const Vec3 back = growth.normalized();
    if (growth.norm() < least_correlation * std::sqrt(back.dot(spread * back) * up.dot(spread * up))) return sideways;
    sideways = up.cross(back).normalized();
    return sideways;
}

double main_level(const Object& object) {
    if (object.level) return *object.level;
    constexpr double flat_enough = 0.7, nearly = 0.8;  // cosine between normal and up; of the most
    constexpr std::size_t steps = 64, span = 4;        // of the height; of them a level may take
    std::array<double, steps> areas{}, moments{};
    const double height = object.high - object.low;
    object.level = height;
    if (!(height > 0)) return height;
    for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t) {
        const double cosine = object.geometry.normals[t].dot(object.placement.up);
        if (cosine < flat_enough) continue;
        const double above = object.geometry.barycentres[t].dot(object.heights) - object.low;
        const auto step = static_cast<std::size_t>(std::clamp(above / height, 0.0, 1.0) * (steps - 1));
        areas[step] += cosine * object.geometry.areas[t];
        moments[step] += cosine * object.geometry.areas[t] * above;
    }
    const auto around = [](const std::array<double, steps>& values, std::size_t first) {
        return std::accumulate(values.begin() + first, values.begin() + first + span, 0.0);
    };
    double most = 0;
    for (std::size_t first = 0; first + span <= steps; ++first) most = std::max(most, around(areas, first));
    if (!(most > 0)) return height;
    std::size_t best = steps - span;
    while (around(areas, best) < nearly * most) --best;
    while (best > 0 && around(areas, best - 1) > around(areas, best)) --best;  // all of the level, not its upper edge
    object.level = around(moments, best) / around(areas, best);
    return *object.level;
}

}  // namespace partonomy
