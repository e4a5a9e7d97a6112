#pragma once

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "owl/ontology.h"

namespace partonomy::knowledge {

/// The same ontology in fewer words, axiom by axiom and in the same order, so that what reads it knows one name for
/// each thing:
/// - properties that are told to be equivalent or inverse to others are replaced by one of them (core's, if any):
///   `isPartOf some Chair` becomes `inverse hasPart some Chair`;
/// - named datatypes are replaced by their definitions;
/// - individuals that are the values of a range concept (Material EquivalentTo {oak, steel}) become classes:
///   `hasMaterial value oak` becomes `hasMaterial some oak`;
/// - a rule whose body is a tree around the one variable of its head becomes a SubClassOf (roll_up);
/// - axioms about features of core that no other file speaks of (unused_features.h) say nothing: Thing SubClassOf Thing.
/// Different names are taken to mean different values, as everywhere in a closed world.
[[nodiscard]] owl::Ontology plain_ontology(const owl::Ontology& ontology);

/// The individuals that are values of range concepts, each with the class that it is a value of; sorted.
[[nodiscard]] std::vector<std::pair<owl::Iri, owl::Iri>> value_individuals(const owl::Ontology& ontology);

/// The rule as "body SubClassOf: head", when the body's variables hang together as a tree around the head's only
/// variable and numbers are compared with constants; otherwise null. Only numbers of which `is_measured` holds are
/// compared.
[[nodiscard]] std::optional<std::pair<owl::ClassPointer, owl::ClassPointer>> roll_up(
    const owl::Rule& rule, const std::function<bool(const owl::Iri&)>& is_measured);

/// Whether a rule concludes that something is a member of the class.
[[nodiscard]] bool is_told_by_rule(const owl::Ontology& ontology, const owl::Iri& iri);

}  // namespace partonomy::knowledge
