/* From questions to an annotation: asks by one of the strategies, then decides what every part is called.
 *
 * A part is called by the most specific concept that is entailed for it. Where a question that would decide cannot be
 * answered (no unit, no algorithm), several names stay possible: then the part gets the name that holds in most of the
 * configurations that are left, its score is that fraction of the shape's, and the annotation lists the assumption
 * among its open questions. A part for which nothing can hold stays unnamed. What is incompatible only if such an
 * assumption is right is no class and no diagnosis: it is told as "perhaps". A part that is nothing but a helper is
 * called by the smallest composite part that it belongs to.
 *
 * Score of a part: mean fitting score of its triangles times the `is a` score of its shape (paper §6.4). Score of the
 * object: mean of its parts' scores by area. */

#include "expert/annotate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>

#include "base/errors.h"
#include "expert/accepted_answers.h"
#include "expert/nearest_name.h"
#include "expert/open_questions.h"
#include "knowledge/near_miss.h"

namespace partonomy {
namespace {

using knowledge::ConceptId;
using knowledge::Conclusions;
using knowledge::ConfigurationSet;
using knowledge::Domain;
using knowledge::Space;
using owl::Iri;

/// The value of core:`name` at a concept; empty when it has none.
std::string annotation_of(const Domain& domain, const Iri& iri, const char* name) {
    const auto found = domain.ontology.annotations.find(iri);
    if (found == domain.ontology.annotations.end()) return {};
    for (const owl::Annotation& annotation : found->second)
        if (annotation.property == std::string(owl::core_prefix) + name) return annotation.literal.value;
    return {};
}

/// Whether a concept only serves to define others.
bool is_helper(const Domain& domain, const Iri& iri) { return annotation_of(domain, iri, "helper") == "true"; }

Naming name_region(const Session& session, const ConfigurationSet& possible) {
    const Space& space = session.domain().regions;
    Naming naming;
    if (possible.is_empty()) return naming;  // of a contradiction everything follows
    for (const ConceptId c : session.wanted())
        if (const auto& concept_ = space.concepts[static_cast<std::size_t>(c)];
            possible.is_subset_of(concept_.where) && !is_helper(session.domain(), concept_.iri))
            naming.concepts.push_back(concept_.iri);
    if (!naming.concepts.empty()) return naming;
    double most = 0;
    for (const ConceptId c : session.wanted()) {
        const auto& concept_ = space.concepts[static_cast<std::size_t>(c)];
        if (concept_.incompatible || is_helper(session.domain(), concept_.iri)) continue;
        if (const double share = possible.share(concept_.where); share > most) {
            most = share;
            naming.concepts = {concept_.iri};
        }
    }
    if (most > 0) naming.certainty = most;
    return naming;
}

std::vector<std::string> local_names(const std::vector<Iri>& iris) {
    std::vector<std::string> names;
    for (const Iri& iri : iris) names.push_back(owl::local_name(iri));
    return names;
}

/// Most specific first, the others after them.
std::vector<Iri> specific_first(const Domain& domain, const std::vector<Iri>& iris) {
    std::vector<Iri> sorted = domain.most_specific(iris);
    for (const Iri& iri : iris)
        if (std::find(sorted.begin(), sorted.end(), iri) == sorted.end()) sorted.push_back(iri);
    return sorted;
}

/// Local names of the most specific that are no diagnoses.
std::vector<std::string> names_among(const Domain& domain, const Space& space, std::vector<Iri> iris) {
    std::erase_if(
        iris, [&](const Iri& iri) { return space.concepts[static_cast<std::size_t>(*space.find(iri))].incompatible; });
    return local_names(domain.most_specific(iris));
}

AnnotatedPart make_part(const Session& session, int region, const ConfigurationSet& possible, const Naming& naming) {
    const Domain& domain = session.domain();
    AnnotatedPart part;
    part.id = region + 1;
    std::vector<Iri> concepts = specific_first(domain, naming.concepts);
    std::ranges::stable_partition(
        concepts, [&](const Iri& iri) {  // a part is called by what it is, then by what is wrong
            return !domain.regions.concepts[static_cast<std::size_t>(*domain.regions.find(iri))].incompatible;
        });
    part.concepts = local_names(concepts);
    part.names = names_among(domain, domain.regions, naming.concepts);
    part.triangles = session.part(region).region.triangles;
    part.score = session.part(region).fit * session.shape_score(region) * naming.certainty;
    for (std::size_t v = 0; v < domain.regions.variables.size(); ++v) {
        const knowledge::Variable& variable = domain.regions.variables[v];
        if (variable.kind != knowledge::VariableKind::range) continue;
        for (std::size_t i = 0; i < variable.values.size(); ++i)
            if (possible.is_subset_of(domain.regions.holds[v][i]))
                part.features[owl::local_name(variable.iri)] = variable.values[i];
    }
    const RegionMeasurements& measured = session.measurements(region);
    for (const Measure& measure : all_measures())
        if (measure.effort == Effort::at_once || (measure.effort == Effort::rays && measured.surroundings))
            if (const auto value = evaluate(measure, session.object(), measured))
                part.measurements[measure.name] = *value;
    part.measurements.insert(measured.asked.begin(), measured.asked.end());
    const double metres = session.object().placement.metres_per_unit.value_or(1);
    part.area = measured.area * metres * metres;
    if (!concepts.empty()) part.color = annotation_of(domain, concepts.front(), "color");
    return part;
}

/// Labels, part ids and scores of the input faces: of the part that holds most of the face's area.
void label_faces(const Object& object, Annotation& annotation) {
    const TriangleMesh& mesh = object.mesh;
    const auto faces = static_cast<std::size_t>(mesh.input_face_count);
    annotation.labels.assign(faces, "-");
    annotation.part_of_face.assign(faces, 0);
    annotation.score_of_face.assign(faces, 0);
    std::map<std::pair<std::int32_t, int>, double>
        shares;  // (input face, part index) -> area; only where a face was cut up
    std::vector<int> first(faces, -2);
    std::vector<bool> is_mixed(faces, false);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto face = static_cast<std::size_t>(mesh.input_faces[t]);
        const int part = annotation.part_of_triangle[t];
        if (first[face] == -2)
            first[face] = part;
        else if (first[face] != part)
            is_mixed[face] = true;
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (is_mixed[static_cast<std::size_t>(mesh.input_faces[t])])
            shares[{mesh.input_faces[t], annotation.part_of_triangle[t]}] += object.geometry.areas[t];
    std::vector<double> largest(faces, -1);
    for (const auto& [key, area] : shares)
        if (area > largest[static_cast<std::size_t>(key.first)]) {
            largest[static_cast<std::size_t>(key.first)] = area;
            first[static_cast<std::size_t>(key.first)] = key.second;
        }
    for (const auto& [face, earlier] : mesh.repeated_faces)
        if (first[static_cast<std::size_t>(face)] == -2)
            first[static_cast<std::size_t>(face)] = first[static_cast<std::size_t>(earlier)];
    for (std::size_t face = 0; face < faces; ++face) {
        if (first[face] < 0) continue;
        AnnotatedPart& part = annotation.parts[static_cast<std::size_t>(first[face])];
        annotation.labels[face] = part.concepts.empty() ? "-" : part.concepts.front();
        annotation.part_of_face[face] = part.id;
        annotation.score_of_face[face] = static_cast<float>(part.score);
        ++part.faces;
    }
}

std::vector<LearnedAnswer> learned_answers(Session& session, const knowledge::Knowledge& knowledge) {
    std::vector<LearnedAnswer> answers;
    for (std::size_t i = 0; i < knowledge.answers.size(); ++i) {
        const knowledge::Answer& answer = knowledge.answers[i];
        const knowledge::Variable& variable =
            session.domain().regions.variables[static_cast<std::size_t>(answer.question.variable)];
        answers.push_back({answer.region + 1, feature_name(variable),
                           variable.values[static_cast<std::size_t>(answer.question.value)], answer.yes,
                           session.answer_scores()[i], session.is_accepted(answer)});
        if (session.is_told_in_numbers()) answers.back().measured = session.in_numbers(answer);
    }
    return answers;
}

/// Tells of each part without a name which one it came nearest to, and what refuses it.
void tell_nearest_names(const Session& session, const knowledge::Knowledge& knowledge, Annotation& annotation) {
    if (!session.is_told_in_numbers()) return;
    const Domain& domain = session.domain();
    std::vector<Iri> names;
    for (const ConceptId c : session.wanted())
        if (const auto& concept_ = domain.regions.concepts[static_cast<std::size_t>(c)];
            !concept_.incompatible && !is_helper(domain, concept_.iri) && !concept_.where.is_empty())
            names.push_back(concept_.iri);
    for (AnnotatedPart& part : annotation.parts) {
        if (!part.concepts.empty()) continue;
        const auto nearest = nearest_name(session, knowledge, part.id - 1, names);
        if (!nearest) continue;
        part.nearest = owl::local_name(nearest->iri);
        for (const std::size_t i : nearest->refused_by)
            part.refusals.push_back(what_was_answered(domain, knowledge.answers[i], annotation.answers[i]));
    }
}

/// What follows when assumed names count as known; what is known alone where that contradicts the axioms.
Conclusions conclude_with_assumptions(const Session& session, const knowledge::Knowledge& knowledge,
                                      const Conclusions& known, const std::vector<Naming>& namings) {
    Conclusions assumed = conclude_assuming(session.domain(), knowledge, known, namings);
    return assumed.contradiction ? known : assumed;
}

/// What is incompatible under the names that are assumed, and not without them: the object, then composite parts.
std::vector<Iri> perhaps_incompatible(const Conclusions& known, const Conclusions& assumed) {
    std::vector<Iri> perhaps;
    std::ranges::set_difference(assumed.diagnoses, known.diagnoses, std::back_inserter(perhaps));
    std::erase_if(perhaps, [](const Iri& iri) { return iri.starts_with(owl::core_prefix); });
    return perhaps;
}

/// The composite parts, those of which no concept is known left out.
std::vector<AnnotatedComposite> composite_parts(const Session& session, const Conclusions& known,
                                                const std::vector<Iri>& perhaps) {
    const Domain& domain = session.domain();
    std::vector<AnnotatedComposite> composites;
    std::vector<const knowledge::CompositePart*> kept;
    for (const knowledge::CompositePart& part : known.composites) {
        const Space& space = domain.composites[static_cast<std::size_t>(part.group)].space;
        std::vector<Iri> names;
        for (const ConceptId c : entailed(space, part.possible)) {
            const Iri& iri = space.concepts[static_cast<std::size_t>(c)].iri;
            if (!iri.starts_with(owl::core_prefix) && std::ranges::find(perhaps, iri) == perhaps.end())
                names.push_back(iri);
        }
        if (names.empty()) continue;
        AnnotatedComposite& composite = composites.emplace_back();
        composite.id = static_cast<int>(composites.size());
        composite.concepts = local_names(specific_first(domain, names));
        composite.names = names_among(domain, space, names);
        for (const int region : part.regions) composite.parts.push_back(region + 1);
        for (std::size_t k = 0; k < kept.size(); ++k)
            if (kept[k]->group < part.group && std::ranges::includes(part.regions, kept[k]->regions))
                composite.composites.push_back(static_cast<int>(k) + 1);
        kept.push_back(&part);
    }
    return composites;
}

/// What a region of which only helpers hold is called by: the most specific concepts of the smallest composite part
/// that it belongs to; empty where it belongs to none.
std::vector<Iri> names_of_whole(const Domain& domain, const Conclusions& known, int region) {
    const knowledge::CompositePart* smallest = nullptr;
    std::vector<Iri> names;
    for (const knowledge::CompositePart& part : known.composites) {
        if (!std::ranges::binary_search(part.regions, region)) continue;
        if (smallest && part.regions.size() >= smallest->regions.size()) continue;
        const Space& space = domain.composites[static_cast<std::size_t>(part.group)].space;
        std::vector<Iri> found;
        for (const ConceptId c : entailed(space, part.possible)) {
            const knowledge::Concept& concept_ = space.concepts[static_cast<std::size_t>(c)];
            if (!concept_.incompatible && !concept_.iri.starts_with(owl::core_prefix) &&
                !is_helper(domain, concept_.iri))
                found.push_back(concept_.iri);
        }
        if (found.empty()) continue;
        smallest = &part;
        names = domain.most_specific(found);
    }
    return names;
}

/// Calls parts without a name of their own by the whole that they belong to.
void name_by_wholes(const Domain& domain, const Conclusions& known, Annotation& annotation) {
    for (AnnotatedPart& part : annotation.parts) {
        if (!part.concepts.empty()) continue;
        const std::vector<Iri> names = names_of_whole(domain, known, part.id - 1);
        if (names.empty()) continue;
        part.concepts = part.names = local_names(names);
        part.color = annotation_of(domain, names.front(), "color");
        part.is_piece = true;
    }
}

/// Mean of the scores of the parts by area, those without a name counting 0.
double score_of(const Annotation& annotation) {
    double area = 0, scored_area = 0;
    for (const AnnotatedPart& part : annotation.parts) {
        area += part.area;
        if (!part.concepts.empty()) scored_area += part.area * part.score;
    }
    return area > 0 ? scored_area / area : 0;
}

/// What an object comes nearest to, unless it is something that is no diagnosis.
std::vector<NearClass> nearest_classes(const Domain& domain, const Conclusions& assumed,
                                       const std::vector<Iri>& classes) {
    constexpr std::size_t most = 3;
    std::vector<NearClass> nearest;
    const knowledge::Space& objects = *assumed.objects;
    if (assumed.contradiction || std::ranges::any_of(classes, [&](const Iri& iri) {
            return !objects.concepts[static_cast<std::size_t>(*objects.find(iri))].incompatible;
        }))
        return nearest;
    std::vector<Iri> helpers;
    for (const knowledge::Concept& concept_ : objects.concepts)
        if (is_helper(domain, concept_.iri)) helpers.push_back(concept_.iri);
    for (knowledge::NearMiss& miss : near_misses(domain, assumed, helpers)) {
        if (nearest.size() == most) break;
        nearest.push_back({owl::local_name(miss.iri), std::move(miss.lacks), std::move(miss.too_many)});
    }
    return nearest;
}

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
    verdict.is_recognised = std::ranges::any_of(entailed(*known.objects, known.object), [&](ConceptId c) {
        const auto& concept_ = known.objects->concepts[static_cast<std::size_t>(c)];
        return !concept_.incompatible && !concept_.iri.starts_with(owl::core_prefix);
    });
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

/// The session of the likeliest cut, after all questions; `cut` becomes that one.
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

}  // namespace

Strategy parse_strategy(const std::string& word) {
    if (word == "expert") return Strategy::expert;
    if (word == "naive") return Strategy::naive;
    if (word == "segment-then-identify") return Strategy::segment_then_identify;
    throw UsageError("--strategy " + word + ": unknown strategy, use expert, naive or segment-then-identify");
}

knowledge::SplitCriterion parse_criterion(const std::string& word) {
    if (word == "dichotomy") return knowledge::SplitCriterion::dichotomy;
    if (word == "entropy") return knowledge::SplitCriterion::entropy;
    if (word == "gain-per-cost") return knowledge::SplitCriterion::gain_per_cost;
    throw UsageError("--criterion " + word + ": unknown criterion, use dichotomy, entropy or gain-per-cost");
}

Annotation annotate(const Domain& domain, const Catalogue& catalogue, const Object& object,
                    const AnnotateOptions& options) {
    const auto start = std::chrono::steady_clock::now();
    Cut cut = cut_of(object);
    const std::unique_ptr<Session> likeliest = ask_about_likeliest(domain, catalogue, object, cut, options);
    Session& session = *likeliest;
    if (!options.accepted.empty()) {
        accept_answers(session, options.accepted, options.accepted_source);
        if (options.strategy == Strategy::expert) ask_on(session, options.criterion);
        session.find_connections();
    }

    const knowledge::Knowledge knowledge = session.knowledge();
    const Conclusions known = conclude(domain, knowledge);
    std::vector<Naming> namings;
    Annotation annotation;
    annotation.part_of_triangle.assign(object.mesh.triangles.size(), -1);
    for (int region = 0; region < session.region_count(); ++region) {
        const ConfigurationSet& possible = known.regions[static_cast<std::size_t>(region)];
        namings.push_back(name_region(session, possible));
        annotation.parts.push_back(make_part(session, region, possible, namings.back()));
        for (const int t : annotation.parts.back().triangles)
            annotation.part_of_triangle[static_cast<std::size_t>(t)] = region;
    }
    const Conclusions assumed = conclude_with_assumptions(session, knowledge, known, namings);
    const std::vector<Iri> perhaps = perhaps_incompatible(known, assumed);
    annotation.perhaps = local_names(perhaps);
    name_by_wholes(domain, assumed, annotation);
    annotation.score = score_of(annotation);
    label_faces(object, annotation);
    annotation.composites = composite_parts(session, assumed, perhaps);
    std::vector<Iri> classes;
    for (const ConceptId c : entailed(*assumed.objects, assumed.object)) {
        const Iri& iri = assumed.objects->concepts[static_cast<std::size_t>(c)].iri;
        const bool is_told = !iri.starts_with(owl::core_prefix) && !is_helper(domain, iri);
        if (is_told && std::ranges::find(perhaps, iri) == perhaps.end()) classes.push_back(iri);
    }
    annotation.all_classes = local_names(classes);
    annotation.classes = local_names(domain.most_specific(classes));
    annotation.nearest = nearest_classes(domain, assumed, classes);
    annotation.answers = learned_answers(session, knowledge);
    tell_nearest_names(session, knowledge, annotation);
    annotation.is_complete = knowledge.complete;
    for (const auto& [a, b] : knowledge.connected) annotation.connected.emplace_back(a + 1, b + 1);
    if (options.diagnose) annotation.diagnosis = diagnose(session, known, annotation.answers);
    annotation.consistent = !known.contradiction && known.diagnoses.empty() && annotation.diagnosis.empty();
    annotation.open_questions = open_questions(session, knowledge, namings, known, assumed, perhaps);
    if (!session.trace.empty() && !annotation.classes.empty())
        session.trace.back().inferred.push_back("the object is " +
                                                fmt::format("{}", fmt::join(annotation.classes, ", ")));
    annotation.questions = {{"SF", session.find_all_count},
                            {"SI", session.is_a_count},
                            {"T", session.related_count},
                            {"TF", session.find_related_count},
                            {"read_off", session.read_off_count}};
    session.tell_measures();
    annotation.trace = std::move(session.trace);
    for (const auto& [stage, ms] : object.times) annotation.timings_ms.emplace_back("find parts: " + stage, ms);
    const auto ms = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
    annotation.timings_ms.emplace_back("expert system", ms);
    return annotation;
}

}  // namespace partonomy
