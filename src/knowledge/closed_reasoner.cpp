/* Entailment over a closed world is satisfiability of the clauses: C(a) follows when no model makes it false. All class
   assertions are one backbone (see solver.cpp), mostly a handful of solver calls. The selectors are fixed to true in
   the solver, so that it simplifies the axioms away as if there were none. */

#include <algorithm>

#include "base/errors.h"
#include "knowledge/closed_world.h"
#include "knowledge/solver.h"

namespace partonomy::knowledge {

struct ClosedReasoner::State {
    ClosedWorld world;  ///< to ground again when a question has restrictions of data that no axiom has
    GroundOptions options;
    std::vector<owl::ClassPointer> questions = {};
    GroundedWorld grounded;
    Solver solver;

    State(ClosedWorld given, const GroundOptions& limits)
        : world(std::move(given)), options(limits), grounded(world, options), solver(grounded.clauses()) {
        solver.require(grounded.selectors());
    }

    void update() { solver.add_new(grounded.clauses()); }

    [[nodiscard]] bool is_satisfiable(const std::vector<int>& assumptions) {
        update();
        return solver.solve(assumptions) == Verdict::satisfiable;
    }

    /// The literal of an expression, though no axiom has its data ranges.
    [[nodiscard]] int literal(const owl::ClassPointer& expression, const Iri& individual) {
        if (const auto found = std::ranges::find(questions, expression);
            found == questions.end() && is_about_data(*expression)) {
            questions.push_back(expression);
            grounded = GroundedWorld(world, options, questions);
            solver = Solver(grounded.clauses());
            solver.require(grounded.selectors());
        }
        return grounded.is_a(individual, *expression);
    }

    [[nodiscard]] static bool is_about_data(const owl::ClassExpression& expression) {
        return expression.kind >= owl::ClassKind::data_some_values_from ||
               std::ranges::any_of(expression.operands,
                                   [](const owl::ClassPointer& operand) { return is_about_data(*operand); });
    }

    /// Those of `candidates` whose literals are true in every model; `literals` are in step with them.
    template <class Candidate>
    [[nodiscard]] std::vector<Candidate> entailed(std::vector<Candidate> candidates, const std::vector<int>& literals) {
        if (!is_satisfiable({})) {
            const std::string& file =
                grounded.ontology().axioms.empty() ? "" : grounded.ontology().axioms.back().source.file;
            throw OntologyError(at(file, 0, "the closed world is inconsistent, so that everything follows from it"));
        }
        std::vector<int> found = solver.entailed(literals);
        std::ranges::sort(found);
        std::vector<Candidate> result;
        for (std::size_t i = 0; i < candidates.size(); ++i)
            if (std::ranges::binary_search(found, literals[i])) result.push_back(std::move(candidates[i]));
        return result;
    }
};

ClosedReasoner::ClosedReasoner(ClosedWorld world, const GroundOptions& options)
    : state_(std::make_unique<State>(std::move(world), options)) {}

ClosedReasoner::~ClosedReasoner() = default;
ClosedReasoner::ClosedReasoner(ClosedReasoner&&) noexcept = default;
ClosedReasoner& ClosedReasoner::operator=(ClosedReasoner&&) noexcept = default;

GroundedWorld& ClosedReasoner::grounded() { return state_->grounded; }

bool ClosedReasoner::is_consistent() { return state_->is_satisfiable({}); }

bool ClosedReasoner::is_satisfiable(const owl::ClassPointer& expression, const Iri& individual) {
    const int literal = state_->literal(expression, individual);
    return state_->is_satisfiable({literal});
}

bool ClosedReasoner::is_entailed(const owl::ClassPointer& expression, const Iri& individual) {
    const int literal = state_->literal(expression, individual);
    return !state_->is_satisfiable({-literal});
}

std::vector<Iri> ClosedReasoner::types(const Iri& individual) {
    std::vector<int> literals;
    for (const Iri& each : state_->grounded.classes()) literals.push_back(state_->grounded.is_a(individual, each));
    return state_->entailed(state_->grounded.classes(), literals);
}

std::vector<std::pair<Iri, Iri>> ClosedReasoner::all_types() {
    std::vector<std::pair<Iri, Iri>> candidates;
    std::vector<int> literals;
    for (const Iri& individual : state_->grounded.individuals())
        for (const Iri& each : state_->grounded.classes()) {
            candidates.emplace_back(individual, each);
            literals.push_back(state_->grounded.is_a(individual, each));
        }
    return state_->entailed(std::move(candidates), literals);
}

std::vector<ClosedReasoner::Relation> ClosedReasoner::relations() {
    std::vector<Relation> candidates;
    std::vector<int> literals;
    for (const Iri& subject : state_->grounded.individuals())
        for (const Iri& property : state_->grounded.object_properties())
            for (const Iri& object : state_->grounded.individuals()) {
                candidates.push_back({subject, property, object});
                literals.push_back(state_->grounded.related(subject, {property, false}, object));
            }
    return state_->entailed(std::move(candidates), literals);
}

std::vector<std::pair<Iri, Iri>> ClosedReasoner::same_individuals() {
    std::vector<std::pair<Iri, Iri>> candidates;
    std::vector<int> literals;
    const std::vector<Iri>& all = state_->grounded.individuals();
    for (std::size_t a = 0; a < all.size(); ++a)
        for (std::size_t b = a + 1; b < all.size(); ++b) {
            candidates.emplace_back(all[a], all[b]);
            literals.push_back(state_->grounded.same(all[a], all[b]));
        }
    return state_->entailed(std::move(candidates), literals);
}

std::vector<std::pair<Iri, Iri>> ClosedReasoner::hierarchy() {
    const std::vector<Iri>& classes = state_->grounded.classes();
    const std::vector<Iri>& individuals = state_->grounded.individuals();
    (void)state_->entailed(std::vector<Iri>{}, {});  // throws when inconsistent
    std::vector<std::vector<int>> members(classes.size());
    for (std::size_t i = 0; i < classes.size(); ++i)
        for (const Iri& individual : individuals) members[i].push_back(state_->grounded.is_a(individual, classes[i]));
    std::vector<std::pair<Iri, Iri>> result;
    for (std::size_t below = 0; below < classes.size(); ++below) {
        std::vector<std::size_t> above;
        for (std::size_t i = 0; i < classes.size(); ++i)
            if (i != below) above.push_back(i);
        for (std::size_t who = 0; who < individuals.size() && !above.empty(); ++who) {
            const std::vector<int> member{members[below][who]};
            if (!state_->is_satisfiable(member)) continue;
            std::vector<int> literals;
            for (const std::size_t i : above) literals.push_back(members[i][who]);
            const std::vector<int> entailed = state_->solver.entailed(literals, member);
            std::erase_if(
                above, [&](std::size_t i) { return std::ranges::find(entailed, members[i][who]) == entailed.end(); });
        }
        for (const std::size_t i : above) result.emplace_back(classes[below], classes[i]);
    }
    return result;
}

}  // namespace partonomy::knowledge
