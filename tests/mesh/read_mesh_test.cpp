#include "mesh/read_mesh.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstring>

#include "mesh/shapes.h"
#include "mesh/write_off.h"

namespace partonomy {
namespace {

using test::error_of;

// One tetrahedron in every dialect; all of them must give the same surface.
const std::vector<Vec3> tetrahedron{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
const std::vector<std::array<std::int32_t, 3>> sides{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

void expect_tetrahedron(const std::string& bytes, MeshFormat format) {
    ASSERT_EQ(detect_mesh_format(bytes), format);
    MeshReport report;
    const PolygonSoup soup = parse_mesh(bytes, "tetrahedron");
    EXPECT_TRUE(soup.notes.empty());
    const TriangleMesh mesh = clean_mesh(soup, "tetrahedron", report);
    EXPECT_EQ(validate(mesh), "");
    EXPECT_EQ(mesh.input_face_count, 4);
    ASSERT_EQ(mesh.triangles.size(), 4U);
    for (std::size_t t = 0; t < 4; ++t) {
        EXPECT_EQ(mesh.input_faces[t], static_cast<std::int32_t>(t));
        for (std::size_t i = 0; i < 3; ++i)
            EXPECT_EQ(mesh.positions[static_cast<std::size_t>(mesh.triangles[t][i])],
                      tetrahedron[static_cast<std::size_t>(sides[t][i])]);
    }
    const Topology topology = compute_topology(mesh);
    EXPECT_EQ(topology.euler, 2);
    EXPECT_DOUBLE_EQ(topology.volume, 1.0 / 6);
    EXPECT_EQ(report.shells, 1);
    EXPECT_EQ(report.flipped_triangles, 0);
}

constexpr const char* off_faces = "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n";

TEST(ReadOff, Plain) {
    expect_tetrahedron(std::string("OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n") + off_faces, MeshFormat::off);
}

TEST(ReadOff, CountsOnTheHeaderLineCommentsAndPlusSigns) {
    expect_tetrahedron(
        std::string("# made by hand\n\nOFF 4 4 0 # counts\n# points\n0 0 0 # first\n+1 0 0\n\n0 1.0 0\n0 "
                    "0 1e0\n") +
            off_faces,
        MeshFormat::off);
}

TEST(ReadOff, ColoursNormalsTexture) {
    expect_tetrahedron(
        "COFF\n4 4 6\n0 0 0 255 0 0 255\n1 0 0 0 0 0 0\n0 1 0 1 1 1 1\n0 0 1 1 1 1 1\n3 0 2 1 255 0 0\n"
        "3 0 1 3 0.5 0.5 0.5 1\n3 1 2 3 7\n3 0 3 2\n",
        MeshFormat::off);
    expect_tetrahedron(
        std::string("STCNOFF\n4 4 6\n0 0 0 0 0 1 0.1 0.2\n1 0 0 0 0 1\n0 1 0 0 0 1\n0 0 1 0 0 1\n") + off_faces,
        MeshFormat::off);
}

TEST(ReadOff, OtherLineEnds) {
    const std::string text = std::string("OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n") + off_faces;
    std::string windows, old_mac = text;
    for (const char c : text) windows += c == '\n' ? std::string("\r\n") : std::string(1, c);
    std::replace(old_mac.begin(), old_mac.end(), '\n', '\r');
    expect_tetrahedron(windows, MeshFormat::off);
    expect_tetrahedron(old_mac, MeshFormat::off);
    expect_tetrahedron(text.substr(0, text.size() - 1), MeshFormat::off);
    expect_tetrahedron("\xEF\xBB\xBF" + text, MeshFormat::off);
}

TEST(ReadOff, WhatWeWriteReadsBackToTheSameDoubles) {
    TriangleMesh mesh;
    mesh.positions = {{0.1, 1.0 / 3, 1e-17}, {1e22, -0.25, 5e-324}, {123456789.123456789, 2, 3}};
    mesh.triangles = {{0, 1, 2}};
    const PolygonSoup soup = parse_mesh(to_off(mesh), "written");
    ASSERT_EQ(soup.positions.size(), 3U);
    EXPECT_EQ(soup.positions, mesh.positions);
}

TEST(ReadOff, SaysWhatItLeftUnread) {
    const std::string text = std::string("OFF\n4 3 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n") + off_faces;
    const PolygonSoup soup = parse_mesh(text, "t");
    EXPECT_EQ(soup.face_count(), 3);
    ASSERT_EQ(soup.notes.size(), 1U);
    EXPECT_NE(soup.notes[0].find("line 10"), std::string::npos) << soup.notes[0];
}

TEST(ReadObj, AllCornerForms) {
    expect_tetrahedron(
        "# made by hand\nmtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0 1.0\nvt 0 0\nvn 0 0 1\nv 0 1 0 0.5 0.5 0.5\nv 0 0 1\n"
        "usemtl red\ns off\ng a b\nf 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1\nf 2/1 3/1 4/1\nf 1 4 3\n",
        MeshFormat::obj);
}

TEST(ReadObj, NegativeIndicesContinuedLinesFacesBeforeVertices) {
    expect_tetrahedron("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -1 -2\nf 1 2 4\nf 2 \\\n 3 4\nf 1\\\n 4 3\nv 0 0 1\n",
                       MeshFormat::obj);
}

TEST(ReadObj, PassesOverLinesAndPoints) {
    const PolygonSoup soup = parse_mesh("v 0 0 0\nv 1 0 0\nv 0 1 0\nl 1 2\np 3\nf 1 2 3\n", "t");
    EXPECT_EQ(soup.face_count(), 1);
    ASSERT_EQ(soup.notes.size(), 1U);
}

std::string ascii_stl() {
    std::string text = "solid tetra hedron\n";
    for (const auto& side : sides) {
        text += " facet normal 0 0 0\n  outer loop\n";
        for (const std::int32_t v : side) {
            const Vec3& p = tetrahedron[static_cast<std::size_t>(v)];
            text +=
                "   vertex " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " + std::to_string(p.z()) + "\n";
        }
        text += "  endloop\n endfacet\n";
    }
    return text + "endsolid tetra\n";
}

void append(std::string& bytes, const void* data, std::size_t size, bool swapped = false) {
    std::string raw(static_cast<const char*>(data), size);
    if (swapped) std::reverse(raw.begin(), raw.end());
    bytes += raw;
}

std::string binary_stl(const std::string& header) {
    std::string bytes = header;
    bytes.resize(80, '\0');
    const std::uint32_t count = 4;
    append(bytes, &count, 4);
    for (const auto& side : sides) {
        bytes.append(12, '\0');
        for (const std::int32_t v : side)
            for (int axis = 0; axis < 3; ++axis) {
                const auto value = static_cast<float>(tetrahedron[static_cast<std::size_t>(v)][axis]);
                append(bytes, &value, 4);
            }
        bytes.append(2, '\0');
    }
    return bytes;
}

TEST(ReadStl, Ascii) {
    expect_tetrahedron(ascii_stl(), MeshFormat::stl_ascii);
    std::string upper = ascii_stl();
    std::transform(upper.begin(), upper.end(), upper.begin(), [](char c) { return c >= 'a' && c <= 'z' ? c - 32 : c; });
    expect_tetrahedron(upper, MeshFormat::stl_ascii);
}

TEST(ReadStl, BinaryEvenWhenItsHeaderSaysSolid) {
    expect_tetrahedron(binary_stl("made by hand"), MeshFormat::stl_binary);
    expect_tetrahedron(binary_stl("solid facet"), MeshFormat::stl_binary);
    const PolygonSoup soup = parse_mesh(binary_stl("solid") + "tail", "t");
    EXPECT_EQ(soup.face_count(), 4);
    EXPECT_EQ(soup.positions.size(), 4U);
    EXPECT_EQ(soup.notes.size(), 1U);
}

TEST(ReadPly, AsciiWithStrangersAround) {
    expect_tetrahedron(
        "ply\nformat ascii 1.0\ncomment end_header is not here\nobj_info x\nelement camera 1\nproperty float f\n"
        "property list uchar int ids\nelement vertex 4\nproperty uchar red\nproperty double z\nproperty float x\n"
        "property float y\nelement face 4\nproperty uchar flags\nproperty list uchar uint vertex_index\n"
        "property list uchar float texcoord\nelement edge 1\nproperty int a\nend_header\n"
        "1.5 2 7 8\n9 0 0 0\n9 0 1 0\n9 0 0 1\n9 1 0 0\n0 3 0 2 1 0\n0 3 0 1 3 2 0.5 0.5\n0 3 1 2 3 0\n0 3 0 3 2 "
        "0\n5\n",
        MeshFormat::ply);
}

template <class Position, class Index>
std::string binary_ply(bool big, const char* position_type, const char* index_type) {
    std::string bytes =
        std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\nelement vertex 4\n";
    for (const char* axis : {"x", "y", "z"}) bytes += std::string("property ") + position_type + " " + axis + "\n";
    bytes += std::string("property short extra\nelement junk 2\nproperty list uchar double d\nproperty char c\n") +
             "element face 4\nproperty list int " + index_type + " vertex_indices\nproperty uchar label\nend_header\n";
    const bool swapped = big == (std::endian::native == std::endian::little);
    for (const Vec3& p : tetrahedron) {
        for (int axis = 0; axis < 3; ++axis) {
            const auto value = static_cast<Position>(p[axis]);
            append(bytes, &value, sizeof value, swapped);
        }
        bytes += "\n\r";
    }
    bytes += std::string("\x01") + "12345678" + "c" + std::string("\0", 1) + "c";
    for (const auto& side : sides) {
        const std::int32_t count = 3;
        append(bytes, &count, 4, swapped);
        for (const std::int32_t v : side) {
            const auto index = static_cast<Index>(v);
            append(bytes, &index, sizeof index, swapped);
        }
        bytes += '\n';
    }
    return bytes;
}

TEST(ReadPly, BothBinaryOrdersAndAllTypes) {
    for (const bool big : {false, true}) {
        expect_tetrahedron(binary_ply<float, std::int32_t>(big, "float", "int"), MeshFormat::ply);
        expect_tetrahedron(binary_ply<double, std::uint8_t>(big, "double", "uchar"), MeshFormat::ply);
        expect_tetrahedron(binary_ply<std::int16_t, std::int8_t>(big, "short", "int8"), MeshFormat::ply);
        expect_tetrahedron(binary_ply<std::uint8_t, std::uint16_t>(big, "uint8", "uint16"), MeshFormat::ply);
        expect_tetrahedron(binary_ply<float, float>(big, "float32", "float32"), MeshFormat::ply);
    }
}

TEST(ReadPly, EveryCutIsAnErrorOrTheWholeMesh) {
    const std::string bytes = binary_ply<float, std::int32_t>(false, "float", "int");
    for (std::size_t size = 0; size < bytes.size(); ++size)
        EXPECT_NE(error_of(bytes.substr(0, size)), "no error") << size;
    EXPECT_EQ(error_of(bytes), "no error");
}

TEST(DetectMeshFormat, RefusesWhatIsNoMesh) {
    EXPECT_EQ(detect_mesh_format(""), std::nullopt);
    EXPECT_EQ(detect_mesh_format("hello world"), std::nullopt);
    EXPECT_EQ(detect_mesh_format(std::string("\x89PNG\r\n\x1a\n", 8) + std::string(200, '\0')), std::nullopt);
    EXPECT_EQ(detect_mesh_format(std::string("PK\x03\x04", 4) + std::string(200, '\0')), std::nullopt);
}

}  // namespace
}  // namespace partonomy
