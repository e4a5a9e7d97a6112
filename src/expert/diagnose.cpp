/* Diagnoses (paper §3.2.4, §5.1.2, Fig. 14): for each incompatible concept that is entailed of the object or of a part,
 * who is to blame, a minimal set of answers and axioms that entail it, and the cheapest sets of answers whose change
 * would mend it. The cost of turning an answer round is its distance from the boundary: an answer with score 0.5 costs
 * nothing, one with 1 costs 0.5. What a person said is never to be turned round.
 *
 * What makes a hammer with a wrong head no hammer at all mends it, too, and often costs less: there are more answers
 * that its name rests on than such that the broken rule rests on. So corrections that leave the object all that it is
 * else come first, and the others say what is lost. The search by cost may not come to the former among all the others;
 * they are tried by themselves. Whatever mends must turn an answer of the minimal explanation, so each of these is
 * turned alone, then together with the same answer about the other parts to blame. */

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>
#include <tuple>

#include "base/errors.h"
#include "base/spelling.h"
#include "expert/annotate.h"
#include "owl/signature.h"

namespace partonomy {
namespace {

using knowledge::ConceptId;
using knowledge::Conclusions;
using knowledge::Domain;
using knowledge::Knowledge;
using owl::Iri;

constexpr std::size_t most_corrections = 8;  // that are listed for one diagnosis
// For the corrections of one diagnosis, about 0.5 s; objects of many parts have a great many.
constexpr std::uint64_t most_steps = 700'000;
constexpr double never = 1'000'000;        // the cost of turning round what a person said
constexpr int most_parts_explained = 500;  // beyond, a minimal explanation takes longer than all the rest
constexpr int most_parts_tried = 100;      // each trial concludes anew
constexpr std::size_t most_trials = 32;    // for one diagnosis

const Iri incompatible = std::string(owl::core_prefix) + "Incompatible";

class Diagnoser {
public:
    Diagnoser(const Session& session, const Conclusions& known)
        : session_(session), domain_(session.domain()), known_(known), knowledge_(session.knowledge()) {
        if (!known.contradiction) classes_ = domain_.most_specific(classes(known));
        for (std::size_t i = 0; i < knowledge_.answers.size(); ++i)
            costs_.push_back(session.is_accepted(knowledge_.answers[i]) ? never
                                                                        : std::abs(session.answer_scores()[i] - 0.5));
    }

    /// An empty IRI: why the answers contradict the axioms. `region` for a concept of regions, else -1.
    [[nodiscard]] Diagnosis diagnose(const Iri& iri, int region) const {
        Diagnosis diagnosis;
        diagnosis.concept_name = iri.empty() ? "contradiction" : owl::local_name(iri);
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
            tell(why, diagnosis);
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
    void tell(const knowledge::Explanation& explanation, Diagnosis& diagnosis) const {
        for (const std::size_t i : explanation.answers) diagnosis.answers.push_back(in_words(i));
        if (explanation.needs_completeness) diagnosis.answers.emplace_back(no_other_parts);
        for (const std::size_t i : explanation.axioms)
            diagnosis.axioms.push_back(axiom_in_words(domain_.ontology.axioms[i]));
        if (!explanation.is_minimal)
            diagnosis.answers.emplace_back("perhaps not all of this is needed: a limit of steps was reached");
    }

    /// All answers about the parts to blame, and the definition.
    void blame(const Iri& iri, Diagnosis& diagnosis) const {
        for (std::size_t i = 0; i < knowledge_.answers.size(); ++i) {
            const knowledge::Answer& answer = knowledge_.answers[i];
            if (answer.yes && std::ranges::find(diagnosis.parts, answer.region + 1) != diagnosis.parts.end())
                diagnosis.answers.push_back(in_words(i));
        }
        const auto is_concept = [&](const owl::ClassPointer& each) {
            return each->kind == owl::ClassKind::named && each->iri == iri;
        };
        for (const owl::Axiom& axiom : domain_.ontology.axioms)
            if (axiom.kind == owl::AxiomKind::equivalent_classes && std::ranges::any_of(axiom.classes, is_concept))
                diagnosis.axioms.push_back(axiom_in_words(axiom));
    }

    [[nodiscard]] std::string in_words(std::size_t i) const {
        const knowledge::Answer& answer = knowledge_.answers[i];
        return answer_in_words(domain_, answer, session_.answer_scores()[i], session_.is_accepted(answer));
    }

    /// A correction and what the object would no longer be.
    struct Ranked {
        knowledge::Correction correction;
        std::vector<Iri> lost;
    };

    /// Concepts of the object that hold and are no diagnoses.
    [[nodiscard]] static std::vector<Iri> classes(const Conclusions& what) {
        std::vector<Iri> found;
        for (const ConceptId c : entailed(*what.objects, what.object)) {
            const knowledge::Concept& concept_ = what.objects->concepts[static_cast<std::size_t>(c)];
            if (!concept_.incompatible && !concept_.iri.starts_with(owl::core_prefix)) found.push_back(concept_.iri);
        }
        return found;
    }

    /// What the object is now and would not be then.
    [[nodiscard]] std::vector<Iri> lost(const Conclusions& after) const {
        const std::vector<Iri> left = after.contradiction ? std::vector<Iri>{} : classes(after);
        std::vector<Iri> gone = classes_;
        std::erase_if(gone, [&](const Iri& class_) { return std::ranges::find(left, class_) != left.end(); });
        return gone;
    }

    [[nodiscard]] Conclusions turned(const std::vector<std::size_t>& answers) const {
        Knowledge changed = knowledge_;
        for (const std::size_t i : answers) changed.answers[i].yes = !changed.answers[i].yes;
        return conclude(domain_, changed);
    }

    /// Whether the concept no longer holds then, and nothing incompatible that did not hold before.
    [[nodiscard]] bool mends(const Conclusions& after, const Iri& iri, int region) const {
        if (after.contradiction) return false;
        if (region >= 0) {
            const auto& left = after.regions[static_cast<std::size_t>(region)];
            const auto id = domain_.regions.find(iri);
            if (id && left.is_subset_of(domain_.regions.concepts[static_cast<std::size_t>(*id)].where)) return false;
        }
        return std::ranges::all_of(after.diagnoses, [&](const Iri& each) {
            return std::ranges::binary_search(known_.diagnoses, each) && (region >= 0 || each != iri);
        });
    }

    /// Of what is said of one part by an answer, the same said of others to blame; `answer` itself first.
    [[nodiscard]] std::vector<std::size_t> said_alike(std::size_t answer, const std::vector<int>& parts) const {
        const knowledge::Answer& model = knowledge_.answers[answer];
        std::vector<std::size_t> alike{answer};
        for (std::size_t i = 0; i < knowledge_.answers.size(); ++i) {
            const knowledge::Answer& each = knowledge_.answers[i];
            if (i != answer && each.question == model.question && each.yes == model.yes &&
                std::ranges::find(parts, each.region + 1) != parts.end())
                alike.push_back(i);
        }
        return alike;
    }

    /// Corrections by answers of the explanation that leave the object all that it is.
    [[nodiscard]] std::vector<Ranked> corrections_that_keep(const Iri& iri, int region,
                                                            const knowledge::Explanation& why,
                                                            const std::vector<int>& blamed) const {
        std::vector<Ranked> found;
        if (session_.region_count() > most_parts_tried) return found;
        std::size_t trials = 0;
        const auto keeps = [&](const std::vector<std::size_t>& answers) {
            ++trials;
            const Conclusions after = turned(answers);
            return mends(after, iri, region) && lost(after).empty();
        };
        for (auto answer = why.answers.rbegin(); answer != why.answers.rend() && trials < most_trials; ++answer) {
            std::vector<std::size_t> set{*answer};
            if (!keeps(set)) {
                set = said_alike(*answer, blamed);
                if (set.size() < 2 || !keeps(set)) continue;
                for (std::size_t i = set.size(); i-- > 0;) {  // a part of it may do
                    std::vector<std::size_t> fewer = set;
                    fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
                    if (!fewer.empty() && keeps(fewer)) set = std::move(fewer);
                }
                std::ranges::sort(set);
            }
            double cost = 0;
            for (const std::size_t i : set) cost += costs_[i];
            const auto is_same = [&](const Ranked& each) { return each.correction.answers == set; };
            if (std::ranges::none_of(found, is_same)) found.push_back({{std::move(set), cost}, {}});
        }
        return found;
    }

    [[nodiscard]] std::vector<const owl::Axiom*> definitions(const Iri& iri) const {
        std::vector<const owl::Axiom*> found;
        for (const owl::Axiom& axiom : domain_.ontology.axioms)
            if (std::ranges::any_of(axiom.classes, [&](const owl::ClassPointer& each) {
                    return each->kind == owl::ClassKind::named && each->iri == iri;
                }))
                found.push_back(&axiom);
        return found;
    }

    /// Whether axioms name what an answer is about: the property that was measured, a value of the range concept, or
    /// the relation to other parts.
    [[nodiscard]] bool is_named_in(const std::vector<const owl::Axiom*>& axioms, std::size_t answer) const {
        const auto id = static_cast<std::size_t>(knowledge_.answers[answer].question.variable);
        const knowledge::Variable& variable = domain_.regions.variables[id];
        return std::ranges::any_of(axioms, [&](const owl::Axiom* axiom) {
            if (variable.part_class)
                return to_manchester(*axiom).find(to_manchester(*variable.part_class)) != std::string::npos;
            bool is_named = false;
            owl::for_each_name(*axiom, [&](const Iri& name) {
                is_named |= name == variable.iri ||
                            std::ranges::find(variable.values, owl::local_name(name)) != variable.values.end();
            });
            return is_named;
        });
    }

    /// Those that leave the object what it is, then the others; each by cost, of costs that are alike first what the
    /// rule itself asks for, then those about the parts to blame.
    [[nodiscard]] std::vector<Ranked> ranked(const Iri& iri, int region, const knowledge::Explanation& why,
                                             const std::vector<int>& blamed) const {
        knowledge::ExplanationOptions options;
        options.limit = most_corrections;
        options.steps = most_steps;
        std::vector<Ranked> all;
        if (!classes_.empty()) all = corrections_that_keep(iri, region, why, blamed);
        const std::size_t kept = all.size();
        for (knowledge::Correction& each : corrections(domain_, knowledge_, iri, costs_, region, options)) {
            const auto is_same = [&](const Ranked& other) { return other.correction.answers == each.answers; };
            if (std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), is_same)) continue;
            std::vector<Iri> gone;
            if (!classes_.empty() && session_.region_count() <= most_parts_tried) gone = lost(turned(each.answers));
            all.push_back({std::move(each), std::move(gone)});
        }
        const auto is_innocent = [&](const Ranked& each) {
            return std::ranges::none_of(each.correction.answers, [&](std::size_t i) {
                return std::ranges::find(blamed, knowledge_.answers[i].region + 1) != blamed.end();
            });
        };
        const std::vector<const owl::Axiom*> rule = definitions(iri);
        const auto is_asked_by_the_rule = [&](const Ranked& each) {
            return std::ranges::any_of(each.correction.answers, [&](std::size_t i) { return is_named_in(rule, i); });
        };
        std::erase_if(all, [](const Ranked& each) { return each.correction.cost >= never; });
        std::ranges::stable_sort(all, {}, [&](const Ranked& each) {
            const double cost = each.correction.cost;
            return std::tuple(!each.lost.empty(), std::round(10 * cost), !is_asked_by_the_rule(each), cost,
                              is_innocent(each));
        });
        if (all.size() > most_corrections) all.resize(most_corrections);
        return all;
    }

    void correct(const Iri& iri, int region, const knowledge::Explanation& why, Diagnosis& diagnosis) const {
        for (const Ranked& each : ranked(iri, region, why, diagnosis.parts)) {
            std::string text;
            for (const std::size_t i : each.correction.answers) {
                const knowledge::Answer& answer = knowledge_.answers[i];
                text += fmt::format("{}part {}: {}: {} instead of {}", text.empty() ? "" : "; and ", answer.region + 1,
                                    to_text(domain_.regions, answer.question, domain_), answer.yes ? "no" : "yes",
                                    answer.yes ? "yes" : "no");
            }
            std::vector<std::string> gone;
            for (const Iri& class_ : each.lost) gone.push_back(with_article(owl::local_name(class_)));
            diagnosis.corrections.push_back(
                fmt::format("{} (cost {:.2f}{})", text, each.correction.cost,
                            gone.empty() ? "" : fmt::format("; then it is not {}", fmt::join(gone, ", nor "))));
            diagnosis.changes.push_back({each.correction.answers, each.correction.cost});
        }
    }

    const Session& session_;
    const Domain& domain_;
    const Conclusions& known_;
    Knowledge knowledge_;
    std::vector<Iri> classes_;  ///< of the object, the most specific
    std::vector<double> costs_;
};

}  // namespace

std::string answer_in_words(const Domain& domain, const knowledge::Answer& answer, double score, bool accepted) {
    return fmt::format("part {}: {}: {} ({})", answer.region + 1, to_text(domain.regions, answer.question, domain),
                       answer.yes ? "yes" : "no", accepted ? "a person said so" : fmt::format("{:.2f}", score));
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

std::vector<Diagnosis> diagnose(const Session& session, const Conclusions& known) {
    const Domain& domain = session.domain();
    const bool is_fine = known.diagnoses.empty() && !known.contradiction;
    if (is_fine) return {};
    const Diagnoser diagnoser(session, known);
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
