/* The two strategies that the paper compares its expert system with (§5.2.3, Table 3). Both ask, of every region, one
 * `is a` for each elementary concept but the last of its range, which is deduced; of those asked the best score is
 * believed. They differ in where regions come from: `naive` runs the `find all` of every shape, so shapes need no `is
 * a` (where other ranges have a `find all`, too, those of the first range have cut all there is); `segment then
 * identify` takes the regions of a segmentation and asks for the shapes too. What a region's measures tell by
 * themselves is not asked (Session::is_measured). */

#include <algorithm>

#include "expert/session.h"

namespace partonomy {
namespace {

using knowledge::Question;
using knowledge::Space;
using knowledge::VariableKind;

/// Asks every value of a range but the last; learns the best one, or the last when none is likely.
void identify(Session& session, int region, int variable) {
    const Space& space = session.domain().regions;
    const int values = static_cast<int>(space.holds[static_cast<std::size_t>(variable)].size());
    std::vector<std::pair<Question, double>> scores;
    for (int i = 0; i + 1 < values; ++i)
        if (const auto score = session.ask_score(region, {variable, i})) scores.push_back({{variable, i}, *score});
    if (scores.empty()) return;
    const auto best = std::max_element(scores.begin(), scores.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    for (const auto& [question, score] : scores) {
        const bool yes = best->second >= 0.5 && question == best->first;
        session.learn(region, question, yes, yes ? score : std::max(0.5, 1 - score));
    }
}

/// The first range whose values can be found all over the mesh; -1: none.
int range_to_find(const Session& session) {
    const auto& variables = session.domain().regions.variables;
    for (int v = 0; v < static_cast<int>(variables.size()); ++v)
        for (int i = 0; i < static_cast<int>(variables[static_cast<std::size_t>(v)].values.size()); ++i)
            if (session.find_all_cost({v, i})) return v;
    return -1;
}

void identify_all(Session& session, int known_variable) {
    const auto& variables = session.domain().regions.variables;
    for (int region = 0; region < session.region_count(); ++region)
        for (int v = 0; v < static_cast<int>(variables.size()); ++v)
            if (variables[static_cast<std::size_t>(v)].kind == VariableKind::range && !session.is_measured(v) &&
                v != known_variable)
                identify(session, region, v);
}

}  // namespace

void run_naive(Session& session) {
    const int v = range_to_find(session);
    if (v >= 0)
        for (int i = 0;
             i < static_cast<int>(session.domain().regions.variables[static_cast<std::size_t>(v)].values.size()); ++i)
            if (session.find_all_cost({v, i})) session.find_all({v, i});
    session.adopt_rest();
    identify_all(session, v);
    name_by_relations(session, knowledge::SplitCriterion::gain_per_cost);
}

void run_segment_then_identify(Session& session) {
    session.adopt_rest();
    identify_all(session, -1);
    name_by_relations(session, knowledge::SplitCriterion::gain_per_cost);
}

}  // namespace partonomy
