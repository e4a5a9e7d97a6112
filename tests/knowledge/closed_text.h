#pragma once

#include <string>

#include "knowledge/closed_world.h"

/// Closed worlds as text in a test: functional syntax with names such as :a; classes A B C, object properties p q r and
/// data properties d e are declared. Axiom n is on line n of "kb".
namespace closed_text {

using namespace partonomy;

inline owl::Iri iri(const std::string& name) { return "urn:kb#" + name; }

inline owl::Ontology ontology(const std::string& axioms) {
    std::string text =
        "Prefix(:=<urn:kb#>) Prefix(xsd:=<http://www.w3.org/2001/XMLSchema#>) "
        "Prefix(owl:=<http://www.w3.org/2002/07/owl#>) "
        "Prefix(rdfs:=<http://www.w3.org/2000/01/rdf-schema#>) Prefix(swrlb:=<http://www.w3.org/2003/11/swrlb#>) "
        "Ontology(<urn:kb> ";
    for (const char* name : {"A", "B", "C"}) text.append("Declaration(Class(:").append(name).append(")) ");
    for (const char* name : {"p", "q", "r"}) text.append("Declaration(ObjectProperty(:").append(name).append(")) ");
    for (const char* name : {"d", "e"}) text.append("Declaration(DataProperty(:").append(name).append(")) ");
    return owl::parse_ontology(text.append(axioms).append("\n)"), "kb");
}

/// `different`: the names that mean different individuals.
inline knowledge::ClosedWorld world(const std::string& axioms, const std::vector<std::string>& different = {}) {
    knowledge::ClosedWorld result{ontology(axioms), {}};
    for (const std::string& name : different) result.individuals.push_back(iri(name));
    return result;
}

}  // namespace closed_text
