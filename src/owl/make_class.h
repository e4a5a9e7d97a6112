#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "owl/ontology.h"
#include "owl/words.h"

// Class expressions made by hand, where axioms are put into other words.

namespace partonomy::owl {

[[nodiscard]] inline ClassPointer named_class(Iri iri) {
    auto expression = std::make_shared<ClassExpression>();
    expression->iri = std::move(iri);
    return expression;
}

/// owl:Thing.
[[nodiscard]] inline ClassPointer thing() { return named_class(std::string(owl_prefix) + "Thing"); }

[[nodiscard]] inline ClassPointer complement_of(ClassPointer operand) {
    auto expression = std::make_shared<ClassExpression>();
    expression->kind = ClassKind::complement_of;
    expression->operands = {std::move(operand)};
    return expression;
}

/// Union or intersection; one operand stands for itself. At least one.
[[nodiscard]] inline ClassPointer combined(ClassKind kind, std::vector<ClassPointer> operands) {
    if (operands.size() == 1) return operands[0];
    auto expression = std::make_shared<ClassExpression>();
    expression->kind = kind;
    expression->operands = std::move(operands);
    return expression;
}

}  // namespace partonomy::owl
