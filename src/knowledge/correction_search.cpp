#include "knowledge/correction_search.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <tuple>

#include "knowledge/assembly.h"

// Sets of answers come off a queue by ascending cost, then size, then place. Each set has two successors, with the
// answers in the order of their costs: one more answer, the next after its last; or that one instead of its last. So
// every set is met once and never before a cheaper one. A set is tried by turning its answers round and asking what the
// object may be then (object_test.h), of the regions that they are about anew; that takes a microsecond or two. Sets
// around one that was found are passed over.

namespace partonomy::knowledge {
namespace {

constexpr std::size_t most_tries = 512;

struct Candidate {
    double cost;
    std::vector<std::size_t> places;                ///< in the order of costs, ascending
    bool operator<(const Candidate& other) const {  // the queue gives the largest first
        const std::size_t size = places.size(), other_size = other.places.size();
        return std::tie(cost, size, places) > std::tie(other.cost, other_size, other.places);
    }
};

bool is_in(const Space& space, const ConfigurationSet& set, const ConfigurationSet& where) {
    return space.size > 0 && !set.is_empty() && set.is_subset_of(where);
}

}  // namespace

CorrectionSearch::CorrectionSearch(const Domain& domain, const Knowledge& knowledge, const Iri& concept_iri,
                                   const std::vector<double>& costs, int region)
    : domain_(domain), changed_(knowledge), costs_(costs), cheapest_first_(costs.size()) {
    std::iota(cheapest_first_.begin(), cheapest_first_.end(), std::size_t{0});
    std::ranges::stable_sort(cheapest_first_, {}, [&](std::size_t i) { return costs[i]; });
    const Conclusions known = conclude(domain, knowledge);
    bool is_there = concept_iri.empty() && known.contradiction;
    goal_.regions.assign(known.regions.size(), domain.regions.none());
    const Space& objects = *known.objects;
    if (const auto id = concept_iri.empty() ? std::nullopt : objects.find(concept_iri))
        if (is_in(objects, known.object, objects.concepts[*id].where)) {
            goal_.objects = {concept_iri};
            is_there = true;
        }
    if (const auto id = concept_iri.empty() ? std::nullopt : domain.regions.find(concept_iri))
        for (std::size_t r = 0; r < known.regions.size(); ++r)
            if (const auto& where = domain.regions.concepts[*id].where;
                (region < 0 ? !is_there : region == static_cast<int>(r)) &&
                is_in(domain.regions, known.regions[r], where)) {
                goal_.regions[r] = where;
                is_there = true;
            }
    if (!is_there && is_entailed_of_a_composite(known, concept_iri)) {
        goal_.concepts = {concept_iri};
        is_there = true;
    }
    if (!is_there) throw std::invalid_argument("corrections: " + concept_iri + " does not follow from what is known");
    all_ = goal_;
    for (const CompositeSpace& composite : domain.composites)
        for (const Concept& each : composite.space.concepts)
            if (each.incompatible && !is_entailed_of_a_composite(known, each.iri)) all_.concepts.push_back(each.iri);
    for (const Concept& each : objects.concepts)
        if (each.incompatible && !is_in(objects, known.object, each.where)) all_.objects.push_back(each.iri);
    for (const Concept& each : domain.regions.concepts)
        for (std::size_t r = 0; r < known.regions.size(); ++r)
            if (each.incompatible && !is_in(domain.regions, known.regions[r], each.where))
                all_.regions[r] |= each.where;
    goal_ = with_test(std::move(goal_), known);
    all_ = with_test(std::move(all_), known);
    answers_of_.resize(known.regions.size());
    for (std::size_t i = 0; i < knowledge.answers.size(); ++i) {
        holds_.push_back(yes_set(domain.regions, knowledge.answers[i].question));
        answers_of_[knowledge.answers[i].region].push_back(i);
    }
}

CorrectionSearch::Unwanted CorrectionSearch::with_test(Unwanted unwanted, const Conclusions& known) const {
    if (!unwanted.concepts.empty()) return unwanted;
    std::vector<int> goals;
    for (const Iri& iri : unwanted.objects) goals.push_back(domain_.grounding->theory.find(iri));
    unwanted.test = ObjectTest::about(domain_, goals);
    for (std::size_t r = 0; unwanted.test && r < known.regions.size(); ++r)  // the empty set is a subset, too
        unwanted.types.push_back(
            known.regions[r].is_subset_of(unwanted.regions[r]) ? 0 : unwanted.test->types_of(known.regions[r]));
    unwanted.turned.resize(costs_.size());
    return unwanted;
}

bool CorrectionSearch::mends(const std::vector<std::size_t>& set, Unwanted& unwanted) {
    for (const std::size_t i : set) changed_.answers[i].yes = !changed_.answers[i].yes;
    const bool result = unwanted.test ? mends_by_test(set, unwanted) : mends_by_conclusions(unwanted);
    for (const std::size_t i : set) changed_.answers[i].yes = !changed_.answers[i].yes;
    return result;
}

ObjectTest::Types CorrectionSearch::types_now(int region, const Unwanted& unwanted) const {
    ConfigurationSet set = domain_.regions.all();
    for (const std::size_t i : answers_of_[region])
        if (changed_.answers[i].yes)
            set &= holds_[i];
        else
            set -= holds_[i];
    return set.is_subset_of(unwanted.regions[region]) ? 0 : unwanted.test->types_of(set);
}

bool CorrectionSearch::mends_by_test(const std::vector<std::size_t>& set, Unwanted& unwanted) const {
    std::vector<ObjectTest::Types> types = unwanted.types;
    for (const std::size_t i : set) {
        const int region = changed_.answers[i].region;
        const bool is_alone =
            std::ranges::count(set, region, [&](std::size_t k) { return changed_.answers[k].region; }) == 1;
        if (is_alone) {
            std::optional<ObjectTest::Types>& turned = unwanted.turned[i];
            if (!turned) turned = types_now(region, unwanted);
            types[region] = *turned;
        } else {
            types[region] = types_now(region, unwanted);
        }
    }
    if (std::ranges::find(types, ObjectTest::Types{0}) != types.end()) return false;
    return unwanted.test->ask(std::move(types), changed_.complete).other;
}

bool CorrectionSearch::mends_by_conclusions(const Unwanted& unwanted) const {
    const Conclusions what = conclude(domain_, changed_);
    if (what.contradiction) return false;
    ConfigurationSet unwanted_objects = what.objects->none();
    for (const Iri& iri : unwanted.objects) unwanted_objects |= what.objects->concepts[*what.objects->find(iri)].where;
    if (what.object.is_subset_of(unwanted_objects)) return false;
    for (std::size_t r = 0; r < what.regions.size(); ++r)
        if (what.regions[r].is_subset_of(unwanted.regions[r])) return false;
    return std::ranges::none_of(unwanted.concepts,
                                [&](const Iri& iri) { return is_entailed_of_a_composite(what, iri); });
}

bool CorrectionSearch::is_entailed_of_a_composite(const Conclusions& what, const Iri& iri) const {
    return std::ranges::any_of(what.composites, [&](const CompositePart& composite) {
        const Space& space = domain_.composites[static_cast<std::size_t>(composite.group)].space;
        const std::optional<ConceptId> id = space.find(iri);
        return id && is_in(space, composite.possible, space.concepts[*id].where);
    });
}

std::vector<Correction> CorrectionSearch::search(std::size_t limit, Unwanted& unwanted) {
    std::vector<Correction> found;
    std::priority_queue<Candidate> queue;
    const auto push = [&](double cost, std::vector<std::size_t> places) {
        cost += costs_[cheapest_first_[places.back()]];
        queue.push({cost, std::move(places)});
    };
    if (!costs_.empty()) push(0, {0});
    is_cut_short_ = false;
    for (std::size_t tries = 0; !queue.empty() && found.size() < limit;) {
        const auto [cost, places] = queue.top();
        queue.pop();
        std::vector<std::size_t> set;
        for (const std::size_t place : places) set.push_back(cheapest_first_[place]);
        std::ranges::sort(set);
        bool holds_one_found = std::ranges::any_of(
            found, [&](const Correction& each) { return std::ranges::includes(set, each.answers); });
        if (!holds_one_found) {
            if (tries++ == most_tries) {
                is_cut_short_ = true;
                break;
            }
            if (mends(set, unwanted)) {
                found.push_back({std::move(set), cost});
                holds_one_found = true;
            }
        }
        const std::size_t next = places.back() + 1;
        if (next == costs_.size()) continue;
        std::vector<std::size_t> other = places;
        other.back() = next;
        push(cost - costs_[cheapest_first_[places.back()]], std::move(other));
        if (holds_one_found) continue;
        std::vector<std::size_t> more = places;
        more.push_back(next);
        push(cost, std::move(more));
    }
    return found;
}

std::vector<Correction> CorrectionSearch::run(std::size_t limit) {
    std::vector<Correction> found = search(limit, all_);
    return found.empty() ? search(limit, goal_) : found;
}

}  // namespace partonomy::knowledge
