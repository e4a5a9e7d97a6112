/* The expert system of paper §3.3.2: walk the decision tree online, ask only what can still change something.
 *
 * 1. Cut. While a part of the mesh is uncut, the tree's next `find all` question is asked of it. When the remaining
 * values of the range can no longer be told apart by a `find all` (only Cube is left), the pieces of the rest are
 * regions with that value inferred. Where the ontology speaks of no shape, derived `find all`s cut out what is wanted.
 * 2. Name. Each region walks the tree by `is a` questions until every concept that the expert defined is decided.
 * 3. Relate. Names that hang on relations to other regions are asked for when those have their names, in rounds, as
 * long as a round brings an answer.
 * 4. Connect. Where the ontology has composite parts, it is found once which regions touch.
 * 5. Recognise. What the names leave open about the object (is its seat elongated?) is asked of the regions that decide
 * it, the question about the object first, then the cheapest question about a region that answers it.
 *
 * The tree is never built here: a node is the set of configurations that are still possible, and its question is chosen
 * when the walk gets there, which gives the same walk as the saved tree (tested). Cost: a few microseconds a question.
 */

#include <map>
#include <numeric>
#include <set>
#include <span>

#include "expert/session.h"

namespace partonomy {
namespace {

using knowledge::ConceptId;
using knowledge::Conclusions;
using knowledge::ConfigurationSet;
using knowledge::Planner;
using knowledge::PlanOptions;
using knowledge::Question;
using knowledge::Space;
using knowledge::SplitCriterion;

/// A planner for each region, over what was possible for it at first: what is read off a region leaves little of the
/// space. Regions of which the same was known share one.
class Planners {
public:
    Planners(const Session& session, PlanOptions options) : session_(session), options_(std::move(options)) {}

    /// `possible` only shrinks from one call to the next.
    const Planner& of(int region, const ConfigurationSet& possible) {
        const auto at = static_cast<std::size_t>(region);
        if (at >= of_region_.size()) of_region_.resize(at + 1);
        if (of_region_[at] == nullptr) {
            const Space& space = session_.domain().regions;
            const ConfigurationSet within = space.diagram ? space.all() : possible;
            auto found = planners_.find(within);
            if (found == planners_.end()) found = planners_.try_emplace(within, space, options_, within).first;
            of_region_[at] = &found->second;
        }
        return *of_region_[at];
    }

private:
    const Session& session_;
    PlanOptions options_;
    std::map<ConfigurationSet, Planner> planners_;
    std::vector<const Planner*> of_region_;
};

void cut(Session& session, SplitCriterion criterion) {
    PlanOptions plan;
    plan.criterion = criterion;
    plan.cost = [&](Question question) { return session.find_all_cost(question); };
    // Shapes cut the whole mesh into parts; a derived `find all` costs more and is only asked for what is wanted.
    if (!session.has_own_find_all()) plan.wanted = session.wanted();
    const Planner planner(session.domain().regions, plan);
    do {
        const auto question = planner.best(session.rest_possible());
        if (!question) break;
        session.find_all(*question);
    } while (session.has_rest());
    session.adopt_rest();
}

/// Asks on about a region of which a question cannot be answered: other names may not hang on it.
void name_without(Session& session, PlanOptions plan, int region, Question unanswered) {
    std::set<Question> in_vain{unanswered};
    plan.cost = [&in_vain, cost = plan.cost](Question question) {
        return in_vain.contains(question) ? std::nullopt : cost(question);
    };
    while (true) {
        const Space& space = session.domain().regions;
        const Planner planner(space, plan, space.diagram ? space.all() : session.possible(region));
        auto question = planner.best(session.possible(region));
        while (question && session.ask(region, *question)) question = planner.best(session.possible(region));
        if (!question) return;
        in_vain.insert(*question);
    }
}

void name(Session& session, SplitCriterion criterion) {
    PlanOptions plan;
    plan.criterion = criterion;
    for (const ConceptId c : session.wanted())  // names that hang on relations wait for those of other regions
        if (!session.domain().regions.concepts[static_cast<std::size_t>(c)].relational) plan.wanted.push_back(c);
    plan.cost = [&](Question question) -> std::optional<double> {
        const auto& variable = session.domain().regions.variables[static_cast<std::size_t>(question.variable)];
        return variable.kind == knowledge::VariableKind::relation ? std::nullopt : session.is_a_cost(question);
    };
    if (plan.wanted.empty() && !session.wanted().empty()) return;  // every name hangs on relations
    Planners planners(session, plan);
    for (int region = 0; region < session.region_count(); ++region)
        while (const auto question = planners.of(region, session.possible(region)).best(session.possible(region)))
            if (!session.ask(region, *question)) {
                name_without(session, plan, region, *question);
                break;
            }
}

/// What to ask of regions, and what was asked in vain.
struct Askable {
    explicit Askable(const Session& asked) : session(asked) {}
    const Session& session;
    int region = -1;  ///< the one in turn
    std::set<std::pair<int, Question>> put_off;
    [[nodiscard]] auto cost() const {
        return [this](Question question) -> std::optional<double> {
            if (put_off.contains({region, question})) return std::nullopt;
            return session.is_a_cost(question);
        };
    }
};

/// A region and a question that may decide whether the object has `variable` of its parts conditions.
std::optional<std::pair<int, Question>> question_for(Askable& askable, Planners& planners, const Conclusions& known,
                                                     int variable) {
    const Session& session = askable.session;
    const knowledge::Domain& domain = session.domain();
    const auto at = static_cast<std::size_t>(variable);
    const std::span<const ConfigurationSet> conditions = known.objects->variables[at].of_composites
                                                             ? std::span(domain.composite_conditions)
                                                             : std::span(domain.part_conditions).subspan(at, 1);
    for (int region = 0; region < session.region_count(); ++region)
        for (const ConfigurationSet& condition : conditions) {
            const ConfigurationSet& set = known.regions[static_cast<std::size_t>(region)];
            if (!set.intersects(condition) || set.is_subset_of(condition)) continue;
            askable.region = region;
            if (const auto question = planners.of(region, set).best_about(set, condition))
                return std::pair{region, *question};
        }
    return std::nullopt;
}

void recognise(Session& session, SplitCriterion criterion) {
    Askable askable(session);
    PlanOptions about_regions;
    about_regions.cost = askable.cost();
    Planners planners(session, about_regions);
    PlanOptions plan;
    plan.criterion = criterion;
    while (true) {
        const Conclusions known = conclude(session.domain(), session.knowledge());
        if (known.contradiction) return;
        const Space& objects = *known.objects;
        plan.wanted.resize(objects.concepts.size());
        std::iota(plan.wanted.begin(), plan.wanted.end(), 0);
        plan.cost = [&](Question question) -> std::optional<double> {
            if (!question_for(askable, planners, known, question.variable)) return std::nullopt;
            return 1.0;
        };
        const auto about_object = best_question(objects, known.object, plan);
        if (!about_object) return;
        const auto about_region = question_for(askable, planners, known, about_object->variable);
        if (!about_region) return;
        if (!session.ask(about_region->first, about_region->second)) askable.put_off.insert(*about_region);
    }
}

}  // namespace

void name_by_relations(Session& session, SplitCriterion criterion) {
    const Space& space = session.domain().regions;
    if (session.domain().relational.empty()) return;
    Askable askable(session);
    PlanOptions plan;
    plan.criterion = criterion;
    plan.cost = askable.cost();
    const Planner planner(space, plan);
    const auto next_question = [&]() -> std::optional<Question> {
        const ConfigurationSet& set = session.possible(askable.region);
        for (const ConceptId c : session.wanted()) {
            const ConfigurationSet& where = space.concepts[static_cast<std::size_t>(c)].where;
            if (!set.intersects(where) || set.is_subset_of(where)) continue;
            if (const auto question = planner.best_about(set, where)) return question;
        }
        return std::nullopt;
    };
    for (bool grown = true; grown;) {
        grown = false;
        askable.put_off.clear();
        for (askable.region = 0; askable.region < session.region_count(); ++askable.region)
            while (const auto question =
                       next_question()) {  // one of each region in turn: what others are is known then
                if (session.ask(askable.region, *question)) {
                    grown = true;
                    break;
                }
                askable.put_off.emplace(askable.region, *question);
            }
    }
}

void ask_what_objects_count(Session& session) {
    Askable askable(session);
    PlanOptions about_regions;
    about_regions.cost = askable.cost();
    Planners planners(session, about_regions);
    std::size_t variables = 0;
    for (std::size_t variable = 0; variable == 0 || variable < variables;) {
        const Conclusions known = conclude(session.domain(), session.knowledge());
        variables = known.objects->variables.size();
        if (known.contradiction || variables == 0) return;
        const auto question = question_for(askable, planners, known, static_cast<int>(variable));
        if (!question)
            ++variable;
        else if (!session.ask(question->first, question->second))
            askable.put_off.insert(*question);
    }
}

void ask_on(Session& session, SplitCriterion criterion) {
    name(session, criterion);
    name_by_relations(session, criterion);
    session.find_connections();
    recognise(session, criterion);
}

void run_expert(Session& session, SplitCriterion criterion) {
    cut(session, criterion);
    ask_on(session, criterion);
}

}  // namespace partonomy
