#include "knowledge/lint_gaps.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace partonomy::knowledge {
namespace {

/// Where a value fits, with a score of 1/2 at least.
struct Fit {
    double from, to;
};

std::string text_of(double x) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x, std::chars_format::general, 6).ptr};
}

}  // namespace

std::string gap_between_values(const RangeConcept& range) {
    std::vector<Fit> fits;
    std::string names;
    for (std::size_t v = 0; v < range.values.size(); ++v) {
        const ElementaryConcept& value = range.values[v];
        if (value.criteria.size() != 1 || value.criteria[0].measure != range.values[0].criteria[0].measure) return {};
        const Criterion& c = value.criteria[0];
        fits.push_back({(c.a1 + c.a2) / 2, (c.a3 + c.a4) / 2});
        names += (v == 0 ? "" : v + 1 == range.values.size() ? " nor " : ", ") + owl::local_name(value.iri);
    }
    if (!range.covered || fits.size() < 2) return {};
    std::ranges::sort(fits, {}, &Fit::from);
    double reached = fits.front().to;
    for (const Fit& fit : fits) {
        if (fit.from > reached + 1e-9 * std::max(std::abs(fit.from), std::abs(reached)))
            return "between " + text_of(reached) + " and " + text_of(fit.from) + " of " +
                   range.values[0].criteria[0].measure + " neither " + names + " fits";
        reached = std::max(reached, fit.to);
    }
    return {};
}

}  // namespace partonomy::knowledge
