// OWL 2 functional syntax out of axioms: a call for each construct of the structural specification (W3C, 2012), one
// axiom a line, in the order of the ontology. Recursion is as deep as expressions nest, which readers bound.

#include <iterator>

#include "owl/words.h"
#include "owl/write_names.h"

namespace partonomy::owl {
namespace {

/// In the order of AxiomKind.
constexpr const char* axiom_words[] = {
    "SubClassOf",
    "EquivalentClasses",
    "DisjointClasses",
    "DisjointUnion",
    "SubObjectPropertyOf",
    "EquivalentObjectProperties",
    "InverseObjectProperties",
    "DisjointObjectProperties",
    "ObjectPropertyDomain",
    "ObjectPropertyRange",
    "FunctionalObjectProperty",
    "InverseFunctionalObjectProperty",
    "SymmetricObjectProperty",
    "AsymmetricObjectProperty",
    "TransitiveObjectProperty",
    "ReflexiveObjectProperty",
    "IrreflexiveObjectProperty",
    "SubDataPropertyOf",
    "EquivalentDataProperties",
    "DisjointDataProperties",
    "DataPropertyDomain",
    "DataPropertyRange",
    "FunctionalDataProperty",
    "ClassAssertion",
    "ObjectPropertyAssertion",
    "NegativeObjectPropertyAssertion",
    "DataPropertyAssertion",
    "SameIndividual",
    "DifferentIndividuals",
    "NegativeDataPropertyAssertion",
    "HasKey",
    "DatatypeDefinition",
    "DLSafeRule",
};
static_assert(std::size(axiom_words) == static_cast<std::size_t>(AxiomKind::rule) + 1);

class FunctionalWriter {
public:
    explicit FunctionalWriter(WriteNames& names) : names_(names) {}

    void write(const ClassExpression& expression);
    void write(const DataRange& range);
    void write(const PropertyExpression& property);
    void write(const Literal& literal) { text += literal_text(literal, names_, false); }
    /// With its annotations, unless there is no ontology to tell a key's properties over things from those over data.
    void write(const Axiom& axiom, const Ontology* ontology);
    void write(const Annotation& annotation, const char* call, const std::string& subject);
    void annotation_axiom(const Iri& subject, const Annotation& note, bool is_property);
    void write(const Rule& rule);
    void annotations(const std::vector<Annotation>& list);

    std::string text;

private:
    void open(std::string_view call) {
        separate();
        text.append(call);
        text += '(';
    }
    void close() { text += ')'; }
    /// A space between the parts of a call.
    void separate() {
        if (!text.empty() && text.back() != '(' && text.back() != '\n') text += ' ';
    }
    void name(const Iri& iri) {
        separate();
        text += names_(iri);
    }
    template <typename Items, typename Show>
    void call(std::string_view word, const Items& items, Show show) {
        open(word);
        for (const auto& item : items) show(item);
        close();
    }
    void restriction(const ClassExpression& expression, const char* word, bool is_cardinality);
    void atom(const RuleAtom& atom);
    void keys(const Axiom& axiom, const Ontology* ontology);

    WriteNames& names_;
};

void FunctionalWriter::write(const PropertyExpression& property) {
    if (!property.inverse) return name(property.iri);
    open("ObjectInverseOf");
    name(property.iri);
    close();
}

void FunctionalWriter::restriction(const ClassExpression& expression, const char* word, bool is_cardinality) {
    const bool over_data = expression.kind >= ClassKind::data_some_values_from;
    open(std::string(over_data ? "Data" : "Object") + word);
    if (is_cardinality) text += std::to_string(expression.number);
    write(expression.property);
    if (expression.kind == ClassKind::has_value)
        name(expression.individuals.at(0));
    else if (expression.kind == ClassKind::data_has_value) {
        separate();
        write(expression.range.values.at(0));
    } else if (over_data)
        write(expression.range);
    else if (!expression.operands.empty())
        write(*expression.operands[0]);
    close();
}

void FunctionalWriter::write(const ClassExpression& expression) {
    const auto operands = [&](const char* word) {
        call(word, expression.operands, [&](const ClassPointer& item) { write(*item); });
    };
    switch (expression.kind) {
        case ClassKind::named:
            return name(expression.iri);
        case ClassKind::intersection_of:
            return operands("ObjectIntersectionOf");
        case ClassKind::union_of:
            return operands("ObjectUnionOf");
        case ClassKind::complement_of:
            return operands("ObjectComplementOf");
        case ClassKind::one_of:
            return call("ObjectOneOf", expression.individuals, [&](const Iri& item) { name(item); });
        case ClassKind::some_values_from:
        case ClassKind::data_some_values_from:
            return restriction(expression, "SomeValuesFrom", false);
        case ClassKind::all_values_from:
        case ClassKind::data_all_values_from:
            return restriction(expression, "AllValuesFrom", false);
        case ClassKind::has_value:
        case ClassKind::data_has_value:
            return restriction(expression, "HasValue", false);
        case ClassKind::has_self:
            return restriction(expression, "HasSelf", false);
        case ClassKind::min_cardinality:
        case ClassKind::data_min_cardinality:
            return restriction(expression, "MinCardinality", true);
        case ClassKind::max_cardinality:
        case ClassKind::data_max_cardinality:
            return restriction(expression, "MaxCardinality", true);
        case ClassKind::exact_cardinality:
        case ClassKind::data_exact_cardinality:
            return restriction(expression, "ExactCardinality", true);
    }
}

void FunctionalWriter::write(const DataRange& range) {
    const auto operands = [&](const char* word) {
        call(word, range.operands, [&](const DataRange& item) { write(item); });
    };
    switch (range.kind) {
        case DataRangeKind::datatype:
            if (range.facets.empty()) return name(range.datatype);
            open("DatatypeRestriction");
            name(range.datatype);
            for (const auto& [facet, value] : range.facets) {
                name(facet);
                separate();
                write(value);
            }
            return close();
        case DataRangeKind::one_of:
            return call("DataOneOf", range.values, [&](const Literal& item) {
                separate();
                write(item);
            });
        case DataRangeKind::intersection_of:
            return operands("DataIntersectionOf");
        case DataRangeKind::union_of:
            return operands("DataUnionOf");
        case DataRangeKind::complement_of:
            return operands("DataComplementOf");
    }
}

void FunctionalWriter::atom(const RuleAtom& atom) {
    constexpr const char* words[] = {"ClassAtom",        "DataRangeAtom",      "ObjectPropertyAtom",
                                     "DataPropertyAtom", "SameIndividualAtom", "DifferentIndividualsAtom",
                                     "BuiltInAtom"};
    open(words[static_cast<int>(atom.kind)]);
    if (atom.kind == RuleAtom::Kind::of_class) write(*atom.klass);
    if (atom.kind == RuleAtom::Kind::of_data_range) write(atom.range);
    if (atom.kind == RuleAtom::Kind::object_property || atom.kind == RuleAtom::Kind::data_property)
        write(atom.property);
    if (atom.kind == RuleAtom::Kind::built_in) name(atom.iri);
    for (const RuleTerm& term : atom.arguments) {
        if (term.kind == RuleTerm::Kind::variable) {
            open("Variable");
            name(term.iri);
            close();
        } else if (term.kind == RuleTerm::Kind::individual) {
            name(term.iri);
        } else {
            separate();
            write(term.literal);
        }
    }
    close();
}

void FunctionalWriter::write(const Rule& rule) {
    call("Body", rule.body, [&](const RuleAtom& item) { atom(item); });
    call("Head", rule.head, [&](const RuleAtom& item) { atom(item); });
}

void FunctionalWriter::annotations(const std::vector<Annotation>& list) {
    for (const Annotation& annotation : list) write(annotation, "Annotation", {});
}

void FunctionalWriter::write(const Annotation& annotation, const char* call, const std::string& subject) {
    open(call);
    annotations(annotation.annotations);
    name(annotation.property);
    if (!subject.empty()) text += " " + subject;
    separate();
    if (annotation.iri.empty())
        write(annotation.literal);
    else
        name(annotation.iri);
    close();
}

void FunctionalWriter::keys(const Axiom& axiom, const Ontology* ontology) {
    for (const bool over_data : {false, true}) {
        separate();
        text += '(';
        for (const PropertyExpression& property : axiom.properties) {
            const bool is_data =
                ontology != nullptr && ontology->find(property.iri, EntityKind::data_property) != nullptr;
            if (is_data == over_data) write(property);
        }
        text += ')';
    }
}

void FunctionalWriter::write(const Axiom& axiom, const Ontology* ontology) {
    open(axiom_words[static_cast<std::size_t>(axiom.kind)]);
    if (ontology != nullptr) annotations(axiom.annotations);
    const bool is_chain = axiom.kind == AxiomKind::sub_object_property_of && axiom.properties.size() > 2;
    const auto classes = [&] {
        for (const ClassPointer& item : axiom.classes) write(*item);
    };
    // Functional syntax has the class first in an assertion and in a key, the property first in all else.
    if (axiom.kind == AxiomKind::has_key) {
        classes();
        keys(axiom, ontology);
    } else if (is_chain) {
        const std::vector<PropertyExpression> chain(axiom.properties.begin(), axiom.properties.end() - 1);
        call("ObjectPropertyChain", chain, [&](const PropertyExpression& item) { write(item); });
        write(axiom.properties.back());
    } else {
        for (const PropertyExpression& item : axiom.properties) write(item);
        classes();
    }
    for (const Iri& item : axiom.individuals) name(item);
    if (axiom.kind == AxiomKind::datatype_definition) name(axiom.datatype);
    if (axiom.kind == AxiomKind::datatype_definition || axiom.kind == AxiomKind::data_property_range)
        write(axiom.range);
    if (axiom.kind == AxiomKind::data_property_assertion || axiom.kind == AxiomKind::negative_data_property_assertion) {
        separate();
        write(axiom.literal);
    }
    if (axiom.rule) write(*axiom.rule);
    close();
}

/// What is said of an entity; of an annotation property it may be its domain, range or super-property.
void FunctionalWriter::annotation_axiom(const Iri& subject, const Annotation& note, bool is_property) {
    const std::string rdfs = rdfs_prefix;
    const char* axiom = note.property == rdfs + "domain"          ? "AnnotationPropertyDomain"
                        : note.property == rdfs + "range"         ? "AnnotationPropertyRange"
                        : note.property == rdfs + "subPropertyOf" ? "SubAnnotationPropertyOf"
                                                                  : nullptr;
    if (!is_property || axiom == nullptr || note.iri.empty())
        return write(note, "AnnotationAssertion", names_(subject));
    open(axiom);
    annotations(note.annotations);
    name(subject);
    name(note.iri);
    close();
}

std::string body_of(const Ontology& ontology, WriteNames& names) {
    FunctionalWriter writer(names);
    constexpr const char* types[] = {"Class",           "ObjectProperty", "DataProperty", "AnnotationProperty",
                                     "NamedIndividual", "Datatype"};
    for (const Entity& entity : ontology.entities) {
        if (!names.is_ours(entity.source)) continue;
        writer.text +=
            std::string("Declaration(") + types[static_cast<int>(entity.kind)] + "(" + names(entity.iri) + "))\n";
    }
    for (const auto& [subject, notes] : ontology.annotations) {
        for (const Annotation& note : notes) {
            if (!names.is_ours(note.source) || subject == ontology.iri) continue;
            writer.annotation_axiom(subject, note, ontology.find(subject, EntityKind::annotation_property) != nullptr);
            writer.text += '\n';
        }
    }
    for (const Axiom& axiom : ontology.axioms) {
        if (!names.is_ours(axiom.source)) continue;
        writer.write(axiom, &ontology);
        writer.text += '\n';
    }
    return std::move(writer.text);
}

}  // namespace

std::string functional_text(const Axiom& axiom) {
    WriteNames names;
    FunctionalWriter writer(names);
    writer.write(axiom, nullptr);
    return std::move(writer.text);
}

std::string write_functional(const Ontology& ontology, const WriteOptions& options) {
    WriteNames names(ontology, options);
    std::string head = "Ontology(";
    const Iri version = version_of(ontology);
    if (!ontology.iri.empty()) head += between("<", ontology.iri, ">");
    if (!version.empty()) head += between("\n<", version, ">");
    head += '\n';
    for (const Iri& iri : names.imports()) head += between("Import(<", iri, ">)\n");
    if (const auto notes = ontology.annotations.find(ontology.iri); notes != ontology.annotations.end()) {
        FunctionalWriter writer(names);
        for (const Annotation& note : notes->second) {
            if (!names.is_ours(note.source) || (is_version(note) && !version.empty())) continue;
            writer.write(note, "Annotation", {});
            writer.text += '\n';
        }
        head += writer.text;
    }
    const std::string body = body_of(ontology, names);
    std::string prefixes;
    for (const auto& [prefix, space] : names.used_prefixes())
        prefixes += between("Prefix(", prefix, "=<") + space + ">)\n";
    return prefixes + "\n" + head + "\n" + body + ")\n";
}

}  // namespace partonomy::owl
