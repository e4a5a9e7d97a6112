#include <gtest/gtest.h>

#include <random>

#include "base/errors.h"
#include "mesh/shapes.h"

namespace partonomy {
namespace {

struct BadFile {
    const char* what;
    std::string bytes;
    const char* place;  ///< how the error must begin
    const char* word;   ///< what it must say
};

std::string stl_header(std::uint32_t count) {
    std::string bytes = "solid";
    bytes.resize(80, '\0');
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(count >> (8 * i));
    return bytes;
}

std::string ply(const std::string& rows, const std::string& faces = "1") {
    return "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement "
           "face " +
           faces + "\nproperty list uchar int vertex_indices\nend_header\n" + rows;
}

std::vector<BadFile> bad_files() {
    const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
    std::string nan_stl = stl_header(1) + std::string(12, '\0');
    for (int i = 0; i < 9; ++i) nan_stl += std::string("\xff\xff\xff\x7f", 4);
    nan_stl += std::string(2, '\0');
    return {
        {"empty", "", "mesh: ", "empty"},
        {"blank", " \n\t\n", "mesh: ", "empty"},
        {"no mesh", "<html></html>", "mesh: ", "not a mesh"},
        {"OFF without counts", "OFF\n", "mesh:2: ", "number of vertices"},
        {"OFF words for counts", "OFF\nthree 1 0\n", "mesh:2: ", "'three'"},
        {"OFF negative count", "OFF\n-3 1 0\n", "mesh:2: ", "-3"},
        {"OFF huge count", "OFF\n99999999999 1 0\n", "mesh:2: ", "99999999999"},
        {"OFF false count", "OFF\n2000000000 2000000000 0\n0 0 0\n",
         "mesh:4: ", "ends after 1 of the 2000000000 vertices"},
        {"OFF cut in vertices", "OFF\n3 1 0\n0 0 0\n1 0 0\n", "mesh:5: ", "after 2 of the 3 vertices"},
        {"OFF cut in faces", "OFF\n3 2 0\n" + points + "3 0 1 2\n", "mesh:7: ", "after 1 of the 2 faces"},
        {"OFF two coordinates", "OFF\n3 1 0\n0 0 0\n1 0\n0 1 0\n3 0 1 2\n", "mesh:4: ", "three numbers"},
        {"OFF word for number", "OFF\n3 1 0\n0 0 0\n1 x 0\n0 1 0\n3 0 1 2\n", "mesh:4: ", "'x'"},
        {"OFF comma", "OFF\n3 1 0\n0 0 0\n1 0,5 0\n0 1 0\n3 0 1 2\n", "mesh:4: ", "'0,5'"},
        {"OFF nan", "OFF\n3 1 0\n0 0 0\n1 nan 0\n0 1 0\n3 0 1 2\n", "mesh:4: ", "coordinate y of vertex 1 is nan"},
        {"OFF inf", "OFF\n3 1 0\n0 0 -inf\n1 0 0\n0 1 0\n3 0 1 2\n", "mesh:3: ", "finite"},
        {"OFF overflow", "OFF\n3 1 0\n0 0 1e999\n1 0 0\n0 1 0\n3 0 1 2\n", "mesh:3: ", "finite"},
        {"OFF too far out", "OFF\n3 1 0\n0 0 1e300\n1 0 0\n0 1 0\n3 0 1 2\n", "mesh:3: ", "1e+60"},
        {"OFF index too large", "OFF\n3 1 0\n" + points + "3 0 1 3\n", "mesh:6: ", "vertex 3; indices run from 0 to 2"},
        {"OFF index negative", "OFF\n3 1 0\n" + points + "3 0 1 -1\n", "mesh:6: ", "vertex -1"},
        {"OFF negative corners", "OFF\n3 1 0\n" + points + "-3 0 1 2\n", "mesh:6: ", "negative"},
        {"OFF corner missing", "OFF\n3 1 0\n" + points + "3 0 1\n", "mesh:6: ", "3 vertex indices"},
        {"OFF no faces", "OFF\n3 0 0\n" + points, "mesh: ", "no faces"},
        {"OFF nothing", "OFF\n0 0 0\n", "mesh: ", "no vertices and no faces"},
        {"OFF binary", "OFF BINARY\nxxxx", "mesh:1: ", "binary OFF"},
        {"OFF four dimensions", "4OFF\n3 1 0\n", "mesh:1: ", "three-dimensional"},
        {"no area", "OFF\n3 1 0\n0 0 0\n1 0 0\n2 0 0\n3 0 1 2\n", "mesh: ", "none of its 1 face has an area"},
        {"all in one place", "OFF\n3 1 0\n5 5 5\n5 5 5\n5 5 5\n3 0 1 2\n", "mesh: ", "area"},
        {"OBJ number", "v 0 0 zero\n", "mesh:1: ", "'zero'"},
        {"OBJ short vertex", "v 0 0 0\nv 0 0\n", "mesh:2: ", "vertex 2 needs three"},
        {"OBJ zero index", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 0 1 2\n", "mesh:4: ", "number 1"},
        {"OBJ index too large", "v 0 0 0\nv 1 0 0\nf 1 2 3\nv 0 1 0\nf 1 2 9\n",
         "mesh:5: ", "vertex 9, but the file has 3"},
        {"OBJ index too negative", "v 0 0 0\nf -1 -2 -3\n", "mesh:2: ", "-2"},
        {"OBJ corner", "v 0 0 0\nf 1 2 a/b\n", "mesh:2: ", "v/vt/vn"},
        {"OBJ nan", "v 0 0 NaN\n", "mesh:1: ", "nan"},
        {"OBJ no faces", "v 0 0 0\n", "mesh: ", "no faces"},
        {"STL cut off", "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n", "mesh:5: ", "cut off"},
        {"STL strange word", "solid a\nfacet normal 0 0 1\nouter loop\nvortex 0 0 0\n", "mesh:4: ", "'vortex'"},
        {"STL two corners", "solid a\nfacet\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nendloop\nendfacet\nendsolid\n",
         "mesh:7: ", "2 vertices"},
        {"STL vertex alone", "solid a\nvertex 0 0 0\n", "mesh:2: ", "outside of a facet"},
        {"STL no facets", "solid a\nendsolid a\n", "mesh: ", "no faces"},
        {"binary STL cut off", stl_header(7) + std::string(50, '\0'), "mesh: ", "434 bytes, this one 134"},
        {"binary STL false count", stl_header(0xffffffff) + std::string(50, '\0'), "mesh: ", "cut off"},
        {"binary STL nan", nan_stl, "mesh: ", "triangle 1: coordinate x of vertex 1 is nan"},
        {"PLY without end", "ply\nformat ascii 1.0\n", "mesh: ", "end_header"},
        {"PLY format", "ply\nformat binary 1.0\nend_header\n", "mesh:2: ", "'binary'"},
        {"PLY no format", "ply\nelement vertex 0\nend_header\n", "mesh:3: ", "format"},
        {"PLY type", "ply\nformat ascii 1.0\nelement vertex 3\nproperty real x\nend_header\n", "mesh:4: ", "'real'"},
        {"PLY count", "ply\nformat ascii 1.0\nelement vertex -3\nend_header\n", "mesh:3: ", "-3"},
        {"PLY property first", "ply\nformat ascii 1.0\nproperty float x\nend_header\n", "mesh:3: ", "before the first"},
        {"PLY no x", "ply\nformat ascii 1.0\nelement vertex 1\nproperty float y\nend_header\n0\n",
         "mesh:", "x, y and z"},
        {"PLY cut", ply("0 0 0\n1 0 0\n"), "mesh:12: ", "after 2 of the 3 'vertex'"},
        {"PLY word", ply("0 0 0\n1 0 0\n0 one 0\n3 0 1 2\n"), "mesh:12: ", "'one'"},
        {"PLY nan", ply("0 0 0\n1 0 0\n0 nan 0\n3 0 1 2\n"), "mesh:12: ", "coordinate y of vertex 2"},
        {"PLY index", ply(points + "3 0 1 3\n"), "mesh:13: ", "vertex 3"},
        {"PLY negative size", ply(points + "-3 0 1 2\n"), "mesh:13: ", "negative"},
        {"PLY false count", ply(points + "3 0 1 2\n", "2000000000"), "mesh:14: ", "after 1 of the 2000000000 'face'"},
        {"PLY no faces", ply(points, "0"), "mesh: ", "no faces"},
    };
}

TEST(BadFiles, EachGivesOneClearSentence) {
    for (const BadFile& bad : bad_files()) {
        SCOPED_TRACE(bad.what);
        const std::string error = test::error_of(bad.bytes);
        EXPECT_TRUE(error.starts_with(bad.place)) << error;
        EXPECT_NE(error.find(bad.word), std::string::npos) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
    }
}

TEST(BadFiles, MissingFileAndFolder) {
    EXPECT_THROW(static_cast<void>(read_mesh("/nowhere/at/all.off")), FileError);
    EXPECT_THROW(static_cast<void>(read_mesh(PARTONOMY_SOURCE_DIR)), FileError);
}

/// Bytes of good files, changed at random: anything may come back but a crash or another exception than ours.
TEST(BadFiles, RandomDamageNeverDoesMoreThanThrow) {
    constexpr std::uint64_t seed = 20240607;
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::vector<std::string> good{ply("0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"), "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
                                  "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
                                  "solid\nfacet\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendfacet\nendsolid\n",
                                  stl_header(1) + std::string(50, '\1')};
    for (int round = 0; round < 20000; ++round) {
        std::string bytes = good[random() % good.size()];
        for (std::uint64_t change = random() % 4 + 1; change-- > 0;) {
            const std::size_t place = random() % bytes.size();
            if (random() % 4 == 0)
                bytes.erase(place, random() % 8 + 1);
            else
                bytes[place] = static_cast<char>(random() % 3 == 0 ? random() : "0123456789-. \nef"[random() % 17]);
            if (bytes.empty()) bytes.push_back('x');
        }
        try {
            MeshReport report;
            const TriangleMesh mesh = clean_mesh(parse_mesh(bytes, "m"), "m", report);
            ASSERT_EQ(validate(mesh), "");
        } catch (const MeshError&) {
        }
    }
}

}  // namespace
}  // namespace partonomy
