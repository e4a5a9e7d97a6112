#include <gtest/gtest.h>

#include <cstring>
#include <sstream>

#include "base/errors.h"
#include "mesh/read_mesh.h"
#include "report/ply_labels.h"
#include "report/write.h"
#include "zoo.h"

namespace partonomy {
namespace {

template <class Value>
Value take(std::string_view& bytes) {
    Value value;
    std::memcpy(&value, bytes.data(), sizeof(Value));
    bytes.remove_prefix(sizeof(Value));
    return value;
}

// The rows are taken apart by hand here: the layout is a promise to other programs.
TEST(Ply, HeaderAndRowsSayWhatTheAnnotationSays) {
    const zoo::Annotated object = zoo::broken_bench();
    const std::string bytes = to_ply(object.mesh, object.annotation);
    const std::string end = "end_header\n";
    const std::size_t header_size = bytes.find(end) + end.size();
    const std::string header = bytes.substr(0, header_size);
    EXPECT_TRUE(header.starts_with("ply\nformat binary_little_endian 1.0\n"));
    for (const char* line :
         {"comment label 1 Seat\n", "comment label 2 Backrest\n", "comment label 3 Leg\n", "element vertex 40\n",
          "element face 60\n", "property list uchar int vertex_indices\n", "property int label\n",
          "property int part\n", "property int input_face\n", "property float score\n", "property uchar red\n"})
        EXPECT_NE(header.find(line), std::string::npos) << line;
    EXPECT_EQ(header.find("comment label 4"), std::string::npos);
    ASSERT_EQ(bytes.size(), header_size + 40 * 24 + 60 * 32);
    std::string_view rest = std::string_view(bytes).substr(header_size);
    for (const Vec3& point : object.mesh.positions)
        for (const double coordinate : point) EXPECT_EQ(take<double>(rest), coordinate);
    for (std::size_t t = 0; t < 60; ++t) {
        EXPECT_EQ(take<std::uint8_t>(rest), 3);
        for (const std::int32_t corner : object.mesh.triangles[t]) EXPECT_EQ(take<std::int32_t>(rest), corner);
        const int part = object.annotation.part_of_triangle[t];
        const auto color =
            part < 0 ? unlabelled_color : color_of(object.annotation.parts[static_cast<std::size_t>(part)]);
        for (const std::uint8_t channel : color) EXPECT_EQ(take<std::uint8_t>(rest), channel);
        EXPECT_EQ(take<std::int32_t>(rest), std::min(part + 1, 3));  // both legs are label 3
        EXPECT_EQ(take<std::int32_t>(rest), part + 1);
        EXPECT_EQ(take<std::int32_t>(rest), object.mesh.input_faces[t]);
        EXPECT_EQ(take<float>(rest), object.annotation.score_of_face[t / 2]);
    }
}

TEST(Ply, ReloadsAsTheSameMeshWithTheSameLabels) {
    const Vec3 far_away(6e5, -4e6, 12.3);
    const zoo::Annotated object = zoo::bench(far_away);
    const std::string bytes = to_ply(object.mesh, object.annotation);
    const PolygonSoup soup = parse_mesh(bytes, "annotation.ply");
    ASSERT_EQ(soup.positions.size(), object.mesh.positions.size());
    for (std::size_t v = 0; v < soup.positions.size(); ++v) EXPECT_EQ(soup.positions[v], object.mesh.positions[v]);
    ASSERT_EQ(soup.face_count(), 48);
    for (std::size_t t = 0; t < 48; ++t)
        for (std::size_t i = 0; i < 3; ++i) EXPECT_EQ(soup.corners[3 * t + i], object.mesh.triangles[t][i]);
    const PlyLabels labels = read_ply_labels(bytes, "annotation.ply");
    EXPECT_EQ(labels.names, (std::vector<std::string>{"", "Seat", "Backrest", "Leg"}));
    EXPECT_EQ(labels.input_faces,
              std::vector<std::int64_t>(object.mesh.input_faces.begin(), object.mesh.input_faces.end()));
}

TEST(Ply, NamesCannotBreakTheHeader) {
    zoo::Annotated object = zoo::bench();
    object.annotation.parts[0].concepts = {"Seat\nend_header"};
    object.annotation.mesh_file = "a\nelement face 7";
    const PlyLabels labels = read_ply_labels(to_ply(object.mesh, object.annotation), "x");
    EXPECT_EQ(labels.labels.size(), 48U);
    EXPECT_EQ(labels.names[1], "Seat end_header");
}

TEST(Ply, RefusesAnAnnotationOfAnotherMesh) {
    zoo::Annotated object = zoo::bench();
    object.annotation.part_of_triangle.pop_back();
    EXPECT_THROW((void)to_ply(object.mesh, object.annotation), UsageError);
    object.annotation.part_of_triangle.push_back(4);
    EXPECT_THROW((void)to_ply(object.mesh, object.annotation), UsageError);
    object.annotation.part_of_triangle.back() = -2;
    EXPECT_THROW((void)to_ply(object.mesh, object.annotation), UsageError);
}

}  // namespace
}  // namespace partonomy
