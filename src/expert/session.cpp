#include "expert/session.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <span>
#include <utility>

#include "algorithms/appearance.h"
#include "base/spelling.h"

namespace partonomy {
namespace {

using knowledge::Answer;
using knowledge::ConceptId;
using knowledge::ConfigurationSet;
using knowledge::Question;
using knowledge::Space;

/// Milliseconds since construction.
class Stopwatch {
public:
    [[nodiscard]] double ms() const {
        return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
    }

private:
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

const std::string connected_iri = std::string(owl::core_prefix) + "Connected";
const std::string shape_iri = std::string(owl::core_prefix) + "Shape";
constexpr double sure = 0.75;  // of an answer: below, others of the same region may overrule it

std::string region_name(int region) { return fmt::format("part {}", region + 1); }

/// "1 region", "4 regions".
std::string how_many(int count, const char* what) { return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s"); }

std::string question_of(const knowledge::Relation& relation) {
    return relation.question.empty() ? owl::local_name(relation.iri) : relation.question;
}

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
}

int Session::add_region(Candidate candidate) {
    parts_.push_back(std::move(candidate.part));
    measurements_.push_back(candidate.measurements);
    possible_.push_back(domain_.regions.all());
    shape_scores_.push_back(1);
    const int region = region_count() - 1;
    for (std::size_t v = 0; v < measured_.size(); ++v)
        if (measured_[v]) read_off(region, static_cast<int>(v));
    return region;
}

/// Learns which value of a range scores best, or that none is likely; or between which two of its limits a number lies.
void Session::read_off(int region, int variable) {
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
    if (best->second >= 0.5) learn(region, best->first, true, best->second);
    if (best->second < 0.5 || is_number)
        for (const auto& [question, score] : scores)
            if (score < 0.5) learn(region, question, false, 1 - score);
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

void Session::find_connections() {
    if (domain_.composites.empty()) return;
    const Stopwatch watch;
    std::vector<int> regions;  // that may belong to a composite part, and those that were looked at before
    std::vector<char> is_new;
    for (int region = 0; region < region_count(); ++region) {
        const bool was = std::ranges::binary_search(connectable_, region);
        if (!was && std::ranges::none_of(domain_.composites, [&](const knowledge::CompositeSpace& composite) {
                return possible(region).is_empty() || possible(region).intersects(composite.regions);
            }))
            continue;
        regions.push_back(region);
        is_new.push_back(!was);
    }
    if (connected_ && regions == connectable_) return;
    if (!connected_) connected_.emplace();
    connectable_ = regions;
    ++find_related_count;
    std::span<const knowledge::Criterion> criteria(&touching(), 1);
    for (const knowledge::Relation& relation : domain_.relations)
        if (relation.iri == connected_iri && !relation.criteria.empty()) criteria = relation.criteria;
    double lowest = 1;
    std::vector<const RegionPlace*> places;
    for (const int region : regions) places.push_back(&place(region));
    const RelatedIndex among(scene(), places);
    for (int i = 0; i < static_cast<int>(regions.size()); ++i) {
        if (!is_new[index(i)]) continue;
        for (const auto& [j, found] : among.find(criteria, {i, -1})) {
            const double score = found.value_or(0);
            if (j < i && is_new[index(j)]) continue;
            lowest = std::min(lowest, std::max(score, 1 - score));
            if (score >= 0.5) connected_->push_back(std::minmax(regions[index(i)], regions[index(j)]));
        }
    }
    std::ranges::sort(*connected_);
    trace.push_back({"TF",
                     "find all parts that touch each other",
                     "mesh",
                     how_many(static_cast<int>(connected_->size()), "pair"),
                     lowest,
                     {},
                     watch.ms()});
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
    return score;
}

const Scene& Session::scene() {
    if (!scene_) scene_ = scene_of(object_);
    return *scene_;
}

const RegionPlace& Session::place(int region) {
    auto found = places_.find(region);
    if (found == places_.end()) found = places_.emplace(region, place_of(scene(), part(region))).first;
    return found->second;
}

std::optional<double> Session::relate(const knowledge::RelationTuple& tuple) {
    const auto [known, is_new] = related_.try_emplace(tuple);
    if (!is_new) return known->second;
    const Stopwatch watch;
    const knowledge::Relation& relation = domain_.relations[tuple.relation];
    std::vector<const RegionPlace*> places;
    std::string references;
    for (const int region : tuple.regions) {
        places.push_back(&place(region));
        if (places.size() > 1) references += (references.empty() ? "" : " and ") + region_name(region);
    }
    known->second = relation_score(relation.criteria, scene(), places);
    if (!known->second) return std::nullopt;
    const double score = *known->second;
    ++related_count;
    const std::string target = region_name(tuple.regions[0]);
    trace.push_back({"T",
                     fmt::format("{}: {} {}", target, question_of(relation), references),
                     target,
                     score >= 0.5 ? "yes" : "no",
                     std::max(score, 1 - score),
                     {},
                     watch.ms()});
    return score;
}

void Session::find_related(const knowledge::RelationTuple& line) {
    const Stopwatch watch;
    if (!index_ || indexed_ != region_count()) {
        std::vector<const RegionPlace*> places;
        for (int region = 0; region < region_count(); ++region) places.push_back(&place(region));
        index_.emplace(scene(), std::move(places));
        indexed_ = region_count();
    }
    const knowledge::Relation& relation = domain_.relations[line.relation];
    const auto open = static_cast<std::size_t>(std::ranges::find(line.regions, -1) - line.regions.begin());
    std::map<int, std::optional<double>> scores;
    for (const RelatedIndex::Related& each : index_->find(relation.criteria, line.regions))
        scores[each.region] = each.score;
    double lowest = 1;
    int yes = 0;
    for (int region = 0; region < region_count(); ++region) {
        if (std::ranges::find(line.regions, region) != line.regions.end()) continue;
        knowledge::RelationTuple tuple = line;
        tuple.regions[open] = region;
        std::sort(tuple.regions.begin() + 1, tuple.regions.end());
        const auto found = scores.find(region);
        const std::optional<double> score = found == scores.end() ? 0 : found->second;
        related_.try_emplace(std::move(tuple), score);
        if (!score) continue;
        lowest = std::min(lowest, std::max(*score, 1 - *score));
        yes += *score >= 0.5;
    }
    ++find_related_count;
    const auto words = [&](int region) { return region < 0 ? std::string("which parts") : region_name(region); };
    std::string references;
    for (std::size_t i = 1; i < line.regions.size(); ++i) references += (i > 1 ? " and " : "") + words(line.regions[i]);
    trace.push_back({"TF",
                     fmt::format("{}: {} {}", words(line.regions[0]), question_of(relation), references),
                     region_name(line.regions[open == 0 ? 1 : 0]),
                     how_many(yes, "region"),
                     lowest,
                     {},
                     watch.ms()});
}

void Session::relate_many(int region, Question question) {
    const knowledge::Variable& variable = domain_.regions.variables[index(question.variable)];
    const knowledge::RelationalFeature& feature = domain_.relational[index(variable.index)];
    std::map<std::size_t, std::vector<knowledge::RelationTuple>> unknown;  // by relation
    for (auto& [truth, node] : nodes_in_question(domain_, feature, region, possible_))
        if (!related_.contains(node) && !domain_.relations[node.relation].criteria.empty())
            unknown[node.relation].push_back(std::move(node));
    const ConfigurationSet yes = yes_set(domain_.regions, question);
    const auto is_open = [&](int other) {  // what a name may hang on
        const ConfigurationSet& set = possible(other);
        return set.intersects(yes) && !set.is_subset_of(yes) && std::ranges::any_of(wanted_, [&](ConceptId c) {
                   const knowledge::Concept& each = domain_.regions.concepts[static_cast<std::size_t>(c)];
                   return each.relational && set.intersects(each.where) && !set.is_subset_of(each.where);
               });
    };
    for (const auto& [relation, nodes] : unknown) {
        if (static_cast<double>(nodes.size()) * region_count() <= find_related_cost) continue;  // T is cheaper anyway
        int asking = 0;
        for (int other = 0; other < region_count(); ++other) asking += other == region || is_open(other);
        const auto count = static_cast<double>(nodes.size());
        const double along = domain_.relations[relation].arity == 2 ? find_related_cost : count + 1;
        const double across = count * find_related_cost / std::max(asking, 1);
        if (count <= std::min(along, across)) continue;
        if (along <= across) {
            find_related({relation, feature.of_target ? std::vector{region, -1} : std::vector{-1, region}});
            continue;
        }
        for (const knowledge::RelationTuple& node : nodes) {
            knowledge::RelationTuple line = node;
            *std::ranges::find(line.regions, region) = -1;
            find_related(line);
        }
    }
}

std::optional<bool> Session::ask_relation(int region, Question question) {
    const std::size_t asked_before = trace.size();
    relate_many(region, question);
    const auto index =
        static_cast<std::size_t>(domain_.regions.variables[static_cast<std::size_t>(question.variable)].index);
    const knowledge::RelationAnswer answer =
        answer_relation(domain_, domain_.relational[index], region, possible_, knowledge().complete,
                        [&](const knowledge::RelationTuple& tuple) { return relate(tuple); });
    if (answer.truth == knowledge::Truth::open) return std::nullopt;
    const bool yes = answer.truth == knowledge::Truth::yes;
    const ConfigurationSet before = possible(region);
    learn(region, question, yes, answer.score);
    // It may have taken several T and TF, of which the last is followed by what they say together, or none.
    if (trace.size() == asked_before)
        trace.push_back({"known", in_words(region, question), region_name(region), yes ? "yes" : "no", answer.score});
    else
        trace.back().inferred.push_back(in_words(region, question) + (yes ? ": yes" : ": no"));
    std::vector<std::string>& inferred = trace.back().inferred;
    for (std::string& text : consequences(region, before, question)) inferred.push_back(std::move(text));
    return yes;
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

void Session::learn(int region, Question question, bool yes, double score) {
    const knowledge::Answer answer{region, question, yes};
    ConfigurationSet next = narrowed(possible(region), answer);
    if (next.is_empty() && !possible(region).is_empty()) {
        if (!make_room(answer, score)) return;
        next = narrowed(possible(region), answer);
    }
    possible_[index(region)] = std::move(next);
    answers_.push_back(answer);
    answer_scores_.push_back(score);
    if (domain_.regions.variables[static_cast<std::size_t>(question.variable)].iri == shape_iri) {
        double& shape_score = shape_scores_[index(region)];
        shape_score = yes ? score : std::min(shape_score, score);
    }
}

ConfigurationSet Session::narrowed(ConfigurationSet set, const knowledge::Answer& answer) const {
    const ConfigurationSet holds = yes_set(domain_.regions, answer.question);
    if (answer.yes)
        set &= holds;
    else
        set -= holds;
    return set;
}

void Session::leave_out(std::size_t answer, const char* why) {
    const Answer& doubtful = answers_[answer];
    left_out_.push_back(fmt::format("left out: {}: {} ({:.2f}) {}", in_words(doubtful.region, doubtful.question),
                                    doubtful.yes ? "yes" : "no", answer_scores_[answer], why));
    answers_.erase(answers_.begin() + static_cast<std::ptrdiff_t>(answer));
    answer_scores_.erase(answer_scores_.begin() + static_cast<std::ptrdiff_t>(answer));
}

ConfigurationSet Session::possible_by_answers(int region) const {
    ConfigurationSet set = domain_.regions.all();
    for (const Answer& answer : answers_)
        if (answer.region == region) set = narrowed(std::move(set), answer);
    return set;
}

bool Session::make_room(const knowledge::Answer& answer, double score) {
    std::vector<std::size_t> doubtful;  // the least certain first
    for (std::size_t i = 0; i < answers_.size(); ++i)
        if (answers_[i].region == answer.region && answer_scores_[i] < std::min(sure, score)) doubtful.push_back(i);
    std::ranges::stable_sort(doubtful, {}, [&](std::size_t i) { return answer_scores_[i]; });
    for (const std::size_t out : doubtful) {
        ConfigurationSet without = domain_.regions.all();
        for (std::size_t i = 0; i < answers_.size(); ++i)
            if (i != out && answers_[i].region == answer.region) without = narrowed(std::move(without), answers_[i]);
        if (narrowed(without, answer).is_empty()) continue;
        leave_out(out, "contradicts what is surer");
        ConfigurationSet before = std::exchange(possible_[index(answer.region)], std::move(without));
        withdraw_relations(answer.region, std::move(before));
        return true;
    }
    if (score >= sure) return true;  // a contradiction that somebody should see
    left_out_.push_back(fmt::format("left out: {}: {} ({:.2f}) contradicts what is surer",
                                    in_words(answer.region, answer.question), answer.yes ? "yes" : "no", score));
    return false;
}

void Session::correct(int region, Question question, bool yes) {
    withdrawn_.clear();
    accepted_.emplace(region, question);
    const Answer told{region, question, yes};
    std::vector<std::size_t> own;  // the surest first
    for (std::size_t i = 0; i < answers_.size(); ++i)
        if (answers_[i].region == region) own.push_back(i);
    std::ranges::stable_sort(own, std::greater<>{}, [&](std::size_t i) { return answer_scores_[i]; });
    std::vector<std::size_t> out;
    ConfigurationSet kept = narrowed(domain_.regions.all(), told);
    for (const std::size_t i : own) {
        ConfigurationSet next = narrowed(kept, answers_[i]);
        if (next.is_empty() && !kept.is_empty())
            out.push_back(i);
        else
            kept = std::move(next);
    }
    std::ranges::sort(out, std::greater<>{});
    for (const std::size_t i : out) leave_out(i, "contradicts what a person says");
    ConfigurationSet before = std::exchange(possible_[index(region)], possible_by_answers(region));
    const ConfigurationSet known = before;
    learn(region, question, yes, 1);
    withdraw_relations(region, std::move(before));
    trace.push_back({"person", in_words(region, question), region_name(region), yes ? "yes" : "no", 1});
    trace.back().inferred = consequences(region, known, question);
}

bool Session::is_relation(const Answer& answer) const {
    return domain_.regions.variables[index(answer.question.variable)].kind == knowledge::VariableKind::relation;
}

void Session::withdraw_relations(int region, ConfigurationSet before) {
    std::vector<std::pair<int, ConfigurationSet>> changed;
    changed.emplace_back(region, std::move(before));
    while (!changed.empty()) {
        const auto [other, was] = std::move(changed.back());
        changed.pop_back();
        const ConfigurationSet now = possible(other);
        const auto tells_otherwise = [&](const ConfigurationSet& where) {
            return was.is_subset_of(where) != now.is_subset_of(where) || was.intersects(where) != now.intersects(where);
        };
        for (std::size_t i = answers_.size(); i-- > 0;) {
            if (!is_relation(answers_[i])) continue;
            const Answer answer = answers_[i];
            const auto feature = index(domain_.regions.variables[index(answer.question.variable)].index);
            if (std::ranges::none_of(domain_.relational[feature].classes, tells_otherwise) ||
                !withdrawn_.emplace(answer.region, answer.question).second)
                continue;
            leave_out(i, "hung on what is no longer so");
            ConfigurationSet next = possible_by_answers(answer.region);
            changed.emplace_back(answer.region, std::exchange(possible_[index(answer.region)], std::move(next)));
        }
    }
}

std::vector<std::string> Session::consequences(int region, const ConfigurationSet& before, Question asked) {
    std::vector<std::string> texts = std::exchange(left_out_, {});
    const ConfigurationSet& now = possible(region);
    if (now.is_empty()) {
        if (!before.is_empty()) texts.push_back(region_name(region) + ": its answers contradict the axioms");
        return texts;
    }
    const Space& space = domain_.regions;
    for (const ConceptId c : wanted_) {
        const knowledge::Concept& concept_ = space.concepts[static_cast<std::size_t>(c)];
        if (now.is_subset_of(concept_.where) && !before.is_subset_of(concept_.where))
            texts.push_back(fmt::format("{} is {}", region_name(region), with_article(owl::local_name(concept_.iri))));
    }
    for (std::size_t v = 0; v < space.variables.size(); ++v) {
        if (space.variables[v].kind != knowledge::VariableKind::range) continue;
        for (std::size_t i = 0; i < space.holds[v].size(); ++i)
            if (Question{static_cast<int>(v), static_cast<int>(i)} != asked && now.is_subset_of(space.holds[v][i]) &&
                !before.is_subset_of(space.holds[v][i]))
                texts.push_back(fmt::format("{} is {}", region_name(region), space.variables[v].values[i]));
    }
    return texts;
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
