/* Explanations and corrections as questions to a SAT solver.

   The object and its regions become clauses with a selector for each axiom (object_clauses.h); the literal of an answer
   is its own selector; further parts may be there unless "there are no other parts" says otherwise. Add that the goal
   does not hold: then a minimal conflict is a minimal explanation, all conflicts are all explanations, and a cheapest
   correction among the answers, with all axioms switched on, is a cheapest set of answers to turn round: in every
   object that remains each of them is the other way, or it would not have been needed (explanations.h).

   Only the goal's cone is written down. Cost: one solver with some hundred variables a region, and a call of it for
   each axiom and answer in the first conflict that it finds; furniture takes a millisecond. */

#include "knowledge/reasons.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <stdexcept>

#include "base/errors.h"
#include "knowledge/assembly.h"
#include "knowledge/object_clauses.h"

namespace partonomy::knowledge {
namespace {

bool is_in(const Space& space, const ConfigurationSet& set, const Iri& iri) {
    const std::optional<ConceptId> id = space.find(iri);
    return id && !set.is_empty() && set.is_subset_of(space.concepts[*id].where);
}

/// What is to be explained, and where.
struct Goal {
    int id = -1;                  ///< concept of the theory, -1 for a contradiction
    Level level = Level::object;  ///< region: the goal is about `regions` alone; composite: about `part`
    std::vector<int> regions;     ///< whose answers count
    CompositePart part;           ///< composite: the one that is a member
};

std::vector<int> all_but_empty(const std::vector<ConfigurationSet>& regions) {
    std::vector<int> result;
    for (std::size_t r = 0; r < regions.size(); ++r)
        if (!regions[r].is_empty()) result.push_back(static_cast<int>(r));
    return result;
}

/// Throws std::invalid_argument unless it follows.
Goal find_goal(const Domain& domain, const Conclusions& known, const Iri& iri, int region) {
    Goal goal;
    if (iri.empty()) {
        for (std::size_t r = 0; r < known.regions.size(); ++r)
            if (known.regions[r].is_empty()) goal.regions.push_back(static_cast<int>(r));
        goal.level = goal.regions.empty() ? Level::object : Level::region;
        if (goal.regions.empty()) goal.regions = all_but_empty(known.regions);
        if (known.contradiction) return goal;
    } else {
        goal.id = domain.grounding->theory.find(iri);
        goal.regions = all_but_empty(known.regions);
        if (is_in(*known.objects, known.object, iri)) return goal;
        goal.level = Level::composite;
        for (const CompositePart& part : known.composites)
            if (is_in(domain.composites[static_cast<std::size_t>(part.group)].space, part.possible, iri)) {
                goal.part = part;
                return goal;
            }
        goal.level = Level::region;
        for (const int r : goal.regions)
            if ((region < 0 || r == region) && is_in(domain.regions, known.regions[r], iri)) {
                goal.regions = {r};
                return goal;
            }
    }
    throw std::invalid_argument("explain: " + (iri.empty() ? std::string("a contradiction") : iri) +
                                " does not follow from what is known");
}

/// Tells which of the regions touch; `parts`: their numbers in the object.
void touch(ObjectClauses& object, const std::map<int, std::size_t>& parts, const Knowledge& knowledge) {
    for (const auto& [a, b] : knowledge.connected)
        if (parts.contains(a) && parts.contains(b)) object.touch(parts.at(a), parts.at(b));
}

/// What is likely is tried first: it is all but consistent, so little is left to search for.
void prefer(Solver& solver, std::span<const Selector> selectors) {
    std::vector<int> literals;
    for (const Selector& selector : selectors) literals.push_back(selector.literal);
    solver.prefer(literals);
}

/// Whether the formula has a model with `literals`. It is looked for near what the selectors say: those of one conflict
/// after the other are given up, which takes much less than a search among all objects.
bool is_possible(Solver& solver, const std::vector<int>& literals, std::span<const Selector> selectors) {
    std::set<int> kept;
    for (const Selector& selector : selectors) kept.insert(selector.literal);
    while (true) {
        std::vector<int> assumptions = literals;
        for (const Selector& selector : selectors)
            if (kept.contains(selector.literal)) assumptions.push_back(selector.literal);
        if (solver.solve(assumptions) == Verdict::satisfiable) return true;
        const std::size_t before = kept.size();
        for (const int literal : solver.core()) kept.erase(literal);
        if (kept.size() == before) return false;
    }
}

/// An object in which the goal fails, with what speaks against that as selectors.
class Reasons {
public:
    enum class Kind { completeness, axiom, answer };
    struct Element {
        Kind kind;
        std::size_t index;
    };

    Reasons(const Domain& domain, const Knowledge& knowledge, const Goal& goal)
        : theory_(domain.grounding->theory), object_(theory_) {
        std::map<int, std::size_t> parts;
        for (const int region : goal.regions) parts[region] = object_.add_region();
        if (goal.level == Level::object)
            object_.add_further_parts(
                parts_that_help(theory_, goal.id < 0 ? std::vector<int>{} : std::vector{goal.id}));
        touch(object_, parts, knowledge);
        object_.require_constraints(Level::region);
        if (goal.level != Level::region) object_.require_constraints(Level::composite);
        if (goal.level == Level::object) {
            object_.require_constraints(Level::object);
            if (goal.id >= 0) object_.clauses.add({-object_.object_concept(goal.id)});
        } else if (goal.level == Level::composite) {
            std::vector<std::size_t> regions;
            for (const int region : goal.part.regions) regions.push_back(parts.at(region));
            object_.clauses.add(
                {-object_.composite_concept(static_cast<std::size_t>(goal.part.group), regions, goal.id)});
        } else if (goal.id >= 0) {
            object_.clauses.add({-object_.region_concept(0, goal.id)});
        }
        std::vector<int> literals(knowledge.answers.size(), 0);
        for (std::size_t i = 0; i < literals.size(); ++i)
            if (const auto part = parts.find(knowledge.answers[i].region); part != parts.end())
                literals[i] = literal_of(domain, object_, part->second, knowledge.answers[i]);

        if (knowledge.complete && goal.level == Level::object) add(Kind::completeness, 0, object_.no_further_parts());
        always_needs_completeness_ = goal.level == Level::composite;  // who belongs to it is known only then
        const std::vector<char> own = defining_axioms(theory_, goal.id, domain.ontology.axioms.size());
        for (const std::size_t axiom : object_.axioms())
            if (!own[axiom]) add(Kind::axiom, axiom, object_.selector(axiom));
        first_answer_ = elements_.size();
        for (std::size_t i = 0; i < literals.size(); ++i)
            if (literals[i] != 0) add(Kind::answer, i, literals[i]);
        for (const std::size_t axiom : object_.axioms())
            if (own[axiom]) add(Kind::axiom, axiom, object_.selector(axiom));
    }

    /// One explanation, without completeness and axioms from elsewhere when that is possible.
    [[nodiscard]] Explanation one(std::uint64_t most_steps) const {
        Solver solver(object_.clauses);
        prefer(solver, selectors_);
        std::size_t begin = 0;
        for (const std::size_t later : {first_answer_, std::size_t{!elements_.empty()}})
            if (begin == 0 && later > 0 && conflicts(solver, later, most_steps)) begin = later;
        const auto found = minimal_conflict(solver, std::span(selectors_).subspan(begin), most_steps);
        if (!found) throw std::logic_error("explain: the clauses do not entail what the layers do");
        Explanation result = explanation(found->set, begin);
        result.is_minimal = found->is_minimal;
        return result;
    }

    [[nodiscard]] Explanations all(const ExplanationOptions& options) const {
        Solver solver(object_.clauses);
        prefer(solver, selectors_);
        const RankedSets found = all_conflicts(solver, selectors_, options).conflicts;
        Explanations result;
        result.is_complete = found.is_complete;
        for (const RankedSet& each : found.sets) result.sets.push_back(explanation(each.set, 0));
        return result;
    }

private:
    void add(Kind kind, std::size_t index, int literal) {
        elements_.push_back({kind, index});
        selectors_.push_back({literal, 1});
    }
    /// Whether the elements from `begin` on do, as far as the steps tell.
    [[nodiscard]] bool conflicts(Solver& solver, std::size_t begin, std::uint64_t most_steps) const {
        std::vector<int> literals;
        for (std::size_t i = begin; i < selectors_.size(); ++i) literals.push_back(selectors_[i].literal);
        Steps steps(most_steps);
        solver.take_from(&steps);
        bool found = false;
        try {
            found = solver.solve(literals) == Verdict::unsatisfiable;
        } catch (const OutOfSteps&) {
        }
        solver.take_from(nullptr);
        return found;
    }
    [[nodiscard]] Explanation explanation(const SelectorSet& set, std::size_t begin) const {
        Explanation result;
        result.needs_completeness = always_needs_completeness_;
        for (const std::size_t i : set) {
            const Element& element = elements_[begin + i];
            if (element.kind == Kind::completeness) result.needs_completeness = true;
            if (element.kind == Kind::axiom) result.axioms.push_back(element.index);
            if (element.kind == Kind::answer) result.answers.push_back(element.index);
        }
        std::ranges::sort(result.axioms);
        return result;
    }

    const Theory& theory_;
    ObjectClauses object_;
    std::vector<Element> elements_;
    std::vector<Selector> selectors_;
    std::size_t first_answer_ = 0;
    bool always_needs_completeness_ = false;
};

}  // namespace

int literal_of(const Domain& domain, ObjectClauses& object, std::size_t part, const Answer& answer) {
    const Theory& theory = domain.grounding->theory;
    const auto variable = static_cast<std::size_t>(answer.question.variable);
    int literal = 0;
    if (variable >= theory.feature_count())
        literal = object.region_concept(part, theory.find(domain.regions.variables[variable].iri));
    else if (variable >= theory.ranges.size() && variable < theory.ranges.size() + theory.numbers.size())
        literal = object.up_to(part, variable, answer.question.value);
    else
        literal = object.value(part, variable, answer.question.value);
    return answer.yes ? literal : -literal;
}

struct FromAxioms::State {
    State(const Domain& domain, const Knowledge& knowledge, int goal, const std::vector<char>& answers, bool complete)
        : object(domain.grounding->theory) {
        const Theory& theory = domain.grounding->theory;
        std::vector<int> told;
        for (int region = 0; region < knowledge.region_count; ++region) static_cast<void>(object.add_region());
        if (!complete)
            object.add_further_parts(parts_that_help(theory, goal < 0 ? std::vector<int>{} : std::vector{goal}));
        object.require_constraints(Level::region);
        object.require_constraints(Level::object);
        if (goal >= 0) object.clauses.add({-object.object_concept(goal)});
        for (std::size_t i = 0; i < answers.size(); ++i)
            if (answers[i])
                object.clauses.add({literal_of(domain, object, static_cast<std::size_t>(knowledge.answers[i].region),
                                               knowledge.answers[i])});
        for (const std::size_t axiom : object.axioms()) selectors.emplace_back(axiom, object.selector(axiom));
        std::ranges::sort(selectors, {}, &std::pair<std::size_t, int>::second);
        solver.emplace(object.clauses);
    }
    ObjectClauses object;
    std::vector<std::pair<std::size_t, int>> selectors;  ///< axiom, literal
    std::optional<Solver> solver;
    std::optional<std::vector<int>> core;  ///< selectors that are known to suffice
};

FromAxioms::FromAxioms(const Domain& domain, const Knowledge& knowledge, int goal, const std::vector<char>& answers,
                       bool complete)
    : state_(std::make_unique<State>(domain, knowledge, goal, answers, complete)) {}

FromAxioms::~FromAxioms() = default;

bool FromAxioms::follows(const std::vector<char>& axioms) {
    std::vector<int> kept;
    for (const auto& [axiom, literal] : state_->selectors)
        if (axioms[axiom]) kept.push_back(literal);
    if (state_->core && std::ranges::includes(kept, *state_->core)) return true;
    if (state_->solver->solve(kept) == Verdict::satisfiable) return false;
    state_->core = state_->solver->core();
    return true;
}

void refuse_to_search_on(const Iri& concept_iri, std::uint64_t steps) {
    throw OntologyError("why " +
                        (concept_iri.empty() ? "answers and axioms contradict each other"
                                             : "it is " + with_article(owl::local_name(concept_iri))) +
                        " was not found within " + std::to_string(steps) + " steps of search");
}

Explanation one_reason(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri, int region,
                       std::uint64_t steps) {
    Goal goal = find_goal(domain, conclude(domain, knowledge), concept_iri, region);
    if (goal.id < 0 && goal.level == Level::region) goal.regions.resize(1);  // one contradiction is enough
    try {
        return Reasons(domain, knowledge, goal).one(steps);
    } catch (const OutOfSteps&) {
        refuse_to_search_on(concept_iri, steps);
    }
}

Explanations all_reasons(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri, int region,
                         const ExplanationOptions& options) {
    Goal goal = find_goal(domain, conclude(domain, knowledge), concept_iri, region);
    if (goal.id < 0) {  // within one region, or between them
        goal.level = Level::object;
        goal.regions.resize(static_cast<std::size_t>(knowledge.region_count));
        std::iota(goal.regions.begin(), goal.regions.end(), 0);
    }
    return Reasons(domain, knowledge, goal).all(options);
}

std::vector<Correction> cheapest_changes(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri,
                                         const std::vector<double>& costs, int region,
                                         const ExplanationOptions& options) {
    const Conclusions known = conclude(domain, knowledge);
    const Goal goal = find_goal(domain, known, concept_iri, region);
    const Theory& theory = domain.grounding->theory;
    std::vector<int> unwanted;  // concepts of the object that must not hold
    if (goal.id >= 0 && goal.level == Level::object) unwanted.push_back(goal.id);
    // What is not wanted of composite parts is only told where they are known.
    const bool with_object = theory.groups.empty() || (knowledge.complete && goal.level != Level::region);
    for (const Concept& each : known.objects->concepts)
        if (with_object && each.incompatible && !is_in(*known.objects, known.object, each.iri))
            unwanted.push_back(theory.find(each.iri));

    ObjectClauses object(theory, false);
    std::map<int, std::size_t> parts;
    const bool has_goal = goal.id >= 0;
    for (int r = 0; r < knowledge.region_count; ++r)
        if (!has_goal || !known.regions[r].is_empty()) parts[r] = object.add_region();
    if (!knowledge.complete) object.add_further_parts(parts_that_help(theory, unwanted));
    touch(object, parts, knowledge);
    object.require_constraints(Level::region);
    if (with_object) object.require_constraints(Level::composite);
    if (with_object) object.require_constraints(Level::object);
    if (has_goal && goal.level == Level::composite) object.clauses.add({-object.some_composite(goal.id)});
    if (has_goal && goal.level == Level::region)
        object.clauses.add({-object.region_concept(parts.at(goal.regions[0]), goal.id)});
    if (has_goal && goal.level == Level::object) object.clauses.add({-object.object_concept(goal.id)});
    std::vector<int> others;  // that must not hold either, if that is possible
    for (const int id : unwanted)
        if (id != goal.id) others.push_back(-object.object_concept(id));
    for (std::size_t id = 0; with_object && id < theory.concepts.size(); ++id) {
        const NamedConcept& named = theory.concepts[id];
        if (named.level != Level::composite || !named.incompatible || static_cast<int>(id) == goal.id) continue;
        const bool follows = std::ranges::any_of(known.composites, [&](const CompositePart& part) {
            return is_in(domain.composites[static_cast<std::size_t>(part.group)].space, part.possible, named.iri);
        });
        if (!follows) others.push_back(-object.some_composite(static_cast<int>(id)));
    }
    for (const Concept& each : domain.regions.concepts)
        if (each.incompatible)
            for (const auto& [r, part] : parts)
                if (!is_in(domain.regions, known.regions[r], each.iri))
                    others.push_back(-object.region_concept(part, theory.find(each.iri)));
    std::vector<Selector> selectors;
    std::vector<std::size_t> indices;
    for (std::size_t i = 0; i < costs.size(); ++i)
        if (const auto part = parts.find(knowledge.answers[i].region); part != parts.end()) {
            selectors.push_back({literal_of(domain, object, part->second, knowledge.answers[i]), costs[i]});
            indices.push_back(i);
        }

    Solver solver(object.clauses);
    prefer(solver, selectors);
    if (is_possible(solver, others, selectors)) solver.require(others);
    std::vector<Correction> found;
    if (!is_possible(solver, {}, selectors)) return found;
    for (const RankedSet& each : cheapest_corrections(solver, selectors, options).sets) {
        found.push_back({{}, each.weight});
        for (const std::size_t i : each.set) found.back().answers.push_back(indices[i]);
    }
    return found;
}

}  // namespace partonomy::knowledge
