#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// The solids of a mesh that is made of several: per triangle the number of its shell (a set of triangles connected
/// over edges) when that is closed, faces outward and holds something; -1 else, as for sheets and cavities. Empty when
/// there are fewer than two. O(#T).
[[nodiscard]] std::vector<std::int32_t> find_solids(const TriangleMesh& mesh, const Adjacency& adjacency,
                                                    int threads = 1);

}  // namespace partonomy
