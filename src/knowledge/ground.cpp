#include "knowledge/ground.h"

#include <algorithm>
#include <set>
#include <utility>

#include "base/errors.h"
#include "owl/make_class.h"

// Grounding is direct, since the domain is finite: a functional feature has exactly one of its values, so `some`,
// `only` and the cardinalities 0 and 1 all come down to "the value is one of these"; a number lies in exactly one
// interval; and every restriction on hasPart is a Boolean combination of "at least k parts are C". Constants are folded
// at once, so that axioms which say nothing here (Region SubClassOf hasShape some Shape) become plainly true.

namespace partonomy::knowledge {
namespace {

using owl::Axiom;
using owl::AxiomKind;
using owl::ClassExpression;
using owl::ClassKind;
using Kind = Formula::Kind;

constexpr unsigned most_parts_counted = 100'000;  // beyond, the ways in which parts combine are too many for any layer

const char* kind_of(Level level) {
    return level == Level::region ? "a region" : level == Level::composite ? "a composite part" : "an object";
}

/// Whether a count that is 1 (`in`) or 0 satisfies the cardinality.
bool satisfies(ClassKind kind, std::uint32_t number, unsigned count) {
    switch (kind) {
        case ClassKind::min_cardinality:
        case ClassKind::data_min_cardinality:
            return count >= number;
        case ClassKind::max_cardinality:
        case ClassKind::data_max_cardinality:
            return count <= number;
        case ClassKind::exact_cardinality:
        case ClassKind::data_exact_cardinality:
            return count == number;
        default:
            return count == 1;  // some, only, value: of a feature that has exactly one value
    }
}

}  // namespace

bool is_made_of_names(const std::vector<owl::ClassPointer>& expressions) {
    return std::ranges::all_of(expressions, [](const owl::ClassPointer& expression) {
        return expression->kind <= ClassKind::complement_of && is_made_of_names(expression->operands);
    });
}

Grounder::Grounder(const owl::Ontology& ontology, const std::map<Iri, Level>& levels, Theory& theory)
    : ontology_(ontology), levels_(levels), theory_(theory), hierarchy_(ontology) {
    theory_.formulas.resize(2);
    theory_.formulas[0].kind = Kind::truth;
    theory_.formulas[1].kind = Kind::falsity;
    for (std::size_t r = 0; r < theory.ranges.size(); ++r) {
        range_names_.insert(theory.ranges[r].iri);
        for (const ElementaryConcept& value : theory.ranges[r].values) ranges_of_values_.emplace(value.iri, r);
    }
}

FormulaId Grounder::add(Formula formula) {
    theory_.formulas.push_back(std::move(formula));
    return static_cast<FormulaId>(theory_.formulas.size()) - 1;
}

FormulaId Grounder::negate(FormulaId a) {
    if (a <= 1) return 1 - a;
    if (theory_.formulas[a].kind == Kind::negation) return theory_.formulas[a].operands[0];
    Formula formula;
    formula.kind = Kind::negation;
    formula.operands = {a};
    return add(std::move(formula));
}

FormulaId Grounder::conjoin(std::vector<FormulaId> operands) {
    std::erase(operands, 0);
    if (std::ranges::count(operands, 1) > 0) return 1;
    if (operands.empty()) return 0;
    if (operands.size() == 1) return operands[0];
    Formula formula;
    formula.kind = Kind::conjunction;
    formula.operands = std::move(operands);
    return add(std::move(formula));
}

FormulaId Grounder::disjoin(std::vector<FormulaId> operands) {
    std::erase(operands, 1);
    if (std::ranges::count(operands, 0) > 0) return 0;
    if (operands.empty()) return 1;
    if (operands.size() == 1) return operands[0];
    Formula formula;
    formula.kind = Kind::disjunction;
    formula.operands = std::move(operands);
    return add(std::move(formula));
}

FormulaId Grounder::named(int concept_id) {
    Formula formula;
    formula.kind = Kind::named;
    formula.index = concept_id;
    return add(std::move(formula));
}

FormulaId Grounder::choice(std::size_t feature, ConfigurationSet values) {
    const std::size_t count = values.count();
    if (count == values.size()) return 0;
    if (count == 0) return 1;
    Formula formula;
    formula.kind = Kind::choice;
    formula.index = static_cast<int>(feature);
    formula.values = std::move(values);
    return add(std::move(formula));
}

const RangeConcept* Grounder::range_of_value(const Iri& value) const {
    const auto found = ranges_of_values_.find(value);
    return found == ranges_of_values_.end() ? nullptr : &theory_.ranges[found->second];
}

bool Grounder::is_functional(const Iri& property) const {
    return std::ranges::any_of(ontology_.axioms, [&](const Axiom& axiom) {
        return axiom.kind == AxiomKind::functional_data_property && axiom.properties[0].iri == property;
    });
}

/// Numbers of a region that are measured; or could be, but for their core:measure.
bool Grounder::is_question(const ClassExpression& expression, Level level) const {
    const auto found = ontology_.annotations.find(expression.property.iri);
    const bool has_measure =
        found != ontology_.annotations.end() && std::ranges::any_of(found->second, [](const owl::Annotation& each) {
            return is_core_term(each.property, "measure");
        });
    return has_measure || (level == Level::region && !theory_.no_numbers.contains(expression.property.iri));
}

FormulaId Grounder::ground_name(const Iri& iri, Level level, const Axiom& axiom) {
    const std::string name = owl::local_name(iri);
    if (is_thing(iri)) return 0;
    if (is_nothing(iri)) return 1;
    if (is_core_term(iri, "Incompatible"))
        refuse(axiom, "nothing proves that something is Incompatible but the concepts below it",
               "write SubClassOf: Incompatible beside the EquivalentTo of a named concept");
    const auto found = levels_.find(iri);
    if (found == levels_.end()) {  // a class that stands beside the layers
        ClassExpression aside;
        aside.iri = iri;
        return open_atom(aside, level, axiom);
    }
    if (is_within_ && found->second != level) return 1;
    if (found->second == Level::feature) {
        const RangeConcept* range = range_of_value(iri);
        refuse(axiom, name + " is a feature and no region",
               range != nullptr ? "write " + owl::local_name(range->property) + " some " + name
                                : "write it behind the property that leads to it");
    }
    if (found->second != level)
        refuse(axiom, name + " is " + kind_of(found->second) + " where " + kind_of(level) + " is meant",
               found->second < level ? "write hasPart some " + name
               : found->second == Level::object
                   ? "describe " + std::string(kind_of(level)) + " by " +
                         (level == Level::region ? "its features" : "its parts")
                   : "write " + pieces_of(iri) + ", of which it consists: any one piece then");
    if (is_core_term(iri, "Region") || is_core_term(iri, "Object") || is_core_term(iri, "CompositePart")) return 0;
    return named(theory_.find(iri));
}

/// Of a class with values the functional property that axioms write before one of them, or that is named after it,
/// where nothing is told of its range; null when there is none.
const Axiom* Grounder::leads_without_range(const Iri& feature) const {
    std::set<Iri> values{feature}, ranged, used;
    for (const Axiom& axiom : ontology_.axioms) {
        const bool is_union = axiom.kind == AxiomKind::disjoint_union && axiom.classes[0]->iri == feature;
        if (is_union || (axiom.kind == AxiomKind::sub_class_of && axiom.classes[1]->iri == feature))
            for (const owl::ClassPointer& value : axiom.classes) values.insert(value->iri);
        if (axiom.kind == AxiomKind::object_property_range) ranged.insert(axiom.properties[0].iri);
    }
    if (values.size() == 1) return nullptr;
    const auto collect = [&](const auto& self, const ClassExpression& expression) -> void {
        for (const owl::ClassPointer& operand : expression.operands) {
            if (operand->kind == ClassKind::named && values.contains(operand->iri))
                used.insert(expression.property.iri);
            self(self, *operand);
        }
    };
    for (const Axiom& axiom : ontology_.axioms)
        for (const owl::ClassPointer& each : axiom.classes) collect(collect, *each);
    for (const Axiom& axiom : ontology_.axioms) {
        if (axiom.kind != AxiomKind::functional_object_property || ranged.contains(axiom.properties[0].iri)) continue;
        const Iri& property = axiom.properties[0].iri;
        if (used.contains(property) || owl::local_name(property) == "has" + owl::local_name(feature)) return &axiom;
    }
    return nullptr;
}

/// "Pole", "(Pole or Arm)": what the definition of a composite part names behind hasPart.
std::string Grounder::pieces_of(const Iri& composite) const {
    std::vector<std::string> names;
    const auto collect = [&](const auto& self, const ClassExpression& expression, bool is_behind) -> void {
        const auto level = levels_.find(expression.iri);
        const bool is_region = level != levels_.end() && level->second == Level::region;
        const std::string name = owl::local_name(expression.iri);
        if (is_behind && expression.kind == ClassKind::named && is_region && std::ranges::count(names, name) == 0)
            names.push_back(name);
        for (const owl::ClassPointer& operand : expression.operands)
            self(self, *operand, is_behind || expression.property.iri == core_term("hasPart"));
    };
    for (const Axiom& axiom : ontology_.axioms)
        if (axiom.kind == AxiomKind::equivalent_classes &&
            std::ranges::any_of(axiom.classes, [&](const auto& c) { return c->iri == composite; }))
            for (const owl::ClassPointer& meaning : axiom.classes) collect(collect, *meaning, false);
    if (names.empty()) return "the names of regions";
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : " or ") + name;
    return names.size() > 1 ? "(" + text + ")" : text;
}

ConfigurationSet Grounder::values(const ClassExpression& expression, std::size_t range, const Axiom& axiom,
                                  bool strict) {
    const RangeConcept& concept_range = theory_.ranges[range];
    ConfigurationSet all(theory_.value_count(range), true), none(theory_.value_count(range));
    switch (expression.kind) {
        case ClassKind::intersection_of:
            for (const auto& operand : expression.operands) all &= values(*operand, range, axiom, strict);
            return all;
        case ClassKind::union_of:
            for (const auto& operand : expression.operands) none |= values(*operand, range, axiom, strict);
            return none;
        case ClassKind::complement_of:
            return values(*expression.operands[0], range, axiom, strict).complement();
        case ClassKind::named:
            break;
        default:
            refuse(axiom,
                   "\"" + to_manchester(expression) + "\" says more about a value of " +
                       owl::local_name(concept_range.iri) + " than its name",
                   "combine names of values with and, or, not");
    }
    const Iri& iri = expression.iri;
    if (is_thing(iri) || is_core_term(iri, "Feature") || iri == concept_range.iri) return all;
    if (is_nothing(iri)) return none;
    for (std::size_t v = 0; v < concept_range.values.size(); ++v)
        if (concept_range.values[v].iri == iri) {
            none.insert(v);
            return none;
        }
    const RangeConcept* other = range_of_value(iri);
    if (other != nullptr || range_names_.contains(iri)) {
        if (!strict) return none;
        refuse(axiom, owl::local_name(iri) + " is no value of " + owl::local_name(concept_range.iri),
               other != nullptr ? "write " + owl::local_name(other->property) + " some " + owl::local_name(iri)
                                : "write the property that leads to it");
    }
    const bool circular = std::ranges::count(open_, iri) > 0;
    for (const Axiom& definition : ontology_.axioms) {  // a name for a combination of values
        if (circular || definition.kind != AxiomKind::equivalent_classes) continue;
        const auto same = [&](const owl::ClassPointer& c) { return c->kind == ClassKind::named && c->iri == iri; };
        if (std::ranges::none_of(definition.classes, same)) continue;
        for (const owl::ClassPointer& meaning : definition.classes) {
            if (same(meaning)) continue;
            open_.push_back(iri);
            ConfigurationSet result = values(*meaning, range, definition, false);
            open_.pop_back();
            return result;
        }
    }
    std::vector<Iri> features{iri};  // it may be one but for a tick or a range, or a value of such a one
    for (const Axiom& told : ontology_.axioms)
        if (told.kind == AxiomKind::sub_class_of && told.classes[0]->iri == iri && !told.classes[1]->iri.empty() &&
            told.classes[1]->iri != core_term("Feature"))
            features.push_back(told.classes[1]->iri);
    for (const Iri& feature : features) {
        for (const Axiom& told : ontology_.axioms)
            if (told.kind == AxiomKind::object_property_range && !told.properties[0].inverse &&
                told.classes[0]->kind == ClassKind::named && told.classes[0]->iri == feature &&
                !range_names_.contains(feature))
                refuse(told, "no functional property has the range " + owl::local_name(feature),
                       "tick Functional on " + owl::local_name(told.properties[0].iri));
        if (const Axiom* functional = leads_without_range(feature); functional && !range_names_.contains(feature))
            refuse(*functional,
                   "no range says that " + owl::local_name(functional->properties[0].iri) + " leads to " +
                       owl::local_name(feature),
                   "give it the range " + owl::local_name(feature));
    }
    refuse(axiom, owl::local_name(iri) + " is no value of " + owl::local_name(concept_range.iri),
           "list it in the disjoint union of " + owl::local_name(concept_range.iri) +
               ", or define it as a combination of its values");
}

FormulaId Grounder::ground_feature(const ClassExpression& expression, std::size_t range, const Axiom& axiom) {
    ConfigurationSet in = expression.operands.empty() ? ConfigurationSet(theory_.value_count(range), true)
                                                      : values(*expression.operands[0], range, axiom, true);
    const bool when_in = satisfies(expression.kind, expression.number, 1),
               when_out = satisfies(expression.kind, expression.number, 0);
    if (when_in == when_out) return when_in ? 0 : 1;
    return choice(range, when_in ? in : in.complement());
}

FormulaId Grounder::ground_number(const ClassExpression& expression, const Axiom& axiom) {
    const Iri& property = expression.property.iri;
    const std::vector<MeasuredProperty::Interval> allowed = number_range(expression.range, axiom);
    if (!is_functional(property))
        refuse(axiom, owl::local_name(property) + " may have several values, and only one is measured",
               "declare " + owl::local_name(property) + " functional");
    const auto number = std::ranges::find_if(theory_.numbers, [&](const auto& n) { return n.iri == property; });
    bool when_in = satisfies(expression.kind, expression.number, 1),
         when_out = satisfies(expression.kind, expression.number, 0);
    if (when_in == when_out) return when_in ? 0 : 1;
    if (number == theory_.numbers.end()) return allowed.empty() == when_in ? 1 : 0;  // all of the line, or nothing
    ConfigurationSet in(number->intervals.size());
    for (std::size_t i = 0; i < number->intervals.size(); ++i) {
        const MeasuredProperty::Interval& piece = number->intervals[i];
        for (const MeasuredProperty::Interval& part : allowed) {
            const bool above =
                piece.low > part.low || (piece.low == part.low && (part.low_closed || !piece.low_closed));
            const bool below =
                piece.high < part.high || (piece.high == part.high && (part.high_closed || !piece.high_closed));
            if (above && below) in.insert(i);
        }
    }
    const auto feature = theory_.ranges.size() + static_cast<std::size_t>(number - theory_.numbers.begin());
    return choice(feature, when_in ? in : in.complement());
}

FormulaId Grounder::ground_parts(const ClassExpression& expression, Level level, const Axiom& axiom) {
    static const owl::ClassPointer anything = owl::thing();
    owl::ClassPointer filler = expression.operands.empty() ? anything : expression.operands[0];
    const Level told = level_of(*filler, levels_, theory_.ranges);
    const Level part_level = told == Level::whole || told == Level::composite ? Level::composite : Level::region;
    if (level == Level::composite && told == Level::whole)
        refuse(axiom, "which composite parts \"" + to_manchester(*filler) + "\" looks for is not told",
               "define a concept by these parts, and write its name");
    const bool is_mention = std::exchange(outside_parts_, false);
    if (is_mention && level == Level::composite) mentions_.emplace_back(ground(filler, part_level, axiom), part_level);
    if (expression.kind == ClassKind::all_values_from) filler = owl::complement_of(filler);
    const FormulaId part = ground(filler, part_level, axiom);
    outside_parts_ = is_mention;
    const auto at_least = [&](unsigned threshold) {
        if (threshold == 0) return 0;
        if (part == 1) return 1;
        Formula formula;
        formula.kind = Kind::parts;
        formula.index = part;
        formula.threshold = threshold;
        formula.part_class = filler;
        formula.part_level = part_level;
        return add(std::move(formula));
    };
    if (expression.number > most_parts_counted)
        refuse(axiom, "it counts to " + std::to_string(expression.number) + " parts",
               "count to " + std::to_string(most_parts_counted) + " at most");
    switch (expression.kind) {
        case ClassKind::some_values_from:
            return at_least(1);
        case ClassKind::all_values_from:
            return negate(at_least(1));
        case ClassKind::min_cardinality:
            return at_least(expression.number);
        case ClassKind::max_cardinality:
            return negate(at_least(expression.number + 1));
        default: {
            const FormulaId enough = at_least(expression.number);
            return conjoin({enough, negate(at_least(expression.number + 1))});
        }
    }
}

FormulaId Grounder::ground(const owl::ClassPointer& pointer, Level level, const Axiom& axiom) {
    const ClassExpression& expression = *pointer;
    const std::string property = owl::local_name(expression.property.iri);
    switch (expression.kind) {
        case ClassKind::named:
            return ground_name(expression.iri, level, axiom);
        case ClassKind::intersection_of:
        case ClassKind::union_of: {
            std::vector<FormulaId> operands;
            for (const auto& operand : expression.operands) operands.push_back(ground(operand, level, axiom));
            return expression.kind == ClassKind::union_of ? disjoin(std::move(operands)) : conjoin(std::move(operands));
        }
        case ClassKind::complement_of:
            return negate(ground(expression.operands[0], level, axiom));
        case ClassKind::one_of:
        case ClassKind::has_value:
        case ClassKind::has_self:
            return open(expression, level, axiom);
        default:
            break;
    }
    if (expression.property.inverse) return open(expression, level, axiom);
    if (is_core_term(expression.property.iri, "isTargetRegion") ||
        is_core_term(expression.property.iri, "isReferenceRegion")) {
        if (level != Level::region)
            refuse(axiom, property + " links regions, and here " + kind_of(level) + " is meant",
                   "write hasPart some (" + to_manchester(expression) + ")");
        return ground_relation(expression, axiom);
    }
    if (level_of(expression, {}, theory_.ranges) == Level::unknown) return open(expression, level, axiom);
    if (expression.kind >= ClassKind::data_some_values_from && !is_question(expression, level))
        return open(expression, level, axiom);
    const bool of_parts = is_core_term(expression.property.iri, "hasPart");
    if (of_parts && level == Level::region)
        refuse(axiom, "a region has no parts, and what has parts is a composite part of a layer above",
               "put it below core:CompositePart and not below core:Region, and describe it by its parts only");
    if (!of_parts && level != Level::region)
        refuse(axiom, property + " is a feature of regions, and here " + kind_of(level) + " is meant",
               "write hasPart some (" + to_manchester(expression) + ")");
    if (of_parts) return ground_parts(expression, level, axiom);
    for (std::size_t r = 0; r < theory_.ranges.size(); ++r)
        if (theory_.ranges[r].property == expression.property.iri)
            return is_made_of_names(expression.operands) ? ground_feature(expression, r, axiom)
                                                         : open(expression, level, axiom);
    return ground_number(expression, axiom);
}

void Grounder::start_over() {
    open_.clear();
    mentions_.clear();
    is_within_ = false;
    outside_parts_ = true;
}

std::vector<std::pair<FormulaId, Level>> Grounder::take_mentions() { return std::exchange(mentions_, {}); }

}  // namespace partonomy::knowledge
