/* Diagnoses (paper §3.2.4, §5.1.2, Fig. 14): for each incompatible concept that is entailed of the object or of a part,
 * who is to blame, a minimal set of answers and axioms that entail it, and the cheapest ways to mend it
 * (rank_corrections.cpp).
 *
 * A minimal set may be long, and most of it is why a wheelbarrow with legs too long is a wheelbarrow. What the rule
 * itself rests on is told first: the answers about the parts to blame, and all that are not needed for what the rule is
 * a case of, which a second minimal explanation within the first tells. A rule about parts that are missing blames
 * none: the parts that come nearest to these are named instead, with what refuses them. */

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "base/errors.h"
#include "base/spelling.h"
#include "expert/annotate.h"
#include "expert/nearest_name.h"
#include "expert/rank_corrections.h"
#include "expert/rule_questions.h"
#include "knowledge/counted_parts.h"
#include "owl/signature.h"
#include "owl/words.h"

namespace partonomy {
namespace {

using knowledge::ConceptId;
using knowledge::Conclusions;
using knowledge::Domain;
using knowledge::Knowledge;
using owl::Iri;

constexpr int most_parts_explained = 500;  // beyond, a minimal explanation takes longer than all the rest

const Iri incompatible = std::string(owl::core_prefix) + "Incompatible";

constexpr std::size_t most_near = 3;  // parts that come nearest to one that is missing

bool names(const owl::ClassPointer& class_, const Iri& iri) {
    return class_->kind == owl::ClassKind::named && class_->iri == iri;
}

class Diagnoser {
public:
    Diagnoser(const Session& session, const Conclusions& known, const std::vector<LearnedAnswer>& learned)
        : session_(session),
          domain_(session.domain()),
          knowledge_(session.knowledge()),
          corrector_(session, known, learned),
          learned_(learned) {}

    /// An empty IRI: why the answers contradict the axioms. `region` for a concept of regions, else -1.
    [[nodiscard]] Diagnosis diagnose(const Iri& iri, int region) const {
        Diagnosis diagnosis;
        diagnosis.concept_name = iri.empty() ? "contradiction" : owl::local_name(iri);
        if (!iri.empty()) {
            diagnosis.comment = comment_on(iri);
            count(iri, diagnosis);
        }
        if (region >= 0)
            diagnosis.parts = {region + 1};
        else if (!iri.empty())
            for (const int culprit : culprits(domain_, knowledge_, iri)) diagnosis.parts.push_back(culprit + 1);
        if (region < 0 && !iri.empty() && session_.region_count() > most_parts_explained) {
            blame(iri, diagnosis);
            return diagnosis;
        }
        knowledge::Explanation why;
        try {
            why = explain(domain_, knowledge_, iri, region);
            tell(why, iri, region, diagnosis);
        } catch (const OntologyError& limit) {
            diagnosis.answers.emplace_back(limit.what());
        }
        try {
            correct(iri, region, why, diagnosis);
        } catch (const OntologyError& limit) {
            if (diagnosis.answers.empty() || diagnosis.answers.back() != limit.what())
                diagnosis.answers.emplace_back(limit.what());
        }
        return diagnosis;
    }

private:
    /// What the expert says of a class; of several comments the first.
    [[nodiscard]] std::string comment_on(const Iri& iri) const {
        const auto found = domain_.ontology.annotations.find(iri);
        if (found == domain_.ontology.annotations.end()) return {};
        for (const owl::Annotation& each : found->second)
            if (each.property == std::string(owl::rdfs_prefix) + "comment") return each.literal.value;
        return {};
    }

    void tell(const knowledge::Explanation& explanation, const Iri& iri, int region, Diagnosis& diagnosis) const {
        std::vector<std::size_t> answers = explanation.answers;
        const std::vector<std::size_t> of_given = answers_of_given(explanation, iri, region, diagnosis);
        const std::vector<const owl::Axiom*> rule = definitions_of(domain_, iri);
        std::ranges::stable_sort(answers, {}, [&](std::size_t i) {
            const int variable = knowledge_.answers[i].question.variable;
            return std::pair(std::ranges::binary_search(of_given, i),
                             !is_named_in(rule, domain_.regions.variables[static_cast<std::size_t>(variable)]));
        });
        for (const std::size_t i : answers) diagnosis.answers.push_back(in_words(i));
        if (explanation.needs_completeness)
            diagnosis.answers.insert(diagnosis.answers.end() - static_cast<std::ptrdiff_t>(of_given.size()),
                                     no_other_parts);
        diagnosis.answers_of_given = of_given.size();
        for (const std::size_t i : outward_from(iri, explanation.axioms))
            diagnosis.axioms.push_back(axiom_in_words(domain_.ontology.axioms[i]));
        if (!explanation.is_minimal)
            diagnosis.answers.emplace_back("perhaps not all of this is needed: a limit of steps was reached");
    }

    /// The classes that the definition begins with: what it is a case of.
    [[nodiscard]] std::vector<Iri> given(const Iri& iri) const {
        std::vector<Iri> found;
        for (const owl::Axiom* axiom : definitions_of(domain_, iri)) {
            if (axiom->kind != owl::AxiomKind::equivalent_classes) continue;
            for (const owl::ClassPointer& each : axiom->classes)
                if (each->kind == owl::ClassKind::intersection_of)
                    for (const owl::ClassPointer& operand : each->operands)
                        if (operand->kind == owl::ClassKind::named && !operand->iri.starts_with(owl::core_prefix))
                            found.push_back(operand->iri);
        }
        return found;
    }

    /// Answers that entail a class, the fewer the better: of those if they do, else of all.
    [[nodiscard]] std::vector<std::size_t> needed_for(const Iri& class_, int region,
                                                      const knowledge::Explanation& why) const {
        Knowledge kept = knowledge_;
        kept.complete = why.needs_completeness;
        kept.answers.clear();
        for (const std::size_t i : why.answers) kept.answers.push_back(knowledge_.answers[i]);
        try {
            std::vector<std::size_t> needed = explain(domain_, kept, class_, region).answers;
            for (std::size_t& i : needed) i = why.answers[i];
            return needed;
        } catch (const std::invalid_argument&) {  // composite parts may be others without the answers that are left out
            return explain(domain_, knowledge_, class_, region).answers;
        }
    }

    /// Of the explanation's answers, ascending, those that only make it what the rule is a case of: not about parts to
    /// blame, and needed for that. None where nothing else would be left.
    [[nodiscard]] std::vector<std::size_t> answers_of_given(const knowledge::Explanation& why, const Iri& iri,
                                                            int region, Diagnosis& diagnosis) const {
        const std::vector<Iri> classes = iri.empty() ? std::vector<Iri>{} : given(iri);
        std::set<std::size_t> needed;
        for (const Iri& each : classes)
            for (const std::size_t i : needed_for(each, region, why))
                if (std::ranges::find(why.answers, i) != why.answers.end()) needed.insert(i);
        std::erase_if(needed, [&](std::size_t i) {
            return region < 0 &&
                   std::ranges::find(diagnosis.parts, knowledge_.answers[i].region + 1) != diagnosis.parts.end();
        });
        if (needed.empty() || needed.size() == why.answers.size()) return {};
        for (const Iri& each : classes) diagnosis.given.push_back(owl::local_name(each));
        return {needed.begin(), needed.end()};
    }

    /// Axioms by how many definitions lie between them and the concept.
    [[nodiscard]] std::vector<std::size_t> outward_from(const Iri& iri, std::vector<std::size_t> axioms) const {
        std::vector<std::size_t> ordered;
        std::vector<Iri> reached{iri};
        std::set<Iri> known{iri};
        for (std::size_t next = 0; next < reached.size(); ++next) {
            const Iri name = reached[next];
            std::erase_if(axioms, [&](std::size_t i) {
                const owl::Axiom& axiom = domain_.ontology.axioms[i];
                if (std::ranges::none_of(axiom.classes, [&](const auto& each) { return names(each, name); }))
                    return false;
                ordered.push_back(i);
                owl::for_each_name(axiom, [&](const Iri& each) {
                    if (known.insert(each).second) reached.push_back(each);
                });
                return true;
            });
        }
        ordered.insert(ordered.end(), axioms.begin(), axioms.end());
        return ordered;
    }

    /// All answers about the parts to blame, and the definition.
    void blame(const Iri& iri, Diagnosis& diagnosis) const {
        for (std::size_t i = 0; i < knowledge_.answers.size(); ++i) {
            const knowledge::Answer& answer = knowledge_.answers[i];
            if (answer.yes && std::ranges::find(diagnosis.parts, answer.region + 1) != diagnosis.parts.end())
                diagnosis.answers.push_back(in_words(i));
        }
        for (const owl::Axiom* axiom : definitions_of(domain_, iri))
            if (axiom->kind == owl::AxiomKind::equivalent_classes) diagnosis.axioms.push_back(axiom_in_words(*axiom));
    }

    [[nodiscard]] std::string in_words(std::size_t i) const {
        return answer_in_words(domain_, knowledge_.answers[i], learned_[i]);
    }

    /// "add one Fin", "one more Leg", "take away one Lens: part 3 or part 4".
    [[nodiscard]] static std::string in_words(const RankedCorrection& each) {
        constexpr std::size_t most = 4;  // parts that are told
        const Diagnosis::Change& change = each.change;
        const std::string number = std::abs(change.count) == 1 ? "one" : std::to_string(std::abs(change.count));
        if (change.count > 0)
            return each.has_some ? fmt::format("{} more {}", number, change.part)
                                 : fmt::format("add {} {}", number, change.part);
        std::string which;
        for (std::size_t i = 0; i < std::min(most, each.parts.size()); ++i)
            which += fmt::format("{}part {}", which.empty() ? ": " : " or ", each.parts[i] + 1);
        return fmt::format("take away {} {}{}{}", number, change.part, which,
                           each.parts.size() > most ? " or another" : "");
    }

    void correct(const Iri& iri, int region, const knowledge::Explanation& why, Diagnosis& diagnosis) const {
        for (const RankedCorrection& each : corrector_.ranked(iri, region, why, diagnosis.parts)) {
            std::string text;
            for (const std::size_t i : each.change.answers) {
                const knowledge::Answer& answer = knowledge_.answers[i];
                text += fmt::format("{}part {}: {}: {} instead of {}", text.empty() ? "" : "; and ", answer.region + 1,
                                    to_text(domain_.regions, answer.question, domain_), answer.yes ? "no" : "yes",
                                    answer.yes ? "yes" : "no");
            }
            if (text.empty()) text = in_words(each);
            std::vector<std::string> gone;
            Diagnosis::Change change = each.change;
            for (const Iri& class_ : each.lost) {
                change.lost.push_back(owl::local_name(class_));
                gone.push_back(with_article(change.lost.back()));
            }
            diagnosis.corrections.push_back(
                fmt::format("{} (cost {:.2f}{})", text, each.change.cost,
                            gone.empty() ? "" : fmt::format("; then it is not {}", fmt::join(gone, ", nor "))));
            diagnosis.changes.push_back(std::move(change));
        }
    }

    void count(const Iri& iri, Diagnosis& diagnosis) const {
        const knowledge::CountedParts counted = knowledge::counted_parts(domain_.ontology, iri);
        for (const knowledge::CountedPart& part : counted.parts) {
            diagnosis.counts.push_back({owl::local_name(part.iri), part.at_least, part.at_most});
            for (std::vector<int> each : corrector_.bearers(part.iri)) {
                for (int& region : each) ++region;
                diagnosis.counts.back().bearers.push_back(std::move(each));
            }
            if (!part.at_most || !session_.is_told_in_numbers()) continue;
            for (const NearestRegion& near : nearest_regions(session_, knowledge_, part.iri, most_near)) {
                Diagnosis::NearPart& told = diagnosis.nearest.emplace_back();
                told.part = near.region + 1;
                told.concept_name = owl::local_name(part.iri);
                for (const std::size_t i : near.refused.refused_by)
                    told.refused_by.push_back(what_was_answered(domain_, knowledge_.answers[i], learned_[i]));
            }
        }
        diagnosis.counts_are_all = counted.is_all;
    }

    const Session& session_;
    const Domain& domain_;
    Knowledge knowledge_;
    Corrector corrector_;
    const std::vector<LearnedAnswer>& learned_;
};

}  // namespace

std::string answer_in_words(const Domain& domain, const knowledge::Answer& answer, const LearnedAnswer& learned) {
    return fmt::format("part {}: {}", answer.region + 1, what_was_answered(domain, answer, learned));
}

std::string what_was_answered(const Domain& domain, const knowledge::Answer& answer, const LearnedAnswer& learned) {
    return fmt::format("{}: {} ({}){}", to_text(domain.regions, answer.question, domain), answer.yes ? "yes" : "no",
                       learned.accepted ? "a person said so" : fmt::format("{:.2f}", learned.score),
                       learned.measured.empty() ? "" : " [" + learned.measured + "]");
}

std::string axiom_in_words(const owl::Axiom& axiom) {
    return fmt::format("{} ({}:{})", to_manchester(axiom), std::filesystem::path(axiom.source.file).filename().string(),
                       axiom.source.line);
}

std::string feature_name(const knowledge::Variable& variable) {
    return variable.kind == knowledge::VariableKind::relation || variable.kind == knowledge::VariableKind::open
               ? to_manchester(*variable.part_class)
               : variable.iri;
}

Knowledge recall(const Domain& domain, int part_count, bool is_complete, const std::vector<LearnedAnswer>& answers,
                 const std::vector<std::pair<int, int>>& connected) {
    Knowledge knowledge{part_count, is_complete, {}};
    for (const auto& [a, b] : connected) knowledge.connected.emplace_back(a - 1, b - 1);
    for (const LearnedAnswer& answer : answers) {
        const auto& variables = domain.regions.variables;
        const auto variable = std::ranges::find(variables, answer.feature, feature_name);
        const std::vector<std::string> values =
            variable == variables.end() ? std::vector<std::string>{} : variable->values;
        const auto value = std::ranges::find(values, answer.value);
        if (value == values.end() || answer.part < 1 || answer.part > part_count)
            throw UsageError(fmt::format("part {}: {} \"{}\" is no question of this ontology; annotate again",
                                         answer.part, owl::local_name(answer.feature), answer.value));
        const auto index = static_cast<knowledge::ValueId>(value - values.begin());
        knowledge.answers.push_back(
            {answer.part - 1, {static_cast<knowledge::VariableId>(variable - variables.begin()), index}, answer.yes});
    }
    return knowledge;
}

std::vector<Diagnosis> diagnose(const Session& session, const Conclusions& known,
                                const std::vector<LearnedAnswer>& learned) {
    const Domain& domain = session.domain();
    const bool is_fine = known.diagnoses.empty() && !known.contradiction;
    if (is_fine) return {};
    const Diagnoser diagnoser(session, known, learned);
    if (known.contradiction) return {diagnoser.diagnose({}, -1)};
    std::vector<Diagnosis> diagnoses;
    for (const ConceptId c : entailed(*known.objects, known.object)) {
        const knowledge::Concept& concept_ = known.objects->concepts[static_cast<std::size_t>(c)];
        if (concept_.incompatible && concept_.iri != incompatible)
            diagnoses.push_back(diagnoser.diagnose(concept_.iri, -1));
    }
    std::set<Iri> explained;  // once, however many composite parts are one
    for (const knowledge::CompositePart& part : known.composites) {
        const knowledge::Space& space = domain.composites[static_cast<std::size_t>(part.group)].space;
        for (const ConceptId c : entailed(space, part.possible)) {
            const knowledge::Concept& concept_ = space.concepts[static_cast<std::size_t>(c)];
            if (concept_.incompatible && concept_.iri != incompatible && explained.insert(concept_.iri).second)
                diagnoses.push_back(diagnoser.diagnose(concept_.iri, -1));
        }
    }
    for (int region = 0; region < session.region_count(); ++region)
        for (const ConceptId c : entailed(domain.regions, known.regions[static_cast<std::size_t>(region)])) {
            const knowledge::Concept& concept_ = domain.regions.concepts[static_cast<std::size_t>(c)];
            if (concept_.incompatible && concept_.iri != incompatible)
                diagnoses.push_back(diagnoser.diagnose(concept_.iri, region));
        }
    return diagnoses;
}

}  // namespace partonomy
