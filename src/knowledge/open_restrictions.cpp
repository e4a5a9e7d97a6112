/* Restrictions that are no questions.

   What a class expression says through a property that nothing measures (madeOf), through an inverse (inverse hasPart
   some Chair), of a named individual or of the thing itself is a yes or no that no algorithm can give. It becomes a
   concept without definition, one for each "at least k" and each layer, so that spaces hold both readings; the closed
   world of a mesh, in which every axiom has its full meaning, may tell later which one it is (mesh_world.h).

   Where properties are told to be below one another, one restriction implies the other: hasShape some Board implies
   hasFeature some Board, and hasLeg some X implies hasPart some X. These implications are constraints of the spaces, so
   that the planner asks what would prove them. */

#include <algorithm>

#include "base/errors.h"
#include "knowledge/ground.h"
#include "owl/make_class.h"

namespace partonomy::knowledge {
namespace {

using owl::Axiom;
using owl::AxiomKind;
using owl::ClassExpression;
using owl::ClassKind;
using owl::PropertyExpression;

owl::DataRange complement_of(const owl::DataRange& operand) {
    owl::DataRange result;
    result.kind = owl::DataRangeKind::complement_of;
    result.operands = {operand};
    return result;
}

bool is_data(ClassKind kind) { return kind >= ClassKind::data_some_values_from; }

/// The restriction "at least `count`".
ClassExpression at_least(ClassExpression restriction, unsigned count) {
    const bool data = is_data(restriction.kind);
    if (count == 1)
        restriction.kind = data ? ClassKind::data_some_values_from : ClassKind::some_values_from;
    else
        restriction.kind = data ? ClassKind::data_min_cardinality : ClassKind::min_cardinality;
    restriction.number = count == 1 ? 0 : count;
    return restriction;
}

}  // namespace

PropertyHierarchy::PropertyHierarchy(const owl::Ontology& ontology) {
    for (std::size_t i = 0; i < ontology.axioms.size(); ++i) {
        const Axiom& axiom = ontology.axioms[i];
        if ((axiom.kind != AxiomKind::sub_object_property_of && axiom.kind != AxiomKind::sub_data_property_of) ||
            axiom.properties.size() != 2)
            continue;
        const auto& [sub, super] = std::pair(axiom.properties[0], axiom.properties[1]);
        above_[sub].emplace_back(super, i);
        above_[{sub.iri, !sub.inverse}].emplace_back(PropertyExpression{super.iri, !super.inverse}, i);
    }
}

std::map<PropertyExpression, std::size_t> PropertyHierarchy::above(const PropertyExpression& property) const {
    std::map<PropertyExpression, std::size_t> found;
    std::vector<PropertyExpression> open{property};
    while (!open.empty()) {
        const auto supers = above_.find(open.back());
        open.pop_back();
        if (supers == above_.end()) continue;
        for (const auto& [super, axiom] : supers->second)
            if (super != property && found.emplace(super, axiom).second) open.push_back(super);
    }
    return found;
}

FormulaId Grounder::open(const ClassExpression& expression, Level level, const Axiom& axiom) {
    if (expression.number == UINT32_MAX) refuse(axiom, "the cardinality is too large", "write a smaller one");
    ClassExpression restriction = expression;
    if (restriction.operands.empty() && expression.kind >= ClassKind::min_cardinality && !is_data(expression.kind)) {
        restriction.operands = {owl::thing()};
    }
    const auto counted = [&](unsigned count) {
        return count == 0 ? 0 : open_atom(at_least(restriction, count), level, axiom);
    };
    switch (expression.kind) {
        case ClassKind::some_values_from:
        case ClassKind::data_some_values_from:
        case ClassKind::data_has_value:
            return counted(1);
        case ClassKind::all_values_from:
            restriction.operands = {complement_of(expression.operands[0])};
            return negate(counted(1));
        case ClassKind::data_all_values_from:
            restriction.range = complement_of(expression.range);
            return negate(counted(1));
        case ClassKind::min_cardinality:
        case ClassKind::data_min_cardinality:
            return counted(expression.number);
        case ClassKind::max_cardinality:
        case ClassKind::data_max_cardinality:
            return negate(counted(expression.number + 1));
        case ClassKind::exact_cardinality:
        case ClassKind::data_exact_cardinality:
            return conjoin({counted(expression.number), negate(counted(expression.number + 1))});
        default:
            return open_atom(restriction, level, axiom);
    }
}

FormulaId Grounder::open_atom(const ClassExpression& expression, Level level, const Axiom& axiom) {
    const auto [known, is_new] = open_atoms_.try_emplace({level, key_of(expression)}, 0);
    if (!is_new) return known->second;
    NamedConcept atom;
    const std::string number = std::to_string(open_atoms_.size());
    atom.iri = Iri(1, '~').append(number.size() < 8 ? 8 - number.size() : 0, '0').append(number);
    atom.level = level;
    atom.open = std::make_shared<const ClassExpression>(expression);
    theory_.concepts.push_back(std::move(atom));
    const FormulaId formula = known->second = named(static_cast<int>(theory_.concepts.size()) - 1);
    link(formula, expression, level, axiom);
    return formula;
}

void Grounder::link(FormulaId atom, const ClassExpression& expression, Level level, const Axiom& axiom) {
    if (hierarchy_.is_empty() || expression.property.iri.empty()) return;
    const auto with = [&](const PropertyExpression& property) {
        auto other = std::make_shared<ClassExpression>(expression);
        other->property = property;
        return other;
    };
    const auto implies = [&](FormulaId premise, FormulaId conclusion, std::size_t index) {
        const FormulaId formula = disjoin({negate(premise), conclusion});
        if (formula != 0) theory_.constraints.push_back({level, index, formula});
    };
    const auto above = hierarchy_.above(expression.property);
    for (const Iri& property : known_properties()) {
        const PropertyExpression known{property, false};
        if (const auto found = above.find(known); found != above.end())
            if (const std::optional<FormulaId> other = ground_if_possible(with(known), level, axiom))
                implies(atom, *other, found->second);
        const auto above_known = hierarchy_.above(known);
        if (const auto found = above_known.find(expression.property); found != above_known.end())
            if (const std::optional<FormulaId> other = ground_if_possible(with(known), level, axiom))
                implies(*other, atom, found->second);
    }
}

std::vector<Iri> Grounder::known_properties() const {
    std::vector<Iri> known{core_term("hasPart")};
    for (const RangeConcept& range : theory_.ranges) known.push_back(range.property);
    for (const MeasuredProperty& number : theory_.numbers) known.push_back(number.iri);
    return known;
}

std::optional<FormulaId> Grounder::ground_if_possible(const owl::ClassPointer& expression, Level level,
                                                      const Axiom& axiom) {
    const bool outside = outside_parts_;
    const std::size_t mentions = mentions_.size(), open = open_.size();
    try {
        outside_parts_ = false;  // nobody wrote it
        const FormulaId formula = ground(expression, level, axiom);
        outside_parts_ = outside;
        return formula;
    } catch (const OntologyError&) {
        outside_parts_ = outside;
        mentions_.resize(mentions);
        open_.resize(open);
        return std::nullopt;
    }
}

FormulaId Grounder::ground_within(const owl::ClassPointer& expression, Level level, const Axiom& axiom) {
    is_within_ = true;
    try {
        const FormulaId formula = ground(expression, level, axiom);
        is_within_ = false;
        return formula;
    } catch (...) {
        is_within_ = false;
        throw;
    }
}

}  // namespace partonomy::knowledge
