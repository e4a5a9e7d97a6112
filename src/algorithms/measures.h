#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "algorithms/object.h"

namespace partonomy {

/// When a measure is taken, and so when annotation.json holds it.
enum class Effort {
    at_once,    ///< in one pass over the region, always
    rays,       ///< for a question that needs rays: together with the other measures of look_around
    on_demand,  ///< for a question that needs it
};

/// What a measure needs of the colours of a mesh file.
enum class AppearanceNeed { none, colors, finish };

/// A measurement that core:measure may name.
struct Measure {
    std::string name;
    std::string unit;  ///< "1", "degrees", "m", "m2"
    std::string description;
    bool needs_metres;
    Effort effort;
    /// Lengths in metres when needs_metres, in file units as long as the unit is unknown; NaN when nothing can tell.
    std::function<double(const Object&, const RegionMeasurements&)> value;
};

/// All measures, in the order in which the catalogue prints them.
[[nodiscard]] std::span<const Measure> all_measures();

/// Puts a measure of a new name at the end, as plugins do; before any ontology is compiled.
void add_measure(Measure measure);

/// nullptr when there is none of that name.
[[nodiscard]] const Measure* find_measure(const std::string& name);

/// The value on a region; nullopt when it needs metres and the unit is unknown, or when nothing can tell.
[[nodiscard]] std::optional<double> evaluate(const Measure& measure, const Object& object,
                                             const RegionMeasurements& region);

/// The same where a unit is not asked for. What is measured on demand is kept in region.asked.
[[nodiscard]] std::optional<double> measure_once(const Measure& measure, const Object& object,
                                                 const RegionMeasurements& region);

}  // namespace partonomy
