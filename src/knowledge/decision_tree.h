#pragma once

#include <array>
#include <compare>
#include <cstdint>
#include <deque>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "knowledge/domain.h"
#include "knowledge/plan_rows.h"
#include "knowledge/split_criterion.h"

namespace partonomy::knowledge {

/// "Is this variable's value that one?"; the answer is yes or no. For a `number` variable the question is whether the
/// value lies at or below the upper end of interval `value` (so k intervals make k - 1 questions).
struct Question {
    VariableId variable = -1;
    ValueId value = -1;
    auto operator<=>(const Question&) const = default;
};

/// The configurations in which the answer to the question is yes.
[[nodiscard]] ConfigurationSet yes_set(const Space& space, Question question);

/// What makes the choice.
struct PlanOptions {
    SplitCriterion criterion = SplitCriterion::gain_per_cost;
    /// Cost of asking, > 0; nullopt when no algorithm can answer. Empty function: every non-primitive question costs 1.
    std::function<std::optional<double>(Question)> cost;
    /// A set of configurations is a leaf as soon as every one of these concepts is decided (holds in all of them or in
    /// none); empty: when one configuration is left.
    std::vector<ConceptId> wanted;
    /// How many of the most promising questions are compared by what their whole trees cost, 1: none. Does nothing for
    /// dichotomy, without wanted concepts, and over compiled spaces.
    std::size_t breadth = 4;
};

/// True when nothing wanted is open in `set`.
[[nodiscard]] bool is_decided(const Space& space, const ConfigurationSet& set, const PlanOptions& options);

/// The question to ask when `set` is what is still possible; nullopt at a leaf, or when no askable question splits it.
/// Ties go to the lower variable, then the lower value.
[[nodiscard]] std::optional<Question> best_question(const Space& space, const ConfigurationSet& set,
                                                    const PlanOptions& options);

/// What best_question does, with its set-up shared between calls: a call takes microseconds on spaces of a few hundred
/// configurations. The space must outlive it. It remembers what it has found out, so threads do not share one.
class Planner {
public:
    Planner(const Space& space, PlanOptions options);
    /// One for subsets of `within` only, which may be a small part of the space: then it is as much faster.
    Planner(const Space& space, PlanOptions options, const ConfigurationSet& within);

    /// The same planner where answers cost something else.
    [[nodiscard]] Planner with_cost(std::function<std::optional<double>(Question)> cost) const;

    [[nodiscard]] bool is_decided(const ConfigurationSet& set) const;
    [[nodiscard]] std::optional<Question> best(const ConfigurationSet& set) const;
    /// The best question that splits `set`, decided or not.
    [[nodiscard]] std::optional<Question> best_split(const ConfigurationSet& set) const;
    /// The question that tells most per cost about whether `condition` holds, given `set`; nullopt when none does. The
    /// plan's wanted concepts play no role.
    [[nodiscard]] std::optional<Question> best_about(const ConfigurationSet& set,
                                                     const ConfigurationSet& condition) const;
    /// The cheapest question whose answer is yes in all of `set`.
    [[nodiscard]] std::optional<Question> cheapest_yes(const ConfigurationSet& set) const;

private:
    struct Candidate {
        Question question;
        ConfigurationSet yes;
        bool answerable;
    };
    [[nodiscard]] std::optional<double> cost(const Candidate& candidate) const;
    struct Scored {
        std::size_t candidate;
        double score;
        double share;  ///< of the set that answers yes
    };
    /// The `most` highest scores, the best first; nothing when no question splits the set.
    [[nodiscard]] std::vector<Scored> ranking(const RowCounts& counts, std::size_t most) const;
    /// The `most` questions that split `count` configurations most evenly per cost.
    template <typename Yes>
    [[nodiscard]] std::vector<Scored> most_even(std::size_t count, const Yes& yes_of, std::size_t most) const;
    /// The best of the questions that split `set` in two, without looking ahead.
    [[nodiscard]] std::optional<Question> best_alone(const ConfigurationSet& set) const;
    /// The question among the highest scores whose tree costs least.
    [[nodiscard]] std::optional<Question> look_ahead(const Rows& rows) const;
    /// What asking on costs on average when every question is the one with the highest score; nullopt when that takes
    /// more than `budget` new sets. Of a set that is not decided; puts the rows in another order.
    [[nodiscard]] std::optional<double> price_of(std::span<std::uint32_t> rows, RowSum sum, const RowCounts& counts,
                                                 std::size_t& budget, std::size_t depth) const;
    /// The same after each answer to a question: yes, no.
    [[nodiscard]] std::array<std::optional<double>, 2> prices_after(std::span<std::uint32_t> rows, RowSum sum,
                                                                    const RowCounts& counts, std::size_t candidate,
                                                                    std::size_t& budget, std::size_t depth) const;
    [[nodiscard]] double price(const Candidate& candidate) const;
    /// A set as the planner has it: without the configurations that are not in `within_`.
    [[nodiscard]] ConfigurationSet packed(const ConfigurationSet& set) const;
    [[nodiscard]] bool is_decided(RowSpan rows) const;
    [[nodiscard]] bool looks_ahead() const;
    /// Over a compiled space; literals of what is wanted, none for the most even split.
    [[nodiscard]] std::optional<Question> best_compiled(const ConfigurationSet& set, const std::vector<int>& wanted,
                                                        bool must_tell) const;

    const Space* space_;
    PlanOptions options_;
    std::optional<ConfigurationSet> within_;
    ConfigurationSet possible_;          ///< packed, as all that follows
    std::vector<Candidate> candidates_;  ///< ascending
    std::vector<std::size_t> open_;      ///< of the candidates: those about `open` variables
    /// What PlanOptions::cost said; asked once in each call, since what an algorithm costs may change between calls.
    struct KnownCost {
        std::optional<double> cost;
        std::uint64_t call = 0;
    };
    mutable std::vector<KnownCost> costs_;  ///< by candidate
    mutable std::uint64_t call_ = 0;
    [[nodiscard]] const PlanRows& rows() const;
    mutable std::shared_ptr<const PlanRows> rows_;  ///< made when first needed
    mutable RowTable prices_;
    mutable Rows scratch_;
    mutable std::deque<std::array<RowCounts, 2>> counts_;  ///< of the two halves, for each depth of price_of
};

/// A node of the tree, which is a DAG: equal sets of configurations share one node.
struct TreeNode {
    ConfigurationSet configurations;
    bool is_open = false;   ///< there is more below, which a limit left out
    bool segmented = true;  ///< false: asked of a region not yet cut (only `find all` questions)
    std::optional<Question> question;
    int yes = -1, no = -1;            ///< nodes, -1 at a leaf
    std::vector<ConceptId> asserted;  ///< concepts that hold in every configuration
    std::vector<ConceptId> excluded;  ///< concepts that hold in none
};

struct DecisionTree {
    const Space* space = nullptr;  ///< not owned
    std::vector<TreeNode> nodes;   ///< node 0 is the root
    [[nodiscard]] std::size_t depth() const;
    [[nodiscard]] bool is_whole() const;  ///< no node is open
};

/// How much of a tree to build.
struct TreeLimits {
    std::size_t nodes = 1'000'000;
    std::size_t depth = std::numeric_limits<std::size_t>::max();  ///< questions on the way from the root
    bool leave_open = false;  ///< nodes beyond the limits are left open; otherwise too many nodes are an error
};

/// Builds the whole tree over the possible configurations of `space` (paper §3.3.1, Fig. 7 and 8).
/// With `find_all` set (cost of each `find all` question, nullopt where there is none), the root stands for the whole
/// mesh: questions that cut come first; "yes" leads to a cut region, "no" to what remains uncut. What remains when
/// every other value is excluded still has to be cut: that question has no "no" (its index stays -1). Throws
/// OntologyError when it would have more nodes than `limits` allows, unless the rest may be left open.
[[nodiscard]] DecisionTree build_tree(const Space& space, const PlanOptions& is_a,
                                      const std::function<std::optional<double>(Question)>& find_all = {},
                                      const TreeLimits& limits = {});

/// The tree as JSON (schema in docs/decision-tree.md), as Graphviz DOT, as a picture (SVG), and as a page of its own on
/// which it unfolds (HTML).
[[nodiscard]] std::string to_json(const DecisionTree& tree, const Domain& domain);
[[nodiscard]] std::string to_dot(const DecisionTree& tree, const Domain& domain);
[[nodiscard]] std::string to_svg(const DecisionTree& tree, const Domain& domain);
[[nodiscard]] std::string to_html(const DecisionTree& tree, const Domain& domain);

/// "is it a Board", "height <= 0.55"; the expert's wording (core:question) where there is one.
[[nodiscard]] std::string to_text(const Space& space, Question question, const Domain& domain);

/// Whom a question about a relation looks for on the other side, "a Seat"; empty where it takes more than a few words.
[[nodiscard]] std::string other_side_in_words(const Variable& variable, const Domain& domain);

}  // namespace partonomy::knowledge
