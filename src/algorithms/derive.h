#pragma once

#include <functional>
#include <map>
#include <span>
#include <vector>

#include "algorithms/object.h"

namespace partonomy {

/// What a derived `find all` browses (paper §3.4.2): the parts of the mesh and what neighbouring parts make together;
/// or these and the pieces of surface that each part is made of (core:regions "patches").
enum class Grain { parts, patches };

/// What a derived `find all` found.
struct DerivedRegion {
    PartRegion part;
    double score = 0;             ///< of `is a`, >= 0.5
    std::vector<std::size_t> of;  ///< the parts that it was made of or cut from, ascending
    bool is_whole = false;        ///< it is one of the parts, unchanged
};
struct DerivedRegions {
    std::vector<DerivedRegion> found;
    std::vector<PartRegion> rests;  ///< connected remainders of the parts that something was cut from
};

/// SF from SI: the disjoint regions among the candidates that are likely to be what `is_a` scores, with the most area
/// times score times fit together; `is_a` is nullopt when nothing can tell. O(n log n) for the candidates, and a
/// measurement of each.
[[nodiscard]] DerivedRegions derive_find_all(
    const Object& object, std::span<const PartRegion* const> parts, Grain grain,
    const std::function<std::optional<double>(const RegionMeasurements&)>& is_a);

/// The parts that are others once each curved patch of the surface lies on one part only; without triangles where
/// nothing is left of a part. A derived `find all` among patches needs such parts, or it finds a hole in pieces.
[[nodiscard]] std::map<std::size_t, PartRegion> keep_patches_whole(const Object& object,
                                                                   std::span<const PartRegion* const> parts);

}  // namespace partonomy
