/* Minimal explanations and corrections over selectors.

   One conflict: the solver names selectors that suffice; each of them is left out in turn, and stays out when the rest
   still conflicts (deletion, with what the solver names then).

   All of them: as MARCO (Liffiton, Previti, Malik and Marques-Silva, "Fast, flexible MUS enumeration", 2016). A second
   formula, the map, knows which sets of selectors are settled. Ask it for one that is not: if it conflicts, shrink it
   to a conflict and settle all larger sets; otherwise grow it until nothing fits in, what is left out is a correction,
   and all smaller sets are settled. When the map has no model, nothing is missing.

   The lightest without all others: a conflict shares a selector with every correction, and a correction with every
   conflict (Reiter 1987). So guess the lightest set that hits all corrections known so far; if it conflicts, it is the
   lightest conflict, else grow it and learn one more correction (Ignatiev, Previti, Liffiton and Marques-Silva,
   "Smallest MUS extraction with minimal hitting set dualization", 2015). Found ones are forbidden, and the next
   lightest follows. Corrections are found the same way with the roles exchanged.

   There may be exponentially many sets; limits on number and work stop the search and say so. */

#include "knowledge/explanations.h"

#include <algorithm>
#include <stdexcept>
#include <tuple>

#include "knowledge/hitting_sets.h"

namespace partonomy::knowledge {
namespace {

class Conflicts {
public:
    Conflicts(Solver& solver, std::span<const Selector> selectors, Steps* steps)
        : solver_(solver), selectors_(selectors) {
        solver_.take_from(steps);
        for (std::size_t i = 0; i < selectors.size(); ++i) {
            if (!(selectors[i].weight >= 0))
                throw std::invalid_argument("explanations: the weight of a selector should not be negative");
            weights_.push_back(selectors[i].weight);
            all_.push_back(i);
        }
    }

    ~Conflicts() { solver_.take_from(nullptr); }
    Conflicts(const Conflicts&) = delete;
    Conflicts& operator=(const Conflicts&) = delete;

    [[nodiscard]] bool has_conflict(const SelectorSet& set) {
        std::vector<int> assumptions;
        for (const std::size_t i : set) assumptions.push_back(selectors_[i].literal);
        return solver_.solve(assumptions) == Verdict::unsatisfiable;
    }

    /// A conflict within `set`, which has one.
    [[nodiscard]] SelectorSet shrink(SelectorSet set) {
        shrink_in_place(set);
        return set;
    }
    /// When the steps run out, `set` has still a conflict.
    void shrink_in_place(SelectorSet& set) {
        keep_core(set);
        for (std::size_t k = 0; k < set.size();) {
            SelectorSet fewer = set;
            fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(k));
            if (has_conflict(fewer)) {
                set = std::move(fewer);
                keep_core(set);
            } else {
                ++k;
            }
        }
    }

    /// What is missing in a largest set around `set`, which has no conflict: a correction.
    [[nodiscard]] SelectorSet correction_around(SelectorSet set) {
        SelectorSet missing;
        std::ranges::set_difference(all_, set, std::back_inserter(missing));
        std::erase_if(missing, [&](std::size_t i) {
            set.push_back(i);
            if (!has_conflict(set)) return true;
            set.pop_back();
            return false;
        });
        return missing;
    }

    [[nodiscard]] SelectorSet without(const SelectorSet& set) const {
        SelectorSet rest;
        std::ranges::set_difference(all_, set, std::back_inserter(rest));
        return rest;
    }
    [[nodiscard]] RankedSet ranked(SelectorSet set) const {
        double weight = 0;
        for (const std::size_t i : set) weight += weights_[i];
        return {std::move(set), weight};
    }
    [[nodiscard]] const SelectorSet& all() const { return all_; }
    [[nodiscard]] const std::vector<double>& weights() const { return weights_; }

private:
    /// After an answer that `set` conflicts. Elements that were tried already stay: each conflict within `set` has
    /// them.
    void keep_core(SelectorSet& set) {
        const std::vector<int> core = solver_.core();
        std::erase_if(set, [&](std::size_t i) { return std::ranges::find(core, selectors_[i].literal) == core.end(); });
    }

    Solver& solver_;
    std::span<const Selector> selectors_;
    std::vector<double> weights_;
    SelectorSet all_;
};

void rank(std::vector<RankedSet>& sets) {
    std::ranges::sort(sets, [](const RankedSet& a, const RankedSet& b) {
        const std::size_t a_size = a.set.size(), b_size = b.set.size();
        return std::tie(a.weight, a_size, a.set) < std::tie(b.weight, b_size, b.set);
    });
}

/// Sets of one kind, the lightest first. `is_one` tells whether a guess contains one; `other_kind` makes a set of the
/// other kind from a guess that does not: one that the guess fails to hit.
template <typename IsOne, typename OtherKind>
RankedSets lightest(Conflicts& conflicts, const ExplanationOptions& options, Steps& steps, const IsOne& is_one,
                    const OtherKind& other_kind) {
    RankedSets result;
    std::vector<SelectorSet> to_hit, found;
    try {
        while (true) {
            const std::optional<SelectorSet> guess = minimum_hitting_set(to_hit, found, conflicts.weights(), &steps);
            if (!guess) return result;
            if (result.sets.size() >= options.limit) break;
            if (is_one(*guess)) {
                result.sets.push_back(conflicts.ranked(*guess));
                found.push_back(*guess);
            } else {
                to_hit.push_back(other_kind(*guess));
            }
        }
    } catch (const OutOfSteps&) {  // what was found until then are the lightest
    }
    result.is_complete = false;
    return result;
}

}  // namespace

std::optional<Conflict> minimal_conflict(Solver& solver, std::span<const Selector> selectors, std::uint64_t most) {
    Steps steps(most);
    Conflicts conflicts(solver, selectors, &steps);
    if (!conflicts.has_conflict(conflicts.all())) return std::nullopt;
    Conflict conflict{conflicts.all()};
    try {
        conflicts.shrink_in_place(conflict.set);
    } catch (const OutOfSteps&) {
        conflict.is_minimal = false;
    }
    return conflict;
}

ConflictsAndCorrections all_conflicts(Solver& solver, std::span<const Selector> selectors,
                                      const ExplanationOptions& options) {
    Steps steps(options.steps);
    Conflicts conflicts(solver, selectors, &steps);
    ConflictsAndCorrections result;
    Clauses map;
    for (std::size_t i = 0; i < selectors.size(); ++i) (void)map.add_variable();
    Solver map_solver(map);
    map_solver.take_from(&steps);
    const auto settle = [&](const SelectorSet& set, int sign) {
        std::vector<int> clause;
        for (const std::size_t i : set) clause.push_back(sign * static_cast<int>(i + 1));
        map.add(clause);
        map_solver.add_new(map);
    };
    const auto has_all = [&] {
        if (map_solver.solve() == Verdict::unsatisfiable) return true;
        const std::size_t found = std::max(result.conflicts.sets.size(), result.corrections.sets.size());
        if (found >= options.limit) throw OutOfSteps();
        SelectorSet seed;
        for (std::size_t i = 0; i < selectors.size(); ++i)
            if (map_solver.value(static_cast<int>(i + 1))) seed.push_back(i);
        if (conflicts.has_conflict(seed)) {
            const SelectorSet conflict = conflicts.shrink(std::move(seed));
            settle(conflict, -1);
            result.conflicts.sets.push_back(conflicts.ranked(conflict));
        } else {
            const SelectorSet correction = conflicts.correction_around(std::move(seed));
            settle(correction, 1);
            result.corrections.sets.push_back(conflicts.ranked(correction));
        }
        return false;
    };
    try {
        while (!has_all()) continue;
    } catch (const OutOfSteps&) {
        result.conflicts.is_complete = result.corrections.is_complete = false;
    }
    rank(result.conflicts.sets);
    rank(result.corrections.sets);
    return result;
}

RankedSets lightest_conflicts(Solver& solver, std::span<const Selector> selectors, const ExplanationOptions& options) {
    Steps steps(options.steps);
    Conflicts conflicts(solver, selectors, &steps);
    return lightest(
        conflicts, options, steps, [&](const SelectorSet& guess) { return conflicts.has_conflict(guess); },
        [&](const SelectorSet& guess) { return conflicts.correction_around(guess); });
}

RankedSets cheapest_corrections(Solver& solver, std::span<const Selector> selectors,
                                const ExplanationOptions& options) {
    Steps steps(options.steps);
    Conflicts conflicts(solver, selectors, &steps);
    return lightest(
        conflicts, options, steps,
        [&](const SelectorSet& guess) { return !conflicts.has_conflict(conflicts.without(guess)); },
        [&](const SelectorSet& guess) { return conflicts.shrink(conflicts.without(guess)); });
}

}  // namespace partonomy::knowledge
