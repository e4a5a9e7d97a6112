/* Gates as clauses.

   A gate is a variable that is equivalent to its formula (Tseitin 1968, both directions, so that it may be used under
   either sign). Disjunctions are negated conjunctions, and conjunctions are found again by their sorted literals.

   Counting is a totalizer (Bailleux and Boufkhad, "Efficient CNF encoding of Boolean cardinality constraints", 2003): a
   balanced tree over the literals whose nodes say "at least r of mine are true". We depart from it in that the output r
   of a node is made when somebody asks for it, which bounds the tree at the largest number asked and lets `min 2` and
   `max 3` over the same literals share it. Output r of a node with halves a and b is defined by

       a_i and b_j -> o_r          for i + j = r           (a_0 is true, a_i is false beyond the half's size)
       o_r -> a_i or b_j           for i + j = r + 1, i and j positive

   so it needs outputs 1 … r of its halves only, and 2r + 1 clauses: literals × count for the tree, not count² for each
   node, since a node of s literals has no more than s outputs. "At least 9 of 10" is "not: at least 2 of the
   negated", hence count never exceeds half the literals. */

#include "knowledge/clauses.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>

namespace partonomy::knowledge {
namespace {

bool by_variable(int a, int b) { return std::abs(a) != std::abs(b) ? std::abs(a) < std::abs(b) : a < b; }

std::vector<int> negated(std::span<const int> literals) {
    std::vector<int> result(literals.begin(), literals.end());
    for (int& literal : result) literal = -literal;
    return result;
}

}  // namespace

std::size_t Clauses::Hash::operator()(const std::vector<int>& literals) const {
    std::uint64_t hash = literals.size();
    for (const int literal : literals) {
        hash = (hash ^ static_cast<std::uint32_t>(literal)) * 0x9E3779B97F4A7C15U;
        hash ^= hash >> 29;
    }
    return static_cast<std::size_t>(hash);
}

void Clauses::add(std::span<const int> literals) {
    if (always_ != 0 && std::ranges::find(literals, always_) != literals.end()) return;
    for (const int literal : literals)
        if (always_ == 0 || literal != -always_) literals_.push_back(literal);
    ends_.push_back(literals_.size());
}

std::span<const int> Clauses::operator[](std::size_t clause) const {
    const std::size_t begin = clause == 0 ? 0 : ends_[clause - 1];
    return std::span(literals_).subspan(begin, ends_[clause] - begin);
}

int Clauses::always() {
    if (always_ == 0) {
        const int variable = add_variable();
        add({variable});
        always_ = variable;
    }
    return always_;
}

int Clauses::all_of(std::span<const int> literals) {
    std::vector<int> sorted;
    for (const int literal : literals) {
        if (always_ != 0 && literal == always_) continue;
        if (always_ != 0 && literal == -always_) return never();
        sorted.push_back(literal);
    }
    std::ranges::sort(sorted, by_variable);
    sorted.erase(std::ranges::unique(sorted).begin(), sorted.end());
    for (std::size_t i = 1; i < sorted.size(); ++i)
        if (sorted[i] == -sorted[i - 1]) return never();
    if (sorted.empty()) return always();
    if (sorted.size() == 1) return sorted[0];

    const auto [found, is_new] = conjunctions_.try_emplace(sorted, 0);
    if (!is_new) return found->second;
    const int gate = found->second = add_variable();
    std::vector<int> clause = negated(sorted);
    clause.push_back(gate);
    add(clause);
    for (const int literal : sorted) add({-gate, literal});
    return gate;
}

int Clauses::any_of(std::span<const int> literals) { return -all_of(negated(literals)); }

std::size_t Clauses::counter_of(std::span<const int> literals) {
    const auto [found, is_new] =
        counter_ids_.try_emplace(std::vector(literals.begin(), literals.end()), counters_.size());
    const std::size_t id = found->second;
    if (!is_new) return id;
    counters_.push_back({0, 0, literals.size(), std::vector<int>(literals.size(), 0)});
    if (literals.size() == 1) {
        counters_[id].outputs[0] = literals[0];
        return id;
    }
    const std::size_t left = counter_of(literals.first(literals.size() / 2));
    const std::size_t right = counter_of(literals.subspan(literals.size() / 2));
    counters_[id].left = left;
    counters_[id].right = right;
    return id;
}

int Clauses::output(std::size_t counter, std::size_t count) {
    if (count == 0) return always();
    const auto& [left, right, size, outputs] = counters_[counter];
    if (count > size) return never();
    if (outputs[count - 1] != 0) return outputs[count - 1];
    const int result = add_variable();
    counters_[counter].outputs[count - 1] = result;
    for (std::size_t i = 0; i <= count; ++i) add({-output(left, i), -output(right, count - i), result});
    for (std::size_t i = 1; i <= count; ++i) add({output(left, i), output(right, count + 1 - i), -result});
    return result;
}

int Clauses::at_least(std::span<const int> literals, unsigned count) {
    std::vector<int> sorted(literals.begin(), literals.end());
    std::ranges::sort(sorted, by_variable);
    std::vector<int> kept;
    std::size_t needed = count;
    for (const int literal : sorted) {
        const bool is_true = always_ != 0 && literal == always_;
        const bool is_pair = !kept.empty() && kept.back() == -literal;  // exactly one of the two is true
        if (is_pair) kept.pop_back();
        if ((is_true || is_pair) && needed-- == 0) return always();
        if (!is_true && !is_pair && (always_ == 0 || literal != -always_)) kept.push_back(literal);
    }
    if (needed == 0) return always();
    if (needed > kept.size()) return never();
    if (needed == 1) return any_of(kept);
    if (needed == kept.size()) return all_of(kept);
    if (2 * needed <= kept.size() + 1) return output(counter_of(kept), needed);
    return -output(counter_of(negated(kept)), kept.size() + 1 - needed);
}

}  // namespace partonomy::knowledge
