#pragma once

#include <cstdint>
#include <vector>

#include "shape/surface.h"

namespace partonomy {

/// Keeps the largest piece of each part, with those that are one with it through the solid, and gives the others to the
/// neighbour with the longest common border. Large pieces that are solids of their own become parts, and so do pieces
/// without a neighbour (separate shells) and shells in which no part was found: they may be sheets.
/// `part_of`: of the triangles of `mesh`, the surface's own or the caller's coarser one; new parts get the numbers
/// after the last. O(#T) a round, at most 8 rounds.
void connect(const Surface& s, const TriangleMesh& mesh, const Adjacency& adjacency, const TriangleGeometry& geometry,
             std::vector<std::int32_t>& part_of);

}  // namespace partonomy
