/* One object and its parts as clauses.

   Each part has its own copy of the features, concepts and constraints of a region; a concept is a variable, and its
   definition an equivalence that holds when the axiom's selector does, so that a class whose axiom is off is free to
   hold or not. The object counts copies: "at least k parts are C" is a totalizer over "is there, and is a C".

   How many further parts are enough? Take any object that is what we look for. Write what we look for with negations
   pushed inwards; each "at least k parts are C" that then stands without a negation and is true keeps k witnesses.
   Everything else may go: counts only sink, so what stands under a negation stays true. Hence the sum of these k.
   A composite part is spoilt when its parts go, so each keeps as many as its concepts count, wanted or not, and each
   part that is kept may be in one.

   Only what was asked for is written down, so the clauses are those of the goal's cone. Cost: parts x (size of the
   cone), and for each count literals x k. */

#include "knowledge/object_clauses.h"

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "knowledge/choices.h"
#include "knowledge/formula_clauses.h"

namespace partonomy::knowledge {
namespace {

constexpr std::size_t most_parts = 4000;  // of the clauses of one object

class HelpfulParts {
public:
    explicit HelpfulParts(const Theory& theory) : theory_(theory) {}

    void look_for(FormulaId id, bool positive) {
        if (!seen_.emplace(id, positive).second) return;
        const Formula& formula = theory_.formulas[id];
        if (formula.kind == Formula::Kind::parts && formula.part_level == Level::composite) look_inside(formula.index);
        if (formula.kind == Formula::Kind::parts && positive) {
            std::size_t& cap = caps_[formula.index];
            cap = std::max<std::size_t>(cap, formula.threshold);
        }
        if (formula.kind == Formula::Kind::named) look_for_concept(formula.index, positive);
        if (formula.kind == Formula::Kind::negation) positive = !positive;
        for (const FormulaId operand : formula.operands) look_for(operand, positive);
    }
    void look_for_concept(int id, bool positive) {
        const NamedConcept& named = theory_.concepts[id];
        if (named.definition < 0) return;
        look_for(named.definition, positive);
        if (named.level == Level::composite) look_inside(named.definition);
    }
    [[nodiscard]] std::size_t count() {
        for (const Constraint& constraint : theory_.constraints)
            if (constraint.level == Level::object) look_for(constraint.formula, true);
        std::size_t sum = sum_of(caps_);
        if (!has_composites_) return sum;
        for (const Constraint& constraint : theory_.constraints)
            if (constraint.level == Level::composite) look_inside(constraint.formula);
        sum = std::max<std::size_t>(sum, 1);
        const std::size_t each = 1 + sum_of(inner_caps_);
        const bool is_nested =
            std::ranges::any_of(theory_.groups, [](const Group& group) { return !group.inner.empty(); });
        for (std::size_t level = 0; level < (is_nested ? theory_.groups.size() : 1) && sum <= most_parts; ++level)
            sum *= each;
        return sum;
    }

private:
    [[nodiscard]] static std::size_t sum_of(const std::map<FormulaId, std::size_t>& caps) {
        std::size_t sum = 0;
        for (const auto& [formula, cap] : caps) sum += cap;
        return sum;
    }
    /// What a composite part counts, wanted or not.
    void look_inside(FormulaId id) {
        has_composites_ = true;
        if (!inside_.insert(id).second) return;
        const Formula& formula = theory_.formulas[id];
        if (formula.kind == Formula::Kind::parts) {
            std::size_t& cap = inner_caps_[formula.index];
            cap = std::max<std::size_t>(cap, formula.threshold);
            if (formula.part_level == Level::composite) look_inside(formula.index);
        }
        if (formula.kind == Formula::Kind::named && theory_.concepts[formula.index].definition >= 0)
            look_inside(theory_.concepts[formula.index].definition);
        for (const FormulaId operand : formula.operands) look_inside(operand);
    }

    const Theory& theory_;
    std::set<std::pair<FormulaId, bool>> seen_;
    std::set<FormulaId> inside_;
    std::map<FormulaId, std::size_t> caps_, inner_caps_;  ///< of the object; of one composite part
    bool has_composites_ = false;
};

}  // namespace

ObjectClauses::ObjectClauses(const Theory& theory, bool switchable)
    : theory_(theory), switchable_(switchable), composites_(theory.groups.size()) {
    object_ = make_member(clauses.always());
}

ObjectClauses::Member ObjectClauses::make_member(int present) const {
    Member member;
    member.present = present;
    member.features.resize(theory_.feature_count());
    member.concepts.assign(theory_.concepts.size(), 0);
    member.formulas.assign(theory_.formulas.size(), 0);
    return member;
}

std::size_t ObjectClauses::add_region() {
    parts_.push_back(make_member(clauses.always()));
    return known_++;
}

void ObjectClauses::add_further_parts(std::size_t count) {
    if (parts_.size() + count > most_parts)
        throw OntologyError("the concepts of objects count up to " + std::to_string(count) +
                            " parts, more than can be explained; count to lower numbers");
    for (std::size_t i = 0; i < count; ++i) {
        const int present = clauses.add_variable();
        if (i > 0) clauses.add({-present, parts_.back().present});
        parts_.push_back(make_member(present));
    }
}

const std::vector<int>& ObjectClauses::feature(Member& member, std::size_t feature) {
    std::vector<int>& values = member.features[feature];
    if (values.empty()) values = add_choice(clauses, theory_.value_count(feature));
    return values;
}

int ObjectClauses::value(std::size_t part, std::size_t feature, ValueId value) {
    return this->feature(parts_[part], feature)[static_cast<std::size_t>(value)];
}

int ObjectClauses::up_to(std::size_t part, std::size_t feature, ValueId value) {
    return clauses.any_of(std::span(this->feature(parts_[part], feature)).first(static_cast<std::size_t>(value) + 1));
}

int ObjectClauses::region_concept(std::size_t part, int id) { return concept_literal(parts_[part], id); }
int ObjectClauses::object_concept(int id) { return concept_literal(object_, id); }

int ObjectClauses::no_further_parts() { return known_ == parts_.size() ? clauses.always() : -parts_[known_].present; }

std::vector<int> ObjectClauses::unless_off(std::size_t axiom) {
    if (!switchable_) return {};
    int& literal = selectors_[axiom];
    if (literal == 0) literal = clauses.add_variable();
    return {-literal};
}

int ObjectClauses::selector(std::size_t axiom) const {
    const auto found = selectors_.find(axiom);
    return found == selectors_.end() ? 0 : found->second;
}

std::vector<std::size_t> ObjectClauses::axioms() const {
    std::vector<std::size_t> result;
    for (const auto& [axiom, literal] : selectors_) result.push_back(axiom);
    return result;
}

int ObjectClauses::concept_literal(Member& member, int id) {
    if (member.concepts[id] != 0) return member.concepts[id];
    const NamedConcept& named = theory_.concepts[id];
    if (member.group >= 0 && named.group >= 0 && named.group != member.group) return clauses.never();
    if (named.definition < 0) return member.concepts[id] = clauses.add_variable();
    const int definition = literal(member, named.definition);
    if (!switchable_) return member.concepts[id] = definition;
    const int concept_ = clauses.add_variable();
    std::vector<int> clause = unless_off(named.axiom);
    clause.insert(clause.end(), {-concept_, definition});
    clauses.add(clause);
    clause[1] = concept_;
    clause[2] = -definition;
    clauses.add(clause);
    return member.concepts[id] = concept_;
}

int ObjectClauses::literal(Member& member, FormulaId id) {
    if (member.formulas[id] == 0) {
        const int made = make(member, id);
        member.formulas[id] = made;
    }
    return member.formulas[id];
}

int ObjectClauses::region_count_in(const Member& whole, const Formula& formula) {
    std::vector<int> members;
    for (std::size_t part = 0; part < (whole.group < 0 ? parts_.size() : region_count()); ++part) {
        const int is_there = whole.group < 0
                                 ? parts_[part].present
                                 : composites(static_cast<std::size_t>(whole.group)).holds[whole.first][part];
        members.push_back(clauses.all_of({is_there, literal(parts_[part], formula.index)}));
    }
    return clauses.at_least(members, formula.threshold);
}

int ObjectClauses::make(Member& member, FormulaId id) {
    const auto count_parts = [&](const Formula& formula) {
        if (member.is_grown) return grown_count(member, formula);
        return formula.part_level == Level::composite ? composite_count(member, formula)
                                                      : region_count_in(member, formula);
    };
    return formula_literal(
        clauses, theory_.formulas[id], [&](FormulaId operand) { return literal(member, operand); },
        [&](std::size_t f) -> const std::vector<int>& { return feature(member, f); },
        [&](int named) { return concept_literal(member, named); }, count_parts);
}

void ObjectClauses::require_constraints(Level level) {
    const auto require = [&](Member& member, const Constraint& constraint) {
        std::vector<int> clause = unless_off(constraint.axiom);
        clause.push_back(-member.present);
        if (level == Level::composite && !member.is_grown && member.first < known_)
            clause.push_back(-no_further_parts());
        clause.push_back(literal(member, constraint.formula));
        clauses.add(clause);
    };
    for (const Constraint& constraint : theory_.constraints) {
        if (constraint.level != level) continue;
        if (level == Level::object) require(object_, constraint);
        for (std::size_t part = 0; level == Level::region && part < parts_.size(); ++part)
            require(parts_[part], constraint);
        for (std::size_t g = 0; level == Level::composite && g < composites_.size(); ++g)
            for (auto* members : {&composites(g).members, &composites(g).grown})
                for (Member& part : *members) require(part, constraint);
    }
}

std::size_t parts_that_help(const Theory& theory, const std::vector<int>& goals) {
    HelpfulParts helpful(theory);
    for (const int goal : goals) helpful.look_for_concept(goal, false);
    return helpful.count();
}

std::size_t parts_for(const Theory& theory, int goal) {
    HelpfulParts helpful(theory);
    if (goal >= 0) helpful.look_for_concept(goal, true);
    return helpful.count();
}

}  // namespace partonomy::knowledge
