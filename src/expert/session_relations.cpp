/* Relations between regions. T measures one tuple of regions and TF all regions in a relation to given ones; each is
   run once and remembered. A question about a relation is answered from the tuples that matter (knowledge/relations.h);
   TF is taken where it costs less than the T's that it stands for. */

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <utility>

#include "expert/session.h"
#include "expert/session_words.h"

namespace partonomy {
namespace {

using knowledge::ConceptId;
using knowledge::ConfigurationSet;
using knowledge::Question;

constexpr std::size_t most_relations_told = 2;       // for one answer
constexpr std::size_t most_relations_compared = 60;  // to find these

const std::string connected_iri = std::string(owl::core_prefix) + "Connected";

std::string question_of(const knowledge::Relation& relation) {
    return relation.question.empty() ? owl::local_name(relation.iri) : relation.question;
}

}  // namespace

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
    known->second = relation_tests_[tuple.relation].score(scene(), places);
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
    if (trace.size() == asked_before) {
        trace.push_back({"known", in_words(region, question), region_name(region), yes ? "yes" : "no", answer.score});
    } else {
        trace.back().inferred.push_back(in_words(region, question) + (yes ? ": yes" : ": no"));
    }
    told_.push_back({trace.size() - 1, trace.back().inferred.size(), region, question, yes});
    std::vector<std::string>& inferred = trace.back().inferred;
    for (std::string& text : consequences(region, before, question)) inferred.push_back(std::move(text));
    return yes;
}

InNumbers Session::relation_in_numbers(int region, Question question) {
    const knowledge::Variable& variable = domain_.regions.variables[index(question.variable)];
    const auto nodes = nodes_in_question(domain_, domain_.relational[index(variable.index)], region, possible_);
    const std::string whom = other_side_in_words(variable, domain_);
    if (nodes.empty()) return {whom.empty() ? "" : "no other part is " + whom};
    struct Tuple {
        double score, off;
        std::string text;
    };
    std::vector<std::pair<double, knowledge::RelationTuple>> answered;
    for (const auto& [truth, node] : nodes)
        if (const auto found = related_.find(node); found != related_.end() && found->second)
            answered.emplace_back(-*found->second, node);
    std::ranges::sort(answered);
    if (answered.size() > most_relations_compared) answered.resize(most_relations_compared);
    std::vector<Tuple> tuples;  // those that hold, the surest first, then those that come nearest to it
    for (const auto& [less, node] : answered) {
        std::vector<const RegionPlace*> places;
        std::string others;
        for (const int each : node.regions) {
            places.push_back(&place(each));
            if (each != region) others += (others.empty() ? "" : " and ") + region_name(each);
        }
        const InNumbers numbers =
            partonomy::relation_in_numbers(domain_.relations[node.relation].criteria, scene(), places);
        tuples.push_back({-less, numbers.off, numbers.text.empty() ? "" : others + ": " + numbers.text});
    }
    std::ranges::stable_sort(
        tuples, {}, [](const Tuple& each) { return std::pair(-each.score, each.score >= 0.5 ? -each.off : each.off); });
    InNumbers result;
    if (!tuples.empty()) result.off = tuples.front().off;
    std::erase_if(tuples, [](const Tuple& each) { return each.text.empty(); });
    for (std::size_t i = 0; i < std::min(tuples.size(), most_relations_told); ++i)
        result.text += (i > 0 ? "; " : "") + tuples[i].text;
    return result;
}

InNumbers Session::in_numbers(const knowledge::Answer& answer) {
    if (is_accepted(answer)) return {};
    return is_relation(answer)
               ? relation_in_numbers(answer.region, answer.question)
               : is_a_in_numbers(domain_, catalogue_, answer.question, object_, measurements(answer.region));
}

void Session::tell_measures() {
    if (!is_told_in_numbers()) return;
    for (const auto& [entry, region, question] : std::exchange(asked_, {}))
        trace[entry].measured = is_a_in_numbers(domain_, catalogue_, question, object_, measurements(region)).text;
    for (const auto& [entry, facts, region, question, yes] : std::exchange(told_, {})) {
        const std::string text = relation_in_numbers(region, question).text;
        if (text.empty()) continue;
        std::vector<std::string>& inferred = trace[entry].inferred;
        if (facts > 0)
            inferred[facts - 1] += " [" + text + "]";
        else
            inferred.insert(inferred.begin(), in_words(region, question) + (yes ? ": yes [" : ": no [") + text + "]");
    }
}

}  // namespace partonomy
