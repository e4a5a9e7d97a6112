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

constexpr std::size_t look_ahead_budget = 200;  ///< sets to price for one question

double entropy_sum(double n) { return n > 0 ? n * std::log2(n) : 0; }

/// The same of whole numbers, those below the size of the table looked up.
class EntropySums {
public:
    EntropySums() {
        for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = entropy_sum(static_cast<double>(i));
    }
    double operator()(std::size_t n) const {
        return n < table_.size() ? table_[n] : entropy_sum(static_cast<double>(n));
    }

private:
    std::array<double, 1024> table_;
};

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

/// Keeps the `most` highest scores, the first of equal ones first.
template <typename Scored>
void offer(std::vector<Scored>& best, Scored scored, std::size_t most) {
    auto place = best.end();
    while (place != best.begin() && scored.score > std::prev(place)->score * (1 + 1e-9)) --place;
    best.insert(place, scored);
    if (best.size() > most) best.pop_back();
}

/// Classes of the configurations of a space, `all`, that agree on each of `concepts`.
std::vector<ConfigurationSet> label_classes(ConfigurationSet all, const std::vector<ConfigurationSet>& concepts) {
    std::vector<ConfigurationSet> classes;
    if (concepts.empty()) return classes;
    classes.push_back(std::move(all));
    for (const ConfigurationSet& where : concepts) {
        std::vector<ConfigurationSet> finer;
        for (ConfigurationSet& each : classes) {
            ConfigurationSet inside = each & where;
            each -= where;
            if (!inside.is_empty()) finer.push_back(std::move(inside));
            if (!each.is_empty()) finer.push_back(std::move(each));
        }
        classes = std::move(finer);
    }
    return classes;
}

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
    if (!space.diagram) {
        std::vector<ConfigurationSet> concepts;
        for (const ConceptId id : options_.wanted) concepts.push_back(packed(space.concepts[id].where));
        labels_ = label_classes(packed(space.all()), concepts);
    }
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

ConfigurationSet Planner::packed(const ConfigurationSet& set) const { return within_ ? set.packed(*within_) : set; }

std::optional<double> Planner::cost(const Candidate& candidate) const {
    if (!options_.cost) return candidate.answerable ? std::optional(1.0) : std::nullopt;
    KnownCost& known = costs_[static_cast<std::size_t>(&candidate - candidates_.data())];
    if (known.call != call_) known = {options_.cost(candidate.question), call_};
    return known.cost;
}

bool Planner::is_decided(const ConfigurationSet& set) const { return is_decided_packed(packed(set)); }

bool Planner::is_decided_packed(const ConfigurationSet& set) const {
    if (space_->diagram) return knowledge::is_decided(*space_, set, options_);
    if (labels_.empty()) return set.count() <= 1;
    const auto is_one_label = [&](const ConfigurationSet& some) {
        const std::optional<std::size_t> first = some.first();
        return !first || some.is_subset_of(labels_[rows().label[*first]]);
    };
    // When what nothing can answer tells the label, nothing that is asked will.
    const auto is_told = [&](const auto& self, const ConfigurationSet& some, std::size_t from) -> bool {
        if (is_one_label(some)) return true;
        for (std::size_t i = from; i < open_.size(); ++i) {
            const ConfigurationSet& yes = candidates_[open_[i]].yes;
            if (some.is_subset_of(yes) || !some.intersects(yes)) continue;
            return self(self, some & yes, i + 1) && self(self, some - yes, i + 1);
        }
        return false;
    };
    return is_told(is_told, set, 0);
}

std::optional<Question> Planner::best(const ConfigurationSet& set) const {
    ++call_;
    return best_packed(packed(set));
}

std::optional<Question> Planner::best_packed(const ConfigurationSet& set) const {
    if (is_decided_packed(set)) return std::nullopt;
    const ConfigurationSet possible = set & possible_;
    if (!is_decided_packed(possible))
        if (const std::optional<Question> question = look_ahead(possible)) return question;
    return look_ahead(set);
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

const Planner::Rows& Planner::rows() const {
    if (rows_) return *rows_;
    const std::size_t size = possible_.size();
    rows_.emplace();
    rows_->label.resize(size);
    for (std::size_t label = 0; label < labels_.size(); ++label)
        labels_[label].for_each([&](std::size_t i) { rows_->label[i] = static_cast<std::uint32_t>(label); });
    rows_->first.assign(size + 1, 0);
    for (const Candidate& candidate : candidates_)
        candidate.yes.for_each([&](std::size_t i) { ++rows_->first[i + 1]; });
    for (std::size_t i = 0; i < size; ++i) rows_->first[i + 1] += rows_->first[i];
    rows_->yes.resize(rows_->first[size]);
    std::vector<std::uint32_t> next(rows_->first.begin(), rows_->first.end() - 1);
    for (std::size_t c = 0; c < candidates_.size(); ++c)
        candidates_[c].yes.for_each([&](std::size_t i) { rows_->yes[next[i]++] = static_cast<std::uint32_t>(c); });
    return *rows_;
}

std::vector<Planner::Scored> Planner::most_even(const ConfigurationSet& set, std::size_t most) const {
    const std::size_t count = set.count();
    std::vector<Scored> even;
    for (const Candidate& candidate : candidates_) {
        const std::size_t yes = set.count_common(candidate.yes);
        if (yes == 0 || yes == count || !cost(candidate)) continue;
        const auto smaller = static_cast<double>(std::min(yes, count - yes));
        offer(even, {&candidate, smaller / price(candidate), static_cast<double>(yes) / static_cast<double>(count)},
              most);
    }
    return even;
}

std::vector<Planner::Scored> Planner::ranking(const ConfigurationSet& set, std::size_t most) const {
    if (options_.criterion == SplitCriterion::dichotomy || labels_.empty()) return most_even(set, most);
    const Rows& rows = this->rows();
    std::size_t count = 0;
    std::vector<std::size_t> sizes(labels_.size(), 0);  // of the labels within the set
    set.for_each([&](std::size_t i) {
        ++count;
        ++sizes[rows.label[i]];
    });
    std::vector<std::uint32_t> place(labels_.size(), 0);  // of a label among those that occur
    std::size_t labels = 0;
    for (std::size_t label = 0; label < sizes.size(); ++label) {
        if (sizes[label] == 0) continue;
        sizes[labels] = sizes[label];
        place[label] = static_cast<std::uint32_t>(labels++);
    }
    const std::size_t width = candidates_.size();
    std::vector<std::uint32_t> yes_of(labels * width, 0);  // by label, then candidate
    set.for_each([&](std::size_t i) {
        std::uint32_t* inside = &yes_of[place[rows.label[i]] * width];
        for (std::uint32_t at = rows.first[i]; at < rows.first[i + 1]; ++at) ++inside[rows.yes[at]];
    });
    std::vector<std::uint32_t> yes_in_all(width, 0);
    for (std::size_t label = 0; label < labels; ++label)
        for (std::size_t c = 0; c < width; ++c) yes_in_all[c] += yes_of[label * width + c];
    static const EntropySums sums;
    double open = 0;  // sum of n log n over the classes: entropy = log n - open / n
    for (std::size_t label = 0; label < labels; ++label) open += sums(sizes[label]);
    const auto n = static_cast<double>(count);
    std::vector<Scored> gain;
    for (std::size_t c = 0; c < width; ++c) {
        const Candidate& candidate = candidates_[c];
        const std::size_t yes = yes_in_all[c];
        if (yes == 0 || yes == count || !cost(candidate)) continue;
        // n times the gain: n H - (yes H_yes + no H_no)
        double bits = sums(count) - sums(yes) - sums(count - yes) - open;
        for (std::size_t label = 0; label < labels; ++label) {
            const std::size_t inside = yes_of[label * width + c];
            bits += sums(inside) + sums(sizes[label] - inside);
        }
        if (bits > 1e-9 * n) offer(gain, {&candidate, bits / n / price(candidate), static_cast<double>(yes) / n}, most);
    }
    return gain.empty() ? most_even(set, most) : gain;
}

std::optional<Question> Planner::best_split(const ConfigurationSet& set) const {
    ++call_;
    return split_packed(packed(set));
}

std::optional<Question> Planner::split_packed(const ConfigurationSet& set) const {
    if (space_->diagram) {
        std::vector<int> wanted;
        for (const ConceptId id : options_.wanted) wanted.push_back(space_->concepts[id].where.literals()[0]);
        if (const auto question = best_compiled(set, wanted, false)) return question;
        return best_compiled(set, {}, false);
    }
    const std::vector<Scored> best = ranking(set, 1);
    return best.empty() ? std::nullopt : std::optional(best[0].candidate->question);
}

double Planner::price(const Candidate& candidate) const {
    return options_.criterion == SplitCriterion::gain_per_cost ? *cost(candidate) : 1;
}

std::optional<double> Planner::price_of(const ConfigurationSet& set, std::size_t& budget) const {
    if (is_decided_packed(set)) return 0;
    if (const auto found = prices_.find(set); found != prices_.end()) return found->second;
    if (budget == 0) return std::nullopt;
    --budget;
    const std::vector<Scored> best = ranking(set, 1);
    if (best.empty()) return prices_[set] = 0;
    const Candidate& asked = *best[0].candidate;
    const std::optional<double> yes = price_of(set & asked.yes, budget), no = price_of(set - asked.yes, budget);
    if (!yes || !no) return std::nullopt;
    const double share = best[0].share;
    return prices_[set] = price(asked) + share * *yes + (1 - share) * *no;
}

std::optional<Question> Planner::look_ahead(const ConfigurationSet& set) const {
    const bool is_wise = options_.breadth > 1 && options_.criterion != SplitCriterion::dichotomy && !labels_.empty();
    if (space_->diagram || !is_wise) return split_packed(set);
    std::size_t budget = look_ahead_budget;
    std::optional<Question> best;
    double least = 0;
    for (const Scored& each : ranking(set, options_.breadth)) {
        const ConfigurationSet& answer = each.candidate->yes;
        const std::optional<double> yes = price_of(set & answer, budget), no = price_of(set - answer, budget);
        if (best && (!yes || !no)) break;
        const double share = each.share;
        const double whole = yes && no ? price(*each.candidate) + share * *yes + (1 - share) * *no : 0;
        if (best && whole >= least - 1e-9 * least) continue;
        best = each.candidate->question;
        least = whole;
        if (!yes || !no) break;
    }
    return best;
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
