#pragma once

#include <optional>

#include "algorithms/object.h"

namespace partonomy {

/// How far an object is from being its own mirror image in the upright plane through the middle of its surface that
/// `side` (a horizontal unit vector) is the normal of: 0 for a mirror image, about 0.2 to 2 for anything else.
[[nodiscard]] double mirror_asymmetry(const Object& object, const Vec3& side);

/// The normal of an upright plane in which the object is its own mirror image; nullopt where there is none, or where
/// sums over its surface tell no direction (round things, regular polygons).
[[nodiscard]] std::optional<Vec3> mirror_side(const Object& object);

/// Asymmetries below this are those of noise and of joints.
inline constexpr double mirror_tolerance = 0.05;

}  // namespace partonomy
