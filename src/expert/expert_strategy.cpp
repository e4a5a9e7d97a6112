/* The expert system of paper §3.3.2: walk the decision tree online, ask only what can still change something.
 *
 * 1. Cut. While a part of the mesh is uncut, the tree's next `find all` question is asked of it. When the remaining
 * values of the range can no longer be told apart by a `find all` (only Cube is left), the pieces of the rest are
 * regions with that value inferred.
 * 2. Name. Each region walks the tree by `is a` questions until every concept that the expert defined is decided.
 * 3. Connect. Where the ontology has composite parts, it is found once which regions touch.
 * 4. Recognise. What the names leave open about the object (is its seat elongated?) is asked of the regions that decide
 * it, the question about the object first, then the cheapest question about a region that answers it.
 *
 * The tree is never built here: a node is the set of configurations that are still possible, and its question is chosen
 * when the walk gets there, which gives the same walk as the saved tree (tested). Cost: a few microseconds a question.
 */

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

void cut(Session& session, SplitCriterion criterion) {
    PlanOptions plan;
    plan.criterion = criterion;
    plan.cost = [&](Question question) { return session.find_all_cost(question); };
    const Planner planner(session.domain().regions, plan);
    do {
        const auto question = planner.best(session.rest_possible());
        if (!question) break;
        session.find_all(*question);
    } while (session.has_rest());
    session.adopt_rest();
}

void name(Session& session, SplitCriterion criterion) {
    PlanOptions plan;
    plan.criterion = criterion;
    plan.wanted = session.wanted();
    plan.cost = [&](Question question) { return session.is_a_cost(question); };
    const Planner planner(session.domain().regions, plan);
    for (int region = 0; region < session.region_count(); ++region)
        while (const auto question = planner.best(session.possible(region)))
            if (!session.ask(region, *question)) break;
}

/// A region and a question that may decide whether the object has `variable` of its parts conditions.
std::optional<std::pair<int, Question>> question_for(const Session& session, const Planner& planner,
                                                     const Conclusions& known, int variable) {
    const knowledge::Domain& domain = session.domain();
    const auto at = static_cast<std::size_t>(variable);
    const std::span<const ConfigurationSet> conditions = domain.objects.variables[at].of_composites
                                                             ? std::span(domain.composite_conditions)
                                                             : std::span(domain.part_conditions).subspan(at, 1);
    for (int region = 0; region < session.region_count(); ++region)
        for (const ConfigurationSet& condition : conditions) {
            const ConfigurationSet& set = known.regions[static_cast<std::size_t>(region)];
            if (!set.intersects(condition) || set.is_subset_of(condition)) continue;
            if (const auto question = planner.best_about(set, condition)) return std::pair{region, *question};
        }
    return std::nullopt;
}

void recognise(Session& session, SplitCriterion criterion) {
    const Space& objects = session.domain().objects;
    PlanOptions about_regions;
    about_regions.cost = [&](Question question) { return session.is_a_cost(question); };
    const Planner planner(session.domain().regions, about_regions);
    PlanOptions plan;
    plan.criterion = criterion;
    for (ConceptId c = 0; c < static_cast<ConceptId>(objects.concepts.size()); ++c) plan.wanted.push_back(c);
    while (true) {
        const Conclusions known = conclude(session.domain(), session.knowledge());
        if (known.contradiction) return;
        plan.cost = [&](Question question) -> std::optional<double> {
            if (!question_for(session, planner, known, question.variable)) return std::nullopt;
            return 1.0;
        };
        const auto about_object = best_question(objects, known.object, plan);
        if (!about_object) return;
        const auto about_region = question_for(session, planner, known, about_object->variable);
        if (!about_region || !session.ask(about_region->first, about_region->second)) return;
    }
}

}  // namespace

void run_expert(Session& session, SplitCriterion criterion) {
    cut(session, criterion);
    name(session, criterion);
    session.find_connections();
    recognise(session, criterion);
}

}  // namespace partonomy
