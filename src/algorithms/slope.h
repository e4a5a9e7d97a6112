#pragma once

#include <optional>

#include "algorithms/object.h"

namespace partonomy {

/// What heights in a scene are read along: the height of a point p is its dot product with it. Up, unless the ground is
/// a slope: then up less the slope, so that the ground is at one height and everything upright keeps its own. Needs the
/// object's tree.
[[nodiscard]] Vec3 height_direction(const Object& object);

/// Height of the ground's upper side in a scene, read along object.heights; nothing where the object has no surface.
/// Needs the object's tree.
[[nodiscard]] std::optional<double> ground_level(const Object& object);

}  // namespace partonomy
