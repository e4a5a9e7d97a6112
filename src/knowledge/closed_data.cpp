/* Literals about data values: d(a, v) for the values that closed_data_names.cpp chose.

   "Some value from 0.4 to 0.48" is a disjunction over neighbouring values, and an ontology with a hundred thresholds
   makes hundreds of such disjunctions over hundreds of values. So disjunctions over long runs of neighbours share a
   binary tree for each property and individual, of which a run needs no more than two nodes on each level. */

#include <algorithm>

#include "knowledge/closed_grounder.h"
#include "owl/words.h"

namespace partonomy::knowledge::closed {

namespace {

constexpr std::size_t short_run = 4;  ///< for which no tree is worth while

}  // namespace

int Grounder::range_id(const owl::DataRange& range) {
    const auto [found, is_new] = range_ids_.try_emplace(range, static_cast<int>(ranges_.size()));
    if (is_new) ranges_.push_back(&found->first);
    return found->second;
}

int Grounder::complement_id(int range) {
    const owl::DataRange& of = *ranges_[static_cast<std::size_t>(range)];
    return range_id({owl::DataRangeKind::complement_of, {}, {}, {}, {of}});
}

std::uint64_t Grounder::literals_in(int range) const {
    DataCells cells(definitions_);
    cells.mention(*ranges_[static_cast<std::size_t>(range)]);
    cells.cut();
    const std::vector<bool> inside = cells.inside(*ranges_[static_cast<std::size_t>(range)]);
    std::uint64_t count = 0;
    for (std::size_t cell = 0; cell < inside.size(); ++cell)
        if (inside[cell]) count = saturating_sum(count, cells.cells()[cell].capacity);
    return count;
}

bool Grounder::has_literal(const owl::DataRange& range, const owl::Literal& literal) const {
    DataCells cells(definitions_);
    cells.mention(range);
    cells.mention(literal);
    cells.cut();
    return cells.inside(range)[cells.find(literal).value()];
}

const std::vector<std::size_t>& Grounder::values_in(int property, int range) {
    const auto [found, is_new] = values_in_.try_emplace({root_of(property), range});
    if (is_new) {
        const DataGroup& group = group_of(property);
        const std::vector<bool> inside = group.cells.inside(*ranges_[static_cast<std::size_t>(range)]);
        for (std::size_t value = 0; value < group.values.size(); ++value)
            if (inside[group.values[value]]) found->second.push_back(value);
    }
    return found->second;
}

int Grounder::any_between(int property, int individual, std::size_t begin, std::size_t end) {
    if (end - begin <= short_run) {
        std::vector<int> atoms;
        for (std::size_t value = begin; value < end; ++value) atoms.push_back(data_atom(property, individual, value));
        return clauses.any_of(atoms);
    }
    // A heap: node 1 is all values, node i has children 2i and 2i + 1, leaf `leaves + v` is value v.
    std::size_t leaves = 1;
    while (leaves < group_of(property).values.size()) leaves *= 2;
    std::vector<int>& tree = any_trees_[{property, individual}];
    tree.resize(2 * leaves, 0);
    const auto node = [&](std::size_t at, const auto& self) -> int {
        if (tree[at] != 0) return tree[at];
        if (at >= leaves) {
            const bool exists = at - leaves < group_of(property).values.size();
            return tree[at] = exists ? data_atom(property, individual, at - leaves) : -always_;
        }
        const int left = self(2 * at, self);
        return tree[at] = clauses.any_of({left, self(2 * at + 1, self)});
    };
    std::vector<int> parts;
    for (std::size_t low = begin + leaves, high = end + leaves; low < high; low /= 2, high /= 2) {
        if (low % 2 == 1) parts.push_back(node(low++, node));
        if (high % 2 == 1) parts.push_back(node(--high, node));
    }
    return clauses.any_of(parts);
}

int Grounder::some_value(int property, int individual, int range) {
    if (property == Property::bottom) return -always_;
    if (property == Property::top) return literals_in(range) > 0 ? always_ : -always_;
    const std::vector<std::size_t>& values = values_in(property, range);
    std::vector<int> runs;
    for (std::size_t i = 0; i < values.size();) {
        std::size_t end = i + 1;
        while (end < values.size() && values[end] == values[end - 1] + 1) ++end;
        runs.push_back(any_between(property, individual, values[i], values[end - 1] + 1));
        i = end;
    }
    return clauses.any_of(runs);
}

int Grounder::at_least_values(int property, int individual, int range, std::uint64_t count) {
    if (count == 0) return always_;
    if (property == Property::bottom) return -always_;
    if (property == Property::top) return literals_in(range) >= count ? always_ : -always_;
    if (count == 1) return some_value(property, individual, range);
    const std::vector<std::size_t>& values = values_in(property, range);
    if (count > values.size()) return -always_;
    std::vector<int> atoms;
    for (const std::size_t value : values) atoms.push_back(data_atom(property, individual, value));
    return clauses.at_least(atoms, static_cast<unsigned>(count));
}

std::optional<int> Grounder::value_atom(int property, int individual, const owl::Literal& literal) {
    if (property == Property::bottom) return -always_;
    const DataGroup& group = group_of(property);
    const std::optional<std::size_t> cell = group.cells.find(literal);
    if (!cell) return std::nullopt;
    return data_atom(property, individual, group.first_value[*cell]);
}

}  // namespace partonomy::knowledge::closed
