// Pieces of one box that noise tore apart.
//
// Waves along a wall change the thickness of a part by as much as they are high, so the core of a thin leg ends where
// it grows thin and another one begins. Kinds, thicknesses and axes of such pieces say little. What says more is
// whether one box accounts for both: nearly all of their surface lies on its sides, no farther than noise reaches, and
// makes up nearly all of them. A dent that noise could have made is no border (minimum description length: one box
// instead of two, unless the second explains something).
//
// Cost: O(n), and one box of some hundred triangles a part and a border.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <set>
#include <utility>

#include "base/ranges.h"
#include "shape/claims.h"
#include "shape/wall_box.h"

namespace partonomy {

namespace {

constexpr double least_cover = 0.8, most_cover = 1.3;  // surface of the two over that of their box
constexpr double some_of_it = 0.5;  // of each may lie farther from the common box than noise reaches: where it is torn

/// How much of a part is farther than `limit` from the sides of a box that holds it and another one.
double share_beyond(const Boxed& both, const Boxed& part, double limit) {
    double all = 0, out = 0;
    for (std::size_t k = 0; k < both.some.size(); ++k) {
        if (!std::ranges::binary_search(part.some, both.some[k])) continue;
        const auto& [distance, area] = both.distances[k];
        all += area;
        if (distance > limit) out += area;
    }
    return all > 0 ? out / all : 1;
}

/// Two parts in one box.
struct Union {
    Boxed both;
    double beyond = 1;  ///< share of the part that it suits less that is farther from it than noise reaches
};

Union join(const Surface& s, const Boxed& a, const Boxed& b, double limit) {
    Union result{put_in_one_box(s, a, b)};
    const double cover = result.both.area / result.both.box.area();
    if (cover > least_cover && cover < most_cover)
        result.beyond = std::max(share_beyond(result.both, a, limit), share_beyond(result.both, b, limit));
    return result;
}

using Pair = std::pair<std::int32_t, std::int32_t>;

}  // namespace

void rejoin_torn_parts(const Surface& s, Parts& parts) {
    std::set<Pair> borders = meeting_groups(s.adjacency, parts.part_of, s.threads);
    if (borders.empty()) return;
    std::vector<Boxed> boxed = boxes_of_parts(s, parts.part_of, parts.parts.size());
    const double limit = reach_of_noise(boxed);
    std::map<Pair, Union> unions;
    for (;;) {
        std::vector<Pair> untried;
        std::ranges::copy_if(borders, std::back_inserter(untried), [&](Pair pair) { return !unions.contains(pair); });
        std::vector<Union> tried(untried.size());
        for_each_range(
            untried.size(), s.threads,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k)
                    tried[k] = join(s, boxed[untried[k].first], boxed[untried[k].second], limit);
            },
            1);
        for (std::size_t k = 0; k < untried.size(); ++k) unions.emplace(untried[k], std::move(tried[k]));
        const auto best = std::ranges::min_element(unions, {}, [](const auto& entry) { return entry.second.beyond; });
        if (best == unions.end() || best->second.beyond > some_of_it) return;
        std::int32_t to = best->first.first, from = best->first.second;
        if (boxed[to].area < boxed[from].area) std::swap(to, from);
        for_each_range(s.count(), s.threads, [&](std::size_t begin, std::size_t end) {
            std::replace(parts.part_of.begin() + begin, parts.part_of.begin() + end, from, to);
        });
        boxed[to] = std::move(best->second.both);
        std::set<Pair> left;
        for (auto [a, b] : borders) {
            if (a == from) a = to;
            if (b == from) b = to;
            if (a != b) left.insert(std::minmax(a, b));
        }
        borders = std::move(left);
        std::erase_if(unions, [&](const auto& entry) {
            const auto [a, b] = entry.first;
            return a == to || a == from || b == to || b == from;
        });
    }
}

}  // namespace partonomy
