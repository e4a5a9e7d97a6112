#pragma once

#include "knowledge/decision_tree.h"

// Inside of the tree's exports: what a node says, in words.

namespace partonomy::knowledge {

/// What is known at a node, as in paper Fig. 8; values as (variable, value).
struct NodeFeatures {
    std::vector<Question> told, inferred, ruled_out;
};
[[nodiscard]] std::vector<NodeFeatures> follow(const DecisionTree& tree);

[[nodiscard]] std::string variable_name(const Variable& variable);
[[nodiscard]] std::string value_words(const Space& space, Question value);
[[nodiscard]] std::string question_words(const Space& space, const TreeNode& node, const Domain& domain);
/// The question, or what a leaf is.
[[nodiscard]] std::string node_title(const DecisionTree& tree, std::size_t node, const Domain& domain);
/// For XML and HTML.
[[nodiscard]] std::string escaped(const std::string& text);

template <typename Range, typename Words>
std::string join(const Range& range, const Words& words) {
    std::string list;
    for (const auto& each : range) list += (list.empty() ? "" : ", ") + words(each);
    return list;
}

}  // namespace partonomy::knowledge
