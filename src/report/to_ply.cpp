// Writes annotation.ply: binary little-endian, the header followed by #V rows of three doubles and #T rows of 32 bytes.
// Doubles, so that positions read back exactly however far the mesh is from its origin. Labels are numbered by first
// appearance among the parts; the header's comments name them.

#include <algorithm>
#include <bit>
#include <cstring>
#include <map>

#include "report/part_names.h"
#include "report/write.h"

namespace partonomy {
namespace {

template <class Value>
void append(std::string& bytes, Value value) {
    std::array<char, sizeof(Value)> raw{};
    std::memcpy(raw.data(), &value, sizeof(Value));
    if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(raw);
    bytes.append(raw.data(), raw.size());
}

/// The parts' concepts by first appearance; number i stands at i - 1.
struct Labels {
    std::vector<std::string> names;
    std::vector<std::int32_t> of_part;  ///< number of each part's concept, 0 for a part without concept
};

Labels number_labels(const Annotation& annotation) {
    Labels labels;
    std::map<std::string, std::int32_t> numbers;
    for (const AnnotatedPart& part : annotation.parts) {
        if (part.concepts.empty()) {
            labels.of_part.push_back(0);
            continue;
        }
        const auto next = static_cast<std::int32_t>(labels.names.size()) + 1;
        const auto [entry, is_new] = numbers.try_emplace(part.concepts.front(), next);
        if (is_new) labels.names.push_back(part.concepts.front());
        labels.of_part.push_back(entry->second);
    }
    return labels;
}

std::string header(const TriangleMesh& mesh, const Annotation& annotation, const Labels& labels) {
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment written by Partonomy\n";
    if (!annotation.mesh_file.empty()) text += "comment mesh " + one_line(annotation.mesh_file) + "\n";
    text += "comment object " + one_line(join(annotation.classes)) + "\n";
    for (std::size_t i = 0; i < labels.names.size(); ++i)
        text += "comment label " + std::to_string(i + 1) + " " + one_line(labels.names[i]) + "\n";
    text += "element vertex " + std::to_string(mesh.positions.size()) +
            "\nproperty double x\nproperty double y\nproperty double z\nelement face " +
            std::to_string(mesh.triangles.size()) +
            "\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
            "property int label\nproperty int part\nproperty int input_face\nproperty float score\nend_header\n";
    return text;
}

}  // namespace

std::string to_ply(const TriangleMesh& mesh, const Annotation& annotation) {
    check_belongs(mesh, annotation);
    const Labels labels = number_labels(annotation);
    std::string bytes = header(mesh, annotation, labels);
    bytes.reserve(bytes.size() + mesh.positions.size() * 24 + mesh.triangles.size() * 32);
    for (const Vec3& point : mesh.positions)
        for (const double coordinate : point) append(bytes, coordinate);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        append(bytes, std::uint8_t{3});
        for (const std::int32_t corner : mesh.triangles[t]) append(bytes, corner);
        const std::int32_t index = annotation.part_of_triangle[t];
        const AnnotatedPart* part = index < 0 ? nullptr : &annotation.parts[static_cast<std::size_t>(index)];
        for (const std::uint8_t channel : part == nullptr ? unlabelled_color : color_of(*part)) append(bytes, channel);
        const auto face = static_cast<std::size_t>(mesh.input_faces[t]);
        append(bytes, part == nullptr ? std::int32_t{0} : labels.of_part[static_cast<std::size_t>(index)]);
        append(bytes, static_cast<std::int32_t>(part == nullptr ? 0 : part->id));
        append(bytes, mesh.input_faces[t]);
        append(bytes, face < annotation.score_of_face.size() ? annotation.score_of_face[face] : 0.0F);
    }
    return bytes;
}

}  // namespace partonomy
