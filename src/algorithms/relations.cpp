/* Measurements between regions, for the relations of paper §3.2.2: T asks whether some regions are in a relation.
 *
 * Each is a number over which the ontology lays a trapezoid, as for `is a`. Most read boxes only, along the sides of
 * the object's smallest upright box: a box says enough about above and beside, costs nothing, and turns with the
 * object. Lengths are fractions of the object's height or diagonal, so that no unit is needed.
 *
 * Gap is exact where it matters: regions that share a vertex touch; else the smallest distance between their triangles,
 * among those triangles that come nearer than a twentieth of the diagonal (regions cut from several shells, or by a
 * scan, do not share vertices); a larger gap is a twentieth, or the distance of the boxes. The triangles of one region
 * are swept past those of the other, and what cannot beat the smallest distance so far is skipped. Distance of two
 * triangles (Ericson, "Real-Time Collision Detection", 2005, chapter 5): 0 when an edge of one pierces the other, else
 * the smallest of vertex to triangle (6) and edge to edge (9). Cost: O(n log n) and the pairs that overlap along the
 * sweep, where n triangles are near the other region. */

#include "algorithms/relations.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "shape/membership.h"

namespace partonomy {
namespace {

using Triangle = std::array<Vec3, 3>;
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double far_away = 0.05;  ///< of the object's diagonal: a larger gap is not measured exactly

/// Corners of the convex hull, counter-clockwise (Andrew's monotone chain).
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
    const auto before = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
        return std::pair(a.x(), a.y()) < std::pair(b.x(), b.y());
    };
    std::ranges::sort(points, before);
    const auto turns_left = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
        return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x()) > 0;
    };
    std::vector<Eigen::Vector2d> hull;
    for (const bool lower : {true, false}) {
        const std::size_t start = hull.size();
        for (const Eigen::Vector2d& p : points) {
            while (hull.size() >= start + 2 && !turns_left(hull[hull.size() - 2], hull.back(), p)) hull.pop_back();
            hull.push_back(p);
        }
        hull.pop_back();  // where the other half begins
        if (lower) std::ranges::reverse(points);
    }
    return hull;
}

double diagonal(const Object& object) { return compute_bounds(object.mesh).diagonal(); }
double height(const Object& object) { return object.high - object.low; }
double fraction(double part, double whole) { return whole > 0 ? part / whole : 0; }

/// Distance of two intervals; negative when they overlap: how far.
double distance_along(const RegionPlace& a, const RegionPlace& b, int axis) {
    return std::max(a.low[axis] - b.high[axis], b.low[axis] - a.high[axis]);
}

/// Horizontal distance of the boxes, 0 when one stands over the other.
double horizontal_distance(const RegionPlace& a, const RegionPlace& b) {
    return std::hypot(std::max(0.0, distance_along(a, b, 0)), std::max(0.0, distance_along(a, b, 1)));
}

/// Overlap of two intervals, as a fraction of the shorter one.
double overlap_along(const RegionPlace& a, const RegionPlace& b, int axis) {
    const double shorter = std::min(a.high[axis] - a.low[axis], b.high[axis] - b.low[axis]);
    const double overlap = -distance_along(a, b, axis);
    return shorter > 0 ? std::clamp(overlap / shorter, 0.0, 1.0) : (overlap >= 0 ? 1.0 : 0.0);
}

Vec3 nearest_in_box(const RegionPlace& box, const Vec3& point) { return point.cwiseMax(box.low).cwiseMin(box.high); }

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a;
    const double length = ab.squaredNorm();
    return length > 0 ? Vec3(a + std::clamp((p - a).dot(ab) / length, 0.0, 1.0) * ab) : a;
}

double distance_to_triangle(const Vec3& p, const Triangle& t) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double size = normal.norm();
    if (size > 0) {
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i) inside &= (t[(i + 1) % 3] - t[i]).cross(p - t[i]).dot(normal) >= 0;
        if (inside) return std::abs((p - t[0]).dot(normal)) / size;
    }
    double nearest = infinity;
    for (std::size_t i = 0; i < 3; ++i)
        nearest = std::min(nearest, (p - nearest_on_segment(p, t[i], t[(i + 1) % 3])).norm());
    return nearest;
}

double distance_of_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = d - c, w = a - c;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), determinant = uu * vv - uv * uv;
    double nearest = std::min({(a - nearest_on_segment(a, c, d)).norm(), (b - nearest_on_segment(b, c, d)).norm(),
                               (c - nearest_on_segment(c, a, b)).norm(), (d - nearest_on_segment(d, a, b)).norm()});
    if (determinant > 1e-12 * uu * vv) {
        const double s = (uv * v.dot(w) - vv * u.dot(w)) / determinant,
                     t = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1) nearest = std::min(nearest, (a + s * u - c - t * v).norm());
    }
    return nearest;
}

bool pierces(const Vec3& a, const Vec3& b, const Triangle& t) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double from = (a - t[0]).dot(normal), to = (b - t[0]).dot(normal);
    if (from == to || (from > 0) == (to > 0)) return false;
    const Vec3 p = a + from / (from - to) * (b - a);
    for (std::size_t i = 0; i < 3; ++i)
        if ((t[(i + 1) % 3] - t[i]).cross(p - t[i]).dot(normal) < 0) return false;
    return true;
}

double distance_of_triangles(const Triangle& a, const Triangle& b) {
    double nearest = infinity;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &from = a[i], &to = a[(i + 1) % 3];
        if (pierces(from, to, b) || pierces(b[i], b[(i + 1) % 3], a)) return 0;
        nearest = std::min({nearest, distance_to_triangle(from, b), distance_to_triangle(b[i], a)});
        for (std::size_t j = 0; j < 3; ++j)
            nearest = std::min(nearest, distance_of_segments(from, to, b[j], b[(j + 1) % 3]));
    }
    return nearest;
}

struct PlacedTriangle {
    Triangle corners;
    Vec3 low, high;
};

/// Triangles of the region that come as near to the box as `reach`.
std::vector<PlacedTriangle> near_triangles(const Object& object, const RegionPlace& of, const RegionPlace& box,
                                           double reach) {
    std::vector<PlacedTriangle> result;
    for (const int t : of.part->region.triangles) {
        const auto& corners = object.mesh.triangles[static_cast<std::size_t>(t)];
        PlacedTriangle placed;
        for (std::size_t i = 0; i < 3; ++i)
            placed.corners[i] = of.frame * object.mesh.positions[static_cast<std::size_t>(corners[i])];
        placed.low = placed.corners[0].cwiseMin(placed.corners[1]).cwiseMin(placed.corners[2]);
        placed.high = placed.corners[0].cwiseMax(placed.corners[1]).cwiseMax(placed.corners[2]);
        if (((placed.low - box.high).array() > reach).any() || ((box.low - placed.high).array() > reach).any())
            continue;
        result.push_back(placed);
    }
    return result;
}

/// The axis along which the triangles spread most.
int longest_axis(const std::vector<PlacedTriangle>& triangles) {
    Vec3 low = Vec3::Constant(infinity), high = -low;
    for (const PlacedTriangle& each : triangles) {
        low = low.cwiseMin(each.low);
        high = high.cwiseMax(each.high);
    }
    int axis = 0;
    if (!triangles.empty()) (high - low).maxCoeff(&axis);
    return axis;
}

bool share_a_vertex(const Object& object, const RegionPlace& a, const RegionPlace& b) {
    std::vector<std::int32_t> vertices;
    for (const int t : a.part->region.triangles)
        for (const std::int32_t v : object.mesh.triangles[static_cast<std::size_t>(t)]) vertices.push_back(v);
    std::ranges::sort(vertices);
    return std::ranges::any_of(b.part->region.triangles, [&](int t) {
        return std::ranges::any_of(object.mesh.triangles[static_cast<std::size_t>(t)],
                                   [&](std::int32_t v) { return std::ranges::binary_search(vertices, v); });
    });
}

double gap(const Object& object, std::span<const RegionPlace* const> regions) {
    const RegionPlace &a = *regions[0], &b = *regions[1];
    const double size = diagonal(object), reach = far_away * size;
    double apart = 0;
    for (int axis = 0; axis < 3; ++axis) apart = std::max(apart, distance_along(a, b, axis));
    if (apart > reach) return fraction(apart, size);
    if (share_a_vertex(object, a, b)) return 0;
    std::vector<PlacedTriangle> of_a = near_triangles(object, a, b, reach), of_b = near_triangles(object, b, a, reach);
    const int axis = longest_axis(of_b);
    for (std::vector<PlacedTriangle>* triangles : {&of_a, &of_b})
        std::ranges::stable_sort(*triangles, {}, [&](const PlacedTriangle& each) { return each.low[axis]; });
    double nearest = reach;
    std::size_t first = 0;
    for (const PlacedTriangle& x : of_a) {
        // What ends before this triangle begins, ends before all later ones do.
        while (first < of_b.size() && of_b[first].high[axis] < x.low[axis] - reach) ++first;
        for (std::size_t i = first; i < of_b.size() && of_b[i].low[axis] <= x.high[axis] + nearest; ++i) {
            const PlacedTriangle& y = of_b[i];
            if (((y.low - x.high).array() >= nearest).any() || ((x.low - y.high).array() >= nearest).any()) continue;
            nearest = std::min(nearest, distance_of_triangles(x.corners, y.corners));
            if (nearest == 0) return 0;
        }
    }
    return fraction(nearest, size);
}

double rise(const Object& object, std::span<const RegionPlace* const> regions) {
    const RegionPlace &target = *regions[0], &reference = *regions[1];
    return fraction((target.low.z() + target.high.z()) / 2 - reference.high.z(), height(object));
}

double side_step(const Object& object, std::span<const RegionPlace* const> regions) {
    return fraction(horizontal_distance(*regions[0], *regions[1]), diagonal(object));
}

double level_overlap(const Object&, std::span<const RegionPlace* const> regions) {
    return overlap_along(*regions[0], *regions[1], 2);
}

double footprint_overlap(const Object&, std::span<const RegionPlace* const> regions) {
    return overlap_along(*regions[0], *regions[1], 0) * overlap_along(*regions[0], *regions[1], 1);
}

double opening_angle(const Object&, std::span<const RegionPlace* const> regions) {
    const Vec3& centre = regions[0]->centre;
    const Vec3 to_first = nearest_in_box(*regions[1], centre) - centre;
    const Vec3 to_second = nearest_in_box(*regions[2], centre) - centre;
    const double lengths = to_first.norm() * to_second.norm();
    if (!(lengths > 0)) return 0;  // inside of one of them
    return std::acos(std::clamp(to_first.dot(to_second) / lengths, -1.0, 1.0)) * 180 / std::numbers::pi;
}

const std::array<RelationMeasure, 6> measures = {{
    {"gap", 2, "diagonal", "smallest distance between the two regions; from 0.05 on, at least that", gap},
    {"rise", 2, "height", "from the top of the reference up to the middle of the target", rise},
    {"side step", 2, "diagonal", "horizontal distance of the two boxes, 0 when one is over the other", side_step},
    {"level overlap", 2, "1", "common range of heights, as a fraction of the lower region's", level_overlap},
    {"footprint overlap", 2, "1", "common ground of the two boxes, as fractions of the narrower ones",
     footprint_overlap},
    {"opening angle", 3, "degrees", "in the middle of the target, between the ways to the two references",
     opening_angle},
}};

}  // namespace

Eigen::Matrix3d upright_frame(const Object& object) {
    const Vec3& up = object.placement.up;
    const Vec3 helper = std::abs(up.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
    const Vec3 first = helper.cross(up).normalized(), second = up.cross(first);
    std::vector<Eigen::Vector2d> points;
    for (const Vec3& p : object.mesh.positions) points.emplace_back(p.dot(first), p.dot(second));
    const std::vector<Eigen::Vector2d> hull = convex_hull(std::move(points));
    double smallest = infinity;
    Eigen::Vector2d side = Eigen::Vector2d::UnitX();
    for (std::size_t i = 0; i < hull.size(); ++i) {  // a smallest rectangle has a side along an edge of the hull
        const Eigen::Vector2d edge = hull[(i + 1) % hull.size()] - hull[i];
        if (!(edge.norm() > 0)) continue;
        const Eigen::Vector2d along = edge.normalized(), across(-along.y(), along.x());
        Eigen::Vector2d low = Eigen::Vector2d::Constant(infinity), high = -low;
        for (const Eigen::Vector2d& p : hull) {
            const Eigen::Vector2d q(p.dot(along), p.dot(across));
            low = low.cwiseMin(q);
            high = high.cwiseMax(q);
        }
        const double area = (high - low).prod();
        if (area < smallest * (1 - 1e-9)) {
            smallest = area;
            side = along;
        }
    }
    Eigen::Matrix3d frame;
    frame.row(2) = up;
    frame.row(0) = side.x() * first + side.y() * second;
    frame.row(1) = up.cross(Vec3(frame.row(0)));
    return frame;
}

RegionPlace place_of(const Object& object, const PartRegion& part, const Eigen::Matrix3d& frame) {
    RegionPlace place;
    place.part = &part;
    place.frame = frame;
    place.low = Vec3::Constant(infinity);
    place.high = Vec3::Constant(-infinity);
    place.centre = Vec3::Zero();
    double area = 0;
    for (const int t : part.region.triangles) {
        const double weight = object.geometry.areas[static_cast<std::size_t>(t)];
        place.centre += weight * (frame * object.geometry.barycentres[static_cast<std::size_t>(t)]);
        area += weight;
        for (const std::int32_t v : object.mesh.triangles[static_cast<std::size_t>(t)]) {
            const Vec3 p = frame * object.mesh.positions[static_cast<std::size_t>(v)];
            place.low = place.low.cwiseMin(p);
            place.high = place.high.cwiseMax(p);
        }
    }
    if (area > 0) place.centre /= area;
    return place;
}

std::span<const RelationMeasure> all_relation_measures() { return measures; }

const RelationMeasure* find_relation_measure(const std::string& name) {
    for (const RelationMeasure& measure : measures)
        if (name == measure.name) return &measure;
    return nullptr;
}

std::optional<double> relation_score(std::span<const knowledge::Criterion> criteria, const Object& object,
                                     std::span<const RegionPlace* const> regions) {
    if (criteria.empty()) return std::nullopt;
    double score = 1;
    for (const knowledge::Criterion& c : criteria) {
        const RelationMeasure* measure = find_relation_measure(c.measure);
        if (!measure || measure->arity != regions.size()) return std::nullopt;
        score = std::min(score, Trapezoid{c.a1, c.a2, c.a3, c.a4}(measure->value(object, regions)));
    }
    return score;
}

const knowledge::Criterion& touching() {
    static const knowledge::Criterion criterion{"gap", -infinity, -infinity, 0.005, 0.015};
    return criterion;
}

}  // namespace partonomy
