#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "expert/annotation.h"
#include "mesh/triangle_mesh.h"

namespace partonomy {

/// The colour a part is drawn in: its own, or one of a fixed palette by its id. RGB, 0..255.
[[nodiscard]] std::array<std::uint8_t, 3> color_of(const AnnotatedPart& part);

/// What triangles without a part are drawn in.
inline constexpr std::array<std::uint8_t, 3> unlabelled_color{190, 190, 190};

/// labels.txt: one line per input face, the concept's local name or "-".
[[nodiscard]] std::string to_labels(const Annotation& annotation);

/// annotation.json (schema in docs/annotation.md).
[[nodiscard]] std::string to_json(const Annotation& annotation);

/// Binary little-endian PLY: one face per triangle, with colours, integer properties `label` (index into the header's
/// "comment label i Name" lines, 0 for none), `part`, `input_face`, and float `score`.
[[nodiscard]] std::string to_ply(const TriangleMesh& mesh, const Annotation& annotation);

/// Binary glTF 2.0 with one named node, mesh and material per part ("Seat", "Leg 2" …), y up.
[[nodiscard]] std::string to_glb(const TriangleMesh& mesh, const Annotation& annotation, const Vec3& up);

struct PreviewOptions {
    int width = 480, height = 360;  ///< pixels
    int threads = 1;
};

/// A PNG picture of the object in its parts' colours with a legend of names and scores; needs no display.
[[nodiscard]] std::string to_png(const TriangleMesh& mesh, const Annotation& annotation, const Vec3& up,
                                 const PreviewOptions& options = {});

/// The questions and answers as text, like the paper's Fig. 13 and 14, with the conclusion at the end.
[[nodiscard]] std::string to_trace(const Annotation& annotation);

}  // namespace partonomy
