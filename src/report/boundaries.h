#pragma once

#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// How well the borders between labels agree with true ones.
struct BoundaryScore {
    double precision = 1;  ///< fraction of the borders' length that lies near a true border
    double recall = 1;     ///< fraction of the true borders' length that lies near a border

    /// Their harmonic mean.
    [[nodiscard]] double f() const {
        return precision + recall > 0 ? 2 * precision * recall / (precision + recall) : 0;
    }
};

/// Compares where labels of neighbouring triangles differ. `labels` and `truth` have one entry per input face; a truth
/// of "" or "-" is not compared. Near means within `tolerance` times the diagonal of the mesh's bounding box. Without
/// any border on either side both fractions are 1, with borders on one side only both are 0. Throws UsageError when the
/// lengths are not the mesh's number of input faces. The measure of Martin et al. (2004), on surfaces.
[[nodiscard]] BoundaryScore compare_boundaries(const TriangleMesh& mesh, const std::vector<std::string>& labels,
                                               const std::vector<std::string>& truth, double tolerance = 0.01);

}  // namespace partonomy
