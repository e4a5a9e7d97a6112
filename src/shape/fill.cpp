// Who gets what is left: fillets, the ends of legs, small bits between parts.
//
// All parts grow over the free triangles at once, along the surface, nearest first (Dijkstra). A step over a concave
// bend is long, in proportion to the part's thickness. Between exact planes a board hardly grows out of its slab along
// a flat face. Ties go by triangle number. Noise leaves one piece that holds most of what is free, over which growing
// goes in one order only; so how far it is over each edge is measured first, on all threads, and growing finds all that
// it needs of a triangle in one place. Free pieces that do not touch are filled side by side. Cost: O(m log m) for m
// free triangles.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

#include "base/ranges.h"
#include "shape/claims.h"

namespace partonomy {

namespace {

constexpr double outside_exact = 20, flat_turn = 1e-4;
constexpr double concave = 5;  // thicknesses that a right angle inward is long

/// A free triangle, by its place among the free ones.
struct Place {
    std::array<std::int32_t, 3> next;  ///< place across each edge, or see part_number()
    float best;                        ///< cost of the best way, rounded up, so that ties stay; settled: < 0
    std::array<double, 3> length;      ///< from barycentre to barycentre
    std::array<double, 3> bend;        ///< what crossing the edge costs, in thicknesses; 0: not concave

    static constexpr std::int32_t nothing = -1;
    /// Parts that are there already are told by numbers below `nothing`; the same both ways.
    static std::int32_t part_number(std::int32_t part) { return nothing - 1 - part; }
};

struct Step {
    double cost;
    std::int32_t place;
    std::int32_t part;
    bool operator>(const Step& other) const {
        if (cost != other.cost) return cost > other.cost;
        return place != other.place ? place > other.place : part > other.part;
    }
};

/// Steps by cost, none less than the last one taken (a radix heap; Ahuja, Mehlhorn, Orlin and Tarjan 1990): each lies
/// in the bucket of the highest bit in which its cost differs from that one's. A common heap took most of the time.
class Steps {
public:
    void push(const Step& step) {
        const auto bucket = static_cast<std::size_t>(std::bit_width(bits(step) ^ last_));
        buckets_[bucket].push_back(step);
        if (bucket == 0)
            std::push_heap(buckets_[0].begin(), buckets_[0].end(), std::greater<>());
        else
            used_ |= std::uint64_t{1} << bucket;
    }

    std::optional<Step> pop() {
        std::vector<Step>& cheapest = buckets_[0];  // all of one cost
        if (cheapest.empty()) {
            if (used_ == 0) {
                last_ = 0;
                return std::nullopt;
            }
            std::vector<Step>& next = buckets_[static_cast<std::size_t>(std::countr_zero(used_))];
            used_ &= used_ - 1;
            last_ = bits(std::ranges::min(next, {}, &Step::cost));
            for (const Step& step : next) push(step);
            next.clear();
        }
        std::pop_heap(cheapest.begin(), cheapest.end(), std::greater<>());
        const Step step = cheapest.back();
        cheapest.pop_back();
        return step;
    }

private:
    /// Of numbers that are not negative, bits are in the order of values.
    static std::uint64_t bits(const Step& step) { return std::bit_cast<std::uint64_t>(step.cost); }

    std::array<std::vector<Step>, 64> buckets_;
    std::uint64_t used_ = 0;  ///< buckets that hold something, but the first
    std::uint64_t last_ = 0;
};

double turn_between(const Surface& s, std::int32_t i, std::int32_t j) {
    return 1 - s.geometry.normals[i].dot(s.geometry.normals[j]);
}

/// All free triangles, those of a piece beside each other and ascending.
std::unique_ptr<Place[]> find_places(const Surface& s, const Groups& free_pieces, const Parts& parts) {
    const auto count = static_cast<std::size_t>(free_pieces.begins.back());
    auto places = std::make_unique_for_overwrite<Place[]>(count);
    const auto place_of = std::make_unique_for_overwrite<std::int32_t[]>(s.count());
    for_each_range(count, s.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) place_of[free_pieces.items[k]] = static_cast<std::int32_t>(k);
    });
    const auto measure = [&](std::int32_t i) {
        constexpr std::int32_t nothing = Place::nothing;
        Place place{{nothing, nothing, nothing}, std::numeric_limits<float>::infinity(), {}, {}};
        for (std::size_t e = 0; e < 3; ++e) {
            const std::int32_t j = s.adjacency.neighbours[i][e];
            if (j < 0) continue;
            const std::int32_t part = parts.part_of[j];
            place.next[e] = part < 0 ? place_of[j] : Place::part_number(part);
            const Vec3 way = s.geometry.barycentres[j] - s.geometry.barycentres[i];
            place.length[e] = way.norm();
            if (way.dot(s.geometry.normals[i] - s.geometry.normals[j]) > 0)
                place.bend[e] = concave * turn_between(s, i, j);
        }
        return place;
    };
    for_each_range(count, s.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k)
            if (const std::int32_t i = free_pieces.items[k]; parts.part_of[i] < 0) places[k] = measure(i);
    });
    return places;
}

/// Lets parts grow over one free piece after the other.
class Growth {
public:
    Growth(const Surface& surface, std::span<const std::int32_t> triangles, Place* places, Parts& parts)
        : s_(surface), triangles_(triangles), places_(places), parts_(parts) {}

    void over(std::int32_t begin, std::int32_t end) {
        for (std::int32_t k = begin; k < end; ++k)
            for (std::size_t e = 0; e < 3; ++e)
                if (const std::int32_t next = places_[k].next[e]; next < Place::nothing)
                    reach(Place::part_number(next), s_.adjacency.neighbours[triangles_[k]][e], k, e, k, 0);
        while (const std::optional<Step> step = steps_.pop()) {
            Place& place = places_[step->place];
            if (std::exchange(place.best, -1.0F) < 0) continue;
            parts_.part_of[triangles_[step->place]] = step->part;
            for (std::size_t e = 0; e < 3; ++e)
                if (const std::int32_t next = place.next[e]; next >= 0)
                    reach(step->part, triangles_[step->place], step->place, e, next, step->cost);
        }
    }

private:
    /// From triangle `from` of a part to the one at place `to`, over an edge that is told at a place.
    void reach(std::int32_t number, std::int32_t from, std::int32_t place, std::size_t edge, std::int32_t to,
               double cost) {
        const Core& part = parts_.parts[number];
        const double length = places_[place].length[edge], bend = places_[place].bend[edge];
        const double crease = bend != 0 ? bend * part.thickness : 0;
        const bool is_outside = part.is_exact && lies_outside(part, from, triangles_[to]);
        const double total = cost + (is_outside ? outside_exact : 1) * length + crease;
        float& best = places_[to].best;
        if (!(total <= static_cast<double>(best))) return;
        best = std::nextafter(static_cast<float>(total), std::numeric_limits<float>::infinity());
        steps_.push({total, to, number});
    }

    [[nodiscard]] bool lies_outside(const Core& board, std::int32_t from, std::int32_t j) const {
        const double u = (s_.geometry.barycentres[j] - board.middle).dot(board.normal);
        return std::abs(u) > 1.05 * board.half && turn_between(s_, from, j) < flat_turn;
    }

    const Surface& s_;
    std::span<const std::int32_t> triangles_;  ///< by place
    Place* places_;
    Parts& parts_;
    Steps steps_;
};

}  // namespace

void fill(const Surface& s, const Groups& free_pieces, Parts& parts) {
    const auto places = find_places(s, free_pieces, parts);
    // Parts are all around a piece, so pieces know nothing of each other. Large ones come first, each by itself; of
    // small ones many are a piece of work, and there are so few of these that threads take them one by one.
    std::vector<std::size_t> order;
    std::size_t all = 0;
    for (std::size_t k = 0; k < free_pieces.size(); ++k)
        if (parts.part_of[free_pieces[k].front()] < 0) {
            order.push_back(k);
            all += free_pieces[k].size();
        }
    const std::size_t enough_work = std::max<std::size_t>(1024, all / 8);
    std::ranges::stable_sort(order, std::greater<>(), [&](std::size_t k) { return free_pieces[k].size(); });
    std::vector<std::size_t> starts;  // of work
    for (std::size_t k = 0, work = enough_work; k < order.size(); ++k) {
        if (work >= enough_work) starts.push_back(k), work = 0;
        work += free_pieces[order[k]].size();
    }
    starts.push_back(order.size());
    const std::span<const std::int32_t> triangles(free_pieces.items.get(), free_pieces.begins.back());
    for_each_range(
        starts.size() - 1, s.threads,
        [&](std::size_t begin, std::size_t end) {
            Growth growth(s, triangles, places.get(), parts);
            for (std::size_t k = starts[begin]; k < starts[end]; ++k)
                growth.over(free_pieces.begins[order[k]], free_pieces.begins[order[k] + 1]);
        },
        1);
}

}  // namespace partonomy
