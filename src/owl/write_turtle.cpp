// Turtle out of axioms (W3C OWL 2 "Mapping to RDF Graphs", table 1). An axiom is a triple of texts, see
// turtle_expressions.h. Where the annotation of an axiom has to point at a blank node, the node gets a label and its
// description a sentence of its own.

#include <utility>

#include "owl/turtle_expressions.h"
#include "owl/words.h"

namespace partonomy::owl {
namespace {

class TurtleWriter : private TurtleExpressions {
public:
    /// `stem` begins the labels of the writer's own blank nodes.
    TurtleWriter(const Ontology& ontology, WriteNames& names, std::string stem)
        : TurtleExpressions(names), ontology_(ontology), label_stem_(std::move(stem)) {}

    std::string body();
    std::string head(const Iri& version);

private:
    [[nodiscard]] std::string atoms(const std::vector<RuleAtom>& list);
    template <typename Items>
    [[nodiscard]] std::string list_object(const Items& items, std::size_t from, const Axiom& axiom);
    void write(const Axiom& axiom);
    void characteristic(const Axiom& axiom, const char* type);
    void triple(std::string subject, const std::string& predicate, std::string object,
                const std::vector<Annotation>& annotations, const char* type = "owl:Axiom");
    /// Each member and the next.
    template <typename Items>
    void chain(const Items& items, const char* predicate, const Axiom& axiom);
    /// Two members by a triple, more by a node.
    template <typename Items>
    void pairwise(const Items& items, const char* predicate, const char* type, const Axiom& axiom);
    void node(const std::string& description, const std::vector<Annotation>& annotations);
    std::string labelled(const std::string& expression);
    [[nodiscard]] std::string value(const Annotation& annotation) {
        return annotation.iri.empty() ? show(annotation.literal) : show(annotation.iri);
    }
    void notes(const std::string& subject, const std::vector<Annotation>& annotations);

    const Ontology& ontology_;
    std::string text_;
    std::string label_stem_;
    std::size_t labels_ = 0;
};

/// A labelled node for each cell: an rdf:List says swrl:AtomList for no reader, and nested brackets would be too deep.
std::string TurtleWriter::atoms(const std::vector<RuleAtom>& list) {
    std::string rest = "rdf:nil";
    for (std::size_t i = list.size(); i-- > 0;) {
        const std::string cell = label_stem_ + std::to_string(++labels_);
        text_ += glued({cell, " a swrl:AtomList ; rdf:first ", show(list[i]), " ; rdf:rest ", rest, " .\n"});
        rest = cell;
    }
    return rest;
}

/// The label of a new node that `expression` ("[ … ]") describes; names stay as they are.
std::string TurtleWriter::labelled(const std::string& expression) {
    if (expression[0] != '[') return expression;
    const std::string label = label_stem_ + std::to_string(++labels_);
    text_ += label + expression.substr(1, expression.size() - 2) + ".\n";
    return label;
}

/// A list that is the object of an axiom: with a label when the axiom has annotations.
template <typename Items>
std::string TurtleWriter::list_object(const Items& items, std::size_t from, const Axiom& axiom) {
    if (axiom.annotations.empty() || from >= items.size()) return list(items, from);
    const Items first(items.begin() + static_cast<std::ptrdiff_t>(from),
                      items.begin() + static_cast<std::ptrdiff_t>(from) + 1);
    const std::string member = list(first);  // "( member )"
    return labelled(
        glued({"[ rdf:first ", member.substr(2, member.size() - 4), " ; rdf:rest ", list(items, from + 1), " ]"}));
}

/// Annotations of `subject`, each as a triple, and their own annotations as nodes.
void TurtleWriter::notes(const std::string& subject, const std::vector<Annotation>& annotations) {
    for (const Annotation& note : annotations)
        triple(subject, names_(note.property), value(note), note.annotations, "owl:Annotation");
}

void TurtleWriter::triple(std::string subject, const std::string& predicate, std::string object,
                          const std::vector<Annotation>& annotations, const char* type) {
    if (!annotations.empty()) {
        subject = labelled(subject);
        object = labelled(object);
    }
    text_ += glued({subject, " ", predicate, " ", object, " .\n"});
    if (annotations.empty()) return;
    node(glued({"a ", type, " ; owl:annotatedSource ", subject, " ; owl:annotatedProperty ",
                predicate == "a" ? "rdf:type" : predicate, " ; owl:annotatedTarget ", object}),
         annotations);
}

void TurtleWriter::node(const std::string& description, const std::vector<Annotation>& annotations) {
    if (annotations.empty()) {
        text_ += glued({"[] ", description, " .\n"});
        return;
    }
    const std::string label = label_stem_ + std::to_string(++labels_);
    text_ += glued({label, " ", description, " .\n"});
    notes(label, annotations);
}

template <typename Items>
void TurtleWriter::chain(const Items& items, const char* predicate, const Axiom& axiom) {
    for (std::size_t i = 0; i + 1 < items.size(); ++i)
        triple(show_item(items[i]), predicate, show_item(items[i + 1]), axiom.annotations);
}

template <typename Items>
void TurtleWriter::pairwise(const Items& items, const char* predicate, const char* type, const Axiom& axiom) {
    if (items.size() == 2) return triple(show_item(items[0]), predicate, show_item(items[1]), axiom.annotations);
    node(glued({"a ", type, " ; owl:members ", list(items)}), axiom.annotations);
}

void TurtleWriter::characteristic(const Axiom& axiom, const char* type) {
    triple(show(axiom.properties.at(0)), "a", std::string("owl:") + type, axiom.annotations);
}

void TurtleWriter::write(const Axiom& axiom) {
    const auto klass = [&](std::size_t i) { return show(*axiom.classes.at(i)); };
    const auto property = [&](std::size_t i) { return show(axiom.properties.at(i)); };
    const auto individual = [&](std::size_t i) { return show(axiom.individuals.at(i)); };
    const auto say = [&](const std::string& subject, const std::string& predicate, const std::string& object) {
        triple(subject, predicate, object, axiom.annotations);
    };
    switch (axiom.kind) {
        case AxiomKind::sub_class_of:
            return say(klass(0), "rdfs:subClassOf", klass(1));
        case AxiomKind::equivalent_classes:
            return chain(axiom.classes, "owl:equivalentClass", axiom);
        case AxiomKind::disjoint_classes:
            return pairwise(axiom.classes, "owl:disjointWith", "owl:AllDisjointClasses", axiom);
        case AxiomKind::disjoint_union:
            return say(klass(0), "owl:disjointUnionOf", list_object(axiom.classes, 1, axiom));
        case AxiomKind::sub_object_property_of:
            if (axiom.properties.size() > 2) {
                const std::vector<PropertyExpression> steps(axiom.properties.begin(), axiom.properties.end() - 1);
                return say(show(axiom.properties.back()), "owl:propertyChainAxiom", list_object(steps, 0, axiom));
            }
            return say(property(0), "rdfs:subPropertyOf", property(1));
        case AxiomKind::sub_data_property_of:
            return say(property(0), "rdfs:subPropertyOf", property(1));
        case AxiomKind::equivalent_object_properties:
        case AxiomKind::equivalent_data_properties:
            return chain(axiom.properties, "owl:equivalentProperty", axiom);
        case AxiomKind::inverse_object_properties: {  // a node with two of them would be two inverses
            PropertyExpression left = axiom.properties.at(0), right = axiom.properties.at(1);
            if (left.inverse && right.inverse) left.inverse = right.inverse = false;
            if (left.inverse) std::swap(left, right);
            return say(show(left), "owl:inverseOf", show(right));
        }
        case AxiomKind::disjoint_object_properties:
        case AxiomKind::disjoint_data_properties:
            return pairwise(axiom.properties, "owl:propertyDisjointWith", "owl:AllDisjointProperties", axiom);
        case AxiomKind::object_property_domain:
        case AxiomKind::data_property_domain:
            return say(property(0), "rdfs:domain", klass(0));
        case AxiomKind::object_property_range:
            return say(property(0), "rdfs:range", klass(0));
        case AxiomKind::data_property_range:
            return say(property(0), "rdfs:range", show(axiom.range));
        case AxiomKind::functional_object_property:
        case AxiomKind::functional_data_property:
            return characteristic(axiom, "FunctionalProperty");
        case AxiomKind::inverse_functional_object_property:
            return characteristic(axiom, "InverseFunctionalProperty");
        case AxiomKind::symmetric_object_property:
            return characteristic(axiom, "SymmetricProperty");
        case AxiomKind::asymmetric_object_property:
            return characteristic(axiom, "AsymmetricProperty");
        case AxiomKind::transitive_object_property:
            return characteristic(axiom, "TransitiveProperty");
        case AxiomKind::reflexive_object_property:
            return characteristic(axiom, "ReflexiveProperty");
        case AxiomKind::irreflexive_object_property:
            return characteristic(axiom, "IrreflexiveProperty");
        case AxiomKind::class_assertion:
            return say(individual(0), "a", klass(0));
        case AxiomKind::object_property_assertion:
            if (axiom.properties.at(0).inverse)
                return say(individual(1), names_(axiom.properties[0].iri), individual(0));
            return say(individual(0), property(0), individual(1));
        case AxiomKind::data_property_assertion:
            return say(individual(0), property(0), show(axiom.literal));
        case AxiomKind::negative_object_property_assertion:
        case AxiomKind::negative_data_property_assertion: {
            const bool over_data = axiom.kind == AxiomKind::negative_data_property_assertion;
            return node(glued({"a owl:NegativePropertyAssertion ; owl:sourceIndividual ", individual(0),
                               " ; owl:assertionProperty ", property(0),
                               over_data ? " ; owl:targetValue " : " ; owl:targetIndividual ",
                               over_data ? show(axiom.literal) : individual(1)}),
                        axiom.annotations);
        }
        case AxiomKind::same_individual:
            return chain(axiom.individuals, "owl:sameAs", axiom);
        case AxiomKind::different_individuals:
            return pairwise(axiom.individuals, "owl:differentFrom", "owl:AllDifferent", axiom);
        case AxiomKind::has_key:
            return say(klass(0), "owl:hasKey", list_object(axiom.properties, 0, axiom));
        case AxiomKind::datatype_definition:
            return say(names_(axiom.datatype), "owl:equivalentClass", show(axiom.range));
        case AxiomKind::rule: {
            const std::string body = atoms(axiom.rule->body);
            const std::string head = atoms(axiom.rule->head);
            return node(glued({"a swrl:Imp ; swrl:body ", body, " ; swrl:head ", head}), axiom.annotations);
        }
    }
}

std::string TurtleWriter::head(const Iri& version) {
    std::string text = ontology_.iri.empty() ? "[]" : between("<", ontology_.iri, ">");
    text += " a owl:Ontology";
    if (!version.empty()) text += between(" ;\n    owl:versionIRI <", version, ">");
    for (const Iri& iri : names_.imports()) text += between(" ;\n    owl:imports <", iri, ">");
    const auto own = ontology_.annotations.find(ontology_.iri);
    if (own == ontology_.annotations.end()) return text + " .\n";
    std::vector<Annotation> annotated;
    for (const Annotation& note : own->second) {
        if (!names_.is_ours(note.source) || (is_version(note) && !version.empty())) continue;
        if (note.annotations.empty() || ontology_.iri.empty())
            text += glued({" ;\n    ", names_(note.property), " ", value(note)});
        else
            annotated.push_back(note);
    }
    text += " .\n";
    if (annotated.empty()) return text;
    notes(names_(ontology_.iri), annotated);
    return text + std::exchange(text_, {});
}

std::string TurtleWriter::body() {
    constexpr const char* types[] = {
        "owl:Class",           "owl:ObjectProperty", "owl:DatatypeProperty", "owl:AnnotationProperty",
        "owl:NamedIndividual", "rdfs:Datatype"};
    for (const Entity& entity : ontology_.entities) {
        if (names_.is_ours(entity.source))
            text_ += glued({names_(entity.iri), " a ", types[static_cast<int>(entity.kind)], " .\n"});
    }
    for (const Iri& variable : variables_of(ontology_, names_))
        text_ += glued({names_(variable), " a swrl:Variable .\n"});
    text_ += '\n';
    for (const auto& [subject, list] : ontology_.annotations) {
        if (subject == ontology_.iri) continue;
        for (const Annotation& note : list) {
            if (names_.is_ours(note.source))
                triple(names_(subject), names_(note.property), value(note), note.annotations);
        }
    }
    text_ += '\n';
    for (const Axiom& axiom : ontology_.axioms) {
        if (names_.is_ours(axiom.source)) write(axiom);
    }
    return std::move(text_);
}

}  // namespace

std::string write_turtle(const Ontology& ontology, const WriteOptions& options) {
    WriteNames names(ontology, options);
    for (const char* space : {owl_prefix, rdf_prefix, rdfs_prefix}) static_cast<void>(names(std::string(space) + "x"));
    std::string text;
    std::string stem = "_:x";
    for (;; stem += 'x') {  // no label of ours may be one of the ontology's
        TurtleWriter writer(ontology, names, stem);
        text = writer.head(version_of(ontology));
        text += '\n';
        text += writer.body();
        if (!names.has_label_with(stem)) break;
    }
    if (text.find("swrl:") != std::string::npos) static_cast<void>(names(std::string(swrl_prefix) + "x"));
    std::string prefixes;
    for (const auto& [prefix, space] : names.used_prefixes())
        prefixes += glued({"@prefix ", prefix, " <", space, "> .\n"});
    return prefixes + "\n" + text;
}

}  // namespace partonomy::owl
