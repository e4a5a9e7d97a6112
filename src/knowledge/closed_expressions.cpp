/* Class expressions at individuals.

   Equal expressions are one (hash-consing, operands first), and the literal of an expression at an individual is made
   once, so that a definition used in a hundred places costs what one use costs. `some` is a disjunction over the
   individuals, `only` its dual, and a cardinality a counter (see clauses.cpp) whose inputs are the fillers: each of k
   individuals costs 3 clauses for the filler and about `number` for the count. When names may be equal, only the first
   of each set of equal names counts. */

#include <algorithm>

#include "knowledge/closed_grounder.h"
#include "owl/words.h"

namespace partonomy::knowledge::closed {

using owl::ClassExpression;
using owl::ClassKind;
using owl::ClassPointer;
using owl::Word;

namespace {

bool is_data(ClassKind kind) { return kind >= ClassKind::data_some_values_from; }

bool has_property(ClassKind kind) { return kind >= ClassKind::some_values_from; }

}  // namespace

Property Grounder::property_of(const owl::PropertyExpression& expression) {
    const Word word = owl::word_of(expression.iri);
    if (word == Word::owl_topObjectProperty) return {Property::top, false};
    if (word == Word::owl_bottomObjectProperty) return {Property::bottom, false};
    return {properties.add(expression.iri), expression.inverse};
}

int Grounder::intern(const ClassPointer& expression) {
    if (!is_collecting_) return intern(*expression);
    const auto found = pointer_ids_.find(expression.get());
    if (found != pointer_ids_.end()) return found->second;
    const int id = intern(*expression);
    pointer_ids_[expression.get()] = id;
    return id;
}

int Grounder::intern(const ClassExpression& expression) {
    Expression made{};
    made.kind = expression.kind;
    if (expression.kind == ClassKind::named) {
        const Word word = owl::word_of(expression.iri);
        made.name = word == Word::owl_Thing     ? everything
                    : word == Word::owl_Nothing ? nothing
                                                : classes.add(expression.iri);
    } else if (is_data(expression.kind)) {
        made.name = data_property_of(expression.property);
        made.range = range_id(expression.range);
    } else if (has_property(expression.kind)) {
        made.property = property_of(expression.property);
    }
    made.number = expression.number;
    for (const ClassPointer& operand : expression.operands) made.operands.push_back(intern(operand));
    for (const Iri& individual : expression.individuals) {
        const auto known = individuals.ids.find(individual);
        if (known == individuals.ids.end() && !is_collecting_)
            throw CannotGround{owl::short_name(individual) +
                               " is no individual of this closed world; name one of its individuals"};
        made.individuals.push_back(individuals.add(individual));
    }
    if (made.kind == ClassKind::intersection_of || made.kind == ClassKind::union_of) make_set(made.operands, 0);
    make_set(made.individuals, 0);

    std::vector<std::int64_t> key{static_cast<int>(made.kind),
                                  made.name,
                                  made.property.id,
                                  made.property.inverse,
                                  made.number,
                                  made.range,
                                  static_cast<int>(made.operands.size())};
    key.insert(key.end(), made.operands.begin(), made.operands.end());
    key.insert(key.end(), made.individuals.begin(), made.individuals.end());
    const auto [found, is_new] = expression_ids_.try_emplace(std::move(key), static_cast<int>(expressions_.size()));
    if (is_new) {
        if (is_data(made.kind)) collect_restriction(made);
        expressions_.push_back(std::move(made));
    }
    return found->second;
}

int Grounder::holds(int expression, int individual) {
    const auto id = static_cast<std::size_t>(expression);
    const auto at = static_cast<std::size_t>(individual);
    std::vector<int>& literals = expressions_[id].literals;
    if (literals.empty()) literals.assign(static_cast<std::size_t>(count_), 0);
    if (literals[at] != 0) return literals[at];
    const int literal = make_literal(expressions_[id], individual);
    expect_clauses(0);
    return expressions_[id].literals[at] = literal;
}

int Grounder::some_related(Property property, int filler, int individual) {
    std::vector<int> witnesses;
    for (const int other : candidates(property, individual))
        witnesses.push_back(clauses.all_of({property_atom(property, individual, other), holds(filler, other)}));
    return clauses.any_of(witnesses);
}

int Grounder::at_least_related(Property property, int filler, int individual, std::uint64_t count) {
    if (count == 0) return always_;
    if (count > static_cast<std::uint64_t>(count_)) return -always_;
    if (count == 1) return some_related(property, filler, individual);
    std::vector<int> witnesses;
    for (const int other : candidates(property, individual))
        witnesses.push_back(
            clauses.all_of({property_atom(property, individual, other), holds(filler, other), is_first(other)}));
    return clauses.at_least(witnesses, static_cast<unsigned>(count));
}

int Grounder::make_literal(const Expression& expression, int individual) {
    const auto operands = [&] {
        std::vector<int> literals;
        for (const int operand : expression.operands) literals.push_back(holds(operand, individual));
        return literals;
    };
    const std::uint64_t number = expression.number;
    switch (expression.kind) {
        case ClassKind::named:
            return class_atom(expression.name, individual);
        case ClassKind::intersection_of:
            return clauses.all_of(operands());
        case ClassKind::union_of:
            return clauses.any_of(operands());
        case ClassKind::complement_of:
            return -holds(expression.operands[0], individual);
        case ClassKind::one_of: {
            std::vector<int> literals;
            for (const int other : expression.individuals) literals.push_back(equality(individual, other));
            return clauses.any_of(literals);
        }
        case ClassKind::some_values_from:
            return some_related(expression.property, expression.operands[0], individual);
        case ClassKind::all_values_from: {
            std::vector<int> literals;
            for (const int other : candidates(expression.property, individual))
                literals.push_back(clauses.any_of(
                    {-property_atom(expression.property, individual, other), holds(expression.operands[0], other)}));
            return clauses.all_of(literals);
        }
        case ClassKind::has_value:
            return property_atom(expression.property, individual, expression.individuals[0]);
        case ClassKind::has_self:
            return property_atom(expression.property, individual, individual);
        case ClassKind::min_cardinality:
            return at_least_related(expression.property, expression.operands[0], individual, number);
        case ClassKind::max_cardinality:
            return -at_least_related(expression.property, expression.operands[0], individual, number + 1);
        case ClassKind::exact_cardinality:
            return clauses.all_of(
                {at_least_related(expression.property, expression.operands[0], individual, number),
                 -at_least_related(expression.property, expression.operands[0], individual, number + 1)});
        case ClassKind::data_some_values_from:
            return some_value(expression.name, individual, expression.range);
        case ClassKind::data_all_values_from:
            return -some_value(expression.name, individual, complement_id(expression.range));
        case ClassKind::data_has_value:
            return some_value(expression.name, individual, expression.range);
        case ClassKind::data_min_cardinality:
            return at_least_values(expression.name, individual, expression.range, number);
        case ClassKind::data_max_cardinality:
            return -at_least_values(expression.name, individual, expression.range, number + 1);
        case ClassKind::data_exact_cardinality:
            return clauses.all_of({at_least_values(expression.name, individual, expression.range, number),
                                   -at_least_values(expression.name, individual, expression.range, number + 1)});
    }
    return -always_;
}

}  // namespace partonomy::knowledge::closed
