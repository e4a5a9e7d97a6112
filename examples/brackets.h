#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "examples/objects.h"

namespace partonomy {

/// The kinds of defects that a bracket may have, by the local name of the diagnosis in ontologies/inspection.omn.
[[nodiscard]] std::span<const std::string> bracket_defects();

/// A manufactured part: a plate with two rows of bolt holes, two ribs, and bosses between them, some of them bored.
/// Numbers, sizes, places, sides of what is round, direction, place in the room and unit (metres or millimetres) are
/// drawn from the seed; the same seed gives the same part everywhere. With a defect it is sound but for that. Throws
/// UsageError for a defect that is not in bracket_defects().
[[nodiscard]] ExampleObject bracket(std::uint32_t seed, const std::string& defect = {});

}  // namespace partonomy
