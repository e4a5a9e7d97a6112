#include <algorithm>
#include <array>
#include <cmath>

#include "knowledge/decision_tree.h"
#include "knowledge/diagram_questions.h"

// Choosing a question is counting: with what is still possible as a bit set, a question's yes and no are one popcount
// away. Dichotomy (paper §3.3.1) takes the question with the most even split. Gain per cost looks at labels instead of
// configurations: those that agree on every wanted concept form one class, and the gain of a question is by how much
// the entropy of the class sinks on average. It does not care for features that no wanted concept looks at, where
// dichotomy asks on. When no single question gains anything but something is open (an exclusive or), the most even
// split per cost makes progress. Configurations count alike; impossible ones only count when nothing else is open.
// Cost: dichotomy takes (questions) x (words of the space); gain per cost walks over the configurations that are left,
// each with the questions that it answers with yes, since far down in a tree few are left of many. Over a compiled
// space the same choice is made by sweeps over its diagram (diagram_questions.cpp).

namespace partonomy::knowledge {
namespace {

double entropy_sum(double n) { return n > 0 ? n * std::log2(n) : 0; }

/// Keeps the first of the highest scores; scores closer than rounding count as equal.
struct Best {
    std::optional<Question> question;
    double score = 0;

    void offer(Question other, double other_score) {
        if (other_score <= score + 1e-9 * std::abs(score)) return;
        question = other;
        score = other_score;
    }
};

}  // namespace

ConfigurationSet yes_set(const Space& space, Question question) {
    const auto& holds = space.holds[question.variable];
    if (space.variables[question.variable].kind != VariableKind::number) return holds[question.value];
    if (space.diagram) return space.up_to[question.variable][question.value];
    ConfigurationSet result = holds[0];
    for (ValueId value = 1; value <= question.value; ++value) result |= holds[value];
    return result;
}

Planner::Planner(const Space& space, PlanOptions options) : Planner(space, std::move(options), space.all()) {}

Planner::Planner(const Space& space, PlanOptions options, const ConfigurationSet& within)
    : space_(&space), options_(std::move(options)) {
    if (!space.diagram && within.count() < space.size) within_ = within;
    possible_ = packed(space.possible);
    for (std::size_t v = 0; v < space.variables.size(); ++v) {
        const Variable& variable = space.variables[v];
        std::size_t questions = variable.values.size();
        if (variable.kind == VariableKind::number) --questions;
        if (variable.kind >= VariableKind::relation) questions = 1;  // yes or no
        for (std::size_t k = 0; k < questions; ++k) {
            const Question question{static_cast<VariableId>(v), static_cast<ValueId>(k)};
            if (variable.kind == VariableKind::open) open_.push_back(candidates_.size());
            candidates_.push_back({question, packed(knowledge::yes_set(space, question)), variable.answerable});
        }
    }
    costs_.resize(candidates_.size());
}

Planner Planner::with_cost(std::function<std::optional<double>(Question)> cost) const {
    if (!space_->diagram) static_cast<void>(rows());  // is the same for both
    Planner other = *this;
    other.options_.cost = std::move(cost);
    other.costs_.assign(candidates_.size(), {});
    other.prices_ = {};
    return other;
}

ConfigurationSet Planner::packed(const ConfigurationSet& set) const { return within_ ? set.packed(*within_) : set; }

std::optional<double> Planner::cost(const Candidate& candidate) const {
    if (!options_.cost) return candidate.answerable ? std::optional(1.0) : std::nullopt;
    KnownCost& known = costs_[static_cast<std::size_t>(&candidate - candidates_.data())];
    if (known.call != call_) known = {options_.cost(candidate.question), call_};
    return known.cost;
}

bool Planner::is_decided(const ConfigurationSet& set) const {
    if (space_->diagram) return knowledge::is_decided(*space_, set, options_);
    return is_decided(rows().rows_of(packed(set)));
}

bool Planner::is_decided(RowSpan rows) const {
    if (options_.wanted.empty()) return rows.size() <= 1;
    if (open_.empty()) return this->rows().has_one_label(rows);
    // When what nothing can answer tells the label, nothing that is asked will.
    const auto is_told = [&](const auto& self, std::span<std::uint32_t> some, std::size_t from) -> bool {
        if (this->rows().has_one_label(some)) return true;
        for (std::size_t i = from; i < open_.size(); ++i) {
            const std::size_t yes = this->rows().split(some, open_[i], scratch_);
            if (yes == 0 || yes == some.size()) continue;
            return self(self, some.first(yes), i + 1) && self(self, some.subspan(yes), i + 1);
        }
        return false;
    };
    Rows copy(rows.begin(), rows.end());
    return is_told(is_told, copy, 0);
}

bool Planner::looks_ahead() const {
    return options_.breadth > 1 && options_.criterion != SplitCriterion::dichotomy && !options_.wanted.empty();
}

std::optional<Question> Planner::best(const ConfigurationSet& whole_set) const {
    ++call_;
    const ConfigurationSet set = packed(whole_set), possible = set & possible_;
    if (space_->diagram) {
        if (is_decided(set)) return std::nullopt;
        if (!is_decided(possible))
            if (const std::optional<Question> question = best_alone(possible)) return question;
        return best_alone(set);
    }
    for (const ConfigurationSet* each : {&possible, &set}) {
        if (each == &set && set == possible) break;
        const Rows rows = this->rows().rows_of(*each);
        if (is_decided(rows)) continue;
        if (const auto question = looks_ahead() ? look_ahead(rows) : best_alone(*each)) return question;
    }
    return std::nullopt;
}

std::optional<Question> Planner::best_compiled(const ConfigurationSet& set, const std::vector<int>& wanted,
                                               bool must_tell) const {
    std::vector<LiteralQuestion> questions;
    std::vector<const Candidate*> asked;
    for (const Candidate& candidate : candidates_) {
        const std::optional<double> price = cost(candidate);
        if (!price) continue;
        questions.push_back({candidate.yes.literals()[0], *price});
        asked.push_back(&candidate);
    }
    ChoiceOptions choice;
    choice.criterion = options_.criterion;
    choice.wanted = wanted;
    choice.must_tell = must_tell;
    const auto best = knowledge::best_question(set.diagram(), questions, choice, set.literals());
    return best ? std::optional(asked[*best]->question) : std::nullopt;
}

std::optional<Question> Planner::best_about(const ConfigurationSet& whole_set,
                                            const ConfigurationSet& condition) const {
    ++call_;
    if (space_->diagram) return best_compiled(whole_set, condition.literals(), true);
    const ConfigurationSet set = packed(whole_set);
    const auto entropy_of = [](double yes, double n) {
        return n > 0 ? (entropy_sum(n) - entropy_sum(yes) - entropy_sum(n - yes)) / n : 0;
    };
    const ConfigurationSet inside = set & packed(condition);
    struct Asked {
        const Candidate* candidate;
        double price;
    };
    std::vector<Asked> asked;
    for (const Candidate& candidate : candidates_)
        if (const std::optional<double> price = cost(candidate)) asked.push_back({&candidate, *price});
    /// What the answer tells when `within` is possible and `good` what is wanted of it; 0 when it is known.
    const auto gain = [&](const Candidate& candidate, const ConfigurationSet& within, const ConfigurationSet& good) {
        const auto all = static_cast<double>(within.count()), all_good = static_cast<double>(good.count());
        const auto yes = static_cast<double>(within.count_common(candidate.yes)), no = all - yes;
        if (yes == 0 || no == 0) return 0.0;
        const auto yes_good = static_cast<double>(good.count_common(candidate.yes));
        const double left = (yes * entropy_of(yes_good, yes) + no * entropy_of(all_good - yes_good, no)) / all;
        const double told = entropy_of(all_good, all) - left;
        return told > 1e-12 ? told : 0.0;
    };
    Best best;
    for (const auto& [candidate, price] : asked)
        if (const double told = gain(*candidate, set, inside); told > 0) best.offer(candidate->question, told / price);
    if (best.question || inside.is_empty() || inside == set) return best.question;
    // Nothing tells alone; of an exclusive or, one answer makes the next one tell.
    for (const auto& [candidate, price] : asked) {
        double told = 0;
        for (const ConfigurationSet& half : {set & candidate->yes, set - candidate->yes}) {
            const ConfigurationSet good = inside & half;
            double most = 0;
            for (const auto& [next, next_price] : asked)
                most = std::max(most, gain(*next, half, good) / (price + next_price));
            told += most * static_cast<double>(half.count());
        }
        if (told > 0) best.offer(candidate->question, told / static_cast<double>(set.count()));
    }
    return best.question;
}

std::optional<Question> Planner::best_split(const ConfigurationSet& set) const {
    ++call_;
    return best_alone(packed(set));
}

std::optional<Question> Planner::cheapest_yes(const ConfigurationSet& whole_set) const {
    ++call_;
    const ConfigurationSet set = packed(whole_set);
    Best best;
    for (const Candidate& candidate : candidates_) {
        if (!set.is_subset_of(candidate.yes)) continue;
        if (const std::optional<double> price = cost(candidate)) best.offer(candidate.question, 1 / *price);
    }
    return best.question;
}

bool is_decided(const Space& space, const ConfigurationSet& set, const PlanOptions& options) {
    if (options.wanted.empty() && !space.diagram) return set.count() <= 1;
    if (options.wanted.empty())
        return std::ranges::all_of(space.holds, [&](const auto& values) {
            return std::ranges::all_of(values, [&](const ConfigurationSet& value) {
                return set.is_subset_of(value) || !set.intersects(value);
            });
        });
    return std::ranges::all_of(options.wanted, [&](ConceptId id) {
        const ConfigurationSet& where = space.concepts[id].where;
        return set.is_subset_of(where) || !set.intersects(where);
    });
}

std::optional<Question> best_question(const Space& space, const ConfigurationSet& set, const PlanOptions& options) {
    return Planner(space, options).best(set);
}

}  // namespace partonomy::knowledge
