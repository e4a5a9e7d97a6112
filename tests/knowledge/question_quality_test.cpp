/* How many questions the planner asks, and what they cost, against the best there is: a tree found by trying every
   question on every set (dynamic programming), on random small spaces. */

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <map>
#include <random>

#include "knowledge/decision_tree.h"

using namespace partonomy;
using namespace partonomy::knowledge;

namespace {

struct Instance {
    Space space;
    std::vector<double> costs;  ///< by question, in order of variables and values
    std::vector<Question> questions;
    PlanOptions plan;

    [[nodiscard]] double cost(Question question) const {
        return costs[static_cast<std::size_t>(std::ranges::find(questions, question) - questions.begin())];
    }
};

/// Two to four features of two or three values, less what random rules forbid; two to five concepts.
Instance random_instance(std::mt19937& random, bool with_costs) {
    Instance made;
    Space& space = made.space;
    std::vector<std::size_t> values;
    const std::size_t features = 2 + random() % 3;
    for (std::size_t f = 0; f < features; ++f) values.push_back(2 + random() % 2);
    space.product = 1;
    for (const std::size_t n : values) space.product *= n;
    space.size = space.product;
    std::size_t run = space.size;
    for (const std::size_t n : values) {
        run /= n;
        Variable variable{};
        variable.kind = VariableKind::range;
        variable.iri = "urn:v" + std::to_string(space.variables.size());
        variable.values.resize(n);
        space.holds.emplace_back(n, ConfigurationSet(space.size));
        for (std::size_t i = 0; i < space.size; ++i) space.holds.back()[i / run % n].insert(i);
        space.variables.push_back(variable);
    }
    const auto some_value = [&]() -> const ConfigurationSet& {
        const std::size_t v = random() % values.size();
        return space.holds[v][random() % values[v]];
    };
    ConfigurationSet allowed = space.all();
    for (std::size_t rule = random() % 3; rule > 0; --rule) {
        const ConfigurationSet forbidden = some_value() & some_value();
        if (!(allowed - forbidden).is_empty()) allowed -= forbidden;
    }
    for (auto& each : space.holds)
        for (ConfigurationSet& set : each) set = set.packed(allowed);
    space.size = allowed.count();
    space.possible = space.all();
    for (std::size_t c = 2 + random() % 4; c > 0; --c) {
        ConfigurationSet where = some_value();
        for (std::size_t terms = 1 + random() % 2; terms > 0; --terms) {
            const ConfigurationSet& other = some_value();
            where = random() % 2 == 0 ? where & other : where | other;
        }
        made.plan.wanted.push_back(static_cast<ConceptId>(space.concepts.size()));
        space.concepts.push_back({"urn:c" + std::to_string(c), where, false, true});
    }
    for (std::size_t v = 0; v < values.size(); ++v)
        for (std::size_t k = 0; k < values[v]; ++k) {
            made.questions.push_back({static_cast<VariableId>(v), static_cast<ValueId>(k)});
            made.costs.push_back(with_costs ? static_cast<double>(1 + random() % 5) : 1);
        }
    return made;
}

/// The least that can be paid in all, over the configurations of the set.
double optimum(const Instance& in, const ConfigurationSet& set, std::map<ConfigurationSet, double>& known) {
    if (is_decided(in.space, set, in.plan)) return 0;
    if (const auto found = known.find(set); found != known.end()) return found->second;
    double best = std::numeric_limits<double>::infinity();
    for (std::size_t q = 0; q < in.questions.size(); ++q) {
        const ConfigurationSet yes = set & yes_set(in.space, in.questions[q]);
        if (yes.is_empty() || yes == set) continue;
        best = std::min(best, in.costs[q] * static_cast<double>(set.count()) + optimum(in, yes, known) +
                                  optimum(in, set - yes, known));
    }
    return known[set] = best;
}

/// What the planner's tree costs in all.
double paid(const Instance& in, const PlanOptions& options) {
    const DecisionTree tree = build_tree(in.space, options);
    double sum = 0;
    for (const TreeNode& node : tree.nodes)
        EXPECT_EQ(node.question.has_value(), !is_decided(in.space, node.configurations, options));
    for (std::size_t i = 0; i < in.space.size; ++i)
        for (int at = 0; tree.nodes[static_cast<std::size_t>(at)].question;) {
            const TreeNode& node = tree.nodes[static_cast<std::size_t>(at)];
            sum += in.cost(*node.question);
            at = yes_set(in.space, *node.question).has(i) ? node.yes : node.no;
        }
    return sum;
}

struct Quality {
    double ours = 0, greedy = 0, dichotomy = 0, worst = 0;  ///< over the optimum; means, and the worst of ours
    int spaces = 0;
};

Quality measure(unsigned first_seed, SplitCriterion criterion) {
    Quality quality;
    for (unsigned seed = first_seed; quality.spaces < 500; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        Instance in = random_instance(random, criterion == SplitCriterion::gain_per_cost);
        in.plan.cost = [&](Question question) { return in.cost(question); };
        in.plan.criterion = criterion;
        std::map<ConfigurationSet, double> known;
        const double best = optimum(in, in.space.all(), known);
        if (best == 0) continue;
        const double ours = paid(in, in.plan) / best;
        PlanOptions other = in.plan;
        other.breadth = 1;
        quality.greedy += paid(in, other) / best;
        other.criterion = SplitCriterion::dichotomy;
        quality.dichotomy += paid(in, other) / best;
        EXPECT_GE(ours, 1 - 1e-9);
        quality.ours += ours;
        quality.worst = std::max(quality.worst, ours);
        ++quality.spaces;
    }
    for (double* sum : {&quality.ours, &quality.greedy, &quality.dichotomy}) *sum /= quality.spaces;
    return quality;
}

}  // namespace

TEST(QuestionQuality, NumberWithinFivePercentOfTheOptimum) {
    const Quality quality = measure(1000, SplitCriterion::entropy);
    std::cout << "questions over the optimum: " << quality.ours << " (worst " << quality.worst
              << "), without look-ahead " << quality.greedy << ", dichotomy " << quality.dichotomy << "\n";
    EXPECT_LE(quality.ours, 1.05);
    EXPECT_LE(quality.ours, quality.greedy);
    EXPECT_LE(quality.ours, quality.dichotomy);
}

TEST(QuestionQuality, CostWithinFivePercentOfTheOptimum) {
    const Quality quality = measure(5000, SplitCriterion::gain_per_cost);
    std::cout << "cost over the optimum: " << quality.ours << " (worst " << quality.worst << "), without look-ahead "
              << quality.greedy << ", dichotomy " << quality.dichotomy << "\n";
    EXPECT_LE(quality.ours, 1.05);
    EXPECT_LE(quality.ours, quality.greedy);
    EXPECT_LE(quality.ours, quality.dichotomy);
}

TEST(QuestionQuality, NeverWorseThanDichotomyOnFurniture) {
    const Domain domain = compile(owl::load_ontology(PARTONOMY_SOURCE_DIR "/ontologies/furniture.ttl"));
    const auto questions = [&](const Space& space, SplitCriterion criterion) {
        PlanOptions options;
        options.criterion = criterion;
        for (std::size_t c = 0; c < space.concepts.size(); ++c)
            if (!space.concepts[c].iri.starts_with(owl::core_prefix))
                options.wanted.push_back(static_cast<ConceptId>(c));
        const DecisionTree tree = build_tree(space, options);
        std::size_t sum = 0;
        space.possible.for_each([&](std::size_t i) {
            for (int at = 0; tree.nodes[static_cast<std::size_t>(at)].question; ++sum) {
                const TreeNode& node = tree.nodes[static_cast<std::size_t>(at)];
                at = yes_set(space, *node.question).has(i) ? node.yes : node.no;
            }
        });
        return static_cast<double>(sum) / static_cast<double>(space.possible.count());
    };
    for (const Space* space : {&domain.regions, &domain.objects()}) {
        const double dichotomy = questions(*space, SplitCriterion::dichotomy);
        for (const SplitCriterion criterion : {SplitCriterion::entropy, SplitCriterion::gain_per_cost}) {
            const double ours = questions(*space, criterion);
            std::cout << "furniture: " << ours << " questions on average, dichotomy " << dichotomy << "\n";
            EXPECT_LE(ours, dichotomy);
        }
    }
}
