/* The upright mirror plane of an object, from sums over its surface.
 *
 * Where an object is its own mirror image, the plane passes through the middle of the surface, lies along a principal
 * axis of the plan, and along each sum of the surface that points somewhere: where what is far out lies, and where what
 * is high lies. So a few directions are all that may be. One of them is right when all odd moments across its plane
 * vanish, up to the fourth degree: with n across, t along and z upward, n, nt, nz, ntt … nnnz, each over the spreads.
 * The moments are exact for large triangles (a rule of six points), so that meshes of other triangles on either side do
 * not matter; small ones count by their middles. Noise averages out.
 *
 * Cost: O(n), some 40 products a point for each of at most six directions. */

#include "algorithms/mirror_plane.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>

namespace partonomy {
namespace {

constexpr double small = 1e-4;  // triangle over the square of the object's size

/// Calls `visit(point, weight)` for points that integrate polynomials of the fourth degree over the surface: exactly
/// over triangles that are not small (Dunavant 1985). Points are relative to the origin.
template <typename Visit>
void for_each_point(const Object& object, const Vec3& origin, const Visit& visit) {
    struct Ring {
        double apart, weight;  // of three points: barycentric coordinate of two corners, share of the area
    };
    constexpr std::array<Ring, 2> rings{Ring{0.445948490915965, 0.223381589678011},
                                        Ring{0.091576213509771, 0.109951743655322}};
    const double size = compute_bounds(object.mesh).diagonal();
    for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t) {
        const Vec3 middle = object.geometry.barycentres[t] - origin;
        if (object.geometry.areas[t] < small * size * size) {
            visit(middle, object.geometry.areas[t]);
            continue;
        }
        const Vec3 sum = 3 * middle;
        for (const std::int32_t v : object.mesh.triangles[t]) {
            const Vec3 corner = object.mesh.positions[static_cast<std::size_t>(v)] - origin;
            for (const Ring& ring : rings)
                visit(Vec3(ring.apart * sum + (1 - 3 * ring.apart) * corner), ring.weight * object.geometry.areas[t]);
        }
    }
}

struct Middle {
    double area = 0;
    Vec3 centre = Vec3::Zero();
};

Middle middle_of(const Object& object) {
    Middle middle;
    for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t) {
        middle.area += object.geometry.areas[t];
        middle.centre += object.geometry.areas[t] * object.geometry.barycentres[t];
    }
    if (middle.area > 0) middle.centre /= middle.area;
    return middle;
}

}  // namespace

double mirror_asymmetry(const Object& object, const Vec3& side) {
    const auto [area, centre] = middle_of(object);
    if (!(area > 0)) return 0;
    const Vec3 &up = object.placement.up, along = up.cross(side);
    // Odd moments, and the spreads that they are measured by, by powers of n, t and z.
    struct Powers {
        int n, t, z;
    };
    constexpr std::array<Powers, 13> odd{{{1, 0, 0},
                                          {1, 1, 0},
                                          {1, 0, 1},
                                          {1, 2, 0},
                                          {1, 1, 1},
                                          {1, 0, 2},
                                          {3, 0, 0},
                                          {1, 3, 0},
                                          {1, 2, 1},
                                          {1, 1, 2},
                                          {1, 0, 3},
                                          {3, 1, 0},
                                          {3, 0, 1}}};
    std::array<double, odd.size()> moments{};
    Vec3 squares = Vec3::Zero();
    for_each_point(object, centre, [&](const Vec3& point, double weight) {
        const double n = point.dot(side), t = point.dot(along), z = point.dot(up);
        const std::array<double, 4> of_n{1, n, n * n, n * n * n}, of_t{1, t, t * t, t * t * t},
            of_z{1, z, z * z, z * z * z};
        squares += weight * Vec3(of_n[2], of_t[2], of_z[2]);
        for (std::size_t i = 0; i < odd.size(); ++i)
            moments[i] += weight * of_n[static_cast<std::size_t>(odd[i].n)] * of_t[static_cast<std::size_t>(odd[i].t)] *
                          of_z[static_cast<std::size_t>(odd[i].z)];
    });
    const Vec3 spread = (squares / area).cwiseSqrt();
    double most = 0;
    for (std::size_t i = 0; i < odd.size(); ++i) {
        const double size =
            area * std::pow(spread[0], odd[i].n) * std::pow(spread[1], odd[i].t) * std::pow(spread[2], odd[i].z);
        if (size > 0) most = std::max(most, std::abs(moments[i]) / size);
    }
    return most;
}

std::optional<Vec3> mirror_side(const Object& object) {
    const auto [area, centre] = middle_of(object);
    if (!(area > 0)) return std::nullopt;
    const Vec3 &up = object.placement.up, x = up.unitOrthogonal(), y = up.cross(x);
    Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
    Vec3 far_out = Vec3::Zero(), high = Vec3::Zero();
    for_each_point(object, centre, [&](const Vec3& point, double weight) {
        const Eigen::Vector2d plan(point.dot(x), point.dot(y));
        spread += weight * plan * plan.transpose();
        far_out += weight * plan.squaredNorm() * point;
        high += weight * point.dot(up) * point;
    });
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> axes(spread);
    std::vector<Vec3> sides;
    for (const int i : {0, 1}) sides.emplace_back(axes.eigenvectors()(0, i) * x + axes.eigenvectors()(1, i) * y);
    for (const Vec3& pointing : {far_out, high})
        if (const Vec3 side = up.cross(pointing); side.norm() > 0) sides.push_back(side.normalized());
    double least = mirror_tolerance;
    std::optional<Vec3> best;
    for (const Vec3& side : sides)
        if (const double asymmetry = mirror_asymmetry(object, side); asymmetry < least) {
            least = asymmetry;
            best = side;
        }
    return best;
}

}  // namespace partonomy
