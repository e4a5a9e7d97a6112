#pragma once

#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// A mesh with what there is to know about it. Triangle i is face i of the file that is written from it.
struct ExampleObject {
    std::string name;
    TriangleMesh mesh;                ///< one closed surface facing outward, z up, metres, on the ground z = 0
    std::vector<std::string> labels;  ///< per triangle: local name of the part's concept, such as Seat or Leg
    std::vector<int> parts;           ///< per triangle: number of its part, 0 .. part_count - 1
    int part_count = 0;
    std::string object_class;     ///< local name of the most specific object concept
    std::string incompatibility;  ///< local name of the diagnosis that must be given; empty for a sound object
};

/// The seven objects of the paper's Table 1, in its order, with its numbers of parts and triangles. Where they differ
/// from the paper's own meshes, which are not published, is told in objects.cpp.
[[nodiscard]] std::vector<ExampleObject> paper_objects();

/// A chair whose backrest carries a headrest on two short posts; `object_class` is HeadrestChair of
/// furniture-headrest.omn. Without `has_backrest` the posts of the seat carry the headrest itself, which that ontology
/// forbids (HeadrestWithoutBackrest).
[[nodiscard]] ExampleObject headrest_chair(bool has_backrest = true);

/// One of the seven: bench, bench2, chair, chair2, couch, curved-bench or strange-object2. Throws UsageError otherwise.
[[nodiscard]] ExampleObject paper_object(const std::string& name);

}  // namespace partonomy
