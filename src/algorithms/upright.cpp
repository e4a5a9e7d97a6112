/* A frame that turns with the object: up, and the sides of the smallest upright box.
 *
 * That box lies askew to things that are wider at one end than at the other: an aeroplane with swept wings. Where an
 * object is its own mirror image in an upright plane, but not in one along that box, the plane is a side of the frame.
 * Scenes have no such plane.
 *
 * The smallest rectangle around the plan has a side along an edge of its convex hull, so each is tried: O(n log n) for
 * the hull, O(h²) for its h edges.
 *
 * Front. Chairs, sofas, benches with a back and cars are told apart from their own mirror image by what stands up at
 * one side: the surface in the upper third of the object lies off the middle of the plan. The front is the opposite
 * side. It must be off by a tenth of the plan along one side of the box, and by less than half of that along the other;
 * else (tables, stools, cupboards) the object has no front that its shape tells, and relations that need one stay open.
 */

#include "algorithms/upright.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "algorithms/clip.h"
#include "algorithms/mirror_plane.h"

namespace partonomy {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

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

Eigen::Matrix3d upright_frame(const Object& object) {
    const Vec3& up = object.placement.up;
    const Vec3 helper = std::abs(up.x()) < 0.9 ? Vec3::UnitX() : Vec3::UnitY();
    const Vec3 first = helper.cross(up).normalized(), second = up.cross(first);
    std::vector<Eigen::Vector2d> points;
    points.reserve(object.mesh.positions.size());
    for (const Vec3& p : object.mesh.positions) points.emplace_back(p.dot(first), p.dot(second));
    const std::vector<Eigen::Vector2d> hull = convex_hull(std::move(points));
    double smallest = infinity;
    Eigen::Vector2d side = Eigen::Vector2d::UnitX();
    for (std::size_t i = 0; i < hull.size(); ++i) {
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

/// Turns the frame to the object's mirror plane, where it has one and the frame is surely not along it.
void turn_to_mirror_plane(const Object& object, Eigen::Matrix3d& frame) {
    constexpr double surely_not = 3 * mirror_tolerance;
    for (const int side : {0, 1})
        if (mirror_asymmetry(object, frame.row(side)) < surely_not) return;
    if (const std::optional<Vec3> side = mirror_side(object)) {
        frame.row(0) = *side;
        frame.row(1) = object.placement.up.cross(*side);
    }
}

std::optional<Vec3> front_of(const Scene& scene) {
    const Object& object = *scene.object;
    const double from = scene.low.z() + scene.height() * 2 / 3;
    Moment above;
    for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t) {
        const auto corners = corners_of(scene, static_cast<std::int32_t>(t));
        if (std::max({corners[0].z(), corners[1].z(), corners[2].z()}) <= from) continue;
        const Moment part = moment_of(clipped({corners.begin(), corners.end()}, -Vec3::UnitZ(), -from));
        above.area += part.area;
        above.first += part.first;
    }
    if (!(above.area > 0)) return std::nullopt;
    const Vec3 mean = above.first / above.area;
    const Vec3 off = (mean - (scene.low + scene.high) / 2).cwiseQuotient(scene.high - scene.low);
    const int along = std::abs(off.x()) > std::abs(off.y()) ? 0 : 1;
    constexpr double clearly_off = 0.1;
    if (!(std::abs(off[along]) >= clearly_off && std::abs(off[1 - along]) < std::abs(off[along]) / 2))
        return std::nullopt;
    Vec3 front = Vec3::Zero();
    front[along] = off[along] > 0 ? -1 : 1;
    return front;
}

}  // namespace

std::array<Vec3, 3> corners_of(const Scene& scene, std::int32_t triangle) {
    const auto& corners = scene.object->mesh.triangles[static_cast<std::size_t>(triangle)];
    const auto at = [&](std::size_t i) -> Vec3 {
        return scene.frame * scene.object->mesh.positions[static_cast<std::size_t>(corners[i])];
    };
    return {at(0), at(1), at(2)};
}

Scene scene_of(const Object& object) {
    Scene scene;
    scene.object = &object;
    scene.frame = upright_frame(object);
    if (!object.is_scene) turn_to_mirror_plane(object, scene.frame);
    scene.frame.row(2) = object.heights;  // up, but for scenes on a slope
    scene.low = Vec3::Constant(infinity);
    scene.high = -scene.low;
    for (const Vec3& position : object.mesh.positions) {
        const Vec3 p = scene.frame * position;
        scene.low = scene.low.cwiseMin(p);
        scene.high = scene.high.cwiseMax(p);
    }
    scene.diagonal = (scene.high - scene.low).norm();
    scene.front = front_of(scene);
    return scene;
}

RegionPlace place_of(const Scene& scene, const PartRegion& part) {
    RegionPlace place;
    place.part = &part;
    place.low = Vec3::Constant(infinity);
    place.high = Vec3::Constant(-infinity);
    place.centre = Vec3::Zero();
    place.spread = Eigen::Matrix3d::Zero();
    for (const std::int32_t t : part.region.triangles) {
        auto corners = corners_of(scene, t);
        for (Vec3& corner : corners) {
            place.low = place.low.cwiseMin(corner);
            place.high = place.high.cwiseMax(corner);
            corner -= scene.low;  // moments lose digits far from the origin
        }
        const double area = scene.object->geometry.areas[static_cast<std::size_t>(t)];
        const Vec3 sum = corners[0] + corners[1] + corners[2];
        place.area += area;
        place.centre += area / 3 * sum;
        Eigen::Matrix3d moments = sum * sum.transpose();  // of a triangle, the mean of p pᵀ is (s sᵀ + Σ c cᵀ) / 12
        for (const Vec3& corner : corners) moments += corner * corner.transpose();
        place.spread += area / 12 * moments;
    }
    if (place.area > 0) {
        place.centre /= place.area;
        place.spread = place.spread / place.area - place.centre * place.centre.transpose();
    }
    place.centre += scene.low;
    return place;
}

}  // namespace partonomy
