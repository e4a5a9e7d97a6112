#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/buckets.h"

namespace partonomy {

/// The half-edges of a mesh, those of one edge beside each other. Half-edge 3 t + e is edge e of triangle t.
struct EdgeTable {
    std::vector<std::int32_t> half_edges;  ///< by smaller vertex, then larger vertex, then number
    std::vector<std::int32_t> starts;      ///< #E + 1 offsets into half_edges
    [[nodiscard]] std::size_t size() const { return starts.size() - 1; }
    [[nodiscard]] std::span<const std::int32_t> operator[](std::size_t edge) const {
        return {half_edges.data() + starts[edge], half_edges.data() + starts[edge + 1]};
    }
};

/// A counting sort by the smaller vertex, then a small sort for each vertex: O(#V + #T log valence). At most 2^31 / 3
/// triangles.
[[nodiscard]] EdgeTable build_edges(std::span<const std::array<std::int32_t, 3>> triangles, std::size_t vertex_count);

/// For those who need each edge but once: the half-edges by their smaller vertex, as keys that begin with the larger
/// one, sorted. threads <= 0: all cores; the same on any number.
[[nodiscard]] Buckets<std::uint64_t> half_edges_of_vertices(std::span<const std::array<std::int32_t, 3>> triangles,
                                                            std::size_t vertex_count, int threads);

[[nodiscard]] inline std::int32_t half_edge_of(std::uint64_t key) {
    return static_cast<std::int32_t>(key & 0xffffffffU);
}

/// Calls work(keys) for each edge among the sorted keys of a vertex.
template <class Work>
void for_each_edge(std::span<const std::uint64_t> keys, const Work& work) {
    for (std::size_t first = 0, last = 0; first < keys.size(); first = last) {
        while (last < keys.size() && keys[last] >> 32 == keys[first] >> 32) ++last;
        work(keys.subspan(first, last - first));
    }
}

/// Whether half-edge h runs from the smaller to the larger vertex index.
[[nodiscard]] inline bool runs_up(std::span<const std::array<std::int32_t, 3>> triangles, std::int32_t h) {
    const auto& triangle = triangles[static_cast<std::size_t>(h / 3)];
    return triangle[static_cast<std::size_t>(h % 3)] < triangle[static_cast<std::size_t>((h % 3 + 1) % 3)];
}

}  // namespace partonomy
