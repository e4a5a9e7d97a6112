#pragma once

#include <string>
#include <vector>

#include "examples/objects.h"

namespace partonomy {

/// A turn about up, then a shift.
struct Pose {
    Vec3 at = Vec3::Zero();
    double degrees = 0;
    [[nodiscard]] Vec3 operator()(const Vec3& p) const;
};

/// A box along the axes that belongs to a part, or is cut out of the boxes before it.
struct Block {
    Vec3 low, high;
    std::string label;
    int part = 0;         ///< number of the part within its shape
    bool is_cut = false;  ///< cut out; the side of the hole that faces along `facing` is the part, the others are not
    Vec3 facing = Vec3::Zero();
};

/// A closed surface of one scene, in its own coordinates. Counts and meshes are for triangles with legs of at most
/// `edge`.
struct Shape {
    enum class Kind { blocks, gable, cone, ball };
    Kind kind = Kind::blocks;
    Pose pose;
    std::vector<Block> blocks;            ///< their union, later ones win; a gable: its box, the ridge along x
    double low = 0, height = 0;           ///< cone: upright, from `low` on, or ball: its diameter
    double radius = 0, upper_radius = 0;  ///< of a cone; a ball has the first, flattened to its height
    std::string label;                    ///< of a cone or ball, which is one part
};

/// A scene of separate closed surfaces.
struct ShapeScene {
    std::vector<Shape> shapes;
    [[nodiscard]] std::size_t triangle_count(double edge) const;
    /// The longest edge with which the scene has at least that many triangles.
    [[nodiscard]] double edge_for(std::size_t triangles) const;
    /// The mesh with labels and parts of its triangles.
    [[nodiscard]] ExampleObject mesh(double edge) const;
};

}  // namespace partonomy
