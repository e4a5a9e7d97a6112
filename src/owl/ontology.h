#pragma once

#include <compare>
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace partonomy::owl {

/// Where an axiom was written.
struct Source {
    std::string file;
    long line = 0;  ///< 1-based line of the triple or of the axiom; 0 when unknown
};

/// A name in full. Equality is that of IRIs.
using Iri = std::string;

/// "Seat" of "https://…/furniture#Seat": what follows the last '#' or '/'.
[[nodiscard]] std::string local_name(const Iri& iri);

enum class ClassKind {
    named,             ///< iri
    intersection_of,   ///< operands
    union_of,          ///< operands
    complement_of,     ///< operands[0]
    one_of,            ///< individuals
    some_values_from,  ///< property, operands[0]
    all_values_from,   ///< property, operands[0]
    has_value,         ///< property, individuals[0]
    has_self,          ///< property
    min_cardinality,   ///< property, number, operands[0] (owl:Thing when unqualified)
    max_cardinality,
    exact_cardinality,
    data_some_values_from,  ///< property, range
    data_all_values_from,   ///< property, range
    data_has_value,         ///< property, range holds the one literal
    data_min_cardinality,   ///< property, number, range
    data_max_cardinality,
    data_exact_cardinality,
};

struct Literal {
    std::string value;
    Iri datatype;
    std::string language;
    auto operator<=>(const Literal&) const = default;
};

enum class DataRangeKind {
    datatype,         ///< datatype, facets
    one_of,           ///< values
    intersection_of,  ///< operands
    union_of,         ///< operands
    complement_of,    ///< operands[0]
};

/// A set of literals: a datatype with facets, such as xsd:double[>= 0.4, <= 0.48]; an enumeration; or made of others.
struct DataRange {
    DataRangeKind kind = DataRangeKind::datatype;
    Iri datatype;
    std::vector<std::pair<Iri, Literal>> facets;  ///< xsd:minInclusive … in the order of the file
    std::vector<Literal> values;
    std::vector<DataRange> operands;
    // Not defaulted: clang 14 does not see the operator inside its own class.
    [[nodiscard]] std::strong_ordering operator<=>(const DataRange& other) const;
    [[nodiscard]] bool operator==(const DataRange& other) const { return (*this <=> other) == 0; }
};

/// An object property, or the inverse of one.
struct PropertyExpression {
    Iri iri;
    bool inverse = false;
    auto operator<=>(const PropertyExpression&) const = default;
};

struct ClassExpression;
/// Shared and immutable, so that axioms are cheap to copy.
using ClassPointer = std::shared_ptr<const ClassExpression>;

struct ClassExpression {
    ClassKind kind = ClassKind::named;
    Iri iri;                      ///< of a named class
    PropertyExpression property;  ///< of a restriction; a data property has inverse == false
    std::uint32_t number = 0;     ///< of a cardinality
    std::vector<ClassPointer> operands;
    std::vector<Iri> individuals;
    DataRange range;
};

/// The expression in Manchester syntax with local names: "hasPart min 3 Leg". For traces and error sentences.
[[nodiscard]] std::string to_manchester(const ClassExpression& expression);

enum class AxiomKind {
    sub_class_of,            ///< classes[0] SubClassOf classes[1]
    equivalent_classes,      ///< classes
    disjoint_classes,        ///< classes
    disjoint_union,          ///< classes[0] = disjoint union of the rest
    sub_object_property_of,  ///< properties[0..n-2] (a chain when more than one), properties.back()
    equivalent_object_properties,
    inverse_object_properties,  ///< properties[0], properties[1]
    disjoint_object_properties,
    object_property_domain,  ///< properties[0], classes[0]
    object_property_range,   ///< properties[0], classes[0]
    functional_object_property,
    inverse_functional_object_property,
    symmetric_object_property,
    asymmetric_object_property,
    transitive_object_property,
    reflexive_object_property,
    irreflexive_object_property,
    sub_data_property_of,
    equivalent_data_properties,
    disjoint_data_properties,
    data_property_domain,  ///< properties[0], classes[0]
    data_property_range,   ///< properties[0], range
    functional_data_property,
    class_assertion,            ///< classes[0], individuals[0]
    object_property_assertion,  ///< properties[0], individuals[0], individuals[1]
    negative_object_property_assertion,
    data_property_assertion,  ///< properties[0], individuals[0], literal
    same_individual,
    different_individuals,
    negative_data_property_assertion,  ///< properties[0], individuals[0], literal
    has_key,                           ///< classes[0], properties (object and data)
    datatype_definition,               ///< datatype = range
    rule,                              ///< DL-safe SWRL rule
};

/// An argument of a rule's atom: a variable, an individual (iri), or a literal.
struct RuleTerm {
    enum class Kind { variable, individual, literal } kind = Kind::variable;
    Iri iri;  ///< of a variable or individual
    Literal literal;
    auto operator<=>(const RuleTerm&) const = default;
};

struct RuleAtom {
    enum class Kind {
        of_class,         ///< klass(arguments[0])
        of_data_range,    ///< range(arguments[0])
        object_property,  ///< property(arguments[0], arguments[1])
        data_property,    ///< property(arguments[0], arguments[1])
        same_as,          ///< two arguments
        different_from,   ///< two arguments
        built_in,         ///< iri (swrlb:lessThan …) of all arguments
    } kind = Kind::of_class;
    ClassPointer klass;
    DataRange range;
    PropertyExpression property;
    Iri iri;
    std::vector<RuleTerm> arguments;
};

/// All of `body` implies all of `head`.
struct Rule {
    std::vector<RuleAtom> body, head;
};

struct Annotation {
    Iri property;
    Literal literal;  ///< when the value is a literal
    Iri iri;          ///< when the value is an IRI, or "_:…" for an anonymous individual
    Source source;
    std::vector<Annotation> annotations = {};  ///< of this annotation
};

struct Axiom {
    AxiomKind kind;
    std::vector<ClassPointer> classes;
    std::vector<PropertyExpression> properties;
    std::vector<Iri> individuals;
    DataRange range;
    Literal literal;
    Source source;
    Iri datatype = {};                      ///< that a datatype_definition defines
    std::shared_ptr<const Rule> rule = {};  ///< of a rule
    std::vector<Annotation> annotations = {};
};

/// The axiom on one line in Manchester-like words: "Seat EquivalentTo: Region and (hasShape some Board)".
[[nodiscard]] std::string to_manchester(const Axiom& axiom);

enum class EntityKind { klass, object_property, data_property, annotation_property, individual, datatype };

struct Entity {
    EntityKind kind;
    Iri iri;
    Source source;  ///< of its declaration
};

/// An ontology with its imports merged: what a document says, and where it says it.
struct Ontology {
    Iri iri;                                             ///< of the file that was asked for; empty when it names none
    std::string sha256;                                  ///< of that file's bytes; empty when it was parsed from memory
    std::vector<std::pair<Iri, std::string>> imports;    ///< every imported ontology and the file it came from
    std::vector<Entity> entities;                        ///< sorted by IRI
    std::vector<Axiom> axioms;                           ///< in the order of files and lines: imports first
    std::map<Iri, std::vector<Annotation>> annotations;  ///< of entities, in file order

    [[nodiscard]] const Entity* find(const Iri& iri, EntityKind kind) const;
    /// The rdfs:label in `language`, else without language, else the local name.
    [[nodiscard]] std::string label(const Iri& iri, const std::string& language = "en") const;
};

struct LoadOptions {
    std::vector<std::filesystem::path> import_folders;  ///< searched for imports after the file's own folder
    /// False: features of the built-in core that no other file speaks of are left out (core_module.h), as if core did
    /// not have them. What the ontology means stays the same, and it is read in half the time.
    bool whole_core = true;
};

/// Reads an ontology in Turtle, N-Triples, RDF/XML, OWL/XML, functional or Manchester syntax, recognised by content,
/// with its imports, which are resolved offline only: catalog-v001.xml beside the file, then files in the file's folder
/// and in `import_folders` whose ontology IRI (or version IRI) is the one imported. The core ontology is built in; only
/// the catalog and `import_folders` can put another file in its place. Cycles are fine. Throws FileError; OntologyError
/// with file and line: syntax, import not found, a statement that is no OWL 2.
[[nodiscard]] Ontology load_ontology(const std::filesystem::path& path, const LoadOptions& options = {});

/// The same from memory; `name` is what error sentences call it, imports resolve to the core ontology only.
[[nodiscard]] Ontology parse_ontology(const std::string& bytes, const std::string& name);

/// The text of ontologies/core.ttl as built into the program.
[[nodiscard]] const std::string& core_ontology_text();

/// IRI of the core ontology without '#', and the prefix of its terms.
inline constexpr const char* core_iri = "https://w3id.org/partonomy/core";
inline constexpr const char* core_prefix = "https://w3id.org/partonomy/core#";

}  // namespace partonomy::owl
