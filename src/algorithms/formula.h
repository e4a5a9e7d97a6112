#pragma once

#include <optional>
#include <string>
#include <vector>

#include "algorithms/measures.h"

namespace partonomy {

enum class FormulaOperation : char { measure, number, add, subtract, multiply, divide, negate };

/// What core:measure says, parsed: the name of a measure, or sums, differences, products and ratios of measures and
/// numbers with parentheses, such as "top height - bottom height" or "area / (length * length)".
template <typename M>
struct FormulaOver {
    using Operation = FormulaOperation;
    struct Step {
        Operation operation;
        const M* measure = nullptr;
        double number = 0;
    };
    std::string text;
    std::vector<Step> steps;  ///< operands before their operation
    std::string unit;         ///< "1", "degrees", "m", "m2", "1/m", "degrees/m" …
    bool needs_metres = false;
};

/// Over measures of one region; those over measures between regions are in relation_formula.h.
using Formula = FormulaOver<Measure>;

/// Metres and degrees are not added to each other; a number takes the unit of what it is added to. Throws OntologyError
/// with one sentence, without a place: a measure that does not exist (with the nearest right name), units that do not
/// go together, or what is no formula at all.
[[nodiscard]] Formula parse_formula(const std::string& text);

/// The value on a region; nullopt when nothing can tell: a division by zero, or metres without a unit. A ratio of
/// lengths needs no unit.
[[nodiscard]] std::optional<double> evaluate(const Formula& formula, const Object& object,
                                             const RegionMeasurements& region);

}  // namespace partonomy
