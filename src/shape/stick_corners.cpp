// Whose the corner is where two sticks meet end to end.
//
// Cores end where the walls of the other stick begin to be seen, so filling leaves the corner cut anyhow. It belongs to
// the level one, as that of two boards does: what is above rests on it, what is below carries it. The border is the
// wall of the level stick that faces the other one, continued. A stick that goes on beyond the other has no corner to
// give away. Cost: O(n), if there are such sticks.

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "shape/claims.h"

namespace partonomy {

namespace {

const double facing_cosine = std::cos(40 * std::numbers::pi / 180);
const double across_cosine = std::cos(60 * std::numbers::pi / 180);
constexpr double more_level = 0.3;   // difference of the cosines to `up`
constexpr double long_enough = 2;    // of its thickness is a stick with a direction
constexpr double most_beyond = 0.5;  // of the thickness of the other one: farther, and the stick goes on
constexpr double far_end = 0.02;     // of the area: what lies beyond is no end
constexpr double least_wall = 0.04;  // of the area

using Weighted = std::pair<double, double>;  // value, weight

double quantile(std::vector<Weighted>& values, double share) {
    std::ranges::sort(values);
    double total = 0, sum = 0;
    for (const auto& [value, weight] : values) total += weight;
    for (const auto& [value, weight] : values)
        if ((sum += weight) >= share * total) return value;
    return values.back().first;
}

/// One stick: its triangles and the direction that none of its walls faces.
struct Stick {
    std::vector<std::int32_t> triangles;
    double area = 0;
    Vec3 axis = Vec3::Zero(), middle = Vec3::Zero();

    Stick(const Surface& s, std::vector<std::int32_t> members, const Core& core) : triangles(std::move(members)) {
        Eigen::Matrix3d facing = Eigen::Matrix3d::Zero();
        for (const std::int32_t i : core.triangles)
            facing += s.geometry.areas[i] * s.geometry.normals[i] * s.geometry.normals[i].transpose();
        axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(facing).eigenvectors().col(0);
        for (const std::int32_t i : triangles) {
            area += s.geometry.areas[i];
            middle += s.geometry.areas[i] * s.geometry.barycentres[i];
        }
        middle /= area;
    }

    /// How far out the wall is that faces a direction.
    [[nodiscard]] std::optional<double> wall(const Surface& s, const Vec3& direction) const {
        std::vector<Weighted> facing;
        double sum = 0;
        for (const std::int32_t i : triangles)
            if (s.geometry.normals[i].dot(direction) > facing_cosine) {
                facing.emplace_back(s.geometry.barycentres[i].dot(direction), s.geometry.areas[i]);
                sum += s.geometry.areas[i];
            }
        if (sum < least_wall * area) return std::nullopt;
        return quantile(facing, 0.5);
    }

    /// How far it reaches along a direction.
    [[nodiscard]] double end(const Surface& s, const Vec3& direction) const {
        std::vector<Weighted> places;
        for (const std::int32_t i : triangles)
            places.emplace_back(s.geometry.barycentres[i].dot(direction), s.geometry.areas[i]);
        return quantile(places, 1 - far_end);
    }
};

/// Draws the border of two sticks, of which the first is the level one, if they meet in a corner.
void draw_border(const Surface& s, const Stick& level, const Stick& other, std::int32_t own, std::int32_t others,
                 std::vector<std::int32_t>& part_of) {
    if (std::abs(level.axis.dot(other.axis)) > across_cosine) return;
    Vec3 to_other = (other.axis - other.axis.dot(level.axis) * level.axis).normalized();
    if ((other.middle - level.middle).dot(to_other) < 0) to_other = -to_other;
    Vec3 to_level = (level.axis - level.axis.dot(other.axis) * other.axis).normalized();
    if ((level.middle - other.middle).dot(to_level) < 0) to_level = -to_level;
    const auto near = level.wall(s, to_other), far = level.wall(s, -to_other);
    const auto other_near = other.wall(s, to_level), other_far = other.wall(s, -to_level);
    if (!near || !far || !other_near || !other_far) return;
    const double thickness = *near + *far, other_thickness = *other_near + *other_far;
    if (!(thickness > 0 && other_thickness > 0)) return;
    if (other.end(s, to_other) - *near < long_enough * other_thickness) return;
    if (level.end(s, to_level) - *other_near < long_enough * thickness) return;
    if (other.end(s, -to_other) - *far > most_beyond * thickness) return;
    if (level.end(s, -to_level) - *other_far > most_beyond * other_thickness) return;
    for (const std::int32_t i : other.triangles)
        if (s.geometry.barycentres[i].dot(to_other) < *near) part_of[i] = own;
    for (const std::int32_t i : level.triangles)
        if (s.geometry.barycentres[i].dot(to_other) > *near && s.geometry.barycentres[i].dot(to_level) < *other_near)
            part_of[i] = others;
}

}  // namespace

void give_corners_to_level_sticks(const Surface& s, const Vec3& up, Parts& parts) {
    const auto is_stick = [&](std::int32_t k) { return parts.parts[k].kind == Solidity::stick; };
    std::set<std::pair<std::int32_t, std::int32_t>> borders;
    std::vector<std::vector<std::int32_t>> members(parts.parts.size());
    for (std::size_t i = 0; i < s.count(); ++i) {
        const std::int32_t own = parts.part_of[i];
        if (own < 0 || !is_stick(own)) continue;
        members[own].push_back(static_cast<std::int32_t>(i));
        for (const std::int32_t j : s.adjacency.neighbours[i])
            if (j >= 0 && parts.part_of[j] > own && is_stick(parts.part_of[j])) borders.emplace(own, parts.part_of[j]);
    }
    for (const auto& [a, b] : borders) {
        if (parts.parts[a].triangles.empty() || parts.parts[b].triangles.empty()) continue;
        const Stick first(s, members[a], parts.parts[a]), second(s, members[b], parts.parts[b]);
        const double rise = std::abs(first.axis.dot(up)) - std::abs(second.axis.dot(up));
        if (rise < -more_level) draw_border(s, first, second, a, b, parts.part_of);
        if (rise > more_level) draw_border(s, second, first, b, a, parts.part_of);
    }
}

}  // namespace partonomy
