#pragma once

#include <cstddef>
#include <initializer_list>
#include <span>
#include <vector>

namespace partonomy::knowledge {

/// A propositional formula in conjunctive normal form, as in DIMACS: variables are 1, 2, …; literal v says that variable
/// v is true, -v that it is false.
class Clauses {
public:
    /// A new variable.
    int add_variable() { return ++variable_count_; }
    /// Adds a clause: at least one of the literals is true. Without literals the formula is unsatisfiable.
    void add(std::span<const int> literals);
    void add(std::initializer_list<int> literals) { add(std::span(literals.begin(), literals.size())); }

    /// A literal that is true exactly when all (any) of the literals are.
    [[nodiscard]] int all_of(std::span<const int> literals);
    [[nodiscard]] int any_of(std::span<const int> literals);
    /// A literal that is true exactly when at least `count` of the literals are (a totalizer: Bailleux and Boufkhad 2003,
    /// bounded at `count`; about literals × count clauses).
    [[nodiscard]] int at_least(std::span<const int> literals, unsigned count);
    /// The constants.
    [[nodiscard]] int always();
    [[nodiscard]] int never() { return -always(); }

    [[nodiscard]] int variable_count() const { return variable_count_; }
    [[nodiscard]] std::size_t size() const { return ends_.size(); }
    [[nodiscard]] std::span<const int> operator[](std::size_t clause) const;

private:
    int variable_count_ = 0;
    int always_ = 0;
    std::vector<int> literals_;
    std::vector<std::size_t> ends_;
};

}  // namespace partonomy::knowledge
