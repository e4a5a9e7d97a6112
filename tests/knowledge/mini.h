#pragma once

#include <algorithm>
#include <initializer_list>
#include <set>
#include <string>
#include <vector>

#include "knowledge/domain.h"

// Ontologies written in a test: classes and axioms in nearly Manchester words. Axiom n is on line n of "mini.ttl".

namespace mini {

using namespace partonomy;
using owl::ClassKind;
using owl::ClassPointer;

inline owl::Iri iri(const std::string& name) {
    static const std::set<std::string> core{
        "Region",  "Object",   "CompositePart",  "Relation",          "Incompatible",
        "Feature", "hasPart",  "measure",        "membership",        "criterion",
        "cost",    "question", "isTargetRegion", "isReferenceRegion", "arity", "typicalHeight"};
    if (name == "Thing" || name == "Nothing") return "http://www.w3.org/2002/07/owl#" + name;
    return (core.contains(name) ? owl::core_prefix : "urn:test#") + name;
}

inline ClassPointer make(ClassKind kind, const std::string& name, std::vector<ClassPointer> operands,
                         unsigned number = 0) {
    auto expression = std::make_shared<owl::ClassExpression>();
    expression->kind = kind;
    (kind == ClassKind::named ? expression->iri : expression->property.iri) = name.empty() ? "" : iri(name);
    expression->operands = std::move(operands);
    expression->number = number;
    return expression;
}

inline ClassPointer name(const std::string& n) { return make(ClassKind::named, n, {}); }
inline ClassPointer both(std::vector<ClassPointer> c) { return make(ClassKind::intersection_of, "", std::move(c)); }
inline ClassPointer either(std::vector<ClassPointer> c) { return make(ClassKind::union_of, "", std::move(c)); }
inline ClassPointer no(ClassPointer c) { return make(ClassKind::complement_of, "", {std::move(c)}); }
inline ClassPointer some(const std::string& p, ClassPointer c) {
    return make(ClassKind::some_values_from, p, {std::move(c)});
}
inline ClassPointer some(const std::string& p, const std::string& c) { return some(p, name(c)); }
inline ClassPointer only(const std::string& p, ClassPointer c) {
    return make(ClassKind::all_values_from, p, {std::move(c)});
}
/// A restriction on the inverse of its property.
inline ClassPointer inverse(const ClassPointer& restriction) {
    auto result = std::make_shared<owl::ClassExpression>(*restriction);
    result->property.inverse = true;
    return result;
}
inline ClassPointer at_least(unsigned n, ClassPointer c) {
    return make(ClassKind::min_cardinality, "hasPart", {std::move(c)}, n);
}
inline ClassPointer at_most(unsigned n, ClassPointer c) {
    return make(ClassKind::max_cardinality, "hasPart", {std::move(c)}, n);
}
inline ClassPointer exactly(unsigned n, ClassPointer c) {
    return make(ClassKind::exact_cardinality, "hasPart", {std::move(c)}, n);
}

/// number("height", {{"maxInclusive", "0.5"}}).
inline ClassPointer number(const std::string& property, const std::vector<std::pair<std::string, std::string>>& facets,
                           ClassKind kind = ClassKind::data_some_values_from) {
    const std::string xsd = "http://www.w3.org/2001/XMLSchema#";
    auto expression = std::make_shared<owl::ClassExpression>();
    expression->kind = kind;
    expression->property.iri = iri(property);
    expression->range.datatype = xsd + "double";
    for (const auto& [facet, value] : facets)
        expression->range.facets.push_back({xsd + facet, {value, xsd + "double", ""}});
    return expression;
}

class Ontology {
public:
    Ontology() { result.iri = "urn:test"; }

    Ontology& axiom(owl::AxiomKind kind, std::vector<ClassPointer> classes, const std::string& property = {}) {
        owl::Axiom axiom{};
        axiom.kind = kind;
        axiom.classes = std::move(classes);
        if (!property.empty()) axiom.properties.push_back({iri(property), false});
        axiom.source = {"mini.ttl", static_cast<long>(result.axioms.size()) + 1};
        result.axioms.push_back(std::move(axiom));
        return *this;
    }
    Ontology& sub(ClassPointer a, ClassPointer b) {
        return axiom(owl::AxiomKind::sub_class_of, {std::move(a), std::move(b)});
    }
    Ontology& sub(const std::string& a, const std::string& b) { return sub(name(a), name(b)); }
    Ontology& same(const std::string& a, ClassPointer b) {
        return axiom(owl::AxiomKind::equivalent_classes, {name(a), std::move(b)});
    }
    Ontology& disjoint(ClassPointer a, ClassPointer b) {
        return axiom(owl::AxiomKind::disjoint_classes, {std::move(a), std::move(b)});
    }
    /// A range concept with hasRange leading to it; disjoint union of its values when `covered`.
    Ontology& range(const std::string& concept_name, const std::vector<std::string>& values, bool covered = true) {
        sub(concept_name, "Feature");
        axiom(owl::AxiomKind::object_property_range, {name(concept_name)}, "has" + concept_name);
        axiom(owl::AxiomKind::functional_object_property, {}, "has" + concept_name);
        std::vector<ClassPointer> classes{name(concept_name)};
        for (const std::string& value : values) {
            if (!covered) sub(value, concept_name);
            classes.push_back(name(value));
        }
        if (covered) axiom(owl::AxiomKind::disjoint_union, classes);
        return *this;
    }
    Ontology& measured(const std::string& property, const std::string& measure = {}) {
        axiom(owl::AxiomKind::functional_data_property, {}, property);
        if (!measure.empty()) note(property, "measure", measure);
        return *this;
    }
    Ontology& note(const std::string& entity, const std::string& knob, const std::string& text) {
        result.annotations[iri(entity)].push_back({iri(knob), {text, "", ""}, "", {"mini.ttl", 1000}});
        return *this;
    }

    owl::Ontology result;
};

/// Shape x Orientation, as in paper Fig. 5.
inline Ontology shapes() {
    Ontology ontology;
    ontology.range("Shape", {"Board", "Cube", "Stick"}).range("Orientation", {"Horizontal", "Vertical"});
    return ontology;
}

inline std::size_t count(const knowledge::Space& space, const std::string& concept_name) {
    const auto id = space.find(iri(concept_name));
    return id ? space.concepts[*id].where.count() : 999999;
}

inline bool is_below(const knowledge::Domain& domain, const std::string& a, const std::string& b) {
    const auto pairs = domain.hierarchy();
    return std::ranges::binary_search(pairs, std::pair(iri(a), iri(b)));
}

}  // namespace mini
