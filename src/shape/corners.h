#pragma once

#include <cstdint>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// The vertices of some triangles, each once, ascending. O(#triangles) where their numbers are close together.
[[nodiscard]] std::vector<std::int32_t> corners_of(const TriangleMesh& mesh,
                                                   const std::vector<std::int32_t>& triangles);

}  // namespace partonomy
