/* In which order to decide.

   A small set of variables that cuts the formula into independent pieces should be decided first, then the same within
   each piece: then pieces repeat and are found in the cache. Such sets come from a tree decomposition of the graph
   whose edges join variables of one clause. Eliminating its vertices one after the other (each elimination joins all
   neighbours of the vertex) gives a decomposition with a bag for each vertex: the vertex and its neighbours then. The
   greedy choice of the vertex that adds the fewest edges (min-fill) or has the fewest neighbours (min-degree) gives
   good ones; we make both, and take the one whose bags have the lower sum of 2^size, an estimate of the diagram's size.
   Its tree is hung up at the bag in its middle, and a variable's rank is the depth of the highest bag that has it; as
   Korhonen and Järvisalo, "Integrating tree decompositions into decision heuristics of propositional model counters"
   (2021), but with the depth alone. Clauses of many literals join neighbouring literals only: deciding them one by one
   needs no more states than literals. Where the estimate is bad, min-fill tries a few more times and breaks its ties in
   other ways; on random rules the best of eight is two to four times smaller than the first.

   Cost: (variables) x (width)^2 adjacency look-ups; 1,000 variables take some milliseconds. */

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <random>
#include <set>
#include <tuple>

#include "knowledge/diagram_nodes.h"

namespace partonomy::knowledge {
namespace {

constexpr std::size_t long_clause = 12;
constexpr int fill_limit = 48;  // neighbours; beyond, counting the missing edges costs more than it helps
constexpr double good_cost = 1 << 16, hopeless_cost = 0x1p60;  // between them, more tries pay
constexpr unsigned more_tries = 7;

using Graph = std::vector<std::vector<int>>;  // sorted neighbours

Graph graph_of(const Clauses& clauses) {
    Graph graph(static_cast<std::size_t>(clauses.variable_count()) + 1);
    const auto join = [&](int a, int b) {
        if (a == b) return;
        graph[a].push_back(b);
        graph[b].push_back(a);
    };
    for (std::size_t c = 0; c < clauses.size(); ++c) {
        const std::span<const int> clause = clauses[c];
        for (std::size_t i = 0; i < clause.size(); ++i)
            for (std::size_t j = i + 1; j < clause.size(); ++j)
                if (clause.size() <= long_clause || j == i + 1) join(std::abs(clause[i]), std::abs(clause[j]));
    }
    for (std::vector<int>& neighbours : graph) {
        std::ranges::sort(neighbours);
        neighbours.erase(std::unique(neighbours.begin(), neighbours.end()), neighbours.end());
    }
    return graph;
}

struct Decomposition {
    std::vector<int> order;              ///< of elimination
    std::vector<std::vector<int>> bags;  ///< by variable: its neighbours when it was eliminated
    double cost = 0;
};

/// `shuffle` breaks ties; 0: by the variables' numbers.
Decomposition eliminate(Graph graph, bool min_fill, unsigned shuffle = 0) {
    const auto is_edge = [&](int a, int b) { return std::ranges::binary_search(graph[a], b); };
    const auto score = [&](int v) -> long {
        const std::vector<int>& near = graph[v];
        const long degree = static_cast<long>(near.size());
        if (!min_fill) return degree;
        if (degree > fill_limit) return degree * degree / 2 + fill_limit * fill_limit;
        long missing = 0;
        for (std::size_t i = 0; i < near.size(); ++i)
            for (std::size_t j = i + 1; j < near.size(); ++j) missing += is_edge(near[i], near[j]) ? 0 : 1;
        return missing;
    };
    std::vector<long> scores(graph.size(), 0);
    std::vector<std::uint32_t> ties(graph.size(), 0);
    std::minstd_rand random(shuffle);
    if (shuffle > 0)
        for (std::uint32_t& tie : ties) tie = static_cast<std::uint32_t>(random());
    std::set<std::tuple<long, std::uint32_t, int>> queue;
    for (int v = 1; v < static_cast<int>(graph.size()); ++v) queue.emplace(scores[v] = score(v), ties[v], v);
    Decomposition result;
    result.bags.resize(graph.size());
    while (!queue.empty()) {
        const int v = std::get<int>(*queue.begin());
        queue.erase(queue.begin());
        const std::vector<int> near = graph[v];
        result.order.push_back(v);
        result.bags[v] = near;
        result.cost += std::exp2(static_cast<double>(near.size() + 1));
        std::vector<int> touched = near;
        std::vector<int> merged;
        for (const int a : near) {
            merged.clear();
            std::ranges::set_union(graph[a], near, std::back_inserter(merged));
            std::erase_if(merged, [&](int b) { return b == a || b == v; });
            if (min_fill && merged.size() + 1 > graph[a].size() && graph[a].size() <= fill_limit)
                touched.insert(touched.end(), graph[a].begin(), graph[a].end());  // their missing edges may be fewer
            graph[a] = merged;
        }
        std::ranges::sort(touched);
        touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
        for (const int a : touched) {
            if (a == v) continue;
            const long fresh = score(a);
            if (fresh == scores[a]) continue;
            queue.erase({scores[a], ties[a], a});
            queue.emplace(scores[a] = fresh, ties[a], a);
        }
        graph[v].clear();
    }
    return result;
}

/// The depth of the highest bag of each variable, with the tree hung up at the bag in its middle.
std::vector<int> ranks_of(const Decomposition& decomposition) {
    const std::size_t n = decomposition.bags.size();
    std::vector<int> position(n, 0), parent(n, 0), weight(n, 1);
    for (std::size_t i = 0; i < decomposition.order.size(); ++i) position[decomposition.order[i]] = static_cast<int>(i);
    Graph tree(n);
    for (const int v : decomposition.order) {
        const std::vector<int>& bag = decomposition.bags[v];
        if (bag.empty()) continue;  // the last one of its component
        parent[v] = *std::ranges::min_element(bag, {}, [&](int a) { return position[a]; });
        tree[v].push_back(parent[v]);
        tree[parent[v]].push_back(v);
        weight[parent[v]] += weight[v];  // children come before their parents
    }
    std::vector<int> ranks(n, 0);
    std::vector<char> seen(n, 0), ranked(n, 0);
    for (auto each = decomposition.order.rbegin(); each != decomposition.order.rend(); ++each) {
        if (parent[*each] != 0) continue;
        int middle = *each;  // go down while more than half hangs below
        for (bool moved = true; moved;) {
            moved = false;
            for (const int child : tree[middle])
                if (parent[child] == middle && 2 * weight[child] > weight[*each]) {
                    middle = child;
                    moved = true;
                    break;
                }
        }
        std::vector<std::pair<int, int>> queue{{middle, 0}};
        seen[middle] = 1;
        for (std::size_t i = 0; i < queue.size(); ++i) {
            const auto [v, depth] = queue[i];
            const auto rank = [&](int a) {
                if (!ranked[a]) ranks[a] = depth;
                ranked[a] = 1;
            };
            rank(v);
            for (const int a : decomposition.bags[v]) rank(a);
            for (const int next : tree[v])
                if (!seen[next]) {
                    seen[next] = 1;
                    queue.emplace_back(next, depth + 1);
                }
        }
    }
    return ranks;
}

}  // namespace

DecisionOrder decision_order(const Clauses& clauses) {
    const Graph graph = graph_of(clauses);
    Decomposition best = eliminate(graph, true);
    const auto consider = [&](Decomposition other) {
        if (other.cost < best.cost) best = std::move(other);
    };
    consider(eliminate(graph, false));
    for (unsigned shuffle = 1; shuffle <= more_tries && best.cost > good_cost && best.cost < hopeless_cost; ++shuffle)
        consider(eliminate(graph, true, shuffle));
    DecisionOrder order{ranks_of(best), 0, best.cost >= hopeless_cost};
    for (const std::vector<int>& bag : best.bags) order.width = std::max(order.width, bag.size());
    return order;
}

}  // namespace partonomy::knowledge
