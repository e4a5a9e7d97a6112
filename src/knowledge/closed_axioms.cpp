/* From axioms to clauses.

   Two passes: the first hears of every name, expression and data range, the second makes clauses. What an axiom says it
   says of every individual; each of its clauses has the axiom's selector as a premise, whereas the clauses that define
   a gate bind always, so gates are shared between axioms. */

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "knowledge/closed_grounder.h"
#include "owl/words.h"

namespace partonomy::knowledge::closed {

using owl::Axiom;
using owl::AxiomKind;

template <class Step>
void Grounder::with_place(const Axiom* axiom, Step step) {
    axiom_ = axiom;
    try {
        step();
    } catch (const CannotGround& problem) {
        if (axiom_ == nullptr) throw OntologyError("the closed world cannot be grounded: " + problem.why);
        throw OntologyError(at(axiom_->source.file, axiom_->source.line,
                               "the axiom " + to_manchester(*axiom_) + " cannot be grounded: " + problem.why));
    }
}

Grounder::Grounder(ClosedWorld given, const GroundOptions& limits, std::vector<owl::ClassPointer> asked)
    : world(std::move(given)), options(limits), questions(std::move(asked)) {
    always_ = clauses.always();
    all_literals_ = range_id({owl::DataRangeKind::datatype, std::string(owl::rdfs_prefix) + "Literal", {}, {}, {}});
    for (const Axiom& axiom : world.ontology.axioms)
        if (axiom.kind == AxiomKind::datatype_definition) definitions_[axiom.datatype] = &axiom.range;

    owl::ClassExpression thing;
    thing.kind = owl::ClassKind::named;
    thing.iri = std::string(owl::owl_prefix) + "Thing";
    thing_ = intern(thing);

    std::vector<Iri> names = world.individuals;
    for (const Iri& iri : individuals_of(world.ontology)) names.push_back(iri);
    std::ranges::sort(names);
    for (const Iri& iri : names) individuals.add(iri);
    if (names.empty()) {
        throw UsageError("a closed world needs at least one individual, and the ontology names none; add one");
    }
    for (const owl::Entity& entity : world.ontology.entities) {
        if (entity.kind == owl::EntityKind::klass && owl::word_of(entity.iri) == owl::Word::none)
            classes.add(entity.iri);
        if (entity.kind == owl::EntityKind::object_property) (void)property_of({entity.iri, false});
        if (entity.kind == owl::EntityKind::data_property) (void)data_property_of({entity.iri, false});
    }
    for (const Axiom& axiom : world.ontology.axioms) {
        with_place(&axiom, [&] { collect(axiom); });
        selectors.push_back(clauses.add_variable());
    }
    with_place(nullptr, [&] {
        for (const owl::ClassPointer& question : questions) (void)intern(question);
        count_ = static_cast<int>(individuals.size());
    });
    is_collecting_ = false;
    with_place(nullptr, [&] { choose_values(); });
    with_place(nullptr, [&] { make_equalities(); });
    learn_known();
    for (std::size_t i = 0; i < world.ontology.axioms.size(); ++i) {
        selector_ = selectors[i];
        with_place(&world.ontology.axioms[i], [&] { ground(world.ontology.axioms[i]); });
    }
    pointer_ids_.clear();
}

void Grounder::collect(const Axiom& axiom) {
    collect_data(axiom);
    if (axiom.kind == AxiomKind::datatype_definition) {
        DataCells check(definitions_);
        check.mention(axiom.range);
    }
    for (const owl::ClassPointer& expression : axiom.classes) (void)intern(expression);
    if (axiom.rule == nullptr) return;
    for (const auto* side : {&axiom.rule->body, &axiom.rule->head})
        for (const owl::RuleAtom& atom : *side)
            if (atom.klass != nullptr) (void)intern(atom.klass);
}

void Grounder::expect_clauses(double count) const {
    if (static_cast<double>(clauses.size()) + count > static_cast<double>(options.max_clauses)) {
        throw CannotGround{"over " + std::to_string(count_) + " individuals this takes more than " +
                           std::to_string(options.max_clauses) +
                           " clauses; use fewer individuals, shorter chains or rules, or a higher limit"};
    }
}

void Grounder::require(std::vector<int> literals) {
    literals.push_back(-selector_);
    clauses.add(literals);
}

void Grounder::require_at_most_one(const std::vector<int>& literals) {
    if (literals.size() > 6) return require({-clauses.at_least(literals, 2)});
    for (std::size_t i = 0; i < literals.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) require({-literals[i], -literals[j]});
}

void Grounder::ground(const Axiom& axiom) {
    switch (axiom.kind) {
        case AxiomKind::sub_class_of:
        case AxiomKind::equivalent_classes:
        case AxiomKind::disjoint_classes:
        case AxiomKind::disjoint_union:
            return ground_class_axiom(axiom);
        case AxiomKind::class_assertion:
        case AxiomKind::object_property_assertion:
        case AxiomKind::negative_object_property_assertion:
        case AxiomKind::data_property_assertion:
        case AxiomKind::negative_data_property_assertion:
        case AxiomKind::same_individual:
        case AxiomKind::different_individuals:
            return ground_assertion(axiom);
        case AxiomKind::sub_data_property_of:
        case AxiomKind::equivalent_data_properties:
        case AxiomKind::disjoint_data_properties:
        case AxiomKind::data_property_domain:
        case AxiomKind::data_property_range:
        case AxiomKind::functional_data_property:
            return ground_data_property(axiom);
        case AxiomKind::has_key:
            return ground_key(axiom);
        case AxiomKind::rule:
            return ground_rule(*axiom.rule);
        case AxiomKind::datatype_definition:
            return;  // known to every data range
        default:
            return ground_object_property(axiom);
    }
}

void Grounder::ground_class_axiom(const Axiom& axiom) {
    std::vector<int> expressions;
    for (const owl::ClassPointer& expression : axiom.classes) expressions.push_back(intern(expression));
    if (axiom.kind == AxiomKind::disjoint_classes) make_set(expressions, 0);
    if (axiom.kind == AxiomKind::disjoint_union) make_set(expressions, 1);
    for (int individual = 0; individual < count_; ++individual) {
        std::vector<int> literals;
        for (const int expression : expressions) literals.push_back(holds(expression, individual));
        if (axiom.kind == AxiomKind::sub_class_of) require({-literals[0], literals[1]});
        if (axiom.kind == AxiomKind::disjoint_classes) require_at_most_one(literals);
        if (axiom.kind == AxiomKind::equivalent_classes) {
            // A ring of implications.
            for (std::size_t i = 0; i < literals.size(); ++i)
                require({-literals[i], literals[(i + 1) % literals.size()]});
        }
        if (axiom.kind == AxiomKind::disjoint_union) {
            std::vector<int> parts(literals.begin() + 1, literals.end());
            require_at_most_one(parts);
            for (const int part : parts) require({-part, literals[0]});
            parts.push_back(-literals[0]);
            require(parts);
        }
    }
}

void Grounder::ground_assertion(const Axiom& axiom) {
    std::vector<int> who;
    for (const Iri& iri : axiom.individuals) who.push_back(individuals.ids.at(iri));
    switch (axiom.kind) {
        case AxiomKind::class_assertion:
            return require({holds(intern(axiom.classes[0]), who[0])});
        case AxiomKind::object_property_assertion:
            return require({property_atom(property_of(axiom.properties[0]), who[0], who[1])});
        case AxiomKind::negative_object_property_assertion:
            return require({-property_atom(property_of(axiom.properties[0]), who[0], who[1])});
        case AxiomKind::data_property_assertion:
            return require({value_atom(data_property_of(axiom.properties[0]), who[0], axiom.literal).value()});
        case AxiomKind::negative_data_property_assertion:
            return require({-value_atom(data_property_of(axiom.properties[0]), who[0], axiom.literal).value()});
        case AxiomKind::same_individual:
            for (std::size_t i = 1; i < who.size(); ++i) require({equality(who[i - 1], who[i])});
            return;
        default:  // different individuals
            make_set(who, 0);
            for (std::size_t i = 0; i < who.size(); ++i)
                for (std::size_t j = 0; j < i; ++j) require({-equality(who[i], who[j])});
    }
}

}  // namespace partonomy::knowledge::closed
