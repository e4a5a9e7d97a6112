/* Relations between regions (paper §3.2.2): T asks whether some regions are in a relation.
 *
 * Each relation is a set of measurements and trapezoids in the ontology, as for `is a`; the lowest score counts. The
 * measurements are in relation_place.cpp, relation_contact.cpp and relation_likeness.cpp; lengths are fractions of the
 * object's height or diagonal, so that no unit is needed. Those of relation_plan.cpp are in metres.
 *
 * A measurement may cost a look at every triangle of both regions. Most tuples are decided before that: each measure
 * tells from boxes and sizes between which numbers its value must lie, and where the trapezoid is 0, or 1, on all of
 * them, the score is. The same question is asked of whole branches of a tree by TF (related_index.cpp). */

#include "algorithms/relations.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "algorithms/relation_formula.h"
#include "algorithms/relation_measures.h"
#include "base/errors.h"
#include "shape/membership.h"

namespace partonomy {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::vector<RelationMeasure> built_in_measures() {
    std::vector<RelationMeasure> measures;
    add_contact_measures(measures);
    add_place_measures(measures);
    add_likeness_measures(measures);
    add_plan_measures(measures);
    return measures;
}

std::vector<RelationMeasure>& registry() {
    static std::vector<RelationMeasure> measures = built_in_measures();
    return measures;
}

/// Whether the trapezoid is 0 on all of the interval. What is rounded otherwise must not be lost.
bool is_zero_on(const knowledge::Criterion& c, const Interval& interval) {
    const double slack = 1e-9 * (1 + std::abs(interval.low) + std::abs(interval.high));
    return interval.high < c.a1 - (std::isfinite(slack) ? slack : 0) ||
           interval.low > c.a4 + (std::isfinite(slack) ? slack : 0);
}

/// Whether it is 1 on all of the interval.
bool is_one_on(const knowledge::Criterion& c, const Interval& interval) {
    if (interval.low == -infinity && interval.high == infinity) return false;  // nor is there always a value
    const double slack = 1e-9 * (1 + std::abs(interval.low) + std::abs(interval.high));
    const double margin = std::isfinite(slack) ? slack : 1e-9;
    return interval.low - margin >= c.a2 && interval.high + margin <= c.a3;
}

}  // namespace

Surround surround_of(const RegionPlace& place) {
    Vec3 sizes;
    for (int i = 0; i < 3; ++i) sizes[i] = std::log(std::max(place.part->box.lengths[i], 1e-300));
    return {place.low, place.low, place.high, place.high, sizes, sizes};
}

void enclose(Surround& one, const Surround& other) {
    one.low_from = one.low_from.cwiseMin(other.low_from);
    one.low_to = one.low_to.cwiseMax(other.low_to);
    one.high_from = one.high_from.cwiseMin(other.high_from);
    one.high_to = one.high_to.cwiseMax(other.high_to);
    one.size_from = one.size_from.cwiseMin(other.size_from);
    one.size_to = one.size_to.cwiseMax(other.size_to);
}

std::span<const RelationMeasure> all_relation_measures() { return registry(); }

void add_relation_measure(RelationMeasure measure) { registry().push_back(std::move(measure)); }

const RelationMeasure* find_relation_measure(const std::string& name) {
    for (const RelationMeasure& measure : registry())
        if (name == measure.name) return &measure;
    return nullptr;
}

RelationTest::RelationTest(std::span<const knowledge::Criterion> criteria) {
    for (const knowledge::Criterion& criterion : criteria) {
        parts_.push_back({&criterion, nullptr});
        try {
            parts_.back().measure = parse_relation_formula(criterion.measure);
        } catch (const OntologyError&) {  // the catalogue says so where the ontology is read
        }
    }
}

RelationTest::Prospect RelationTest::prospect(const Scene& scene, std::span<const Surround* const> surrounds) const {
    Prospect prospect = parts_.empty() ? Prospect::open : Prospect::sure;
    for (const auto& [criterion, measure] : parts_) {
        if (!measure || !measure->range || measure->arity != surrounds.size()) {
            prospect = Prospect::open;
            continue;
        }
        const Interval interval = measure->range(scene, surrounds);
        if (is_zero_on(*criterion, interval)) return Prospect::none;
        if (!is_one_on(*criterion, interval)) prospect = Prospect::open;
    }
    return prospect;
}

bool RelationTest::looks_at_sizes_only() const {
    return std::ranges::none_of(
        parts_, [](const Part& part) { return part.measure && part.measure->range && !part.measure->by_size; });
}

std::optional<double> RelationTest::score(const Scene& scene, RelationMeasure::Regions regions,
                                          std::span<const Surround* const> surrounds) const {
    if (parts_.empty()) return std::nullopt;
    for (const Part& part : parts_)
        if (!part.measure || part.measure->arity != regions.size()) return std::nullopt;
    const Prospect before = prospect(scene, surrounds);
    if (before != Prospect::open) return before == Prospect::sure ? 1 : 0;
    double score = 1;
    bool is_known = true;
    for (const auto& [criterion, measure] : parts_) {
        const std::optional<double> x = measure->value(scene, regions);
        if (x)
            score = std::min(score, Trapezoid{criterion->a1, criterion->a2, criterion->a3, criterion->a4}(*x));
        else
            is_known = false;
        if (score == 0) return 0;  // whatever the others are
    }
    return is_known ? std::optional(score) : std::nullopt;
}

std::optional<double> RelationTest::score(const Scene& scene, RelationMeasure::Regions regions) const {
    std::array<Surround, 3> surrounds;
    const std::array<const Surround*, 3> each{&surrounds[0], &surrounds[1], &surrounds[2]};
    if (regions.size() > each.size()) return std::nullopt;
    for (std::size_t i = 0; i < regions.size(); ++i) surrounds[i] = surround_of(*regions[i]);
    return score(scene, regions, std::span(each).first(regions.size()));
}

std::optional<double> relation_score(std::span<const knowledge::Criterion> criteria, const Scene& scene,
                                     RelationMeasure::Regions regions) {
    return RelationTest(criteria).score(scene, regions);
}

const knowledge::Criterion& touching() {
    static const knowledge::Criterion criterion{"gap", -infinity, -infinity, 0.005, 0.015};
    return criterion;
}

}  // namespace partonomy
