// Turtle out of axioms (W3C OWL 2 "Mapping to RDF Graphs", table 1). An expression is a text: a name, "[ … ]" or "( …
// )"; an axiom is a triple of texts. Where the annotation of an axiom has to point at a blank node, the node gets a
// label and its description a sentence of its own. Recursion is as deep as expressions nest, which readers bound.

#include <algorithm>
#include <initializer_list>
#include <string_view>
#include <utility>

#include "owl/words.h"
#include "owl/write_names.h"

namespace partonomy::owl {
namespace {

/// The pieces one after the other. In a chain of + GCC 12 sees an overlap that is not there.
std::string glued(std::initializer_list<std::string_view> pieces) {
    std::string text;
    for (const std::string_view piece : pieces) text += piece;
    return text;
}

class TurtleWriter {
public:
    TurtleWriter(const Ontology& ontology, WriteNames& names);

    std::string body();
    std::string head(const Iri& version);

private:
    [[nodiscard]] std::string show(const ClassExpression& expression);
    [[nodiscard]] std::string show(const DataRange& range);
    [[nodiscard]] std::string show(const PropertyExpression& property);
    [[nodiscard]] std::string show(const Literal& literal) { return literal_text(literal, names_, true); }
    [[nodiscard]] std::string show(const Iri& iri) { return names_(iri); }
    [[nodiscard]] std::string show(const RuleTerm& term);
    [[nodiscard]] std::string show(const RuleAtom& atom);
    [[nodiscard]] std::string atoms(const std::vector<RuleAtom>& list);
    [[nodiscard]] std::string restriction(const ClassExpression& expression, const char* word);
    [[nodiscard]] std::string cardinality(const ClassExpression& expression, const char* word, const char* qualified);
    template <typename Items>
    [[nodiscard]] std::string list(const Items& items, std::size_t from = 0);
    template <typename Items>
    [[nodiscard]] std::string list_object(const Items& items, std::size_t from, const Axiom& axiom);
    [[nodiscard]] std::string show_item(const ClassPointer& item) { return show(*item); }
    template <typename Item>
    [[nodiscard]] std::string show_item(const Item& item) {
        return show(item);
    }

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
    WriteNames& names_;
    std::string text_;
    std::string label_stem_ = "_:x";
    std::size_t labels_ = 0;
};

/// No label of ours may be one of the ontology's.
TurtleWriter::TurtleWriter(const Ontology& ontology, WriteNames& names) : ontology_(ontology), names_(names) {
    std::size_t longest = 0;
    const auto look_at = [&](const Iri& iri) {
        if (iri.starts_with("_:x")) longest = std::max(longest, iri.size());
    };
    const auto look_into = [&](const auto& self, const ClassExpression& expression) -> void {
        for (const Iri& iri : expression.individuals) look_at(iri);
        for (const ClassPointer& operand : expression.operands) self(self, *operand);
    };
    for (const Axiom& axiom : ontology.axioms) {
        for (const Iri& iri : axiom.individuals) look_at(iri);
        for (const ClassPointer& expression : axiom.classes) look_into(look_into, *expression);
        for (const Annotation& note : axiom.annotations) look_at(note.iri);
        if (!axiom.rule) continue;
        for (const auto* atoms : {&axiom.rule->body, &axiom.rule->head}) {
            for (const RuleAtom& atom : *atoms) {
                if (atom.klass) look_into(look_into, *atom.klass);
                for (const RuleTerm& term : atom.arguments) look_at(term.iri);
            }
        }
    }
    for (const auto& [subject, notes] : ontology.annotations) {
        look_at(subject);
        for (const Annotation& note : notes) look_at(note.iri);
    }
    while (label_stem_.size() < longest) label_stem_ += 'x';
}

template <typename Items>
std::string TurtleWriter::list(const Items& items, std::size_t from) {
    std::string text = "(";
    for (std::size_t i = from; i < items.size(); ++i) text += glued({" ", show_item(items[i])});
    return text + " )";
}

std::string TurtleWriter::show(const PropertyExpression& property) {
    return property.inverse ? glued({"[ owl:inverseOf ", names_(property.iri), " ]"}) : names_(property.iri);
}

std::string TurtleWriter::restriction(const ClassExpression& expression, const char* word) {
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

std::string TurtleWriter::cardinality(const ClassExpression& expression, const char* word, const char* qualified) {
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

std::string TurtleWriter::show(const ClassExpression& expression) {
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

std::string TurtleWriter::show(const DataRange& range) {
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

std::string TurtleWriter::show(const RuleTerm& term) {
    return term.kind == RuleTerm::Kind::literal ? show(term.literal) : names_(term.iri);
}

std::string TurtleWriter::show(const RuleAtom& atom) {
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
        case AxiomKind::inverse_object_properties:
            return say(property(0), "owl:inverseOf", property(1));
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
    TurtleWriter writer(ontology, names);
    for (const char* space : {owl_prefix, rdf_prefix, rdfs_prefix}) static_cast<void>(names(std::string(space) + "x"));
    const std::string head = writer.head(version_of(ontology));
    const std::string body = writer.body();
    if (body.find("swrl:") != std::string::npos) static_cast<void>(names(std::string(swrl_prefix) + "x"));
    std::string prefixes;
    for (const auto& [prefix, space] : names.used_prefixes())
        prefixes += glued({"@prefix ", prefix, " <", space, "> .\n"});
    return prefixes + "\n" + head + "\n" + body;
}

}  // namespace partonomy::owl
