#pragma once

#include <vector>

#include "knowledge/clauses.h"
#include "knowledge/theory.h"

namespace partonomy::knowledge {

/// The literal that is true exactly when the formula is, from those that the caller has for what it is made of:
/// `literal(FormulaId)`, `values(feature)` with one literal for each value, `concept_literal(concept)` and
/// `parts(formula)`.
template <typename Literal, typename Values, typename ConceptLiteral, typename PartsLiteral>
[[nodiscard]] int formula_literal(Clauses& clauses, const Formula& formula, const Literal& literal,
                                  const Values& values, const ConceptLiteral& concept_literal,
                                  const PartsLiteral& parts) {
    std::vector<int> operands;
    for (const FormulaId operand : formula.operands) operands.push_back(literal(operand));
    switch (formula.kind) {
        case Formula::Kind::truth:
            return clauses.always();
        case Formula::Kind::falsity:
            return clauses.never();
        case Formula::Kind::conjunction:
            return clauses.all_of(operands);
        case Formula::Kind::disjunction:
            return clauses.any_of(operands);
        case Formula::Kind::negation:
            return -operands[0];
        case Formula::Kind::choice: {
            const std::vector<int>& each = values(static_cast<std::size_t>(formula.index));
            formula.values.for_each([&](std::size_t value) { operands.push_back(each[value]); });
            return clauses.any_of(operands);
        }
        case Formula::Kind::named:
            return concept_literal(formula.index);
        case Formula::Kind::parts:
            break;
    }
    return parts(formula);
}

}  // namespace partonomy::knowledge
