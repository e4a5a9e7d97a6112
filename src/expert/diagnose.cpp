/* Diagnoses (paper §3.2.4, §5.1.2, Fig. 14): for each incompatible concept that is entailed, who is to blame, a minimal
 * set of answers and axioms that entail it, and the single answers whose change would mend it, the least certain ones
 * first. The cost of turning an answer round is its distance from the boundary: an answer with score 0.5 costs nothing,
 * one with 1 costs 0.5. */

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "expert/annotate.h"

namespace partonomy {
namespace {

using knowledge::ConceptId;
using knowledge::Conclusions;
using knowledge::Domain;
using owl::Iri;

std::string answer_in_words(const Session& session, const knowledge::Answer& answer, double score) {
    const Domain& domain = session.domain();
    return fmt::format("part {}: {}: {} ({:.2f})", answer.region + 1, to_text(domain.regions, answer.question, domain),
                       answer.yes ? "yes" : "no", score);
}

std::string axiom_in_words(const owl::Axiom& axiom) {
    return fmt::format("{} ({}:{})", to_manchester(axiom), std::filesystem::path(axiom.source.file).filename().string(),
                       axiom.source.line);
}

Diagnosis explain_concept(const Session& session, const knowledge::Knowledge& knowledge, const Iri& iri) {
    const Domain& domain = session.domain();
    Diagnosis diagnosis;
    diagnosis.concept_name = iri.empty() ? "contradiction" : owl::local_name(iri);
    const knowledge::Explanation explanation = explain(domain, knowledge, iri);
    for (const std::size_t i : explanation.answers)
        diagnosis.answers.push_back(answer_in_words(session, knowledge.answers[i], session.answer_scores()[i]));
    if (explanation.needs_completeness) diagnosis.answers.emplace_back("there are no other parts");
    for (const std::size_t i : explanation.axioms)
        diagnosis.axioms.push_back(axiom_in_words(domain.ontology.axioms[i]));
    if (iri.empty()) return diagnosis;
    for (const int region : culprits(domain, knowledge, iri)) diagnosis.parts.push_back(region + 1);
    std::vector<double> costs;
    for (const double score : session.answer_scores()) costs.push_back(std::abs(score - 0.5));
    std::vector<knowledge::Correction> ranked = corrections(domain, knowledge, iri, costs);
    std::stable_sort(ranked.begin(), ranked.end(), [&](const auto& a, const auto& b) {
        const auto key = [&](const knowledge::Correction& c) {
            const int part = knowledge.answers[c.answer].region + 1;
            return std::pair(c.cost, std::ranges::find(diagnosis.parts, part) == diagnosis.parts.end());
        };
        return key(a) < key(b);
    });
    for (const knowledge::Correction& correction : ranked) {
        const knowledge::Answer& answer = knowledge.answers[correction.answer];
        diagnosis.corrections.push_back(fmt::format("part {}: {}: {} instead of {} (cost {:.2f})", answer.region + 1,
                                                    to_text(domain.regions, answer.question, domain),
                                                    answer.yes ? "no" : "yes", answer.yes ? "yes" : "no",
                                                    correction.cost));
    }
    return diagnosis;
}

}  // namespace

std::vector<Diagnosis> diagnose(const Session& session, const Conclusions& known) {
    const knowledge::Knowledge knowledge = session.knowledge();
    std::vector<Diagnosis> diagnoses;
    if (known.contradiction) return {explain_concept(session, knowledge, {})};
    for (const ConceptId c : entailed(session.domain().objects, known.object)) {
        const knowledge::Concept& concept_ = session.domain().objects.concepts[static_cast<std::size_t>(c)];
        if (concept_.incompatible && concept_.iri != std::string(owl::core_prefix) + "Incompatible")
            diagnoses.push_back(explain_concept(session, knowledge, concept_.iri));
    }
    std::set<Iri> explained;  // once, however many composite parts are one
    for (const knowledge::CompositePart& part : known.composites) {
        const knowledge::Space& space = session.domain().composites[static_cast<std::size_t>(part.group)].space;
        for (const ConceptId c : entailed(space, part.possible)) {
            const knowledge::Concept& concept_ = space.concepts[static_cast<std::size_t>(c)];
            if (concept_.incompatible && explained.insert(concept_.iri).second)
                diagnoses.push_back(explain_concept(session, knowledge, concept_.iri));
        }
    }
    for (int region = 0; region < session.region_count(); ++region)
        for (const ConceptId c : entailed(session.domain().regions, known.regions[static_cast<std::size_t>(region)])) {
            const knowledge::Concept& concept_ = session.domain().regions.concepts[static_cast<std::size_t>(c)];
            if (!concept_.incompatible || concept_.iri == std::string(owl::core_prefix) + "Incompatible") continue;
            Diagnosis diagnosis;
            diagnosis.concept_name = owl::local_name(concept_.iri);
            diagnosis.parts = {region + 1};
            for (std::size_t i = 0; i < knowledge.answers.size(); ++i)
                if (knowledge.answers[i].region == region)
                    diagnosis.answers.push_back(
                        answer_in_words(session, knowledge.answers[i], session.answer_scores()[i]));
            diagnoses.push_back(std::move(diagnosis));
        }
    return diagnoses;
}

}  // namespace partonomy
