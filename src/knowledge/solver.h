#pragma once

#include <memory>
#include <span>
#include <vector>

#include "knowledge/clauses.h"
#include "knowledge/steps.h"

namespace partonomy::knowledge {

enum class Verdict { satisfiable, unsatisfiable };

/// An incremental SAT solver (CaDiCaL), so that many questions about one formula share what was learned.
class Solver {
public:
    explicit Solver(const Clauses& clauses);
    ~Solver();
    Solver(Solver&&) noexcept;
    Solver& operator=(Solver&&) noexcept;

    /// Adds the clauses of `clauses` that it had not when this was last called (or constructed).
    void add_new(const Clauses& clauses);

    /// Adds another formula, its variables renumbered behind all that there are: by so much. Nothing may be added from
    /// the first formula any more.
    int append(const Clauses& other);
    /// Adds clauses over the variables that there are.
    void add_more(const Clauses& clauses);

    /// Makes literals true in this solver from now on, though not in the clauses.
    void require(std::span<const int> literals);

    /// From now on, tries these literals first where it has to guess.
    void prefer(std::span<const int> literals);

    /// From now on, all that it is asked takes its steps from these, which must live as long; nullptr: no limit.
    void take_from(Steps* steps);

    /// Whether the formula has a model in which all assumptions are true. Throws OutOfSteps; what was learned until
    /// then is kept.
    [[nodiscard]] Verdict solve(std::span<const int> assumptions = {});
    /// After `satisfiable`: whether the variable is true in the model found.
    [[nodiscard]] bool value(int variable) const;
    /// After `unsatisfiable`: assumptions that suffice for it, in the order given; not minimal.
    [[nodiscard]] std::vector<int> core() const;

    /// Those of `candidates` that are true in every model of formula and assumptions, in the order given. Throws
    /// std::logic_error when there is no model.
    [[nodiscard]] std::vector<int> entailed(std::span<const int> candidates, std::span<const int> assumptions = {});

private:
    struct Engine;
    std::unique_ptr<Engine> engine_;
};

}  // namespace partonomy::knowledge
