#pragma once

#include <array>
#include <optional>
#include <span>

#include "knowledge/diagram.h"
#include "knowledge/split_criterion.h"

namespace partonomy::knowledge {

/// "Is this literal true?"
struct LiteralQuestion {
    int literal;
    double cost = 1;  ///< > 0
};

struct ChoiceOptions {
    SplitCriterion criterion = SplitCriterion::gain_per_cost;
    std::vector<int> wanted;  ///< the labels: what the questions are asked for
    /// A label is known when its share is at least this, or at most 1 minus this. 1: when it is inferred.
    double certainty = 1;
    bool must_tell = false;  ///< no question rather than one that tells nothing about the labels
    /// Literals that may be looked at to tell the combinations of labels apart. When there are more combinations, each
    /// label's entropy is counted for itself.
    std::size_t work_limit = 4'000'000;
};

/// True when every label is known (see ChoiceOptions::certainty); shares without any model know everything.
[[nodiscard]] bool are_known(const Shares& shares, const ChoiceOptions& options);

/// Which of `questions` to ask next, given evidence and likelihoods; nullopt when all labels are known, or no question
/// is open. Ties go to the earlier question. Where no single question tells anything about the labels, the most even
/// split per cost.
[[nodiscard]] std::optional<std::size_t> best_question(const Diagram& diagram,
                                                       std::span<const LiteralQuestion> questions,
                                                       const ChoiceOptions& options, std::span<const int> evidence = {},
                                                       std::span<const LiteralWeight> weights = {});

/// An answer as a likelihood: "literal is true" with a fuzzy score in [0, 1]. Several answers about one literal
/// multiply.
[[nodiscard]] std::array<LiteralWeight, 2> likelihood(int literal, double score);

}  // namespace partonomy::knowledge
