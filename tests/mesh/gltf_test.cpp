#include <fmt/format.h>
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <bit>
#include <filesystem>
#include <functional>

#include "base/errors.h"
#include "base/files.h"
#include "examples/objects.h"
#include "mesh/appearance.h"
#include "mesh/readers.h"
#include "mesh/shapes.h"

namespace partonomy {
namespace {

std::string base64(const std::string& bytes) {
    static const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        std::uint32_t bits = 0;
        for (std::size_t k = 0; k < 3; ++k)
            bits = bits << 8 | (i + k < bytes.size() ? static_cast<unsigned char>(bytes[i + k]) : 0U);
        for (std::size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[bits >> (18 - 6 * k) & 63] : '=';
    }
    return text;
}

std::string floats(const std::vector<float>& numbers) {
    std::string bytes;
    for (const float number : numbers)
        for (int i = 0; i < 4; ++i) bytes += static_cast<char>(std::bit_cast<std::uint32_t>(number) >> (8 * i));
    return bytes;
}

/// Four corners of a unit square, then the indices 0 1 2 0 2 3 as bytes, then four colours as bytes.
const std::string square_bytes = floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}) + std::string("\0\1\2\0\2\3\0\0", 8) +
                                 std::string("\xff\0\0\xff\xff\0\0\xff\0\0\xff\xff\0\0\xff\xff", 16);

/// A glTF file of one square; `parts` may take the place of its members.
struct Parts {
    std::string buffer =
        fmt::format(R"({{"byteLength":72,"uri":"data:application/octet-stream;base64,{}"}})", base64(square_bytes));
    std::string views =
        R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":8},{"buffer":0,"byteOffset":56,"byteLength":16})";
    std::string accessors =
        R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},{"bufferView":1,"componentType":5121,"count":6,"type":"SCALAR"},{"bufferView":2,"componentType":5121,"normalized":true,"count":4,"type":"VEC4"})";
    std::string primitive = R"({"attributes":{"POSITION":0},"indices":1})";
    std::string nodes = R"({"mesh":0})";
    std::string scene = R"("scenes":[{"nodes":[0]}],)";
    std::string rest;
    [[nodiscard]] std::string text() const {
        return fmt::format(
            R"({{"asset":{{"version":"2.0"}},{}"nodes":[{}],"meshes":[{{"primitives":[{}]}}],"accessors":[{}],"bufferViews":[{}],"buffers":[{}]{}}})",
            scene, nodes, primitive, accessors, views, buffer, rest);
    }
};

PolygonSoup soup_of(const Parts& parts) { return parse_mesh(parts.text(), "m.gltf"); }

Vec3 corner(const PolygonSoup& soup, std::size_t i) {
    return soup.positions[static_cast<std::size_t>(soup.corners[i])];
}

TEST(Gltf, SquareIsReadInFileOrder) {
    const PolygonSoup soup = soup_of({});
    ASSERT_EQ(soup.face_count(), 2);
    EXPECT_EQ(corner(soup, 1), Vec3(1, 0, 0));
    EXPECT_EQ(corner(soup, 5), Vec3(0, 1, 0));
}

TEST(Gltf, NodesTurnScaleMirrorAndRepeat) {
    Parts parts;
    parts.nodes =
        R"({"translation":[10,0,0],"children":[1,2]},{"mesh":0,"rotation":[0,0,0.7071067811865476,0.7071067811865476],"scale":[2,1,1]},{"mesh":0,"matrix":[-1,0,0,0,0,1,0,0,0,0,1,0,0,0,5,1]})";
    const PolygonSoup soup = soup_of(parts);
    ASSERT_EQ(soup.face_count(), 4);
    EXPECT_LE((corner(soup, 1) - Vec3(10, 2, 0)).norm(), 1e-6);  // scaled, then turned, then moved
    EXPECT_LE((corner(soup, 2) - Vec3(9, 2, 0)).norm(), 1e-6);
    EXPECT_EQ(corner(soup, 6), Vec3(10, 0, 5));
    const Vec3 normal = (corner(soup, 7) - corner(soup, 6)).cross(corner(soup, 8) - corner(soup, 6));
    EXPECT_GT(normal.z(), 0);  // mirrored triangles keep their outside
}

TEST(Gltf, StripsFansAndUnindexedTriangles) {
    Parts strip;
    strip.primitive = R"({"attributes":{"POSITION":0},"mode":5})";
    const PolygonSoup a = soup_of(strip);
    EXPECT_EQ(a.corners, (std::vector<std::int32_t>{0, 1, 2, 2, 1, 3}));
    strip.primitive = R"({"attributes":{"POSITION":0},"mode":6})";
    EXPECT_EQ(soup_of(strip).corners, (std::vector<std::int32_t>{1, 2, 0, 2, 3, 0}));
    strip.primitive = R"({"attributes":{"POSITION":0},"mode":1},{"attributes":{"POSITION":0},"indices":1})";
    const PolygonSoup c = soup_of(strip);
    EXPECT_EQ(c.face_count(), 2);
    ASSERT_EQ(c.notes.size(), 1U);
}

/// Elements of an accessor that stand elsewhere; without a view of its own the others are zero.
TEST(Gltf, SparseAccessors) {
    const std::string indices = R"({"bufferView":1,"componentType":5121,"count":6,"type":"SCALAR"})";
    Parts parts;
    parts.accessors =
        R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":1,"byteOffset":2,"componentType":5121},"values":{"bufferView":0,"byteOffset":36}}},)" +
        indices;
    PolygonSoup soup = soup_of(parts);
    EXPECT_EQ(soup.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 1, 0}}));
    parts.accessors =
        R"({"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":3,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0,"byteOffset":12}}},)" +
        indices;
    soup = soup_of(parts);
    EXPECT_EQ(soup.positions, (std::vector<Vec3>{{1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}}));
}

TEST(Gltf, ColoursOfVerticesAndMaterials) {
    Parts parts;
    parts.primitive = R"({"attributes":{"POSITION":0,"COLOR_0":2},"indices":1,"material":0})";
    parts.rest = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,1,0.5,1],"metallicFactor":0.25}}])";
    SoupAppearance colors;
    const PolygonSoup soup = parse_gltf(parts.text(), "m.gltf", {}, &colors);
    ASSERT_EQ(colors.vertex_colors.size(), 4U);
    EXPECT_EQ(colors.vertex_colors[0], Color(1, 0, 0));
    EXPECT_EQ(colors.vertex_colors[3], Color(0, 0, 1));
    ASSERT_EQ(colors.materials.size(), 1U);
    EXPECT_EQ(colors.materials[0].metallic, 0.25F);
    EXPECT_EQ(colors.materials[0].roughness, 1.0F);
    MeshReport report;
    const TriangleMesh mesh = clean_mesh(soup, "m", report);
    const Appearance appearance = bind_appearance(std::move(colors), soup, mesh);
    EXPECT_EQ(appearance.color_at(1, {0, 0, 1}), Color(0, 0, 0.5F));
}

TEST(Gltf, ModelsWithoutScenesAreRead) {
    Parts parts;
    parts.scene.clear();
    EXPECT_EQ(soup_of(parts).face_count(), 2);
    parts.nodes.clear();
    EXPECT_EQ(soup_of(parts).face_count(), 2);
}

TEST(Gltf, BuffersBesideTheModelOnly) {
    namespace fs = std::filesystem;
    const fs::path root = fs::temp_directory_path() / "partonomy-gltf-buffers", folder = root / "models";
    fs::remove_all(root);
    fs::create_directories(folder);
    write_file(folder / "a b.bin", square_bytes);
    write_file(root / "out.bin", square_bytes);
    fs::create_symlink(root / "out.bin", folder / "link.bin");
    const auto read = [&](const std::string& uri) -> std::string {
        Parts parts;
        parts.buffer = fmt::format(R"({{"byteLength":72,"uri":"{}"}})", uri);
        write_file(folder / "m.gltf", parts.text());
        try {
            return std::to_string(read_mesh(folder / "m.gltf").mesh.triangles.size());
        } catch (const MeshError& error) {
            return error.what();
        }
    };
    EXPECT_EQ(read("a%20b.bin"), "2");
    EXPECT_EQ(read("a b.bin"), "2");
    for (const char* uri : {"../out.bin", "%2e%2e/out.bin", "..%2fout.bin", "%2E%2E%5Cout.bin", "x/../../out.bin"})
        EXPECT_NE(read(uri).find("outside the model's folder"), std::string::npos) << read(uri);
    EXPECT_NE(read("/etc/hostname").find("absolute"), std::string::npos);
    EXPECT_NE(read("%2Fetc%2Fhostname").find("absolute"), std::string::npos);
    EXPECT_NE(read("file:///etc/hostname").find("address"), std::string::npos);
    EXPECT_NE(read("http://example.org/x.bin").find("address"), std::string::npos);
    EXPECT_NE(read("link.bin").find("link"), std::string::npos);
    EXPECT_NE(read("none.bin").find("buffers[0].uri: the buffer 'none.bin' is missing"), std::string::npos);
    EXPECT_NE(read("a%00.bin").find("zero byte"), std::string::npos);
    EXPECT_NE(read("a%2.bin").find("hexadecimal"), std::string::npos);
    fs::remove_all(root);
}

TEST(Gltf, HostileFilesGiveOneClearSentence) {
    struct Case {
        const char* what;
        std::function<void(Parts&)> spoil;
        const char* word;
    };
    const auto accessor = [](const std::string& first) {
        return [first](Parts& p) {
            p.accessors = first + R"(,{"bufferView":1,"componentType":5121,"count":6,"type":"SCALAR"})";
        };
    };
    const std::vector<Case> cases = {
        {"count beyond the view", accessor(R"({"bufferView":0,"componentType":5126,"count":5,"type":"VEC3"})"),
         "accessors[0] announces 5 elements"},
        {"huge count", accessor(R"({"bufferView":0,"componentType":5126,"count":18446744073709551615,"type":"VEC3"})"),
         "announces 18446744073709551615"},
        {"offset beyond",
         accessor(R"({"bufferView":0,"byteOffset":18446744073709551600,"componentType":5126,"count":4,"type":"VEC3"})"),
         "announces 4 elements"},
        {"negative count", accessor(R"({"bufferView":0,"componentType":5126,"count":-4,"type":"VEC3"})"),
         "accessors[0].count must be a whole number"},
        {"count as text", accessor(R"({"bufferView":0,"componentType":5126,"count":"4","type":"VEC3"})"),
         "whole number"},
        {"wrong type", accessor(R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC2"})"), "must be VEC3"},
        {"wrong component", accessor(R"({"bufferView":0,"componentType":9,"count":4,"type":"VEC3"})"), "5120"},
        {"sparse", accessor(R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{}})"),
         "accessors[0].sparse.indices.componentType must be one of"},
        {"sparse, more than there are",
         accessor(
             R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":5,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0}}})"),
         "accessors[0].sparse.count is more than the 4 elements"},
        {"sparse, beyond the accessor",
         accessor(
             R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":1,"byteOffset":5,"componentType":5121},"values":{"bufferView":0}}})"),
         "names element 3 of an accessor that has 3"},
        {"sparse, beyond its view",
         accessor(
             R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","sparse":{"count":4,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0,"byteOffset":12}}})"),
         "accessors[0].sparse.values announces 4 elements"},
        {"sparse, huge",
         accessor(
             R"({"componentType":5126,"count":4000000000,"type":"VEC3","sparse":{"count":1,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":0}}})"),
         "announces 4000000000 elements without a bufferView"},
        {"no view", accessor(R"({"componentType":5126,"count":4000000000,"type":"VEC3"})"), "no bufferView"},
        {"view that is not there", accessor(R"({"bufferView":7,"componentType":5126,"count":4,"type":"VEC3"})"),
         "refers to number 7 of bufferViews, but there are 3"},
        {"view beyond its buffer",
         [](Parts& p) {
             p.views =
                 R"({"buffer":0,"byteOffset":900000000000,"byteLength":400},{"buffer":0,"byteOffset":48,"byteLength":8})";
         },
         "bufferViews[0] runs to byte 900000000000"},
        {"view that wraps around",
         [](Parts& p) {
             p.views =
                 R"({"buffer":0,"byteOffset":18446744073709551615,"byteLength":2},{"buffer":0,"byteOffset":48,"byteLength":8})";
         },
         "runs to byte"},
        {"stride too small",
         [](Parts& p) {
             p.views = R"({"buffer":0,"byteLength":48,"byteStride":4},{"buffer":0,"byteOffset":48,"byteLength":8})";
         },
         "announces 4 elements"},
        {"buffer shorter than told",
         [](Parts& p) { p.buffer = R"({"byteLength":9000000000000,"uri":"data:;base64,AAAA"})"; },
         "announces 9000000000000 bytes, but 3"},
        {"buffer without bytes", [](Parts& p) { p.buffer = R"({"byteLength":72})"; }, "no uri"},
        {"broken base64", [](Parts& p) { p.buffer = R"({"byteLength":72,"uri":"data:;base64,A*A"})"; }, "base64"},
        {"data that is not base64", [](Parts& p) { p.buffer = R"({"byteLength":72,"uri":"data:text/plain,abc"})"; },
         "base64"},
        {"index out of range",
         [](Parts& p) {
             p.accessors =
                 R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"},{"bufferView":1,"componentType":5121,"count":6,"type":"SCALAR"})";
         },
         "meshes[0].primitives[0].indices refers to vertex 3 in triangle 1"},
        {"indices in floats",
         [](Parts& p) {
             p.primitive = R"({"attributes":{"POSITION":0},"indices":3})";
             p.accessors += R"(,{"bufferView":0,"componentType":5126,"count":12,"type":"SCALAR"})";
         },
         "whole numbers"},
        {"no positions", [](Parts& p) { p.primitive = R"({"attributes":{},"indices":1})"; }, "POSITION is missing"},
        {"mode", [](Parts& p) { p.primitive = R"({"attributes":{"POSITION":0},"mode":77})"; }, "mode must be"},
        {"corners", [](Parts& p) { p.primitive = R"({"attributes":{"POSITION":0}})"; }, "no multiple of 3"},
        {"circle of nodes", [](Parts& p) { p.nodes = R"({"children":[1]},{"mesh":0,"children":[0]})"; },
         "a second time"},
        {"node that is not there", [](Parts& p) { p.scene = R"("scenes":[{"nodes":[5]}],)"; }, "number 5 of nodes"},
        {"scene that is not there", [](Parts& p) { p.scene = R"("scene":3,"scenes":[{"nodes":[0]}],)"; },
         "number 3 of scenes"},
        {"mesh that is not there", [](Parts& p) { p.nodes = R"({"mesh":4})"; }, "number 4 of meshes"},
        {"short matrix", [](Parts& p) { p.nodes = R"({"mesh":0,"matrix":[1,2]})"; },
         "nodes[0].matrix must be 16 numbers"},
        {"no rotation", [](Parts& p) { p.nodes = R"({"mesh":0,"rotation":[0,0,0,0]})"; }, "no rotation"},
        {"far out", [](Parts& p) { p.nodes = R"({"mesh":0,"translation":[1e300,0,0]})"; }, "further out"},
        {"number too large", [](Parts& p) { p.nodes = R"({"mesh":0,"translation":[1e999,0,0]})"; }, "too large"},
        {"compressed", [](Parts& p) { p.rest = R"(,"extensionsRequired":["KHR_draco_mesh_compression"])"; },
         "extension"},
        {"nodes are no list", [](Parts& p) { p.scene = R"("scenes":{},)"; }, "no JSON array"},
        {"primitive is no object", [](Parts& p) { p.primitive = "7"; }, "no JSON object"},
        {"nothing to see", [](Parts& p) { p.primitive = R"({"attributes":{"POSITION":0},"mode":0})"; }, "no faces"},
    };
    for (const Case& each : cases) {
        SCOPED_TRACE(each.what);
        Parts parts;
        each.spoil(parts);
        const std::string error = test::error_of(parts.text(), "m.gltf");
        EXPECT_TRUE(error.starts_with("m.gltf: ")) << error;
        EXPECT_NE(error.find(each.word), std::string::npos) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
}

TEST(Gltf, HostileMaterialsGiveOneClearSentence) {
    const std::string png = base64("\x89PNG\r\n\x1a\nnothing more");
    const std::pair<std::string, const char*> cases[] = {
        {R"(,"materials":[])", "number 0 of materials"},
        {R"(,"materials":[{"pbrMetallicRoughness":{"baseColorFactor":[1,1]}}])", "must be 4 numbers"},
        {R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}])", "number 0 of textures"},
        {R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[{}])",
         "names no PNG or JPEG"},
        {R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[{"source":0}],"images":[{"uri":"none.png"}])",
         "images[0].uri: the image 'none.png'"},
        {R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[{"source":0}],"images":[{"uri":"../../x.png"}])",
         "outside"},
        {R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[{"source":0}],"images":[{"bufferView":0}])",
         "no PNG or JPEG image"},
        {R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[{"source":0}],"images":[{"uri":"data:image/png;base64,)" +
             png + R"("}])",
         "images[0] is broken"},
    };
    for (const auto& [rest, word] : cases) {
        SCOPED_TRACE(rest);
        Parts parts;
        parts.primitive = R"({"attributes":{"POSITION":0},"indices":1,"material":0})";
        parts.rest = rest;
        EXPECT_EQ(soup_of(parts).face_count(), 2);  // geometry needs none of it
        SoupAppearance colors;
        try {
            static_cast<void>(parse_gltf(parts.text(), "m.gltf", {}, &colors));
            ADD_FAILURE();
        } catch (const MeshError& error) {
            EXPECT_TRUE(std::string(error.what()).starts_with("m.gltf: ")) << error.what();
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
    }
}

TEST(Gltf, RepetitionIsBounded) {
    Parts parts;  // 300 nodes show a mesh of 300 primitives of 8000 triangles each: 720 million
    std::string primitives, nodes, roots;
    for (int i = 0; i < 300; ++i) {
        primitives += std::string(i ? "," : "") + R"({"attributes":{"POSITION":0},"indices":1})";
        nodes += std::string(i ? "," : "") + R"({"mesh":0})";
        roots += (i ? "," : "") + std::to_string(i);
    }
    parts.primitive = primitives;
    parts.nodes = nodes;
    parts.scene = R"("scenes":[{"nodes":[)" + roots + "]}],";
    parts.buffer = fmt::format(R"({{"byteLength":24048,"uri":"data:;base64,{}"}})",
                               base64(square_bytes.substr(0, 48) + std::string(24000, '\1')));
    parts.views = R"({"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":24000})";
    parts.accessors =
        R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"},{"bufferView":1,"componentType":5121,"count":24000,"type":"SCALAR"})";
    EXPECT_NE(test::error_of(parts.text(), "m.gltf").find("repetition"), std::string::npos);
}

TEST(Gltf, BrokenContainers) {
    const std::pair<std::string, const char*> cases[] = {
        {"{", "no valid JSON"},
        {"{\n\"asset\": x}", "m.gltf:2: "},
        {"{}", "asset"},
        {"[]", "not a mesh"},
        {R"({"asset":{"version":"1.0"}})", "only version 2"},
        {"glTF", "cut off"},
        {std::string("glTF\1\0\0\0\x14\0\0\0\0\0\0\0JSON", 20), "GLB version 1"},
        {std::string("glTF\2\0\0\0\xff\xff\xff\xff\0\0\0\0JSON", 20), "cut off"},
        {std::string("glTF\2\0\0\0\x14\0\0\0\xff\xff\xff\xffJSON", 20), "runs beyond"},
        {std::string("glTF\2\0\0\0\x14\0\0\0\0\0\0\0BIN\0", 20), "first chunk"},
        {std::string(100000, '['), "not a mesh"},
        {"{\"a\":" + std::string(100000, '['), "no valid JSON"},
    };
    for (const auto& [bytes, word] : cases) {
        const std::string error = test::error_of(bytes, "m.gltf");
        EXPECT_NE(error.find(word), std::string::npos) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
}

}  // namespace
}  // namespace partonomy
