/* How regions touch and hold each other, from their triangles.
 *
 * Gap: the exact smallest distance (triangle_tree.cpp). Contact: the edges of either region that come as near to the
 * other as a hundredth of the diagonal; how far the furthest of their points are apart, over the longest side of the
 * smaller region. Along an edge, the distance to one triangle falls and then rises (both are convex), so its near
 * stretch is found by halving. Inside: the share of the target's surface, cut at the walls, within the reference's
 * smallest box. Encirclement: 72 rays in each plane of the object's frame leave the middle of the reference; a ray
 * counts when it leaves the reference before it meets the target, of which only what is level with the reference is
 * looked at. The best plane counts, so a frame around a door is told as well as a ring around a pole. */

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "algorithms/clip.h"
#include "algorithms/relation_measures.h"
#include "algorithms/triangle_tree.h"

namespace partonomy {
namespace {

using Regions = RelationMeasure::Regions;
using Surrounds = std::span<const Surround* const>;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double touch = 0.01;  ///< of the diagonal: what is nearer than that is in contact
constexpr int rays = 72;

const TriangleTree& tree_of(const Scene& scene, const RegionPlace& place) {
    if (!place.triangles) {
        std::vector<Triangle> triangles;
        triangles.reserve(place.part->region.triangles.size());
        for (const std::int32_t t : place.part->region.triangles) triangles.push_back(corners_of(scene, t));
        place.triangles = std::make_shared<const TriangleTree>(std::move(triangles));
    }
    return *place.triangles;
}

/// The boxes are at least so far apart.
double apart(const Surround& a, const Surround& b) {
    return (a.low_from - b.high_to).cwiseMax(b.low_from - a.high_to).cwiseMax(0.0).norm();
}

std::optional<double> gap(const Scene& scene, Regions r) {
    return scene.diagonal > 0 ? tree_of(scene, *r[0]).distance(tree_of(scene, *r[1])) / scene.diagonal : 0;
}

/// Each side of a box is met by what is within: no farther than the farthest points of the two nearest sides.
double at_most_apart(const Surround& a, const Surround& b) {
    double nearest = infinity;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        const auto farthest = [&](int i) {
            return std::max(a.high_to[i] - b.low_from[i], b.high_to[i] - a.low_from[i]);
        };
        const auto sides_apart = [](double x_from, double x_to, double y_from, double y_to) {
            return std::max(std::abs(x_to - y_from), std::abs(y_to - x_from));
        };
        const double along =
            std::min({sides_apart(a.low_from[axis], a.low_to[axis], b.low_from[axis], b.low_to[axis]),
                      sides_apart(a.low_from[axis], a.low_to[axis], b.high_from[axis], b.high_to[axis]),
                      sides_apart(a.high_from[axis], a.high_to[axis], b.low_from[axis], b.low_to[axis]),
                      sides_apart(a.high_from[axis], a.high_to[axis], b.high_from[axis], b.high_to[axis])});
        nearest = std::min(nearest, std::hypot(along, farthest(u), farthest(v)));
    }
    return nearest;
}

Interval gap_range(const Scene& scene, Surrounds s) {
    if (!(scene.diagonal > 0)) return {0, 0};
    return {apart(*s[0], *s[1]) / scene.diagonal, at_most_apart(*s[0], *s[1]) / scene.diagonal};
}

/// Ends of the stretch from p to q that is within reach of the triangle, as fractions of the way; none: first > second.
std::pair<double, double> near_stretch(const Vec3& p, const Vec3& q, const Triangle& triangle, double reach) {
    if (distance_of_edge(p, q, triangle) > reach) return {1, 0};
    const auto distance = [&](double t) { return distance_to_triangle(p + t * (q - p), triangle); };
    double low = 0, high = 1;
    for (int i = 0; i < 50 && distance((low + high) / 2) > reach; ++i) {
        const double a = low + (high - low) / 3, b = high - (high - low) / 3;
        if (distance(a) <= distance(b))
            high = b;
        else
            low = a;
    }
    double nearest = (low + high) / 2;
    for (const double end : {0.0, 1.0})
        if (distance(end) < distance(nearest)) nearest = end;
    if (distance(nearest) > reach) return {1, 0};
    const auto border = [&](double inside, double outside) {
        if (distance(outside) <= reach) return outside;
        for (int i = 0; i < 30; ++i) {
            const double half = (inside + outside) / 2;
            (distance(half) <= reach ? inside : outside) = half;
        }
        return inside;
    };
    return {border(nearest, 0), border(nearest, 1)};
}

/// Points where edges of `one` come within reach of `other`, or leave it.
void collect_contacts(const RegionPlace& place, const TriangleTree& one, const TriangleTree& other, double reach,
                      std::vector<Vec3>& points) {
    one.for_each_near(place.low, place.high, reach, [&](const Triangle& triangle) {
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 &p = triangle[i], &q = triangle[(i + 1) % 3];
            const bool from_p = other.distance(p, 2 * reach) <= reach, to_q = other.distance(q, 2 * reach) <= reach;
            if (from_p) points.push_back(p);
            if ((from_p && to_q) || (q - p).norm() < reach / 4) continue;
            other.for_each_near(p.cwiseMin(q), p.cwiseMax(q), reach, [&](const Triangle& near) {
                const auto [first, last] = near_stretch(p, q, near, reach);
                if (first > last) return;
                points.emplace_back(p + first * (q - p));
                points.emplace_back(p + last * (q - p));
            });
        }
    });
}

/// The largest distance of two points; of very many that of the outermost ones in 64 directions, 2 % too short at most.
double extent(std::vector<Vec3> points) {
    constexpr std::size_t many = 500, ways = 64;
    if (points.size() > many) {
        std::vector<Vec3> outermost;
        for (std::size_t k = 0; k < ways; ++k) {  // evenly over half a sphere, along a spiral
            const double z = (static_cast<double>(k) + 0.5) / ways, turn = 2.399963 * static_cast<double>(k);
            const Vec3 way(std::sqrt(1 - z * z) * std::cos(turn), std::sqrt(1 - z * z) * std::sin(turn), z);
            const auto [low, high] = std::ranges::minmax_element(points, {}, [&](const Vec3& p) { return p.dot(way); });
            outermost.insert(outermost.end(), {*low, *high});
        }
        points = std::move(outermost);
    }
    double longest = 0;
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) longest = std::max(longest, (points[i] - points[j]).squaredNorm());
    return std::sqrt(longest);
}

std::optional<double> contact(const Scene& scene, Regions r) {
    const TriangleTree &a = tree_of(scene, *r[0]), &b = tree_of(scene, *r[1]);
    const double reach = touch * scene.diagonal;
    std::vector<Vec3> points;
    collect_contacts(*r[1], a, b, reach, points);
    collect_contacts(*r[0], b, a, reach, points);
    const double longest_side = std::min(r[0]->part->box.lengths[0], r[1]->part->box.lengths[0]);
    return points.empty() || !(longest_side > 0) ? 0 : extent(std::move(points)) / longest_side;
}

Interval contact_range(const Scene& scene, Surrounds s) {
    return {0, apart(*s[0], *s[1]) > touch * scene.diagonal ? 0 : infinity};
}

std::optional<double> inside_share(const Scene& scene, Regions r) {
    const OrientedBox& box = r[1]->part->box;
    const Vec3 centre = scene.frame * box.centre;
    double within = 0;
    for (const std::int32_t t : r[0]->part->region.triangles) {
        const auto corners = corners_of(scene, t);
        Polygon polygon(corners.begin(), corners.end());
        for (int i = 0; i < 3 && !polygon.empty(); ++i) {
            const Vec3 axis = scene.frame * box.axes.col(i);
            for (const double side : {1.0, -1.0})
                polygon = clipped(polygon, side * axis, side * axis.dot(centre) + box.lengths[i] / 2);
        }
        within += moment_of(polygon).area;
    }
    return r[0]->area > 0 ? std::min(1.0, within / r[0]->area) : 0;
}

Interval inside_range(const Scene&, Surrounds s) {
    const double box_diagonal = s[1]->size_to.array().exp().matrix().norm();  // no point of the box is further away
    return {0, apart(*s[0], *s[1]) > box_diagonal ? 0.0 : 1.0};
}

/// Where the rays around `centre` first meet the region's part between two planes across `axis`, and where they last
/// leave it.
struct Outline {
    std::array<double, rays> near, far;
};
Outline outline(const Scene& scene, const RegionPlace& place, const Vec3& centre, int axis, double from, double to) {
    Outline result;
    result.near.fill(infinity);
    result.far.fill(-infinity);
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (const std::int32_t t : place.part->region.triangles) {
        const auto corners = corners_of(scene, t);
        const Polygon polygon =
            clipped(clipped({corners.begin(), corners.end()}, Vec3::Unit(axis), to), -Vec3::Unit(axis), -from);
        for (int ray = 0; ray < rays && !polygon.empty(); ++ray) {
            const double angle = 2 * std::numbers::pi * (ray + 0.5) / rays, x = std::cos(angle), y = std::sin(angle);
            double near = infinity, far = -infinity;
            bool is_around_centre = false;
            for (std::size_t i = 0; i < polygon.size(); ++i) {
                const Vec3 a = polygon[i] - centre, b = polygon[(i + 1) % polygon.size()] - centre;
                const double left_a = x * a[v] - y * a[u], left_b = x * b[v] - y * b[u];
                if ((left_a < 0) == (left_b < 0)) continue;
                const double share = left_a / (left_a - left_b);
                const double along = x * (a[u] + share * (b[u] - a[u])) + y * (a[v] + share * (b[v] - a[v]));
                if (along < 0) continue;
                near = std::min(near, along);
                far = std::max(far, along);
                is_around_centre = !is_around_centre;
            }
            const auto at = static_cast<std::size_t>(ray);
            result.near[at] = std::min(result.near[at], is_around_centre ? 0 : near);
            result.far[at] = std::max(result.far[at], far);
        }
    }
    return result;
}

std::optional<double> encirclement(const Scene& scene, Regions r) {
    constexpr double nearly = 0.9;  // what the target may reach into the reference
    const RegionPlace &target = *r[0], &reference = *r[1];
    const Vec3 centre = reference.middle();
    int most = 0;
    for (int axis = 0; axis < 3; ++axis) {
        const double from = reference.low[axis], to = reference.high[axis];
        if (target.low[axis] > to || target.high[axis] < from) continue;
        const Outline outer = outline(scene, target, centre, axis, from, to);
        const Outline inner = outline(scene, reference, centre, axis, from, to);
        int count = 0;
        for (std::size_t i = 0; i < rays; ++i)
            count += std::isfinite(outer.near[i]) && outer.near[i] > 0 && outer.near[i] >= nearly * inner.far[i];
        most = std::max(most, count);
    }
    return static_cast<double>(most) / rays;
}

/// A box beside the reference is seen from it within half a turn.
Interval encirclement_range(const Scene&, Surrounds s) { return {0, apart(*s[0], *s[1]) > 0 ? 0.5 + 1.0 / rays : 1.0}; }

}  // namespace

void add_contact_measures(std::vector<RelationMeasure>& measures) {
    measures.push_back({"gap", 2, "diagonal", "smallest distance between the two regions", gap, gap_range});
    measures.push_back({"contact", 2, "1", "length along which they touch, over the longest side of the smaller region",
                        contact, contact_range});
    measures.push_back({"inside share", 2, "1", "share of the target's surface within the reference's smallest box",
                        inside_share, inside_range});
    measures.push_back({"encirclement", 2, "1", "share of the ways out of the reference that meet the target beyond it",
                        encirclement, encirclement_range});
}

}  // namespace partonomy
