#include <algorithm>

#include "base/errors.h"
#include "knowledge/theory.h"

// A named class belongs to the layer that its axioms speak of: properties of features are about regions, hasPart is
// about objects, and names pass on what their own axioms say. A sweep over all axioms is repeated until nothing new is
// learned, which takes as many sweeps as definitions are deep. Upwards (from a class to a bare superclass) is only
// learned when all else is.

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
        levels_[core_term("Region")] = Level::region;
        levels_[core_term("Object")] = Level::object;
    }

    std::map<Iri, Level> run() {
        for (bool upwards : {false, true}) {
            for (bool grown = true; grown;) {
                grown = false;
                for (const Axiom& axiom : ontology_.axioms) grown |= learn(axiom, upwards);
            }
        }
        return std::move(levels_);
    }

private:
    [[nodiscard]] Level level_of(const owl::ClassExpression& expression) const {
        return knowledge::level_of(expression, levels_, ranges_);
    }

    bool set(const owl::ClassPointer& expression, Level level) {
        if (level == Level::unknown || expression->kind != ClassKind::named) return false;
        const Iri& iri = expression->iri;
        if (is_thing(iri) || is_nothing(iri) || iri == core_term("Incompatible")) return false;
        return levels_.emplace(iri, level).second;
    }

    bool learn(const Axiom& axiom, bool upwards) {
        bool grown = false;
        if (axiom.kind == AxiomKind::sub_class_of) {
            grown |= set(axiom.classes[0], level_of(*axiom.classes[1]));
            if (upwards) grown |= set(axiom.classes[1], level_of(*axiom.classes[0]));
        } else if (axiom.kind == AxiomKind::equivalent_classes || axiom.kind == AxiomKind::disjoint_union) {
            Level level = Level::unknown;
            for (const owl::ClassPointer& expression : axiom.classes)
                if (level == Level::unknown) level = level_of(*expression);
            for (const owl::ClassPointer& expression : axiom.classes) grown |= set(expression, level);
        }
        return grown;
    }

    const owl::Ontology& ontology_;
    const std::vector<RangeConcept>& ranges_;
    std::map<Iri, Level> levels_;
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
            for (const owl::ClassPointer& operand : expression.operands)
                if (const Level level = level_of(*operand, levels, ranges); level != Level::unknown) return level;
            return Level::unknown;
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
            if (expression.property.iri == core_term("hasPart")) return Level::object;
            return std::ranges::any_of(ranges, [&](const auto& r) { return r.property == expression.property.iri; })
                       ? Level::region
                       : Level::unknown;
    }
}

std::map<Iri, Level> find_levels(const owl::Ontology& ontology, const std::vector<RangeConcept>& ranges) {
    return LevelFinder(ontology, ranges).run();
}

}  // namespace partonomy::knowledge
