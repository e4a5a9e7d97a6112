#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "knowledge/domain.h"

namespace partonomy::knowledge {

/// Regions that may be in a relation: one node of the N-ary Relation pattern, when they are.
struct RelationTuple {
    std::size_t relation = 0;  ///< into Domain::relations
    std::vector<int> regions;  ///< the target first, then the references, ascending
    auto operator<=>(const RelationTuple&) const = default;
};

enum class Truth { no, open, yes };

/// Whether some node of this relation may pass the test, whatever its regions are.
[[nodiscard]] bool may_pass(const NodeTest& test, const std::vector<Relation>& relations, std::size_t relation);

/// Whether the node passes the test, when each region is known to lie in its set.
[[nodiscard]] Truth passes(const RelationalFeature& feature, const RelationTuple& node,
                           const std::vector<ConfigurationSet>& regions);

/// An answer to "has region `region` the feature", and how sure it is: the score of the node that proves it, or of the
/// least sure one that was excluded.
struct RelationAnswer {
    Truth truth = Truth::open;
    double score = 1;
};

/// Nodes that the region may be in, in its role, and that may pass the test; those that surely pass come first.
[[nodiscard]] std::vector<std::pair<Truth, RelationTuple>> nodes_in_question(
    const Domain& domain, const RelationalFeature& feature, int region, const std::vector<ConfigurationSet>& regions);

/// Looks for nodes among the regions that are there. `score` is T: the score of "these regions are in the relation" (>=
/// 0.5: there is such a node), nullopt when nothing can tell; it is asked as little as possible, nodes that surely pass
/// the test first. Unless `complete`, other regions may turn up, and no answer is no. Open when it hangs on what
/// another region is.
[[nodiscard]] RelationAnswer answer_relation(const Domain& domain, const RelationalFeature& feature, int region,
                                             const std::vector<ConfigurationSet>& regions, bool complete,
                                             const std::function<std::optional<double>(const RelationTuple&)>& score);

}  // namespace partonomy::knowledge
