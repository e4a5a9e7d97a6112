/* The public face of the grounder, and the closed knowledge base as plain OWL. */

#include "knowledge/closed_world.h"

#include <algorithm>
#include <set>

#include "base/errors.h"
#include "knowledge/closed_grounder.h"
#include "owl/make_class.h"
#include "owl/words.h"

namespace partonomy::knowledge {

using closed::CannotGround;
using closed::Grounder;

namespace {

void add_individuals(const owl::ClassExpression& expression, std::set<Iri>& names) {
    names.insert(expression.individuals.begin(), expression.individuals.end());
    for (const owl::ClassPointer& operand : expression.operands) add_individuals(*operand, names);
}

void add_individuals(const owl::Rule& rule, std::set<Iri>& names) {
    for (const auto* side : {&rule.body, &rule.head}) {
        for (const owl::RuleAtom& atom : *side) {
            if (atom.klass != nullptr) add_individuals(*atom.klass, names);
            for (const owl::RuleTerm& term : atom.arguments)
                if (term.kind == owl::RuleTerm::Kind::individual) names.insert(term.iri);
        }
    }
}

}  // namespace

std::vector<Iri> individuals_of(const owl::Ontology& ontology) {
    std::set<Iri> names;
    for (const owl::Entity& entity : ontology.entities)
        if (entity.kind == owl::EntityKind::individual) names.insert(entity.iri);
    for (const owl::Axiom& axiom : ontology.axioms) {
        names.insert(axiom.individuals.begin(), axiom.individuals.end());
        for (const owl::ClassPointer& expression : axiom.classes) add_individuals(*expression, names);
        if (axiom.rule != nullptr) add_individuals(*axiom.rule, names);
    }
    return {names.begin(), names.end()};
}

struct GroundedWorld::Machine {
    Machine(ClosedWorld world, const GroundOptions& options, std::vector<owl::ClassPointer> questions)
        : grounder(std::move(world), options, std::move(questions)) {
        individuals = grounder.individuals.sorted();
        classes = grounder.classes.sorted();
        properties = grounder.properties.sorted();
        data_properties = grounder.data_properties.sorted();
    }

    [[nodiscard]] int individual(const Iri& iri) const {
        const auto found = grounder.individuals.ids.find(iri);
        if (found == grounder.individuals.ids.end()) {
            throw UsageError(owl::short_name(iri) + " is no individual of this closed world; it has " +
                             std::to_string(individuals.size()) + ", the first is " +
                             owl::short_name(individuals.front()));
        }
        return found->second;
    }

    Grounder grounder;
    std::vector<Iri> individuals, classes, properties, data_properties;
};

GroundedWorld::GroundedWorld(ClosedWorld world, const GroundOptions& options, std::vector<owl::ClassPointer> questions)
    : machine_(std::make_unique<Machine>(std::move(world), options, std::move(questions))) {}

GroundedWorld::~GroundedWorld() = default;
GroundedWorld::GroundedWorld(GroundedWorld&&) noexcept = default;
GroundedWorld& GroundedWorld::operator=(GroundedWorld&&) noexcept = default;

const owl::Ontology& GroundedWorld::ontology() const { return machine_->grounder.world.ontology; }
const std::vector<Iri>& GroundedWorld::individuals() const { return machine_->individuals; }
const std::vector<Iri>& GroundedWorld::classes() const { return machine_->classes; }
const std::vector<Iri>& GroundedWorld::object_properties() const { return machine_->properties; }
const std::vector<Iri>& GroundedWorld::data_properties() const { return machine_->data_properties; }
const Clauses& GroundedWorld::clauses() const { return machine_->grounder.clauses; }
const std::vector<int>& GroundedWorld::selectors() const { return machine_->grounder.selectors; }

int GroundedWorld::is_a(const Iri& individual, const owl::ClassExpression& expression) {
    const int who = machine_->individual(individual);
    try {
        return machine_->grounder.holds(machine_->grounder.intern(expression), who);
    } catch (const CannotGround& problem) {
        throw UsageError("the class expression " + to_manchester(expression) + " cannot be asked: " + problem.why);
    }
}

int GroundedWorld::is_a(const Iri& individual, const Iri& named_class) {
    return is_a(individual, *owl::named_class(named_class));
}

int GroundedWorld::related(const Iri& subject, const owl::PropertyExpression& property, const Iri& object) {
    Grounder& grounder = machine_->grounder;
    const int from = machine_->individual(subject), to = machine_->individual(object);
    return grounder.property_atom(grounder.property_of(property), from, to);
}

std::optional<int> GroundedWorld::has_value(const Iri& subject, const Iri& data_property, const owl::Literal& value) {
    Grounder& grounder = machine_->grounder;
    const auto found = grounder.data_properties.ids.find(data_property);
    const int who = machine_->individual(subject);
    if (found == grounder.data_properties.ids.end()) return std::nullopt;
    try {
        return grounder.value_atom(found->second, who, value);
    } catch (const CannotGround& problem) {
        throw UsageError("the literal cannot be asked: " + problem.why);
    }
}

int GroundedWorld::same(const Iri& a, const Iri& b) {
    return machine_->grounder.equality(machine_->individual(a), machine_->individual(b));
}

}  // namespace partonomy::knowledge
