#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// How well labels agree with a truth.
struct Evaluation {
    double face_accuracy = 0;     ///< faces with the right label / faces with a truth label
    double area_accuracy = 0;     ///< the same by face area
    double rand_index_error = 0;  ///< area-weighted fraction of face pairs that one side joins and the other parts
    std::map<std::string, double> iou;  ///< per truth label of positive area, by area; over the compared faces
    std::map<std::string, std::map<std::string, double>>
        confusion;           ///< [truth][answer] fraction of the compared area; adds up to 1
    std::int64_t faces = 0;  ///< compared
};

/// Compares labels per input face. `areas` has one entry per input face. A truth of "" or "-" is not compared,
/// nor is a face without area. Throws UsageError when the three differ in length.
[[nodiscard]] Evaluation evaluate_labels(const std::vector<std::string>& labels, const std::vector<std::string>& truth,
                                         const std::vector<double>& areas);

/// Area of each input face: the sum of its triangles.
[[nodiscard]] std::vector<double> input_face_areas(const TriangleMesh& mesh);

/// Reads truth labels, format told by content: a name per line (labels.txt), Labeled-PSB (a line with the label's name,
/// a line of 1-based face numbers), PSB .seg (a segment number per line), one byte per face (.lab), or a PLY with an
/// integer face property `label`. `names` renames labels, for example "support" -> "Seat". Throws FileError, UsageError
/// with file and line; also when the number of faces is not `face_count`.
[[nodiscard]] std::vector<std::string> read_truth(const std::string& path, std::int64_t face_count,
                                                  const std::map<std::string, std::string>& names = {});

}  // namespace partonomy
