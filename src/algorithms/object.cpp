/* What the questions of paper §6.3 stand on.
 *
 * Inclination. Of a stick, the angle between its long axis and the horizontal plane; of anything else, the angle
 * between its largest side and the horizontal plane, which the shortest axis is the normal of. So 0 is horizontal and
 * 90 vertical for both. A block whose lengths are nearly equal has no largest side: of its nearly equal sides the most
 * horizontal one is taken, so that noise does not turn it over.
 *
 * Extent along up. The triangles that reach furthest are left out up to a two-hundredth of the region's area at either
 * end, so that a sliver that strayed across a border does not change "reaches the ground" into its opposite. On a
 * coarse mesh no triangle is that small, and nothing is left out. */

#include "algorithms/object.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <numbers>

#include "algorithms/appearance.h"
#include "algorithms/mirrored_cut.h"
#include "algorithms/slope.h"
#include "base/errors.h"
#include "shape/hull_area.h"

namespace partonomy {
namespace {

constexpr double stray_area_fraction = 0.005;

double degrees_above_horizontal(const Vec3& axis, const Vec3& up) {
    return std::asin(std::min(1.0, std::abs(axis.dot(up)))) * 180 / std::numbers::pi;
}

double inclination_of(const OrientedBox& box, const Vec3& up) {
    const double l0 = box.lengths[0], l1 = box.lengths[1], l2 = box.lengths[2];
    const bool is_stick = l0 >= 2 * l1 && l1 < 2 * l2;
    if (is_stick) return degrees_above_horizontal(box.axes.col(0), up);
    constexpr double nearly_equal = 1.25;
    double steepest_normal = degrees_above_horizontal(box.axes.col(2), up);
    for (const int i : {1, 0})
        if (box.lengths[i] < nearly_equal * l2)
            steepest_normal = std::max(steepest_normal, degrees_above_horizontal(box.axes.col(i), up));
    return 90 - steepest_normal;
}

/// The value that all but `spare` of the weight lies at or above, when the pairs (value, weight) ascend.
double trimmed_end(std::vector<std::pair<double, double>>& ends, double spare) {
    std::sort(ends.begin(), ends.end());
    double left = spare;
    for (const auto& [value, weight] : ends) {
        left -= weight;
        if (left < 0) return value;
    }
    return ends.back().first;
}

/// Extent in height, of a scene from the ground, and the area of the convex outline seen from above. Cleaning left no
/// vertex without a triangle.
void stand(Object& object) {
    object.heights = object.is_scene ? height_direction(object) : object.placement.up;
    object.low = std::numeric_limits<double>::infinity();
    object.high = -object.low;
    const Vec3 x = object.placement.up.unitOrthogonal(), y = object.placement.up.cross(x);
    std::vector<Eigen::Vector2d> plan;
    plan.reserve(object.mesh.positions.size());
    for (const Vec3& position : object.mesh.positions) {
        const double z = position.dot(object.heights);
        object.low = std::min(object.low, z);
        object.high = std::max(object.high, z);
        plan.emplace_back(position.dot(x), position.dot(y));
    }
    object.footprint = hull_area(std::move(plan));
    if (object.is_scene) object.low = ground_level(object).value_or(object.low);
}

}  // namespace

Vec3 parse_up(const std::string& word) {
    static const std::map<std::string, Vec3> words = {
        {"x", Vec3::UnitX()}, {"+x", Vec3::UnitX()}, {"-x", -Vec3::UnitX()},
        {"y", Vec3::UnitY()}, {"+y", Vec3::UnitY()}, {"-y", -Vec3::UnitY()},
        {"z", Vec3::UnitZ()}, {"+z", Vec3::UnitZ()}, {"-z", -Vec3::UnitZ()}};
    const auto found = words.find(word);
    if (found == words.end()) throw UsageError("--up " + word + ": unknown axis, use x, -x, y, -y, z, -z or auto");
    return found->second;
}

std::optional<double> parse_unit(const std::string& word) {
    static const std::map<std::string, std::optional<double>> words = {
        {"m", 1.0}, {"cm", 0.01}, {"mm", 0.001}, {"in", 0.0254}, {"auto", std::nullopt}};
    const auto found = words.find(word);
    if (found == words.end()) throw UsageError("--unit " + word + ": unknown unit, use m, cm, mm, in or auto");
    return found->second;
}

Object make_object(TriangleMesh mesh, const Placement& placement, int threads, bool is_scene) {
    Object object;
    object.is_scene = is_scene;
    object.mesh = std::move(mesh);
    object.geometry = compute_geometry(object.mesh);
    object.placement = placement;
    const auto start = std::chrono::steady_clock::now();
    object.tree = std::make_shared<const RayTree>(object.mesh, threads);
    object.times.emplace_back(
        "tree", std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    stand(object);
    cut(object, threads);
    return object;
}

void place(Object& object, const Placement& placement) {
    object.placement = placement;
    object.sideways.reset();
    object.level.reset();
    stand(object);
}

void cut(Object& object, int threads) {
    object.candidates =
        find_parts(object.mesh, {object.placement.up, threads, object.tree, object.is_scene}, &object.times);
    object.is_noisy = std::ranges::any_of(object.candidates, &PartRegion::is_noisy);
    if (!object.is_scene) cut_both_sides_alike(object, threads);
    if (object.appearance) split_by_color(object);
}

RegionMeasurements measure_region(const Object& object, const PartRegion& part) {
    RegionMeasurements result;
    result.triangles = part.region.triangles;
    double upward = 0, downward = 0;
    result.lengths = part.box.lengths;
    result.axes = part.box.axes;
    result.centre = part.box.centre;
    result.inclination = inclination_of(part.box, object.placement.up);
    std::vector<std::pair<double, double>> lows, highs;
    for (const int t : part.region.triangles) {
        double low = std::numeric_limits<double>::infinity(), high = -low;
        for (const int v : object.mesh.triangles[static_cast<std::size_t>(t)]) {
            const double z = object.mesh.positions[static_cast<std::size_t>(v)].dot(object.heights);
            low = std::min(low, z);
            high = std::max(high, z);
        }
        const double area = object.geometry.areas[static_cast<std::size_t>(t)];
        result.area += area;
        const double plan = area * object.geometry.normals[static_cast<std::size_t>(t)].dot(object.placement.up);
        (plan > 0 ? upward : downward) += std::abs(plan);
        lows.emplace_back(low, area);
        highs.emplace_back(-high, area);
    }
    result.plan_area = std::max(upward, downward);
    if (!lows.empty()) {
        result.low = trimmed_end(lows, stray_area_fraction * result.area);
        result.high = -trimmed_end(highs, stray_area_fraction * result.area);
    }
    return result;
}

}  // namespace partonomy
