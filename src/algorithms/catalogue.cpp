/* The catalogue of elementary algorithms (paper §3.4): which questions can be answered, how, and at what cost.
 *
 * `is a` needs no code: the ontology ties a concept to measurements and trapezoids, and the score is the lowest of them
 * (paper §4.1, §6.3). As in paper §4.2.2, one segmentation cuts the mesh, into box-like regions and along the borders
 * of colours; where core:regions of a range concept is "cut", as of shapes and colours, each `find all` keeps those of
 * its regions that are what was asked for. Every other concept has a derived `find all` (derive.cpp) at three times the
 * cost; how fine it looks, core:regions tells, too. A number that an axiom mentions ("height <= 0.55") is answered by
 * its measure; its score falls from 1 to 0 over a tenth of the number at either side.
 */

#include "algorithms/catalogue.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "algorithms/appearance.h"
#include "algorithms/relation_formula.h"
#include "base/errors.h"
#include "knowledge/relations.h"
#include "knowledge/theory.h"
#include "owl/make_class.h"
#include "shape/membership.h"

namespace partonomy {
namespace {

using knowledge::Domain;
using knowledge::Question;
using knowledge::Variable;
using knowledge::VariableKind;

constexpr double read_off_cost = 0.01;  ///< of what is known once the region is cut: core:cost 0, and numbers
constexpr double find_all_cost = 20;  ///< one `find all` against one `is a`: it browses the whole mesh (paper §5.2.3)

constexpr double related_cost = 2;  ///< T, some of them: it looks at other regions, too

constexpr double derived_cost = 60;  ///< of a derived `find all`: it measures each candidate, too

/// core:regions of the range concept: how fine a derived `find all` looks, "parts" without it; nullopt for "cut", whose
/// regions the mesh is cut into before anything is asked.
std::optional<Grain> grain_of(const Domain& domain, const owl::Iri& range) {
    const auto found = domain.ontology.annotations.find(range);
    if (found == domain.ontology.annotations.end()) return Grain::parts;
    for (const owl::Annotation& annotation : found->second) {
        if (annotation.property != std::string(owl::core_prefix) + "regions") continue;
        if (annotation.literal.value == "patches") return Grain::patches;
        if (annotation.literal.value == "parts") return Grain::parts;
        if (annotation.literal.value == "cut") return std::nullopt;
        throw OntologyError(at(annotation.source.file, annotation.source.line,
                               fmt::format("regions \"{}\" of {} should be \"cut\", \"parts\" or \"patches\"",
                                           annotation.literal.value, owl::local_name(range))));
    }
    return Grain::parts;
}

/// Where an annotation of `iri` names a measure.
owl::Source source_of(const Domain& domain, const owl::Iri& iri, const std::string& measure) {
    owl::Source source;
    if (const auto found = domain.ontology.annotations.find(iri); found != domain.ontology.annotations.end())
        for (const owl::Annotation& annotation : found->second)
            if (annotation.literal.value.find(measure) != std::string::npos) source = annotation.source;
    return source;
}

/// What an annotation of `iri` says of measures, parsed; or an error that tells where it says so.
template <typename Parse>
auto require(const Parse& parse, const Domain& domain, const owl::Iri& iri, const std::string& text) {
    try {
        return parse(text);
    } catch (const OntologyError& error) {
        const owl::Source source = source_of(domain, iri, text);
        throw OntologyError(at(source.file, source.line, fmt::format("{}: {}", owl::local_name(iri), error.what())));
    }
}

Formula require_formula(const Domain& domain, const owl::Iri& iri, const std::string& text) {
    return require(parse_formula, domain, iri, text);
}

/// Relations measure as many regions as they link.
void check_relations(const Domain& domain) {
    for (const knowledge::Relation& relation : domain.relations)
        for (const knowledge::Criterion& criterion : relation.criteria) {
            const auto measure = require(parse_relation_formula, domain, relation.iri, criterion.measure);
            if (measure->arity == relation.arity) continue;
            const owl::Source source = source_of(domain, relation.iri, criterion.measure);
            throw OntologyError(
                at(source.file, source.line,
                   fmt::format("{} links {} regions (core:arity, 2 without it), but \"{}\" measures "
                               "{}; change one of them",
                               owl::local_name(relation.iri), relation.arity, measure->name, measure->arity)));
        }
}

double number_score(double x, double limit, bool closed) {
    const double slack = 0.1 * std::max(std::abs(limit), 1e-9);
    const double score = std::clamp(0.5 + 0.5 * (limit - x) / slack, 0.0, 1.0);
    return x == limit && !closed ? std::nextafter(0.5, 0.0) : score;
}

}  // namespace

const ElementaryAlgorithm* Catalogue::find(Signature signature, Question question) const {
    const auto found = std::find_if(algorithms.begin(), algorithms.end(), [&](const ElementaryAlgorithm& a) {
        return a.signature == signature && a.question == question;
    });
    return found == algorithms.end() ? nullptr : &*found;
}

std::optional<double> Catalogue::cutting_cost(Question question, std::size_t parts) const {
    const ElementaryAlgorithm* algorithm = find(Signature::find_all, question);
    if (!algorithm) return std::nullopt;
    if (!algorithm->grain) return algorithm->cost;
    if (has_own_find_all) return std::nullopt;
    const ElementaryAlgorithm* one = find(Signature::is_a, question);
    const bool pays = *algorithm->grain == Grain::patches || algorithm->cost < one->cost * static_cast<double>(parts);
    return pays ? std::optional(algorithm->cost) : std::nullopt;
}

Catalogue make_catalogue(const Domain& domain) {
    check_relations(domain);
    Catalogue catalogue;
    const auto& variables = domain.regions.variables;
    for (int v = 0; v < static_cast<int>(variables.size()); ++v) {
        const Variable& variable = variables[static_cast<std::size_t>(v)];
        if (variable.kind == VariableKind::range) {
            const knowledge::RangeConcept& range = domain.ranges[static_cast<std::size_t>(variable.index)];
            const std::optional<Grain> grain = grain_of(domain, range.iri);
            for (int i = 0; i < static_cast<int>(range.values.size()); ++i) {
                const knowledge::ElementaryConcept& value = range.values[static_cast<std::size_t>(i)];
                if (value.criteria.empty()) continue;
                bool needs_metres = false;
                AppearanceNeed look = AppearanceNeed::none;
                std::string method;
                std::vector<Formula> formulas;
                for (const knowledge::Criterion& c : value.criteria) {
                    formulas.push_back(require_formula(domain, value.iri, c.measure));
                    needs_metres |= formulas.back().needs_metres;
                    look = std::max(look, appearance_need(formulas.back()));
                    method += fmt::format("{}{} in [{} {} {} {}]", method.empty() ? "" : " and ", c.measure, c.a1, c.a2,
                                          c.a3, c.a4);
                }
                const std::string name = owl::local_name(value.iri);
                if (!grain)
                    catalogue.algorithms.push_back({Signature::find_all,
                                                    {v, i},
                                                    name,
                                                    "regions of the box-like partition with " + method,
                                                    find_all_cost,
                                                    needs_metres,
                                                    look == AppearanceNeed::none ? Origin::own : Origin::derived,
                                                    {},
                                                    look});
                else if (value.cost != 0)
                    catalogue.algorithms.push_back({Signature::find_all,
                                                    {v, i},
                                                    name,
                                                    grain == Grain::patches
                                                        ? "best of parts, their unions and patches by `is a`"
                                                        : "best of parts and their unions by `is a`",
                                                    derived_cost * std::max(1.0, value.cost.value_or(1)),
                                                    needs_metres,
                                                    Origin::derived,
                                                    {},
                                                    look,
                                                    grain});
                catalogue.algorithms.push_back({Signature::is_a,
                                                {v, i},
                                                name,
                                                method,
                                                std::max(read_off_cost, value.cost.value_or(1)),
                                                needs_metres,
                                                Origin::own,
                                                std::move(formulas),
                                                look});
            }
        } else if (variable.kind == VariableKind::number) {
            const knowledge::MeasuredProperty& number = domain.numbers[static_cast<std::size_t>(variable.index)];
            if (number.measure.empty()) continue;
            const Formula formula = require_formula(domain, number.iri, number.measure);
            for (int i = 0; i + 1 < static_cast<int>(number.intervals.size()); ++i) {
                const auto& interval = number.intervals[static_cast<std::size_t>(i)];
                const std::string name = fmt::format("{} {} {}", owl::local_name(number.iri),
                                                     interval.high_closed ? "<=" : "<", interval.high);
                catalogue.algorithms.push_back({Signature::is_a,
                                                {v, i},
                                                name,
                                                number.measure,
                                                read_off_cost,
                                                formula.needs_metres,
                                                Origin::own,
                                                {formula},
                                                appearance_need(formula)});
            }
        }
    }
    for (int v = 0; v < static_cast<int>(variables.size()); ++v) {
        const Variable& variable = variables[static_cast<std::size_t>(v)];
        if (variable.kind != VariableKind::relation || !variable.answerable) continue;
        const knowledge::NodeTest& test = domain.relational[static_cast<std::size_t>(variable.index)].test;
        double cost = 0;
        std::string method;
        for (std::size_t r = 0; r < domain.relations.size(); ++r) {
            const knowledge::Relation& relation = domain.relations[r];
            if (!may_pass(test, domain.relations, r)) continue;
            cost = std::max(cost, relation.cost.value_or(related_cost));
            for (const knowledge::Criterion& c : relation.criteria)
                method += fmt::format("{}{} in [{} {} {} {}]", method.empty() ? "" : " and ", c.measure, c.a1, c.a2,
                                      c.a3, c.a4);
        }
        catalogue.algorithms.push_back(
            {Signature::related, {v, 0}, to_manchester(*variable.part_class), method, cost, false});
        catalogue.algorithms.push_back({Signature::find_related,
                                        {v, 0},
                                        catalogue.algorithms.back().name,
                                        "through an index of boxes: " + method,
                                        cost * find_related_cost,
                                        false});
    }
    catalogue.has_own_find_all = std::ranges::any_of(catalogue.algorithms, [](const ElementaryAlgorithm& algorithm) {
        return algorithm.signature == Signature::find_all && !algorithm.grain;
    });
    return catalogue;
}

knowledge::Domain make_core_domain() {
    Domain domain;
    domain.ontology = owl::parse_ontology(owl::core_ontology_text(), "core.ttl");
    domain.ranges = knowledge::find_ranges(domain.ontology);
    domain.relations = knowledge::find_relations(domain.ontology);
    for (std::size_t r = 0; r < domain.ranges.size(); ++r) {
        Variable variable{VariableKind::range, domain.ranges[r].iri, {}, static_cast<int>(r), nullptr};
        for (const knowledge::ElementaryConcept& value : domain.ranges[r].values)
            variable.values.push_back(owl::local_name(value.iri));
        domain.regions.variables.push_back(std::move(variable));
    }
    for (std::size_t r = 0; r < domain.relations.size(); ++r) {  // one statement about each: that there is a node
        knowledge::RelationalFeature feature;
        feature.test.kind = knowledge::NodeTest::Kind::relation;
        feature.test.relations.assign(domain.relations.size(), 0);
        feature.test.relations[r] = 1;
        domain.relational.push_back(std::move(feature));
        domain.regions.variables.push_back({VariableKind::relation,
                                            {},
                                            {"yes", "no"},
                                            static_cast<int>(r),
                                            owl::named_class(domain.relations[r].iri)});
    }
    return domain;
}

Catalogue make_core_catalogue() { return make_catalogue(make_core_domain()); }

std::optional<double> is_a(const Domain& domain, const Catalogue& catalogue, Question question, const Object& object,
                           const RegionMeasurements& region) {
    const ElementaryAlgorithm* algorithm = catalogue.find(Signature::is_a, question);
    if (!algorithm) return std::nullopt;
    const Variable& variable = domain.regions.variables[static_cast<std::size_t>(question.variable)];
    const auto index = static_cast<std::size_t>(variable.index), value = static_cast<std::size_t>(question.value);
    if (variable.kind == VariableKind::number) {
        const std::optional<double> x = evaluate(algorithm->formulas.front(), object, region);
        if (!x) return std::nullopt;
        const auto& interval = domain.numbers[index].intervals[value];
        return number_score(*x, interval.high, interval.high_closed);
    }
    const std::vector<knowledge::Criterion>& criteria = domain.ranges[index].values[value].criteria;
    double score = 1;
    for (std::size_t i = 0; i < criteria.size(); ++i) {
        const std::optional<double> x = evaluate(algorithm->formulas[i], object, region);
        if (!x) return std::nullopt;
        const knowledge::Criterion& c = criteria[i];
        score = std::min(score, Trapezoid{c.a1, c.a2, c.a3, c.a4}(*x));
        if (score == 0) break;
    }
    return score;
}

}  // namespace partonomy
