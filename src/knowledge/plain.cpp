/* One name for each thing.

   Equivalent and inverse properties form a forest: each property has a parent and says whether it is the parent's
   inverse, so the way to the root tells what a property is called and whether it is turned round (union-find with
   parity). Everything else is a walk over class expressions that copies only what changes. */

#include "knowledge/plain.h"

#include <algorithm>
#include <map>
#include <set>

#include "knowledge/theory.h"
#include "knowledge/unused_features.h"
#include "owl/make_class.h"
#include "owl/signature.h"

namespace partonomy::knowledge {
namespace {

using owl::Axiom;
using owl::AxiomKind;
using owl::ClassExpression;
using owl::ClassKind;
using owl::ClassPointer;
using owl::PropertyExpression;

class PropertyNames {
public:
    explicit PropertyNames(const owl::Ontology& ontology) {
        for (const Axiom& axiom : ontology.axioms) {
            const bool is_inverse = axiom.kind == AxiomKind::inverse_object_properties;
            if (!is_inverse && axiom.kind != AxiomKind::equivalent_object_properties &&
                axiom.kind != AxiomKind::equivalent_data_properties)
                continue;
            for (std::size_t i = 1; i < axiom.properties.size(); ++i)
                unite(axiom.properties[i - 1], axiom.properties[i], is_inverse);
        }
    }

    [[nodiscard]] bool is_empty() const { return parents_.empty(); }

    [[nodiscard]] PropertyExpression operator()(PropertyExpression property) const {
        for (auto up = parents_.find(property.iri); up != parents_.end(); up = parents_.find(property.iri))
            property = {up->second.iri, up->second.inverse != property.inverse};
        return property;
    }

private:
    void unite(const PropertyExpression& a, const PropertyExpression& b, bool is_inverse) {
        PropertyExpression x = (*this)(a), y = (*this)(b);
        if (x.iri == y.iri) return;  // said already; or a property that is its own inverse, which no name can say
        if (!is_core(x.iri) && (is_core(y.iri) || y.iri < x.iri)) std::swap(x, y);
        if (is_core(y.iri)) return;  // two properties of core keep their names
        parents_[y.iri] = {x.iri, (x.inverse != y.inverse) != is_inverse};
    }
    [[nodiscard]] static bool is_core(const Iri& iri) { return iri.starts_with(owl::core_prefix); }

    std::map<Iri, PropertyExpression> parents_;
};

class Plainer {
public:
    explicit Plainer(const owl::Ontology& ontology) : ontology_(ontology), names_(ontology) {
        for (const Axiom& axiom : ontology.axioms)
            if (axiom.kind == AxiomKind::datatype_definition) datatypes_.emplace(axiom.datatype, &axiom.range);
        for (const auto& [value, range] : value_individuals(ontology)) values_.insert(value);
    }

    [[nodiscard]] bool has_nothing_to_do() const {
        return names_.is_empty() && datatypes_.empty() && values_.empty() &&
               std::ranges::none_of(ontology_.axioms, [](const Axiom& axiom) { return axiom.kind == AxiomKind::rule; });
    }

    [[nodiscard]] Axiom plain(Axiom axiom) const {
        if (axiom.kind == AxiomKind::rule) {
            const auto rolled = roll_up(*axiom.rule, [&](const Iri& property) { return is_measured(property); });
            if (!rolled) return axiom;
            axiom.kind = AxiomKind::sub_class_of;
            axiom.classes = {rolled->first, rolled->second};
            axiom.rule = nullptr;
        }
        for (ClassPointer& expression : axiom.classes) expression = plain(expression);
        axiom.range = plain(axiom.range);
        for (PropertyExpression& property : axiom.properties) property = names_(property);
        if (axiom.kind == AxiomKind::class_assertion && values_.contains(axiom.individuals[0])) {
            axiom.kind = AxiomKind::sub_class_of;
            axiom.classes = {owl::named_class(axiom.individuals[0]), axiom.classes[0]};
            axiom.individuals.clear();
        }
        if (!axiom.properties.empty() && axiom.properties[0].inverse) turn_round(axiom);
        return axiom;
    }

private:
    /// What is said of an inverse is said of the property itself, the other way round.
    static void turn_round(Axiom& axiom) {
        switch (axiom.kind) {
            case AxiomKind::object_property_domain:
                axiom.kind = AxiomKind::object_property_range;
                break;
            case AxiomKind::object_property_range:
                axiom.kind = AxiomKind::object_property_domain;
                break;
            case AxiomKind::functional_object_property:
                axiom.kind = AxiomKind::inverse_functional_object_property;
                break;
            case AxiomKind::inverse_functional_object_property:
                axiom.kind = AxiomKind::functional_object_property;
                break;
            case AxiomKind::object_property_assertion:
            case AxiomKind::negative_object_property_assertion:
                std::swap(axiom.individuals[0], axiom.individuals[1]);
                break;
            case AxiomKind::sub_object_property_of:
                if (axiom.properties.size() != 2) return;
                axiom.properties[1].inverse = !axiom.properties[1].inverse;
                break;
            case AxiomKind::symmetric_object_property:
            case AxiomKind::asymmetric_object_property:
            case AxiomKind::transitive_object_property:
            case AxiomKind::reflexive_object_property:
            case AxiomKind::irreflexive_object_property:
                break;
            default:
                return;
        }
        axiom.properties[0].inverse = false;
    }

    [[nodiscard]] bool is_measured(const Iri& property) const {
        const auto found = ontology_.annotations.find(names_({property, false}).iri);
        return found != ontology_.annotations.end() &&
               std::ranges::any_of(found->second, [](const owl::Annotation& annotation) {
                   return is_core_term(annotation.property, "measure");
               });
    }

    [[nodiscard]] owl::DataRange plain(const owl::DataRange& range, int depth = 0) const {
        const auto definition = range.kind == owl::DataRangeKind::datatype && range.facets.empty()
                                    ? datatypes_.find(range.datatype)
                                    : datatypes_.end();
        if (definition != datatypes_.end() && depth < 100) return plain(*definition->second, depth + 1);
        owl::DataRange result = range;
        for (owl::DataRange& operand : result.operands) operand = plain(operand, depth);
        return result;
    }

    [[nodiscard]] ClassPointer plain(const ClassPointer& expression) const {
        ClassExpression result = *expression;
        bool is_new = false;
        for (ClassPointer& operand : result.operands) {
            ClassPointer other = plain(operand);
            is_new |= other != operand;
            operand = std::move(other);
        }
        result.property = names_(expression->property);
        is_new |= result.property != expression->property;
        if (result.kind >= ClassKind::data_some_values_from) {
            result.range = plain(expression->range);
            is_new |= result.range != expression->range;
        }
        const bool are_values =
            !values_.empty() && !result.individuals.empty() &&
            std::ranges::all_of(result.individuals, [&](const Iri& iri) { return values_.contains(iri); });
        if (are_values && result.kind == ClassKind::has_value) {
            result.kind = ClassKind::some_values_from;
            result.operands = {owl::named_class(result.individuals[0])};
            result.individuals.clear();
            is_new = true;
        } else if (are_values && result.kind == ClassKind::one_of) {
            if (result.individuals.size() == 1) return owl::named_class(result.individuals[0]);
            result.kind = ClassKind::union_of;
            for (const Iri& iri : result.individuals) result.operands.push_back(owl::named_class(iri));
            result.individuals.clear();
            is_new = true;
        }
        return is_new ? std::make_shared<const ClassExpression>(std::move(result)) : expression;
    }

    const owl::Ontology& ontology_;
    PropertyNames names_;
    std::map<Iri, const owl::DataRange*> datatypes_;
    std::set<Iri> values_;
};

/// Classes that a functional property leads to, below core:Feature.
std::set<Iri> ranges_of_features(const owl::Ontology& ontology) {
    std::set<Iri> below{core_term("Feature")}, functional, ranges;
    for (bool grown = true; grown;) {
        grown = false;
        for (const Axiom& axiom : ontology.axioms)
            if (axiom.kind == AxiomKind::sub_class_of && axiom.classes[0]->kind == ClassKind::named &&
                axiom.classes[1]->kind == ClassKind::named && below.contains(axiom.classes[1]->iri))
                grown |= below.insert(axiom.classes[0]->iri).second;
    }
    for (const Axiom& axiom : ontology.axioms)
        if (axiom.kind == AxiomKind::functional_object_property) functional.insert(axiom.properties[0].iri);
    for (const Axiom& axiom : ontology.axioms)
        if (axiom.kind == AxiomKind::object_property_range && functional.contains(axiom.properties[0].iri) &&
            axiom.classes[0]->kind == ClassKind::named && below.contains(axiom.classes[0]->iri))
            ranges.insert(axiom.classes[0]->iri);
    return ranges;
}

}  // namespace

std::vector<std::pair<Iri, Iri>> value_individuals(const owl::Ontology& ontology) {
    std::map<Iri, Iri> values;
    const bool has_individuals = std::ranges::any_of(ontology.axioms, [](const Axiom& axiom) {
        return axiom.kind == AxiomKind::class_assertion ||
               (axiom.kind == AxiomKind::equivalent_classes &&
                std::ranges::any_of(axiom.classes, [](const auto& c) { return c->kind == ClassKind::one_of; }));
    });
    if (!has_individuals) return {};
    const std::set<Iri> ranges = ranges_of_features(ontology);
    for (const Axiom& axiom : ontology.axioms) {
        if (axiom.kind == AxiomKind::class_assertion && axiom.classes[0]->kind == ClassKind::named &&
            ranges.contains(axiom.classes[0]->iri))
            values.emplace(axiom.individuals[0], axiom.classes[0]->iri);
        if (axiom.kind != AxiomKind::equivalent_classes) continue;
        for (const ClassPointer& range : axiom.classes) {
            if (range->kind != ClassKind::named || !ranges.contains(range->iri)) continue;
            for (const ClassPointer& meaning : axiom.classes)
                if (meaning->kind == ClassKind::one_of)
                    for (const Iri& value : meaning->individuals) values.emplace(value, range->iri);
        }
    }
    return {values.begin(), values.end()};
}

bool is_told_by_rule(const owl::Ontology& ontology, const Iri& iri) {
    return std::ranges::any_of(ontology.axioms, [&](const Axiom& axiom) {
        return axiom.kind == AxiomKind::rule && std::ranges::any_of(axiom.rule->head, [&](const owl::RuleAtom& atom) {
                   return atom.kind == owl::RuleAtom::Kind::of_class && atom.klass->kind == ClassKind::named &&
                          atom.klass->iri == iri;
               });
    });
}

owl::Ontology plain_ontology(const owl::Ontology& ontology) {
    const Plainer plainer(ontology);
    const std::set<Iri> unused = unused_features(ontology);
    if (unused.empty() && plainer.has_nothing_to_do()) return ontology;
    const auto is_used = [&](const Iri& name) { return !unused.contains(name); };
    owl::Ontology result{ontology.iri, ontology.sha256, ontology.imports, {}, {}, {}};
    for (const owl::Entity& entity : ontology.entities)
        if (is_used(entity.iri)) result.entities.push_back(entity);
    for (const auto& [name, annotations] : ontology.annotations)
        if (is_used(name)) result.annotations.emplace_hint(result.annotations.end(), name, annotations);
    result.axioms.reserve(ontology.axioms.size());
    for (const Axiom& axiom : ontology.axioms) {
        bool speaks_of_unused = false;
        if (!unused.empty())
            owl::for_each_name(axiom, [&](const Iri& name) { speaks_of_unused = speaks_of_unused || !is_used(name); });
        if (speaks_of_unused)
            result.axioms.push_back(
                {AxiomKind::sub_class_of, {owl::thing(), owl::thing()}, {}, {}, {}, {}, axiom.source});
        else
            result.axioms.push_back(plainer.plain(axiom));
    }
    return result;
}

}  // namespace partonomy::knowledge
