#include "knowledge/correction_search.h"

#include <algorithm>
#include <numeric>
#include <queue>
#include <stdexcept>
#include <tuple>

// Sets of answers come off a queue by ascending cost, then size, then place. Each set has two successors, with the
// answers in the order of their costs: one more answer, the next after its last; or that one instead of its last. So
// every set is met once and never before a cheaper one. A set is tried by turning its answers round and drawing the
// conclusions, which takes microseconds; sets around one that was found are passed over.

namespace partonomy::knowledge {
namespace {

constexpr std::size_t most_tries = 512;

struct Candidate {
    double cost;
    std::vector<std::size_t> places;  ///< in the order of costs, ascending
    auto key() const { return std::tuple(cost, places.size(), std::cref(places).get()); }
    bool operator<(const Candidate& other) const { return key() > other.key(); }  // the queue gives the largest first
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
    goal_ = {std::vector<ConfigurationSet>(known.regions.size(), domain.regions.none()), domain.objects.none()};
    if (const auto id = concept_iri.empty() ? std::nullopt : domain.objects.find(concept_iri))
        if (const auto& where = domain.objects.concepts[*id].where; is_in(domain.objects, known.object, where)) {
            goal_.objects = where;
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
    for (const Concept& each : domain.objects.concepts)
        if (each.incompatible && !is_in(domain.objects, known.object, each.where)) all_.objects |= each.where;
    for (const Concept& each : domain.regions.concepts)
        for (std::size_t r = 0; r < known.regions.size(); ++r)
            if (each.incompatible && !is_in(domain.regions, known.regions[r], each.where))
                all_.regions[r] |= each.where;
}

bool CorrectionSearch::mends(const std::vector<std::size_t>& set, const Unwanted& unwanted) {
    for (const std::size_t i : set) changed_.answers[i].yes = !changed_.answers[i].yes;
    const Conclusions what = conclude(domain_, changed_);
    for (const std::size_t i : set) changed_.answers[i].yes = !changed_.answers[i].yes;
    if (what.contradiction || what.object.is_subset_of(unwanted.objects)) return false;
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

std::vector<Correction> CorrectionSearch::search(std::size_t limit, const Unwanted& unwanted) {
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
