#include "knowledge/mesh_words.h"

#include <algorithm>

#include "knowledge/assembly.h"
#include "knowledge/closed_world.h"
#include "knowledge/mesh_world.h"
#include "owl/make_class.h"
#include "owl/words.h"

// A closed world has one kind of things, where a domain's axioms are about regions, composite parts or the object. So
// each axiom is confined to its layer, hasPart to the layer that its filler is about, and restrictions on relations
// between regions become classes of which a region is told to be a member or not. Numbers are doubles here, whatever
// datatype the axioms wrote: spaces compare them as numbers.

namespace partonomy::knowledge {

using owl::Axiom;
using owl::AxiomKind;
using owl::ClassExpression;
using owl::ClassKind;
using owl::ClassPointer;

namespace {

owl::DataRange doubles(owl::DataRange range) {
    const Iri xsd_double = std::string(owl::xsd_prefix) + "double";
    if (range.kind == owl::DataRangeKind::datatype) range.datatype = xsd_double;
    for (auto& [facet, literal] : range.facets) literal.datatype = xsd_double;
    for (owl::Literal& value : range.values) value.datatype = xsd_double;
    for (owl::DataRange& operand : range.operands) operand = doubles(operand);
    return range;
}

}  // namespace

Iri relation_class(std::size_t index) { return mesh_prefix + std::string("relation") + std::to_string(index + 1); }

Iri mesh_class() { return mesh_prefix + std::string("Mesh"); }

Iri group_class(int group) { return mesh_prefix + std::string("group") + std::to_string(group + 1); }

MeshWords::MeshWords(const Domain& domain, const owl::Ontology& plain)
    : theory_(domain.grounding->theory), ranges_(domain.ranges), levels_(find_levels(plain, domain.ranges)) {
    for (const Iri& iri : individuals_of(plain)) has_strangers_ |= !levels_.contains(iri);
    for (const MeasuredProperty& number : domain.numbers) numbers_.insert(number.iri);
    for (std::size_t i = 0; i < domain.relational.size(); ++i)
        relational_.emplace(key_of(*domain.relational[i].as_written), i);
}

ClassPointer MeshWords::operator()(const ClassPointer& expression) const {
    if (const auto counted = as_relation(*expression)) return *counted;
    auto result = std::make_shared<ClassExpression>(*expression);
    for (ClassPointer& operand : result->operands) operand = (*this)(operand);
    if (is_data(result->kind) && numbers_.contains(result->property.iri)) result->range = doubles(result->range);
    if (!theory_.groups.empty() && result->property == owl::PropertyExpression{core_term("hasPart"), false})
        look_at_one_layer(*result, expression);
    return result;
}

Axiom MeshWords::operator()(Axiom axiom) const {
    const Level level = level_of_axiom(axiom);
    const bool is_implication = axiom.kind == AxiomKind::sub_class_of;
    const int group = group_of(axiom);
    for (ClassPointer& expression : axiom.classes) {
        const bool is_conclusion = is_implication && &expression != &axiom.classes[0];
        expression = (*this)(expression);
        if (axiom.kind <= AxiomKind::disjoint_union && !is_conclusion) expression = within(level, group, expression);
    }
    if (axiom.kind == AxiomKind::data_property_range && numbers_.contains(axiom.properties[0].iri))
        axiom.range = doubles(axiom.range);
    return axiom;
}

Level MeshWords::level_of_axiom(const Axiom& axiom) const { return level_of_all(axiom.classes, levels_, ranges_); }

/// What is a composite part of a kind is one of the groups that the kind speaks of.
int MeshWords::group_of(const Axiom& axiom) const {
    for (const ClassPointer& expression : axiom.classes)
        if (expression->kind == ClassKind::named)
            if (const int id = theory_.find(expression->iri);
                id >= 0 && theory_.concepts[static_cast<std::size_t>(id)].group >= 0)
                return theory_.concepts[static_cast<std::size_t>(id)].group;
    return -1;
}

/// hasPart leads to regions and to composite parts; a class behind it is about the ones or about the others.
void MeshWords::look_at_one_layer(ClassExpression& result, const ClassPointer& as_written) const {
    if (result.kind == ClassKind::has_value || result.kind == ClassKind::has_self) return;
    const ClassPointer filler = result.operands.empty() ? owl::thing() : result.operands[0];
    const ClassPointer told = as_written->operands.empty() ? owl::thing() : as_written->operands[0];
    const Level level = level_of(*told, levels_, ranges_);
    const bool is_composite = level == Level::composite || level == Level::whole;
    const ClassPointer top = owl::named_class(core_term(is_composite ? "CompositePart" : "Region"));
    const bool is_only = result.kind == ClassKind::all_values_from;
    result.operands = {owl::combined(is_only ? ClassKind::union_of : ClassKind::intersection_of,
                                     {is_only ? owl::complement_of(top) : top, filler})};
}

/// An axiom about regions is about nothing else, and so is one about objects: "not (hasShape some Board) SubClassOf
/// …" does not mean the object, though that has no shape; and neither means another object that the ontology names,
/// of whose parts nothing is known.
ClassPointer MeshWords::within(Level level, int group, const ClassPointer& expression) const {
    if (level <= Level::relation) return expression;
    if (group >= 0 && expression->kind != ClassKind::named)
        return owl::combined(ClassKind::intersection_of, {owl::named_class(group_class(group)), expression});
    if (has_strangers_) return owl::combined(ClassKind::intersection_of, {owl::named_class(mesh_class()), expression});
    if (expression->kind == ClassKind::named && !is_thing(expression->iri)) return expression;
    const char* const top = level == Level::region ? "Region" : level == Level::composite ? "CompositePart" : "Object";
    return owl::combined(ClassKind::intersection_of, {owl::named_class(core_term(top)), expression});
}

/// A restriction that became features of a region (ground_relations.cpp) in terms of these.
std::optional<ClassPointer> MeshWords::as_relation(const ClassExpression& expression) const {
    if (relational_.empty() || expression.property.inverse || is_data(expression.kind) ||
        expression.kind < ClassKind::some_values_from ||
        (!is_core_term(expression.property.iri, "isTargetRegion") &&
         !is_core_term(expression.property.iri, "isReferenceRegion")))
        return std::nullopt;
    ClassPointer filler = expression.operands.empty()                     ? owl::thing()
                          : expression.kind == ClassKind::all_values_from ? owl::complement_of(expression.operands[0])
                                                                          : expression.operands[0];
    bool is_known = true;
    const auto at_least = [&](unsigned count) {
        ClassExpression asked;
        asked.kind = count == 1 ? ClassKind::some_values_from : ClassKind::min_cardinality;
        asked.property = expression.property;
        asked.number = count == 1 ? 0 : count;
        asked.operands = {filler};
        const auto found = relational_.find(key_of(asked));
        if (count == 0) return owl::thing();
        is_known &= found != relational_.end();
        return found == relational_.end() ? filler : owl::named_class(relation_class(found->second));
    };
    ClassPointer result;
    switch (expression.kind) {
        case ClassKind::some_values_from:
            result = at_least(1);
            break;
        case ClassKind::all_values_from:
            result = owl::complement_of(at_least(1));
            break;
        case ClassKind::min_cardinality:
            result = at_least(expression.number);
            break;
        case ClassKind::max_cardinality:
            result = owl::complement_of(at_least(expression.number + 1));
            break;
        case ClassKind::exact_cardinality:
            result = owl::combined(ClassKind::intersection_of,
                                   {at_least(expression.number), owl::complement_of(at_least(expression.number + 1))});
            break;
        default:
            return std::nullopt;
    }
    return is_known ? std::optional(result) : std::nullopt;
}

}  // namespace partonomy::knowledge
