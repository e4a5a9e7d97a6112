#pragma once

#include <string>

namespace partonomy::owl {

/// The IRIs with a meaning of their own in the RDF syntax of OWL 2 and of SWRL rules. A list in one place: the enum and
/// the look-up grow from it.
// clang-format off
#define PARTONOMY_OWL_WORDS(X)                                                                                         \
    X(owl, AllDifferent) X(owl, AllDisjointClasses) X(owl, AllDisjointProperties) X(owl, Annotation)                   \
    X(owl, AnnotationProperty)                                                                                         \
    X(owl, AsymmetricProperty) X(owl, Axiom) X(owl, Class) X(owl, DataRange) X(owl, DatatypeProperty)                  \
    X(owl, DeprecatedClass) X(owl, DeprecatedProperty) X(owl, FunctionalProperty) X(owl, InverseFunctionalProperty)    \
    X(owl, IrreflexiveProperty) X(owl, NamedIndividual) X(owl, NegativePropertyAssertion) X(owl, Nothing)              \
    X(owl, ObjectProperty) X(owl, Ontology) X(owl, OntologyProperty) X(owl, ReflexiveProperty) X(owl, Restriction)     \
    X(owl, SymmetricProperty) X(owl, Thing) X(owl, TransitiveProperty) X(owl, allValuesFrom)                           \
    X(owl, annotatedProperty) X(owl, annotatedSource) X(owl, annotatedTarget) X(owl, assertionProperty)                \
    X(owl, backwardCompatibleWith) X(owl, bottomDataProperty) X(owl, bottomObjectProperty) X(owl, cardinality)         \
    X(owl, complementOf) X(owl, datatypeComplementOf) X(owl, deprecated) X(owl, differentFrom)                         \
    X(owl, disjointUnionOf) X(owl, disjointWith) X(owl, distinctMembers) X(owl, equivalentClass)                       \
    X(owl, equivalentProperty) X(owl, hasKey) X(owl, hasSelf) X(owl, hasValue) X(owl, imports)                         \
    X(owl, incompatibleWith) X(owl, intersectionOf) X(owl, inverseOf) X(owl, maxCardinality)                           \
    X(owl, maxQualifiedCardinality) X(owl, members) X(owl, minCardinality) X(owl, minQualifiedCardinality)             \
    X(owl, onClass) X(owl, onDataRange) X(owl, onDatatype) X(owl, onProperties) X(owl, onProperty) X(owl, oneOf)       \
    X(owl, priorVersion) X(owl, propertyChainAxiom) X(owl, propertyDisjointWith) X(owl, qualifiedCardinality)          \
    X(owl, rational) X(owl, real) X(owl, sameAs) X(owl, someValuesFrom) X(owl, sourceIndividual)                       \
    X(owl, targetIndividual) X(owl, targetValue) X(owl, topDataProperty) X(owl, topObjectProperty) X(owl, unionOf)     \
    X(owl, versionIRI) X(owl, versionInfo) X(owl, withRestrictions) X(rdf, List) X(rdf, PlainLiteral)                  \
    X(rdf, Property) X(rdf, XMLLiteral) X(rdf, first) X(rdf, langRange) X(rdf, langString) X(rdf, nil) X(rdf, rest)    \
    X(rdf, type) X(rdfs, Class) X(rdfs, Datatype) X(rdfs, Literal) X(rdfs, comment) X(rdfs, domain)                    \
    X(rdfs, isDefinedBy) X(rdfs, label) X(rdfs, range) X(rdfs, seeAlso) X(rdfs, subClassOf) X(rdfs, subPropertyOf)     \
    X(swrl, AtomList) X(swrl, Builtin) X(swrl, BuiltinAtom) X(swrl, ClassAtom) X(swrl, DataRangeAtom)                  \
    X(swrl, DatavaluedPropertyAtom) X(swrl, DifferentIndividualsAtom) X(swrl, Imp) X(swrl, IndividualPropertyAtom)     \
    X(swrl, SameIndividualAtom) X(swrl, Variable) X(swrl, argument1) X(swrl, argument2) X(swrl, arguments)             \
    X(swrl, body) X(swrl, builtin) X(swrl, classPredicate) X(swrl, dataRange) X(swrl, head)                            \
    X(swrl, propertyPredicate)
// clang-format on

enum class Word {
    none,
#define PARTONOMY_OWL_WORD(prefix, name) prefix##_##name,
    PARTONOMY_OWL_WORDS(PARTONOMY_OWL_WORD)
#undef PARTONOMY_OWL_WORD
};

inline constexpr const char* owl_prefix = "http://www.w3.org/2002/07/owl#";
inline constexpr const char* rdf_prefix = "http://www.w3.org/1999/02/22-rdf-syntax-ns#";
inline constexpr const char* rdfs_prefix = "http://www.w3.org/2000/01/rdf-schema#";
inline constexpr const char* xsd_prefix = "http://www.w3.org/2001/XMLSchema#";

/// Local names of the XML Schema datatypes whose values are numbers.
inline constexpr const char* numeric_datatypes[] = {"double",
                                                    "float",
                                                    "decimal",
                                                    "integer",
                                                    "nonNegativeInteger",
                                                    "nonPositiveInteger",
                                                    "positiveInteger",
                                                    "negativeInteger",
                                                    "long",
                                                    "int",
                                                    "short",
                                                    "byte",
                                                    "unsignedLong",
                                                    "unsignedInt",
                                                    "unsignedShort",
                                                    "unsignedByte"};
inline constexpr const char* swrl_prefix = "http://www.w3.org/2003/11/swrl#";
inline constexpr const char* swrlb_prefix = "http://www.w3.org/2003/11/swrlb#";  ///< of SWRL's built-ins

/// The word that `iri` is, Word::none for all others.
[[nodiscard]] Word word_of(const std::string& iri);

/// "owl:Class" for the four vocabularies of OWL 2, the local name for other IRIs: how error sentences say an IRI.
[[nodiscard]] std::string short_name(const std::string& iri);

/// `text` between two words. Appended piece by piece: in a chain of + GCC 12 sees an overlap that is not there.
[[nodiscard]] std::string between(const char* open, const std::string& text, const char* close);

}  // namespace partonomy::owl
