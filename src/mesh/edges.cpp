#include "mesh/edges.h"

#include <algorithm>
#include <utility>

#include "base/ranges.h"

namespace partonomy {
namespace {

constexpr std::array<std::size_t, 3> next_corner{1, 2, 0};

/// Most vertices begin a handful of edges: insertion beats the set-up of a general sort.
void sort_few(std::span<std::uint64_t> keys) {
    if (keys.size() > 24) {
        std::sort(keys.begin(), keys.end());
        return;
    }
    for (std::size_t i = 1; i < keys.size(); ++i) {
        const std::uint64_t key = keys[i];
        std::size_t j = i;
        for (; j > 0 && keys[j - 1] > key; --j) keys[j] = keys[j - 1];
        keys[j] = key;
    }
}

}  // namespace

EdgeTable build_edges(std::span<const std::array<std::int32_t, 3>> triangles, std::size_t vertex_count, int threads) {
    // With more than one thread each of two takes half of the vertices; atomic counters would gain nothing.
    const std::size_t shares = threads == 1 ? 1 : 2;
    const auto for_each_edge = [&](const auto& work) {
        for_each_range(
            shares, threads,
            [&](std::size_t begin, std::size_t end) {
                const auto from = static_cast<std::int32_t>(vertex_count * begin / shares);
                const auto to = static_cast<std::int32_t>(vertex_count * end / shares);
                for (std::size_t t = 0; t < triangles.size(); ++t)
                    for (std::size_t e = 0; e < 3; ++e) {
                        const auto [low, high] = std::minmax(triangles[t][e], triangles[t][next_corner[e]]);
                        if (from <= low && low < to) work(static_cast<std::size_t>(low), high, 3 * t + e);
                    }
            },
            1);
    };
    std::vector<std::int32_t> fill(vertex_count + 1, 0);
    for_each_edge([&](std::size_t low, std::int32_t, std::size_t) { ++fill[low]; });
    std::int32_t sum = 0;
    for (std::int32_t& begin : fill) sum += std::exchange(begin, sum);
    std::vector<std::uint64_t> keys(3 * triangles.size());  // larger vertex, half-edge
    for_each_edge([&](std::size_t low, std::int32_t high, std::size_t half_edge) {
        keys[static_cast<std::size_t>(fill[low]++)] = static_cast<std::uint64_t>(high) << 32 | half_edge;
    });
    // Now each vertex's edges end where `fill` says, and begin where those of the vertex before it end.
    EdgeTable table;
    table.half_edges.resize(keys.size());
    for_each_range(vertex_count, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            const auto first = static_cast<std::size_t>(v > 0 ? fill[v - 1] : 0);
            const auto last = static_cast<std::size_t>(fill[v]);
            sort_few({keys.data() + first, last - first});
            for (std::size_t i = first; i < last; ++i)
                table.half_edges[i] = static_cast<std::int32_t>(keys[i] & 0xffffffffU);
        }
    });
    table.starts.reserve(keys.size() / 2 + 2);
    std::size_t first = 0;
    for (std::size_t v = 0; v < vertex_count; ++v) {
        const auto last = static_cast<std::size_t>(fill[v]);
        for (std::size_t i = first; i < last; ++i)
            if (i == first || keys[i] >> 32 != keys[i - 1] >> 32) table.starts.push_back(static_cast<std::int32_t>(i));
        first = last;
    }
    table.starts.push_back(static_cast<std::int32_t>(keys.size()));
    return table;
}

}  // namespace partonomy
