#include "examples/lamps.h"

#include <cmath>
#include <numbers>

#include "examples/solid.h"

// A lamp is one body of revolution around the z axis, with 24 sides: a disc as its base, a pole that grows out of it,
// and a shade, wider below than above, closed at both ends, around the top of the pole. Rings of corners are shared, so
// the surface is closed and the borders of parts are edges.

namespace partonomy {
namespace {

struct Sizes {
    double base_radius, pole_top, shade_bottom_radius, shade_top_radius, shade_height;
};

constexpr double base_height = 0.03, pole_radius = 0.015;

std::vector<Solid::Vertex> ring(Solid& solid, double radius, double z) {
    constexpr int sides = 24;
    std::vector<Solid::Vertex> corners;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2 * std::numbers::pi * i / sides;
        corners.push_back(solid.at(radius * std::cos(angle), radius * std::sin(angle), z));
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

}  // namespace

std::vector<ExampleObject> lamps() {
    const Sizes floor{0.16, 1.3, 0.2, 0.14, 0.3}, table{0.1, 0.3, 0.14, 0.08, 0.2},
        small_foot{0.07, 1.3, 0.2, 0.14, 0.3};
    return {lamp(floor, true, "floor-lamp", "FloorLamp"), lamp(table, true, "table-lamp", "TableLamp"),
            lamp(small_foot, true, "tippy-lamp", "FloorLamp", "LampThatTips"), lamp(floor, false, "stand", "")};
}

}  // namespace partonomy
