#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

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
/// triangles. threads <= 0: all cores; the table is the same on any number.
[[nodiscard]] EdgeTable build_edges(std::span<const std::array<std::int32_t, 3>> triangles, std::size_t vertex_count,
                                    int threads = 1);

/// Whether half-edge h runs from the smaller to the larger vertex index.
[[nodiscard]] inline bool runs_up(std::span<const std::array<std::int32_t, 3>> triangles, std::int32_t h) {
    const auto& triangle = triangles[static_cast<std::size_t>(h / 3)];
    return triangle[static_cast<std::size_t>(h % 3)] < triangle[static_cast<std::size_t>((h % 3 + 1) % 3)];
}

}  // namespace partonomy
