#include "expert/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "algorithms/appearance.h"
#include "expert/session_words.h"

namespace partonomy {
namespace {

using knowledge::Answer;
using knowledge::ConceptId;
using knowledge::ConfigurationSet;
using knowledge::Question;
using knowledge::Space;

bool is_free(const knowledge::RangeConcept& range) {
    return std::ranges::all_of(range.values, [](const auto& value) { return value.cost && *value.cost == 0; });
}

std::vector<ConceptId> wanted_concepts(const Space& space) {
    std::vector<ConceptId> wanted;
    for (ConceptId c = 0; c < static_cast<ConceptId>(space.concepts.size()); ++c) {
        const knowledge::Concept& candidate = space.concepts[static_cast<std::size_t>(c)];
        if (candidate.provable && !candidate.iri.starts_with(owl::core_prefix)) wanted.push_back(c);
    }
    return wanted;
}

}  // namespace

Session::Session(const knowledge::Domain& domain, const Catalogue& catalogue, const Object& object, const Cut& cut)
    : domain_(domain),
      catalogue_(catalogue),
      object_(object),
      wanted_(wanted_concepts(domain.regions)),
      rest_possible_(domain.regions.all()) {
    double covered = 0, total = 0;
    for (const auto& region : cut) {
        rest_.push_back({region->part, region->measurements, {}, {}});
        covered += rest_.back().measurements.area;
    }
    for (const double area : object_.geometry.areas) total += area;
    uncovered_fraction_ = total > 0 ? std::max(0.0, 1 - covered / total) : 0;
    for (const knowledge::Variable& variable : domain.regions.variables)
        measured_.push_back(variable.kind == knowledge::VariableKind::number ||
                            (variable.kind == knowledge::VariableKind::range &&
                             is_free(domain.ranges[static_cast<std::size_t>(variable.index)])));
    for (const knowledge::Relation& relation : domain.relations) relation_tests_.emplace_back(relation.criteria);
}

int Session::add_region(Candidate candidate) {
    parts_.push_back(std::move(candidate.part));
    measurements_.push_back(candidate.measurements);
    possible_.push_back(domain_.regions.all());
    shape_scores_.push_back(1);
    const int region = region_count() - 1;
    std::vector<ScoredAnswer> answers;
    for (std::size_t v = 0; v < measured_.size(); ++v)
        if (measured_[v]) read_off(region, static_cast<int>(v), answers);
    learn_together(answers);
    return region;
}

/// Which value of a range scores best, or that none is likely; or between which two of its limits a number lies.
void Session::read_off(int region, int variable, std::vector<ScoredAnswer>& answers) {
    const knowledge::Variable& about = domain_.regions.variables[index(variable)];
    const bool is_number = about.kind == knowledge::VariableKind::number;
    std::vector<std::pair<Question, double>> scores;
    for (int i = 0; i < static_cast<int>(about.values.size()); ++i) {
        const Question question{variable, i};
        const ElementaryAlgorithm* algorithm = catalogue_.find(Signature::is_a, question);
        if (!algorithm) continue;
        const auto score = is_a(domain_, catalogue_, question, object_, measurements(region));
        if (!score) return;  // no unit
        scores.emplace_back(question, *score);
        if (is_number && *score >= 0.5) break;
    }
    if (scores.empty()) return;
    ++read_off_count;
    const auto best = std::max_element(scores.begin(), scores.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    if (best->second >= 0.5) answers.push_back({{region, best->first, true}, best->second});
    if (best->second < 0.5 || is_number)
        for (const auto& [question, score] : scores)
            if (score < 0.5) answers.push_back({{region, question, false}, 1 - score});
}

Session::Candidate Session::make_candidate(PartRegion part) const {
    Candidate candidate;
    candidate.part = std::move(part);
    candidate.measurements = measure_region(object_, candidate.part);
    return candidate;
}

std::vector<const PartRegion*> Session::rest_parts() const {
    std::vector<const PartRegion*> parts;
    for (const Candidate& candidate : rest_) parts.push_back(&candidate.part);
    return parts;
}

std::vector<std::pair<Session::Candidate, double>> Session::take_derived(const ElementaryAlgorithm& algorithm) {
    if (algorithm.grain == Grain::patches && !std::exchange(patches_are_whole_, true)) {
        for (auto& [part, region] : keep_patches_whole(object_, rest_parts()))
            rest_[part] = region.region.triangles.empty() ? Candidate{} : make_candidate(std::move(region));
        std::erase_if(rest_, [](const Candidate& candidate) { return candidate.part.region.triangles.empty(); });
    }
    const std::vector<const PartRegion*> parts = rest_parts();
    DerivedRegions derived =
        derive_find_all(object_, parts, *algorithm.grain, [&](const RegionMeasurements& measurements) {
            return is_a(domain_, catalogue_, algorithm.question, object_, measurements);
        });
    std::vector<std::pair<Candidate, double>> found;
    std::vector<char> is_used(rest_.size(), 0);
    for (DerivedRegion& region : derived.found) {
        for (const std::size_t part : region.of) is_used[part] = 1;
        if (region.is_whole)
            found.emplace_back(std::move(rest_[region.of.front()]), region.score);
        else  // what was answered about the parts need not hold for their union or for a piece
            found.emplace_back(make_candidate(std::move(region.part)), region.score);
    }
    std::vector<Candidate> rest;
    for (std::size_t i = 0; i < rest_.size(); ++i)
        if (!is_used[i]) rest.push_back(std::move(rest_[i]));
    for (PartRegion& part : derived.rests) rest.push_back(make_candidate(std::move(part)));
    rest_ = std::move(rest);
    return found;
}

int Session::find_all(Question question) {
    const Stopwatch watch;
    ++find_all_count;
    const ElementaryAlgorithm* algorithm = catalogue_.find(Signature::find_all, question);
    std::vector<int> found;
    double lowest = 1;
    const auto cut = [&](Candidate&& candidate, double score) {
        const int region = add_region(std::move(candidate));
        learn(region, question, true, score);
        lowest = std::min(lowest, score * part(region).fit);
        found.push_back(region);
    };
    if (algorithm && algorithm->grain)
        for (auto& [candidate, score] : take_derived(*algorithm)) cut(std::move(candidate), score);
    std::vector<Candidate> rest;
    for (Candidate& candidate : rest_) {
        const double score = is_a(domain_, catalogue_, question, object_, candidate.measurements).value_or(0);
        if (score >= 0.5) {
            cut(std::move(candidate), score);
        } else {
            candidate.ruled_out.push_back({-1, question, false});
            candidate.scores.push_back(1 - score);
            rest.push_back(std::move(candidate));
        }
    }
    rest_ = std::move(rest);
    rest_possible_ -= yes_set(domain_.regions, question);

    const std::string where = find_all_count == 1 ? "mesh" : "rest";
    TraceEntry entry{"SF", fmt::format("find all {} in the {}", algorithm ? algorithm->name : "?", where), where,
                     how_many(static_cast<int>(found.size()), "region"), found.empty() ? 1 : lowest};
    for (const int region : found) {
        for (std::string& text : consequences(region, domain_.regions.all(), question))
            entry.inferred.push_back(std::move(text));
    }
    entry.ms = watch.ms();
    if (find_all_count == 1)  // the first one stands for the cutting, which all of them share
        for (const auto& [stage, ms] : object_.times) entry.ms += ms;
    trace.push_back(std::move(entry));
    return static_cast<int>(found.size());
}

void Session::adopt_rest() {
    for (Candidate& candidate : std::exchange(rest_, {})) {
        const std::vector<Answer> ruled_out = std::move(candidate.ruled_out);
        const std::vector<double> scores = std::move(candidate.scores);
        const int region = add_region(std::move(candidate));
        for (std::size_t i = 0; i < ruled_out.size(); ++i) learn(region, ruled_out[i].question, false, scores[i]);
        if (!trace.empty())
            for (std::string& text : consequences(region, domain_.regions.all(), {}))
                trace.back().inferred.push_back(std::move(text));
    }
}

std::optional<double> Session::ask_score(int region, Question question) {
    const Stopwatch watch;
    const std::optional<double> score = is_a(domain_, catalogue_, question, object_, measurements(region));
    if (!score) return std::nullopt;
    ++is_a_count;
    trace.push_back({"SI",
                     in_words(region, question),
                     region_name(region),
                     *score >= 0.5 ? "yes" : "no",
                     *score >= 0.5 ? *score : 1 - *score,
                     {},
                     watch.ms()});
    asked_.push_back({trace.size() - 1, region, question});
    return score;
}

std::string Session::in_words(int region, Question question) const {
    return fmt::format("{}: {}", region_name(region), to_text(domain_.regions, question, domain_));
}

std::optional<bool> Session::ask(int region, Question question) {
    if (domain_.regions.variables[static_cast<std::size_t>(question.variable)].kind ==
        knowledge::VariableKind::relation)
        return ask_relation(region, question);
    const std::optional<double> score = ask_score(region, question);
    if (!score) return std::nullopt;
    const bool yes = *score >= 0.5;
    const ConfigurationSet before = possible(region);
    learn(region, question, yes, yes ? *score : 1 - *score);
    trace.back().inferred = consequences(region, before, question);
    return yes;
}

knowledge::Knowledge Session::knowledge() const {
    constexpr double negligible = 0.05;  // of the surface
    return {region_count(), rest_.empty() && uncovered_fraction_ < negligible, answers_,
            connected_.value_or(std::vector<std::pair<int, int>>{})};
}

std::optional<double> Session::is_a_cost(Question question) const {
    const ElementaryAlgorithm* algorithm = catalogue_.find(Signature::is_a, question);
    if (!algorithm) algorithm = catalogue_.find(Signature::related, question);
    if (!algorithm || (algorithm->needs_metres && !object_.placement.metres_per_unit) ||
        !tells(object_, algorithm->look))
        return std::nullopt;
    return algorithm->cost;
}

std::optional<double> Session::find_all_cost(Question question) const {
    const ElementaryAlgorithm* algorithm = catalogue_.find(Signature::find_all, question);
    if (!algorithm || (algorithm->needs_metres && !object_.placement.metres_per_unit)) return std::nullopt;
    if (!tells(object_, algorithm->look)) return std::nullopt;
    return catalogue_.cutting_cost(question, rest_.size());
}

}  // namespace partonomy
