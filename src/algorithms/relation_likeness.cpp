/* How regions are like each other, and which is the larger: directions, planes, lines, mirror images, shapes and sizes,
 * from their smallest boxes and the moments of their surfaces.
 *
 * Direction. Of a stick its axis, of anything else the normal of its largest side; of a block, where nearly equal sides
 * have none that is largest, each of them, and the best counts. A stick and a board are parallel when the axis lies in
 * the board's plane. A plane has what has one largest side, an axis what is a stick; nothing else is coplanar or
 * collinear.
 *
 * Mirror images. There are two vertical planes through the middle of the object, along its sides (upright.cpp). The
 * middle and the second moments of the target's surface, mirrored, are compared with the reference's: an X's two bars
 * have the same box, but not the same moments. What differs in higher moments only is not told apart.
 *
 * Which is the larger. The target over the reference: longest side, shortest side, surface. The surface, not the
 * volume: a sheet and a part that is open where it was cut have one, too, and a tabletop is larger than the block under
 * it.
 *
 * Shape. Ratios of sides tell a stick from a cube; how widely the surface is spread along the two longer sides tells a
 * round stick from a square one, a disc from a square board, a ball from a cube. The area would tell more, but noise
 * makes surfaces larger. */

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "algorithms/relation_measures.h"

namespace partonomy {
namespace {

using Regions = RelationMeasure::Regions;
using Surrounds = std::span<const Surround* const>;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double thin = 0.01;  ///< of the longest side: what is thinner counts as so thin

bool is_stick(const OrientedBox& box) {
    return box.lengths[0] >= 2 * box.lengths[1] && box.lengths[1] < 2 * box.lengths[2];
}

/// Columns of the box's axes that may be its direction.
std::vector<int> directions_of(const OrientedBox& box) {
    if (is_stick(box)) return {0};
    constexpr double nearly_equal = 1.25;
    std::vector<int> directions{2};
    for (const int i : {1, 0})
        if (box.lengths[i] < nearly_equal * box.lengths[2]) directions.push_back(i);
    return directions;
}

bool is_flat(const OrientedBox& box) { return !is_stick(box) && directions_of(box).size() == 1; }

/// Smallest angle between the two directions, or smallest way from it to a right angle; degrees.
double angle_between(Regions r, bool from_right_angle) {
    const OrientedBox &a = r[0]->part->box, &b = r[1]->part->box;
    const bool mixed = is_stick(a) != is_stick(b);
    double least = 90;
    for (const int i : directions_of(a))
        for (const int j : directions_of(b)) {
            // By sine and cosine: the angle between unit vectors is exact near 0 and near 90.
            const Vec3 u = a.axes.col(i), v = b.axes.col(j);
            const double angle = std::atan2(u.cross(v).norm(), std::abs(u.dot(v))) * 180 / std::numbers::pi;
            least = std::min(least, mixed == from_right_angle ? angle : 90 - angle);
        }
    return least;
}

double over_diagonal(const Scene& scene, double length) { return scene.diagonal > 0 ? length / scene.diagonal : 0; }

std::optional<double> plane_offset(const Scene& scene, Regions r) {
    const OrientedBox &a = r[0]->part->box, &b = r[1]->part->box;
    if (!is_flat(a) || !is_flat(b)) return infinity;
    double offset = 0;
    for (const OrientedBox* of : {&a, &b}) {
        const double middles = (a.centre - b.centre).dot(of->axes.col(2)), thicker = (a.lengths[2] - b.lengths[2]) / 2;
        offset =
            std::max(offset, std::min({std::abs(middles), std::abs(middles + thicker), std::abs(middles - thicker)}));
    }
    return over_diagonal(scene, offset);
}

std::optional<double> line_offset(const Scene& scene, Regions r) {
    const OrientedBox &a = r[0]->part->box, &b = r[1]->part->box;
    if (!is_stick(a) || !is_stick(b)) return infinity;
    const Vec3 between = a.centre - b.centre;
    return over_diagonal(scene, std::max(between.cross(a.axes.col(0)).norm(), between.cross(b.axes.col(0)).norm()));
}

std::optional<double> mirror_offset(const Scene& scene, Regions r) {
    const RegionPlace &a = *r[0], &b = *r[1];
    const double size = std::sqrt(std::max(a.spread.trace(), b.spread.trace()));
    double least = infinity;
    for (const int axis : {0, 1}) {
        Vec3 centre = a.centre;
        centre[axis] = scene.low[axis] + scene.high[axis] - centre[axis];
        Vec3 flip = Vec3::Ones();
        flip[axis] = -1;
        const Eigen::Matrix3d spread = flip.asDiagonal() * a.spread * flip.asDiagonal();
        const double moments = size > 0 ? (spread - b.spread).cwiseAbs().maxCoeff() / size : 0;
        least = std::min(least, std::max((centre - b.centre).norm(), moments));
    }
    return over_diagonal(scene, least);
}

/// Their middles lie within their boxes.
Interval mirror_range(const Scene& scene, Surrounds s) {
    double least = infinity;
    for (const int axis : {0, 1}) {
        Vec3 low = s[0]->low_from, high = s[0]->high_to;
        const double sum = scene.low[axis] + scene.high[axis];
        low[axis] = sum - s[0]->high_to[axis];
        high[axis] = sum - s[0]->low_from[axis];
        least = std::min(least, (low - s[1]->high_to).cwiseMax(s[1]->low_from - high).cwiseMax(0.0).norm());
    }
    return {over_diagonal(scene, least), infinity};
}

Vec3 sides_of(const OrientedBox& box) {
    return box.lengths.cwiseMax(thin * box.lengths[0]).cwiseMax(std::numeric_limits<double>::min());
}

double change(double a, double b) { return std::abs(std::log(a / b)); }

std::optional<double> shape_difference(const Scene& scene, Regions r) {
    // Two ratios of sides, and how widely the surface is spread along the two longer ones.
    const auto of = [&](const RegionPlace& place) {
        const Vec3 l = sides_of(place.part->box);
        Eigen::Vector4d shape(l[0] / l[1], l[1] / l[2], 1, 1);
        for (const int i : {0, 1}) {
            const Vec3 axis = scene.frame * place.part->box.axes.col(i);
            shape[2 + i] = std::max(axis.dot(place.spread * axis) / (l[i] * l[i]), thin);
        }
        return shape;
    };
    const Eigen::Vector4d a = of(*r[0]), b = of(*r[1]);
    double most = 0;
    for (int i = 0; i < 4; ++i) most = std::max(most, change(a[i], b[i]));
    return most;
}

std::optional<double> size_difference(const Scene&, Regions r) {
    const Vec3 a = sides_of(r[0]->part->box), b = sides_of(r[1]->part->box);
    return std::max({change(a[0], b[0]), change(a[1], b[1]), change(a[2], b[2])});
}

/// How far two intervals are apart.
double apart(double a_from, double a_to, double b_from, double b_to) {
    return std::max({0.0, a_from - b_to, b_from - a_to});
}

Interval shape_range(const Scene&, Surrounds s) {
    // Both ends of the first ratio, as far as thin sides count.
    const auto ends = [](const Surround& of) {
        const double most = -std::log(thin);
        return std::pair(std::clamp(of.size_from[0] - of.size_to[1], 0.0, most),
                         std::clamp(of.size_to[0] - of.size_from[1], 0.0, most));
    };
    const auto [a_from, a_to] = ends(*s[0]);
    const auto [b_from, b_to] = ends(*s[1]);
    return {apart(a_from, a_to, b_from, b_to), infinity};
}

/// Noise and ragged rims hardly change it, other than the sides of boxes. What is a point from above is as wide as what
/// is next to nothing.
std::optional<double> girth_difference(const Scene& scene, Regions r) {
    const auto girth = [&](const RegionPlace& place) {
        return std::sqrt(place.spread(0, 0) + place.spread(1, 1)) + 1e-6 * scene.diagonal;
    };
    return change(girth(*r[0]), girth(*r[1]));
}

/// The target's over the reference's; what is next to nothing counts as so small.
double share_of(double target, double reference, double least) {
    least = std::max(least, std::numeric_limits<double>::min());
    return std::max(target, least) / std::max(reference, least);
}

double least_length(const Scene& scene) { return 1e-6 * scene.diagonal; }

std::optional<double> area_ratio(const Scene& scene, Regions r) {
    return share_of(r[0]->area, r[1]->area, least_length(scene) * least_length(scene));
}

/// Of the side with that place among l0 >= l1 >= l2.
RelationMeasure side_ratio(const char* name, const char* description, int side) {
    const auto value = [side](const Scene& scene, Regions r) -> std::optional<double> {
        return share_of(r[0]->part->box.lengths[side], r[1]->part->box.lengths[side], least_length(scene));
    };
    const auto range = [side](const Scene& scene, Surrounds s) -> Interval {
        const auto ratio = [&](const Vec3& target, const Vec3& reference) {
            return share_of(std::exp(target[side]), std::exp(reference[side]), least_length(scene));
        };
        return {ratio(s[0]->size_from, s[1]->size_to), ratio(s[0]->size_to, s[1]->size_from)};
    };
    return {name, 2, "1", description, value, range, true};
}

Interval size_range(const Scene&, Surrounds s) {
    return {apart(s[0]->size_from[0], s[0]->size_to[0], s[1]->size_from[0], s[1]->size_to[0]), infinity};
}

}  // namespace

void add_likeness_measures(std::vector<RelationMeasure>& measures) {
    const auto add = [&](const char* name, const char* unit, const char* description, auto value, auto range) {
        measures.push_back({name, 2, unit, description, value, range});
    };
    add(
        "angle", "degrees",
        "between a stick's axis, or the plane of the largest side of anything else, and the other's",
        [](const Scene&, Regions r) -> std::optional<double> { return angle_between(r, false); }, nullptr);
    add(
        "off square", "degrees",
        "how much a stick's axis, or the plane of anything else, is off a right angle to the other's",
        [](const Scene&, Regions r) -> std::optional<double> { return angle_between(r, true); }, nullptr);
    add("plane offset", "diagonal", "how far their planes are apart, in the middle or on one side; only flat regions",
        plane_offset, nullptr);
    add("line offset", "diagonal", "how far their middles are off each other's axis; only sticks", line_offset,
        nullptr);
    add("mirror offset", "diagonal", "how far the target's mirror image in the object's upright planes is off",
        mirror_offset, mirror_range);
    add("shape difference", "1",
        "largest change of a ratio of sides, or of how the surface is spread along them; logarithm", shape_difference,
        shape_range);
    measures.back().by_size = true;
    add("size difference", "1", "largest change of a side of the smallest box; logarithm", size_difference, size_range);
    measures.back().by_size = true;
    add("girth difference", "1",
        "change of how widely the surface is spread, seen from above: of the radius of upright round walls; logarithm",
        girth_difference, nullptr);
    measures.push_back(side_ratio("length ratio", "longest side of the target's smallest box over the reference's", 0));
    measures.push_back(
        side_ratio("thickness ratio", "shortest side of the target's smallest box over the reference's", 2));
    add("area ratio", "1", "surface of the target over the reference's", area_ratio, nullptr);
}

}  // namespace partonomy
