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

struct Key {
    ConfigurationSet set;
    bool segmented;
    bool operator==(const Key&) const = default;
};

struct KeyHash {
    std::size_t operator()(const Key& key) const { return key.set.hash() * 2 + (key.segmented ? 1 : 0); }
};

class TreeBuilder {
public:
    TreeBuilder(const Space& space, const PlanOptions& is_a,
                const std::function<std::optional<double>(Question)>& find_all, const TreeLimits& limits)
        : space_(space), asker_(space, is_a), cutter_(space, {is_a.criterion, find_all, is_a.wanted}), limits_(limits) {
        tree_.space = &space;
        node(space.possible, !find_all);
    }

    DecisionTree run() {
        for (std::size_t i = 0; i < tree_.nodes.size(); ++i) {
            const ConfigurationSet set = tree_.nodes[i].configurations;  // a copy: `node` moves the nodes
            const bool segmented = tree_.nodes[i].segmented;
            if (set.is_empty()) continue;
            std::optional<Question> question = segmented ? asker_.best(set) : cutter_.best_split(set);
            const bool last = !question && !segmented;
            if (last) question = cutter_.cheapest_yes(set);
            if (!question) continue;
            tree_.nodes[i].question = question;
            if (limits_.leave_open && (depths_[i] >= limits_.depth || tree_.nodes.size() + 2 > limits_.nodes)) {
                tree_.nodes[i].is_open = true;
                continue;
            }
            depth_ = depths_[i] + 1;
            const ConfigurationSet yes = yes_set(space_, *question);
            const int yes_node = node(set & yes, true), no_node = last ? -1 : node(set - yes, segmented);
            tree_.nodes[i].yes = yes_node;
            tree_.nodes[i].no = no_node;
        }
        return std::move(tree_);
    }

private:
    int node(ConfigurationSet set, bool segmented) {
        const auto [place, added] =
            known_.emplace(Key{std::move(set), segmented}, static_cast<int>(tree_.nodes.size()));
        if (!added) return place->second;
        if (tree_.nodes.size() >= limits_.nodes)
            throw OntologyError("the decision tree has more than " + std::to_string(limits_.nodes) +
                                " nodes; say which concepts are wanted, or mention fewer features");
        TreeNode fresh;
        fresh.configurations = place->first.set;
        fresh.segmented = segmented;
        for (std::size_t c = 0; c < space_.concepts.size(); ++c) {
            if (!fresh.configurations.intersects(space_.concepts[c].where))
                fresh.excluded.push_back(static_cast<ConceptId>(c));
            else if (fresh.configurations.is_subset_of(space_.concepts[c].where))
                fresh.asserted.push_back(static_cast<ConceptId>(c));
        }
        tree_.nodes.push_back(std::move(fresh));
        depths_.push_back(depth_);
        return place->second;
    }

    const Space& space_;
    Planner asker_, cutter_;
    TreeLimits limits_;
    std::vector<std::size_t> depths_;  // of the first way to each node
    std::size_t depth_ = 0;            // of nodes being made
    DecisionTree tree_;
    std::unordered_map<Key, int, KeyHash> known_;  // only looked up, never walked
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
