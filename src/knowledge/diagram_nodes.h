#pragma once

#include <array>
#include <cstdint>

#include "knowledge/diagram.h"

// Inside of the diagram: its nodes, and the three steps that make them.

namespace partonomy::knowledge {

/// A decision has two branches. A branch is a conjunction: literals, independent children, and variables that are free.
struct DiagramBranch {
    std::size_t first = 0;  ///< in Diagram::Nodes::pool: literals, then free variables, then children
    std::uint32_t literals = 0, free = 0, children = 0;
    bool is_dead = true;  ///< no model
};

struct Diagram::Nodes {
    int variables = 0;
    std::vector<int> pool;
    std::vector<std::array<DiagramBranch, 2>> nodes;  ///< children before parents
    DiagramBranch root;

    [[nodiscard]] std::span<const int> literals(const DiagramBranch& branch) const {
        return std::span(pool).subspan(branch.first, branch.literals);
    }
    [[nodiscard]] std::span<const int> free(const DiagramBranch& branch) const {
        return std::span(pool).subspan(branch.first + branch.literals, branch.free);
    }
    [[nodiscard]] std::span<const int> children(const DiagramBranch& branch) const {
        return std::span(pool).subspan(branch.first + branch.literals + branch.free, branch.children);
    }
};

struct DecisionOrder {
    std::vector<int> ranks;    ///< when each variable is best decided: the lower the earlier; index 0 is not used
    std::size_t width = 0;     ///< variables that have to be decided together at worst
    bool is_hopeless = false;  ///< a diagram of that order may well have 2^60 nodes
};
[[nodiscard]] DecisionOrder decision_order(const Clauses& clauses);

/// The diagram's nodes, deciding the variable of lowest rank first in each component.
[[nodiscard]] std::shared_ptr<const Diagram::Nodes> search_diagram(const Clauses& clauses, const DecisionOrder& order,
                                                                   const DiagramOptions& options);

}  // namespace partonomy::knowledge
