#include "knowledge/counted_parts.h"

#include <algorithm>

#include "knowledge/theory.h"

namespace partonomy::knowledge {
namespace {

using owl::ClassExpression;
using owl::ClassKind;

bool is_about_parts(const ClassExpression& expression) {
    return expression.property.iri == core_term("hasPart") ||
           std::ranges::any_of(expression.operands, [](const auto& each) { return is_about_parts(*each); });
}

void collect(const ClassExpression& expression, bool is_wanted, CountedParts& found) {
    if (expression.kind == ClassKind::complement_of) return collect(*expression.operands[0], !is_wanted, found);
    if (expression.kind == (is_wanted ? ClassKind::intersection_of : ClassKind::union_of)) {
        for (const owl::ClassPointer& each : expression.operands) collect(*each, is_wanted, found);
        return;
    }
    if (!is_about_parts(expression)) return;
    const std::uint32_t number = expression.kind == ClassKind::some_values_from ? 1 : expression.number;
    const bool is_min = expression.kind == ClassKind::some_values_from || expression.kind == ClassKind::min_cardinality;
    const bool is_max = expression.kind == ClassKind::max_cardinality;
    const bool is_exact = expression.kind == ClassKind::exact_cardinality && is_wanted;
    if ((!is_min && !is_max && !is_exact) || expression.property.inverse ||
        expression.property.iri != core_term("hasPart") || expression.operands[0]->kind != ClassKind::named) {
        found.is_all = false;
        return;
    }
    CountedPart part{expression.operands[0]->iri, {}, {}};
    if (is_exact || is_min == is_wanted) part.at_least = is_wanted ? number : number + 1;
    if (is_exact || is_max == is_wanted) {
        if (!is_wanted && number == 0) {  // fewer than none
            found.is_all = false;
            return;
        }
        part.at_most = is_wanted ? number : number - 1;
    }
    if (part.at_least == 0) part.at_least.reset();
    if (part.at_least || part.at_most) found.parts.push_back(part);
}

}  // namespace

CountedParts counted_parts(const owl::Ontology& ontology, const owl::Iri& iri) {
    CountedParts found;
    for (const owl::Axiom& axiom : ontology.axioms) {
        if (axiom.kind != owl::AxiomKind::equivalent_classes) continue;
        const auto is_it = [&](const owl::ClassPointer& each) {
            return each->kind == ClassKind::named && each->iri == iri;
        };
        if (std::ranges::none_of(axiom.classes, is_it)) continue;
        for (const owl::ClassPointer& each : axiom.classes)
            if (!is_it(each)) collect(*each, true, found);
        break;
    }
    return found;
}

}  // namespace partonomy::knowledge
