/* Where one thing stands on, under or beside another, in metres: for scenes, of which a fraction says nothing. Without
 * a unit they have no answer.
 *
 * Two things are seen from above. What a thing covers is the convex outline of its points, so that a road that runs
 * askew covers no more than its own ground. The distance of two outlines is 0 when no side of either parts them, else
 * that of the nearest corner and side. The mesh is passed once for each region that is asked about; a rectangle's
 * corners are exact, a disc is taken for a polygon of 64 corners. Cost: O(n) a region, then O(1) a pair. */

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "algorithms/relation_measures.h"

namespace partonomy {
namespace {

using Point = Eigen::Vector2d;
constexpr double infinity = std::numeric_limits<double>::infinity();

double cross(const Point& a, const Point& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Corners counter-clockwise, seen from above: the farthest points in 64 directions.
const std::vector<Point>& outline_of(const Scene& scene, const RegionPlace& place) {
    if (!place.outline.empty()) return place.outline;
    constexpr int directions = 64;
    std::array<Point, directions> ways, farthest;
    std::array<double, directions> distances;
    distances.fill(-infinity);
    for (int i = 0; i < directions; ++i) {
        const double angle = 2 * std::numbers::pi * (i + 0.5) / directions;
        ways[static_cast<std::size_t>(i)] = {std::cos(angle), std::sin(angle)};
    }
    const TriangleMesh& mesh = scene.object->mesh;
    for (const std::int32_t t : place.part->region.triangles)
        for (const std::int32_t v : mesh.triangles[static_cast<std::size_t>(t)]) {
            const Point p = scene.frame.topRows<2>() * mesh.positions[static_cast<std::size_t>(v)];
            for (std::size_t i = 0; i < directions; ++i)
                if (const double along = p.dot(ways[i]); along > distances[i]) {
                    distances[i] = along;
                    farthest[i] = p;
                }
        }
    for (const Point& p : farthest)
        if (place.outline.empty() || (p != place.outline.back() && p != place.outline.front()))
            place.outline.push_back(p);
    return place.outline;
}

double distance_to_border(const Point& p, std::span<const Point> outline) {
    double nearest = infinity;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Point &from = outline[i], side = outline[(i + 1) % outline.size()] - from;
        const double length = side.squaredNorm();
        const double along = length > 0 ? std::clamp((p - from).dot(side) / length, 0.0, 1.0) : 0;
        nearest = std::min(nearest, (p - from - along * side).norm());
    }
    return nearest;
}

/// 0 within the outline, which goes round to the left.
double distance(const Point& p, std::span<const Point> outline) {
    bool is_inside = outline.size() > 2;
    for (std::size_t i = 0; is_inside && i < outline.size(); ++i)
        is_inside = cross(outline[(i + 1) % outline.size()] - outline[i], p - outline[i]) >= 0;
    return is_inside ? 0 : distance_to_border(p, outline);
}

bool is_parted(const std::vector<Point>& a, const std::vector<Point>& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        const Point side = a[(i + 1) % a.size()] - a[i];
        if (std::ranges::all_of(b, [&](const Point& p) { return cross(side, p - a[i]) < 0; })) return true;
    }
    return false;
}

using Regions = RelationMeasure::Regions;

std::optional<double> in_metres(const Scene& scene, double length) {
    const std::optional<double>& metres = scene.object->placement.metres_per_unit;
    return metres ? std::optional(*metres * length) : std::nullopt;
}

std::optional<double> foot_rise(const Scene& scene, Regions r) {
    return in_metres(scene, r[0]->low.z() - r[1]->high.z());
}

Interval foot_rise_range(const Scene& scene, std::span<const Surround* const> s) {
    const double metres = scene.object->placement.metres_per_unit.value_or(infinity);
    if (metres == infinity) return {-infinity, infinity};
    return {metres * (s[0]->low_from.z() - s[1]->high_to.z()), metres * (s[0]->low_to.z() - s[1]->high_from.z())};
}

/// Of the boxes: what stands within them is no nearer, and so is no middle.
Interval plan_range(const Scene& scene, std::span<const Surround* const> s) {
    const std::optional<double>& metres = scene.object->placement.metres_per_unit;
    if (!metres) return {-infinity, infinity};
    const auto apart =
        (s[0]->low_from - s[1]->high_to).cwiseMax(s[1]->low_from - s[0]->high_to).cwiseMax(0.0).head<2>().eval();
    return {*metres * apart.norm(), infinity};
}

std::optional<double> plan_distance(const Scene& scene, Regions r) {
    const std::vector<Point>&a = outline_of(scene, *r[0]), &b = outline_of(scene, *r[1]);
    if (!is_parted(a, b) && !is_parted(b, a)) return in_metres(scene, 0);
    double nearest = infinity;
    for (const Point& p : a) nearest = std::min(nearest, distance(p, b));
    for (const Point& p : b) nearest = std::min(nearest, distance(p, a));
    return in_metres(scene, nearest);
}

/// From p to the triangles of the region, seen from above.
double distance_to_surface(const Scene& scene, const RegionPlace& place, const Point& p) {
    const TriangleMesh& mesh = scene.object->mesh;
    double nearest = infinity;
    for (const std::int32_t t : place.part->region.triangles) {
        std::array<Point, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] = scene.frame.topRows<2>() *
                         mesh.positions[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(t)][i])];
        const Point low = corners[0].cwiseMin(corners[1]).cwiseMin(corners[2]),
                    high = corners[0].cwiseMax(corners[1]).cwiseMax(corners[2]);
        if ((low - p).cwiseMax(p - high).cwiseMax(0.0).norm() >= nearest) continue;
        if (cross(corners[1] - corners[0], corners[2] - corners[0]) < 0) std::swap(corners[1], corners[2]);
        nearest = std::min(nearest, distance(p, corners));
        if (nearest == 0) return 0;
    }
    return nearest;
}

/// Within the outline what counts is the surface, which may follow a bend or lie around something. A hole that the
/// target itself fills, standing on it in one closed surface, is none.
std::optional<double> middle_distance(const Scene& scene, Regions r) {
    const std::vector<Point>& target = outline_of(scene, *r[0]);
    Point middle = Point::Zero();
    for (const Point& p : target) middle += p / static_cast<double>(target.size());
    const double outside = distance(middle, outline_of(scene, *r[1]));
    if (outside > 0) return in_metres(scene, outside);
    const double reach = distance_to_border(middle, target);
    return in_metres(scene, std::max(0.0, distance_to_surface(scene, *r[1], middle) - 1.1 * reach));
}

}  // namespace

void add_plan_measures(std::vector<RelationMeasure>& measures) {
    measures.push_back({"foot rise", 2, "m", "from the top of the reference up to the foot of the target", foot_rise,
                        foot_rise_range});
    measures.push_back({"plan distance", 2, "m", "distance of the two seen from above, 0 where they overlap",
                        plan_distance, plan_range});
    measures.push_back({"middle distance", 2, "m",
                        "from the middle of the target to the reference, seen from above; 0 over it", middle_distance,
                        plan_range});
}

}  // namespace partonomy
