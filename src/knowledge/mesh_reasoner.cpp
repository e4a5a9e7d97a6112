/* What the whole ontology says about one mesh.

   The mesh is grounded once (closed_world.h), with a selector for each axiom; the answers are class assertions and so
   have selectors, too. What follows for regions and object is one backbone over the concepts that their sets leave
   open; what is known of a set already is assumed, which is sound and saves the solver work. Explanations are minimal
   conflicts between selectors, corrections the cheapest sets of answers to give up (explanations.h).

   The world is told which composite parts there are. For explanations the regions are there a second time, as clauses
   that say which composite parts they make (object_composites.cpp); both share the selectors of axioms and answers.
   Without some of the answers there may be other composite parts, of more regions or of fewer: a leg that nobody asked
   about may belong to the frame of its neighbour. So this world has a thing for each region that may be the first of a
   composite part of each kind, and what it is told of that (it is there, it has that region) holds when the second
   formula makes it so, and no other time. One minimal conflict of both is minimal also in what makes composite parts.

   Cost: 20 parts with 5 features are 121 individuals, some 10,000 clauses and a few milliseconds; what properties of
   which nothing is known cost grows with the square of the individuals. */

#include <algorithm>
#include <stdexcept>

#include "knowledge/assembly.h"
#include "knowledge/mesh_world.h"
#include "knowledge/object_clauses.h"
#include "knowledge/reasons.h"
#include "knowledge/solver.h"

namespace partonomy::knowledge {

struct MeshReasoner::State {
    const Domain& domain;
    const Knowledge knowledge;
    const bool to_explain;
    const std::vector<CompositePart> certain;     ///< composite parts that there are
    const std::vector<CompositePart> composites;  ///< to explain: those that there might be, else the certain ones
    MeshWorld mesh;
    GroundedWorld grounded;
    std::optional<Solver> solver;

    State(const Domain& given, const Knowledge& known, const std::vector<CompositePart>& parts, bool explains)
        : domain(given),
          knowledge(known),
          to_explain(explains && !given.composites.empty()),
          certain(parts),
          composites(to_explain ? candidate_composites(given, known) : parts),
          mesh(make_mesh_world(given, knowledge, composites)),
          grounded(mesh.world, limits(), questions(mesh)) {}

    static GroundOptions limits() {
        GroundOptions options;
        options.max_clauses = 8'000'000;
        return options;
    }

    static std::vector<owl::ClassPointer> questions(const MeshWorld& mesh) {
        std::vector<owl::ClassPointer> asked = mesh.open;
        std::erase(asked, nullptr);
        return asked;
    }

    [[nodiscard]] const Theory& theory() const { return domain.grounding->theory; }

    [[nodiscard]] int literal(const Iri& individual, int concept_id) {
        const owl::ClassPointer& open = mesh.open[static_cast<std::size_t>(concept_id)];
        return open ? grounded.is_a(individual, *open)
                    : grounded.is_a(individual, theory().concepts[static_cast<std::size_t>(concept_id)].iri);
    }

    /// A literal about an individual, and the configurations in which it is true.
    struct Fact {
        int literal;
        const ConfigurationSet* where;
    };

    /// Concepts and open restrictions of a space at one individual.
    [[nodiscard]] std::vector<Fact> facts_about(const Iri& individual, const Space& space) {
        std::vector<Fact> facts;
        for (const Concept& each : space.concepts)
            facts.push_back({literal(individual, theory().find(each.iri)), &each.where});
        for (std::size_t v = 0; v < space.variables.size(); ++v)
            if (space.variables[v].kind == VariableKind::open)
                facts.push_back({literal(individual, theory().find(space.variables[v].iri)), &space.holds[v][0]});
        return facts;
    }

    /// Literals of what `set` tells; what it leaves open goes to `open`.
    static void sort_facts(const std::vector<Fact>& facts, const ConfigurationSet& set, std::vector<int>& told,
                           std::vector<Fact>& open) {
        for (const Fact& fact : facts) {
            if (set.is_subset_of(*fact.where))
                told.push_back(fact.literal);
            else if (!set.intersects(*fact.where))
                told.push_back(-fact.literal);
            else
                open.push_back(fact);
        }
    }

    /// A solver in which every axiom and every answer holds.
    [[nodiscard]] Solver& everything() {
        if (!solver) {
            solver.emplace(grounded.clauses());
            solver->require(grounded.selectors());
        }
        solver->add_new(grounded.clauses());
        return *solver;
    }

    /// Literals of `open` that follow from `told`, sorted.
    [[nodiscard]] std::vector<int> entailed(const std::vector<int>& told, const std::vector<Fact>& open) {
        std::vector<int> candidates;
        for (const Fact& fact : open) {
            candidates.push_back(fact.literal);
            candidates.push_back(-fact.literal);
        }
        std::vector<int> found = everything().entailed(candidates, told);
        std::ranges::sort(found);
        return found;
    }

    static void apply(const std::vector<int>& entailed, const std::vector<Fact>& open, ConfigurationSet& set) {
        for (const Fact& fact : open) {
            if (std::ranges::binary_search(entailed, fact.literal)) set &= *fact.where;
            if (std::ranges::binary_search(entailed, -fact.literal)) set -= *fact.where;
        }
    }

    enum class Element { axiom, answer };

    /// What explanations and corrections are about: selectors, the goal's negation being required.
    struct Question {
        std::vector<Selector> selectors;
        std::vector<std::pair<Element, std::size_t>> elements;  ///< what, and its index
        Solver solver;
    };

    /// Someone who may be what is asked about.
    struct Goal {
        int literal = 0;  ///< that it is
        int part = -1;    ///< of `certain`: which has to be there as well; -1: a region, or the object
    };

    /// What may be meant: any region, or any composite part, unless one is given.
    [[nodiscard]] std::vector<Goal> goals(const Iri& concept_iri, int region) {
        const int id = theory().find(concept_iri);
        if (id < 0) throw std::invalid_argument("explain: " + concept_iri + " is no concept");
        const Level level = theory().concepts[static_cast<std::size_t>(id)].level;
        if (level != Level::region && level != Level::composite) return {{literal(mesh.object, id)}};
        if (region >= 0) return {{literal(mesh.regions.at(static_cast<std::size_t>(region)), id)}};
        std::vector<Goal> result;
        if (level == Level::region)
            for (const Iri& each : mesh.regions) result.push_back({literal(each, id)});
        for (std::size_t i = 0; level == Level::composite && i < certain.size(); ++i)
            result.push_back({literal(mesh.composites[place_of(certain[i])], id), static_cast<int>(i)});
        return result;
    }

    /// The thing that stands for a composite part.
    [[nodiscard]] std::size_t place_of(const CompositePart& part) const {
        const auto found = std::ranges::find_if(composites, [&](const CompositePart& each) {
            return each.group == part.group && each.regions[0] == part.regions[0];
        });
        return static_cast<std::size_t>(found - composites.begin());
    }

    [[nodiscard]] Question ask(const Iri& concept_iri, int region, bool axioms_are_given,
                               const std::vector<double>* costs) {
        const std::vector<Goal> wanted = concept_iri.empty() ? std::vector<Goal>{} : goals(concept_iri, region);
        const std::vector<Told> told = to_explain ? told_composites() : std::vector<Told>{};
        Question question{{}, {}, Solver(grounded.clauses())};
        const std::vector<int>& selectors = grounded.selectors();
        const std::size_t axioms = domain.ontology.axioms.size();
        const auto add = [&](Element element, std::size_t i, std::size_t index, double weight) {
            question.selectors.push_back({selectors[i], weight});
            question.elements.emplace_back(element, index);
        };
        std::vector<char> follows(selectors.size(), 0);  // what is told of composite parts, from what makes them
        for (const Told& each : told) follows[each.what.axiom] = 1;
        std::vector<int> is_there;  // by certain composite part
        if (to_explain) is_there = link_composites(question.solver, told);
        std::vector<int> given;
        for (std::size_t i = 0; i < selectors.size(); ++i) {
            if (i < axioms && !axioms_are_given)
                add(Element::axiom, i, i, 1);
            else if (i >= mesh.first_answer && i < mesh.first_answer + knowledge.answers.size())
                add(Element::answer, i, i - mesh.first_answer, costs ? (*costs)[i - mesh.first_answer] : 1);
            else if (!follows[i])
                given.push_back(selectors[i]);
        }
        question.solver.require(given);
        if (!concept_iri.empty()) require_not(question, wanted, is_there, concept_iri);
        return question;
    }

    /// Requires that the first of the goals that follows does not hold.
    static void require_not(Question& question, const std::vector<Goal>& goals, const std::vector<int>& is_there,
                            const Iri& concept_iri) {
        std::vector<int> everything;
        for (const Selector& selector : question.selectors) everything.push_back(selector.literal);
        for (const Goal& goal : goals) {
            std::vector<int> all{goal.literal};
            if (goal.part >= 0 && !is_there.empty()) all.push_back(is_there[static_cast<std::size_t>(goal.part)]);
            const bool is_entailed = goals.size() == 1 || std::ranges::all_of(all, [&](int literal) {
                                         everything.push_back(-literal);
                                         const Verdict verdict = question.solver.solve(everything);
                                         everything.pop_back();
                                         return verdict == Verdict::unsatisfiable;
                                     });
            if (!is_entailed) continue;
            for (int& literal : all) literal = -literal;
            Clauses fails;
            fails.add(all);
            question.solver.add_more(fails);
            return;
        }
        throw std::invalid_argument("explain: " + concept_iri + " does not follow from what is known");
    }

    /// What the world is told of a composite part, and the literal of that (0: there is none).
    struct Told {
        MeshWorld::Told what;
        int literal;
    };
    [[nodiscard]] std::vector<Told> told_composites() {
        std::vector<Told> result;
        for (const MeshWorld::Told& each : mesh.told_composites) {
            const owl::Axiom& axiom = mesh.world.ontology.axioms[each.axiom];
            int literal = 0;
            if (axiom.kind == owl::AxiomKind::object_property_assertion)
                literal = grounded.related(axiom.individuals[0], axiom.properties[0], axiom.individuals[1]);
            else if (axiom.classes[0]->kind == owl::ClassKind::named)
                literal = grounded.is_a(axiom.individuals[0], axiom.classes[0]->iri);
            result.push_back({each, literal});
        }
        return result;
    }

    /// What is told of a composite part holds when the regions make it so, and no other time; what they make follows
    /// from answers and axioms about regions. Returns, for each of the certain composite parts, whether there is one of
    /// just its regions.
    std::vector<int> link_composites(Solver& into, const std::vector<Told>& told_of) const {
        const std::vector<int>& selectors = grounded.selectors();
        ObjectClauses object(theory());
        for (int region = 0; region < knowledge.region_count; ++region) static_cast<void>(object.add_region());
        for (const auto& [a, b] : knowledge.connected)
            object.touch(static_cast<std::size_t>(a), static_cast<std::size_t>(b));
        object.require_constraints(Level::region);
        const auto says = [&](const MeshWorld::Told& told) {
            const CompositePart& part = composites[told.composite];
            const auto group = static_cast<std::size_t>(part.group), first = static_cast<std::size_t>(part.regions[0]);
            if (told.region >= 0) return object.composite_has(group, first, static_cast<std::size_t>(told.region));
            if (told.inner < 0) return object.composite(group, first);
            const CompositePart& inner = composites[static_cast<std::size_t>(told.inner)];
            return object.composite_has(group, first, static_cast<std::size_t>(inner.group),
                                        static_cast<std::size_t>(inner.regions[0]));
        };
        std::vector<int> is_so, is_there, answers;
        for (const Told& told : told_of) is_so.push_back(says(told.what));
        for (const CompositePart& part : certain)
            is_there.push_back(object.composite(static_cast<std::size_t>(part.group),
                                                std::vector<std::size_t>(part.regions.begin(), part.regions.end())));
        for (const Answer& answer : knowledge.answers)
            answers.push_back(literal_of(domain, object, static_cast<std::size_t>(answer.region), answer));
        const int by = into.append(object.clauses);
        const auto shifted = [&](int literal) { return literal > 0 ? literal + by : literal - by; };
        Clauses links;
        for (const std::size_t axiom : object.axioms()) links.add({-selectors[axiom], shifted(object.selector(axiom))});
        for (std::size_t i = 0; i < answers.size(); ++i)
            links.add({-selectors[mesh.first_answer + i], shifted(answers[i])});
        for (std::size_t i = 0; i < told_of.size(); ++i) {
            links.add({-shifted(is_so[i]), selectors[told_of[i].what.axiom]});
            if (told_of[i].literal != 0) links.add({shifted(is_so[i]), -told_of[i].literal});
        }
        into.add_more(links);
        for (int& literal : is_there) literal = shifted(literal);
        return is_there;
    }

    [[nodiscard]] Explanation explanation(const Question& question, const SelectorSet& set) const {
        Explanation result;
        result.needs_completeness = true;
        for (const std::size_t i : set) {
            const auto [element, index] = question.elements[i];
            (element == Element::answer ? result.answers : result.axioms).push_back(index);
        }
        std::ranges::sort(result.answers);
        std::ranges::sort(result.axioms);
        return result;
    }
};

MeshReasoner::MeshReasoner(const Domain& domain, const Knowledge& knowledge,
                           const std::vector<CompositePart>& composites, bool to_explain)
    : state_(std::make_unique<State>(domain, knowledge, composites, to_explain)) {}

MeshReasoner::~MeshReasoner() = default;

bool MeshReasoner::narrow(std::vector<ConfigurationSet>& regions) {
    std::vector<int> told;
    std::vector<std::vector<State::Fact>> open(regions.size());
    std::vector<State::Fact> all;
    for (std::size_t r = 0; r < regions.size(); ++r) {
        if (regions[r].is_empty()) continue;
        State::sort_facts(state_->facts_about(state_->mesh.regions[r], state_->domain.regions), regions[r], told,
                          open[r]);
        all.insert(all.end(), open[r].begin(), open[r].end());
    }
    if (state_->everything().solve(told) == Verdict::unsatisfiable) return false;
    const std::vector<int> entailed = state_->entailed(told, all);
    for (std::size_t r = 0; r < regions.size(); ++r) State::apply(entailed, open[r], regions[r]);
    return true;
}

bool MeshReasoner::narrow(const std::vector<ConfigurationSet>& regions, const Space& objects,
                          ConfigurationSet& object) {
    std::vector<int> told;
    std::vector<State::Fact> open, ignored;
    for (std::size_t r = 0; r < regions.size(); ++r)
        if (!regions[r].is_empty())
            State::sort_facts(state_->facts_about(state_->mesh.regions[r], state_->domain.regions), regions[r], told,
                              ignored);
    State::sort_facts(state_->facts_about(state_->mesh.object, objects), object, told, open);
    if (state_->everything().solve(told) == Verdict::unsatisfiable) return false;
    State::apply(state_->entailed(told, open), open, object);
    return !object.is_empty();
}

void MeshReasoner::narrow(std::vector<CompositePart>& composites) {
    for (std::size_t i = 0; i < composites.size(); ++i) {
        std::vector<int> told;
        std::vector<State::Fact> open;
        CompositePart& part = composites[i];
        const Space& space = state_->domain.composites[static_cast<std::size_t>(part.group)].space;
        State::sort_facts(state_->facts_about(state_->mesh.composites[i], space), part.possible, told, open);
        State::apply(state_->entailed(told, open), open, part.possible);
    }
}

Explanation MeshReasoner::explain(const Iri& concept_iri, int region, std::uint64_t steps) {
    State::Question question = state_->ask(concept_iri, region, false, nullptr);
    std::optional<Conflict> found;
    try {
        found = minimal_conflict(question.solver, question.selectors, steps);
    } catch (const OutOfSteps&) {
        refuse_to_search_on(concept_iri, steps);
    }
    if (!found)
        throw std::invalid_argument("explain: " + (concept_iri.empty() ? std::string("a contradiction") : concept_iri) +
                                    " does not follow from what is known");
    Explanation explanation = state_->explanation(question, found->set);
    explanation.is_minimal = found->is_minimal;
    return explanation;
}

Explanations MeshReasoner::explain_all(const Iri& concept_iri, int region, const ExplanationOptions& options) {
    State::Question question = state_->ask(concept_iri, region, false, nullptr);
    const RankedSets found = all_conflicts(question.solver, question.selectors, options).conflicts;
    Explanations result;
    result.is_complete = found.is_complete;
    for (const RankedSet& each : found.sets) result.sets.push_back(state_->explanation(question, each.set));
    return result;
}

std::vector<Correction> MeshReasoner::correct(const Iri& concept_iri, const std::vector<double>& costs, int region,
                                              const ExplanationOptions& options) {
    State::Question question = state_->ask(concept_iri, region, true, &costs);
    std::vector<Correction> found;
    if (question.solver.solve() == Verdict::unsatisfiable) return found;  // whatever is answered
    for (const RankedSet& each : cheapest_corrections(question.solver, question.selectors, options).sets) {
        found.push_back({{}, each.weight});
        for (const std::size_t i : each.set) found.back().answers.push_back(question.elements[i].second);
    }
    return found;
}

}  // namespace partonomy::knowledge
