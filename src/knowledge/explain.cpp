#include "knowledge/explain.h"

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <memory>
#include <set>
#include <stdexcept>

#include "knowledge/assembly.h"
#include "knowledge/correction_search.h"
#include "knowledge/mesh_world.h"
#include "knowledge/object_clauses.h"
#include "knowledge/object_test.h"
#include "knowledge/reasons.h"

// A minimal explanation by deletion: take one thing away; if the conclusion still follows, it was not needed. With
// consistent knowledge entailment only shrinks when things are taken away, hence what remains is minimal. Answers come
// first: with all axioms, whether the rest still suffices is told from what the goal counts, in microseconds
// (object_test.h). Each test of an axiom looks at the cone of the goal only, the concepts and features that the axioms
// still kept lead to; a class whose defining axiom is gone is free to hold or not. That makes many kinds of parts, so
// of an object one is looked for that is no such thing; where the kinds are too many to be tried, a solver with a
// selector for each axiom looks for it (reasons.cpp). In small spaces it would take longer than trying. Composite parts
// are always left to the solver.
//
// Corrections by best-first search: sets of answers by ascending cost, each turned round and concluded from, those left
// out that contain one found before. When that takes too many tries, or when the space is compiled, both are questions
// to a SAT solver instead (reasons.cpp).

namespace partonomy::knowledge {
namespace {

constexpr std::size_t no_limit = std::numeric_limits<std::size_t>::max();

/// Whether the goal follows from some of the axioms.
class Oracle {
public:
    Oracle(const Domain& domain, const Knowledge& knowledge, int goal)
        : theory_(domain.grounding->theory), domain_(domain), knowledge_(knowledge), goal_(goal) {}

    /// Whether the goal (a contradiction for -1) follows from the kept axioms and answers; the answers and `complete`
    /// are the same each time.
    [[nodiscard]] bool follows(const std::vector<char>& axioms, const std::vector<char>& answers, bool complete) {
        if (by_solver_) return by_solver_->follows(axioms);
        const Scope scope = cone(theory_, goal_, axioms, goal_ < 0);
        const Layer regions = build_regions(theory_, scope, domain_.grounding->options);
        const Told told = tell(regions, answers);
        const bool broken = std::ranges::any_of(told.sets, [](const auto& set) { return set.is_empty(); });
        if (goal_ < 0 && broken) return true;
        if (goal_ >= 0 && theory_.concepts[goal_].level == Level::region)
            return std::ranges::any_of(told.sets, [&](const auto& set) {
                return !set.is_empty() && set.is_subset_of(regions.concepts[goal_]);
            });
        const Assembly assembly = assemble(theory_, scope, regions, no_limit);
        const std::vector<int> goals(goal_ < 0 ? 0 : 1, goal_);
        const auto test = ObjectTest::within(theory_, scope, assembly.parts, goals);
        if (!test) {
            by_solver_ = std::make_unique<FromAxioms>(domain_, knowledge_, goal_, answers, complete);
            return by_solver_->follows(axioms);
        }
        std::vector<ObjectTest::Types> types_of_set, types;
        for (const ConfigurationSet& set : told.sets) types_of_set.push_back(test->types_of(set));
        for (const std::size_t set : told.set_of) types.push_back(types_of_set[set]);
        const ObjectTest::Outcome outcome = test->ask(std::move(types), complete);
        return goal_ < 0 ? !outcome.any : outcome.any && !outcome.other;
    }

private:
    /// What the answers that are kept leave of each region: mostly all that there is.
    struct Told {
        std::vector<ConfigurationSet> sets;
        std::vector<std::size_t> set_of;  ///< by region
    };
    [[nodiscard]] Told tell(const Layer& regions, const std::vector<char>& answers) const {
        std::vector<std::vector<std::array<int, 3>>> kept(static_cast<std::size_t>(knowledge_.region_count));
        for (std::size_t i = 0; i < answers.size(); ++i) {
            const Answer& answer = knowledge_.answers[i];
            const int variable = answers[i] ? variable_in(regions, answer.question.variable) : -1;
            if (variable >= 0) kept[answer.region].push_back({variable, answer.question.value, answer.yes ? 1 : 0});
        }
        Told told;
        std::map<std::vector<std::array<int, 3>>, std::size_t> known;
        for (const auto& each : kept) {
            const auto [found, is_new] = known.try_emplace(each, told.sets.size());
            told.set_of.push_back(found->second);
            if (!is_new) continue;
            ConfigurationSet& set = told.sets.emplace_back(regions.space.all());
            for (const auto& [variable, value, yes] : each)
                if (yes)
                    set &= yes_set(regions.space, {variable, value});
                else
                    set -= yes_set(regions.space, {variable, value});
        }
        return told;
    }
    /// The variable of the cone's layer that corresponds to one of the domain's.
    [[nodiscard]] int variable_in(const Layer& regions, VariableId variable) const {
        if (static_cast<std::size_t>(variable) < theory_.feature_count()) return regions.features[variable];
        return regions.primitives[theory_.find(domain_.regions.variables[variable].iri)];
    }

    const Theory& theory_;
    const Domain& domain_;
    const Knowledge& knowledge_;
    int goal_;
    std::unique_ptr<FromAxioms> by_solver_;  ///< from when on there are too many kinds of parts; answers stay the same
};

/// Classes of parts whose presence the formula asks for, without looking into the concepts that it names.
void wanted_parts(const Theory& theory, FormulaId id, bool positive, std::vector<FormulaId>& atoms) {
    const Formula& formula = theory.formulas[id];
    if (formula.kind == Formula::Kind::parts && positive) atoms.push_back(id);
    if (formula.kind == Formula::Kind::negation) positive = !positive;
    for (const FormulaId operand : formula.operands) wanted_parts(theory, operand, positive, atoms);
}

bool follows(const Space& space, const ConfigurationSet& set, const Iri& iri) {
    const std::optional<ConceptId> id = space.find(iri);
    return id && !set.is_empty() && set.is_subset_of(space.concepts[*id].where);
}

bool is_entailed(const Domain& domain, const Conclusions& conclusions, const Iri& concept_iri) {
    return follows(*conclusions.objects, conclusions.object, concept_iri) ||
           std::ranges::any_of(conclusions.composites,
                               [&](const CompositePart& composite) {
                                   return follows(domain.composites[static_cast<std::size_t>(composite.group)].space,
                                                  composite.possible, concept_iri);
                               }) ||
           std::ranges::any_of(conclusions.regions,
                               [&](const auto& set) { return follows(domain.regions, set, concept_iri); });
}

/// Whether the goal follows from all axioms and some of the answers.
class FromAnswers {
public:
    FromAnswers(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri, int goal)
        : domain_(domain), knowledge_(knowledge), iri_(concept_iri) {
        if (goal < 0 || domain.grounding->theory.concepts[goal].level == Level::object)
            test_ = ObjectTest::about(domain, goal < 0 ? std::vector<int>{} : std::vector{goal});
        for (const Answer& answer : knowledge.answers) {
            holds_.push_back(yes_set(domain.regions, answer.question));
            if (test_ && !answer.yes) holds_.back() = holds_.back().complement();
        }
        answers_of_.resize(static_cast<std::size_t>(knowledge.region_count));
        for (std::size_t i = 0; i < knowledge.answers.size(); ++i)
            answers_of_[knowledge.answers[i].region].push_back(i);
        last_.resize(answers_of_.size());
    }

    [[nodiscard]] bool follows(const std::vector<char>& answers, bool complete) {
        if (!test_) return concludes(answers, complete);
        std::vector<ObjectTest::Types> types;
        for (std::size_t r = 0; r < answers_of_.size(); ++r) {
            const Region& region = look_at(r, answers);
            if (iri_.empty() && region.is_empty) return true;
            types.push_back(region.types);
        }
        const ObjectTest::Outcome outcome = test_->ask(std::move(types), complete);
        return iri_.empty() ? !outcome.any : outcome.any && !outcome.other;
    }

private:
    struct Region {
        std::optional<std::vector<char>> kept;  ///< of its answers
        ObjectTest::Types types = 0;
        bool is_empty = false;
    };
    /// Only computed when other answers are kept than last time.
    const Region& look_at(std::size_t r, const std::vector<char>& answers) {
        std::vector<char> kept;
        for (const std::size_t i : answers_of_[r]) kept.push_back(answers[i]);
        Region& region = last_[r];
        if (region.kept == kept) return region;
        ConfigurationSet set = domain_.regions.all();
        for (const std::size_t i : answers_of_[r])
            if (answers[i]) set &= holds_[i];
        region = {std::move(kept), test_->types_of(set), set.is_empty()};
        return region;
    }
    [[nodiscard]] bool concludes(const std::vector<char>& answers, bool complete) const {
        Knowledge some = knowledge_;
        some.complete = complete;
        some.answers.clear();
        for (std::size_t i = 0; i < answers.size(); ++i)
            if (answers[i]) some.answers.push_back(knowledge_.answers[i]);
        const Conclusions what = conclude(domain_, some);
        return iri_.empty() ? what.contradiction : is_entailed(domain_, what, iri_);
    }

    const Domain& domain_;
    const Knowledge& knowledge_;
    const Iri& iri_;
    std::optional<ObjectTest> test_;
    std::vector<ConfigurationSet> holds_;               ///< by answer
    std::vector<std::vector<std::size_t>> answers_of_;  ///< by region
    std::vector<Region> last_;                          ///< by region
};

/// Leaves out those of `candidates` that can be left out of `kept`: all of them when `still_follows` then, else by
/// halves. Whatever can go together can go one by one, so the rest is what leaving out one after the other leaves.
template <typename Follows>
void shrink(std::vector<char>& kept, std::span<const std::size_t> candidates, const Follows& still_follows) {
    if (candidates.empty()) return;
    for (const std::size_t i : candidates) kept[i] = 0;
    if (still_follows()) return;
    for (const std::size_t i : candidates) kept[i] = 1;
    if (candidates.size() == 1) return;
    const std::size_t half = (candidates.size() + 1) / 2;
    shrink(kept, candidates.first(half), still_follows);
    shrink(kept, candidates.subspan(half), still_follows);
}

std::vector<std::size_t> places(const std::vector<char>& kept) {
    std::vector<std::size_t> result;
    for (std::size_t i = 0; i < kept.size(); ++i)
        if (kept[i]) result.push_back(i);
    return result;
}

/// Conclusions from a listed space take microseconds; from a compiled one the solver is faster.
bool prefers_solver(const Domain& domain, const Knowledge& knowledge) {
    return domain.regions.diagram != nullptr && (knowledge.complete || domain.grounding->theory.groups.empty());
}

/// Whether a concept of one region is asked about in a compiled space: what is known of the other regions says nothing
/// then, and the solver is asked even where objects are more than it can express.
bool is_about_one_region(const Domain& domain, const Iri& concept_iri, int region) {
    return region >= 0 && domain.regions.diagram != nullptr && domain.regions.find(concept_iri).has_value();
}

/// What is known of one region, as if it were the only one.
struct Excerpt {
    Excerpt(const Knowledge& all, int region) : knowledge{1, all.complete, {}, {}} {
        for (std::size_t i = 0; i < all.answers.size(); ++i)
            if (all.answers[i].region == region) {
                knowledge.answers.push_back({0, all.answers[i].question, all.answers[i].yes});
                places.push_back(i);
            }
    }
    [[nodiscard]] std::vector<std::size_t> in_all(std::vector<std::size_t> answers) const {
        for (std::size_t& i : answers) i = places[i];
        return answers;
    }
    Knowledge knowledge;
    std::vector<std::size_t> places;  ///< of its answers
};

/// Whether the concept (a contradiction when empty) holds of the object or a part, or of `region` when it is about
/// that.
bool is_concluded(const Domain& domain, const Conclusions& conclusions, const Iri& concept_iri, int region) {
    if (concept_iri.empty()) return conclusions.contradiction;
    if (region >= 0 && domain.regions.find(concept_iri))
        return follows(domain.regions, conclusions.regions.at(static_cast<std::size_t>(region)), concept_iri);
    return is_entailed(domain, conclusions, concept_iri);
}

/// Whether turning these answers round leaves the concept as it is.
bool still_holds(const Domain& domain, Knowledge knowledge, const Iri& concept_iri, int region,
                 const std::vector<std::size_t>& answers) {
    for (const std::size_t i : answers) knowledge.answers[i].yes = !knowledge.answers[i].yes;
    return is_concluded(domain, conclude(domain, knowledge), concept_iri, region);
}

/// The closed world of the mesh, where configuration spaces do not tell why; nullptr where they do. Composite parts are
/// better explained by spaces, to which they are no given facts, as long as the conclusion is drawn there.
std::unique_ptr<MeshReasoner> world_of(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri,
                                       int region, bool to_explain) {
    if (!needs_mesh_world(domain, knowledge)) return nullptr;
    if (!domain.grounding->assembly.has_composites()) return std::make_unique<MeshReasoner>(domain, knowledge);
    if (is_concluded(domain, conclude_by_spaces(domain, knowledge), concept_iri, region)) return nullptr;
    return std::make_unique<MeshReasoner>(domain, knowledge, *certain_composites(domain, knowledge), to_explain);
}

}  // namespace

std::vector<char> defining_axioms(const Theory& theory, int goal, std::size_t axiom_count) {
    std::vector<char> definitions(axiom_count, 0), axioms(axiom_count, 0);
    for (const NamedConcept& named : theory.concepts)
        if (named.definition >= 0) definitions[named.axiom] = 1;
    for (const Constraint& constraint : theory.constraints) definitions[constraint.axiom] = 0;
    const Scope scope = cone(theory, goal, definitions, false);
    for (std::size_t id = 0; id < theory.concepts.size(); ++id)
        if (scope.concepts[id] && theory.concepts[id].definition >= 0) axioms[theory.concepts[id].axiom] = 1;
    return axioms;
}

Explanation explain(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri, int region_asked,
                    const ExplanationOptions& options) {
    if (auto world = world_of(domain, knowledge, concept_iri, region_asked, true))
        return world->explain(concept_iri, region_asked, options.steps);
    if (is_about_one_region(domain, concept_iri, region_asked)) {
        const Excerpt excerpt(knowledge, region_asked);
        Explanation explanation = one_reason(domain, excerpt.knowledge, concept_iri, 0, options.steps);
        explanation.answers = excerpt.in_all(std::move(explanation.answers));
        return explanation;
    }
    if (prefers_solver(domain, knowledge))
        return one_reason(domain, knowledge, concept_iri, region_asked, options.steps);
    const Conclusions conclusions = conclude_by_spaces(domain, knowledge);
    if (conclusions.objects->diagram || domain.grounding->assembly.has_composites())
        return one_reason(domain, knowledge, concept_iri, region_asked, options.steps);
    const Theory& theory = domain.grounding->theory;
    const auto refuse = [&] {
        throw std::invalid_argument("explain: " + (concept_iri.empty() ? std::string("a contradiction") : concept_iri) +
                                    " does not follow from what is known");
    };
    if (concept_iri.empty() ? !conclusions.contradiction : !is_entailed(domain, conclusions, concept_iri)) refuse();
    const int goal = concept_iri.empty() ? -1 : theory.find(concept_iri);
    std::vector<char> answers(knowledge.answers.size(), 1), axioms(domain.ontology.axioms.size(), 0);
    bool complete = knowledge.complete;
    const auto keep_regions = [&](const auto& is_kept) {
        for (std::size_t i = 0; i < answers.size(); ++i)
            if (!is_kept(knowledge.answers[i].region)) answers[i] = 0;
    };
    if (goal >= 0)  // a region that contradicts itself tells nothing
        keep_regions([&](int region) { return !conclusions.regions[region].is_empty(); });
    if (goal >= 0 && theory.concepts[goal].level == Level::region) {
        const auto is_one = [&](int region) {
            return follows(domain.regions, conclusions.regions[region], concept_iri);
        };
        for (int region = 0; region_asked < 0; ++region)
            if (is_one(region)) region_asked = region;
        if (region_asked >= knowledge.region_count || !is_one(region_asked)) refuse();
        keep_regions([&](int region) { return region == region_asked; });
    }

    FromAnswers from(domain, knowledge, concept_iri, goal);
    if (complete) complete = !from.follows(answers, false);
    shrink(answers, places(answers), [&] { return from.follows(answers, complete); });

    Oracle oracle(domain, knowledge, goal);
    const auto still_follows = [&] { return oracle.follows(axioms, answers, complete); };
    axioms = defining_axioms(theory, goal, axioms.size());
    if (still_follows()) {
        for (const std::size_t axiom : places(axioms)) shrink(axioms, std::span(&axiom, 1), still_follows);
    } else {
        for (const NamedConcept& named : theory.concepts)
            if (named.definition >= 0) axioms[named.axiom] = 1;
        for (const Constraint& constraint : theory.constraints) axioms[constraint.axiom] = 1;
        shrink(axioms, places(axioms), still_follows);
    }

    return {places(answers), places(axioms), complete};
}

std::vector<int> culprits(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri) {
    const Conclusions conclusions = conclude(domain, knowledge);
    const Theory& theory = domain.grounding->theory;
    const Parts& parts = domain.grounding->assembly.parts;
    const auto members = [&](const ConfigurationSet& where) {
        std::vector<int> regions;
        for (std::size_t r = 0; r < conclusions.regions.size(); ++r)
            if (!conclusions.regions[r].is_empty() && conclusions.regions[r].is_subset_of(where))
                regions.push_back(static_cast<int>(r));
        return regions;
    };
    if (const std::optional<ConceptId> id = domain.regions.find(concept_iri))
        return members(domain.regions.concepts[*id].where);
    std::set<int> blamed;
    const auto blame_composites = [&](unsigned threshold, const auto& where_in_group) {
        std::vector<int> regions;
        unsigned count = 0;
        for (const CompositePart& composite : conclusions.composites) {
            const ConfigurationSet where = where_in_group(static_cast<std::size_t>(composite.group));
            if (where.size() == 0 || composite.possible.is_empty() || !composite.possible.is_subset_of(where)) continue;
            std::ranges::copy(composite.regions, std::back_inserter(regions));
            ++count;
        }
        if (count >= threshold) blamed.insert(regions.begin(), regions.end());
    };
    const int id = theory.find(concept_iri);
    if (id >= 0 && theory.concepts[id].level == Level::composite)
        blame_composites(1, [&](std::size_t group) {
            const Space& space = domain.composites[group].space;
            const std::optional<ConceptId> found = space.find(concept_iri);
            return found ? space.concepts[*found].where : ConfigurationSet();
        });
    if (id < 0 || theory.concepts[id].level != Level::object || theory.concepts[id].definition < 0)
        return {blamed.begin(), blamed.end()};
    std::vector<FormulaId> atoms;
    wanted_parts(theory, theory.concepts[id].definition, true, atoms);
    for (const FormulaId formula : atoms) {
        if (parts.atom_of[formula] < 0) continue;
        const Parts::Atom& atom = parts.atoms[parts.atom_of[formula]];
        const Parts::PartClass& part = parts.classes[atom.part];
        const std::vector<int> regions = members(part.where);
        if (part.composites.empty() && regions.size() >= atom.threshold) blamed.insert(regions.begin(), regions.end());
        blame_composites(atom.threshold, [&](std::size_t group) {
            return group < part.composites.size() ? part.composites[group] : ConfigurationSet();
        });
    }
    return {blamed.begin(), blamed.end()};
}

Explanations all_explanations(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri, int region,
                              const ExplanationOptions& options) {
    if (auto world = world_of(domain, knowledge, concept_iri, region, true))
        return world->explain_all(concept_iri, region, options);
    return all_reasons(domain, knowledge, concept_iri, region, options);
}

std::vector<Correction> corrections(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri,
                                    const std::vector<double>& costs, int region, const ExplanationOptions& options) {
    if (costs.size() != knowledge.answers.size()) throw std::invalid_argument("corrections: one cost for each answer");
    if (std::ranges::any_of(costs, [](double cost) { return !(cost >= 0); }))
        throw std::invalid_argument("corrections: a cost should not be negative");
    if (auto world = world_of(domain, knowledge, concept_iri, region, false)) {
        std::vector<Correction> found = world->correct(concept_iri, costs, region, options);
        if (domain.grounding->assembly.has_composites())  // which may be others after the change
            std::erase_if(found, [&](const Correction& each) {
                return still_holds(domain, knowledge, concept_iri, region, each.answers);
            });
        return found;
    }
    if (is_about_one_region(domain, concept_iri, region)) {
        const Excerpt excerpt(knowledge, region);
        std::vector<double> its_costs;
        for (const std::size_t i : excerpt.places) its_costs.push_back(costs[i]);
        std::vector<Correction> found = cheapest_changes(domain, excerpt.knowledge, concept_iri, its_costs, 0, options);
        for (Correction& each : found) each.answers = excerpt.in_all(std::move(each.answers));
        return found;
    }
    if (prefers_solver(domain, knowledge))
        return cheapest_changes(domain, knowledge, concept_iri, costs, region, options);
    if (conclude_by_spaces(domain, knowledge).objects->diagram)
        return cheapest_changes(domain, knowledge, concept_iri, costs, region, options);
    if (domain.regions.diagram != nullptr) return {};  // sets of a compiled space cannot be tried one by one
    CorrectionSearch search(domain, knowledge, concept_iri, costs, region);
    std::vector<Correction> found = search.run(options.limit);
    if (found.empty() && search.is_cut_short())
        return cheapest_changes(domain, knowledge, concept_iri, costs, region, options);
    return found;
}

}  // namespace partonomy::knowledge
