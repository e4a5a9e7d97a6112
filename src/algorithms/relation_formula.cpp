/* Combinations of measures between regions, as formula.cpp has them of one region.
 *
 * A combination is a measure like any other. Between which numbers it lies, for whole groups of regions, follows from
 * its measures by interval arithmetic: so T and TF leave out as much as they do for a single one. Where a divisor may
 * be 0, or nothing is known of a measure, nothing is known of the value. */

#include "algorithms/relation_formula.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "algorithms/formula_parser.h"

namespace partonomy {
namespace {

using RelationFormula = FormulaOver<RelationMeasure>;
using Surrounds = std::span<const Surround* const>;
using Operation = FormulaOperation;

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Interval anything{-infinity, infinity};

/// The least and the largest of the four; anything where one of them is no number.
Interval hull(double a, double b, double c, double d) {
    if (std::isnan(a) || std::isnan(b) || std::isnan(c) || std::isnan(d)) return anything;
    return {std::min({a, b, c, d}), std::max({a, b, c, d})};
}

Interval combined(Operation operation, const Interval& a, const Interval& b) {
    switch (operation) {
        case Operation::add:
            return hull(a.low + b.low, a.low + b.low, a.high + b.high, a.high + b.high);
        case Operation::subtract:
            return hull(a.low - b.high, a.low - b.high, a.high - b.low, a.high - b.low);
        case Operation::multiply:
            return hull(a.low * b.low, a.low * b.high, a.high * b.low, a.high * b.high);
        default:
            if (b.low <= 0 && b.high >= 0) return anything;
            return hull(a.low / b.low, a.low / b.high, a.high / b.low, a.high / b.high);
    }
}

Interval range_of(const RelationFormula& formula, const Scene& scene, Surrounds surrounds) {
    std::vector<Interval> stack;
    for (const RelationFormula::Step& step : formula.steps) {
        if (step.operation == Operation::number) {
            stack.push_back({step.number, step.number});
        } else if (step.operation == Operation::measure) {
            stack.push_back(step.measure->range ? step.measure->range(scene, surrounds) : anything);
        } else if (step.operation == Operation::negate) {
            stack.back() = {-stack.back().high, -stack.back().low};
        } else {
            const Interval b = stack.back();
            stack.pop_back();
            stack.back() = combined(step.operation, stack.back(), b);
        }
    }
    return stack.back();
}

std::optional<double> value_of(const RelationFormula& formula, const Scene& scene, RelationMeasure::Regions regions) {
    const auto value = run(formula, [&](const RelationMeasure& measure) { return measure.value(scene, regions); });
    return value && !std::isnan(*value) ? value : std::nullopt;
}

}  // namespace

std::shared_ptr<const RelationMeasure> parse_relation_formula(const std::string& text) {
    if (const RelationMeasure* one = find_relation_measure(text))
        return {std::shared_ptr<const RelationMeasure>(), one};  // it is in the registry for good
    const auto elsewhere = [](const std::string& word) {
        return find_measure(word) ? fmt::format(
                                        "\"{}\" is measured of one region, and a relation needs what is measured "
                                        "between regions; partonomy catalogue lists such measures",
                                        word)
                                  : std::string();
    };
    FormulaParser<RelationMeasure> parser(text, all_relation_measures(), elsewhere);
    RelationFormula formula = parser.parse();
    const RelationMeasure* first = nullptr;
    bool by_size = true;
    for (const RelationFormula::Step& step : formula.steps) {
        if (step.operation != Operation::measure) continue;
        if (!first) first = step.measure;
        by_size = by_size && step.measure->by_size;
        if (step.measure->arity != first->arity)
            parser.fail(fmt::format("\"{}\" measures {} regions, but \"{}\" {}", first->name, first->arity,
                                    step.measure->name, step.measure->arity));
    }
    if (!first) parser.fail("no measure is in it");
    RelationMeasure combination{text, first->arity, formula.unit, "a combination", nullptr, nullptr, by_size};
    const auto shared = std::make_shared<const RelationFormula>(std::move(formula));
    combination.value = [shared](const Scene& scene, RelationMeasure::Regions regions) {
        return value_of(*shared, scene, regions);
    };
    combination.range = [shared](const Scene& scene, Surrounds surrounds) {
        return range_of(*shared, scene, surrounds);
    };
    return std::make_shared<const RelationMeasure>(std::move(combination));
}

}  // namespace partonomy
