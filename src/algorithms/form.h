#pragma once

#include "algorithms/object.h"

namespace partonomy {

// Measures of a region's form beyond its box; docs/elementary-algorithms.md says what each value means. Lengths and
// volumes in file units; NaN when nothing can tell. They stand on samples, so that triangles and noise do not matter.

/// The object's surface with noise taken out, made the first time that it is asked for (not from two threads at once).
[[nodiscard]] const CalmSurface& calm_surface(const Object& object);

/// The same with its creases kept where the region has triangles enough to tell them from noise.
[[nodiscard]] const CalmSurface& surface_of(const Object& object, const RegionMeasurements& region);

/// Points of equal shares of the region's area, made the first time that they are asked for; empty without area.
[[nodiscard]] const SurfaceSamples& samples_of(const Object& object, const RegionMeasurements& region);

[[nodiscard]] double enclosed_volume(const Object& object, const RegionMeasurements& region);
[[nodiscard]] double wall_thickness(const Object& object, const RegionMeasurements& region);
[[nodiscard]] double section_spread(const Object& object, const RegionMeasurements& region);
[[nodiscard]] double end_ratio(const Object& object, const RegionMeasurements& region);
[[nodiscard]] double bend(const Object& object, const RegionMeasurements& region);
[[nodiscard]] double convexity(const Object& object, const RegionMeasurements& region);
[[nodiscard]] double mirror_difference(const Object& object, const RegionMeasurements& region);
[[nodiscard]] double turn_difference(const Object& object, const RegionMeasurements& region);

/// What the region's surface is made of, cut the first time that it is asked for.
[[nodiscard]] const std::vector<Patch>& patches_of(const Object& object, const RegionMeasurements& region);
/// Share of the area in patches of a kind; and that of the most frequent kind but freeform.
[[nodiscard]] double kind_share(const Object& object, const RegionMeasurements& region, SurfaceKind kind);
[[nodiscard]] double primitive_share(const Object& object, const RegionMeasurements& region);
/// How far round its axis the largest cylinder or cone goes with what is concentric with it, in degrees; 0 without one.
[[nodiscard]] double arc(const Object& object, const RegionMeasurements& region);
/// Of the largest flat patch.
[[nodiscard]] Outline largest_outline(const Object& object, const RegionMeasurements& region);

}  // namespace partonomy
