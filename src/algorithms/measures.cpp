/* The measurements behind `is a` (paper §6.3). Each reads from RegionMeasurements, so asking twice costs nothing.
 *
 * End height. The paper compares the highest, central and lowest points of region and object. We look at the end of the
 * region that is nearer to the object's own end: a region nearer to the ground is judged by its lowest point, one
 * nearer to the top by its highest point, both as fractions of the object's height. A leg that almost reaches the top
 * of a table is down (0), its top is up (1), a seat lies in between; a side wall from floor to top stands on the
 * ground, so it is down. */

#include "algorithms/measures.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include "algorithms/appearance.h"
#include "algorithms/form.h"
#include "algorithms/stance.h"
#include "base/errors.h"
#include "shape/corners.h"
#include "shape/oriented_box.h"

namespace partonomy {
namespace {

constexpr std::size_t most_measures = 256;

double ratio(double a, double b) { return b > 0 ? a / b : std::numeric_limits<double>::infinity(); }

double metres(const Object& object, double length) { return length * object.placement.metres_per_unit.value_or(1); }

double end_height(const Object& object, const RegionMeasurements& region) {
    const double height = object.high - object.low;
    if (!(height > 0)) return 0;
    const double above_ground = (region.low - object.low) / height;
    const double below_top = (object.high - region.high) / height;
    return above_ground <= below_top ? above_ground : 1 - below_top;
}

double length_inclination(const Object& object, const RegionMeasurements& region) {
    const double sine = std::abs(region.axes.col(0).dot(object.placement.up));
    return std::asin(std::min(1.0, sine)) * 180 / std::numbers::pi;
}

double crosswise_angle(const Object& object, const RegionMeasurements& region) {
    const double sine = std::abs(region.axes.col(0).dot(sideways_of(object)));
    return std::asin(std::min(1.0, sine)) * 180 / std::numbers::pi;
}

/// The longest side of the smallest box around the whole object, in file units: the same however it stands.
double object_length(const Object& object) {
    if (!object.length) {
        std::vector<std::int32_t> all(object.mesh.triangles.size());
        std::iota(all.begin(), all.end(), 0);
        std::vector<Vec3> points;
        for (const std::int32_t v : corners_of(object.mesh, all)) points.push_back(object.mesh.positions[v]);
        object.length = smallest_box(points).lengths[0];
    }
    return *object.length;
}

double object_area(const Object& object) {
    if (!object.area) object.area = std::accumulate(object.geometry.areas.begin(), object.geometry.areas.end(), 0.0);
    return *object.area;
}

std::vector<Measure> built_in_measures() {
    return {
        {"l0/l1", "1", "longest over middle length of the smallest oriented box", false, Effort::at_once,
         [](const Object&, const RegionMeasurements& r) { return ratio(r.lengths[0], r.lengths[1]); }},
        {"l1/l2", "1", "middle over shortest length of the smallest oriented box", false, Effort::at_once,
         [](const Object&, const RegionMeasurements& r) { return ratio(r.lengths[1], r.lengths[2]); }},
        {"l0/l2", "1", "longest over shortest length of the smallest oriented box", false, Effort::at_once,
         [](const Object&, const RegionMeasurements& r) { return ratio(r.lengths[0], r.lengths[2]); }},
        {"inclination", "degrees",
         "angle of a stick's axis, or of the largest side of anything else, to the horizontal", false, Effort::at_once,
         [](const Object&, const RegionMeasurements& r) { return r.inclination; }},
        {"end height", "1", "height of the end that is nearest to the object's own end, 0 ground to 1 top", false,
         Effort::at_once, end_height},
        {"relative height", "1", "height of the middle of the region, 0 ground to 1 top of the object", false,
         Effort::at_once,
         [](const Object& o, const RegionMeasurements& r) {
             return ((r.low + r.high) / 2 - o.low) / (o.high - o.low);
         }},
        {"top height", "m",
         "height of the region's highest point above the object's lowest, in a scene above the ground", true,
         Effort::at_once, [](const Object& o, const RegionMeasurements& r) { return metres(o, r.high - o.low); }},
        {"length", "m", "longest length of the smallest oriented box", true, Effort::at_once,
         [](const Object& o, const RegionMeasurements& r) { return metres(o, r.lengths[0]); }},
        {"width", "m", "middle length of the smallest oriented box", true, Effort::at_once,
         [](const Object& o, const RegionMeasurements& r) { return metres(o, r.lengths[1]); }},
        {"thickness", "m", "shortest length of the smallest oriented box", true, Effort::at_once,
         [](const Object& o, const RegionMeasurements& r) { return metres(o, r.lengths[2]); }},
        {"area", "m2", "area of the region's surface", true, Effort::at_once,
         [](const Object& o, const RegionMeasurements& r) { return metres(o, metres(o, r.area)); }},
        {"extent", "1", "height from the region's lowest to its highest point, over the object's height", false,
         Effort::at_once,
         [](const Object& o, const RegionMeasurements& r) { return ratio(r.high - r.low, o.high - o.low); }},
        {"footprint share", "1",
         "area of the region's upper side, over that of the object's outline, both seen from above", false,
         Effort::at_once, [](const Object& o, const RegionMeasurements& r) { return ratio(r.plan_area, o.footprint); }},
        {"upper area", "m2", "area of the region's upper side, seen from above", true, Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) { return metres(o, metres(o, r.plan_area)); }},
        {"open above", "1", "share of the region's upper side that nothing of the object is above", false, Effort::rays,
         [](const Object& o, const RegionMeasurements& r) { return look_around(o, r).open_above; }},
        {"room above", "1", "share of the upper side with nothing above it within a tenth of the object's height",
         false, Effort::rays,
         [](const Object& o, const RegionMeasurements& r) { return look_around(o, r).room_above; }},
        {"room below", "1", "how much of the height below the region is empty: 0 none, 1 all", false, Effort::rays,
         [](const Object& o, const RegionMeasurements& r) { return look_around(o, r).room_below; }},
        {"bottom height", "m",
         "height of the region's lowest point above the object's lowest, in a scene above the ground", true,
         Effort::on_demand, [](const Object& o, const RegionMeasurements& r) { return metres(o, r.low - o.low); }},
        {"foot height", "1", "height of the region's lowest point, 0 ground to 1 top of the object", false,
         Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) { return ratio(r.low - o.low, o.high - o.low); }},
        {"level height", "1",
         "height of the middle of the region over that of the object's main level, where most of what looks up lies: "
         "below 1 under a seat or a top, above 1 over it",
         false, Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) {
             return ratio((r.low + r.high) / 2 - o.low, main_level(o));
         }},
        {"length inclination", "degrees", "angle of the longest side of the smallest oriented box to the horizontal",
         false, Effort::on_demand, length_inclination},
        {"crosswise angle", "degrees",
         "angle of the longest side of the smallest oriented box to the plane between left and right of an object with "
         "a back: 90 runs from side to side, 0 from front to back, upright, or where there is no back",
         false, Effort::on_demand, crosswise_angle},
        {"length share", "1", "longest length over that of the whole object, however it stands", false,
         Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) { return ratio(r.lengths[0], object_length(o)); }},
        {"area share", "1", "area of the region's surface over that of the whole object", false, Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) { return ratio(r.area, object_area(o)); }},
        {"l0", "m", "another name of length, for combinations", true, Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) { return metres(o, r.lengths[0]); }},
        {"l1", "m", "another name of width", true, Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) { return metres(o, r.lengths[1]); }},
        {"l2", "m", "another name of thickness", true, Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) { return metres(o, r.lengths[2]); }},
        {"volume", "m3", "what the region encloses, its openings closed", true, Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) {
             return metres(o, metres(o, metres(o, enclosed_volume(o, r))));
         }},
        {"wall", "1", "thickness of the material, half of it at least, over the shortest length of the box", false,
         Effort::on_demand, wall_thickness},
        {"section spread", "1", "how far the outline of a cross-section is from an ellipse: 0 is round, a square 0.1",
         false, Effort::on_demand, section_spread},
        {"taper", "1", "size of the smaller end's cross-section over that of the larger end", false, Effort::on_demand,
         end_ratio},
        {"bend", "1", "how far the middle line leaves a straight line, over its length", false, Effort::on_demand,
         bend},
        {"convexity", "1", "1 bulging outward all over, -1 inward as the wall of a hole, 0 flat or both alike", false,
         Effort::on_demand, convexity},
        {"mirror difference", "1",
         "mean distance between the region and its mirror image in the best vertical plane, over its size", false,
         Effort::on_demand, mirror_difference},
        {"turn difference", "1",
         "the same for a turn about a vertical axis, by a half down to a sixth of a whole turn, the best of them",
         false, Effort::on_demand, turn_difference},
        {"flat share", "1", "share of the surface that is flat", false, Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) { return kind_share(o, r, SurfaceKind::flat); }},
        {"cylinder share", "1", "share of the surface that is part of a cylinder", false, Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) { return kind_share(o, r, SurfaceKind::cylinder); }},
        {"sphere share", "1", "share of the surface that is part of a sphere", false, Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) { return kind_share(o, r, SurfaceKind::sphere); }},
        {"cone share", "1", "share of the surface that is part of a cone", false, Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) { return kind_share(o, r, SurfaceKind::cone); }},
        {"torus share", "1", "share of the surface that is part of a torus", false, Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) { return kind_share(o, r, SurfaceKind::torus); }},
        {"primitive share", "1", "the largest of these five", false, Effort::on_demand, primitive_share},
        {"arc", "degrees",
         "how far its largest cylinder or cone goes round: 360 a hole or a round stick, 90 a rounded corner, 0 none",
         false, Effort::on_demand, arc},
        {"rectangle fill", "1", "area of the largest flat patch, holes filled, over that of its smallest rectangle",
         false, Effort::on_demand,
         [](const Object& o, const RegionMeasurements& r) { return largest_outline(o, r).rectangle; }},
        {"disc fill", "1", "area of the largest flat patch, holes filled, over that of a disc as wide", false,
         Effort::on_demand, [](const Object& o, const RegionMeasurements& r) { return largest_outline(o, r).disc; }},
    };
}

std::vector<Measure>& registry() {
    static std::vector<Measure> measures = [] {
        std::vector<Measure> all = built_in_measures();
        all.insert(all.end(), appearance_measures().begin(), appearance_measures().end());
        all.reserve(most_measures);  // so that none of them ever moves
        return all;
    }();
    return measures;
}

}  // namespace

std::span<const Measure> all_measures() { return registry(); }

void add_measure(Measure measure) {
    if (registry().size() == most_measures) throw UsageError("there are too many plugins; load fewer of them");
    registry().push_back(std::move(measure));
}

const Measure* find_measure(const std::string& name) {
    for (const Measure& measure : registry())
        if (name == measure.name) return &measure;
    return nullptr;
}

std::optional<double> evaluate(const Measure& measure, const Object& object, const RegionMeasurements& region) {
    if (measure.needs_metres && !object.placement.metres_per_unit) return std::nullopt;
    return measure_once(measure, object, region);
}

std::optional<double> measure_once(const Measure& measure, const Object& object, const RegionMeasurements& region) {
    if (measure.effort != Effort::on_demand) return measure.value(object, region);
    const auto known = region.asked.find(measure.name);
    const double value = known != region.asked.end() ? known->second : measure.value(object, region);
    if (std::isnan(value)) return std::nullopt;
    if (known == region.asked.end()) region.asked.emplace(measure.name, value);
    return value;
}

}  // namespace partonomy
