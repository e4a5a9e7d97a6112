#include "knowledge/causes.h"

#include <algorithm>

#include "knowledge/object_clauses.h"

// Ask for one region that is a member (or for an object, or a composite part, with as many parts as could be needed),
// with every axiom as a selector: the minimal conflicts are the causes. Features and the exclusion of their values are
// no axioms to blame.

namespace partonomy::knowledge {
namespace {

constexpr std::size_t most_to_enumerate = 60;  // axioms; beyond, one cause has to do
constexpr std::size_t most_parts_of_composites = 40;
constexpr std::uint64_t most_steps = 300'000;  // for the causes after the first: about 0.2 s

std::vector<Cause> causes(const Theory& theory, Level level, int goal, std::size_t limit) {
    ObjectClauses object(theory);
    if (level == Level::region) {
        (void)object.add_region();
    } else {
        const std::size_t parts = parts_for(theory, goal);
        if (!theory.groups.empty() && parts > most_parts_of_composites) return {};
        object.add_further_parts(parts);
    }
    object.require_constraints(Level::region);
    if (level != Level::region) object.require_constraints(Level::composite);
    if (level == Level::object) object.require_constraints(Level::object);
    if (goal >= 0)
        object.clauses.add({level == Level::region      ? object.region_concept(0, goal)
                            : level == Level::composite ? object.some_composite(goal)
                                                        : object.object_concept(goal)});

    const std::vector<std::size_t> axioms = object.axioms();
    std::vector<Selector> selectors;
    for (const std::size_t axiom : axioms) selectors.push_back({object.selector(axiom)});
    Solver solver(object.clauses);
    std::vector<SelectorSet> sets;
    if (axioms.size() <= most_to_enumerate && limit > 1) {
        for (RankedSet& each : lightest_conflicts(solver, selectors, {limit, most_steps}).sets)
            sets.push_back(std::move(each.set));
    }
    if (sets.empty()) try {
            if (auto one = minimal_conflict(solver, selectors)) sets.push_back(std::move(one->set));
        } catch (const OutOfSteps&) {  // then it is told without a cause
        }
    std::vector<Cause> result;
    for (const SelectorSet& set : sets) {
        Cause& cause = result.emplace_back();
        for (const std::size_t i : set) cause.push_back(axioms[i]);
    }
    return result;
}

}  // namespace

std::vector<Cause> causes_of_unsatisfiable(const Theory& theory, int id, std::size_t limit) {
    return causes(theory, theory.concepts[id].level, id, limit);
}

std::vector<Cause> causes_of_nothing(const Theory& theory, Level level, std::size_t limit) {
    return causes(theory, level, -1, limit);
}

}  // namespace partonomy::knowledge
