#include "knowledge/diagram.h"

#include <bdd.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>
#include <set>

#include "base/errors.h"
#include "knowledge/choices.h"

// Counts and shares against two other roads: every assignment tried one by one, and BuDDy.

using namespace partonomy;
using namespace partonomy::knowledge;

namespace {

bool holds(const Clauses& clauses, std::uint32_t model) {
    for (std::size_t c = 0; c < clauses.size(); ++c) {
        bool satisfied = false;
        for (const int literal : clauses[c])
            satisfied |= ((model >> std::abs(literal)) & 1U) == (literal > 0 ? 1U : 0U);
        if (!satisfied) return false;
    }
    return true;
}

bool is_true(std::uint32_t model, int literal) {
    return ((model >> std::abs(literal)) & 1U) == (literal > 0 ? 1U : 0U);
}

std::vector<std::uint32_t> all_models(const Clauses& clauses) {
    std::vector<std::uint32_t> models;
    for (std::uint32_t model = 0; model < (2U << clauses.variable_count()); model += 2)
        if (holds(clauses, model)) models.push_back(model);
    return models;
}

/// Choices of two or three values, gates over them, and clauses over both; at most 16 variables.
Clauses random_theory(std::mt19937& random) {
    Clauses clauses;
    std::vector<int> literals;
    for (int i = 0; i < 4; ++i)
        for (const int literal : add_choice(clauses, 2 + random() % 2)) literals.push_back(literal);
    const auto pick = [&] {
        const int literal = literals[random() % literals.size()];
        return random() % 2 == 0 ? literal : -literal;
    };
    const std::size_t gates = random() % 4;
    for (std::size_t i = 0; i < gates; ++i)
        literals.push_back(random() % 2 == 0 ? clauses.all_of({pick(), pick()})
                                             : clauses.any_of({pick(), pick(), pick()}));
    const std::size_t rules = random() % 7;
    for (std::size_t i = 0; i < rules; ++i) clauses.add({pick(), pick(), pick()});
    return clauses;
}

/// Rules of `width` literals over neighbouring variables; those that one hidden assignment meets, so that models exist.
Clauses local_theory(std::mt19937& random, int variables, int rules, int width, int window) {
    Clauses clauses;
    std::vector<char> hidden(static_cast<std::size_t>(variables) + 1);
    for (int v = 1; v <= variables; ++v) hidden[static_cast<std::size_t>(clauses.add_variable())] = random() % 2;
    while (static_cast<int>(clauses.size()) < rules) {
        const int start = 1 + static_cast<int>(random() % static_cast<unsigned>(variables - window + 1));
        std::set<int> chosen;
        while (static_cast<int>(chosen.size()) < width)
            chosen.insert(start + static_cast<int>(random() % static_cast<unsigned>(window)));
        std::vector<int> clause;
        bool met = false;
        for (const int v : chosen) {
            clause.push_back(random() % 2 == 0 ? v : -v);
            met |= (clause.back() > 0) == (hidden[static_cast<std::size_t>(v)] != 0);
        }
        if (met) clauses.add(clause);
    }
    return clauses;
}

}  // namespace

TEST(Diagram, CountsAndModelsAreThoseOfEveryAssignmentTried) {
    for (unsigned seed = 0; seed < 400; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const Clauses clauses = random_theory(random);
        const Diagram diagram(clauses);
        std::vector<int> evidence;
        for (int i = 0; i < static_cast<int>(random() % 3); ++i) {
            const int v = 1 + static_cast<int>(random() % static_cast<unsigned>(clauses.variable_count()));
            evidence.push_back(random() % 2 == 0 ? v : -v);
        }
        std::vector<std::uint32_t> models = all_models(clauses);
        std::erase_if(models, [&](std::uint32_t model) {
            return !std::ranges::all_of(evidence, [&](int literal) { return is_true(model, literal); });
        });
        EXPECT_EQ(diagram.count(evidence).digits, std::to_string(models.size()));
        const LiteralCounts counts = diagram.count_each(evidence);
        const Shares shares = diagram.shares(evidence);
        for (int v = 1; v <= clauses.variable_count(); ++v)
            for (const int literal : {v, -v}) {
                const auto expected =
                    std::ranges::count_if(models, [&](auto model) { return is_true(model, literal); });
                EXPECT_EQ(counts.of(literal).digits, std::to_string(expected));
                EXPECT_EQ(shares.is_possible(literal), expected > 0);
                const auto all = static_cast<double>(models.size());
                EXPECT_NEAR(shares.of(literal), models.empty() ? 0 : static_cast<double>(expected) / all, 1e-12);
            }
        std::set<std::uint32_t> ours;
        for (const std::vector<int>& model : diagram.models(100'000, evidence)) {
            std::uint32_t bits = 0;
            for (const int v : model) bits |= 1U << v;
            ours.insert(bits);
        }
        EXPECT_EQ(ours, std::set<std::uint32_t>(models.begin(), models.end()));
        EXPECT_EQ(diagram.models(3, evidence).size(), std::min<std::size_t>(3, models.size()));
    }
}

TEST(Diagram, WhatIsRememberedIsWhatASweepFinds) {
    const unsigned seed = std::random_device()();
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    const Clauses clauses = local_theory(random, 400, 240, 3, 8);  // 6,000 evidences do not all fit into memory
    const Diagram diagram(clauses);
    const LiteralWeight neutral{1, 1};  // takes the road of scaled numbers
    for (int i = 0; i < 6000; ++i) {
        const int a = 1 + static_cast<int>(random() % 200), b = 201 + static_cast<int>(random() % 200);
        const std::vector<int> evidence = random() % 4 == 0 ? std::vector<int>{-b, a} : std::vector<int>{a, b};
        const auto remembered = diagram.remembered_shares(evidence);
        if (i % 100 != 0) continue;
        const Shares swept = diagram.shares(evidence, std::span(&neutral, 1));
        ASSERT_NEAR(remembered->log2_total, swept.log2_total, 1e-9);
        ASSERT_EQ(remembered, diagram.remembered_shares(evidence));
        for (int v = 1; v <= diagram.variable_count(); ++v)
            for (const int literal : {v, -v}) {
                ASSERT_NEAR(remembered->of(literal), swept.of(literal), 1e-12);
                ASSERT_EQ(remembered->is_possible(literal), swept.is_possible(literal));
            }
    }
}

TEST(Diagram, WeightsAreLikelihoods) {
    for (unsigned seed = 0; seed < 200; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const Clauses clauses = random_theory(random);
        std::vector<LiteralWeight> weights;
        std::vector<double> of(2 * static_cast<std::size_t>(clauses.variable_count()) + 2, 1);
        for (int v = 1; v <= clauses.variable_count(); v += 2) {
            weights.push_back({v, static_cast<double>(random() % 5) / 4});
            of[static_cast<std::size_t>(v)] = weights.back().weight;
        }
        double total = 0;
        std::vector<double> parts(of.size(), 0);
        for (const std::uint32_t model : all_models(clauses)) {
            double weight = 1;
            for (int v = 1; v <= clauses.variable_count(); ++v)
                if (is_true(model, v)) weight *= of[static_cast<std::size_t>(v)];
            total += weight;
            for (int v = 1; v <= clauses.variable_count(); ++v)
                if (is_true(model, v)) parts[static_cast<std::size_t>(v)] += weight;
        }
        const Shares shares = Diagram(clauses).shares({}, weights);
        EXPECT_NEAR(std::exp2(shares.log2_total), total, 1e-9 * total);
        for (int v = 1; v <= clauses.variable_count() && total > 0; ++v)
            EXPECT_NEAR(shares.of(v), parts[static_cast<std::size_t>(v)] / total, 1e-9);
    }
}

TEST(Diagram, AgreesWithBuddy) {
    for (unsigned seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const int n = 20 + static_cast<int>(random() % 21);
        const Clauses clauses = local_theory(random, n, 3 * n, 3, 8);
        bdd_init(200'000, 20'000);
        bdd_setvarnum(n + 1);
        bdd all = bddtrue;
        for (std::size_t c = 0; c < clauses.size(); ++c) {
            bdd clause = bddfalse;
            for (const int literal : clauses[c]) clause |= literal > 0 ? bdd_ithvar(literal) : bdd_nithvar(-literal);
            all &= clause;
        }
        const auto count = [](const bdd& set) { return std::to_string(static_cast<long>(bdd_satcount(set) / 2)); };
        const LiteralCounts counts = Diagram(clauses).count_each();
        EXPECT_EQ(counts.total.digits, count(all));
        for (int v = 1; v <= n; ++v) {
            EXPECT_EQ(counts.of(v).digits, count(all & bdd_ithvar(v)));
            EXPECT_EQ(counts.of(-v).digits, count(all & bdd_nithvar(v)));
        }
        all = bddfalse;
        bdd_done();
    }
}

TEST(Diagram, CountsBeyondEveryMachineWord) {
    Clauses clauses;
    std::vector<int> first;
    for (int i = 0; i < 1500; ++i) {
        const std::vector<int> value = add_choice(clauses, 3);
        first.push_back(value[0]);
    }
    clauses.add({first[0], first[1]});
    const Diagram diagram(clauses);
    // 3^1500 - 4 x 3^1498 = 5 x 3^1498
    EXPECT_NEAR(diagram.count().log2, std::log2(5.0) + 1498 * std::log2(3.0), 1e-6);
    EXPECT_EQ(diagram.count().digits.size(), 716U);
    EXPECT_NEAR(diagram.shares().of(first[0]), 3.0 / 5, 1e-12);
    EXPECT_NEAR(diagram.shares().of(first[700]), 1.0 / 3, 1e-12);
    EXPECT_LT(diagram.node_count(), 10'000U);
}

TEST(Diagram, DefinedConceptsDoNotMultiplyCounts) {
    Clauses clauses;
    std::vector<int> values;
    for (int i = 0; i < 10; ++i) values.push_back(add_choice(clauses, 2)[0]);
    const int any = clauses.any_of(values), most = clauses.at_least(values, 6);
    const LiteralCounts counts = Diagram(clauses).count_each();
    EXPECT_EQ(counts.total.digits, "1024");
    EXPECT_EQ(counts.of(any).digits, "1023");
    EXPECT_EQ(counts.of(most).digits, "386");  // 210 + 120 + 45 + 10 + 1
}

TEST(Diagram, Contradictions) {
    Clauses clauses;
    const int a = clauses.add_variable();
    EXPECT_EQ(Diagram(clauses).count(std::vector{a, -a}).digits, "0");
    clauses.add({a});
    EXPECT_EQ(Diagram(clauses).count(std::vector{-a}).digits, "0");
    clauses.add({-a});
    EXPECT_TRUE(Diagram(clauses).is_empty());
    EXPECT_EQ(Diagram(clauses).count_each().of(a).digits, "0");
    EXPECT_FALSE(Diagram(clauses).shares().is_possible(a));
    EXPECT_TRUE(Diagram(clauses).models(5).empty());
    Clauses empty;
    EXPECT_EQ(Diagram(empty).count().digits, "1");
    empty.add(std::vector<int>{});
    EXPECT_TRUE(Diagram(empty).is_empty());
}

TEST(Diagram, LimitsAreSentences) {
    std::mt19937 random(1);
    const Clauses clauses = local_theory(random, 120, 200, 3, 120);
    try {
        const Diagram diagram(clauses, {100, std::size_t{1} << 30, 60});
        FAIL() << "no limit reached";
    } catch (const OntologyError& error) {
        EXPECT_TRUE(std::string(error.what())
                        .starts_with("the decision diagram of its configurations has more than 100 nodes; raise that "
                                     "limit, or let rules tie fewer concepts together (up to "))
            << error.what();
    }
    EXPECT_THROW(Diagram(clauses, {10'000'000, std::size_t{1} << 17, 60}), OntologyError);
    EXPECT_THROW(Diagram(clauses, {10'000'000, std::size_t{1} << 34, 0.01}), OntologyError);
    EXPECT_THROW(Diagram(clauses, {10'000'000, std::size_t{1} << 34, 60, 0.01}), OntologyError);
}

TEST(Diagram, WhatIsHopelessIsGivenUpSoon) {
    std::mt19937 random(3);
    const Clauses clauses = local_theory(random, 1000, 600, 3, 1000);  // rules over any three of 1,000 concepts
    const auto start = std::chrono::steady_clock::now();
    EXPECT_THROW(Diagram(clauses, {100'000'000, std::size_t{1} << 40, 2}), OntologyError);
    EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(1)) << "a twentieth of two million steps";
}

TEST(Diagram, AThousandConceptsWithRulesOverAnyTwo) {
    std::mt19937 random(5);
    const Clauses clauses = local_theory(random, 1000, 600, 2, 1000);
    const Diagram diagram(clauses);
    const LiteralCounts counts = diagram.count_each();
    for (int v = 1; v <= 1000; v += 37) {  // a second opinion on some of them
        EXPECT_EQ(counts.of(v).digits, diagram.count(std::vector{v}).digits);
        EXPECT_EQ(counts.of(-v).digits, diagram.count(std::vector{-v}).digits);
    }
}

TEST(Diagram, AThousandConceptsInOneSweep) {
    std::mt19937 random(7);
    const Clauses clauses = local_theory(random, 1000, 600, 3, 12);
    const Diagram diagram(clauses);
    const LiteralCounts counts = diagram.count_each();
    const Shares shares = diagram.shares();
    EXPECT_GT(counts.total.log2, 800);
    for (int v = 1; v <= 1000; ++v)
        EXPECT_NEAR(std::exp2(counts.of(v).log2 - counts.total.log2), shares.of(v), 1e-9) << "variable " << v;
}
