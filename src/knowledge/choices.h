#pragma once

#include <vector>

#include "knowledge/clauses.h"

namespace partonomy::knowledge {

/// Adds a variable of which exactly one of `values` values holds (at least one), and returns a literal for each value.
/// Two values need one propositional variable, so that a yes/no feature is as cheap as it can be.
[[nodiscard]] inline std::vector<int> add_choice(Clauses& clauses, std::size_t values) {
    if (values <= 1) return std::vector<int>(values, clauses.always());
    if (values == 2) {
        const int variable = clauses.add_variable();
        return {variable, -variable};
    }
    std::vector<int> literals;
    for (std::size_t i = 0; i < values; ++i) literals.push_back(clauses.add_variable());
    clauses.add(literals);
    for (std::size_t i = 0; i < values; ++i)
        for (std::size_t j = i + 1; j < values; ++j) clauses.add({-literals[i], -literals[j]});
    return literals;
}

}  // namespace partonomy::knowledge
