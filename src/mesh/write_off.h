#pragma once

#include <string>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// The mesh as the text of an OFF file, one face a triangle. Coordinates take the fewest digits that read back to the
/// same double.
[[nodiscard]] std::string to_off(const TriangleMesh& mesh);

}  // namespace partonomy
