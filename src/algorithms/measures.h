#pragma once

#include <optional>
#include <span>
#include <string>

#include "algorithms/object.h"

namespace partonomy {

/// A measurement that core:measure may name.
struct Measure {
    const char* name;
    const char* unit;  ///< "1", "degrees", "m", "m2"
    const char* description;
    bool needs_metres;
    bool needs_rays;  ///< measured only when a question needs it
    double (*value)(const Object&, const RegionMeasurements&);  ///< lengths in metres when needs_metres
};

/// All measures, in the order in which the catalogue prints them.
[[nodiscard]] std::span<const Measure> all_measures();

/// nullptr when there is none of that name.
[[nodiscard]] const Measure* find_measure(const std::string& name);

/// The value on a region; nullopt when it needs metres and the unit is unknown.
[[nodiscard]] std::optional<double> evaluate(const Measure& measure, const Object& object,
                                             const RegionMeasurements& region);

}  // namespace partonomy
