#include <algorithm>
#include <optional>
#include <utility>

#include "base/errors.h"
#include "knowledge/ground.h"
#include "knowledge/relations.h"
#include "owl/make_class.h"

// Restrictions on isTargetRegion and isReferenceRegion become features of a region that hold or not, one for each "at
// least k nodes pass this test"; the same restriction in two axioms is one feature. What the test says of the linked
// regions is grounded like any statement about a region, but only evaluated on other regions (relations.cpp), so a Seat
// may be below a Backrest that is above a Seat.

namespace partonomy::knowledge {
namespace {

using owl::ClassExpression;
using owl::ClassKind;

NodeTest negated(NodeTest test) {
    NodeTest result;
    result.kind = NodeTest::Kind::no;
    result.operands.push_back(std::move(test));
    return result;
}

/// Tests "at least k" put together to what the restriction says; `at_least(0)` is true.
template <typename AtLeast>
auto counted(const ClassExpression& expression, const AtLeast& at_least, const auto& negate, const auto& conjoin) {
    switch (expression.kind) {
        case ClassKind::some_values_from:
            return at_least(1U);
        case ClassKind::all_values_from:
            return negate(at_least(1U));  // of what is not in the class
        case ClassKind::min_cardinality:
            return at_least(expression.number);
        case ClassKind::max_cardinality:
            return negate(at_least(expression.number + 1));
        default:
            return conjoin(at_least(expression.number), negate(at_least(expression.number + 1)));
    }
}

/// The relation that a test asks for, if it is one.
std::optional<std::size_t> only_relation(const NodeTest& test) {
    if (test.kind == NodeTest::Kind::relation && std::ranges::count(test.relations, 1) == 1)
        return std::ranges::find(test.relations, 1) - test.relations.begin();
    std::optional<std::size_t> one;
    if (test.kind == NodeTest::Kind::no) return one;
    for (const NodeTest& operand : test.operands)
        if (const auto found = only_relation(operand)) {
            if (one && *one != *found) return std::nullopt;
            one = found;
        }
    return one;
}

owl::ClassPointer filler_of(const ClassExpression& expression) {
    if (expression.operands.empty()) return owl::thing();
    if (expression.kind == ClassKind::all_values_from) return owl::complement_of(expression.operands[0]);
    return expression.operands[0];
}

}  // namespace

std::string key_of(const ClassExpression& expression) {
    std::string key = std::to_string(static_cast<int>(expression.kind)) + (expression.property.inverse ? "-<" : "<") +
                      expression.iri + expression.property.iri + ">" + std::to_string(expression.number) + "(";
    for (const owl::ClassPointer& operand : expression.operands) key += key_of(*operand) + ",";
    for (const Iri& individual : expression.individuals) key += individual + ",";
    if (expression.kind >= ClassKind::data_some_values_from) key += to_manchester(expression);  // the values
    return key + ")";
}

NodeTest Grounder::ground_linked(const ClassExpression& expression, std::vector<FormulaId>& classes,
                                 const owl::Axiom& axiom) {
    const Iri& property = expression.property.iri;
    const bool of_target = is_core_term(property, "isTargetRegion");
    if (!expression.property.inverse || (!of_target && !is_core_term(property, "isReferenceRegion")))
        refuse(axiom, "\"" + to_manchester(expression) + "\" says nothing of a relation between regions",
               "write inverse (" + other_side() + ") some " +
                   (expression.operands.empty() ? "Region" : to_manchester(*expression.operands[0])));
    if (expression.number == UINT32_MAX) refuse(axiom, "the cardinality is too large", "write a smaller one");
    classes.push_back(ground(filler_of(expression), Level::region, axiom));
    const auto at_least = [&](unsigned threshold) {
        NodeTest test;  // nothing to hold: true
        if (threshold == 0) return test;
        test.kind = of_target ? NodeTest::Kind::target : NodeTest::Kind::references;
        test.threshold = threshold;
        test.part_class = classes.size() - 1;
        return test;
    };
    return counted(expression, at_least, negated, [](NodeTest a, NodeTest b) {
        NodeTest both;
        both.operands = {std::move(a), std::move(b)};
        return both;
    });
}

NodeTest Grounder::ground_node(const owl::ClassPointer& pointer, std::vector<FormulaId>& classes,
                               const owl::Axiom& axiom) {
    const ClassExpression& expression = *pointer;
    NodeTest test;
    switch (expression.kind) {
        case ClassKind::named: {
            if (is_thing(expression.iri)) return test;
            if (is_nothing(expression.iri)) return negated(test);
            test.kind = NodeTest::Kind::relation;
            bool known = is_core_term(expression.iri, "Relation");
            const auto told = told_relations(ontology_);
            for (const Relation& relation : theory_.relations) {
                const bool is_one = known || relation.iri == expression.iri ||
                                    std::ranges::binary_search(told, std::pair(relation.iri, expression.iri));
                test.relations.push_back(is_one ? 1 : 0);
            }
            known |= std::ranges::count(test.relations, 1) > 0;
            if (!known)
                refuse(axiom, owl::local_name(expression.iri) + " is no relation",
                       "put " + owl::local_name(expression.iri) + " below core:Relation, or write a class that is");
            return test;
        }
        case ClassKind::intersection_of:
        case ClassKind::union_of:
            test.kind = expression.kind == ClassKind::union_of ? NodeTest::Kind::any : NodeTest::Kind::all;
            for (const owl::ClassPointer& operand : expression.operands)
                test.operands.push_back(ground_node(operand, classes, axiom));
            return test;
        case ClassKind::complement_of:
            return negated(ground_node(expression.operands[0], classes, axiom));
        case ClassKind::some_values_from:
        case ClassKind::all_values_from:
        case ClassKind::min_cardinality:
        case ClassKind::max_cardinality:
        case ClassKind::exact_cardinality:
            return ground_linked(expression, classes, axiom);
        default:
            refuse(axiom, "\"" + to_manchester(expression) + "\" says nothing of a relation between regions",
                   "write a relation, and inverse (" + other_side() + ") some Region");
    }
}

FormulaId Grounder::ground_relation(const ClassExpression& expression, const owl::Axiom& axiom) {
    switch (expression.kind) {
        case ClassKind::some_values_from:
        case ClassKind::all_values_from:
        case ClassKind::min_cardinality:
        case ClassKind::max_cardinality:
        case ClassKind::exact_cardinality:
            break;
        default:
            refuse(axiom, "nodes of relations have no names",
                   "write " + owl::local_name(expression.property.iri) + " some (UpFrom and …)");
    }
    if (expression.number == UINT32_MAX) refuse(axiom, "the cardinality is too large", "write a smaller one");
    const owl::ClassPointer filler = filler_of(expression);
    const auto at_least = [&](unsigned threshold) -> FormulaId {
        if (threshold == 0) return 0;
        auto as_written = std::make_shared<ClassExpression>();
        as_written->kind = threshold == 1 ? ClassKind::some_values_from : ClassKind::min_cardinality;
        as_written->property = expression.property;
        as_written->number = threshold == 1 ? 0 : threshold;
        as_written->operands = {filler};
        const auto [known, is_new] = relational_.try_emplace(key_of(*as_written), theory_.relational.size());
        if (is_new) {
            RelationalFeature feature;
            std::vector<FormulaId> classes;
            feature.of_target = is_core_term(expression.property.iri, "isTargetRegion");
            feature.threshold = threshold;
            feature.as_written = as_written;
            const std::size_t index = theory_.relational.size();
            theory_.relational.push_back(feature);  // its place is taken before those inside
            theory_.relational_classes.emplace_back();
            const bool was_target = std::exchange(is_target_, feature.of_target);
            feature.test = ground_node(filler, classes, axiom);
            is_target_ = was_target;
            bool possible = false;
            for (std::size_t r = 0; r < theory_.relations.size(); ++r)
                possible |= may_pass(feature.test, theory_.relations, r);
            if (!possible) {
                const std::string what = "no node can be \"" + to_manchester(*filler) + "\"";
                const std::optional<std::size_t> one = only_relation(feature.test);
                if (!one)
                    refuse(axiom, what + ", since each is of one relation", "write one restriction for each relation");
                const Relation& relation = theory_.relations[*one];
                refuse(axiom,
                       what + ", since " + owl::local_name(relation.iri) + " links one target and " +
                           (relation.arity == 2 ? "one reference" : "two references"),
                       "ask for no more of either");
            }
            for (const FormulaId formula : classes) {
                Formula marker;  // so that a compiled layer of regions has a literal for it
                marker.kind = Formula::Kind::parts;
                marker.index = formula;
                marker.threshold = 1;
                add(std::move(marker));
            }
            theory_.relational[index] = std::move(feature);
            theory_.relational_classes[index] = std::move(classes);
        }
        const std::size_t feature = theory_.ranges.size() + theory_.numbers.size() + known->second;
        ConfigurationSet yes(2);
        yes.insert(0);
        return choice(feature, std::move(yes));
    };
    return counted(
        expression, at_least, [&](FormulaId a) { return negate(a); },
        [&](FormulaId a, FormulaId b) {
            return conjoin({a, b});
        });
}

}  // namespace partonomy::knowledge
