#include "knowledge/diagram_questions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "knowledge/choices.h"

// What a question tells, against the definition: entropies over every model, each with its weight.

using namespace partonomy::knowledge;

namespace {

struct Game {
    Clauses clauses;
    std::vector<LiteralQuestion> questions;
    ChoiceOptions options;
    std::vector<LiteralWeight> weights;
};

Game random_game(std::mt19937& random) {
    Game game;
    std::vector<int> literals;
    for (int i = 0; i < 4; ++i)
        for (const int literal : add_choice(game.clauses, 2 + random() % 2)) literals.push_back(literal);
    for (const int literal : literals) game.questions.push_back({literal, 1 + static_cast<double>(random() % 3)});
    const auto pick = [&] {
        const int literal = literals[random() % literals.size()];
        return random() % 2 == 0 ? literal : -literal;
    };
    for (std::size_t i = 0; i < 1 + random() % 3; ++i)
        game.options.wanted.push_back(random() % 2 == 0 ? game.clauses.all_of({pick(), pick()})
                                                        : game.clauses.any_of({pick(), pick(), pick()}));
    for (std::size_t i = 0; i < random() % 4; ++i) game.clauses.add({pick(), pick(), pick()});
    for (std::size_t i = 0; i < random() % 3; ++i)
        for (const LiteralWeight& each : likelihood(pick(), static_cast<double>(random() % 5) / 4))
            game.weights.push_back(each);
    constexpr SplitCriterion criteria[]{SplitCriterion::dichotomy, SplitCriterion::entropy,
                                        SplitCriterion::gain_per_cost};
    game.options.criterion = criteria[random() % 3];
    return game;
}

double entropy_of(const std::map<std::vector<bool>, double>& weights, double total) {
    double sum = 0;
    for (const auto& [label, weight] : weights)
        if (weight > 0) sum -= weight / total * std::log2(weight / total);
    return sum;
}

/// The score that a question deserves by the definitions.
double score_of(const Game& game, const std::vector<std::vector<int>>& models, const LiteralQuestion& question,
                bool even_only) {
    const auto is_true = [](const std::vector<int>& model, int literal) {
        return std::ranges::binary_search(model, std::abs(literal)) == (literal > 0);
    };
    std::map<std::vector<bool>, double> side[2], both;
    double total[2] = {0, 0};
    for (const std::vector<int>& model : models) {
        double weight = 1;
        for (const LiteralWeight& each : game.weights)
            if (is_true(model, each.literal)) weight *= each.weight;
        std::vector<bool> label;
        for (const int literal : game.options.wanted) label.push_back(is_true(model, literal));
        const bool yes = is_true(model, question.literal);
        side[yes][label] += weight;
        both[label] += weight;
        total[yes] += weight;
    }
    const double all = total[0] + total[1];
    const double price = game.options.criterion == SplitCriterion::gain_per_cost ? question.cost : 1;
    if (game.options.criterion == SplitCriterion::dichotomy || even_only)
        return std::min(total[0], total[1]) / all / price;
    double gain = entropy_of(both, all);
    for (const int yes : {0, 1})
        if (total[yes] > 0) gain -= total[yes] / all * entropy_of(side[yes], total[yes]);
    return gain > 1e-9 ? gain / price : 0;
}

}  // namespace

TEST(DiagramQuestions, AreTheBestByTheDefinition) {
    int asked = 0;
    for (unsigned seed = 0; seed < 500; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const Game game = random_game(random);
        const Diagram diagram(game.clauses);
        const auto best = best_question(diagram, game.questions, game.options, {}, game.weights);
        const Shares shares = diagram.shares({}, game.weights);
        if (are_known(shares, game.options)) {
            EXPECT_FALSE(best);
            continue;
        }
        const auto models = diagram.models(100'000);
        bool even_only = true;
        for (const LiteralQuestion& question : game.questions)
            even_only &= score_of(game, models, question, false) == 0;
        double highest = 0;
        for (const LiteralQuestion& question : game.questions)
            highest = std::max(highest, score_of(game, models, question, even_only));
        ASSERT_EQ(best.has_value(), highest > 0);
        if (!best) continue;
        ++asked;
        EXPECT_NEAR(score_of(game, models, game.questions[*best], even_only), highest, 1e-7);
    }
    EXPECT_GT(asked, 200);
}

TEST(DiagramQuestions, LabelsOneByOneWhereTheyAreMany) {
    Clauses clauses;
    std::vector<LiteralQuestion> questions;
    ChoiceOptions options;
    for (int i = 0; i < 30; ++i) {
        const int a = add_choice(clauses, 2)[0], b = add_choice(clauses, 2)[0];
        options.wanted.push_back(clauses.all_of({a, b}));
        questions.push_back({a});
        if (i == 17) options.wanted.push_back(clauses.all_of({-a, b}));  // this one decides more
    }
    options.work_limit = 0;
    EXPECT_EQ(best_question(Diagram(clauses), questions, options), 17U);
}

TEST(DiagramQuestions, UncertainAnswersAddUpUntilTheLabelIsSure) {
    Clauses clauses;
    const std::vector<int> shape = add_choice(clauses, 3);
    const Diagram diagram(clauses);
    std::vector<LiteralWeight> weights;
    ChoiceOptions options;
    options.wanted = {shape[0]};
    options.certainty = 0.95;
    int answers = 0;
    while (best_question(diagram, std::vector<LiteralQuestion>{{shape[0]}}, options, {}, weights)) {
        for (const LiteralWeight& each : likelihood(shape[0], 0.8)) weights.push_back(each);
        ASSERT_LT(++answers, 10);
    }
    EXPECT_EQ(answers, 3);  // the odds start at 1 : 2 and are multiplied by 4: 0.67, 0.89, 0.97
    EXPECT_NEAR(diagram.shares({}, weights).of(shape[0]), 32.0 / 33, 1e-12);
    EXPECT_TRUE(diagram.shares({}, weights).is_possible(shape[1]));
}
