// Class expressions, data ranges, names and the atoms of rules in functional syntax and OWL/XML, said as triples (W3C
// OWL 2 "Mapping to RDF Graphs", table 1, and for rules the RDF syntax of the SWRL submission of 2004).

#include <algorithm>
#include <string_view>

#include "owl/structural.h"

namespace partonomy::owl {
namespace {

constexpr std::size_t any_number = static_cast<std::size_t>(-1);

}  // namespace

Node StructuralReader::entity(const Construct& construct, EntityKind kind) {
    constexpr const char* types[] = {"Class",           "ObjectProperty", "DataProperty", "AnnotationProperty",
                                     "NamedIndividual", "Datatype"};
    constexpr const char* words[] = {"a class",       "an object property", "a data property", "an annotation property",
                                     "an individual", "a datatype"};
    const auto index = static_cast<std::size_t>(kind);
    if (construct.kind != Construct::Kind::iri || (!construct.name.empty() && construct.name != types[index])) {
        misplaced(construct, words[index]);
    }
    const Node node = graph_.iri(construct.value, construct.line);
    if (kind != EntityKind::individual && kind != EntityKind::annotation_property) {
        say_.expect(node, kind, construct.line);
    }
    return node;
}

Node StructuralReader::object_property(const Construct& construct) {
    if (construct.kind != Construct::Kind::call || construct.name != "ObjectInverseOf") {
        return entity(construct, EntityKind::object_property);
    }
    want(construct, 0, 1, 1);
    return say_.inverse(entity(construct.parts[0], EntityKind::object_property), construct.line);
}

Node StructuralReader::data_property(const Construct& construct) {
    return entity(construct, EntityKind::data_property);
}

Node StructuralReader::annotation_property(const Construct& construct) {
    return entity(construct, EntityKind::annotation_property);
}

Node StructuralReader::individual(const Construct& construct) {
    if (construct.kind == Construct::Kind::anonymous) return graph_.blank(construct.value);
    return entity(construct, EntityKind::individual);
}

Node StructuralReader::literal(const Construct& construct) {
    if (construct.kind != Construct::Kind::literal) misplaced(construct, "a literal");
    if (!construct.datatype.empty()) static_cast<void>(graph_.iri(construct.datatype, construct.line));  // is it one?
    return say_.literal(construct.value, construct.datatype, construct.language);
}

Node StructuralReader::annotation_value(const Construct& construct) {
    if (construct.kind == Construct::Kind::literal) return literal(construct);
    if (construct.kind == Construct::Kind::anonymous) return graph_.blank(construct.value);
    if (construct.kind != Construct::Kind::iri) misplaced(construct, "an IRI or a literal");
    return graph_.iri(construct.value, construct.line);
}

Node StructuralReader::class_expression(const Construct& construct) {
    if (construct.kind != Construct::Kind::call) return entity(construct, EntityKind::klass);
    const std::string_view name = construct.name;
    if (name == "ObjectIntersectionOf" || name == "ObjectUnionOf") {
        want(construct, 0, 1, any_number);
        return say_.connective(Word::owl_Class, name == "ObjectUnionOf" ? Word::owl_unionOf : Word::owl_intersectionOf,
                               each(construct, 0, &StructuralReader::class_expression), construct.line);
    }
    if (name == "ObjectComplementOf") {
        want(construct, 0, 1, 1);
        return say_.complement(Word::owl_Class, Word::owl_complementOf, class_expression(construct.parts[0]),
                               construct.line);
    }
    if (name == "ObjectOneOf") {
        want(construct, 0, 1, any_number);
        return say_.connective(Word::owl_Class, Word::owl_oneOf, each(construct, 0, &StructuralReader::individual),
                               construct.line);
    }
    if (name == "ObjectHasSelf") {
        want(construct, 0, 1, 1);
        return say_.restriction(object_property(construct.parts[0]), Word::owl_hasSelf,
                                graph_.literal("true", std::string(xsd_prefix) + "boolean"), construct.line);
    }
    for (const std::string_view form :
         {"SomeValuesFrom", "AllValuesFrom", "HasValue", "MinCardinality", "MaxCardinality", "ExactCardinality"}) {
        if (!name.ends_with(form)) continue;
        const std::string_view side = name.substr(0, name.size() - form.size());
        if (side == "Object" || side == "Data") return restriction(construct, side == "Data");
    }
    misplaced(construct, "a class expression");
}

Node StructuralReader::restriction(const Construct& construct, bool over_data) {
    const std::string_view name = construct.name;
    const auto property = [&](const Construct& part) {
        return over_data ? data_property(part) : object_property(part);
    };
    const auto filler = [&](const Construct& part) { return over_data ? data_range(part) : class_expression(part); };
    if (name.ends_with("Cardinality")) {
        want(construct, 0, 2, 3);
        if (construct.parts[0].kind != Construct::Kind::literal) misplaced(construct.parts[0], "a whole number");
        const Word word = name.find("Min") != std::string_view::npos   ? Word::owl_minCardinality
                          : name.find("Max") != std::string_view::npos ? Word::owl_maxCardinality
                                                                       : Word::owl_cardinality;
        const Node on = property(construct.parts[1]);
        const bool is_qualified = construct.parts.size() == 3;
        const Word filler_word = !is_qualified ? Word::none : over_data ? Word::owl_onDataRange : Word::owl_onClass;
        return say_.cardinality(on, word, construct.parts[0].value, filler_word,
                                is_qualified ? filler(construct.parts[2]) : 0, construct.line);
    }
    if (over_data && construct.parts.size() > 2)
        fail(construct, construct.name + " names several data properties, for which OWL 2 has no data ranges; use one");
    want(construct, 0, 2, 2);
    const Node on = property(construct.parts[0]);
    if (name.ends_with("HasValue")) {
        return say_.restriction(on, Word::owl_hasValue,
                                over_data ? literal(construct.parts[1]) : individual(construct.parts[1]),
                                construct.line);
    }
    return say_.restriction(on, name.ends_with("SomeValuesFrom") ? Word::owl_someValuesFrom : Word::owl_allValuesFrom,
                            filler(construct.parts[1]), construct.line);
}

Node StructuralReader::data_range(const Construct& construct) {
    if (construct.kind != Construct::Kind::call) return entity(construct, EntityKind::datatype);
    const std::string_view name = construct.name;
    if (name == "DataIntersectionOf" || name == "DataUnionOf") {
        want(construct, 0, 1, any_number);
        return say_.connective(Word::rdfs_Datatype,
                               name == "DataUnionOf" ? Word::owl_unionOf : Word::owl_intersectionOf,
                               each(construct, 0, &StructuralReader::data_range), construct.line);
    }
    if (name == "DataComplementOf") {
        want(construct, 0, 1, 1);
        return say_.complement(Word::rdfs_Datatype, Word::owl_datatypeComplementOf, data_range(construct.parts[0]),
                               construct.line);
    }
    if (name == "DataOneOf") {
        want(construct, 0, 1, any_number);
        return say_.connective(Word::rdfs_Datatype, Word::owl_oneOf, each(construct, 0, &StructuralReader::literal),
                               construct.line);
    }
    if (name != "DatatypeRestriction") misplaced(construct, "a data range");
    want(construct, 0, 3, any_number);
    if (construct.parts.size() % 2 == 0)
        fail(construct, "DatatypeRestriction wants a datatype and then pairs of facet and literal");
    const Node datatype = entity(construct.parts[0], EntityKind::datatype);
    std::vector<std::pair<Node, Node>> facets;
    for (std::size_t i = 1; i < construct.parts.size(); i += 2) {
        const Construct& facet = construct.parts[i];
        if (facet.kind != Construct::Kind::iri || !facet.name.empty())
            misplaced(facet, "a facet such as xsd:minInclusive");
        facets.emplace_back(graph_.iri(facet.value, facet.line), literal(construct.parts[i + 1]));
    }
    return say_.datatype_restriction(datatype, facets, construct.line);
}

void StructuralReader::rule(const Construct& axiom, std::size_t first, const std::vector<Note>& notes) {
    want(axiom, first, 2, 2);
    const Construct& body = axiom.parts[first];
    const Construct& head = axiom.parts[first + 1];
    if (body.kind != Construct::Kind::call || body.name != "Body") misplaced(body, "the Body of a rule");
    if (head.kind != Construct::Kind::call || head.name != "Head") misplaced(head, "the Head of a rule");
    const auto atoms = [&](const Construct& list) { return each(list, 0, &StructuralReader::atom); };
    const std::vector<Node> premises = atoms(body);
    say_.rule(premises, atoms(head), axiom.line, notes);
}

Node StructuralReader::atom(const Construct& construct) {
    const std::string_view name = construct.kind == Construct::Kind::call ? construct.name : std::string_view();
    const auto arguments = [&](std::size_t first) { return each(construct, first, &StructuralReader::rule_argument); };
    if (name == "ClassAtom" || name == "DataRangeAtom") {
        want(construct, 0, 2, 2);
        const bool over_data = name == "DataRangeAtom";
        const Node predicate = over_data ? data_range(construct.parts[0]) : class_expression(construct.parts[0]);
        return say_.atom(over_data ? Word::swrl_DataRangeAtom : Word::swrl_ClassAtom,
                         over_data ? Word::swrl_dataRange : Word::swrl_classPredicate, predicate, arguments(1),
                         construct.line);
    }
    if (name == "ObjectPropertyAtom" || name == "DataPropertyAtom") {
        want(construct, 0, 3, 3);
        const bool over_data = name == "DataPropertyAtom";
        const Node predicate = over_data ? data_property(construct.parts[0]) : object_property(construct.parts[0]);
        return say_.atom(over_data ? Word::swrl_DatavaluedPropertyAtom : Word::swrl_IndividualPropertyAtom,
                         Word::swrl_propertyPredicate, predicate, arguments(1), construct.line);
    }
    if (name == "SameIndividualAtom" || name == "DifferentIndividualsAtom") {
        want(construct, 0, 2, 2);
        return say_.atom(
            name == "SameIndividualAtom" ? Word::swrl_SameIndividualAtom : Word::swrl_DifferentIndividualsAtom,
            Word::none, 0, arguments(0), construct.line);
    }
    if (name != "BuiltInAtom") misplaced(construct, "an atom of a rule");
    want(construct, 0, 2, any_number);
    const Construct& built_in = construct.parts[0];
    if (built_in.kind != Construct::Kind::iri || !built_in.name.empty()) misplaced(built_in, "the IRI of a built-in");
    return say_.built_in(graph_.iri(built_in.value, built_in.line), arguments(1), construct.line);
}

Node StructuralReader::rule_argument(const Construct& construct) {
    if (construct.kind == Construct::Kind::iri && construct.name == "Variable")
        return say_.variable(construct.value, construct.line);
    if (construct.kind == Construct::Kind::literal) return literal(construct);
    return individual(construct);
}

}  // namespace partonomy::owl
