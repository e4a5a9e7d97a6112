/* Clauses and their solver against truth tables. */

#include "knowledge/clauses.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

#include "knowledge/solver.h"

using namespace partonomy::knowledge;

namespace {

bool holds(int literal, unsigned model) { return ((model >> (std::abs(literal) - 1)) & 1U) == (literal > 0 ? 1U : 0U); }

std::vector<int> assumptions_of(unsigned model, int variables) {
    std::vector<int> result;
    for (int v = 1; v <= variables; ++v) result.push_back(holds(v, model) ? v : -v);
    return result;
}

std::vector<int> random_literals(std::mt19937& random, int variables, std::size_t count) {
    std::vector<int> result;
    for (std::size_t i = 0; i < count; ++i) {
        const int variable = 1 + static_cast<int>(random() % static_cast<unsigned>(variables));
        result.push_back(random() % 2 == 0 ? variable : -variable);
    }
    return result;
}

TEST(Clauses, GatesAreTrueExactlyWhenTheirFormulaIs) {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        constexpr int variables = 5;
        Clauses clauses;
        for (int i = 0; i < variables; ++i) (void)clauses.add_variable();
        std::vector<int> literals = random_literals(random, variables, random() % 8);
        const std::size_t drawn = literals.size();
        if (random() % 3 == 0) literals.push_back(clauses.always());
        if (random() % 3 == 0) literals.push_back(clauses.never());
        const auto wanted = static_cast<unsigned>(random() % 7);
        const int all = clauses.all_of(literals);
        const int any = clauses.any_of(literals);
        const int enough = clauses.at_least(literals, wanted);
        const int more = clauses.at_least(literals, wanted + 1);
        Solver solver(clauses);
        for (unsigned model = 0; model < 1U << variables; ++model) {
            unsigned count = 0;
            for (std::size_t i = 0; i < literals.size(); ++i)
                count += i < drawn ? holds(literals[i], model) : literals[i] == clauses.always();
            ASSERT_EQ(solver.solve(assumptions_of(model, variables)), Verdict::satisfiable);
            const auto value = [&](int literal) { return solver.value(std::abs(literal)) == (literal > 0); };
            ASSERT_EQ(value(all), count == literals.size());
            ASSERT_EQ(value(any), count > 0);
            ASSERT_EQ(value(enough), count >= wanted);
            ASSERT_EQ(value(more), count >= wanted + 1);
        }
    }
}

TEST(Clauses, SharesGates) {
    Clauses clauses;
    std::vector<int> literals;
    for (int i = 0; i < 40; ++i) literals.push_back(clauses.add_variable());
    const int some = clauses.at_least(literals, 5);
    const int both = clauses.all_of({literals[0], -literals[1]});
    const std::size_t size = clauses.size();
    EXPECT_EQ(clauses.at_least(literals, 5), some);
    EXPECT_EQ(clauses.all_of({-literals[1], literals[0], literals[0]}), both);
    EXPECT_EQ(clauses.any_of({-literals[0], literals[1]}), -both);
    EXPECT_EQ(clauses.size(), size);
    EXPECT_EQ(clauses.all_of({literals[0], -literals[0]}), clauses.never());
    EXPECT_EQ(clauses.any_of({}), clauses.never());
    EXPECT_EQ(clauses.at_least(literals, 41), clauses.never());  // more than there are
    EXPECT_EQ(clauses.at_least({}, 1), clauses.never());
}

TEST(Clauses, CountingGrowsWithLiteralsTimesCount) {
    for (const unsigned count : {2U, 10U, 40U}) {
        Clauses clauses;
        std::vector<int> literals;
        for (int i = 0; i < 1000; ++i) literals.push_back(clauses.add_variable());
        (void)clauses.at_least(literals, count);
        EXPECT_LT(clauses.size(), 6U * 1000U * count);
        const std::size_t size = clauses.size();
        (void)clauses.at_least(literals, count - 1);
        EXPECT_LT(clauses.size() - size, size) << "the tree is shared";
    }
}

TEST(Solver, CoresAndBackbonesAgreeWithTruthTables) {
    for (unsigned seed = 1; seed <= 200; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        constexpr int variables = 8;
        Clauses clauses;
        for (int i = 0; i < variables; ++i) (void)clauses.add_variable();
        Solver solver(clauses);
        std::vector<std::vector<int>> formula;
        for (int round = 0; round < 6; ++round) {  // the formula grows under the solver
            for (int i = 0; i < 4; ++i) {
                formula.push_back(random_literals(random, variables, 1 + random() % 3 + (random() % 4 != 0)));
                clauses.add(formula.back());
            }
            solver.add_new(clauses);
            const std::vector<int> assumptions = random_literals(random, variables, random() % 4);
            const auto models = [&](const std::vector<int>& facts) {
                std::vector<unsigned> result;
                for (unsigned model = 0; model < 1U << variables; ++model) {
                    bool good = true;
                    for (const int fact : facts) good = good && holds(fact, model);
                    for (const auto& clause : formula) {
                        bool some = false;
                        for (const int literal : clause) some = some || holds(literal, model);
                        good = good && some;
                    }
                    if (good) result.push_back(model);
                }
                return result;
            };
            const std::vector<unsigned> expected = models(assumptions);
            ASSERT_EQ(solver.solve(assumptions) == Verdict::satisfiable, !expected.empty());
            if (expected.empty()) {
                EXPECT_TRUE(models(solver.core()).empty());
                EXPECT_THROW((void)solver.entailed(assumptions, assumptions), std::logic_error);
                continue;
            }
            std::vector<int> candidates, common;
            for (int v = 1; v <= variables; ++v) candidates.insert(candidates.end(), {v, -v});
            for (const int candidate : candidates) {
                bool in_all = true;
                for (const unsigned model : expected) in_all = in_all && holds(candidate, model);
                if (in_all) common.push_back(candidate);
            }
            ASSERT_EQ(solver.entailed(candidates, assumptions), common);
        }
    }
}

}  // namespace
