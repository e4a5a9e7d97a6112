#pragma once

#include <cstdint>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "base/buckets.h"
#include "base/ranges.h"
#include "mesh/triangle_mesh.h"
#include "shape/sets.h"

namespace partonomy {

/// Triangles in numbered pieces.
struct Pieces {
    std::vector<std::int32_t> piece_of;  ///< of each triangle; -1: in none
    std::vector<std::int32_t> lowest;    ///< triangle of each piece, ascending
    [[nodiscard]] std::size_t size() const { return lowest.size(); }
};

/// Numbers sets by their lowest triangle; sets of triangles that are not `is_in` have no number. The same on any number
/// of threads.
template <class IsIn>
[[nodiscard]] Pieces number_sets(Sets& sets, std::size_t count, int threads, const IsIn& is_in) {
    const auto roots = map_blocks(count, threads, [&](std::size_t begin, std::size_t end) {
        std::vector<std::int32_t> found;
        for (auto i = static_cast<std::int32_t>(begin); i < static_cast<std::int32_t>(end); ++i)
            if (is_in(i) && sets.find(i) == i) found.push_back(i);
        return found;
    });
    Pieces pieces{std::vector<std::int32_t>(count, -1), {}};
    for (const std::vector<std::int32_t>& found : roots)
        for (const std::int32_t i : found) {
            pieces.piece_of[i] = static_cast<std::int32_t>(pieces.lowest.size());
            pieces.lowest.push_back(i);
        }
    for_each_range(count, threads, [&](std::size_t begin, std::size_t end) {
        for (auto i = static_cast<std::int32_t>(begin); i < static_cast<std::int32_t>(end); ++i)
            if (const std::int32_t root = sets.find(i); root != i && is_in(i))
                pieces.piece_of[i] = pieces.piece_of[root];
    });
    return pieces;
}

/// Pieces that hang together over edges between triangles that are alike(i, j); a triangle that is not alike(i, i) is
/// in none. O(n).
template <class Alike>
[[nodiscard]] Pieces find_pieces(const Adjacency& adjacency, int threads, const Alike& alike) {
    const std::size_t count = adjacency.neighbours.size();
    Sets sets(count);
    for_each_range(count, threads, [&](std::size_t begin, std::size_t end) {
        for (auto i = static_cast<std::int32_t>(begin); i < static_cast<std::int32_t>(end); ++i)
            for (const std::int32_t j : adjacency.neighbours[i])
                if (j > i && alike(i, j)) sets.join(i, j);
    });
    return number_sets(sets, count, threads, [&](std::int32_t i) { return alike(i, i); });
}

/// The members of numbered groups, ascending.
using Groups = Buckets<std::int32_t>;

/// Who is in which of so many groups; `group_of` tells the group of each, -1 for none. O(n).
[[nodiscard]] inline Groups group_members(std::span<const std::int32_t> group_of, std::size_t groups, int threads) {
    return sort_into_buckets<std::int32_t>(group_of.size(), groups, threads, [&](std::size_t i, const auto& put) {
        if (group_of[i] >= 0) put(group_of[i], static_cast<std::int32_t>(i));
    });
}

/// Pairs of groups that meet over an edge, the lower number first. O(n).
[[nodiscard]] inline std::set<std::pair<std::int32_t, std::int32_t>> meeting_groups(
    const Adjacency& adjacency, std::span<const std::int32_t> group_of, int threads) {
    using Pairs = std::set<std::pair<std::int32_t, std::int32_t>>;
    const auto of_blocks = map_blocks(group_of.size(), threads, [&](std::size_t begin, std::size_t end) {
        Pairs pairs;
        std::pair<std::int32_t, std::int32_t> last(-1, -1);  // most pairs come again and again
        for (std::size_t i = begin; i < end; ++i) {
            const std::int32_t own = group_of[i];
            if (own < 0) continue;
            for (const std::int32_t j : adjacency.neighbours[i])
                if (j >= 0 && group_of[j] > own && last != std::pair(own, group_of[j]))
                    pairs.insert(last = {own, group_of[j]});
        }
        return pairs;
    });
    Pairs all;
    for (const Pairs& some : of_blocks) all.insert(some.begin(), some.end());
    return all;
}

}  // namespace partonomy
