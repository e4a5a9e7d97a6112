#include "expert/in_numbers.h"

#include <fmt/format.h>

#include <cmath>

#include "algorithms/relation_formula.h"
#include "shape/membership.h"

namespace partonomy {
namespace {

/// "<= 0.35", ">= 0.02", "0.1 to 0.3": where the trapezoid is at least 0.5.
std::string wanted(const knowledge::Criterion& criterion) {
    const double low = (criterion.a1 + criterion.a2) / 2, high = (criterion.a3 + criterion.a4) / 2;
    if (std::isfinite(low) && std::isfinite(high)) return fmt::format("{:.3g} to {:.3g}", low, high);
    return std::isfinite(low) ? fmt::format(">= {:.3g}", low) : fmt::format("<= {:.3g}", high);
}

/// "angle 21.4 degrees (wanted <= 10)".
std::string in_numbers(const knowledge::Criterion& criterion, std::optional<double> value, const std::string& unit) {
    const bool is_told = unit == "degrees" || unit == "m";
    return fmt::format("{} {}{} (wanted {})", criterion.measure, value ? fmt::format("{:.3g}", *value) : "?",
                       is_told ? " " + unit : "", wanted(criterion));
}

}  // namespace

std::string relation_in_numbers(std::span<const knowledge::Criterion> criteria, const Scene& scene,
                                RelationMeasure::Regions regions) {
    std::string text;
    for (const knowledge::Criterion& criterion : criteria) {
        const auto measure = parse_relation_formula(criterion.measure);
        const bool fits = measure->arity == regions.size();
        const std::optional<double> value = fits ? measure->value(scene, regions) : std::nullopt;
        text += (text.empty() ? "" : ", ") + in_numbers(criterion, value, fits ? measure->unit : "");
    }
    return text;
}

std::string is_a_in_numbers(const knowledge::Domain& domain, const Catalogue& catalogue, knowledge::Question question,
                            const Object& object, const RegionMeasurements& region) {
    const ElementaryAlgorithm* algorithm = catalogue.find(Signature::is_a, question);
    if (algorithm == nullptr) return {};
    const knowledge::Variable& variable = domain.regions.variables[static_cast<std::size_t>(question.variable)];
    const auto index = static_cast<std::size_t>(variable.index), value = static_cast<std::size_t>(question.value);
    if (variable.kind == knowledge::VariableKind::number) {
        const Formula& formula = algorithm->formulas.front();
        const std::optional<double> x = evaluate(formula, object, region);
        return x ? fmt::format("{} {:.3g}{}", formula.text, *x, formula.unit == "1" ? "" : " " + formula.unit) : "";
    }
    const std::vector<knowledge::Criterion>& criteria = domain.ranges[index].values[value].criteria;
    std::string text;
    for (std::size_t i = 0; i < criteria.size(); ++i) {
        const std::optional<double> x = evaluate(algorithm->formulas[i], object, region);
        if (!x) return {};
        const knowledge::Criterion& c = criteria[i];
        const std::string one = in_numbers(c, x, algorithm->formulas[i].unit);
        if (Trapezoid{c.a1, c.a2, c.a3, c.a4}(*x) < 0.5) return one;
        text += (text.empty() ? "" : ", ") + one;
    }
    return text;
}

}  // namespace partonomy
