/* From questions to an annotation: asks about the likeliest cut (likeliest_cut.cpp), decides what every part is called
 * (naming.cpp), and tells what is wrong (diagnose.cpp) and what stayed open (open_questions.cpp).
 *
 * What is incompatible only if an assumed name is right is no class and no diagnosis: it is told as "perhaps".
 *
 * Score of a part: mean fitting score of its triangles times the `is a` score of its shape (paper §6.4), times the
 * certainty of its name. Score of the object: mean of its parts' scores by area. */

#include "expert/annotate.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <iterator>
#include <memory>

#include "base/errors.h"
#include "expert/accepted_answers.h"
#include "expert/likeliest_cut.h"
#include "expert/naming.h"
#include "expert/open_questions.h"
#include "expert/rule_questions.h"

namespace partonomy {
namespace {

using knowledge::ConceptId;
using knowledge::Conclusions;
using knowledge::ConfigurationSet;
using knowledge::Domain;
using owl::Iri;

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
        if (!session.is_told_in_numbers()) continue;
        const InNumbers numbers = session.in_numbers(answer);
        answers.back().measured = numbers.text;
        answers.back().off = numbers.off;
    }
    return answers;
}

/// What was not needed to tell what the object is, and what explains why it is nothing, or impossible.
void ask_for_explanations(Session& session) {
    const Conclusions known = conclude(session.domain(), session.knowledge());
    if (!is_recognised(known) && !known.contradiction && session.is_told_in_numbers()) ask_what_objects_count(session);
    ask_what_rules_rest_on(session);
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

/// Mean of the scores of the parts by area, those without a name counting 0.
double score_of(const Annotation& annotation) {
    double area = 0, scored_area = 0;
    for (const AnnotatedPart& part : annotation.parts) {
        area += part.area;
        if (!part.concepts.empty()) scored_area += part.area * part.score;
    }
    return area > 0 ? scored_area / area : 0;
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

    if (options.strategy == Strategy::expert && options.diagnose) ask_for_explanations(session);
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
