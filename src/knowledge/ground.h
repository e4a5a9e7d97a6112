#pragma once

#include <map>
#include <optional>
#include <set>

#include "knowledge/theory.h"

namespace partonomy::knowledge {

/// What is told of properties: which are below which.
class PropertyHierarchy {
public:
    explicit PropertyHierarchy(const owl::Ontology& ontology);
    [[nodiscard]] bool is_empty() const { return above_.empty(); }
    /// All that are above `property`, each with an axiom that says so.
    [[nodiscard]] std::map<owl::PropertyExpression, std::size_t> above(const owl::PropertyExpression& property) const;

private:
    std::map<owl::PropertyExpression, std::vector<std::pair<owl::PropertyExpression, std::size_t>>> above_;
};

/// Equal for equal expressions only; IRIs in full.
[[nodiscard]] std::string key_of(const owl::ClassExpression& expression);

/// Whether the expressions are names and what and, or, not make of them.
[[nodiscard]] bool is_made_of_names(const std::vector<owl::ClassPointer>& expressions);

/// Turns class expressions into formulas of a theory whose ranges, numbers and concept names are already there.
class Grounder {
public:
    Grounder(const owl::Ontology& ontology, const std::map<Iri, Level>& levels, Theory& theory);

    /// `expression` as a statement about one region, composite part or object. Throws OntologyError naming `axiom`.
    FormulaId ground(const owl::ClassPointer& expression, Level level, const owl::Axiom& axiom);
    /// The same, but a class that is about something else holds nowhere, instead of being refused.
    FormulaId ground_within(const owl::ClassPointer& expression, Level level, const owl::Axiom& axiom);
    /// The values of range concept `range` that belong to `expression`, a Boolean combination of classes below
    /// core:Feature. With `strict`, values of other range concepts are refused; otherwise they are none of this one's.
    ConfigurationSet values(const owl::ClassExpression& expression, std::size_t range, const owl::Axiom& axiom,
                            bool strict);

    /// The classes of parts that composite parts were said to have since the last call, as written: (formula, level).
    /// Parts of those parts do not count.
    std::vector<std::pair<FormulaId, Level>> take_mentions();

    /// After an axiom that was refused half way.
    void start_over();

    FormulaId negate(FormulaId a);
    FormulaId conjoin(std::vector<FormulaId> operands);
    FormulaId disjoin(std::vector<FormulaId> operands);
    FormulaId named(int concept_id);
    [[nodiscard]] bool is_true(FormulaId a) const { return theory_.formulas[a].kind == Formula::Kind::truth; }

private:
    FormulaId add(Formula formula);
    FormulaId choice(std::size_t feature, ConfigurationSet values);
    FormulaId ground_name(const Iri& iri, Level level, const owl::Axiom& axiom);
    FormulaId ground_feature(const owl::ClassExpression& expression, std::size_t range, const owl::Axiom& axiom);
    FormulaId ground_number(const owl::ClassExpression& expression, const owl::Axiom& axiom);
    FormulaId ground_parts(const owl::ClassExpression& expression, Level level, const owl::Axiom& axiom);
    FormulaId ground_relation(const owl::ClassExpression& expression, const owl::Axiom& axiom);
    NodeTest ground_node(const owl::ClassPointer& expression, std::vector<FormulaId>& classes, const owl::Axiom& axiom);
    NodeTest ground_linked(const owl::ClassExpression& expression, std::vector<FormulaId>& classes,
                           const owl::Axiom& axiom);
    /// The property that leads to what a relation links the region to, for messages.
    [[nodiscard]] std::string other_side() const { return is_target_ ? "isReferenceRegion" : "isTargetRegion"; }
    [[nodiscard]] std::string pieces_of(const Iri& composite) const;
    [[nodiscard]] const owl::Axiom* leads_without_range(const Iri& feature) const;
    [[nodiscard]] const RangeConcept* range_of_value(const Iri& value) const;
    [[nodiscard]] bool is_functional(const Iri& property) const;
    [[nodiscard]] bool is_question(const owl::ClassExpression& expression, Level level) const;

    // open_restrictions.cpp
    FormulaId open(const owl::ClassExpression& expression, Level level, const owl::Axiom& axiom);
    FormulaId open_atom(const owl::ClassExpression& expression, Level level, const owl::Axiom& axiom);
    void link(FormulaId atom, const owl::ClassExpression& expression, Level level, const owl::Axiom& axiom);
    [[nodiscard]] std::vector<Iri> known_properties() const;
    std::optional<FormulaId> ground_if_possible(const owl::ClassPointer& expression, Level level,
                                                const owl::Axiom& axiom);

    const owl::Ontology& ontology_;
    const std::map<Iri, Level>& levels_;
    Theory& theory_;
    std::map<Iri, std::size_t> ranges_of_values_;
    std::set<Iri> range_names_;
    std::map<std::string, std::size_t> relational_;  ///< by key of the expression: into Theory::relational
    std::vector<Iri> open_;                          ///< classes of values whose definition is being read
    PropertyHierarchy hierarchy_;
    std::map<std::pair<Level, std::string>, FormulaId> open_atoms_;  ///< by layer and key
    bool is_target_ = true;                                          ///< of the relation that is being grounded
    bool is_within_ = false;                                         ///< see ground_within
    bool outside_parts_ = true;
    std::vector<std::pair<FormulaId, Level>> mentions_;
};

}  // namespace partonomy::knowledge
