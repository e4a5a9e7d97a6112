/* Which corrections of an impossible object to tell, and in which order.
 *
 * The cost of turning an answer round is its distance from the boundary: an answer with score 0.5 costs nothing, one
 * with 1 costs 0.5. What a person said is never to be turned round.
 *
 * What makes a hammer with a wrong head no hammer at all mends it, too, and often costs less: there are more answers
 * that its name rests on than such that the broken rule rests on. So corrections that leave the object all that it is
 * else come first, and the others say what is lost. The search by cost may not come to the former among all the others;
 * they are tried by themselves. Whatever mends must turn an answer of the minimal explanation, so each of these is
 * turned alone, then together with the same answer about the other parts to blame. A rule that is broken in two ways
 * takes two answers: all that it names of the parts to blame are turned together.
 *
 * Where the rule counts parts, one more or one less may be what it takes: an aeroplane without a fin needs a fin, and
 * no answer is wrong. A part more or less costs as much as turning a certain answer. Each such correction is tried: the
 * object with further regions of which nothing but the name is known, or without some of its own. */

#include "expert/rank_corrections.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>

#include "expert/rule_questions.h"
#include "knowledge/counted_parts.h"

namespace partonomy {
namespace {

using knowledge::ConceptId;
using knowledge::Conclusions;
using knowledge::ConfigurationSet;
using knowledge::Knowledge;
using owl::Iri;

constexpr std::size_t most_corrections = 8;  // that are told for one diagnosis
// For the corrections of one diagnosis, about 0.5 s; objects of many parts have a great many.
constexpr std::uint64_t most_steps = 700'000;
constexpr double never = 1'000'000;       // the cost of turning round what a person said
constexpr double of_a_part = 0.5;         // the cost of a part more or less
constexpr int most_parts_tried = 100;     // each trial concludes anew
constexpr std::size_t most_trials = 32;   // for one diagnosis
constexpr std::size_t most_counted = 8;   // parts to add, or to take away
constexpr std::size_t most_together = 6;  // answers that a rule names, turned at once
constexpr std::size_t most_extra = 3;     // parts to add beyond those without which the rule is broken

/// Concepts of the object that hold and are no diagnoses.
std::vector<Iri> classes(const Conclusions& what) {
    std::vector<Iri> found;
    for (const ConceptId c : entailed(*what.objects, what.object)) {
        const knowledge::Concept& concept_ = what.objects->concepts[static_cast<std::size_t>(c)];
        if (!concept_.incompatible && !concept_.iri.starts_with(owl::core_prefix)) found.push_back(concept_.iri);
    }
    return found;
}

/// Answers about other regions than those, which are numbered anew.
Knowledge without_regions(const Knowledge& knowledge, const std::set<int>& regions) {
    const auto is_out = [&](int region) { return regions.contains(region); };
    const auto renumbered = [&](int region) {
        return region - static_cast<int>(std::ranges::count_if(regions, [&](int out) { return out < region; }));
    };
    Knowledge left{renumbered(knowledge.region_count), knowledge.complete, {}};
    for (knowledge::Answer answer : knowledge.answers)
        if (!is_out(answer.region)) {
            answer.region = renumbered(answer.region);
            left.answers.push_back(answer);
        }
    for (const auto& [a, b] : knowledge.connected)
        if (!is_out(a) && !is_out(b)) left.connected.emplace_back(renumbered(a), renumbered(b));
    return left;
}

}  // namespace

Corrector::Corrector(const Session& session, const Conclusions& known, const std::vector<LearnedAnswer>& learned)
    : session_(session), domain_(session.domain()), known_(known), knowledge_(session.knowledge()), learned_(learned) {
    if (!known.contradiction) classes_ = domain_.most_specific(classes(known));
    for (std::size_t i = 0; i < knowledge_.answers.size(); ++i)
        costs_.push_back(session.is_accepted(knowledge_.answers[i]) ? never
                                                                    : std::abs(session.answer_scores()[i] - 0.5));
}

/// What follows when these answers are turned round. Several diagnoses try the same ones.
const Conclusions& Corrector::turned(const std::vector<std::size_t>& answers) const {
    if (const auto found = turned_.find(answers); found != turned_.end()) return found->second;
    Knowledge changed = knowledge_;
    for (const std::size_t i : answers) changed.answers[i].yes = !changed.answers[i].yes;
    return turned_.emplace(answers, conclude(domain_, changed)).first->second;
}

std::vector<std::vector<int>> Corrector::bearers(const Iri& name) const {
    std::vector<std::vector<int>> found;
    const auto is_one = [&](const knowledge::Space& space, const ConfigurationSet& possible) {
        const auto id = space.find(name);
        return id && !possible.is_empty() && possible.is_subset_of(space.concepts[static_cast<std::size_t>(*id)].where);
    };
    for (std::size_t r = 0; r < known_.regions.size(); ++r)
        if (is_one(domain_.regions, known_.regions[r])) found.push_back({static_cast<int>(r)});
    for (const knowledge::CompositePart& part : known_.composites)
        if (is_one(domain_.composites[static_cast<std::size_t>(part.group)].space, part.possible))
            found.push_back(part.regions);
    return found;
}

/// The object with so many more parts of a name, of which nothing else is known; a composite part is made of one part
/// of each name that its definition asks for. nullopt where that is not to be had.
std::optional<Conclusions> Corrector::with_more(const Iri& name, std::size_t count) const {
    Knowledge more = knowledge_;
    std::vector<ConfigurationSet> regions = known_.regions;
    const auto add = [&](const Iri& region) {
        const auto id = domain_.regions.find(region);
        if (!id) return false;
        regions.push_back(domain_.regions.concepts[static_cast<std::size_t>(*id)].where);
        ++more.region_count;
        return !regions.back().is_empty();
    };
    for (std::size_t i = 0; i < count; ++i) {
        if (add(name)) continue;
        if (domain_.regions.find(name)) return std::nullopt;
        const int first = more.region_count;
        for (const knowledge::CountedPart& part : knowledge::counted_parts(domain_.ontology, name).parts)
            for (std::uint32_t k = 0; k < part.at_least.value_or(0); ++k)
                if (more.region_count - first >= static_cast<int>(most_counted) || !add(part.iri)) return std::nullopt;
        if (more.region_count == first) return std::nullopt;
        for (int a = first; a < more.region_count; ++a)
            for (int b = a + 1; b < more.region_count; ++b) more.connected.emplace_back(a, b);
    }
    return conclude_object(domain_, more, std::move(regions));
}

Conclusions Corrector::without(const std::vector<int>& regions) const {
    return conclude(domain_, without_regions(knowledge_, {regions.begin(), regions.end()}));
}

/// A name, and the names of regions below it: one more Step may have to be a Rung.
std::vector<Iri> Corrector::kinds_of(const Iri& name) const {
    std::vector<Iri> kinds{name};
    const auto id = domain_.regions.find(name);
    if (!id) return kinds;
    const ConfigurationSet& where = domain_.regions.concepts[static_cast<std::size_t>(*id)].where;
    for (const knowledge::Concept& each : domain_.regions.concepts)
        if (kinds.size() < most_counted && each.iri != name && !each.iri.starts_with(owl::core_prefix) &&
            !each.incompatible && !each.where.is_empty() && each.where.is_subset_of(where))
            kinds.push_back(each.iri);
    return kinds;
}

/// Where the concept's own definition counts parts: more, or fewer, of these, if that leaves the object all that it is.
std::vector<RankedCorrection> Corrector::by_numbers_of_parts(const Iri& iri) const {
    std::vector<RankedCorrection> found;
    if (iri.empty() || !knowledge_.complete || known_.contradiction || session_.region_count() > most_parts_tried)
        return found;
    const auto mends_and_keeps = [&](const Conclusions& after) { return mends(after, iri, -1) && lost(after).empty(); };
    for (const knowledge::CountedPart& part : knowledge::counted_parts(domain_.ontology, iri).parts) {
        const std::vector<std::vector<int>> there = bearers(part.iri);
        const auto tell = [&](std::size_t count, int sign, std::vector<int> parts, const Iri& name) {
            found.push_back(
                {{{}, of_a_part * static_cast<double>(count), owl::local_name(name), sign * static_cast<int>(count)},
                 std::move(parts),
                 {},
                 !there.empty()});
        };
        if (part.at_most && there.size() <= *part.at_most && *part.at_most - there.size() < most_counted) {
            const std::size_t missing = *part.at_most + 1 - there.size();
            bool is_mended = false;
            for (const Iri& name : kinds_of(part.iri))
                for (std::size_t count = missing; !is_mended && count <= missing + most_extra; ++count) {
                    const auto after = with_more(name, count);
                    if (!after || !mends_and_keeps(*after)) continue;  // one wing breaks another rule than none
                    tell(count, 1, {}, name);
                    is_mended = true;
                }
        }
        if (part.at_least && there.size() >= *part.at_least && there.size() - *part.at_least < most_counted) {
            const std::size_t surplus = there.size() - *part.at_least + 1;
            std::vector<int> each;
            for (std::size_t i = 0; surplus == 1 && i < std::min(there.size(), most_counted); ++i)
                if (mends_and_keeps(without(there[i]))) each.push_back(there[i].front());
            if (!each.empty()) tell(1, -1, std::move(each), part.iri);
            if (surplus == 1) continue;
            std::vector<int> first;
            for (std::size_t i = 0; i < surplus; ++i) first.insert(first.end(), there[i].begin(), there[i].end());
            if (mends_and_keeps(without(first))) tell(surplus, -1, {}, part.iri);
        }
    }
    return found;
}

/// What the object is now and would not be then.
std::vector<Iri> Corrector::lost(const Conclusions& after) const {
    const std::vector<Iri> left = after.contradiction ? std::vector<Iri>{} : classes(after);
    std::vector<Iri> gone = classes_;
    std::erase_if(gone, [&](const Iri& class_) { return std::ranges::find(left, class_) != left.end(); });
    return gone;
}

/// Whether the concept no longer holds then, and nothing incompatible that did not hold before.
bool Corrector::mends(const Conclusions& after, const Iri& iri, int region) const {
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
std::vector<std::size_t> Corrector::said_alike(std::size_t answer, const std::vector<int>& parts) const {
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

/// Whether a rule is kept when these are turned, and the object stays what it is.
bool Corrector::keeps(const std::vector<std::size_t>& answers, const Iri& iri, int region) const {
    const Conclusions& after = turned(answers);
    return mends(after, iri, region) && lost(after).empty();
}

/// Of a set whose turning keeps the rule, those that it takes.
std::vector<std::size_t> Corrector::fewest(std::vector<std::size_t> set, const Iri& iri, int region) const {
    for (std::size_t i = set.size(); i-- > 0;) {
        std::vector<std::size_t> fewer = set;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        if (!fewer.empty() && keeps(fewer, iri, region)) set = std::move(fewer);
    }
    std::ranges::sort(set);
    return set;
}

/// Corrections by answers of the explanation that leave the object all that it is; and, of a rule that is broken in
/// several ways, by all that it names of the parts to blame.
std::vector<RankedCorrection> Corrector::by_answers_of(const Iri& iri, int region, const knowledge::Explanation& why,
                                                       const std::vector<int>& blamed) const {
    std::vector<RankedCorrection> found;
    if (session_.region_count() > most_parts_tried) return found;
    const auto tell = [&](std::vector<std::size_t> set) {
        double cost = 0;
        for (const std::size_t i : set) cost += costs_[i];
        const auto is_same = [&](const RankedCorrection& each) { return each.change.answers == set; };
        if (std::ranges::none_of(found, is_same)) found.push_back({{std::move(set), cost}, {}, {}});
    };
    const std::size_t before = turned_.size();
    for (auto answer = why.answers.rbegin(); answer != why.answers.rend(); ++answer) {
        if (turned_.size() - before >= most_trials) break;
        if (keeps({*answer}, iri, region)) {
            tell({*answer});
            continue;
        }
        const std::vector<std::size_t> alike = said_alike(*answer, blamed);
        if (alike.size() > 1 && keeps(alike, iri, region)) tell(fewest(alike, iri, region));
    }
    const std::vector<const owl::Axiom*> rule = definitions_of(domain_, iri);
    std::vector<std::size_t> named;
    for (std::size_t i = 0; i < knowledge_.answers.size(); ++i)
        if (std::ranges::find(blamed, knowledge_.answers[i].region + 1) != blamed.end() && is_named_in(rule, i))
            named.push_back(i);
    if (named.size() > 1 && named.size() <= most_together && keeps(named, iri, region))
        tell(fewest(std::move(named), iri, region));
    return found;
}

bool Corrector::is_named_in(const std::vector<const owl::Axiom*>& axioms, std::size_t answer) const {
    const int variable = knowledge_.answers[answer].question.variable;
    return partonomy::is_named_in(axioms, domain_.regions.variables[static_cast<std::size_t>(variable)]);
}

std::vector<RankedCorrection> Corrector::ranked(const Iri& iri, int region, const knowledge::Explanation& why,
                                                const std::vector<int>& blamed) const {
    knowledge::ExplanationOptions options;
    options.limit = most_corrections;
    options.steps = most_steps;
    std::vector<RankedCorrection> all;
    if (!classes_.empty()) all = by_answers_of(iri, region, why, blamed);
    const std::size_t kept = all.size();
    if (region < 0)
        for (RankedCorrection& each : by_numbers_of_parts(iri)) all.push_back(std::move(each));
    for (knowledge::Correction& each : corrections(domain_, knowledge_, iri, costs_, region, options)) {
        const auto is_same = [&](const RankedCorrection& other) { return other.change.answers == each.answers; };
        if (std::any_of(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(kept), is_same)) continue;
        std::vector<Iri> gone;
        if (!classes_.empty() && session_.region_count() <= most_parts_tried) gone = lost(turned(each.answers));
        all.push_back({{std::move(each.answers), each.cost}, {}, std::move(gone)});
    }
    const auto is_innocent = [&](const RankedCorrection& each) {
        return each.change.part.empty() && std::ranges::none_of(each.change.answers, [&](std::size_t i) {
                   return std::ranges::find(blamed, knowledge_.answers[i].region + 1) != blamed.end();
               });
    };
    const std::vector<const owl::Axiom*> rule = definitions_of(domain_, iri);
    const auto is_asked_by_the_rule = [&](const RankedCorrection& each) {
        return !each.change.part.empty() ||
               std::ranges::any_of(each.change.answers, [&](std::size_t i) { return is_named_in(rule, i); });
    };
    std::erase_if(all, [](const RankedCorrection& each) { return each.change.cost >= never; });
    std::ranges::stable_sort(all, {}, [&](const RankedCorrection& each) {
        const double cost = each.change.cost;
        double off = 0;
        for (const std::size_t i : each.change.answers) off += learned_[i].off;
        return std::tuple(!each.lost.empty(), std::round(10 * cost), !is_asked_by_the_rule(each), off, cost,
                          is_innocent(each));
    });
    if (all.size() > most_corrections) all.resize(most_corrections);
    return all;
}

}  // namespace partonomy
