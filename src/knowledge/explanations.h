#pragma once

#include <optional>
#include <span>
#include <vector>

#include "knowledge/solver.h"

namespace partonomy::knowledge {

/// A literal that switches something on, an axiom or an answer, and what giving it up would cost.
struct Selector {
    int literal;
    double weight = 1;  ///< >= 0
};

/// Selectors, by their place in the list; ascending.
using SelectorSet = std::vector<std::size_t>;

struct ExplanationOptions {
    std::size_t limit = 100;           ///< sets to find
    std::uint64_t steps = 10'000'000;  ///< of solver and search (steps.h): about ten seconds
};

struct RankedSet {
    SelectorSet set;
    double weight = 0;  ///< the sum of its selectors'
};

/// What was found, and whether that is all there is.
struct RankedSets {
    std::vector<RankedSet> sets;
    bool is_complete = true;  ///< false when a limit was reached before the search had come to its end
};

/* A *conflict* is a set of selectors that cannot all be true with the solver's clauses; a *correction* a set without
   which all others can. Both are minimal here: no selector can be left out of them. The empty set is the only conflict
   when the clauses contradict each other, and the only correction when nothing conflicts. To explain why something
   follows, give the solver its negation as a clause, or as one more selector. All functions give the same answer each
   time they are asked with a new solver. */

struct Conflict {
    SelectorSet set;
    bool is_minimal = true;  ///< false: the steps ran out before it was known of each selector that it is needed
};
/// One conflict; selectors early in the list are given up first. nullopt when there is none. Throws OutOfSteps when the
/// steps do not suffice to find out whether there is one; from then on, what is left of them goes into making it
/// minimal.
[[nodiscard]] std::optional<Conflict> minimal_conflict(Solver& solver, std::span<const Selector> selectors,
                                                       std::uint64_t steps = ExplanationOptions{}.steps);

/// All conflicts and all corrections, each by ascending weight, then size, then place.
struct ConflictsAndCorrections {
    RankedSets conflicts, corrections;
};
[[nodiscard]] ConflictsAndCorrections all_conflicts(Solver& solver, std::span<const Selector> selectors,
                                                    const ExplanationOptions& options = {});

/// Conflicts, the lightest first (then the smallest), without finding all others. Give every selector the weight 1 for
/// the smallest ones.
[[nodiscard]] RankedSets lightest_conflicts(Solver& solver, std::span<const Selector> selectors,
                                            const ExplanationOptions& options = {});

/// Corrections, the cheapest first (then the smallest), without finding all others.
[[nodiscard]] RankedSets cheapest_corrections(Solver& solver, std::span<const Selector> selectors,
                                              const ExplanationOptions& options = {});

}  // namespace partonomy::knowledge
