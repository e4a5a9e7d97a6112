#pragma once

#include <cstdint>

#include "mesh/edges.h"
#include "mesh/triangle_mesh.h"

namespace partonomy {

struct WindingReport {
    std::int64_t flipped = 0;    ///< triangles turned
    std::int64_t cavities = 0;   ///< closed shells inside another one that face inward, as the file had them
    std::int64_t one_sided = 0;  ///< patches that no winding can make agree
    std::int64_t shells = 0;     ///< sets of triangles that are connected over edges, however many share an edge
};

/// Turns triangles (by swapping their last two corners) so that neighbours agree and shells face outward, by the rules
/// that clean_mesh promises. `edges` belongs to `mesh`, and no longer does when triangles were turned.
WindingReport unify_winding(TriangleMesh& mesh, const EdgeTable& edges);

}  // namespace partonomy
