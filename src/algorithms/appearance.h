#pragma once

#include <array>
#include <optional>
#include <span>

#include "algorithms/color_names.h"
#include "algorithms/formula.h"

namespace partonomy {

struct Catalogue;

/// What a region looks like, weighted by area.
struct RegionColors {
    double known = 0;                           ///< share of the area whose colour is told
    Lab mean{0, 0, 0};                          ///< of what is known
    std::array<double, 11> names{};             ///< shares of color_names
    double chroma = 0;                          ///< mean
    double spread = 0;                          ///< root mean square distance from the mean
    std::optional<double> metallic, roughness;  ///< means; nullopt where less than half of the area tells them
};

/// How the colours of a region lie beside each other, from its waves: shares of the colours' variance in [0, 1].
struct RegionPattern {
    double stripes = 0;  ///< in one wave of two periods or more, beyond what a crossing one has
    double checks = 0;   ///< in two waves that cross, twice the weaker of them
    double grain = 0;    ///< in none of them, and too fine to be a border or a shade
};

/// Measured when first asked for. The object must have an appearance.
[[nodiscard]] const RegionColors& look_at_colors(const Object& object, const RegionMeasurements& region);
[[nodiscard]] const RegionPattern& look_at_pattern(const Object& object, const RegionMeasurements& region);

/// The measures of colour and finish: not a number for a region about which the file tells nothing.
[[nodiscard]] std::span<const Measure> appearance_measures();

[[nodiscard]] AppearanceNeed appearance_need(const Measure& measure);
[[nodiscard]] AppearanceNeed appearance_need(const Formula& formula);

/// Whether the object's file tells what a measure needs.
[[nodiscard]] bool tells(const Object& object, AppearanceNeed need);

/// Whether a question may be answered by colour or finish: otherwise no file's colours need be read.
[[nodiscard]] bool needs_appearance(const Catalogue& catalogue);

/// Gives the object its appearance, which may be null, and cuts its candidates along the borders of colours.
void paint(Object& object, std::shared_ptr<const Appearance> appearance);

/// Cuts candidate regions where their colours change: connected pieces of one colour, of a fiftieth of the region at
/// least. Pieces of colours that come back, as in stripes and checks, stay together: they are a pattern.
void split_by_color(Object& object);

}  // namespace partonomy
