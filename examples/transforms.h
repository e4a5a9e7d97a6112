#pragma once

#include <cstdint>

#include "examples/objects.h"

namespace partonomy {

// The same object in another place or another mesh of the same surface; labels and parts follow the triangles. An
// answer about the object must not change under any of them but scaled.

[[nodiscard]] ExampleObject rotated_about_z(ExampleObject object, double degrees);
[[nodiscard]] ExampleObject translated(ExampleObject object, const Vec3& by);
[[nodiscard]] ExampleObject scaled(ExampleObject object, double factor);
/// x becomes -x; triangles are turned so that they still face outward.
[[nodiscard]] ExampleObject mirrored(ExampleObject object);
/// Faces in an order drawn from `seed`, the same on every machine; vertices stay.
[[nodiscard]] ExampleObject with_permuted_faces(ExampleObject object, std::uint64_t seed);
/// Each triangle cut into four at the middles of its edges, in place of it: triangle i becomes 4 i ... 4 i + 3.
[[nodiscard]] ExampleObject subdivided(const ExampleObject& object);

}  // namespace partonomy
