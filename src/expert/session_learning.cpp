/* What answers make of the regions. Answers are likelihoods: where those about one region contradict each other the
   least certain one is left out when it is borderline; what a person says outweighs all of them. Whatever hung on an
   answer that is given up is given up, too. */

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <utility>

#include "base/spelling.h"
#include "expert/session.h"
#include "expert/session_words.h"

namespace partonomy {
namespace {

using knowledge::Answer;
using knowledge::ConceptId;
using knowledge::ConfigurationSet;
using knowledge::Question;
using knowledge::Space;

const std::string shape_iri = std::string(owl::core_prefix) + "Shape";
constexpr double sure = 0.75;  // of an answer: below, others of the same region may overrule it

}  // namespace

void Session::learn(int region, Question question, bool yes, double score) {
    const knowledge::Answer answer{region, question, yes};
    ConfigurationSet next = narrowed(possible(region), answer);
    if (next.is_empty() && !possible(region).is_empty()) {
        if (!make_room(answer, score)) return;
        next = narrowed(possible(region), answer);
    }
    possible_[index(region)] = std::move(next);
    note(answer, score);
}

void Session::note(const Answer& answer, double score) {
    answers_.push_back(answer);
    answer_scores_.push_back(score);
    if (domain_.regions.variables[index(answer.question.variable)].iri == shape_iri) {
        double& shape_score = shape_scores_[index(answer.region)];
        shape_score = answer.yes ? score : std::min(shape_score, score);
    }
}

void Session::learn_together(const std::vector<ScoredAnswer>& answers) {
    if (answers.empty()) return;
    const int region = answers.front().answer.region;
    ConfigurationSet next = possible(region);
    for (const auto& [answer, score] : answers) next = narrowed(std::move(next), answer);
    if (next.is_empty()) {
        for (const auto& [answer, score] : answers) learn(region, answer.question, answer.yes, score);
        return;
    }
    possible_[index(region)] = std::move(next);
    for (const auto& [answer, score] : answers) note(answer, score);
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

}  // namespace partonomy
