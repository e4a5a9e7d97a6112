// The axioms of functional syntax and OWL/XML, said as triples (W3C OWL 2 "Mapping to RDF Graphs", table 1). Where the
// syntax tells the role of a name and the triples do not (an undeclared property of an assertion would be taken for an
// annotation), the role is noted beside the triples and checked with the declarations.

#include "owl/structural.h"

#include <algorithm>
#include <functional>
#include <iterator>
#include <string_view>
#include <unordered_map>

#include "base/errors.h"

namespace partonomy::owl {
namespace {

/// How many parts make an axiom, and what reads it.
enum class Family { class_axiom, property_axiom, assertion, annotation_axiom, declaration, key, rule, import, note };

const std::unordered_map<std::string_view, Family>& families() {
    using enum Family;
    static const std::unordered_map<std::string_view, Family> map = {
        {"SubClassOf", class_axiom},
        {"EquivalentClasses", class_axiom},
        {"DisjointClasses", class_axiom},
        {"DisjointUnion", class_axiom},
        {"DatatypeDefinition", class_axiom},
        {"SubObjectPropertyOf", property_axiom},
        {"EquivalentObjectProperties", property_axiom},
        {"DisjointObjectProperties", property_axiom},
        {"InverseObjectProperties", property_axiom},
        {"ObjectPropertyDomain", property_axiom},
        {"ObjectPropertyRange", property_axiom},
        {"FunctionalObjectProperty", property_axiom},
        {"InverseFunctionalObjectProperty", property_axiom},
        {"ReflexiveObjectProperty", property_axiom},
        {"IrreflexiveObjectProperty", property_axiom},
        {"SymmetricObjectProperty", property_axiom},
        {"AsymmetricObjectProperty", property_axiom},
        {"TransitiveObjectProperty", property_axiom},
        {"SubDataPropertyOf", property_axiom},
        {"EquivalentDataProperties", property_axiom},
        {"DisjointDataProperties", property_axiom},
        {"DataPropertyDomain", property_axiom},
        {"DataPropertyRange", property_axiom},
        {"FunctionalDataProperty", property_axiom},
        {"SameIndividual", assertion},
        {"DifferentIndividuals", assertion},
        {"ClassAssertion", assertion},
        {"ObjectPropertyAssertion", assertion},
        {"NegativeObjectPropertyAssertion", assertion},
        {"DataPropertyAssertion", assertion},
        {"NegativeDataPropertyAssertion", assertion},
        {"AnnotationAssertion", annotation_axiom},
        {"SubAnnotationPropertyOf", annotation_axiom},
        {"AnnotationPropertyDomain", annotation_axiom},
        {"AnnotationPropertyRange", annotation_axiom},
        {"HasKey", key},
        {"DLSafeRule", rule},
        {"Declaration", declaration},
        {"Import", import},
        {"Annotation", note},
    };
    return map;
}

constexpr std::size_t any_number = static_cast<std::size_t>(-1);

}  // namespace

bool is_typed_name(const std::string& name) {
    for (const char* type :
         {"Class", "Datatype", "ObjectProperty", "DataProperty", "AnnotationProperty", "NamedIndividual", "Variable"}) {
        if (name == type) return true;
    }
    return false;
}

void StructuralReader::fail(const Construct& construct, const std::string& sentence) const {
    throw OntologyError(at(graph_.file, construct.line, sentence));
}

void StructuralReader::misplaced(const Construct& construct, const std::string& wanted) const {
    std::string what = "an IRI";
    switch (construct.kind) {
        case Construct::Kind::call:
            what = construct.name;
            break;
        case Construct::Kind::group:
            what = "a list in parentheses";
            break;
        case Construct::Kind::iri:
            what = (construct.name.empty() ? "" : construct.name + " ") + short_name(construct.value);
            break;
        case Construct::Kind::anonymous:
            what = "an anonymous individual";
            break;
        case Construct::Kind::literal:
            what = "a literal";
            break;
    }
    fail(construct, wanted + " is expected where " + what + " stands");
}

void StructuralReader::want(const Construct& construct, std::size_t first, std::size_t least, std::size_t most) const {
    const std::size_t count = construct.parts.size() - first;
    if (count >= least && count <= most) return;
    fail(construct, construct.name + " wants " + (most == any_number ? "at least " : "") + std::to_string(least) +
                        (most != any_number && most != least ? " or " + std::to_string(most) : "") +
                        (least == 1 && most == 1 ? " part" : " parts") + ", here are " + std::to_string(count));
}

std::vector<Node> StructuralReader::each(const Construct& construct, std::size_t first, Read reader) {
    std::vector<Node> nodes;
    for (std::size_t i = first; i < construct.parts.size(); ++i) nodes.push_back((this->*reader)(construct.parts[i]));
    return nodes;
}

void StructuralReader::ontology(const Iri& iri, const Iri& version, long line) {
    ontology_ = iri.empty() ? graph_.blank() : graph_.iri(iri, line);
    say_.say(ontology_, Word::rdf_type, Word::owl_Ontology, line);
    if (!version.empty()) say_.say(ontology_, Word::owl_versionIRI, graph_.iri(version, line), line);
}

void StructuralReader::import(const Construct& construct) {
    want(construct, 0, 1, 1);
    if (construct.parts[0].kind != Construct::Kind::iri) misplaced(construct.parts[0], "the IRI of an ontology");
    say_.say(ontology_, Word::owl_imports, graph_.iri(construct.parts[0].value, construct.line), construct.line);
}

void StructuralReader::read(const Construct& construct) {
    const auto family = families().find(construct.kind == Construct::Kind::call ? construct.name : std::string());
    if (family == families().end()) misplaced(construct, "an axiom such as SubClassOf or Declaration");
    if (family->second == Family::import) return import(construct);
    if (family->second == Family::note) return say_.annotate(ontology_, {annotation(construct)});
    std::size_t first = 0;
    const std::vector<Note> notes = annotations(construct, first);
    switch (family->second) {
        case Family::class_axiom:
            return class_axiom(construct, first, notes);
        case Family::property_axiom:
            return property_axiom(construct, first, notes);
        case Family::assertion:
            return assertion(construct, first, notes);
        case Family::annotation_axiom:
            return annotation_axiom(construct, first, notes);
        case Family::key:
            return has_key(construct, first, notes);
        case Family::rule:
            return rule(construct, first, notes);
        default:
            return declaration(construct, first, notes);
    }
}

std::vector<Note> StructuralReader::annotations(const Construct& construct, std::size_t& first) {
    std::vector<Note> notes;
    while (first < construct.parts.size() && construct.parts[first].kind == Construct::Kind::call &&
           construct.parts[first].name == "Annotation") {
        notes.push_back(annotation(construct.parts[first++]));
    }
    return notes;
}

Note StructuralReader::annotation(const Construct& construct) {
    std::size_t first = 0;
    Note note;
    note.notes = annotations(construct, first);
    want(construct, first, 2, 2);
    note.line = construct.line;
    note.property = annotation_property(construct.parts[first]);
    note.value = annotation_value(construct.parts[first + 1]);
    return note;
}

void StructuralReader::declaration(const Construct& construct, std::size_t first, const std::vector<Note>& notes) {
    want(construct, first, 1, 1);
    const Construct& declared = construct.parts[first];
    constexpr std::pair<const char*, Word> types[] = {
        {"Class", Word::owl_Class},
        {"Datatype", Word::rdfs_Datatype},
        {"ObjectProperty", Word::owl_ObjectProperty},
        {"DataProperty", Word::owl_DatatypeProperty},
        {"AnnotationProperty", Word::owl_AnnotationProperty},
        {"NamedIndividual", Word::owl_NamedIndividual},
    };
    const auto* const type =
        std::ranges::find_if(types, [&](const auto& entry) { return declared.name == entry.first; });
    if (type == std::end(types) || declared.kind != Construct::Kind::iri)
        misplaced(declared, "Class, ObjectProperty or another kind of entity with its name");
    say_.axiom(graph_.iri(declared.value, declared.line), Word::rdf_type, graph_.word(type->second), construct.line,
               notes);
}

void StructuralReader::class_axiom(const Construct& axiom, std::size_t first, const std::vector<Note>& notes) {
    if (axiom.name == "DatatypeDefinition") {
        want(axiom, first, 2, 2);
        const Node datatype = entity(axiom.parts[first], EntityKind::datatype);
        return say_.axiom(datatype, Word::owl_equivalentClass, data_range(axiom.parts[first + 1]), axiom.line, notes);
    }
    want(axiom, first, 2, axiom.name == "SubClassOf" ? 2 : any_number);
    std::vector<Node> classes = each(axiom, first, &StructuralReader::class_expression);
    if (axiom.name == "SubClassOf") {
        say_.axiom(classes[0], Word::rdfs_subClassOf, classes[1], axiom.line, notes);
    } else if (axiom.name == "EquivalentClasses") {
        say_.chain(Word::owl_equivalentClass, classes, axiom.line, notes);
    } else if (axiom.name == "DisjointClasses") {
        say_.pairwise(Word::owl_disjointWith, Word::owl_AllDisjointClasses, Word::owl_members, classes, axiom.line,
                      notes);
    } else {
        const Node united = classes.front();
        classes.erase(classes.begin());
        say_.axiom(united, Word::owl_disjointUnionOf, say_.list(classes, axiom.line), axiom.line, notes);
    }
}

void StructuralReader::property_axiom(const Construct& axiom, std::size_t first, const std::vector<Note>& notes) {
    const std::string_view name = axiom.name;
    const bool over_data = name.find("Data") != std::string_view::npos;
    const Read reader = over_data ? &StructuralReader::data_property : &StructuralReader::object_property;
    const auto property = [&](const Construct& part) { return (this->*reader)(part); };
    if (name.starts_with("Equivalent") || name.starts_with("Disjoint")) {
        want(axiom, first, 2, any_number);
        const std::vector<Node> properties = each(axiom, first, reader);
        if (name.starts_with("Equivalent"))
            say_.chain(Word::owl_equivalentProperty, properties, axiom.line, notes);
        else
            say_.pairwise(Word::owl_propertyDisjointWith, Word::owl_AllDisjointProperties, Word::owl_members,
                          properties, axiom.line, notes);
        return;
    }
    const bool is_pair = name.starts_with("Sub") || name.starts_with("InverseObject");
    const bool is_domain = name.ends_with("Domain");
    const bool is_range = name.ends_with("Range");
    want(axiom, first, is_pair || is_domain || is_range ? 2 : 1, is_pair || is_domain || is_range ? 2 : 1);
    const Construct& part = axiom.parts[first];
    if (is_pair) {
        if (part.kind == Construct::Kind::call && part.name == "ObjectPropertyChain" && name == "SubObjectPropertyOf") {
            want(part, 0, 2, any_number);
            const std::vector<Node> chain = each(part, 0, reader);
            const Node above = property(axiom.parts[first + 1]);
            return say_.axiom(above, Word::owl_propertyChainAxiom, say_.list(chain, axiom.line), axiom.line, notes);
        }
        if (name.starts_with("InverseObject")) return inverse_properties(axiom, part, axiom.parts[first + 1], notes);
        const Node left = property(part);
        return say_.axiom(left, Word::rdfs_subPropertyOf, property(axiom.parts[first + 1]), axiom.line, notes);
    }
    const Node node = property(part);
    if (is_domain || is_range) {
        const Construct& bound = axiom.parts[first + 1];
        return say_.axiom(node, is_domain ? Word::rdfs_domain : Word::rdfs_range,
                          is_range && over_data ? data_range(bound) : class_expression(bound), axiom.line, notes);
    }
    const Word type = name.starts_with("InverseFunctional") ? Word::owl_InverseFunctionalProperty
                      : name.starts_with("Functional")      ? Word::owl_FunctionalProperty
                      : name.starts_with("Reflexive")       ? Word::owl_ReflexiveProperty
                      : name.starts_with("Irreflexive")     ? Word::owl_IrreflexiveProperty
                      : name.starts_with("Symmetric")       ? Word::owl_SymmetricProperty
                      : name.starts_with("Asymmetric")      ? Word::owl_AsymmetricProperty
                                                            : Word::owl_TransitiveProperty;
    say_.axiom(node, Word::rdf_type, graph_.word(type), axiom.line, notes);
}

/// As triples `[ owl:inverseOf p ] owl:inverseOf q` would be one node with two values: it is said the other way round,
/// and that p and q are inverse of each other for their inverses.
void StructuralReader::inverse_properties(const Construct& axiom, const Construct& first, const Construct& second,
                                          const std::vector<Note>& notes) {
    const auto is_inverse = [](const Construct& part) { return part.kind == Construct::Kind::call; };
    if (is_inverse(first) && is_inverse(second)) {
        for (const Construct* side : {&first, &second}) {
            if (side->name != "ObjectInverseOf") misplaced(*side, "an object property");
            want(*side, 0, 1, 1);
        }
        return inverse_properties(axiom, first.parts[0], second.parts[0], notes);
    }
    const Node left = object_property(is_inverse(first) ? second : first);
    say_.axiom(left, Word::owl_inverseOf, object_property(is_inverse(first) ? first : second), axiom.line, notes);
}

void StructuralReader::assertion(const Construct& axiom, std::size_t first, const std::vector<Note>& notes) {
    const std::string_view name = axiom.name;
    if (name == "SameIndividual" || name == "DifferentIndividuals") {
        want(axiom, first, 2, any_number);
        const std::vector<Node> nodes = each(axiom, first, &StructuralReader::individual);
        if (name == "SameIndividual") return say_.chain(Word::owl_sameAs, nodes, axiom.line, notes);
        return say_.pairwise(Word::owl_differentFrom, Word::owl_AllDifferent, Word::owl_members, nodes, axiom.line,
                             notes);
    }
    if (name == "ClassAssertion") {
        want(axiom, first, 2, 2);
        const Node type = class_expression(axiom.parts[first]);
        return say_.axiom(individual(axiom.parts[first + 1]), Word::rdf_type, type, axiom.line, notes);
    }
    want(axiom, first, 3, 3);
    const bool over_data = name.find("Data") != std::string_view::npos;
    const Construct& predicate = axiom.parts[first];
    const Node subject = individual(axiom.parts[first + 1]);
    const Node object = over_data ? literal(axiom.parts[first + 2]) : individual(axiom.parts[first + 2]);
    if (name.starts_with("Negative")) {
        const Node property = over_data ? data_property(predicate) : object_property(predicate);
        return say_.negative_assertion(subject, property,
                                       over_data ? Word::owl_targetValue : Word::owl_targetIndividual, object,
                                       axiom.line, notes);
    }
    if (!over_data && predicate.kind == Construct::Kind::call && predicate.name == "ObjectInverseOf") {
        want(predicate, 0, 1, 1);
        return say_.axiom(object, entity(predicate.parts[0], EntityKind::object_property), subject, axiom.line, notes);
    }
    say_.axiom(subject, entity(predicate, over_data ? EntityKind::data_property : EntityKind::object_property), object,
               axiom.line, notes);
}

void StructuralReader::annotation_axiom(const Construct& axiom, std::size_t first, const std::vector<Note>& notes) {
    const bool is_assertion = axiom.name == "AnnotationAssertion";
    want(axiom, first, is_assertion ? 3 : 2, is_assertion ? 3 : 2);
    const Node property = annotation_property(axiom.parts[first]);
    const Node second = annotation_value(axiom.parts[first + 1]);
    if (graph_.terms[second].kind == TermKind::literal) misplaced(axiom.parts[first + 1], "an IRI");
    if (is_assertion) {
        return say_.axiom(second, property, annotation_value(axiom.parts[first + 2]), axiom.line, notes);
    }
    const Word word = axiom.name == "SubAnnotationPropertyOf"    ? Word::rdfs_subPropertyOf
                      : axiom.name == "AnnotationPropertyDomain" ? Word::rdfs_domain
                                                                 : Word::rdfs_range;
    graph_.uses.push_back({property, EntityKind::annotation_property, axiom.line});
    say_.axiom(property, word, second, axiom.line, notes);
}

void StructuralReader::has_key(const Construct& axiom, std::size_t first, const std::vector<Note>& notes) {
    want(axiom, first, 2, any_number);
    const Node subject = class_expression(axiom.parts[first]);
    std::vector<Node> properties;
    for (std::size_t i = first + 1; i < axiom.parts.size(); ++i) {
        const Construct& part = axiom.parts[i];
        if (part.kind == Construct::Kind::group) {  // functional syntax: (object properties) (data properties)
            const bool over_data = i == first + 2;
            for (const Construct& member : part.parts)
                properties.push_back(over_data ? data_property(member) : object_property(member));
        } else {
            properties.push_back(part.name == "DataProperty" ? data_property(part) : object_property(part));
        }
    }
    if (properties.empty()) fail(axiom, "HasKey names no property; it needs at least one");
    say_.axiom(subject, Word::owl_hasKey, say_.list(properties, axiom.line), axiom.line, notes);
}

}  // namespace partonomy::owl
