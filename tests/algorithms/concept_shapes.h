#pragma once

#include <memory>
#include <string>
#include <vector>

#include "mesh/appearance.h"
#include "mesh/triangle_mesh.h"

// Shapes made by code, and which elementary concepts of core.ttl they are known to be by construction.

namespace partonomy {

struct KnownShape {
    std::string name;
    TriangleMesh mesh;                ///< metres, z up
    std::vector<std::string> is;      ///< concepts; so it is none of the other values of their range concepts
    std::vector<std::string> border;  ///< concepts whose border it is on: about as likely as not
    std::size_t region = 0;           ///< how many triangles from the first one on are asked about; 0: all
    std::shared_ptr<const Appearance> appearance = nullptr;
};

/// By box, orientation, form, symmetry and kind of surface.
[[nodiscard]] std::vector<KnownShape> shapes_by_form();
/// By where they are in an object, and by height in metres.
[[nodiscard]] std::vector<KnownShape> shapes_by_place();
/// By colour, finish and pattern.
[[nodiscard]] std::vector<KnownShape> shapes_by_paint();

}  // namespace partonomy
