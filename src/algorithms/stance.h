#pragma once

#include "algorithms/object.h"

// What an object as a whole looks like as it stands.

namespace partonomy {

/// From one side of an object with a back, such as a chair, to the other: a horizontal unit vector, or zero where there
/// is no back. What is high lies behind what is low: across the horizontal direction in which height grows. Found the
/// first time that it is asked for.
[[nodiscard]] const Vec3& sideways_of(const Object& object);

/// How high, above the object's lowest point and in file units, most of the surface that looks up lies: the seat of a
/// chair, the top of a table. Of two levels with nearly as much the higher one. Found the first time that it is asked
/// for.
[[nodiscard]] double main_level(const Object& object);

}  // namespace partonomy
