#include "knowledge/explanations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>
#include <set>

#include "knowledge/hitting_sets.h"

// Conflicts and corrections against every subset of the selectors, each tried with every assignment.

using namespace partonomy::knowledge;

namespace {

/// Clauses over `variables` variables; rule i holds when selector i does.
struct Instance {
    Clauses clauses;
    std::vector<Selector> selectors;
    std::vector<std::vector<int>> rules;
    int variables = 0;
};

Instance random_instance(std::mt19937& random, bool weighted) {
    Instance instance;
    instance.variables = 2 + static_cast<int>(random() % 3);
    for (int v = 0; v < instance.variables; ++v) (void)instance.clauses.add_variable();
    const std::size_t rules = 4 + random() % 6;
    for (std::size_t i = 0; i < rules; ++i) {
        std::set<int> rule;
        for (std::size_t k = 0; k < 1 + random() % 2; ++k) {
            const int v = 1 + static_cast<int>(random() % static_cast<unsigned>(instance.variables));
            rule.insert(random() % 2 == 0 ? v : -v);
        }
        instance.rules.emplace_back(rule.begin(), rule.end());
        const int selector = instance.clauses.add_variable();
        instance.selectors.push_back({selector, weighted ? static_cast<double>(random() % 6) / 4 : 1});
        std::vector<int> clause = instance.rules.back();
        clause.push_back(-selector);
        instance.clauses.add(clause);
    }
    return instance;
}

bool has_conflict(const Instance& instance, unsigned subset) {
    for (unsigned model = 0; model < (1U << instance.variables); ++model) {
        bool fine = true;
        for (std::size_t i = 0; i < instance.rules.size(); ++i)
            fine &= ((subset >> i) & 1U) == 0 || std::ranges::any_of(instance.rules[i], [&](int literal) {
                        return ((model >> (std::abs(literal) - 1)) & 1U) == (literal > 0 ? 1U : 0U);
                    });
        if (fine) return false;
    }
    return true;
}

SelectorSet to_set(unsigned subset) {
    SelectorSet set;
    for (std::size_t i = 0; i < 32; ++i)
        if ((subset >> i) & 1U) set.push_back(i);
    return set;
}

/// All minimal subsets with the property, which supersets share.
template <typename Property>
std::set<SelectorSet> minimal(std::size_t n, const Property& property) {
    std::set<SelectorSet> result;
    for (unsigned subset = 0; subset < (1U << n); ++subset) {
        bool is_minimal = property(subset);
        for (unsigned i = 0; is_minimal && i < n; ++i)
            if ((subset >> i) & 1U) is_minimal = !property(subset & ~(1U << i));
        if (is_minimal) result.insert(to_set(subset));
    }
    return result;
}

std::set<SelectorSet> sets_of(const RankedSets& ranked) {
    std::set<SelectorSet> sets;
    for (const RankedSet& each : ranked.sets) sets.insert(each.set);
    EXPECT_EQ(sets.size(), ranked.sets.size()) << "the same set twice";
    return sets;
}

bool is_ascending(const RankedSets& ranked) {
    return std::ranges::is_sorted(ranked.sets, [](const RankedSet& a, const RankedSet& b) {
        return a.weight < b.weight - 1e-9 || (a.weight < b.weight + 1e-9 && a.set.size() < b.set.size());
    });
}

}  // namespace

TEST(Explanations, AreThoseOfEverySubsetTried) {
    int conflicting = 0;
    for (unsigned seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const Instance instance = random_instance(random, seed % 2 == 0);
        const std::size_t n = instance.selectors.size();
        const unsigned all = (1U << n) - 1;
        const auto conflicts = minimal(n, [&](unsigned subset) { return has_conflict(instance, subset); });
        const auto corrections = minimal(n, [&](unsigned subset) { return !has_conflict(instance, all & ~subset); });

        Solver solver(instance.clauses);
        const std::optional<Conflict> one = minimal_conflict(solver, instance.selectors);
        EXPECT_EQ(one.has_value(), !conflicts.empty());
        EXPECT_TRUE(!one || (one->is_minimal && conflicts.contains(one->set)));
        conflicting += one.has_value();
        EXPECT_THROW((void)minimal_conflict(solver, instance.selectors, 0), OutOfSteps);
        std::optional<Conflict> hurried;  // with the fewest steps that tell whether there is one
        for (std::uint64_t steps = 1; !hurried && one; ++steps) try {
                hurried = minimal_conflict(solver, instance.selectors, steps);
            } catch (const OutOfSteps&) {
            }
        if (hurried) {
            unsigned subset = 0;
            for (const std::size_t i : hurried->set) subset |= 1U << i;
            EXPECT_TRUE(has_conflict(instance, subset)) << "what is left when the steps run out is a conflict, too";
            EXPECT_TRUE(!hurried->is_minimal || conflicts.contains(hurried->set));
        }

        const ConflictsAndCorrections both = all_conflicts(solver, instance.selectors, {10'000});
        EXPECT_TRUE(both.conflicts.is_complete);
        EXPECT_EQ(sets_of(both.conflicts), conflicts);
        EXPECT_EQ(sets_of(both.corrections), corrections);
        EXPECT_TRUE(is_ascending(both.conflicts));

        const RankedSets lightest = lightest_conflicts(solver, instance.selectors, {10'000});
        EXPECT_TRUE(lightest.is_complete);
        EXPECT_EQ(sets_of(lightest), conflicts);
        EXPECT_TRUE(is_ascending(lightest));
        const RankedSets cheapest = cheapest_corrections(solver, instance.selectors, {10'000});
        EXPECT_EQ(sets_of(cheapest), corrections);
        EXPECT_TRUE(is_ascending(cheapest));

        if (corrections.size() > 1) {
            const RankedSets first = cheapest_corrections(solver, instance.selectors, {1});
            EXPECT_FALSE(first.is_complete);
            ASSERT_EQ(first.sets.size(), 1U);
            EXPECT_EQ(first.sets[0].set, cheapest.sets[0].set);
        }
    }
    EXPECT_GT(conflicting, 100);
}

TEST(Explanations, OfClausesThatContradictEachOtherIsTheEmptySet) {
    Clauses clauses;
    const int a = clauses.add_variable(), switch_ = clauses.add_variable();
    clauses.add({a});
    clauses.add({-a});
    Solver solver(clauses);
    const std::vector<Selector> selectors{{switch_}};
    EXPECT_EQ(minimal_conflict(solver, selectors)->set, SelectorSet{});
    const ConflictsAndCorrections both = all_conflicts(solver, selectors);
    ASSERT_EQ(both.conflicts.sets.size(), 1U);
    EXPECT_TRUE(both.conflicts.sets[0].set.empty());
    EXPECT_TRUE(both.corrections.sets.empty());
}

TEST(Explanations, TwoAnswersMayHaveToChangeTogether) {
    // Two witnesses each say yes; a rule says that nobody does.
    Clauses clauses;
    const int x = clauses.add_variable(), y = clauses.add_variable(), rule = clauses.add_variable();
    const int first = clauses.add_variable(), second = clauses.add_variable();
    clauses.add({-rule, -x});
    clauses.add({-rule, -y});
    clauses.add({-first, x});
    clauses.add({-second, y});
    Solver solver(clauses);
    const RankedSets repairs =
        cheapest_corrections(solver, std::vector<Selector>{{first, 0.2}, {second, 0.3}, {rule, 5}});
    ASSERT_EQ(repairs.sets.size(), 2U);
    EXPECT_EQ(repairs.sets[0].set, (SelectorSet{0, 1}));
    EXPECT_NEAR(repairs.sets[0].weight, 0.5, 1e-12);
    EXPECT_EQ(repairs.sets[1].set, (SelectorSet{2}));
}

TEST(Explanations, EndAfterTheSameStepsEachTime) {
    // Sixteen pigeons in holes for five of them, each pigeon a selector: far too many conflicts to list.
    Clauses clauses;
    std::vector<Selector> selectors;
    std::vector<std::vector<int>> holes(5);
    for (int pigeon = 0; pigeon < 16; ++pigeon) {
        selectors.push_back({clauses.add_variable(), 1.0 + pigeon % 3});
        std::vector<int> somewhere{-selectors.back().literal};
        for (std::vector<int>& hole : holes) {
            const int here = clauses.add_variable();
            for (const int other : hole) clauses.add({-here, -other});
            hole.push_back(here);
            somewhere.push_back(here);
        }
        clauses.add(somewhere);
    }
    std::size_t most = 0;
    for (const std::uint64_t steps : {0, 1, 1000, 30'000, 100'000}) {
        std::vector<std::set<SelectorSet>> found;
        for (int run = 0; run < 2; ++run) {
            Solver solver(clauses);
            const RankedSets cheapest = cheapest_corrections(solver, selectors, {1000, steps});
            EXPECT_FALSE(cheapest.is_complete);
            EXPECT_EQ(solver.solve(), Verdict::satisfiable) << "the limit is that of one search";
            Solver another(clauses);
            const ConflictsAndCorrections all = all_conflicts(another, selectors, {1000, steps});
            EXPECT_FALSE(all.conflicts.is_complete);
            for (const RankedSet& each : all.corrections.sets) EXPECT_EQ(each.set.size(), 11U);
            found.push_back(sets_of(cheapest));
            found.push_back(sets_of(all.corrections));
        }
        EXPECT_EQ(found[0], found[2]);
        EXPECT_EQ(found[1], found[3]);
        EXPECT_TRUE(steps > 0 || (found[0].empty() && found[1].empty()));
        most = std::max(most, found[1].size());
    }
    EXPECT_GT(most, 0U);
}

TEST(HittingSets, AreThoseOfEverySubsetTried) {
    for (unsigned seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const std::size_t n = 3 + random() % 6;
        std::vector<double> weights;
        for (std::size_t i = 0; i < n; ++i) weights.push_back(static_cast<double>(random() % 5));
        const auto some_sets = [&](std::size_t most) {
            std::vector<SelectorSet> sets;
            for (std::size_t i = 0; i < random() % (most + 1); ++i)
                sets.push_back(to_set(1 + static_cast<unsigned>(random() % ((1U << n) - 1))));
            return sets;
        };
        const auto sets = some_sets(6), forbidden = some_sets(3);
        std::optional<std::tuple<double, std::size_t, SelectorSet>> best;
        for (unsigned subset = 0; subset < (1U << n); ++subset) {
            const SelectorSet set = to_set(subset);
            const auto meets = [&](const SelectorSet& other) {
                return std::ranges::any_of(other, [&](auto e) { return std::ranges::binary_search(set, e); });
            };
            if (!std::ranges::all_of(sets, meets)) continue;
            if (std::ranges::any_of(forbidden, [&](const auto& other) { return std::ranges::includes(set, other); }))
                continue;
            double weight = 0;
            for (const std::size_t i : set) weight += weights[i];
            const std::tuple candidate(weight, set.size(), set);
            if (!best || candidate < *best) best = candidate;
        }
        const std::optional<SelectorSet> ours = minimum_hitting_set(sets, forbidden, weights);
        ASSERT_EQ(ours.has_value(), best.has_value());
        EXPECT_TRUE(!best || *ours == std::get<2>(*best));
    }
}
