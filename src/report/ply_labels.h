#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace partonomy {

/// The integer face properties of a PLY file that say what a face is.
struct PlyLabels {
    std::vector<std::int64_t> labels;       ///< property `label`, one a face
    std::vector<std::int64_t> input_faces;  ///< property `input_face`, empty when there is none
    std::vector<std::string> names;         ///< of "comment label i Name": entry i, "" where there is none
};

/// Reads ASCII and both binary PLY. `name` is what errors call the file. Throws UsageError with line or element when
/// the header is broken, no face property `label` of integer type exists, or the data end early.
[[nodiscard]] PlyLabels read_ply_labels(std::string_view bytes, const std::string& name);

}  // namespace partonomy
