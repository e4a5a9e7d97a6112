#include <algorithm>
#include <charconv>
#include <limits>

#include "base/errors.h"
#include "knowledge/relations.h"
#include "knowledge/theory.h"

// A layer starts as the Cartesian product of its variables (paper §3.2.3, Fig. 5), one bit per combination: the first
// variable varies slowest, so the bits of "variable v has value k" are runs of equal length. Every concept is then
// evaluated with one sweep of word operations per node of its definition, the constraints are met, and what violates
// them is packed away. Cost: (formula nodes) x (product / 64) word operations; furniture has a product of 288 and so 5
// words. A product beyond the listing limit is not listed but compiled (compiled_space.cpp).

namespace partonomy::knowledge {
namespace {

/// Product that stays at the largest number instead of running over.
std::size_t times(std::size_t a, std::size_t b) {
    return b != 0 && a > std::numeric_limits<std::size_t>::max() / b ? std::numeric_limits<std::size_t>::max() : a * b;
}

std::string to_words(double x) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr};
}

std::string to_words(const MeasuredProperty::Interval& interval) {
    const bool has_low = interval.low != -std::numeric_limits<double>::infinity();
    const bool has_high = interval.high != std::numeric_limits<double>::infinity();
    if (has_low && interval.low == interval.high) return "= " + to_words(interval.low);
    std::string words;
    if (has_low) words = (interval.low_closed ? ">= " : "> ") + to_words(interval.low);
    if (has_high)
        words += (has_low ? ", " : "") + std::string(interval.high_closed ? "<= " : "< ") + to_words(interval.high);
    return words;
}

Variable feature_variable(const Theory& theory, std::size_t feature) {
    Variable variable{};
    if (feature < theory.ranges.size()) {
        const RangeConcept& range = theory.ranges[feature];
        variable.kind = VariableKind::range;
        variable.iri = range.iri;
        variable.index = static_cast<int>(feature);
        for (const ElementaryConcept& value : range.values) variable.values.push_back(owl::local_name(value.iri));
        if (!range.covered) variable.values.emplace_back("other");
    } else if (feature >= theory.ranges.size() + theory.numbers.size()) {
        const std::size_t index = feature - theory.ranges.size() - theory.numbers.size();
        const RelationalFeature& relational = theory.relational[index];
        variable.kind = VariableKind::relation;
        variable.index = static_cast<int>(index);
        variable.values = {"yes", "no"};
        variable.part_class = relational.as_written;
        variable.threshold = relational.threshold;
        for (std::size_t r = 0; r < theory.relations.size(); ++r)
            if (theory.relations[r].criteria.empty() && may_pass(relational.test, theory.relations, r))
                variable.answerable = false;
    } else {
        const std::size_t number = feature - theory.ranges.size();
        variable.kind = VariableKind::number;
        variable.iri = theory.numbers[number].iri;
        variable.index = static_cast<int>(number);
        variable.answerable = !theory.numbers[number].measure.empty();
        for (const auto& interval : theory.numbers[number].intervals) variable.values.push_back(to_words(interval));
    }
    return variable;
}

}  // namespace

Scope whole_scope(const Theory& theory, std::size_t axiom_count) {
    return {std::vector<char>(axiom_count, 1), std::vector<char>(theory.concepts.size(), 1),
            std::vector<char>(theory.feature_count(), 1)};
}

Scope cone(const Theory& theory, int goal, std::vector<char> axioms, bool all_features) {
    Scope scope{std::move(axioms), std::vector<char>(theory.concepts.size(), 0),
                std::vector<char>(theory.feature_count(), all_features ? 1 : 0)};
    const auto visit = [&](const auto& self, FormulaId id) -> void {
        const Formula& formula = theory.formulas[id];
        if (formula.kind == Formula::Kind::choice) scope.features[formula.index] = 1;
        if (formula.kind == Formula::Kind::parts) self(self, formula.index);
        for (const FormulaId operand : formula.operands) self(self, operand);
        if (formula.kind != Formula::Kind::named || scope.concepts[formula.index]) return;
        scope.concepts[formula.index] = 1;
        const NamedConcept& named = theory.concepts[formula.index];
        if (named.definition >= 0 && scope.axioms[named.axiom]) self(self, named.definition);
        if (named.group < 0) return;  // what its groups are made of does not hang on the axioms that are kept
        self(self, theory.groups[static_cast<std::size_t>(named.group)].regions);
        self(self, theory.groups[static_cast<std::size_t>(named.group)].composites);
    };
    if (goal >= 0) {
        scope.concepts[goal] = 1;
        const NamedConcept& named = theory.concepts[goal];
        if (named.definition >= 0 && scope.axioms[named.axiom]) visit(visit, named.definition);
        if (named.group >= 0) {
            visit(visit, theory.groups[static_cast<std::size_t>(named.group)].regions);
            visit(visit, theory.groups[static_cast<std::size_t>(named.group)].composites);
        }
    }
    for (const Constraint& constraint : theory.constraints)
        if (scope.axioms[constraint.axiom]) visit(visit, constraint.formula);
    return scope;
}

ConfigurationSet evaluate(const Theory& theory, const Layer& layer, FormulaId id) {
    if (layer.space.diagram) return ConfigurationSet(layer.space.diagram, {layer.literals[id]});
    const Formula& formula = theory.formulas[id];
    const std::size_t size = layer.space.size;
    switch (formula.kind) {
        case Formula::Kind::truth:
            return ConfigurationSet(size, true);
        case Formula::Kind::falsity:
            return ConfigurationSet(size);
        case Formula::Kind::conjunction: {
            ConfigurationSet result = evaluate(theory, layer, formula.operands[0]);
            for (std::size_t i = 1; i < formula.operands.size(); ++i)
                result &= evaluate(theory, layer, formula.operands[i]);
            return result;
        }
        case Formula::Kind::disjunction: {
            ConfigurationSet result = evaluate(theory, layer, formula.operands[0]);
            for (std::size_t i = 1; i < formula.operands.size(); ++i)
                result |= evaluate(theory, layer, formula.operands[i]);
            return result;
        }
        case Formula::Kind::negation:
            return evaluate(theory, layer, formula.operands[0]).complement();
        case Formula::Kind::choice: {
            ConfigurationSet result(size);
            const auto& holds = layer.space.holds[layer.features[formula.index]];
            formula.values.for_each([&](std::size_t value) { result |= holds[value]; });
            return result;
        }
        case Formula::Kind::named:
            return layer.concepts[formula.index];
        case Formula::Kind::parts:
            break;
    }
    return layer.atoms[id] < 0 ? ConfigurationSet(size) : layer.space.holds[layer.atoms[id]][0];
}

std::size_t add_primitives(const Theory& theory, const Scope& scope, Subject subject, Layer& layer) {
    std::size_t added = 0;
    layer.primitives.assign(theory.concepts.size(), -1);
    for (const VariableKind kind : {VariableKind::open, VariableKind::primitive})
        for (std::size_t id = 0; id < theory.concepts.size(); ++id) {
            const NamedConcept& named = theory.concepts[id];
            if (!subject.has(named) || !scope.concepts[id]) continue;
            if (named.definition >= 0 && scope.axioms[named.axiom]) continue;
            if ((named.open != nullptr) != (kind == VariableKind::open)) continue;
            Variable variable{};
            variable.kind = kind;
            variable.iri = named.iri;
            variable.values = {"yes", "no"};
            variable.part_class = named.open;
            variable.answerable = false;
            layer.primitives[id] = static_cast<int>(layer.space.variables.size());
            layer.space.variables.push_back(std::move(variable));
            ++added;
        }
    return added;
}

ConfigurationSet close_layer(const Theory& theory, const Scope& scope, Subject subject, Layer& layer) {
    layer.concepts.assign(theory.concepts.size(), {});
    std::vector<char> done(theory.concepts.size(), 0);
    const auto settle = [&](const auto& self, std::size_t id) -> void {
        const NamedConcept& named = theory.concepts[id];
        if (done[id] || named.level != subject.level || !scope.concepts[id]) return;
        done[id] = 1;
        if (!subject.has(named)) {
            layer.concepts[id] = ConfigurationSet(layer.space.size);
            return;
        }
        if (layer.primitives[id] >= 0) {
            layer.concepts[id] = layer.space.holds[layer.primitives[id]][0];
            return;
        }
        const auto descend = [&](const auto& down, FormulaId f) -> void {
            const Formula& formula = theory.formulas[f];
            if (formula.kind == Formula::Kind::named) self(self, static_cast<std::size_t>(formula.index));
            for (const FormulaId operand : formula.operands) down(down, operand);
        };
        descend(descend, named.definition);
        layer.concepts[id] = evaluate(theory, layer, named.definition);
    };
    for (std::size_t id = 0; id < theory.concepts.size(); ++id) settle(settle, id);

    ConfigurationSet allowed = layer.space.all();
    for (const Constraint& constraint : theory.constraints)
        if (constraint.level == subject.level && scope.axioms[constraint.axiom])
            allowed &= evaluate(theory, layer, constraint.formula);
    const std::size_t count = allowed.count();
    if (count == layer.space.size) return allowed;
    for (auto& values : layer.space.holds)
        for (ConfigurationSet& set : values) set = set.packed(allowed);
    for (ConfigurationSet& set : layer.concepts)
        if (set.size() == layer.space.size) set = set.packed(allowed);
    layer.space.size = count;
    return allowed;
}

Layer build_regions(const Theory& theory, const Scope& scope, const CompileOptions& options) {
    Layer layer;
    Space& space = layer.space;
    layer.features.assign(theory.feature_count(), -1);
    for (std::size_t f = 0; f < theory.feature_count(); ++f) {
        if (!scope.features[f]) continue;
        layer.features[f] = static_cast<int>(space.variables.size());
        space.variables.push_back(feature_variable(theory, f));
    }
    add_primitives(theory, scope, {Level::region, -1}, layer);
    space.product = 1;
    for (const Variable& variable : space.variables) space.product = times(space.product, variable.values.size());
    if (space.product > options.listing_limit) {
        compile_regions(theory, scope, options.diagram, layer);
        return layer;
    }
    space.size = space.product;
    std::size_t run = space.size;
    for (const Variable& variable : space.variables) {
        const std::size_t period = run;
        run /= variable.values.size();
        std::vector<ConfigurationSet> holds;
        for (std::size_t value = 0; value < variable.values.size(); ++value)
            holds.push_back(ConfigurationSet::every(space.size, value * run, run, period));
        space.holds.push_back(std::move(holds));
    }
    close_layer(theory, scope, {Level::region, -1}, layer);
    return layer;
}

}  // namespace partonomy::knowledge
