// Axioms out of triples (W3C OWL 2 "Mapping to RDF Graphs", tables 16 and 17). One pass over the triples in the order
// of the file: each predicate that makes an axiom reads the expressions it needs, which marks their triples as used.
// What is left unused at the end belongs to no axiom, and is refused rather than dropped.

#include <algorithm>
#include <functional>

#include "base/errors.h"
#include "owl/axiom_reader.h"

namespace partonomy::owl {

bool is_reserved(const Iri& iri) {
    return iri.starts_with(owl_prefix) || iri.starts_with(rdf_prefix) || iri.starts_with(rdfs_prefix) ||
           iri.starts_with(swrl_prefix);
}

bool AxiomReader::is_annotation_property(Node node) const {
    return term(node).kind == TermKind::iri && declarations_.has(term(node).value, EntityKind::annotation_property) &&
           !declarations_.has(term(node).value, EntityKind::object_property) &&
           !declarations_.has(term(node).value, EntityKind::data_property);
}

std::size_t AxiomReader::index(const Triple& triple) const {
    const Triple* begin = graph_.triples.data();
    const Triple* end = begin + graph_.triples.size();
    const bool is_inside = !std::less<>()(&triple, begin) && std::less<>()(&triple, end);
    return is_inside ? static_cast<std::size_t>(&triple - begin) : none;
}

void AxiomReader::use(const Triple& triple) {
    if (const std::size_t i = index(triple); i != none) read_.used[i] = 1;
}

Axiom& AxiomReader::add(AxiomKind kind, const Triple& triple) {
    if (!reified_.empty()) {
        if (const std::size_t i = index(triple); i != none) axiom_of_triple_[i] = ontology_.axioms.size();
    }
    ontology_.axioms.push_back({kind, {}, {}, {}, {}, {}, {graph_.file, triple.line}});
    return ontology_.axioms.back();
}

Iri AxiomReader::individual(Node node, long line) {
    Iri iri = read_.individual(node, line);
    if (term(node).kind == TermKind::iri)
        ontology_.entities.push_back({EntityKind::individual, iri, {graph_.file, line}});
    return iri;
}

void AxiomReader::class_axiom(AxiomKind kind, const Triple& triple) {
    if (kind == AxiomKind::equivalent_classes && term(triple.subject).kind == TermKind::iri &&
        declarations_.has(term(triple.subject).value, EntityKind::datatype)) {
        DataRange range = read_.data_range(triple.object, triple.line);
        Axiom& axiom = add(AxiomKind::datatype_definition, triple);
        axiom.datatype = term(triple.subject).value;
        axiom.range = std::move(range);
        return;
    }
    const ClassPointer left = read_.class_expression(triple.subject, triple.line);
    const ClassPointer right = read_.class_expression(triple.object, triple.line);
    add(kind, triple).classes = {left, right};
}

void AxiomReader::disjoint_union(const Triple& triple) {
    std::vector<ClassPointer> classes = {read_.class_expression(triple.subject, triple.line)};
    for (const Node node : read_.list(triple.object, triple.line))
        classes.push_back(read_.class_expression(node, triple.line));
    if (classes.size() < 2)
        read_.fail(triple.line, "owl:disjointUnionOf has an empty list; it needs at least one class");
    add(AxiomKind::disjoint_union, triple).classes = std::move(classes);
}

void AxiomReader::individuals_axiom(AxiomKind kind, const Triple& triple) {
    const Iri left = individual(triple.subject, triple.line);
    const Iri right = individual(triple.object, triple.line);
    add(kind, triple).individuals = {left, right};
}

void AxiomReader::import(const Triple& triple) {
    if (!is_ontology(triple.subject))
        read_.fail(triple.line, "owl:imports belongs to an ontology; declare its subject as owl:Ontology");
    if (term(triple.object).kind != TermKind::iri)
        read_.fail(triple.line, "owl:imports wants the IRI of an ontology, not " + read_.shown(triple.object));
}

void AxiomReader::type(const Triple& triple) {
    const bool is_blank = term(triple.subject).kind == TermKind::blank;
    switch (word(triple.object)) {
        case Word::owl_Class:
        case Word::rdfs_Class:
        case Word::rdfs_Datatype:
        case Word::owl_DataRange:
        case Word::owl_ObjectProperty:
        case Word::owl_Restriction:
        case Word::rdf_List:
            if (is_blank) return;  // used by the expression it belongs to
            if (word(triple.object) == Word::owl_Restriction) {
                read_.fail(triple.line, "a restriction has no name; say that " + read_.shown(triple.subject) +
                                            " is owl:equivalentClass [ a owl:Restriction … ]");
            }
            use(triple);
            return;
        case Word::owl_DatatypeProperty:
        case Word::owl_AnnotationProperty:
        case Word::owl_OntologyProperty:
        case Word::owl_NamedIndividual:
        case Word::owl_Ontology:
            use(triple);
            return;
        case Word::owl_DeprecatedClass:
        case Word::owl_DeprecatedProperty: {
            use(triple);
            ontology_.annotations[term(triple.subject).value].push_back(
                {std::string(owl_prefix) + "deprecated",
                 {"true", std::string(xsd_prefix) + "boolean", {}},
                 {},
                 {graph_.file, triple.line}});
            return;
        }
        case Word::owl_FunctionalProperty:
        case Word::owl_InverseFunctionalProperty:
        case Word::owl_SymmetricProperty:
        case Word::owl_AsymmetricProperty:
        case Word::owl_TransitiveProperty:
        case Word::owl_ReflexiveProperty:
        case Word::owl_IrreflexiveProperty:
            use(triple);
            return characteristic(triple);
        case Word::owl_AllDisjointClasses:
        case Word::owl_AllDisjointProperties:
        case Word::owl_AllDifferent:
            use(triple);
            return members(triple);
        case Word::owl_NegativePropertyAssertion:
            use(triple);
            return negative_assertion(triple);
        case Word::owl_Axiom:
        case Word::owl_Annotation:
        case Word::swrl_Variable:
        case Word::swrl_Builtin:
            return use(triple);
        case Word::swrl_Imp:
            use(triple);
            return rule(triple);
        case Word::swrl_AtomList:
        case Word::swrl_ClassAtom:
        case Word::swrl_DataRangeAtom:
        case Word::swrl_IndividualPropertyAtom:
        case Word::swrl_DatavaluedPropertyAtom:
        case Word::swrl_SameIndividualAtom:
        case Word::swrl_DifferentIndividualsAtom:
        case Word::swrl_BuiltinAtom:
            return;  // used by the rule it belongs to
        case Word::owl_Thing:
        case Word::owl_Nothing:
        case Word::none:
            break;
        case Word::rdf_Property: {
            const Iri& iri = term(triple.subject).value;
            if (declarations_.has(iri, EntityKind::object_property) ||
                declarations_.has(iri, EntityKind::data_property) ||
                declarations_.has(iri, EntityKind::annotation_property)) {
                return use(triple);
            }
            read_.fail(triple.line, "rdf:Property says too little of " + read_.shown(triple.subject) +
                                        "; declare an owl:ObjectProperty, owl:DatatypeProperty or "
                                        "owl:AnnotationProperty");
        }
        default:
            read_.fail(triple.line, read_.shown(triple.object) + " is no class of individuals");
    }
    class_assertion(triple);
}

void AxiomReader::class_assertion(const Triple& triple) {
    const Iri& object = term(triple.object).value;
    if (term(triple.object).kind == TermKind::iri && word(triple.object) == Word::none && is_reserved(object)) {
        read_.fail(triple.line, read_.shown(triple.object) + " is no word of OWL 2");
    }
    use(triple);
    const ClassPointer type = read_.class_expression(triple.object, triple.line);
    const Iri subject = individual(triple.subject, triple.line);
    Axiom& axiom = add(AxiomKind::class_assertion, triple);
    axiom.classes = {type};
    axiom.individuals = {subject};
}

/// A property between individuals, or an annotation.
void AxiomReader::assertion(const Triple& triple) {
    const Iri& predicate = term(triple.predicate).value;
    if (declarations_.has(predicate, EntityKind::object_property) ||
        declarations_.has(predicate, EntityKind::data_property)) {
        return property_assertion(triple);
    }
    if (word(triple.predicate) == Word::none && is_reserved(predicate) && !is_annotation_property(triple.predicate)) {
        read_.fail(triple.line, read_.shown(triple.predicate) + " is no property of OWL 2");
    }
    if (predicate.starts_with(xsd_prefix)) return;   // a facet, read with its data range
    if (read_.is_structure(triple.subject)) return;  // the expression or, at the end, refuse_unused will say so
    if (read_.is_structure(triple.object)) {
        read_.fail(triple.line, read_.shown(triple.predicate) +
                                    " is no property of OWL 2, but a class expression or list is its value");
    }
    annotate(triple);
}

void AxiomReader::property_assertion(const Triple& triple) {
    const Iri& predicate = term(triple.predicate).value;
    use(triple);
    const bool over_data = declarations_.has(predicate, EntityKind::data_property);
    if (over_data != (term(triple.object).kind == TermKind::literal)) {
        read_.fail(triple.line, read_.shown(triple.predicate) +
                                    (over_data ? " is a data property; its value is a literal, not "
                                               : " is an object property; its value is an individual, not ") +
                                    read_.shown(triple.object));
    }
    const Iri subject = individual(triple.subject, triple.line);
    const Iri object = over_data ? Iri() : individual(triple.object, triple.line);
    Axiom& axiom = add(over_data ? AxiomKind::data_property_assertion : AxiomKind::object_property_assertion, triple);
    axiom.properties = {{predicate, false}};
    axiom.individuals = {subject};
    if (over_data)
        axiom.literal = read_.literal(triple.object);
    else
        axiom.individuals.push_back(object);
}

void AxiomReader::statement(const Triple& triple) {
    const bool is_blank = term(triple.subject).kind == TermKind::blank;
    switch (word(triple.predicate)) {
        case Word::rdf_type:
            return type(triple);
        case Word::rdfs_subClassOf:
            use(triple);
            return class_axiom(AxiomKind::sub_class_of, triple);
        case Word::owl_equivalentClass:
            use(triple);
            return class_axiom(AxiomKind::equivalent_classes, triple);
        case Word::owl_disjointWith:
            use(triple);
            return class_axiom(AxiomKind::disjoint_classes, triple);
        case Word::owl_disjointUnionOf:
            use(triple);
            return disjoint_union(triple);
        case Word::owl_intersectionOf:
        case Word::owl_unionOf:
        case Word::owl_complementOf:
        case Word::owl_oneOf: {  // of a named class: the OWL 1 way to define it
            if (is_blank) return;
            use(triple);
            const ClassPointer left = read_.class_expression(triple.subject, triple.line);
            const ClassPointer right = read_.described_by(triple);
            add(AxiomKind::equivalent_classes, triple).classes = {left, right};
            return;
        }
        case Word::rdfs_subPropertyOf:
            use(triple);
            return property_axiom(triple, AxiomKind::sub_object_property_of, AxiomKind::sub_data_property_of);
        case Word::owl_equivalentProperty:
            use(triple);
            return property_axiom(triple, AxiomKind::equivalent_object_properties,
                                  AxiomKind::equivalent_data_properties);
        case Word::owl_propertyDisjointWith:
            use(triple);
            return property_axiom(triple, AxiomKind::disjoint_object_properties, AxiomKind::disjoint_data_properties);
        case Word::owl_propertyChainAxiom:
            use(triple);
            return property_chain(triple);
        case Word::owl_inverseOf: {
            if (is_blank) return;
            use(triple);
            const PropertyExpression left = read_.object_property(triple.subject, triple.line);
            const PropertyExpression right = read_.object_property(triple.object, triple.line);
            add(AxiomKind::inverse_object_properties, triple).properties = {left, right};
            return;
        }
        case Word::rdfs_domain:
        case Word::rdfs_range:
            use(triple);
            return domain_or_range(triple);
        case Word::owl_sameAs:
            use(triple);
            return individuals_axiom(AxiomKind::same_individual, triple);
        case Word::owl_differentFrom:
            use(triple);
            return individuals_axiom(AxiomKind::different_individuals, triple);
        case Word::owl_hasKey:
            use(triple);
            return has_key(triple);
        case Word::owl_imports:
            use(triple);
            return import(triple);
        case Word::none:
            return assertion(triple);
        default:
            if (declarations_.has(term(triple.predicate).value, EntityKind::annotation_property) ||
                declarations_.has(term(triple.predicate).value, EntityKind::object_property) ||
                declarations_.has(term(triple.predicate).value, EntityKind::data_property)) {
                assertion(triple);
            }
            return;  // a word of some structure, used by it
    }
}

void AxiomReader::refuse_unused() const {
    for (std::size_t i = 0; i < graph_.triples.size(); ++i) {
        if (read_.used[i] != 0) continue;
        const Triple& triple = graph_.triples[i];
        if (nodes_.contains(triple.subject)) {
            read_.fail(triple.line, read_.shown(triple.predicate) + " has no place here");
        }
        if (read_.is_structure(triple.subject)) {
            read_.fail(triple.line,
                       "the expression or list that has " + read_.shown(triple.predicate) +
                           " here belongs to no axiom; join it to a class, for example by owl:equivalentClass");
        }
        read_.fail(triple.line, read_.shown(triple.predicate) + " has no meaning for " + read_.shown(triple.subject) +
                                    "; in OWL 2 it belongs to an expression or axiom");
    }
}

void AxiomReader::check_uses() const {
    for (const Graph::Use& use : graph_.uses) {
        if (!declarations_.has(term(use.node).value, use.kind)) read_.reject_undeclared(use.node, use.kind, use.line);
    }
}

void AxiomReader::read() {
    first_axiom_ = ontology_.axioms.size();
    check_uses();
    for (const Triple& triple : graph_.triples) {
        if (word(triple.predicate) != Word::rdf_type) continue;
        const Word kind = word(triple.object);
        if (kind == Word::owl_Axiom || kind == Word::owl_Annotation) reified(triple);
        if (kind == Word::owl_AllDisjointClasses || kind == Word::owl_AllDisjointProperties ||
            kind == Word::owl_AllDifferent || kind == Word::owl_NegativePropertyAssertion || kind == Word::swrl_Imp)
            nodes_.insert(triple.subject);
        if (kind == Word::swrl_Variable) variables_.insert(triple.subject);
    }
    for (const Triple& triple : graph_.triples) statement(triple);
    attach_annotations();
    refuse_unused();
}

void map_axioms(const Graph& graph, const Declarations& declarations, AnonymousNames& names, Ontology& ontology) {
    AxiomReader(graph, declarations, names, ontology).read();
}

}  // namespace partonomy::owl
