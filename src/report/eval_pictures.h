#pragma once

#include <map>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// The confusion of labels as a PNG picture: a row for each true label, a column for each answer, each cell the
/// percentage of the row's area, the darker the more; right answers are green, wrong ones red. `confusion` is
/// [truth][answer] area in any unit.
[[nodiscard]] std::string confusion_picture(const std::map<std::string, std::map<std::string, double>>& confusion);

/// One mesh of a contact sheet.
struct SheetEntry {
    std::string title;  ///< "105: 0.944"
    TriangleMesh mesh;
    std::vector<std::string> labels, truth;  ///< one per input face
    Vec3 up = Vec3::UnitZ();
};

/// Meshes beside each other as a PNG picture, each as it is in truth and as it was labelled, seen from the same side,
/// one colour a label, with a legend. Throws UsageError when there is no mesh, or labels do not belong to theirs.
[[nodiscard]] std::string contact_sheet(const std::vector<SheetEntry>& entries, int threads = 0);

}  // namespace partonomy
