/* The cut that the ontology finds likeliest (final_labelling.h): each cut is judged by a session of its own, which asks
 * all that its regions ask for. The questions of all of them are counted. */

#include "expert/likeliest_cut.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <set>

#include "expert/final_labelling.h"
#include "expert/naming.h"

namespace partonomy {
namespace {

using knowledge::Conclusions;
using knowledge::Domain;
using owl::Iri;

void run(Session& session, const AnnotateOptions& options) {
    switch (options.strategy) {
        case Strategy::expert:
            run_expert(session, options.criterion);
            break;
        case Strategy::naive:
            run_naive(session);
            break;
        case Strategy::segment_then_identify:
            run_segment_then_identify(session);
            break;
    }
    session.find_connections();
}

/// The least certain answer that a region's name rests on.
double fuzzy_membership(const Session& session, int region) {
    double least = 1;
    const std::vector<knowledge::Answer> answers = session.knowledge().answers;
    for (std::size_t i = 0; i < answers.size(); ++i)
        if (answers[i].region == region && !session.is_measured(answers[i].question.variable))
            least = std::min(least, session.answer_scores()[i]);
    return least;
}

/// What the ontology says of the regions of a cut, once a session has asked all it wanted.
Verdict verdict_of(const Session& session, const Cut& cut) {
    const Domain& domain = session.domain();
    const Conclusions known = conclude(domain, session.knowledge());
    std::map<std::int32_t, std::size_t> place;  // in the cut, by lowest triangle
    for (std::size_t i = 0; i < cut.size(); ++i) place[cut[i]->part.region.triangles.front()] = i;
    Verdict verdict;
    verdict.regions.resize(cut.size());
    for (int region = 0; region < session.region_count(); ++region) {
        const Naming naming = name_region(session, known.regions[static_cast<std::size_t>(region)]);
        const auto found = place.find(session.part(region).region.triangles.front());
        if (found == place.end()) continue;
        cut[found->second]->measurements.surroundings = session.measurements(region).surroundings;  // for the next cut
        const std::vector<Iri> names =
            naming.concepts.empty() ? names_of_whole(domain, known, region) : specific_first(domain, naming.concepts);
        if (names.empty()) continue;
        verdict.regions[found->second] = {owl::local_name(names.front()),
                                          naming.certainty * fuzzy_membership(session, region)};
    }
    verdict.is_consistent = !known.contradiction && known.diagnoses.empty();
    verdict.is_recognised = is_recognised(known);
    return verdict;
}

/// Counts of the questions that were asked of cuts that others were better than.
void add_questions(const Session& from, Session& to) {
    to.find_all_count += from.find_all_count;
    to.is_a_count += from.is_a_count;
    to.related_count += from.related_count;
    to.find_related_count += from.find_related_count;
    to.read_off_count += from.read_off_count;
}

/// Tells the trace which edits made the cut likelier.
void trace_edits(Session& session, const FinalLabelling& labelling, double ms) {
    TraceEntry entry;
    entry.kind = "FL";
    entry.region = "mesh";
    entry.question = "which cut is the likeliest";
    entry.answer = fmt::format("{} edit{} in {} trials", labelling.edits.size(), labelling.edits.size() == 1 ? "" : "s",
                               labelling.trials);
    entry.score = 1;
    entry.ms = ms;
    for (const Edit& edit : labelling.edits)
        for (int region = 0; region < session.region_count(); ++region)
            if (std::ranges::binary_search(session.part(region).region.triangles, edit.triangle))
                entry.inferred.push_back(fmt::format("part {} {}", region + 1, edit.what));
    session.trace.push_back(std::move(entry));
}

/// Whether the regions are the parts of the cut: a derived `find all` may have found surfaces inside of them.
bool has_regions_of(const Session& session, const Cut& cut) {
    std::set<std::pair<std::int32_t, std::size_t>> parts;  // by lowest triangle and size
    for (const auto& region : cut)
        parts.emplace(region->part.region.triangles.front(), region->part.region.triangles.size());
    for (int region = 0; region < session.region_count(); ++region) {
        const std::vector<std::int32_t>& triangles = session.part(region).region.triangles;
        if (!parts.contains({triangles.front(), triangles.size()})) return false;
    }
    return true;
}

}  // namespace

std::unique_ptr<Session> ask_about_likeliest(const Domain& domain, const Catalogue& catalogue, const Object& object,
                                             Cut& cut, const AnnotateOptions& options) {
    const auto asked = [&](const Cut& about) {
        auto session = std::make_unique<Session>(domain, catalogue, object, about);
        run(*session, options);
        return session;
    };
    std::unique_ptr<Session> session = asked(cut);
    if (!options.mend || options.strategy != Strategy::expert || !has_regions_of(*session, cut)) return session;
    const auto start = std::chrono::steady_clock::now();
    const auto judge = [&](const Cut& other) {
        const std::unique_ptr<Session> trial = asked(other);
        add_questions(*trial, *session);
        return verdict_of(*trial, other);
    };
    const auto labelling = find_final_labelling(object, cut, verdict_of(*session, cut), judge, options.threads);
    if (!labelling) return session;
    cut = labelling->cut;
    std::unique_ptr<Session> best = asked(cut);
    add_questions(*session, *best);
    trace_edits(*best, *labelling,
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    return best;
}

}  // namespace partonomy
