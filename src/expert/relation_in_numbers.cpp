#include "expert/relation_in_numbers.h"

#include <fmt/format.h>

#include <cmath>

namespace partonomy {
namespace {

/// "<= 0.35", ">= 0.02", "0.1 to 0.3": where the trapezoid is at least 0.5.
std::string wanted(const knowledge::Criterion& criterion) {
    const double low = (criterion.a1 + criterion.a2) / 2, high = (criterion.a3 + criterion.a4) / 2;
    if (std::isfinite(low) && std::isfinite(high)) return fmt::format("{:.3g} to {:.3g}", low, high);
    return std::isfinite(low) ? fmt::format(">= {:.3g}", low) : fmt::format("<= {:.3g}", high);
}

}  // namespace

std::string relation_in_numbers(std::span<const knowledge::Criterion> criteria, const Scene& scene,
                                RelationMeasure::Regions regions) {
    std::string text;
    for (const knowledge::Criterion& criterion : criteria) {
        const RelationMeasure* measure = find_relation_measure(criterion.measure);
        const bool fits = measure != nullptr && measure->arity == regions.size();
        const std::optional<double> value = fits ? measure->value(scene, regions) : std::nullopt;
        const std::string unit =
            fits && (measure->unit == "degrees" || measure->unit == "m") ? " " + measure->unit : "";
        text += fmt::format("{}{} {}{} (wanted {})", text.empty() ? "" : ", ", criterion.measure,
                            value ? fmt::format("{:.3g}", *value) : "?", unit, wanted(criterion));
    }
    return text;
}

}  // namespace partonomy
