#pragma once

#include "shape/find_parts.h"

namespace partonomy {

/// find_parts for a scene: its pieces (scene_pieces.h), and those that are not plain cut into parts, each for itself,
/// so that a bench in a street is cut as it would be alone. All of the surface is in a region.
[[nodiscard]] std::vector<PartRegion> find_scene_parts(const TriangleMesh& mesh, const FindPartsOptions& options,
                                                       StageTimes* times);

}  // namespace partonomy
