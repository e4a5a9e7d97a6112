#include "knowledge/decision_tree.h"

#include <algorithm>
#include <unordered_map>

#include "base/errors.h"

// The tree is grown breadth first from the set of all possible configurations; a set met before is not grown again,
// which turns the tree into a DAG. Nodes that stand for something not yet cut (find_all) only ask what cuts: "yes"
// takes the cut regions along the rest of the tree, "no" leaves the remainder uncut. When all but one value are
// excluded, the answer of the last `find all` is known beforehand, yet somebody has to cut: the supplementary
// algorithms of paper §3.3.2. Cost: one best question per node, and a hash of its set.

namespace partonomy::knowledge {
namespace {

class TreeBuilder {
public:
    TreeBuilder(const Space& space, const PlanOptions& is_a,
                const std::function<std::optional<double>(Question)>& find_all, const TreeLimits& limits)
        : space_(space), asker_(space, is_a), limits_(limits) {
        if (find_all) cutter_ = asker_.with_cost(find_all);
        tree_.space = &space;
        node(space.possible, !find_all, nullptr);
    }

    DecisionTree run() {
        for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
            TreeNode& here = tree_.nodes[i];  // until `node` moves the nodes
            const ConfigurationSet& set = here.configurations;
            const bool segmented = here.segmented;
            if (set.is_empty()) continue;
            here.question = segmented ? asker_.best(set) : cutter_->best_split(set);
            const bool last = !here.question && !segmented;
            if (last) here.question = cutter_->cheapest_yes(set);
            if (!here.question) continue;
            if (limits_.leave_open && (depths_[i] >= limits_.depth || tree_.nodes.size() + 2 > limits_.nodes)) {
                here.is_open = true;
                continue;
            }
            depth_ = depths_[i] + 1;
            const ConfigurationSet yes = yes_set(space_, *here.question);
            ConfigurationSet inside = set & yes, outside = last ? ConfigurationSet() : set - yes;
            const int yes_node = node(std::move(inside), true, &i);
            const int no_node = last ? -1 : node(std::move(outside), segmented, &i);
            tree_.nodes[i].yes = yes_node;
            tree_.nodes[i].no = no_node;
        }
        return std::move(tree_);
    }

private:
    /// The node of a set; what holds or is excluded in its parent is so in it.
    int node(ConfigurationSet set, bool segmented, const std::size_t* parent) {
        std::vector<int>& known = known_[set.hash() * 2 + (segmented ? 1 : 0)];
        for (const int id : known)
            if (const TreeNode& other = tree_.nodes[static_cast<std::size_t>(id)];
                other.segmented == segmented && other.configurations == set)
                return id;
        const int id = static_cast<int>(tree_.nodes.size());
        known.push_back(id);
        if (tree_.nodes.size() >= limits_.nodes)
            throw OntologyError("the decision tree has more than " + std::to_string(limits_.nodes) +
                                " nodes; say which concepts are wanted, or mention fewer features");
        TreeNode fresh;
        fresh.configurations = std::move(set);
        fresh.segmented = segmented;
        const auto has = [&](std::vector<ConceptId> TreeNode::*concepts, ConceptId c) {
            return parent && std::ranges::binary_search(tree_.nodes[*parent].*concepts, c);
        };
        const bool is_empty = fresh.configurations.is_empty();
        for (ConceptId c = 0; c < static_cast<ConceptId>(space_.concepts.size()); ++c) {
            const ConfigurationSet& where = space_.concepts[static_cast<std::size_t>(c)].where;
            if (is_empty || has(&TreeNode::excluded, c) || !fresh.configurations.intersects(where))
                fresh.excluded.push_back(c);
            else if (has(&TreeNode::asserted, c) || fresh.configurations.is_subset_of(where))
                fresh.asserted.push_back(c);
        }
        tree_.nodes.push_back(std::move(fresh));
        depths_.push_back(depth_);
        return id;
    }

    const Space& space_;
    Planner asker_;
    std::optional<Planner> cutter_;  // where the root stands for the whole mesh
    TreeLimits limits_;
    std::vector<std::size_t> depths_;  // of the first way to each node
    std::size_t depth_ = 0;            // of nodes being made
    DecisionTree tree_;
    std::unordered_map<std::size_t, std::vector<int>> known_;  // nodes by hash; only looked up, never walked
};

}  // namespace

std::size_t DecisionTree::depth() const {
    std::vector<std::size_t> depths(nodes.size(), 0);
    std::vector<char> done(nodes.size(), 0);
    const auto visit = [&](const auto& self, int i) -> std::size_t {
        if (i < 0 || done[i]) return i < 0 ? 0 : depths[i];
        done[i] = 1;
        if (nodes[i].yes >= 0) depths[i] = 1 + std::max(self(self, nodes[i].yes), self(self, nodes[i].no));
        return depths[i];
    };
    return nodes.empty() ? 0 : visit(visit, 0);
}

bool DecisionTree::is_whole() const {
    return std::ranges::none_of(nodes, [](const TreeNode& node) { return node.is_open; });
}

DecisionTree build_tree(const Space& space, const PlanOptions& is_a,
                        const std::function<std::optional<double>(Question)>& find_all, const TreeLimits& limits) {
    return TreeBuilder(space, is_a, find_all, limits).run();
}

}  // namespace partonomy::knowledge
