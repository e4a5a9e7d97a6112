/* A layer of regions that is too large to list, as clauses and a diagram over them.

   Every range concept and measured property is a choice of one value, every concept a literal that is equivalent to its
   definition (a gate), every constraint a clause or several. Definitions multiply nothing, so the models of the clauses
   are the configurations, and sets of configurations are conjunctions of these literals (configuration_set.h). Beside
   concepts, whatever somebody will ask for needs a literal before the diagram is made: the classes of parts that
   objects count, and "at most this interval" of each measured property.

   Whether a concept can ever be proved is a question with two quantifiers: is there a choice of features under which it
   holds whatever the concepts without definition are? As usual, guess the features, look for a counterexample, and let
   the next guess avoid that one too (Janota et al., "Solving QBF with counterexample guided refinement", 2016); nearly
   always the first counterexample, "none of them holds", ends it. */

#include <algorithm>

#include "base/errors.h"
#include "knowledge/choices.h"
#include "knowledge/diagram.h"
#include "knowledge/formula_clauses.h"
#include "knowledge/solver.h"
#include "knowledge/theory.h"

namespace partonomy::knowledge {
namespace {

/// Clauses about one region.
class RegionClauses {
public:
    /// One reading of the concepts without definition: as variables of their own, or as constants.
    struct Reading {
        std::vector<int> primitives;  ///< literal by concept, 0 for others
        std::vector<int> literals;    ///< by formula, 0 while nobody has asked
    };

    RegionClauses(const Theory& theory, const Scope& scope) : theory_(theory), scope_(scope) {
        (void)clauses.always();
        for (std::size_t f = 0; f < theory.feature_count(); ++f)
            features.push_back(scope.features[f] ? add_choice(clauses, theory.value_count(f)) : std::vector<int>{});
        open.primitives.assign(theory.concepts.size(), 0);
        open.literals.assign(theory.formulas.size(), 0);
        for (std::size_t id = 0; id < theory.concepts.size(); ++id)
            if (is_primitive(id)) open.primitives[id] = add_choice(clauses, 2)[0];
    }

    [[nodiscard]] bool is_primitive(std::size_t id) const {
        const NamedConcept& named = theory_.concepts[id];
        return named.level == Level::region && scope_.concepts[id] &&
               (named.definition < 0 || !scope_.axioms[named.axiom]);
    }

    void require_constraints() {
        for (const Constraint& constraint : theory_.constraints)
            if (constraint.level == Level::region && scope_.axioms[constraint.axiom]) require(constraint.formula, true);
    }

    [[nodiscard]] int constraints(Reading& reading) {
        std::vector<int> all;
        for (const Constraint& constraint : theory_.constraints)
            if (constraint.level == Level::region && scope_.axioms[constraint.axiom])
                all.push_back(literal(reading, constraint.formula));
        return clauses.all_of(all);
    }

    [[nodiscard]] int concept_literal(Reading& reading, std::size_t id) {
        if (reading.primitives[id] != 0) return reading.primitives[id];
        return literal(reading, theory_.concepts[id].definition);
    }

    [[nodiscard]] int literal(Reading& reading, FormulaId id) {
        if (reading.literals[id] == 0) reading.literals[id] = make(reading, theory_.formulas[id]);
        return reading.literals[id];
    }

    Clauses clauses;
    std::vector<std::vector<int>> features;  ///< [feature][value]
    Reading open;

private:
    [[nodiscard]] int make(Reading& reading, const Formula& formula) {
        return formula_literal(
            clauses, formula, [&](FormulaId operand) { return literal(reading, operand); },
            [&](std::size_t f) -> const std::vector<int>& { return features[f]; },
            [&](int named) { return concept_literal(reading, static_cast<std::size_t>(named)); },
            [&](const Formula&) { return clauses.never(); });
    }

    /// Makes the formula (its negation when not `sign`) true without gates for its outer conjunctions and disjunctions.
    void require(FormulaId id, bool sign) {
        const Formula& formula = theory_.formulas[id];
        if (formula.kind == Formula::Kind::negation) return require(formula.operands[0], !sign);
        if (formula.kind == (sign ? Formula::Kind::conjunction : Formula::Kind::disjunction)) {
            for (const FormulaId operand : formula.operands) require(operand, sign);
            return;
        }
        std::vector<int> clause;
        collect(id, sign, clause);
        clauses.add(clause);
    }

    void collect(FormulaId id, bool sign, std::vector<int>& clause) {
        const Formula& formula = theory_.formulas[id];
        if (formula.kind == Formula::Kind::negation) return collect(formula.operands[0], !sign, clause);
        if (formula.kind == (sign ? Formula::Kind::disjunction : Formula::Kind::conjunction)) {
            for (const FormulaId operand : formula.operands) collect(operand, sign, clause);
        } else if (formula.kind == Formula::Kind::choice) {
            const std::vector<int>& values = features[formula.index];
            for (std::size_t value = 0; value < values.size(); ++value)
                if (formula.values.has(value) == sign) clause.push_back(values[value]);
        } else {
            clause.push_back(sign ? literal(open, id) : -literal(open, id));
        }
    }

    const Theory& theory_;
    const Scope& scope_;
};

}  // namespace

void compile_regions(const Theory& theory, const Scope& scope, const DiagramOptions& options, Layer& layer) {
    RegionClauses region(theory, scope);
    region.require_constraints();
    std::vector<int> concepts(theory.concepts.size(), 0);
    for (std::size_t id = 0; id < theory.concepts.size(); ++id)
        if (theory.concepts[id].level == Level::region && scope.concepts[id])
            concepts[id] = region.concept_literal(region.open, id);
    const auto is_in_scope = [&](const auto& self, FormulaId id) -> bool {
        const Formula& formula = theory.formulas[id];
        if (formula.kind == Formula::Kind::choice) return scope.features[formula.index] != 0;
        if (formula.kind == Formula::Kind::named) return scope.concepts[formula.index] != 0;
        return std::ranges::all_of(formula.operands, [&](FormulaId operand) { return self(self, operand); });
    };
    for (const Formula& formula : theory.formulas)
        if (formula.kind == Formula::Kind::parts && formula.part_level == Level::region &&
            is_in_scope(is_in_scope, formula.index))
            (void)region.literal(region.open, formula.index);
    std::vector<std::vector<int>> up_to(theory.feature_count());
    for (std::size_t f = theory.ranges.size(); f < theory.feature_count(); ++f)
        for (std::size_t value = 0; value < region.features[f].size(); ++value)
            up_to[f].push_back(region.clauses.any_of(std::span(region.features[f]).first(value + 1)));

    Space& space = layer.space;
    try {
        space.diagram = std::make_shared<const Diagram>(region.clauses, options);
    } catch (const OntologyError& too_large) {
        space.diagram = std::make_shared<const Diagram>(Diagram::sampled(region.clauses, too_large.what()));
    }
    const auto set = [&](int literal) { return ConfigurationSet(space.diagram, {literal}); };
    for (std::size_t f = 0; f < theory.feature_count(); ++f) {
        if (!scope.features[f]) continue;
        std::vector<ConfigurationSet>&holds = space.holds.emplace_back(), &prefixes = space.up_to.emplace_back();
        for (const int literal : region.features[f]) holds.push_back(set(literal));
        for (const int literal : up_to[f]) prefixes.push_back(set(literal));
    }
    layer.concepts.resize(theory.concepts.size());
    for (std::size_t id = 0; id < theory.concepts.size(); ++id) {
        if (concepts[id] != 0) layer.concepts[id] = set(concepts[id]);
    }
    while (space.holds.size() < space.variables.size()) {
        const int literal = concepts[static_cast<std::size_t>(theory.find(space.variables[space.holds.size()].iri))];
        space.holds.push_back({set(literal), set(-literal)});
    }
    space.up_to.resize(space.holds.size());
    layer.literals = region.open.literals;
    space.size = space.all().count();
}

std::vector<char> provable_regions(const Theory& theory, const Scope& scope) {
    constexpr int most_guesses = 64;  // never seen more than three; then we believe the definition
    RegionClauses region(theory, scope);
    region.require_constraints();
    std::vector<char> provable(theory.concepts.size(), 0);
    std::vector<int> concepts(theory.concepts.size(), 0);
    for (std::size_t id = 0; id < theory.concepts.size(); ++id)
        if (theory.concepts[id].level == Level::region) concepts[id] = region.concept_literal(region.open, id);
    Solver solver(region.clauses);
    const auto is_provable = [&](std::size_t id) {
        const int guard = region.clauses.add_variable();
        for (int guess = 0; guess < most_guesses; ++guess) {
            solver.add_new(region.clauses);
            if (solver.solve(std::vector{guard, concepts[id]}) == Verdict::unsatisfiable) return false;
            std::vector<int> counterexample{-concepts[id]};
            for (const std::vector<int>& values : region.features)
                for (const int value : values)
                    if (solver.value(std::abs(value)) == (value > 0)) counterexample.push_back(value);
            for (std::size_t other = 0; other < theory.concepts.size(); ++other)
                if (const int value = region.open.primitives[other]; value != 0 && theory.concepts[other].open)
                    counterexample.push_back(solver.value(value) ? value : -value);
            if (solver.solve(counterexample) == Verdict::unsatisfiable) return true;
            RegionClauses::Reading reading{region.open.primitives, std::vector<int>(theory.formulas.size(), 0)};
            for (std::size_t other = 0; other < theory.concepts.size(); ++other)
                if (int& primitive = reading.primitives[other]; primitive != 0 && !theory.concepts[other].open)
                    primitive = solver.value(primitive) ? region.clauses.always() : region.clauses.never();
            const int fine = region.constraints(reading), holds = region.concept_literal(reading, id);
            region.clauses.add({-guard, -fine, holds});
        }
        return theory.concepts[id].definition >= 0;
    };
    for (std::size_t id = 0; id < theory.concepts.size(); ++id)
        if (concepts[id] != 0) provable[id] = is_provable(id) ? 1 : 0;
    return provable;
}

}  // namespace partonomy::knowledge
