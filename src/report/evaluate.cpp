// Compares labels through their contingency table: n[t][a], the area of the faces with truth t and answer a.
//
// The Rand index error counts pairs of different faces i < j, each weighing area_i * area_j, that one labelling puts
// together and the other apart. With row sums t, column sums s, whole area W and Q = sum of area_i^2, the pairs
// together in a cell of size n weigh (n^2 - q) / 2, where the q of all cells add up to Q. So
//     error = (sum t^2 + sum s^2 - 2 sum n^2) / (W^2 - Q)
// in O(#F log #labels) instead of O(#F^2). Chen et al. (2009) define it over faces of equal weight; areas make it
// independent of how finely a flat board is cut.

#include "report/evaluate.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "base/errors.h"

namespace partonomy {
namespace {

bool is_compared(const std::string& truth) { return !truth.empty() && truth != "-"; }

void check_lengths(std::size_t labels, std::size_t truth, std::size_t areas) {
    if (labels == truth && truth == areas) return;
    throw UsageError("labels for " + std::to_string(labels) + " faces, truth for " + std::to_string(truth) +
                     " and areas of " + std::to_string(areas) + " cannot be compared; the three must be of one mesh");
}

using Table = std::map<std::string, std::map<std::string, double>>;

double square(double x) { return x * x; }

double rand_error(const Table& table, double whole, double squares) {
    double cells = 0, rows = 0, columns = 0;
    std::map<std::string, double> by_answer;
    for (const auto& [truth, answers] : table) {
        double row = 0;
        for (const auto& [answer, area] : answers) {
            row += area;
            cells += square(area);
            by_answer[answer] += area;
        }
        rows += square(row);
    }
    for (const auto& [answer, area] : by_answer) columns += square(area);
    const double pairs = square(whole) - squares;
    return pairs > 0 ? std::clamp((rows + columns - 2 * cells) / pairs, 0.0, 1.0) : 0;
}

std::map<std::string, double> intersection_over_union(const Table& table) {
    std::map<std::string, double> truth_area, answer_area, iou;
    for (const auto& [truth, answers] : table)
        for (const auto& [answer, area] : answers) {
            truth_area[truth] += area;
            answer_area[answer] += area;
        }
    for (const auto& [truth, area] : truth_area) {
        const auto& answers = table.at(truth);
        const auto found = answers.find(truth);
        const double both = found == answers.end() ? 0 : found->second;
        const auto claimed = answer_area.find(truth);
        const double either = area + (claimed == answer_area.end() ? 0 : claimed->second) - both;
        if (either > 0) iou[truth] = both / either;
    }
    return iou;
}

}  // namespace

Evaluation evaluate_labels(const std::vector<std::string>& labels, const std::vector<std::string>& truth,
                           const std::vector<double>& areas) {
    check_lengths(labels.size(), truth.size(), areas.size());
    Evaluation evaluation;
    Table table;
    std::int64_t right = 0;
    double right_area = 0, whole = 0, squares = 0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
        if (!is_compared(truth[i]) || !(areas[i] > 0)) continue;
        const bool agrees = labels[i] == truth[i];
        ++evaluation.faces;
        right += agrees;
        right_area += agrees ? areas[i] : 0;
        whole += areas[i];
        squares += square(areas[i]);
        table[truth[i]][labels[i].empty() ? "-" : labels[i]] += areas[i];
    }
    if (evaluation.faces == 0) return evaluation;
    evaluation.face_accuracy = static_cast<double>(right) / static_cast<double>(evaluation.faces);
    if (!(whole > 0)) return evaluation;
    evaluation.area_accuracy = right_area / whole;
    evaluation.rand_index_error = rand_error(table, whole, squares);
    evaluation.iou = intersection_over_union(table);
    for (auto& [truth_label, answers] : table)
        for (auto& [answer, area] : answers) area /= whole;
    evaluation.confusion = std::move(table);
    return evaluation;
}

std::vector<double> input_face_areas(const TriangleMesh& mesh) {
    std::vector<double> areas(static_cast<std::size_t>(mesh.input_face_count), 0.0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        const Vec3& corner = mesh.positions[static_cast<std::size_t>(a)];
        const Vec3 cross = (mesh.positions[static_cast<std::size_t>(b)] - corner)
                               .cross(mesh.positions[static_cast<std::size_t>(c)] - corner);
        areas[static_cast<std::size_t>(mesh.input_faces[t])] += cross.norm() / 2;
    }
    return areas;
}

}  // namespace partonomy
