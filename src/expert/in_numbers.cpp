#include "expert/in_numbers.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

/// Distance to the nearer end of an interval, as a share of the larger of the two; 0 where it has none.
double nearer_end(double low, double high, double x) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const double end : {low, high})
        if (const double scale = std::max(std::abs(x), std::abs(end)); std::isfinite(end))
            nearest = std::min(nearest, scale > 0 ? std::abs(x - end) / scale : 0);
    return std::isfinite(nearest) ? nearest : 0;
}

/// Whether a criterion holds, and how far it is from not doing so.
struct Border {
    bool holds;
    double off;
};

Border border(const knowledge::Criterion& c, double x) {
    return {Trapezoid{c.a1, c.a2, c.a3, c.a4}(x) >= 0.5, nearer_end((c.a1 + c.a2) / 2, (c.a3 + c.a4) / 2, x)};
}

/// All criteria must hold: the nearest border while they do, else the farthest of those that do not.
class Distance {
public:
    void add(Border each) {
        if (each.holds) {
            nearest_ = std::min(nearest_, each.off);
        } else {
            farthest_ = std::max(farthest_, each.off);
            all_hold_ = false;
        }
    }
    [[nodiscard]] double off() const { return !all_hold_ ? farthest_ : std::isfinite(nearest_) ? nearest_ : 0; }

private:
    bool all_hold_ = true;
    double nearest_ = std::numeric_limits<double>::infinity(), farthest_ = 0;
};

}  // namespace

InNumbers relation_in_numbers(std::span<const knowledge::Criterion> criteria, const Scene& scene,
                              RelationMeasure::Regions regions) {
    InNumbers result;
    Distance distance;
    for (const knowledge::Criterion& criterion : criteria) {
        const auto measure = parse_relation_formula(criterion.measure);
        const bool fits = measure->arity == regions.size();
        const std::optional<double> value = fits ? measure->value(scene, regions) : std::nullopt;
        if (value) distance.add(border(criterion, *value));
        result.text += (result.text.empty() ? "" : ", ") + in_numbers(criterion, value, fits ? measure->unit : "");
    }
    result.off = distance.off();
    return result;
}

InNumbers is_a_in_numbers(const knowledge::Domain& domain, const Catalogue& catalogue, knowledge::Question question,
                          const Object& object, const RegionMeasurements& region) {
    const ElementaryAlgorithm* algorithm = catalogue.find(Signature::is_a, question);
    if (algorithm == nullptr) return {};
    const knowledge::Variable& variable = domain.regions.variables[static_cast<std::size_t>(question.variable)];
    const auto index = static_cast<std::size_t>(variable.index), value = static_cast<std::size_t>(question.value);
    if (variable.kind == knowledge::VariableKind::number) {
        const Formula& formula = algorithm->formulas.front();
        const std::optional<double> x = evaluate(formula, object, region);
        if (!x) return {};
        InNumbers result{fmt::format("{} {:.3g}{}", formula.text, *x, formula.unit == "1" ? "" : " " + formula.unit)};
        const auto& [low, high, low_closed, high_closed] = domain.numbers[index].intervals[value];
        result.off = nearer_end(low, high, *x);
        return result;
    }
    const std::vector<knowledge::Criterion>& criteria = domain.ranges[index].values[value].criteria;
    InNumbers all, first_failing;
    Distance distance;
    for (std::size_t i = 0; i < criteria.size(); ++i) {
        const std::optional<double> x = evaluate(algorithm->formulas[i], object, region);
        if (!x) return {};
        const std::string one = in_numbers(criteria[i], x, algorithm->formulas[i].unit);
        const Border to = border(criteria[i], *x);
        distance.add(to);
        if (!to.holds && first_failing.text.empty()) first_failing.text = one;
        all.text += (all.text.empty() ? "" : ", ") + one;
    }
    InNumbers& told = first_failing.text.empty() ? all : first_failing;
    told.off = distance.off();
    return told;
}

}  // namespace partonomy
