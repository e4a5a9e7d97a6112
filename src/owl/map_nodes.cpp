// Axioms that are nodes of their own: owl:AllDisjointClasses and the like, and negative assertions (W3C OWL 2 "Mapping
// to RDF Graphs", table 16).

#include "owl/axiom_reader.h"

namespace partonomy::owl {

const Triple* AxiomReader::find_only(const Triple& triple, Word wanted) {
    const Triple* found = nullptr;
    for (const std::uint32_t i : read_.about(triple.subject)) {
        if (word(graph_.triples[i].predicate) != wanted) continue;
        if (found != nullptr) {
            read_.fail(graph_.triples[i].line,
                       read_.shown(graph_.triples[i].predicate) + " has two values here; one is right");
        }
        found = &graph_.triples[i];
        read_.used[i] = 1;
    }
    return found;
}

const Triple& AxiomReader::only(const Triple& triple, Word wanted, const char* name) {
    const Triple* found = find_only(triple, wanted);
    if (found == nullptr) read_.fail(triple.line, read_.shown(triple.object) + " needs " + name + " beside it");
    return *found;
}

/// owl:AllDisjointClasses, owl:AllDisjointProperties, owl:AllDifferent.
void AxiomReader::members(const Triple& triple) {
    const Word kind = word(triple.object);
    bool has_distinct = false;
    for (const std::uint32_t i : read_.about(triple.subject)) {
        has_distinct |= word(graph_.triples[i].predicate) == Word::owl_distinctMembers;
    }
    const Triple& listed = kind == Word::owl_AllDifferent && has_distinct
                               ? only(triple, Word::owl_distinctMembers, "owl:distinctMembers")
                               : only(triple, Word::owl_members, "owl:members");
    const std::vector<Node> nodes = read_.list(listed.object, listed.line);
    if (nodes.size() < 2) read_.fail(listed.line, read_.shown(triple.object) + " needs a list of at least two members");
    Axiom axiom;
    axiom.kind = AxiomKind::disjoint_classes;
    if (kind == Word::owl_AllDisjointClasses) {
        for (const Node node : nodes) axiom.classes.push_back(read_.class_expression(node, listed.line));
    } else if (kind == Word::owl_AllDifferent) {
        axiom.kind = AxiomKind::different_individuals;
        for (const Node node : nodes) axiom.individuals.push_back(individual(node, listed.line));
    } else {
        const bool over_data = read_.is_data_property(nodes.front(), listed.line);
        axiom.kind = over_data ? AxiomKind::disjoint_data_properties : AxiomKind::disjoint_object_properties;
        for (const Node node : nodes) {
            axiom.properties.push_back(over_data ? read_.data_property(node, listed.line)
                                                 : read_.object_property(node, listed.line));
        }
    }
    axiom.source = {graph_.file, triple.line};
    axiom_of_node_[triple.subject] = ontology_.axioms.size();
    ontology_.axioms.push_back(std::move(axiom));
}

void AxiomReader::negative_assertion(const Triple& triple) {
    const Triple& source = only(triple, Word::owl_sourceIndividual, "owl:sourceIndividual");
    const Triple& property = only(triple, Word::owl_assertionProperty, "owl:assertionProperty");
    const Triple* value = find_only(triple, Word::owl_targetValue);
    if (value != nullptr && term(value->object).kind != TermKind::literal)
        read_.fail(value->line, "owl:targetValue is a literal, not " + read_.shown(value->object));
    const Triple* target = value != nullptr
                               ? nullptr
                               : &only(triple, Word::owl_targetIndividual, "owl:targetIndividual or owl:targetValue");
    const PropertyExpression expression = value != nullptr ? read_.data_property(property.object, property.line)
                                                           : read_.object_property(property.object, property.line);
    std::vector<Iri> individuals = {individual(source.object, source.line)};
    if (target != nullptr) individuals.push_back(individual(target->object, target->line));
    axiom_of_node_[triple.subject] = ontology_.axioms.size();
    Axiom& axiom = add(
        value != nullptr ? AxiomKind::negative_data_property_assertion : AxiomKind::negative_object_property_assertion,
        triple);
    axiom.properties = {expression};
    axiom.individuals = std::move(individuals);
    if (value != nullptr) axiom.literal = read_.literal(value->object);
}

}  // namespace partonomy::owl
