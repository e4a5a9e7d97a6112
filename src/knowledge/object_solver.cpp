/* Objects of too many kinds to list, as clauses for a solver.

   As in object_space.cpp an object is what it counts, and parts only matter by their types. A known region is of one of
   the types that its set leaves open; of further parts there are, of each type, none, one, two … up to where more makes
   no difference. "At least k parts are C" is a totalizer over the types that are C. So nothing grows with the number of
   combinations: there are (classes) x (types within) x (highest count) clauses.

   The atoms and concepts come first among the variables; all others only help to say how they hang together, and
   nothing is asked about them. */

#include <algorithm>

#include "base/errors.h"
#include "knowledge/choices.h"
#include "knowledge/diagram.h"
#include "knowledge/formula_clauses.h"
#include "knowledge/theory.h"

namespace partonomy::knowledge {
namespace {

constexpr std::size_t most_inputs = 2'000'000;  // of totalizers: some seconds

class ObjectSolver {
public:
    ObjectSolver(const Theory& theory, const Scope& scope, const Parts& parts)
        : theory_(theory), scope_(scope), parts_(parts), inputs_(parts.classes.size()) {
        literals_.assign(theory.formulas.size(), 0);
        (void)clauses.always();
        for (std::size_t a = 0; a < parts.atoms.size(); ++a) atoms.push_back(clauses.add_variable());
        concepts.assign(theory.concepts.size(), 0);
        for (std::size_t id = 0; id < concepts.size(); ++id)
            if (theory.concepts[id].level == Level::object && scope.concepts[id]) concepts[id] = clauses.add_variable();
        told = clauses.variable_count();
    }

    void add_region(const ConfigurationSet& region) {
        const std::vector<std::size_t> types = types_within(parts_, region.is_empty() ? region.complement() : region);
        const std::vector<int> choice = add_choice(clauses, types.size());
        for (std::size_t c = 0; c < inputs_.size(); ++c) {
            std::vector<int> inside;
            for (std::size_t t = 0; t < types.size(); ++t)
                if (std::ranges::binary_search(parts_.types[types[t]].classes, c)) inside.push_back(choice[t]);
            if (!inside.empty()) add_input(c, clauses.any_of(inside));
        }
    }

    void add_further_parts() {
        for (const Parts::Type& type : parts_.types) {
            unsigned most = 0;
            for (const std::size_t c : type.classes) most = std::max(most, parts_.classes[c].cap);
            for (int k = 0, before = 0; k < static_cast<int>(most); ++k) {  // the first is there when any is
                const int present = clauses.add_variable();
                if (k > 0) clauses.add({-present, before});
                before = present;
                for (const std::size_t c : type.classes)
                    if (k < static_cast<int>(parts_.classes[c].cap)) add_input(c, present);
            }
        }
    }

    void finish() {
        for (std::size_t a = 0; a < atoms.size(); ++a) {
            const Parts::Atom& atom = parts_.atoms[a];
            join(atoms[a], clauses.at_least(inputs_[atom.part], atom.threshold));
        }
        for (std::size_t id = 0; id < concepts.size(); ++id)
            if (const NamedConcept& named = theory_.concepts[id];
                concepts[id] != 0 && named.definition >= 0 && scope_.axioms[named.axiom])
                join(concepts[id], literal(named.definition));
        for (const Constraint& constraint : theory_.constraints)
            if (constraint.level == Level::object && scope_.axioms[constraint.axiom])
                clauses.add({literal(constraint.formula)});
    }

    Clauses clauses;
    std::vector<int> atoms;     ///< by Parts::atoms
    std::vector<int> concepts;  ///< by concept of the theory; 0: of another layer
    int told = 0;               ///< how many variables somebody asks about

private:
    void add_input(std::size_t part_class, int literal) {
        inputs_[part_class].push_back(literal);
        if (++input_count_ > most_inputs) throw OntologyError(too_many_classes(parts_));
    }

    void join(int variable, int literal) {
        clauses.add({-variable, literal});
        clauses.add({variable, -literal});
    }

    [[nodiscard]] int literal(FormulaId id) {
        if (literals_[id] == 0) literals_[id] = make(id);
        return literals_[id];
    }

    [[nodiscard]] int make(FormulaId id) {
        static const std::vector<int> no_values;
        return formula_literal(
            clauses, theory_.formulas[id], [&](FormulaId operand) { return literal(operand); },
            [](std::size_t) -> const std::vector<int>& { return no_values; },
            [&](int named) { return concepts[static_cast<std::size_t>(named)]; },
            [&](const Formula&) { return parts_.atom_of[id] < 0 ? clauses.never() : atoms[parts_.atom_of[id]]; });
    }

    const Theory& theory_;
    const Scope& scope_;
    const Parts& parts_;
    std::vector<std::vector<int>> inputs_;  ///< by class of parts: literals of which each stands for one
    std::size_t input_count_ = 0;
    std::vector<int> literals_;  ///< by formula, 0 until asked for
};

}  // namespace

Space objects_by_solver(const Theory& theory, const Scope& scope, const Parts& parts,
                        const std::vector<ConfigurationSet>& regions, bool complete, std::string why) {
    ObjectSolver object(theory, scope, parts);
    for (const ConfigurationSet& region : regions) object.add_region(region);
    if (!complete) object.add_further_parts();
    object.finish();
    Layer layer;
    Space& space = layer.space;
    space.diagram = std::make_shared<const Diagram>(Diagram::sampled(object.clauses, std::move(why), object.told));
    const auto set = [&](int literal) { return ConfigurationSet(space.diagram, {literal}); };
    for (const Parts::Atom& atom : parts.atoms) space.variables.push_back(part_variable(atom, false));
    add_primitives(theory, scope, {}, layer);
    for (const int atom : object.atoms) space.holds.push_back({set(atom), set(-atom)});
    space.holds.resize(space.variables.size());
    std::vector<int> none_of_them;  // concepts without definition
    for (std::size_t id = 0; id < theory.concepts.size(); ++id)
        if (const int variable = layer.primitives[id]; variable >= 0) {
            const int literal = object.concepts[id];
            space.holds[static_cast<std::size_t>(variable)] = {set(literal), set(-literal)};
            none_of_them.push_back(-literal);
        }
    space.up_to.resize(space.holds.size());
    space.size = space.all().count();
    space.possible = space.all();
    for (std::size_t id = 0; id < theory.concepts.size(); ++id) {
        const NamedConcept& named = theory.concepts[id];
        if (object.concepts[id] == 0 || named.open) continue;
        const ConfigurationSet where = set(object.concepts[id]);
        if (named.incompatible) space.possible -= where;
        bool provable = named.definition >= 0;
        if (provable && !none_of_them.empty() && !where.is_empty())
            provable = !(where & ConfigurationSet(space.diagram, none_of_them)).is_empty();
        space.concepts.push_back({named.iri, where, named.incompatible, provable, false});
    }
    return space;
}

}  // namespace partonomy::knowledge
