/* What is above and below a region.
 *
 * From points spread evenly over the region's upper side, a ray goes up: it leaves the object, or something is above,
 * as on all boards of a shelf but its topmost. Another ray comes from below the object straight up to the point: what
 * it meets first is where the room below ends. Under a tabletop that is nearly all of the height; under a cabinet's top
 * none. Of an open sheet the side that is larger in plan counts as the upper one. At most 48 pairs of rays a region,
 * shot when a question needs them for the first time. */

#include <algorithm>
#include <cmath>

#include "algorithms/object.h"

namespace partonomy {
namespace {

constexpr double flat_enough = 0.5;  // cosine between normal and up
constexpr double room = 0.1;         // of the object's height: less is no room
constexpr int most_points = 48;

/// Points at equal steps of plan area over the triangles that look along `side`.
std::vector<Vec3> upper_points(const Object& object, const RegionMeasurements& region, const Vec3& side) {
    double total = 0;
    const auto plan = [&](std::int32_t t) {
        const double cosine = object.geometry.normals[static_cast<std::size_t>(t)].dot(side);
        return cosine > flat_enough ? cosine * object.geometry.areas[static_cast<std::size_t>(t)] : 0;
    };
    for (const std::int32_t t : region.triangles) total += plan(t);
    std::vector<Vec3> points;
    if (!(total > 0)) return points;
    const double step = total / most_points;
    double next = step / 2, sum = 0;
    double u = 0.5, v = 0.5;
    for (const std::int32_t t : region.triangles) {
        sum += plan(t);
        const auto& corners = object.mesh.triangles[static_cast<std::size_t>(t)];
        const auto corner = [&](std::size_t i) -> const Vec3& {
            return object.mesh.positions[static_cast<std::size_t>(corners[i])];
        };
        for (; next < sum; next += step) {
            // Steps by the plastic number's powers fill a square evenly; folding it makes a triangle.
            u = std::fmod(u + 0.7548776662466927, 1.0), v = std::fmod(v + 0.5698402909980532, 1.0);
            const double a = u + v > 1 ? 1 - u : u, b = u + v > 1 ? 1 - v : v;
            points.push_back(corner(0) + a * (corner(1) - corner(0)) + b * (corner(2) - corner(0)));
        }
    }
    return points;
}

}  // namespace

const Surroundings& look_around(const Object& object, const RegionMeasurements& region) {
    if (region.surroundings) return *region.surroundings;
    Surroundings& result = region.surroundings.emplace();
    const Vec3& up = object.placement.up;
    std::vector<Vec3> points = upper_points(object, region, up);
    if (points.empty()) points = upper_points(object, region, -up);
    const double height = object.high - object.low;
    if (points.empty() || !(height > 0)) return result;
    const double lift = 1e-4 * height;
    for (const Vec3& point : points) {
        const auto above = object.tree->first_hit(point + lift * up, up);
        if (!above) result.open_above += 1;
        if (!above || *above > room * height) result.room_above += 1;
        const double above_ground = point.dot(object.heights) - object.low;
        const double start = above_ground + 0.01 * height;
        const auto way = object.tree->first_hit(point - start * up, up);
        if (way && above_ground > lift)
            result.room_below += std::clamp((*way - 0.01 * height) / above_ground, 0.0, 1.0);
    }
    result.open_above /= static_cast<double>(points.size());
    result.room_above /= static_cast<double>(points.size());
    result.room_below /= static_cast<double>(points.size());
    return result;
}

}  // namespace partonomy
