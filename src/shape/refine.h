#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// A mesh that was cut finer, and how.
struct Refinement {
    /// What a round did to each triangle.
    struct Round {
        std::vector<std::int32_t> begins;   ///< where its pieces begin after the round
        std::vector<std::uint8_t> pattern;  ///< bit e: edge e was halved; bit 3: which diagonal cut the quadrilateral
    };
    TriangleMesh mesh;  ///< fine; input_faces[i] is the number of the coarse triangle, pieces of one are consecutive
    std::vector<Round> rounds;

    /// The fine triangle at a point of a coarse one, which is given by its barycentric coordinates for corners 1 and 2.
    [[nodiscard]] std::int32_t piece_at(std::int32_t triangle, double u, double v) const;
};

/// The same surface with every edge at most `longest`: edges are halved, so neighbours stay neighbours.
[[nodiscard]] Refinement refine(const TriangleMesh& mesh, double longest);

/// The edge length that leaves a fine mesh of a few thousand triangles; infinity when the mesh is fine as it is.
[[nodiscard]] double refinement_length(const TriangleMesh& mesh, double size, int threads = 1);

}  // namespace partonomy
