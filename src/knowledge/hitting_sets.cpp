/* Take the smallest set that is not hit yet and try each of its elements in turn; an element that was tried is barred
   from what is tried after it. A branch is left when what is chosen, and the cheapest element of each of some disjoint
   sets that are still to be hit, cost more than the best answer so far. */

#include "knowledge/hitting_sets.h"

#include <algorithm>
#include <compare>

namespace partonomy::knowledge {
namespace {

using Set = std::vector<std::size_t>;

constexpr std::size_t elements_a_step = 1000;  // that are looked at

struct Price {
    double weight = 0;
    std::size_t size = 0;
    auto operator<=>(const Price&) const = default;
};

class HittingSearch {
public:
    HittingSearch(const std::vector<Set>& sets, const std::vector<Set>& forbidden, const std::vector<double>& weights,
                  Steps* steps)
        : sets_(sets), forbidden_(forbidden), weights_(weights), steps_(steps), state_(weights.size(), State::open) {
        for (const std::vector<Set>& all : {sets, forbidden})
            for (const Set& set : all) elements_ += set.size();
    }

    std::optional<Set> run() {
        search({});
        return best_;
    }

private:
    enum class State : char { open, chosen, barred };

    [[nodiscard]] bool is_hit(const Set& set) const {
        return std::ranges::any_of(set, [&](std::size_t e) { return state_[e] == State::chosen; });
    }

    void search(const Price& price) {
        if (steps_ != nullptr && !steps_->take(1 + (elements_ + state_.size()) / elements_a_step)) throw OutOfSteps();
        const bool is_forbidden = std::ranges::any_of(forbidden_, [&](const Set& set) {
            return std::ranges::all_of(set, [&](std::size_t e) { return state_[e] == State::chosen; });
        });
        if (is_forbidden) return;
        Price bound = price;
        const Set* next = nullptr;
        std::size_t fewest = 0;
        std::vector<char> covered(state_.size(), 0);
        for (const Set& set : sets_) {
            if (is_hit(set)) continue;
            std::size_t open = 0;
            bool is_apart = true;
            double cheapest = 0;
            for (const std::size_t e : set) {
                if (state_[e] != State::open) continue;
                cheapest = open++ == 0 ? weights_[e] : std::min(cheapest, weights_[e]);
                is_apart &= !covered[e];
            }
            if (open == 0) return;
            if (next == nullptr || open < fewest) {
                next = &set;
                fewest = open;
            }
            if (!is_apart) continue;
            bound.weight += cheapest;
            ++bound.size;
            for (const std::size_t e : set) covered[e] = 1;
        }
        if (best_ && is_worse(bound)) return;
        if (next == nullptr) return offer(price);
        Set elements;
        for (const std::size_t e : *next)
            if (state_[e] == State::open) elements.push_back(e);
        std::ranges::stable_sort(elements, {}, [&](std::size_t e) { return weights_[e]; });
        for (const std::size_t e : elements) {
            state_[e] = State::chosen;
            search({price.weight + weights_[e], price.size + 1});
            state_[e] = State::barred;
        }
        for (const std::size_t e : elements) state_[e] = State::open;
    }

    /// Sums that differ by rounding only are equal.
    [[nodiscard]] bool is_worse(const Price& price) const {
        const double slack = 1e-9 * (1 + best_price_.weight);
        if (price.weight > best_price_.weight + slack) return true;
        return price.weight > best_price_.weight - slack && price.size > best_price_.size;
    }

    void offer(const Price& price) {
        Set set;
        for (std::size_t e = 0; e < state_.size(); ++e)
            if (state_[e] == State::chosen) set.push_back(e);
        const double slack = 1e-9 * (1 + best_price_.weight);
        const bool is_better =
            !best_ || price.weight < best_price_.weight - slack || price.size < best_price_.size || set < *best_;
        if (!is_better) return;
        best_ = std::move(set);
        best_price_ = price;
    }

    const std::vector<Set>&sets_, &forbidden_;
    const std::vector<double>& weights_;
    Steps* steps_;
    std::size_t elements_ = 0;  ///< of all sets
    std::vector<State> state_;
    std::optional<Set> best_;
    Price best_price_;
};

}  // namespace

std::optional<std::vector<std::size_t>> minimum_hitting_set(const std::vector<std::vector<std::size_t>>& sets,
                                                            const std::vector<std::vector<std::size_t>>& forbidden,
                                                            const std::vector<double>& weights, Steps* steps) {
    return HittingSearch(sets, forbidden, weights, steps).run();
}

}  // namespace partonomy::knowledge
