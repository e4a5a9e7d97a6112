#pragma once

// What an ontology says, as a set of texts: order of operands, order of axioms, repetitions and the labels of anonymous
// individuals do not count, since the tools that convert ontologies change them.

#include <algorithm>
#include <set>
#include <string>

#include "owl/ontology.h"
#include "owl/write.h"

namespace partonomy::owl {

inline std::string text_of(const ClassPointer& expression) {
    Axiom axiom;
    axiom.kind = AxiomKind::sub_class_of;
    axiom.classes = {expression};
    return functional_text(axiom);
}

inline std::string text_of(const DataRange& range) {
    Axiom axiom;
    axiom.kind = AxiomKind::data_property_range;
    axiom.range = range;
    return functional_text(axiom);
}

inline DataRange sorted(DataRange range) {
    for (DataRange& operand : range.operands) operand = sorted(operand);
    std::ranges::sort(range.operands, {}, [](const DataRange& item) { return text_of(item); });
    std::ranges::sort(range.facets);
    std::ranges::sort(range.values);
    return range;
}

inline ClassPointer sorted(const ClassPointer& expression) {
    ClassExpression copy = *expression;
    for (ClassPointer& operand : copy.operands) operand = sorted(operand);
    std::ranges::sort(copy.operands, {}, [](const ClassPointer& item) { return text_of(item); });
    std::ranges::sort(copy.individuals);
    copy.range = sorted(copy.range);
    return std::make_shared<const ClassExpression>(std::move(copy));
}

inline std::string text_of(const std::vector<RuleAtom>& atoms) {
    std::set<std::string> texts;
    for (RuleAtom atom : atoms) {
        if (atom.klass) atom.klass = sorted(atom.klass);
        atom.range = sorted(atom.range);
        Axiom axiom;
        axiom.kind = AxiomKind::rule;
        axiom.rule = std::make_shared<const Rule>(Rule{{atom}, {}});
        texts.insert(functional_text(axiom));
    }
    std::string text;
    for (const std::string& item : texts) text += item + " ";
    return text;
}

inline std::string text_of(const std::vector<Annotation>& annotations) {
    std::set<std::string> texts;
    for (const Annotation& note : annotations) {
        texts.insert(" @(" + note.property + " " + note.iri + "|" + note.literal.value + "|" + note.literal.datatype +
                     "|" + note.literal.language + text_of(note.annotations) + ")");
    }
    std::string text;
    for (const std::string& item : texts) text += item;
    return text;
}

inline std::string text_of(Axiom axiom, bool with_annotations) {
    for (ClassPointer& expression : axiom.classes) expression = sorted(expression);
    axiom.range = sorted(axiom.range);
    const auto by_text = [](const ClassPointer& item) { return text_of(item); };
    switch (axiom.kind) {
        case AxiomKind::equivalent_classes:
        case AxiomKind::disjoint_classes:
            std::ranges::sort(axiom.classes, {}, by_text);
            break;
        case AxiomKind::disjoint_union:
            std::ranges::sort(axiom.classes.begin() + 1, axiom.classes.end(), {}, by_text);
            break;
        case AxiomKind::equivalent_object_properties:
        case AxiomKind::disjoint_object_properties:
        case AxiomKind::inverse_object_properties:
        case AxiomKind::equivalent_data_properties:
        case AxiomKind::disjoint_data_properties:
        case AxiomKind::has_key:
            std::ranges::sort(axiom.properties);
            break;
        case AxiomKind::same_individual:
        case AxiomKind::different_individuals:
            std::ranges::sort(axiom.individuals);
            break;
        default:
            break;
    }
    const std::string text =
        axiom.rule ? "Rule " + text_of(axiom.rule->body) + "-> " + text_of(axiom.rule->head) : functional_text(axiom);
    return with_annotations ? text + text_of(axiom.annotations) : text;
}

inline std::string without_labels(const std::string& text) {
    std::string out;
    for (std::size_t i = 0; i < text.size(); ++i) {
        out += text[i];
        if (out.ends_with("_:")) {
            while (i + 1 < text.size() && std::string(" )|").find(text[i + 1]) == std::string::npos) ++i;
        }
    }
    return out;
}

/// Axioms, with their annotations when asked for, each a text.
inline std::set<std::string> axioms_of(const Ontology& ontology, bool with_annotations = true) {
    std::set<std::string> texts;
    for (const Axiom& axiom : ontology.axioms) texts.insert(without_labels(text_of(axiom, with_annotations)));
    return texts;
}

/// Axioms, annotations and entities.
inline std::set<std::string> everything_in(const Ontology& ontology) {
    std::set<std::string> texts = axioms_of(ontology);
    texts.insert("Ontology " + ontology.iri);
    for (const Entity& entity : ontology.entities)
        texts.insert("Entity " + std::to_string(static_cast<int>(entity.kind)) + " " + entity.iri);
    for (const auto& [subject, notes] : ontology.annotations) {
        for (const Annotation& note : notes) texts.insert(without_labels("About " + subject + text_of({note})));
    }
    return texts;
}

/// What only one of two sets has, a line each; empty when they are equal.
inline std::string differences(const std::set<std::string>& one, const std::set<std::string>& other) {
    std::string text;
    for (const std::string& item : one)
        if (!other.contains(item)) text += "only the first:  " + item + "\n";
    for (const std::string& item : other)
        if (!one.contains(item)) text += "only the second: " + item + "\n";
    return text;
}

}  // namespace partonomy::owl
