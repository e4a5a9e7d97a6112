#include <algorithm>
#include <cmath>

#include "knowledge/decision_tree.h"

// Which questions tell most, and what asking on costs. Both look at rows (plan_rows.h): a set is counted once, label by
// label, and each question's gain is a sum over those counts. The price of a set is worked out by asking on: its rows
// are parted in place, the smaller half is counted, and the larger is the rest.

namespace partonomy::knowledge {
namespace {

constexpr std::size_t look_ahead_budget = 200;  ///< sets to price for one question

/// n log n, of small numbers looked up.
class EntropySums {
public:
    EntropySums() {
        for (std::size_t i = 0; i < table_.size(); ++i) table_[i] = of(i);
    }
    double operator()(std::size_t n) const { return n < table_.size() ? table_[n] : of(n); }

private:
    static double of(std::size_t n) {
        const auto x = static_cast<double>(n);
        return n > 0 ? x * std::log2(x) : 0;
    }
    std::array<double, 1024> table_;
};

/// Keeps the `most` highest scores, the first of equal ones first.
template <typename Scored>
void offer(std::vector<Scored>& best, Scored scored, std::size_t most) {
    auto place = best.end();
    while (place != best.begin() && scored.score > std::prev(place)->score * (1 + 1e-9)) --place;
    best.insert(place, scored);
    if (best.size() > most) best.pop_back();
}

}  // namespace

const PlanRows& Planner::rows() const {
    if (!rows_) {
        std::vector<ConfigurationSet> wanted;
        for (const ConceptId id : options_.wanted) wanted.push_back(packed(space_->concepts[id].where));
        std::vector<const ConfigurationSet*> questions;
        for (const Candidate& candidate : candidates_) questions.push_back(&candidate.yes);
        rows_ = std::make_shared<const PlanRows>(possible_.size(), wanted, questions);
    }
    return *rows_;
}

template <typename Yes>
std::vector<Planner::Scored> Planner::most_even(std::size_t count, const Yes& yes_of, std::size_t most) const {
    std::vector<Scored> even;
    for (std::size_t c = 0; c < candidates_.size(); ++c) {
        const std::size_t yes = yes_of(c);
        if (yes == 0 || yes == count || !cost(candidates_[c])) continue;
        const auto smaller = static_cast<double>(std::min(yes, count - yes));
        offer(even, {c, smaller / price(candidates_[c]), static_cast<double>(yes) / static_cast<double>(count)}, most);
    }
    return even;
}

std::vector<Planner::Scored> Planner::ranking(const RowCounts& counts, std::size_t most) const {
    static const EntropySums sums;
    const std::size_t width = candidates_.size(), labels = counts.labels.size(), count = counts.count;
    double open = 0;                   // sum of n log n over the classes: entropy = log n - open / n
    std::vector<std::size_t> several;  // labels of more than one configuration; the others add nothing
    for (std::size_t label = 0; label < labels; ++label) {
        open += sums(counts.sizes[label]);
        if (counts.sizes[label] > 1) several.push_back(label);
    }
    const auto n = static_cast<double>(count);
    std::vector<Scored> gain;
    for (std::size_t c = 0; c < width; ++c) {
        const std::size_t yes = counts.yes_in_all[c];
        if (yes == 0 || yes == count || !cost(candidates_[c])) continue;
        // n times the gain: n H - (yes H_yes + no H_no)
        double bits = sums(count) - sums(yes) - sums(count - yes) - open;
        for (const std::size_t label : several) {
            const std::size_t inside = counts.yes[label * width + c];
            bits += sums(inside) + sums(counts.sizes[label] - inside);
        }
        if (bits > 1e-9 * n) offer(gain, {c, bits / n / price(candidates_[c]), static_cast<double>(yes) / n}, most);
    }
    if (!gain.empty()) return gain;
    return most_even(
        count, [&](std::size_t c) { return counts.yes_in_all[c]; }, most);
}

std::optional<Question> Planner::best_alone(const ConfigurationSet& set) const {
    if (space_->diagram) {
        std::vector<int> wanted;
        for (const ConceptId id : options_.wanted) wanted.push_back(space_->concepts[id].where.literals()[0]);
        if (const auto question = best_compiled(set, wanted, false)) return question;
        return best_compiled(set, {}, false);
    }
    std::vector<Scored> best;
    const std::size_t count = set.count();
    if (options_.criterion != SplitCriterion::dichotomy && !options_.wanted.empty()) {
        RowCounts counts;
        rows().count(rows().rows_of(set), counts);
        best = ranking(counts, 1);
    } else if (count * 64 < set.size()) {  // few rows, each of which answers some questions with yes
        const std::vector<std::uint32_t> yes = rows().count_yes(set);
        best = most_even(
            count, [&](std::size_t c) { return yes[c]; }, 1);
    } else {
        best = most_even(
            count, [&](std::size_t c) { return set.count_common(candidates_[c].yes); }, 1);
    }
    return best.empty() ? std::nullopt : std::optional(candidates_[best[0].candidate].question);
}

double Planner::price(const Candidate& candidate) const {
    return options_.criterion == SplitCriterion::gain_per_cost ? *cost(candidate) : 1;
}

std::array<std::optional<double>, 2> Planner::prices_after(std::span<std::uint32_t> rows, RowSum sum,
                                                           const RowCounts& counts, std::size_t candidate,
                                                           std::size_t& budget, std::size_t depth) const {
    const std::size_t yes = this->rows().split(rows, candidate, scratch_);
    const std::array halves{rows.first(yes), rows.subspan(yes)};
    const int smaller = halves[0].size() <= halves[1].size() ? 0 : 1;
    std::array<RowSum, 2> sums;
    sums[smaller] = this->rows().sum(halves[smaller]);
    sums[1 - smaller] = sum - sums[smaller];
    std::array<std::optional<double>, 2> prices;
    for (const int half : {0, 1}) prices[half] = is_decided(halves[half]) ? 0 : prices_.value(sums[half]);
    if (budget == 0 || (prices[0] && prices[1])) return prices;
    if (counts_.size() <= depth) counts_.emplace_back();
    std::array<RowCounts, 2>& counted = counts_[depth];
    this->rows().count(halves[smaller], counted[smaller]);
    if (!prices[1 - smaller]) this->rows().subtract(counts, counted[smaller], counted[1 - smaller]);
    for (const int half : {0, 1}) {
        if (prices[half]) continue;
        prices[half] = price_of(halves[half], sums[half], counted[half], budget, depth + 1);
        if (!prices[half]) break;
    }
    return prices;
}

std::optional<double> Planner::price_of(std::span<std::uint32_t> rows, RowSum sum, const RowCounts& counts,
                                        std::size_t& budget, std::size_t depth) const {
    if (budget == 0) return std::nullopt;
    --budget;
    const std::vector<Scored> best = ranking(counts, 1);
    if (best.empty()) return prices_.value(sum) = 0;
    const auto [yes, no] = prices_after(rows, sum, counts, best[0].candidate, budget, depth);
    if (!yes || !no) return std::nullopt;
    const double share = best[0].share;
    return prices_.value(sum) = price(candidates_[best[0].candidate]) + share * *yes + (1 - share) * *no;
}

std::optional<Question> Planner::look_ahead(const Rows& rows) const {
    std::size_t budget = look_ahead_budget;
    RowCounts counts;
    this->rows().count(rows, counts);
    if (counts.labels.size() > look_ahead_budget) {  // a tree has at least as many leaves: it would not be priced
        const std::vector<Scored> first = ranking(counts, 1);
        return first.empty() ? std::nullopt : std::optional(candidates_[first[0].candidate].question);
    }
    const RowSum sum = this->rows().sum(rows);
    std::optional<std::size_t> best;
    double least = 0;
    Rows parted;
    for (const Scored& each : ranking(counts, options_.breadth)) {
        parted = rows;
        const auto [yes, no] = prices_after(parted, sum, counts, each.candidate, budget, 0);
        if (best && (!yes || !no)) break;
        const double whole =
            yes && no ? price(candidates_[each.candidate]) + each.share * *yes + (1 - each.share) * *no : 0;
        if (best && whole >= least - 1e-9 * least) continue;
        best = each.candidate;
        least = whole;
        if (!yes || !no) break;
    }
    return best ? std::optional(candidates_[*best].question) : std::nullopt;
}

}  // namespace partonomy::knowledge
