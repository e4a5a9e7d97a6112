#pragma once

#include <cstdint>

#include "mesh/edges.h"
#include "mesh/triangle_mesh.h"

namespace partonomy {

/// Cuts triangles where an open edge of theirs meets a row of shorter open edges on its other side, from end to end, so
/// that the surface closes there. Only such rows count: sheets that merely come near stay as they are. New triangles
/// take the place of the one that was cut and keep its input face; no vertex is made or moved. Returns how many edges
/// were cut; `edges` belongs to `mesh`, and no longer does when there were any. O(#open edges) but for their sort.
std::int64_t cut_at_t_junctions(TriangleMesh& mesh, const EdgeTable& edges);

}  // namespace partonomy
