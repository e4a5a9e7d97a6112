// Annotations: of entities, which are triples, and of axioms and other annotations, which are nodes of type owl:Axiom
// or owl:Annotation that repeat the triple they are about (W3C OWL 2 "Mapping to RDF Graphs", tables 2 and 17). Tools
// repeat a class expression in two ways: by the same blank node, or by writing it out once more. So the axiom is looked
// for by its triple first, and then by what it says. The annotations of declarations are checked and left out.

#include "base/errors.h"
#include "owl/axiom_reader.h"
#include "owl/write.h"

namespace partonomy::owl {
namespace {

constexpr int max_depth = 100;

}  // namespace

bool AxiomReader::is_ontology(Node node) const {
    for (const std::uint32_t i : read_.about(node)) {
        const Triple& triple = graph_.triples[i];
        if (word(triple.predicate) == Word::rdf_type && word(triple.object) == Word::owl_Ontology) return true;
    }
    return false;
}

Annotation AxiomReader::annotation(const Triple& triple) {
    const Term& object = term(triple.object);
    Annotation annotation;
    annotation.property = term(triple.predicate).value;
    annotation.source = {graph_.file, triple.line};
    if (object.kind == TermKind::literal)
        annotation.literal = read_.literal(triple.object);
    else
        annotation.iri = object.kind == TermKind::iri ? object.value : names_.name(graph_, triple.object);
    return annotation;
}

void AxiomReader::annotate(const Triple& triple) {
    const std::size_t i = index(triple);
    if (i == none) return;
    use(triple);
    if (nodes_.contains(triple.subject)) {
        notes_[triple.subject].push_back(i);
        return;
    }
    Iri subject;  // stays empty for an ontology without name
    if (term(triple.subject).kind == TermKind::iri)
        subject = term(triple.subject).value;
    else if (!is_ontology(triple.subject))
        subject = names_.name(graph_, triple.subject);
    std::vector<Annotation>& list = ontology_.annotations[subject];
    if (!reified_.empty()) annotation_of_triple_[i] = {subject, list.size()};
    list.push_back(annotation(triple));
}

void AxiomReader::reified(const Triple& triple) {
    nodes_.insert(triple.subject);
    const Triple& source = only(triple, Word::owl_annotatedSource, "owl:annotatedSource");
    const Triple& property = only(triple, Word::owl_annotatedProperty, "owl:annotatedProperty");
    const Triple& target = only(triple, Word::owl_annotatedTarget, "owl:annotatedTarget");
    reified_.push_back({triple.subject, source.object, property.object, target.object, triple.line});
}

std::size_t AxiomReader::find_triple(Node subject, Node predicate, Node object) {
    if (triples_.empty()) {
        for (std::size_t i = 0; i < graph_.triples.size(); ++i) {
            const Triple& triple = graph_.triples[i];
            triples_.emplace(std::tuple(triple.subject, triple.predicate, triple.object), i);
        }
    }
    const auto found = triples_.find({subject, predicate, object});
    return found == triples_.end() ? none : found->second;
}

/// Reads the axiom that `triple` would make, and takes it out again.
Axiom* AxiomReader::find_equal_axiom(const Triple& triple) {
    std::vector<Axiom>& axioms = ontology_.axioms;
    if (axioms_by_text_.empty()) {
        for (std::size_t i = first_axiom_; i < axioms.size(); ++i)
            axioms_by_text_.emplace(functional_text(axioms[i]), i);
    }
    const std::size_t count = axioms.size();
    statement(triple);
    if (axioms.size() == count) return nullptr;
    const auto found = axioms_by_text_.find(functional_text(axioms.back()));
    axioms.resize(count);
    return found == axioms_by_text_.end() ? nullptr : &axioms[found->second];
}

void AxiomReader::attach(Node node, Node subject, Node property, Node target, long line) {
    std::vector<Annotation> notes = notes_of(node, 0);
    const auto append = [&notes](std::vector<Annotation>& list) {
        for (Annotation& note : notes) list.push_back(std::move(note));
    };
    if (const std::size_t i = find_triple(subject, property, target); i != none) {
        if (const auto axiom = axiom_of_triple_.find(i); axiom != axiom_of_triple_.end())
            append(ontology_.axioms[axiom->second].annotations);
        else if (const auto place = annotation_of_triple_.find(i); place != annotation_of_triple_.end())
            append(ontology_.annotations[place->second.first][place->second.second].annotations);
        return;
    }
    Axiom* axiom = nullptr;
    if (read_.is_structure(subject) || read_.is_structure(target))
        axiom = find_equal_axiom({subject, property, target, line});
    if (axiom == nullptr) {
        read_.fail(line, "the axiom that is annotated here is not in the file; write '" + read_.shown(subject) + " " +
                             read_.shown(property) + " " + read_.shown(target) + "' beside it");
    }
    append(axiom->annotations);
}

std::vector<Annotation> AxiomReader::notes_of(Node node, int depth) {
    if (depth > max_depth) {
        read_.fail(graph_.triples[read_.about(node).front()].line,
                   "annotations of annotations are nested more than " + std::to_string(max_depth) + " deep");
    }
    std::vector<Annotation> notes;
    for (const std::size_t i : notes_[node]) {
        const Triple& triple = graph_.triples[i];
        notes.push_back(annotation(triple));
        const auto inner = note_nodes_.find({node, triple.predicate, triple.object});
        if (inner != note_nodes_.end()) notes.back().annotations = notes_of(inner->second, depth + 1);
    }
    return notes;
}

void AxiomReader::attach_annotations() {
    for (const Reified& about : reified_) {
        if (nodes_.contains(about.subject))
            note_nodes_.emplace(std::tuple(about.subject, about.property, about.target), about.node);
    }
    for (const auto& [node, axiom] : axiom_of_node_) {
        for (Annotation& note : notes_of(node, 0)) ontology_.axioms[axiom].annotations.push_back(std::move(note));
    }
    for (const Reified& about : reified_) {
        if (!nodes_.contains(about.subject))
            attach(about.node, about.subject, about.property, about.target, about.line);
        else if (find_triple(about.subject, about.property, about.target) == none)
            read_.fail(about.line, "the annotation that is annotated here is not in the file");
    }
}

}  // namespace partonomy::owl
