// Expressions as Turtle (W3C OWL 2 "Mapping to RDF Graphs", table 1). Recursion is as deep as expressions nest, which
// readers bound.

#include "owl/turtle_expressions.h"

#include "owl/words.h"

namespace partonomy::owl {

std::string glued(std::initializer_list<std::string_view> pieces) {
    std::string text;
    for (const std::string_view piece : pieces) text += piece;
    return text;
}

std::string TurtleExpressions::show(const PropertyExpression& property) {
    return property.inverse ? glued({"[ owl:inverseOf ", names_(property.iri), " ]"}) : names_(property.iri);
}

std::string TurtleExpressions::restriction(const ClassExpression& expression, const char* word) {
    const bool over_data = expression.kind >= ClassKind::data_some_values_from;
    std::string filler = "true";
    if (expression.kind == ClassKind::has_value)
        filler = show(expression.individuals.at(0));
    else if (expression.kind == ClassKind::data_has_value)
        filler = show(expression.range.values.at(0));
    else if (over_data)
        filler = show(expression.range);
    else if (expression.kind != ClassKind::has_self)
        filler = show(*expression.operands.at(0));
    return glued(
        {"[ a owl:Restriction ; owl:onProperty ", show(expression.property), " ; owl:", word, " ", filler, " ]"});
}

std::string TurtleExpressions::cardinality(const ClassExpression& expression, const char* word, const char* qualified) {
    const bool over_data = expression.kind >= ClassKind::data_some_values_from;
    const bool is_qualified = over_data ? !expression.range.facets.empty() ||
                                              expression.range.kind != DataRangeKind::datatype ||
                                              expression.range.datatype != std::string(rdfs_prefix) + "Literal"
                                        : expression.operands.at(0)->kind != ClassKind::named ||
                                              expression.operands[0]->iri != std::string(owl_prefix) + "Thing";
    const std::string type = names_(std::string(xsd_prefix) + "nonNegativeInteger");
    const std::string text =
        glued({"[ a owl:Restriction ; owl:onProperty ", show(expression.property),
               " ; owl:", is_qualified ? qualified : word, " \"", std::to_string(expression.number), "\"^^", type});
    if (!is_qualified) return text + " ]";
    return over_data ? glued({text, " ; owl:onDataRange ", show(expression.range), " ]"})
                     : glued({text, " ; owl:onClass ", show(*expression.operands[0]), " ]"});
}

std::string TurtleExpressions::show(const ClassExpression& expression) {
    switch (expression.kind) {
        case ClassKind::named:
            return names_(expression.iri);
        case ClassKind::intersection_of:
            return glued({"[ a owl:Class ; owl:intersectionOf ", list(expression.operands), " ]"});
        case ClassKind::union_of:
            return glued({"[ a owl:Class ; owl:unionOf ", list(expression.operands), " ]"});
        case ClassKind::complement_of:
            return glued({"[ a owl:Class ; owl:complementOf ", show(*expression.operands.at(0)), " ]"});
        case ClassKind::one_of:
            return glued({"[ a owl:Class ; owl:oneOf ", list(expression.individuals), " ]"});
        case ClassKind::some_values_from:
        case ClassKind::data_some_values_from:
            return restriction(expression, "someValuesFrom");
        case ClassKind::all_values_from:
        case ClassKind::data_all_values_from:
            return restriction(expression, "allValuesFrom");
        case ClassKind::has_value:
        case ClassKind::data_has_value:
            return restriction(expression, "hasValue");
        case ClassKind::has_self:
            return restriction(expression, "hasSelf");
        case ClassKind::min_cardinality:
        case ClassKind::data_min_cardinality:
            return cardinality(expression, "minCardinality", "minQualifiedCardinality");
        case ClassKind::max_cardinality:
        case ClassKind::data_max_cardinality:
            return cardinality(expression, "maxCardinality", "maxQualifiedCardinality");
        case ClassKind::exact_cardinality:
        case ClassKind::data_exact_cardinality:
            return cardinality(expression, "cardinality", "qualifiedCardinality");
    }
    return {};
}

std::string TurtleExpressions::show(const DataRange& range) {
    switch (range.kind) {
        case DataRangeKind::datatype: {
            if (range.facets.empty()) return names_(range.datatype);
            std::string facets = "(";
            for (const auto& [facet, literal] : range.facets)
                facets += glued({" [ ", names_(facet), " ", show(literal), " ]"});
            return glued({"[ a rdfs:Datatype ; owl:onDatatype ", names_(range.datatype), " ; owl:withRestrictions ",
                          facets, " ) ]"});
        }
        case DataRangeKind::one_of:
            return glued({"[ a rdfs:Datatype ; owl:oneOf ", list(range.values), " ]"});
        case DataRangeKind::intersection_of:
            return glued({"[ a rdfs:Datatype ; owl:intersectionOf ", list(range.operands), " ]"});
        case DataRangeKind::union_of:
            return glued({"[ a rdfs:Datatype ; owl:unionOf ", list(range.operands), " ]"});
        case DataRangeKind::complement_of:
            return glued({"[ a rdfs:Datatype ; owl:datatypeComplementOf ", show(range.operands.at(0)), " ]"});
    }
    return {};
}

std::string TurtleExpressions::show(const RuleTerm& term) {
    return term.kind == RuleTerm::Kind::literal ? show(term.literal) : names_(term.iri);
}

std::string TurtleExpressions::show(const RuleAtom& atom) {
    std::string text = "[ a ";
    switch (atom.kind) {
        case RuleAtom::Kind::of_class:
            text += glued({"swrl:ClassAtom ; swrl:classPredicate ", show(*atom.klass)});
            break;
        case RuleAtom::Kind::of_data_range:
            text += glued({"swrl:DataRangeAtom ; swrl:dataRange ", show(atom.range)});
            break;
        case RuleAtom::Kind::object_property:
            text += glued({"swrl:IndividualPropertyAtom ; swrl:propertyPredicate ", show(atom.property)});
            break;
        case RuleAtom::Kind::data_property:
            text += glued({"swrl:DatavaluedPropertyAtom ; swrl:propertyPredicate ", show(atom.property)});
            break;
        case RuleAtom::Kind::same_as:
            text += "swrl:SameIndividualAtom";
            break;
        case RuleAtom::Kind::different_from:
            text += "swrl:DifferentIndividualsAtom";
            break;
        case RuleAtom::Kind::built_in:
            return glued({text, "swrl:BuiltinAtom ; swrl:builtin ", names_(atom.iri), " ; swrl:arguments ",
                          list(atom.arguments), " ]"});
    }
    text += glued({" ; swrl:argument1 ", show(atom.arguments.at(0))});
    if (atom.arguments.size() > 1) text += glued({" ; swrl:argument2 ", show(atom.arguments[1])});
    return text + " ]";
}

}  // namespace partonomy::owl
