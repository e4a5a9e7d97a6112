#include "examples/lamps.h"

#include <cmath>
#include <numbers>

#include "examples/solid.h"

// A lamp is one body of revolution around the z axis, with 24 sides: a disc as its base, a pole that grows out of it,
// and a shade, wider below than above, closed at both ends, around the top of the pole. Rings of corners are shared, so
// the surface is closed and the borders of parts are edges. Desk lamps are solids that reach into each other: a disc,
// stems of two sticks, and under each stem's end a hood, a drum of thin sheet that is open below.

namespace partonomy {
namespace {

struct Sizes {
    double base_radius, pole_top, shade_bottom_radius, shade_top_radius, shade_height;
};

constexpr double base_height = 0.03, pole_radius = 0.015;

std::vector<Solid::Vertex> ring(Solid& solid, double radius, double z, double middle = 0) {
    constexpr int sides = 24;
    std::vector<Solid::Vertex> corners;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        corners.push_back(solid.at(middle + radius * std::cos(angle), radius * std::sin(angle), z));
    }
    return corners;
}

/// The wall between two rings; `upper` is above `lower`, or inside it at the same height and the wall faces up.
void wall(Solid& solid, const std::vector<Solid::Vertex>& lower, const std::vector<Solid::Vertex>& upper) {
    for (std::size_t i = 0; i < lower.size(); ++i) {
        const std::size_t j = (i + 1) % lower.size();
        solid.face({lower[i], lower[j], upper[j], upper[i]});
    }
}

ExampleObject lamp(const Sizes& sizes, bool has_shade, const std::string& name, const std::string& object_class,
                   const std::string& incompatibility = {}) {
    Solid solid;
    const auto foot = ring(solid, sizes.base_radius, 0), rim = ring(solid, sizes.base_radius, base_height),
               joint = ring(solid, pole_radius, base_height), neck = ring(solid, pole_radius, sizes.pole_top);
    solid.begin_part("Base");
    solid.face(foot, true);
    wall(solid, foot, rim);
    wall(solid, rim, joint);
    solid.begin_part("Pole");
    wall(solid, joint, neck);
    if (has_shade) {
        const auto below = ring(solid, sizes.shade_bottom_radius, sizes.pole_top),
                   above = ring(solid, sizes.shade_top_radius, sizes.pole_top + sizes.shade_height);
        solid.begin_part("Shade");
        wall(solid, neck, below);
        wall(solid, below, above);
        solid.face(above);
    } else {
        solid.face(neck);
    }
    return std::move(solid).finish(name, object_class, incompatibility);
}

/// A square stick between two points of the plane y = 0.
void stick(Solid& solid, const Vec3& from, const Vec3& to) {
    constexpr double half = 0.01;
    const Vec3 across = half * Vec3(from.z() - to.z(), 0, to.x() - from.x()).normalized();
    std::vector<Solid::Vertex> ends[2];
    for (const int end : {0, 1})
        for (const auto& [a, y] : {std::pair{-1.0, -half}, {-1.0, half}, {1.0, half}, {1.0, -half}}) {
            const Vec3 corner = (end == 0 ? from : to) + a * across;
            ends[end].push_back(solid.at(corner.x(), y, corner.z()));
        }
    solid.face(ends[0], true);
    wall(solid, ends[0], ends[1]);
    solid.face(ends[1]);
}

/// A stem and a hood to the right (1) or left (-1) of its foot.
void arm(Solid& solid, double foot, int side) {
    const Vec3 joint(foot - 0.06 * side, 0, 0.6), end(foot + 0.24 * side, 0, 0.415);
    solid.begin_part("Pole");
    stick(solid, {foot, 0, base_height - 0.005}, joint);
    solid.begin_part("Arm");
    stick(solid, joint, end);
    constexpr double low = 0.26, top = 0.4, sheet = 0.006, radius = 0.07;
    const auto at = [&](double r, double z) { return ring(solid, r, z, end.x()); };
    const auto brim = at(radius, low), outside = at(radius, top), inner_brim = at(radius - sheet, low),
               inside = at(radius - sheet, top - sheet);
    solid.begin_part("HoodWall");
    wall(solid, inner_brim, brim);
    wall(solid, brim, outside);
    wall(solid, inside, inner_brim);
    solid.begin_part("HoodTop");
    solid.face(outside);
    solid.face(inside, true);
}

ExampleObject desk_lamp(bool is_twin) {
    Solid solid;
    const auto foot = ring(solid, 0.12, 0), rim = ring(solid, 0.12, base_height);
    solid.begin_part("Base");
    solid.face(foot, true);
    wall(solid, foot, rim);
    solid.face(rim);
    arm(solid, is_twin ? 0.08 : 0, 1);
    if (is_twin) arm(solid, -0.08, -1);
    return std::move(solid).finish(is_twin ? "twin-lamp" : "desk-lamp", is_twin ? "TwinLamp" : "DeskLamp");
}

}  // namespace

std::vector<ExampleObject> lamps() {
    const Sizes floor{0.16, 1.3, 0.2, 0.14, 0.3}, table{0.1, 0.3, 0.14, 0.08, 0.2},
        small_foot{0.07, 1.3, 0.2, 0.14, 0.3};
    return {lamp(floor, true, "floor-lamp", "FloorLamp"),
            lamp(table, true, "table-lamp", "TableLamp"),
            lamp(small_foot, true, "tippy-lamp", "FloorLamp", "LampThatTips"),
            lamp(floor, false, "stand", ""),
            desk_lamp(false),
            desk_lamp(true)};
}

}  // namespace partonomy
