/* CaDiCaL behind our interface.

   What every model has in common (the backbone) is found as in Janota, Lynce and Marques-Silva, "Algorithms for
   computing backbones of propositional formulae" (2015): whatever one model refutes is out, and the rest is asked all
   at once: "is one of these false?" Each answer but the last removes at least one candidate, and since the solver is
   told to try false first, usually most. */

#include "knowledge/solver.h"

#include <algorithm>
#include <cadical.hpp>
#include <cstdlib>
#include <stdexcept>

namespace partonomy::knowledge {

namespace {

// CaDiCaL asks whether to stop every ten decisions; what lies between takes the longer the larger the formula is. It
// tells each conflict, which takes longer than a decision.
constexpr std::uint64_t variables_a_step = 8000;
constexpr std::uint64_t steps_a_conflict = 10;

}  // namespace

struct Solver::Engine : CaDiCaL::Terminator, CaDiCaL::Learner {
    CaDiCaL::Solver cadical;
    std::size_t clauses = 0;  ///< taken over so far
    int variables = 0;
    std::vector<int> assumptions;  ///< of the last solve
    Steps* steps = nullptr;

    bool run(std::span<const int> literals) {
        assumptions.assign(literals.begin(), literals.end());
        if (steps != nullptr && terminate()) throw OutOfSteps();
        for (const int literal : literals) cadical.assume(literal);
        const int verdict = cadical.solve();
        if (verdict == 0) throw OutOfSteps();
        return verdict == 10;
    }
    bool learning(int) override {
        static_cast<void>(steps->take(steps_a_conflict));
        return false;
    }
    void learn(int) override {}
    bool terminate() override { return !steps->take(1 + static_cast<std::uint64_t>(variables) / variables_a_step); }
};

Solver::Solver(const Clauses& clauses) : engine_(std::make_unique<Engine>()) {
    engine_->cadical.set("quiet", 1);
    add_new(clauses);
}

Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

void Solver::add_new(const Clauses& clauses) {
    for (; engine_->clauses < clauses.size(); ++engine_->clauses) {
        for (const int literal : clauses[engine_->clauses]) engine_->cadical.add(literal);
        engine_->cadical.add(0);
    }
    engine_->variables = clauses.variable_count();
    engine_->cadical.reserve(engine_->variables);
}

int Solver::append(const Clauses& other) {
    const int by = engine_->variables;
    for (std::size_t clause = 0; clause < other.size(); ++clause) {
        for (const int literal : other[clause]) engine_->cadical.add(literal > 0 ? literal + by : literal - by);
        engine_->cadical.add(0);
    }
    engine_->variables += other.variable_count();
    engine_->cadical.reserve(engine_->variables);
    return by;
}

void Solver::add_more(const Clauses& clauses) {
    for (std::size_t clause = 0; clause < clauses.size(); ++clause) {
        for (const int literal : clauses[clause]) engine_->cadical.add(literal);
        engine_->cadical.add(0);
    }
}

void Solver::take_from(Steps* steps) {
    if (engine_->steps != nullptr) {
        engine_->cadical.disconnect_terminator();
        engine_->cadical.disconnect_learner();
    }
    engine_->steps = steps;
    if (steps == nullptr) return;
    engine_->cadical.connect_terminator(engine_.get());
    engine_->cadical.connect_learner(engine_.get());
}

void Solver::require(std::span<const int> literals) {
    for (const int literal : literals) {
        engine_->cadical.add(literal);
        engine_->cadical.add(0);
    }
}

void Solver::prefer(std::span<const int> literals) {
    for (const int literal : literals) engine_->cadical.phase(literal);
}

Verdict Solver::solve(std::span<const int> assumptions) {
    return engine_->run(assumptions) ? Verdict::satisfiable : Verdict::unsatisfiable;
}

bool Solver::value(int variable) const { return engine_->cadical.val(variable) > 0; }

std::vector<int> Solver::core() const {
    std::vector<int> result;
    for (const int literal : engine_->assumptions)
        if (engine_->cadical.failed(literal) && std::ranges::find(result, literal) == result.end())
            result.push_back(literal);
    return result;
}

std::vector<int> Solver::entailed(std::span<const int> candidates, std::span<const int> assumptions) {
    std::vector<int> open(candidates.begin(), candidates.end());
    const auto drop_refuted = [&] {
        std::erase_if(open, [&](int literal) { return engine_->cadical.val(std::abs(literal)) != literal; });
    };
    for (const int literal : candidates) engine_->cadical.phase(-literal);
    const bool has_model = engine_->run(assumptions);
    if (has_model) drop_refuted();
    while (has_model && !open.empty()) {
        for (const int literal : open) engine_->cadical.constrain(-literal);
        engine_->cadical.constrain(0);
        if (!engine_->run(assumptions)) break;
        drop_refuted();
    }
    for (const int literal : candidates) engine_->cadical.unphase(literal);
    if (!has_model) throw std::logic_error("Solver::entailed: the formula has no model under these assumptions");
    return open;
}

}  // namespace partonomy::knowledge
