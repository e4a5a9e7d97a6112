#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "examples/objects.h"

namespace partonomy {

/// How a building of a street is made.
enum class BuildingStyle {
    slabs,   ///< a slab for each wall and the roof, door and windows sunk into them: closed solids of their own
    solid,   ///< a block for all walls, door and windows standing out from it, a slab or a gable for the roof
    carved,  ///< one closed surface, door and windows carved into it
    mixed,   ///< each building another one of these
};

struct StreetOptions {
    std::uint64_t seed = 1;
    std::size_t triangles = 200'000;  ///< at least as many, and few more; 0: a box has twelve
    int buildings_a_side = 4;
    BuildingStyle style = BuildingStyle::mixed;
    bool has_trees = true;
    /// Local names of diagnoses in street.ttl to seed, each once: DoorOntoNothing, LampInRoad, TreeInRoad,
    /// CarOnPavement, BlockedDoor, RooflessWall.
    std::vector<std::string> faults = {};
};

/// A street made at random (paper Fig. 4): ground, road, pavements, buildings with doors and windows, lamp posts,
/// trees, benches and parked cars. Labels are concepts of street.ttl; `incompatibility` is the first fault. Metres, z
/// up, the lowest point at 0. Throws UsageError for an unknown fault.
[[nodiscard]] ExampleObject street(const StreetOptions& options = {});

}  // namespace partonomy
