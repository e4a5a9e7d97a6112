/* Where regions lie to each other, read off their boxes along the sides of the object (upright.cpp): a box
 * says enough about above and beside, costs nothing, and turns with the object. */

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "algorithms/relation_measures.h"

namespace partonomy {
namespace {

constexpr double degrees = 180 / std::numbers::pi;
using Regions = RelationMeasure::Regions;
using Surrounds = std::span<const Surround* const>;

double fraction(double part, double whole) { return whole > 0 ? part / whole : 0; }

Interval fraction(const Interval& part, double whole) {
    return {fraction(part.low, whole), fraction(part.high, whole)};
}

/// Distance of two intervals; negative when they overlap: how far.
double distance_along(const RegionPlace& a, const RegionPlace& b, int axis) {
    return std::max(a.low[axis] - b.high[axis], b.low[axis] - a.high[axis]);
}

Interval distance_along(const Surround& a, const Surround& b, int axis) {
    return {std::max(a.low_from[axis] - b.high_to[axis], b.low_from[axis] - a.high_to[axis]),
            std::max(a.low_to[axis] - b.high_from[axis], b.low_to[axis] - a.high_from[axis])};
}

/// Overlap of two intervals, as a fraction of the shorter one.
double overlap_along(const RegionPlace& a, const RegionPlace& b, int axis) {
    const double shorter = std::min(a.high[axis] - a.low[axis], b.high[axis] - b.low[axis]);
    const double overlap = -distance_along(a, b, axis);
    return shorter > 0 ? std::clamp(overlap / shorter, 0.0, 1.0) : (overlap >= 0 ? 1.0 : 0.0);
}

Interval overlap_range(const Surround& a, const Surround& b, std::initializer_list<int> axes) {
    return {0, std::ranges::any_of(axes, [&](int axis) { return distance_along(a, b, axis).low > 0; }) ? 0.0 : 1.0};
}

std::optional<double> rise(const Scene& scene, Regions regions) {
    return fraction(regions[0]->middle().z() - regions[1]->high.z(), scene.height());
}

Interval rise_range(const Scene& scene, Surrounds s) {
    return fraction({(s[0]->low_from.z() + s[0]->high_from.z()) / 2 - s[1]->high_to.z(),
                     (s[0]->low_to.z() + s[0]->high_to.z()) / 2 - s[1]->high_from.z()},
                    scene.height());
}

std::optional<double> drop(const Scene& scene, Regions regions) {
    return fraction(regions[1]->low.z() - regions[0]->middle().z(), scene.height());
}

Interval drop_range(const Scene& scene, Surrounds s) {
    return fraction({s[1]->low_from.z() - (s[0]->low_to.z() + s[0]->high_to.z()) / 2,
                     s[1]->low_to.z() - (s[0]->low_from.z() + s[0]->high_from.z()) / 2},
                    scene.height());
}

/// Horizontal distance of the boxes, 0 when one stands over the other.
std::optional<double> side_step(const Scene& scene, Regions r) {
    return fraction(
        std::hypot(std::max(0.0, distance_along(*r[0], *r[1], 0)), std::max(0.0, distance_along(*r[0], *r[1], 1))),
        scene.diagonal);
}

Interval side_step_range(const Scene& scene, Surrounds s) {
    const Interval x = distance_along(*s[0], *s[1], 0), y = distance_along(*s[0], *s[1], 1);
    return fraction({std::hypot(std::max(0.0, x.low), std::max(0.0, y.low)),
                     std::hypot(std::max(0.0, x.high), std::max(0.0, y.high))},
                    scene.diagonal);
}

std::optional<double> level_overlap(const Scene&, Regions r) { return overlap_along(*r[0], *r[1], 2); }

std::optional<double> footprint_overlap(const Scene&, Regions r) {
    return overlap_along(*r[0], *r[1], 0) * overlap_along(*r[0], *r[1], 1);
}

/// From the far side of the reference along `way` on to the middle of the target.
std::optional<double> beyond(const Scene& scene, const std::optional<Vec3>& way, Regions r) {
    if (!way) return std::nullopt;
    const double end = way->sum() > 0 ? r[1]->high.dot(*way) : r[1]->low.dot(*way);  // `way` is along an axis
    return fraction(r[0]->middle().dot(*way) - end, scene.diagonal);
}

Interval beyond_range(const Scene& scene, const std::optional<Vec3>& way, Surrounds s) {
    if (!way) return {-std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    const Vec3 from = (s[0]->low_from + s[0]->high_from) / 2, to = (s[0]->low_to + s[0]->high_to) / 2;
    if (way->sum() > 0)
        return fraction({(from - s[1]->high_to).dot(*way), (to - s[1]->high_from).dot(*way)}, scene.diagonal);
    return fraction({(to - s[1]->low_from).dot(*way), (from - s[1]->low_to).dot(*way)}, scene.diagonal);
}

std::optional<Vec3> back_of(const Scene& scene) {
    return scene.front ? std::optional<Vec3>(-*scene.front) : std::nullopt;
}

Interval common(const Interval& a, const Interval& b) { return {std::max(a.low, b.low), std::min(a.high, b.high)}; }
Interval along(const RegionPlace& place, int axis) { return {place.low[axis], place.high[axis]}; }

/// Length of the common part over that of `whole`; of a whole without length, whether it is in there.
double covered(const Interval& whole, const Interval& by) {
    const double length = whole.high - whole.low;
    const Interval part = common(whole, by);
    return length > 0 ? std::clamp((part.high - part.low) / length, 0.0, 1.0) : (part.high >= part.low ? 1.0 : 0.0);
}

/// The way from one reference to the other along one axis: between their middles, and all of what they share.
Interval corridor_along(const RegionPlace& a, const RegionPlace& b, int axis) {
    const auto [low, high] = std::minmax(a.middle()[axis], b.middle()[axis]);
    const Interval shared = common(along(a, axis), along(b, axis));
    return shared.low > shared.high ? Interval{low, high}
                                    : Interval{std::min(low, shared.low), std::max(high, shared.high)};
}

/// Seen from the point of the target's box where it comes nearest to the corridor between the references, of such
/// points the one next to the middle of its surface: from the middle itself, swept wings would both be behind.
std::optional<double> opening_angle(const Scene&, Regions regions) {
    Vec3 here = regions[0]->centre;
    for (int axis = 0; axis < 3; ++axis) {
        const RegionPlace &a = *regions[1], &b = *regions[2];
        const double one = std::max(a.low[axis], b.low[axis]), other = std::min(a.high[axis], b.high[axis]);
        const double in_corridor = std::clamp(here[axis], std::min(one, other), std::max(one, other));
        here[axis] = std::clamp(in_corridor, regions[0]->low[axis], regions[0]->high[axis]);
    }
    const auto way_to = [&](const RegionPlace& box) -> Vec3 {
        return here.cwiseMax(box.low).cwiseMin(box.high) - here;
    };
    const Vec3 to_first = way_to(*regions[1]), to_second = way_to(*regions[2]);
    const double lengths = to_first.norm() * to_second.norm();
    if (!(lengths > 0)) return 0;  // inside of one of them
    return std::acos(std::clamp(to_first.dot(to_second) / lengths, -1.0, 1.0)) * degrees;
}

/// Along each axis, how much of the target is in the corridor, or of the corridor in the target where that is longer: a
/// hull is longer than the wings it is between. But along the line of their middles how much more of the target is
/// between them than beyond, since what holds both is not.
std::optional<double> corridor_share(const Scene&, Regions r) {
    const RegionPlace &target = *r[0], &a = *r[1], &b = *r[2];
    double least = 1;
    for (int axis = 0; axis < 3; ++axis) {
        const Interval corridor = corridor_along(a, b, axis), own = along(target, axis);
        least = std::min(least, std::max(covered(own, corridor), covered(corridor, own)));
    }
    const Vec3 way = b.middle() - a.middle();
    if (!(way.norm() > 0)) return 0;
    const double middle = way.dot(target.middle()), reach = way.cwiseAbs().dot(target.high - target.low) / 2;
    const double in_between = covered({middle - reach, middle + reach}, {way.dot(a.middle()), way.dot(b.middle())});
    return std::min(least, std::max(0.0, 2 * in_between - 1));
}

/// Nothing of what is beyond both of them is in the corridor.
Interval corridor_range(const Scene&, Surrounds s) {
    for (int axis = 0; axis < 3; ++axis)
        if (s[0]->low_from[axis] > std::max(s[1]->high_to[axis], s[2]->high_to[axis]) ||
            s[0]->high_to[axis] < std::min(s[1]->low_from[axis], s[2]->low_from[axis]))
            return {0, 0};
    return {0, 1};
}

/// Where both references lie to one side of the target, neither way turns further from that side than its distance
/// across lets it.
Interval opening_range(const Scene&, Surrounds s) {
    double widest = 180;
    for (int axis = 0; axis < 3; ++axis)
        for (const bool above : {true, false}) {
            double turned = 0;
            for (const Surround* box : {s[1], s[2]}) {
                const double ahead =
                    above ? box->low_from[axis] - s[0]->high_to[axis] : s[0]->low_from[axis] - box->high_to[axis];
                double across = 0;
                for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
                    const double far = std::max({0.0, box->low_to[other] - s[0]->low_from[other],
                                                 s[0]->high_to[other] - box->high_from[other]});
                    across = std::hypot(across, far);
                }
                turned += ahead > 0 ? std::atan2(across, ahead) * degrees : 180;
            }
            widest = std::min(widest, turned);
        }
    return {0, widest};
}

/// From the sides of the reference's box inward to the target's; negative when the target reaches beyond them.
std::optional<double> margin(const Scene& scene, Regions r) {
    double least = std::numeric_limits<double>::infinity();
    for (const int axis : {0, 1})
        least = std::min({least, r[0]->low[axis] - r[1]->low[axis], r[1]->high[axis] - r[0]->high[axis]});
    return fraction(least, scene.diagonal);
}

Interval margin_range(const Scene& scene, Surrounds s) {
    Interval least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (const int axis : {0, 1}) {
        least.low = std::min(
            {least.low, s[0]->low_from[axis] - s[1]->low_to[axis], s[1]->high_from[axis] - s[0]->high_to[axis]});
        least.high = std::min(
            {least.high, s[0]->low_to[axis] - s[1]->low_from[axis], s[1]->high_to[axis] - s[0]->high_from[axis]});
    }
    return fraction(least, scene.diagonal);
}

/// Two of three coordinates agree in a row: the second largest difference.
double middle_of(double a, double b, double c) { return std::max(std::min(a, b), std::min(std::max(a, b), c)); }

std::optional<double> row_offset(const Scene& scene, Regions r) {
    const Vec3 d = (r[0]->middle() - r[1]->middle()).cwiseAbs();
    return fraction(middle_of(d.x(), d.y(), d.z()), scene.diagonal);
}

Interval row_range(const Scene& scene, Surrounds s) {
    Vec3 least, most;
    for (int axis = 0; axis < 3; ++axis) {
        const double from =
            (s[0]->low_from[axis] + s[0]->high_from[axis] - s[1]->low_to[axis] - s[1]->high_to[axis]) / 2;
        const double to = (s[0]->low_to[axis] + s[0]->high_to[axis] - s[1]->low_from[axis] - s[1]->high_from[axis]) / 2;
        least[axis] = std::max({0.0, from, -to});
        most[axis] = std::max(std::abs(from), std::abs(to));
    }
    return fraction({middle_of(least.x(), least.y(), least.z()), middle_of(most.x(), most.y(), most.z())},
                    scene.diagonal);
}

}  // namespace

void add_place_measures(std::vector<RelationMeasure>& measures) {
    const auto front = [](const Scene& scene) { return scene.front; };
    const auto add = [&](const char* name, std::size_t arity, const char* unit, const char* description, auto value,
                         auto range) {
        measures.push_back({name, arity, unit, description, value, range});
    };
    add("rise", 2, "height", "from the top of the reference up to the middle of the target", rise, rise_range);
    add("drop", 2, "height", "from the foot of the reference down to the middle of the target", drop, drop_range);
    add("side step", 2, "diagonal", "horizontal distance of the two boxes, 0 when one is over the other", side_step,
        side_step_range);
    add("level overlap", 2, "1", "common range of heights, as a fraction of the lower region's", level_overlap,
        [](const Scene&, Surrounds s) { return overlap_range(*s[0], *s[1], {2}); });
    add("footprint overlap", 2, "1", "common ground of the two boxes, as fractions of the narrower ones",
        footprint_overlap, [](const Scene&, Surrounds s) {
            return overlap_range(*s[0], *s[1], {0, 1});
        });
    add(
        "ahead", 2, "diagonal", "from the reference's front side forward to the middle of the target; needs a front",
        [front](const Scene& scene, Regions r) { return beyond(scene, front(scene), r); },
        [front](const Scene& scene, Surrounds s) { return beyond_range(scene, front(scene), s); });
    add(
        "behind", 2, "diagonal", "from the reference's back side backward to the middle of the target; needs a front",
        [](const Scene& scene, Regions r) { return beyond(scene, back_of(scene), r); },
        [](const Scene& scene, Surrounds s) { return beyond_range(scene, back_of(scene), s); });
    add("margin", 2, "diagonal", "from the nearest upright side of the reference's box inward to the target's box",
        margin, margin_range);
    add("row offset", 2, "diagonal", "how far the middles are off one line along a side of the object, or upright",
        row_offset, row_range);
    add("opening angle", 3, "degrees",
        "where the target comes nearest to the corridor between the references, between the ways to them",
        opening_angle, opening_range);
    add("corridor share", 3, "1",
        "how much of the target is in the corridor between the references, or of the corridor in the target",
        corridor_share, corridor_range);
}

}  // namespace partonomy
