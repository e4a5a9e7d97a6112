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

/// "between 2 and 5 of l0/l1", "up to 40 of inclination", "for any inclination".
std::string interval_words(double from, double to, const std::string& measure) {
    if (from == to) return "at " + text_of(from) + " of " + measure;
    const bool is_low = std::isfinite(from), is_high = std::isfinite(to);
    if (is_low && is_high) return "between " + text_of(from) + " and " + text_of(to) + " of " + measure;
    if (is_low) return "from " + text_of(from) + " of " + measure + " on";
    return is_high ? "up to " + text_of(to) + " of " + measure : "for any " + measure;
}

/// Where both values fit with a score of 1, in words; empty where they never do, and where the one is measured by
/// something that the other is not.
std::string where_both_fit(const ElementaryConcept& one, const ElementaryConcept& other) {
    if (one.criteria.empty() || one.criteria.size() != other.criteria.size()) return {};
    std::string words;
    for (const Criterion& a : one.criteria) {
        if (std::ranges::count(one.criteria, a.measure, &Criterion::measure) > 1) return {};
        const auto b = std::ranges::find(other.criteria, a.measure, &Criterion::measure);
        if (b == other.criteria.end()) return {};
        const double from = std::max(a.a2, b->a2), to = std::min(a.a3, b->a3);
        const bool is_same = a.a1 == b->a1 && a.a2 == b->a2 && a.a3 == b->a3 && a.a4 == b->a4;
        if (!(from < to) && !is_same) return {};  // values may meet in a number
        words += (words.empty() ? "" : " and ") + interval_words(from, to, a.measure);
    }
    return words;
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

std::vector<ValuesThatBothFit> values_that_both_fit(const RangeConcept& range) {
    std::vector<ValuesThatBothFit> found;
    for (std::size_t one = 0; one < range.values.size(); ++one)
        for (std::size_t other = one + 1; other < range.values.size(); ++other)
            if (std::string where = where_both_fit(range.values[one], range.values[other]); !where.empty())
                found.push_back({one, other, std::move(where)});
    return found;
}

}  // namespace partonomy::knowledge
