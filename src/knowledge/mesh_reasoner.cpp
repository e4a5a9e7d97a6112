/* What the whole ontology says about one mesh.

   The mesh is grounded once (closed_world.h), with a selector for each axiom; the answers are class assertions and so
   have selectors, too. What follows for regions and object is one backbone over the concepts that their sets leave
   open; what is known of a set already is assumed, which is sound and saves the solver work. Explanations are minimal
   conflicts between selectors, corrections the cheapest sets of answers to give up (explanations.h).

   Cost: 20 parts with 5 features are 121 individuals, some 10,000 clauses and a few milliseconds; what properties of
   which nothing is known cost grows with the square of the individuals. */

#include <algorithm>
#include <map>
#include <set>
#include <stdexcept>

#include "knowledge/assembly.h"
#include "knowledge/mesh_world.h"
#include "knowledge/solver.h"

namespace partonomy::knowledge {

struct MeshReasoner::State {
    const Domain& domain;
    const Knowledge knowledge;
    const std::vector<CompositePart> composites;
    MeshWorld mesh;
    GroundedWorld grounded;
    std::optional<Solver> solver;

    State(const Domain& given, const Knowledge& known, const std::vector<CompositePart>& parts)
        : domain(given),
          knowledge(known),
          composites(parts),
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

    enum class Element { axiom, answer, composite };

    /// What explanations and corrections are about: selectors, the goal's negation being required.
    struct Question {
        std::vector<Selector> selectors;
        std::vector<std::pair<Element, std::size_t>> elements;  ///< what, and its index
        Solver solver;
    };

    [[nodiscard]] int goal_literal(const Iri& concept_iri, int region) {
        const int id = theory().find(concept_iri);
        if (id < 0) throw std::invalid_argument("explain: " + concept_iri + " is no concept");
        const Level level = theory().concepts[static_cast<std::size_t>(id)].level;
        if (level != Level::region && level != Level::composite) return literal(mesh.object, id);
        if (region >= 0) return literal(mesh.regions.at(static_cast<std::size_t>(region)), id);
        for (const Iri& each : level == Level::region ? mesh.regions : mesh.composites)
            if (const int candidate = literal(each, id);
                everything().solve(std::vector{-candidate}) == Verdict::unsatisfiable)
                return candidate;
        throw std::invalid_argument("explain: " + concept_iri + " does not follow from what is known");
    }

    [[nodiscard]] Question ask(const Iri& concept_iri, int region, bool axioms_are_given,
                               const std::vector<double>* costs) {
        std::vector<int> given;
        if (!concept_iri.empty()) given.push_back(-goal_literal(concept_iri, region));
        Question question{{}, {}, Solver(grounded.clauses())};
        const std::vector<int>& selectors = grounded.selectors();
        const std::size_t axioms = domain.ontology.axioms.size();
        std::map<std::size_t, std::size_t> composite_of;  // axioms that tell of one
        if (!axioms_are_given) composite_of.insert(mesh.told_composites.begin(), mesh.told_composites.end());
        const auto add = [&](Element element, std::size_t i, std::size_t index, double weight) {
            question.selectors.push_back({selectors[i], weight});
            question.elements.emplace_back(element, index);
        };
        for (std::size_t i = 0; i < selectors.size(); ++i) {
            if (i < axioms && !axioms_are_given)
                add(Element::axiom, i, i, 1);
            else if (i >= mesh.first_answer && i < mesh.first_answer + knowledge.answers.size())
                add(Element::answer, i, i - mesh.first_answer, costs ? (*costs)[i - mesh.first_answer] : 1);
            else if (const auto found = composite_of.find(i); found != composite_of.end())
                add(Element::composite, i, found->second, 1);
            else
                given.push_back(selectors[i]);
        }
        question.solver.require(given);
        return question;
    }

    [[nodiscard]] Explanation explanation(const Question& question, const SelectorSet& set) const {
        std::set<std::size_t> answers, axioms;
        for (const std::size_t i : set) {
            const auto [element, index] = question.elements[i];
            if (element == Element::composite)
                add_reasons(composites[index], answers, axioms);
            else
                (element == Element::answer ? answers : axioms).insert(index);
        }
        return {{answers.begin(), answers.end()}, {axioms.begin(), axioms.end()}, true};
    }

    [[nodiscard]] bool mentions_parts(FormulaId id) const {
        const Formula& formula = theory().formulas[static_cast<std::size_t>(id)];
        return formula.kind == Formula::Kind::parts ||
               std::ranges::any_of(formula.operands, [&](FormulaId operand) { return mentions_parts(operand); });
    }

    /// Why there is this composite part: what makes each region around it belong to its group or not, and the axioms
    /// that say what belongs.
    void add_reasons(const CompositePart& part, std::set<std::size_t>& answers, std::set<std::size_t>& axioms) const {
        std::set<int> around(part.regions.begin(), part.regions.end());
        for (const auto& [a, b] : knowledge.connected) {
            if (std::ranges::binary_search(part.regions, a)) around.insert(b);
            if (std::ranges::binary_search(part.regions, b)) around.insert(a);
        }
        const ConfigurationSet& members = domain.composites[static_cast<std::size_t>(part.group)].regions;
        for (const int region : around) {
            std::vector<std::size_t> kept;
            for (std::size_t i = 0; i < knowledge.answers.size(); ++i)
                if (knowledge.answers[i].region == region) kept.push_back(i);
            const auto is_told = [&] {
                ConfigurationSet set = domain.regions.all();
                for (const std::size_t i : kept) {
                    const ConfigurationSet yes = yes_set(domain.regions, knowledge.answers[i].question);
                    if (knowledge.answers[i].yes)
                        set &= yes;
                    else
                        set -= yes;
                }
                return set.is_subset_of(members) || !set.intersects(members);
            };
            if (!is_told()) continue;  // made of composite parts itself, each of which has its reasons
            for (std::size_t k = kept.size(); k-- > 0;) {
                const std::size_t left_out = kept[k];
                kept.erase(kept.begin() + static_cast<std::ptrdiff_t>(k));
                if (!is_told()) kept.insert(kept.begin() + static_cast<std::ptrdiff_t>(k), left_out);
            }
            answers.insert(kept.begin(), kept.end());
        }
        for (const NamedConcept& named : theory().concepts)
            if (named.group == part.group && named.definition >= 0 && mentions_parts(named.definition))
                axioms.insert(named.axiom);
    }
};

MeshReasoner::MeshReasoner(const Domain& domain, const Knowledge& knowledge,
                           const std::vector<CompositePart>& composites)
    : state_(std::make_unique<State>(domain, knowledge, composites)) {}

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

Explanation MeshReasoner::explain(const Iri& concept_iri, int region) {
    State::Question question = state_->ask(concept_iri, region, false, nullptr);
    const std::optional<SelectorSet> set = minimal_conflict(question.solver, question.selectors);
    if (!set)
        throw std::invalid_argument("explain: " + (concept_iri.empty() ? std::string("a contradiction") : concept_iri) +
                                    " does not follow from what is known");
    return state_->explanation(question, *set);
}

Explanations MeshReasoner::explain_all(const Iri& concept_iri, int region, const ExplanationOptions& options) {
    State::Question question = state_->ask(concept_iri, region, false, nullptr);
    const RankedSets found = all_conflicts(question.solver, question.selectors, options).conflicts;
    Explanations result;
    result.is_complete = found.is_complete;
    for (const RankedSet& each : found.sets) {
        Explanation found_one = state_->explanation(question, each.set);
        if (std::ranges::find(result.sets, found_one) == result.sets.end()) result.sets.push_back(std::move(found_one));
    }
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
