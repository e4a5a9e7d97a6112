#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <unordered_map>
#include <vector>

namespace partonomy::knowledge {

/// A propositional formula in conjunctive normal form, as in DIMACS: variables are 1, 2, …; literal v says that
/// variable v is true, -v that it is false. Gates are shared: asking twice for the same one gives the same literal.
class Clauses {
public:
    /// A new variable.
    int add_variable() { return ++variable_count_; }
    /// Adds a clause: at least one of the literals is true. Without literals the formula is unsatisfiable.
    void add(std::span<const int> literals);
    void add(std::initializer_list<int> literals) { add(std::span(literals.begin(), literals.size())); }

    /// A literal that is true exactly when all (any) of the literals are.
    [[nodiscard]] int all_of(std::span<const int> literals);
    [[nodiscard]] int all_of(std::initializer_list<int> literals) {
        return all_of(std::span(literals.begin(), literals.size()));
    }
    [[nodiscard]] int any_of(std::span<const int> literals);
    [[nodiscard]] int any_of(std::initializer_list<int> literals) {
        return any_of(std::span(literals.begin(), literals.size()));
    }
    /// A literal that is true exactly when at least `count` of the literals are; one that is given twice counts twice;
    /// of more than there are: never() (a totalizer: Bailleux and Boufkhad 2003, bounded at `count`; about literals ×
    /// count clauses).
    [[nodiscard]] int at_least(std::span<const int> literals, unsigned count);
    /// The constants.
    [[nodiscard]] int always();
    [[nodiscard]] int never() { return -always(); }

    [[nodiscard]] int variable_count() const { return variable_count_; }
    [[nodiscard]] std::size_t size() const { return ends_.size(); }
    [[nodiscard]] std::span<const int> operator[](std::size_t clause) const;

private:
    /// A node of a totalizer: how many of its literals are true.
    struct Counter {
        std::size_t left = 0, right = 0;  ///< the counters of its halves
        std::size_t size = 0;             ///< literals
        std::vector<int> outputs;         ///< [r - 1]: at least r are true; 0 while nobody has asked
    };
    [[nodiscard]] std::size_t counter_of(std::span<const int> literals);
    [[nodiscard]] int output(std::size_t counter, std::size_t count);

    int variable_count_ = 0;
    int always_ = 0;
    std::vector<int> literals_;
    std::vector<std::size_t> ends_;
    struct Hash {
        std::size_t operator()(const std::vector<int>& literals) const;
    };
    std::unordered_map<std::vector<int>, int, Hash> conjunctions_;  ///< by sorted literals; only looked up, so no order
    std::unordered_map<std::vector<int>, std::size_t, Hash> counter_ids_;
    std::vector<Counter> counters_;
};

}  // namespace partonomy::knowledge
