#include "mesh/edges.h"

#include <algorithm>

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

Buckets<std::uint64_t> half_edges_of_vertices(std::span<const std::array<std::int32_t, 3>> triangles,
                                              std::size_t vertex_count, int threads) {
    auto half_edges =
        sort_into_buckets<std::uint64_t>(triangles.size(), vertex_count, threads, [&](std::size_t t, const auto& put) {
            for (std::size_t e = 0; e < 3; ++e) {
                const auto [low, high] = std::minmax(triangles[t][e], triangles[t][next_corner[e]]);
                put(low, static_cast<std::uint64_t>(high) << 32 | (3 * t + e));
            }
        });
    for_each_range(vertex_count, threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) sort_few(half_edges[v]);
    });
    return half_edges;
}

EdgeTable build_edges(std::span<const std::array<std::int32_t, 3>> triangles, std::size_t vertex_count) {
    const Buckets<std::uint64_t> half_edges = half_edges_of_vertices(triangles, vertex_count, 1);
    EdgeTable table;
    table.half_edges.reserve(3 * triangles.size());
    table.starts.reserve(3 * triangles.size() / 2 + 2);
    for (std::size_t v = 0; v < vertex_count; ++v)
        for_each_edge(half_edges[v], [&](std::span<const std::uint64_t> edge) {
            table.starts.push_back(static_cast<std::int32_t>(table.half_edges.size()));
            for (const std::uint64_t key : edge) table.half_edges.push_back(half_edge_of(key));
        });
    table.starts.push_back(static_cast<std::int32_t>(table.half_edges.size()));
    return table;
}

}  // namespace partonomy
