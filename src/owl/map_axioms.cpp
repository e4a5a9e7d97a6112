// Axioms out of triples (W3C OWL 2 "Mapping to RDF Graphs", tables 16 and 17). One pass over the triples in the order
// of the file: each predicate that makes an axiom reads the expressions it needs, which marks their triples as used.
// What is left unused at the end belongs to no axiom, and is refused rather than dropped. The annotations of axioms
// (owl:Axiom) are checked and left out: the axiom itself is written beside them.

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "owl/expressions.h"

namespace partonomy::owl {
namespace {

class AxiomReader {
public:
    AxiomReader(const Graph& graph, const Declarations& declarations, Ontology& ontology)
        : graph_(graph), declarations_(declarations), read_(graph, declarations), ontology_(ontology) {}

    void read();

private:
    void statement(const Triple& triple);
    void type(const Triple& triple);
    void characteristic(const Triple& triple);
    void members(const Triple& triple);
    void negative_assertion(const Triple& triple);
    void annotated_axiom(const Triple& triple);
    void class_axiom(AxiomKind kind, const Triple& triple);
    void property_axiom(const Triple& triple, AxiomKind object_kind, AxiomKind data_kind);
    void domain_or_range(const Triple& triple);
    void individuals_axiom(AxiomKind kind, const Triple& triple);
    void assertion(const Triple& triple);
    void annotate(const Triple& triple);
    void refuse_unused();

    [[nodiscard]] const Term& term(Node node) const { return read_.term(node); }
    [[nodiscard]] Word word(Node node) const { return term(node).word; }
    [[nodiscard]] bool is_annotation_property(Node node) const {
        return term(node).kind == TermKind::iri &&
               declarations_.has(term(node).value, EntityKind::annotation_property) &&
               !declarations_.has(term(node).value, EntityKind::object_property) &&
               !declarations_.has(term(node).value, EntityKind::data_property);
    }
    /// The one value of `word` that `triple`'s subject has.
    const Triple& only(const Triple& triple, Word word, const char* name);
    Axiom& add(AxiomKind kind, long line) {
        ontology_.axioms.push_back({kind, {}, {}, {}, {}, {}, {graph_.file, line}});
        return ontology_.axioms.back();
    }
    void use(const Triple& triple) { read_.used[static_cast<std::size_t>(&triple - graph_.triples.data())] = 1; }
    Iri individual(Node node, long line);

    const Graph& graph_;
    const Declarations& declarations_;
    Expressions read_;
    Ontology& ontology_;
    std::set<Node> reified_;  ///< blank nodes that are axioms: what is said of them beyond OWL's words is annotation
};

bool is_reserved(const Iri& iri) {
    return iri.starts_with(owl_prefix) || iri.starts_with(rdf_prefix) || iri.starts_with(rdfs_prefix);
}

Iri AxiomReader::individual(Node node, long line) {
    Iri iri = read_.individual(node, line);
    if (term(node).kind == TermKind::iri)
        ontology_.entities.push_back({EntityKind::individual, iri, {graph_.file, line}});
    return iri;
}

const Triple& AxiomReader::only(const Triple& triple, Word wanted, const char* name) {
    const Triple* found = nullptr;
    for (const std::uint32_t i : read_.about(triple.subject)) {
        if (word(graph_.triples[i].predicate) != wanted) continue;
        if (found != nullptr)
            read_.fail(graph_.triples[i].line, std::string(name) + " has two values here; one is right");
        found = &graph_.triples[i];
        read_.used[i] = 1;
    }
    if (found == nullptr) read_.fail(triple.line, read_.shown(triple.object) + " needs " + name + " beside it");
    return *found;
}

void AxiomReader::class_axiom(AxiomKind kind, const Triple& triple) {
    if (kind == AxiomKind::equivalent_classes && term(triple.subject).kind == TermKind::iri &&
        declarations_.has(term(triple.subject).value, EntityKind::datatype)) {
        read_.fail(triple.line, "the definition of the datatype " + read_.shown(triple.subject) +
                                    " is not covered; write its facets where it is used");
    }
    const ClassPointer left = read_.class_expression(triple.subject, triple.line);
    const ClassPointer right = read_.class_expression(triple.object, triple.line);
    add(kind, triple.line).classes = {left, right};
}

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
    add(over_data ? data_kind : object_kind, triple.line).properties = {left, right};
}

void AxiomReader::domain_or_range(const Triple& triple) {
    if (is_annotation_property(triple.subject)) {
        annotate(triple);
        return;
    }
    const bool is_range = word(triple.predicate) == Word::rdfs_range;
    const bool over_data = read_.is_data_property(triple.subject, triple.line);
    Axiom axiom;
    axiom.kind = over_data  ? is_range ? AxiomKind::data_property_range : AxiomKind::data_property_domain
                 : is_range ? AxiomKind::object_property_range
                            : AxiomKind::object_property_domain;
    axiom.source = {graph_.file, triple.line};
    axiom.properties = {over_data ? read_.data_property(triple.subject, triple.line)
                                  : read_.object_property(triple.subject, triple.line)};
    if (over_data && is_range)
        axiom.range = read_.data_range(triple.object, triple.line);
    else
        axiom.classes = {read_.class_expression(triple.object, triple.line)};
    ontology_.axioms.push_back(std::move(axiom));
}

void AxiomReader::individuals_axiom(AxiomKind kind, const Triple& triple) {
    const Iri left = individual(triple.subject, triple.line);
    const Iri right = individual(triple.object, triple.line);
    add(kind, triple.line).individuals = {left, right};
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
    add(axiom, triple.line).properties = {property};
}

/// owl:AllDisjointClasses, owl:AllDisjointProperties, owl:AllDifferent.
void AxiomReader::members(const Triple& triple) {
    reified_.insert(triple.subject);
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
    axiom.source = {graph_.file, triple.line};
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
    ontology_.axioms.push_back(std::move(axiom));
}

void AxiomReader::negative_assertion(const Triple& triple) {
    reified_.insert(triple.subject);
    for (const std::uint32_t i : read_.about(triple.subject)) {
        if (word(graph_.triples[i].predicate) == Word::owl_targetValue) {
            read_.fail(graph_.triples[i].line,
                       "a negative assertion about data (owl:targetValue) is not covered; "
                       "say it with owl:complementOf a restriction with owl:hasValue");
        }
    }
    const Triple& source = only(triple, Word::owl_sourceIndividual, "owl:sourceIndividual");
    const Triple& property = only(triple, Word::owl_assertionProperty, "owl:assertionProperty");
    const Triple& target = only(triple, Word::owl_targetIndividual, "owl:targetIndividual");
    const PropertyExpression expression = read_.object_property(property.object, property.line);
    const Iri from = individual(source.object, source.line);
    const Iri to = individual(target.object, target.line);
    Axiom& axiom = add(AxiomKind::negative_object_property_assertion, triple.line);
    axiom.properties = {expression};
    axiom.individuals = {from, to};
}

void AxiomReader::annotated_axiom(const Triple& triple) {
    reified_.insert(triple.subject);
    const Triple& source = only(triple, Word::owl_annotatedSource, "owl:annotatedSource");
    const Triple& property = only(triple, Word::owl_annotatedProperty, "owl:annotatedProperty");
    const Triple& target = only(triple, Word::owl_annotatedTarget, "owl:annotatedTarget");
    const bool is_there = std::ranges::any_of(read_.about(source.object), [&](std::uint32_t i) {
        return graph_.triples[i].predicate == property.object && graph_.triples[i].object == target.object;
    });
    if (!is_there) {
        read_.fail(triple.line, "the axiom that is annotated here is not in the file; write '" +
                                    read_.shown(source.object) + " " + read_.shown(property.object) + " " +
                                    read_.shown(target.object) + "' beside it");
    }
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
            use(triple);
            return annotated_axiom(triple);
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
    const Iri& object = term(triple.object).value;
    if (term(triple.object).kind == TermKind::iri && object.starts_with(swrl_prefix)) {
        read_.fail(triple.line, "SWRL rules are not covered; say it with class expressions or property chains");
    }
    if (term(triple.object).kind == TermKind::iri && word(triple.object) == Word::none && is_reserved(object)) {
        read_.fail(triple.line, read_.shown(triple.object) + " is no word of OWL 2");
    }
    use(triple);
    const ClassPointer type = read_.class_expression(triple.object, triple.line);
    const Iri subject = individual(triple.subject, triple.line);
    Axiom& axiom = add(AxiomKind::class_assertion, triple.line);
    axiom.classes = {type};
    axiom.individuals = {subject};
}

void AxiomReader::annotate(const Triple& triple) {
    use(triple);
    const Term& object = term(triple.object);
    Annotation annotation;
    annotation.property = term(triple.predicate).value;
    annotation.source = {graph_.file, triple.line};
    if (object.kind == TermKind::literal)
        annotation.literal = read_.literal(triple.object);
    else
        annotation.iri = object.value;
    ontology_.annotations[term(triple.subject).value].push_back(std::move(annotation));
}

/// A property between individuals, or an annotation.
void AxiomReader::assertion(const Triple& triple) {
    const Iri& predicate = term(triple.predicate).value;
    if (predicate.starts_with(swrl_prefix)) {
        read_.fail(triple.line, "SWRL rules are not covered; say it with class expressions or property chains");
    }
    if (word(triple.predicate) == Word::none && is_reserved(predicate)) {
        read_.fail(triple.line, read_.shown(triple.predicate) + " is no property of OWL 2");
    }
    if (declarations_.has(predicate, EntityKind::object_property) ||
        declarations_.has(predicate, EntityKind::data_property)) {
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
        Axiom& axiom =
            add(over_data ? AxiomKind::data_property_assertion : AxiomKind::object_property_assertion, triple.line);
        axiom.properties = {{predicate, false}};
        axiom.individuals = {subject};
        if (over_data)
            axiom.literal = read_.literal(triple.object);
        else
            axiom.individuals.push_back(object);
        return;
    }
    if (predicate.starts_with(xsd_prefix)) return;   // a facet, read with its data range
    if (read_.is_structure(triple.subject)) return;  // the expression or, at the end, refuse_unused will say so
    if (read_.is_structure(triple.object)) {
        read_.fail(triple.line, read_.shown(triple.predicate) +
                                    " is no property of OWL 2, but a class expression or list is its value");
    }
    annotate(triple);
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
        case Word::owl_disjointUnionOf: {
            use(triple);
            std::vector<ClassPointer> classes = {read_.class_expression(triple.subject, triple.line)};
            for (const Node node : read_.list(triple.object, triple.line))
                classes.push_back(read_.class_expression(node, triple.line));
            if (classes.size() < 2)
                read_.fail(triple.line, "owl:disjointUnionOf has an empty list; it needs at least one class");
            add(AxiomKind::disjoint_union, triple.line).classes = std::move(classes);
            return;
        }
        case Word::owl_intersectionOf:
        case Word::owl_unionOf:
        case Word::owl_complementOf:
        case Word::owl_oneOf: {  // of a named class: the OWL 1 way to define it
            if (is_blank) return;
            use(triple);
            const ClassPointer left = read_.class_expression(triple.subject, triple.line);
            const ClassPointer right = read_.described_by(triple);
            add(AxiomKind::equivalent_classes, triple.line).classes = {left, right};
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
        case Word::owl_propertyChainAxiom: {
            use(triple);
            std::vector<PropertyExpression> chain;
            for (const Node node : read_.list(triple.object, triple.line))
                chain.push_back(read_.object_property(node, triple.line));
            if (chain.size() < 2)
                read_.fail(triple.line, "owl:propertyChainAxiom needs a list of at least two object properties");
            chain.push_back(read_.object_property(triple.subject, triple.line));
            add(AxiomKind::sub_object_property_of, triple.line).properties = std::move(chain);
            return;
        }
        case Word::owl_inverseOf: {
            if (is_blank) return;
            use(triple);
            const PropertyExpression left = read_.object_property(triple.subject, triple.line);
            const PropertyExpression right = read_.object_property(triple.object, triple.line);
            add(AxiomKind::inverse_object_properties, triple.line).properties = {left, right};
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
            read_.fail(triple.line, "keys (owl:hasKey) are not covered; leave the axiom out");
        case Word::owl_imports: {
            use(triple);
            const bool is_header = std::ranges::any_of(read_.about(triple.subject), [&](std::uint32_t i) {
                return word(graph_.triples[i].object) == Word::owl_Ontology;
            });
            if (!is_header)
                read_.fail(triple.line, "owl:imports belongs to an ontology; declare its subject as owl:Ontology");
            if (term(triple.object).kind != TermKind::iri)
                read_.fail(triple.line, "owl:imports wants the IRI of an ontology, not " + read_.shown(triple.object));
            return;
        }
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

void AxiomReader::refuse_unused() {
    for (std::size_t i = 0; i < graph_.triples.size(); ++i) {
        if (read_.used[i] != 0) continue;
        const Triple& triple = graph_.triples[i];
        if (reified_.contains(triple.subject)) {
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

void AxiomReader::read() {
    for (const Triple& triple : graph_.triples) {
        const Word kind = word(triple.predicate) == Word::rdf_type ? word(triple.object) : Word::none;
        if (kind == Word::owl_Axiom || kind == Word::owl_Annotation) reified_.insert(triple.subject);
    }
    for (const Triple& triple : graph_.triples) statement(triple);
    refuse_unused();
    for (const Node node : reified_) ontology_.annotations.erase(term(node).value);
}

}  // namespace

void map_axioms(const Graph& graph, const Declarations& declarations, Ontology& ontology) {
    AxiomReader(graph, declarations, ontology).read();
}

}  // namespace partonomy::owl
