// Expressions and axioms as a person would say them: OWL 2 Manchester syntax with local names in place of prefixes.
// Inside `and`, `or`, `not` and as fillers everything but a name or an enumeration stands in parentheses, as Protégé
// shows it. Iteration limits are those of the reader: expressions are at most 500 deep.

#include <string_view>

#include "owl/ontology.h"
#include "owl/words.h"

namespace partonomy::owl {
namespace {

/// `items` through `show`, with `separator` between them.
template <typename Items, typename Show>
std::string joined(const Items& items, std::string_view separator, Show show) {
    std::string text;
    for (const auto& item : items) {
        if (!text.empty()) text += separator;
        text += show(item);
    }
    return text;
}

std::string name(const Iri& iri) {
    if (iri.starts_with("_:")) return iri;
    const std::string local = local_name(iri);
    return local.empty() ? between("<", iri, ">") : local;
}

std::string datatype_name(const Iri& iri) {
    return iri.starts_with(xsd_prefix) || iri.starts_with(rdfs_prefix) || iri.starts_with(rdf_prefix) ? short_name(iri)
                                                                                                      : name(iri);
}

std::string show(const PropertyExpression& property) {
    return property.inverse ? between("inverse (", name(property.iri), ")") : name(property.iri);
}

std::string show(const Literal& literal) {
    const std::string type = datatype_name(literal.datatype);
    for (const char* bare : {"xsd:integer", "xsd:decimal", "xsd:double", "xsd:float", "xsd:boolean",
                             "xsd:nonNegativeInteger", "xsd:int"}) {
        if (type == bare && !literal.value.empty()) return literal.value;
    }
    std::string text = "\"";
    for (const char c : literal.value) {
        if (c == '"' || c == '\\') text += '\\';
        text += c;
    }
    text += '"';
    if (!literal.language.empty()) return text + "@" + literal.language;
    return type == "xsd:string" ? text : text + "^^" + type;
}

std::string facet_name(const Iri& facet) {
    const std::string local = local_name(facet);
    if (local == "minInclusive") return ">=";
    if (local == "maxInclusive") return "<=";
    if (local == "minExclusive") return ">";
    if (local == "maxExclusive") return "<";
    return local;
}

std::string show(const DataRange& range) {
    const auto operands = [&](const char* separator) {
        return between("(", joined(range.operands, separator, [](const DataRange& item) { return show(item); }), ")");
    };
    switch (range.kind) {
        case DataRangeKind::datatype:
            break;
        case DataRangeKind::one_of:
            return between("{", joined(range.values, ", ", [](const Literal& value) { return show(value); }), "}");
        case DataRangeKind::intersection_of:
            return operands(" and ");
        case DataRangeKind::union_of:
            return operands(" or ");
        case DataRangeKind::complement_of:
            return between("not ", show(range.operands.at(0)), "");
    }
    if (range.facets.empty()) return datatype_name(range.datatype);
    return datatype_name(range.datatype) + "[" +
           joined(range.facets, ", ",
                  [](const auto& facet) { return facet_name(facet.first) + " " + show(facet.second); }) +
           "]";
}

std::string names(const std::vector<Iri>& iris) { return joined(iris, ", ", name); }

std::string operand(const ClassExpression& expression) {
    const bool is_atom = expression.kind == ClassKind::named || expression.kind == ClassKind::one_of;
    return is_atom ? to_manchester(expression) : between("(", to_manchester(expression), ")");
}

std::string list(const std::vector<ClassPointer>& classes, std::size_t from) {
    std::string text;
    for (std::size_t i = from; i < classes.size(); ++i) {
        if (i > from) text += ", ";
        text += to_manchester(*classes[i]);
    }
    return text;
}

std::string list(const std::vector<PropertyExpression>& properties) {
    return joined(properties, ", ", [](const PropertyExpression& property) { return show(property); });
}

std::string show(const RuleAtom& atom) {
    const auto term = [](const RuleTerm& item) {
        if (item.kind == RuleTerm::Kind::literal) return show(item.literal);
        return item.kind == RuleTerm::Kind::variable ? between("?", name(item.iri), "") : name(item.iri);
    };
    std::string predicate;
    switch (atom.kind) {
        case RuleAtom::Kind::of_class:
            predicate = operand(*atom.klass);
            break;
        case RuleAtom::Kind::of_data_range:
            predicate = show(atom.range);
            break;
        case RuleAtom::Kind::object_property:
        case RuleAtom::Kind::data_property:
            predicate = show(atom.property);
            break;
        case RuleAtom::Kind::same_as:
            predicate = "sameAs";
            break;
        case RuleAtom::Kind::different_from:
            predicate = "differentFrom";
            break;
        case RuleAtom::Kind::built_in:
            predicate = name(atom.iri);
            break;
    }
    return predicate + between("(", joined(atom.arguments, ", ", term), ")");
}

std::string show(const Rule& rule) {
    const auto atom = [](const RuleAtom& item) { return show(item); };
    return joined(rule.body, ", ", atom) + " -> " + joined(rule.head, ", ", atom);
}

}  // namespace

std::string to_manchester(const ClassExpression& expression) {
    const auto operands = [&](std::string_view separator) {
        return joined(expression.operands, separator, [](const ClassPointer& item) { return operand(*item); });
    };
    const auto some = [&](const char* word) { return show(expression.property) + " " + word + " "; };
    const auto filler = [&] { return operand(*expression.operands.at(0)); };
    const std::string number = std::to_string(expression.number) + " ";
    switch (expression.kind) {
        case ClassKind::named:
            return name(expression.iri);
        case ClassKind::intersection_of:
            return operands(" and ");
        case ClassKind::union_of:
            return operands(" or ");
        case ClassKind::complement_of:
            return "not " + filler();
        case ClassKind::one_of:
            return between("{", names(expression.individuals), "}");
        case ClassKind::some_values_from:
            return some("some") + filler();
        case ClassKind::all_values_from:
            return some("only") + filler();
        case ClassKind::has_value:
            return some("value") + name(expression.individuals.at(0));
        case ClassKind::has_self:
            return some("Self").substr(0, some("Self").size() - 1);
        case ClassKind::min_cardinality:
            return some("min") + number + filler();
        case ClassKind::max_cardinality:
            return some("max") + number + filler();
        case ClassKind::exact_cardinality:
            return some("exactly") + number + filler();
        case ClassKind::data_some_values_from:
            return some("some") + show(expression.range);
        case ClassKind::data_all_values_from:
            return some("only") + show(expression.range);
        case ClassKind::data_has_value:
            return some("value") + show(expression.range.values.at(0));
        case ClassKind::data_min_cardinality:
            return some("min") + number + show(expression.range);
        case ClassKind::data_max_cardinality:
            return some("max") + number + show(expression.range);
        case ClassKind::data_exact_cardinality:
            return some("exactly") + number + show(expression.range);
    }
    return {};
}

std::string to_manchester(const Axiom& axiom) {
    const auto klass = [&](std::size_t i) { return to_manchester(*axiom.classes.at(i)); };
    const auto property = [&](std::size_t i) { return show(axiom.properties.at(i)); };
    const auto individual = [&](std::size_t i) { return name(axiom.individuals.at(i)); };
    const auto characteristic = [&](const char* word) { return property(0) + " Characteristics: " + word; };
    const auto properties = [&](const char* between, const char* before) {
        return axiom.properties.size() == 2 ? property(0) + between + property(1) : before + list(axiom.properties);
    };
    const auto classes = [&](const char* between, const char* before) {
        return axiom.classes.size() == 2 ? klass(0) + between + klass(1) : before + list(axiom.classes, 0);
    };
    switch (axiom.kind) {
        case AxiomKind::sub_class_of:
            return klass(0) + " SubClassOf: " + klass(1);
        case AxiomKind::equivalent_classes:
            return classes(" EquivalentTo: ", "EquivalentClasses: ");
        case AxiomKind::disjoint_classes:
            return classes(" DisjointWith: ", "DisjointClasses: ");
        case AxiomKind::disjoint_union:
            return klass(0) + " DisjointUnionOf: " + list(axiom.classes, 1);
        case AxiomKind::sub_object_property_of:
            if (axiom.properties.size() > 2) {
                const std::vector<PropertyExpression> chain(axiom.properties.begin(), axiom.properties.end() - 1);
                return property(axiom.properties.size() - 1) + " SubPropertyChain: " +
                       joined(chain, " o ", [](const PropertyExpression& step) { return show(step); });
            }
            return property(0) + " SubPropertyOf: " + property(1);
        case AxiomKind::equivalent_object_properties:
        case AxiomKind::equivalent_data_properties:
            return properties(" EquivalentTo: ", "EquivalentProperties: ");
        case AxiomKind::inverse_object_properties:
            return property(0) + " InverseOf: " + property(1);
        case AxiomKind::disjoint_object_properties:
        case AxiomKind::disjoint_data_properties:
            return properties(" DisjointWith: ", "DisjointProperties: ");
        case AxiomKind::object_property_domain:
        case AxiomKind::data_property_domain:
            return property(0) + " Domain: " + klass(0);
        case AxiomKind::object_property_range:
            return property(0) + " Range: " + klass(0);
        case AxiomKind::functional_object_property:
        case AxiomKind::functional_data_property:
            return characteristic("Functional");
        case AxiomKind::inverse_functional_object_property:
            return characteristic("InverseFunctional");
        case AxiomKind::symmetric_object_property:
            return characteristic("Symmetric");
        case AxiomKind::asymmetric_object_property:
            return characteristic("Asymmetric");
        case AxiomKind::transitive_object_property:
            return characteristic("Transitive");
        case AxiomKind::reflexive_object_property:
            return characteristic("Reflexive");
        case AxiomKind::irreflexive_object_property:
            return characteristic("Irreflexive");
        case AxiomKind::sub_data_property_of:
            return property(0) + " SubPropertyOf: " + property(1);
        case AxiomKind::data_property_range:
            return property(0) + " Range: " + show(axiom.range);
        case AxiomKind::class_assertion:
            return individual(0) + " Types: " + klass(0);
        case AxiomKind::object_property_assertion:
            return individual(0) + " Facts: " + property(0) + " " + individual(1);
        case AxiomKind::negative_object_property_assertion:
            return individual(0) + " Facts: not " + property(0) + " " + individual(1);
        case AxiomKind::data_property_assertion:
            return individual(0) + " Facts: " + property(0) + " " + show(axiom.literal);
        case AxiomKind::negative_data_property_assertion:
            return individual(0) + " Facts: not " + property(0) + " " + show(axiom.literal);
        case AxiomKind::has_key:
            return klass(0) + " HasKey: " + list(axiom.properties);
        case AxiomKind::datatype_definition:
            return "Datatype: " + name(axiom.datatype) + " EquivalentTo: " + show(axiom.range);
        case AxiomKind::rule:
            return show(*axiom.rule);
        case AxiomKind::same_individual:
            return axiom.individuals.size() == 2 ? individual(0) + " SameAs: " + individual(1)
                                                 : "SameIndividual: " + names(axiom.individuals);
        case AxiomKind::different_individuals:
            return axiom.individuals.size() == 2 ? individual(0) + " DifferentFrom: " + individual(1)
                                                 : "DifferentIndividuals: " + names(axiom.individuals);
    }
    return {};
}

}  // namespace partonomy::owl
