/* The slope and the level that a scene stands on.
 *
 * On a slope, "a metre above the ground" says nothing of "a metre above the lowest point". So heights in a scene are
 * read from a plane through the ground. Rays come up from below on a square grid, and where they meet something first
 * is the lowest surface there; a plane is fitted to these points by least squares, over and over with weights that fade
 * with the distance from it (Cauchy's), so that what overhangs or lies beside the ground does not turn it. It counts
 * where most points lie on it and it is neither level nor steeper than any street; else heights are read along up.
 *
 * Nor is the lowest point the ground: that is the underside of a slab of any thickness, or the foot of a foundation.
 * Rays from above, on the same grid, see roofs, crowns and the ground; what is lower than all but a tenth of what they
 * see is the ground's upper side. Cost: 2,048 rays a scene. */

#include "algorithms/slope.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace partonomy {
namespace {

constexpr int grid = 32;
constexpr int rounds = 20;
constexpr double near = 0.002;       // of the diagonal: how far off counts half
constexpr double least_share = 0.6;  // of the points that must lie within twice of that
constexpr double least_slope = 0.005, steepest = 0.35;
constexpr double ground_share = 0.1;  // of what is seen from above: lower is a pit, or the edge of the ground

/// Where rays on a square grid first meet the object, from below or from above, in the frame x, y and up.
struct Look {
    Eigen::Matrix3d frame;
    Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
    std::vector<Vec3> points;

    Look(const Object& object, bool is_from_above) {
        const Vec3& up = object.placement.up;
        const Vec3 x = up.unitOrthogonal(), y = up.cross(x);
        frame << x.transpose(), y.transpose(), up.transpose();
        for (const Vec3& position : object.mesh.positions) {
            low = low.cwiseMin(frame * position);
            high = high.cwiseMax(frame * position);
        }
        const double margin = 0.01 * (high - low).norm(), sign = is_from_above ? -1 : 1;
        for (int i = 0; i < grid; ++i)
            for (int j = 0; j < grid; ++j) {
                const Vec3 from(low.x() + (i + 0.5) / grid * (high.x() - low.x()),
                                low.y() + (j + 0.5) / grid * (high.y() - low.y()),
                                is_from_above ? high.z() + margin : low.z() - margin);
                if (const auto way = object.tree->first_hit(frame.transpose() * from, sign * up))
                    points.push_back(from + Vec3(0, 0, sign * *way));
            }
    }
};

}  // namespace

Vec3 height_direction(const Object& object) {
    const Vec3& up = object.placement.up;
    if (!object.tree || object.mesh.positions.empty()) return up;
    Look look(object, false);
    const double diagonal = (look.high - look.low).norm();
    const Vec3 middle = (look.low + look.high) / 2;
    std::vector<Vec3>& points = look.points;
    for (Vec3& point : points) point -= middle;
    if (points.size() < 3) return up;
    Vec3 plane = Vec3::Zero();  // z = plane · (x, y, 1)
    double share = 0;
    for (int round = 0; round < rounds; ++round) {
        Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
        Vec3 b = Vec3::Zero();
        share = 0;
        for (const Vec3& p : points) {
            const Vec3 row(p.x(), p.y(), 1);
            const double off = (p.z() - plane.dot(row)) / (near * diagonal);
            const double weight = round == 0 ? 1 : 1 / (1 + off * off);
            a += weight * row * row.transpose();
            b += weight * p.z() * row;
            share += std::abs(off) < 2 ? 1.0 / static_cast<double>(points.size()) : 0;
        }
        plane = a.ldlt().solve(b);
    }
    const double slope = plane.head<2>().norm();
    if (!(share >= least_share && slope >= least_slope && slope <= steepest)) return up;
    return up - plane.x() * look.frame.row(0).transpose() - plane.y() * look.frame.row(1).transpose();
}

std::optional<double> ground_level(const Object& object) {
    if (!object.tree || object.mesh.positions.empty()) return std::nullopt;
    const Look look(object, true);
    std::vector<double> heights;
    for (const Vec3& point : look.points) heights.push_back((look.frame.transpose() * point).dot(object.heights));
    if (heights.empty()) return std::nullopt;
    const auto ground =
        heights.begin() + static_cast<std::ptrdiff_t>(ground_share * static_cast<double>(heights.size()));
    std::ranges::nth_element(heights, ground);
    return *ground;
}

}  // namespace partonomy
