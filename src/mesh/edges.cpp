#include "mesh/edges.h"

#include <algorithm>

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

EdgeTable build_edges(std::span<const std::array<std::int32_t, 3>> triangles, std::size_t vertex_count) {
    std::vector<std::int32_t> begins(vertex_count + 1, 0);
    for (const auto& triangle : triangles)
        for (std::size_t e = 0; e < 3; ++e)
            ++begins[static_cast<std::size_t>(std::min(triangle[e], triangle[next_corner[e]])) + 1];
    for (std::size_t v = 0; v < vertex_count; ++v) begins[v + 1] += begins[v];

    std::vector<std::uint64_t> keys(3 * triangles.size());  // larger vertex, half-edge
    std::vector<std::int32_t> fill(begins.begin(), begins.end() - 1);
    for (std::size_t t = 0; t < triangles.size(); ++t)
        for (std::size_t e = 0; e < 3; ++e) {
            const auto [low, high] = std::minmax(triangles[t][e], triangles[t][next_corner[e]]);
            keys[static_cast<std::size_t>(fill[static_cast<std::size_t>(low)]++)] =
                static_cast<std::uint64_t>(high) << 32 | (3 * t + e);
        }

    EdgeTable table;
    table.half_edges.resize(keys.size());
    table.starts.reserve(keys.size() / 2 + 2);
    for (std::size_t v = 0; v < vertex_count; ++v) {
        const auto first = static_cast<std::size_t>(begins[v]), last = static_cast<std::size_t>(begins[v + 1]);
        sort_few({keys.data() + first, last - first});
        for (std::size_t i = first; i < last; ++i) {
            if (i == first || keys[i] >> 32 != keys[i - 1] >> 32) table.starts.push_back(static_cast<std::int32_t>(i));
            table.half_edges[i] = static_cast<std::int32_t>(keys[i] & 0xffffffffU);
        }
    }
    table.starts.push_back(static_cast<std::int32_t>(keys.size()));
    return table;
}

}  // namespace partonomy
