#include <algorithm>
#include <set>

#include "base/errors.h"
#include "knowledge/theory.h"

// A named class belongs to the layer that its axioms speak of: properties of features are about regions, hasPart is
// about objects and composite parts, and names pass on what their own axioms say. A sweep over all axioms is repeated
// until nothing new is learned, which takes as many sweeps as definitions are deep. What only has parts is a composite
// part when some hasPart leads to it, or when it is told to be one; else an object. That is decided when nothing surer
// is left to learn. Upwards
// (from a class to a bare superclass) is only learned when all else is.

namespace partonomy::knowledge {
namespace {

using owl::Axiom;
using owl::AxiomKind;
using owl::ClassKind;

class LevelFinder {
public:
    LevelFinder(const owl::Ontology& ontology, const std::vector<RangeConcept>& ranges)
        : ontology_(ontology), ranges_(ranges) {
        for (const RangeConcept& range : ranges) {
            levels_[range.iri] = Level::feature;
            for (const ElementaryConcept& value : range.values) levels_[value.iri] = Level::feature;
        }
        levels_[core_term("Feature")] = Level::feature;
        levels_[core_term("Relation")] = Level::relation;
        levels_[core_term("Region")] = Level::region;
        levels_[core_term("Object")] = Level::object;
        levels_[core_term("CompositePart")] = Level::composite;
        for (const Axiom& axiom : ontology.axioms)
            for (const owl::ClassPointer& expression : axiom.classes) find_parts(*expression, false);
    }

    std::map<Iri, Level> run() {
        const auto sweep = [&](Wholes wholes, bool upwards) {
            wholes_ = wholes;
            for (bool grown = true; grown;) {  // there and back: deep hierarchies are mostly written in one order
                grown = false;
                for (const Axiom& axiom : ontology_.axioms) grown |= learn(axiom, upwards);
                if (!grown) break;
                for (std::size_t i = ontology_.axioms.size(); i-- > 0;) grown |= learn(ontology_.axioms[i], upwards);
            }
        };
        sweep(Wholes::left_open, false);
        sweep(Wholes::composite_when_part, false);
        sweep(Wholes::else_object, false);
        sweep(Wholes::else_object, true);
        return std::move(levels_);
    }

private:
    /// What a class is that has parts, and of which nothing else is known.
    enum class Wholes { left_open, composite_when_part, else_object };

    [[nodiscard]] Level level_of(const owl::ClassExpression& expression) const {
        return knowledge::level_of(expression, levels_, ranges_);
    }

    /// Names behind hasPart.
    void find_parts(const owl::ClassExpression& expression, bool is_part) {
        if (expression.kind == ClassKind::named && is_part) parts_.insert(expression.iri);
        const bool leads_to_parts = is_core_term(expression.property.iri, "hasPart");
        for (const owl::ClassPointer& operand : expression.operands) find_parts(*operand, is_part || leads_to_parts);
    }

    bool set(const owl::ClassPointer& expression, Level level) {
        if (level == Level::unknown || expression->kind != ClassKind::named) return false;
        const Iri& iri = expression->iri;
        if (is_thing(iri) || is_nothing(iri) || is_core_term(iri, "Incompatible")) return false;
        if (level == Level::whole) {
            const bool is_part = parts_.contains(iri);
            if (wholes_ == Wholes::left_open || (wholes_ == Wholes::composite_when_part && !is_part)) return false;
            level = is_part ? Level::composite : Level::object;
        }
        return levels_.emplace(iri, level).second;
    }

    bool learn(const Axiom& axiom, bool upwards) {
        bool grown = false;
        if (axiom.kind == AxiomKind::sub_class_of) {
            grown |= set(axiom.classes[0], level_of(*axiom.classes[1]));
            if (upwards) grown |= set(axiom.classes[1], level_of(*axiom.classes[0]));
        } else if (axiom.kind == AxiomKind::equivalent_classes || axiom.kind == AxiomKind::disjoint_union) {
            const Level level = level_of_all(axiom.classes, levels_, ranges_);
            for (const owl::ClassPointer& expression : axiom.classes) grown |= set(expression, level);
        } else if (axiom.kind == AxiomKind::rule && upwards) {
            for (const owl::RuleAtom& atom : axiom.rule->head)
                if (atom.kind == owl::RuleAtom::Kind::of_class)
                    grown |= set(atom.klass, level_of(atom.arguments[0], *axiom.rule));
        }
        return grown;
    }

    /// What a rule's body says of a variable.
    [[nodiscard]] Level level_of(const owl::RuleTerm& term, const owl::Rule& rule) const {
        Level found = Level::unknown;
        for (const owl::RuleAtom& atom : rule.body) {
            if (atom.arguments.empty() || atom.arguments[0].kind != term.kind || atom.arguments[0].iri != term.iri)
                continue;
            Level level = Level::unknown;
            if (atom.kind == owl::RuleAtom::Kind::of_class) {
                level = level_of(*atom.klass);
            } else if (atom.kind == owl::RuleAtom::Kind::object_property ||
                       atom.kind == owl::RuleAtom::Kind::data_property) {  // as "p some …" does
                owl::ClassExpression some;
                some.kind = atom.kind == owl::RuleAtom::Kind::object_property ? ClassKind::some_values_from
                                                                              : ClassKind::data_some_values_from;
                some.property = atom.property;
                level = level_of(some);
            }
            if (level != Level::unknown && level != Level::whole) return level;
            if (level == Level::whole) found = level;
        }
        return found;
    }

    const owl::Ontology& ontology_;
    const std::vector<RangeConcept>& ranges_;
    std::map<Iri, Level> levels_;
    std::set<Iri> parts_;
    Wholes wholes_ = Wholes::left_open;
};

}  // namespace

Level level_of(const owl::ClassExpression& expression, const std::map<Iri, Level>& levels,
               const std::vector<RangeConcept>& ranges) {
    switch (expression.kind) {
        case ClassKind::named: {
            const auto found = levels.find(expression.iri);
            return found == levels.end() ? Level::unknown : found->second;
        }
        case ClassKind::intersection_of:
        case ClassKind::union_of:
        case ClassKind::complement_of:
            return level_of_all(expression.operands, levels, ranges);
        case ClassKind::one_of:
        case ClassKind::has_self:
            return Level::unknown;
        case ClassKind::data_some_values_from:
        case ClassKind::data_all_values_from:
        case ClassKind::data_has_value:
        case ClassKind::data_min_cardinality:
        case ClassKind::data_max_cardinality:
        case ClassKind::data_exact_cardinality:
            return Level::region;
        default:
            if (is_core_term(expression.property.iri, "hasPart")) return Level::whole;
            if (!expression.property.inverse && (is_core_term(expression.property.iri, "isTargetRegion") ||
                                                 is_core_term(expression.property.iri, "isReferenceRegion")))
                return Level::region;
            return std::ranges::any_of(ranges, [&](const auto& r) { return r.property == expression.property.iri; })
                       ? Level::region
                       : Level::unknown;
    }
}

Level level_of_all(std::span<const owl::ClassPointer> expressions, const std::map<Iri, Level>& levels,
                   const std::vector<RangeConcept>& ranges) {
    Level found = Level::unknown;
    for (const owl::ClassPointer& expression : expressions) {
        const Level level = level_of(*expression, levels, ranges);
        if (level != Level::unknown && level != Level::whole) return level;
        if (level == Level::whole) found = level;
    }
    return found;
}

std::map<Iri, Level> find_levels(const owl::Ontology& ontology, const std::vector<RangeConcept>& ranges) {
    return LevelFinder(ontology, ranges).run();
}

}  // namespace partonomy::knowledge
