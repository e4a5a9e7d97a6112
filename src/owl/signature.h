#pragma once

#include "owl/ontology.h"

namespace partonomy::owl {

/// Calls `visit(iri)` for each class and property that an expression names, in order, repeated ones too.
void for_each_name(const ClassExpression& expression, auto&& visit) {
    if (!expression.iri.empty()) visit(expression.iri);
    if (!expression.property.iri.empty()) visit(expression.property.iri);
    for (const ClassPointer& operand : expression.operands) for_each_name(*operand, visit);
}

/// The same for an axiom, rules included.
void for_each_name(const Axiom& axiom, auto&& visit) {
    for (const ClassPointer& expression : axiom.classes) for_each_name(*expression, visit);
    for (const PropertyExpression& property : axiom.properties) visit(property.iri);
    if (!axiom.rule) return;
    for (const auto* atoms : {&axiom.rule->body, &axiom.rule->head})
        for (const RuleAtom& atom : *atoms) {
            if (atom.klass) for_each_name(*atom.klass, visit);
            if (!atom.property.iri.empty()) visit(atom.property.iri);
        }
}

}  // namespace partonomy::owl
