// Axioms about properties out of triples (W3C OWL 2 "Mapping to RDF Graphs", tables 16 and 17). What a property leads
// to, things or data, its declaration tells; what is said of an annotation property is an annotation.

#include "owl/axiom_reader.h"

namespace partonomy::owl {

void AxiomReader::property_axiom(const Triple& triple, AxiomKind object_kind, AxiomKind data_kind) {
    if (is_annotation_property(triple.subject)) {
        annotate(triple);
        return;
    }
    const bool over_data = read_.is_data_property(triple.subject, triple.line);
    const auto property = [&](Node node) {
        return over_data ? read_.data_property(node, triple.line) : read_.object_property(node, triple.line);
    };
    const PropertyExpression left = property(triple.subject);
    const PropertyExpression right = property(triple.object);
    add(over_data ? data_kind : object_kind, triple).properties = {left, right};
}

void AxiomReader::property_chain(const Triple& triple) {
    std::vector<PropertyExpression> chain;
    for (const Node node : read_.list(triple.object, triple.line))
        chain.push_back(read_.object_property(node, triple.line));
    if (chain.size() < 2)
        read_.fail(triple.line, "owl:propertyChainAxiom needs a list of at least two object properties");
    chain.push_back(read_.object_property(triple.subject, triple.line));
    add(AxiomKind::sub_object_property_of, triple).properties = std::move(chain);
}

void AxiomReader::has_key(const Triple& triple) {
    const ClassPointer keyed = read_.class_expression(triple.subject, triple.line);
    std::vector<PropertyExpression> properties;
    for (const Node node : read_.list(triple.object, triple.line)) {
        properties.push_back(read_.is_data_property(node, triple.line) ? read_.data_property(node, triple.line)
                                                                       : read_.object_property(node, triple.line));
    }
    if (properties.empty()) read_.fail(triple.line, "owl:hasKey has an empty list; it needs at least one property");
    Axiom& axiom = add(AxiomKind::has_key, triple);
    axiom.classes = {keyed};
    axiom.properties = std::move(properties);
}

void AxiomReader::domain_or_range(const Triple& triple) {
    if (is_annotation_property(triple.subject)) {
        annotate(triple);
        return;
    }
    const bool is_range = word(triple.predicate) == Word::rdfs_range;
    const bool over_data = read_.is_data_property(triple.subject, triple.line);
    const AxiomKind kind = over_data  ? is_range ? AxiomKind::data_property_range : AxiomKind::data_property_domain
                           : is_range ? AxiomKind::object_property_range
                                      : AxiomKind::object_property_domain;
    const PropertyExpression property = over_data ? read_.data_property(triple.subject, triple.line)
                                                  : read_.object_property(triple.subject, triple.line);
    DataRange range;
    std::vector<ClassPointer> classes;
    if (over_data && is_range)
        range = read_.data_range(triple.object, triple.line);
    else
        classes.push_back(read_.class_expression(triple.object, triple.line));
    Axiom& axiom = add(kind, triple);
    axiom.properties = {property};
    axiom.classes = std::move(classes);
    axiom.range = std::move(range);
}

void AxiomReader::characteristic(const Triple& triple) {
    const Word kind = word(triple.object);
    const bool over_data = read_.is_data_property(triple.subject, triple.line);
    if (over_data && kind != Word::owl_FunctionalProperty) {
        read_.fail(triple.line, read_.shown(triple.subject) + " is a data property, which cannot be an " +
                                    read_.shown(triple.object));
    }
    const PropertyExpression property = over_data ? read_.data_property(triple.subject, triple.line)
                                                  : read_.object_property(triple.subject, triple.line);
    AxiomKind axiom = over_data ? AxiomKind::functional_data_property : AxiomKind::functional_object_property;
    if (kind == Word::owl_InverseFunctionalProperty) axiom = AxiomKind::inverse_functional_object_property;
    if (kind == Word::owl_SymmetricProperty) axiom = AxiomKind::symmetric_object_property;
    if (kind == Word::owl_AsymmetricProperty) axiom = AxiomKind::asymmetric_object_property;
    if (kind == Word::owl_TransitiveProperty) axiom = AxiomKind::transitive_object_property;
    if (kind == Word::owl_ReflexiveProperty) axiom = AxiomKind::reflexive_object_property;
    if (kind == Word::owl_IrreflexiveProperty) axiom = AxiomKind::irreflexive_object_property;
    add(axiom, triple).properties = {property};
}

}  // namespace partonomy::owl
