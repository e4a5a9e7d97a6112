#include "mesh/appearance.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "base/errors.h"
#include "base/files.h"
#include "examples/signs.h"
#include "mesh/companions.h"
#include "mesh/decode_image.h"
#include "mesh/material_library.h"
#include "mesh/shapes.h"

namespace partonomy {
namespace {

namespace fs = std::filesystem;

/// An empty folder in another one, both gone with the object.
class Folder {
public:
    Folder()
        : root_(fs::temp_directory_path() /
                ("partonomy-look-" +
                 std::string(testing::UnitTest::GetInstance()->current_test_info()->test_suite_name()) + "-" +
                 testing::UnitTest::GetInstance()->current_test_info()->name())) {
        fs::remove_all(root_);
        fs::create_directories(path());
    }
    ~Folder() { fs::remove_all(root_); }
    Folder(const Folder&) = delete;
    Folder& operator=(const Folder&) = delete;
    [[nodiscard]] fs::path path() const { return root_ / "models"; }
    fs::path write(const std::string& name, const std::string& bytes) const {
        fs::create_directories((path() / name).parent_path());
        write_file(path() / name, bytes);
        return path() / name;
    }

private:
    fs::path root_;
};

std::shared_ptr<const Appearance> look(const fs::path& file) {
    const LoadedMesh loaded = read_mesh(file);
    return read_appearance(file, loaded.sha256, loaded.mesh);
}

std::string error_of(const fs::path& file) {
    try {
        static_cast<void>(look(file));
    } catch (const Error& error) {
        return error.what();
    }
    return "no error";
}

const Eigen::Vector3f middle = Eigen::Vector3f::Constant(1.0F / 3);

/// The colour in the middle of a triangle as screens count it, 0 to 255.
Eigen::Vector3i screen_color(const Appearance& appearance, std::size_t t, const Eigen::Vector3f& weights = middle) {
    return appearance.color_at(t, weights)
        .unaryExpr([](float x) { return x <= 0.0031308F ? 12.92F * x : 1.055F * std::pow(x, 1 / 2.4F) - 0.055F; })
        .unaryExpr([](float x) { return std::round(255 * x); })
        .cast<int>();
}

const Eigen::Vector3i red(255, 0, 0), green(0, 255, 0), blue(0, 0, 255), white(255, 255, 255);
const std::string square = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n";

TEST(Appearance, PlyFacesHideVertices) {
    const Folder folder;
    const std::string head =
        "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
        "red\nproperty uchar green\nproperty uchar blue\nelement face 2\nproperty list uchar int vertex_indices\n";
    const std::string vertices = "0 0 0 255 0 0\n1 0 0 255 0 0\n1 1 0 0 0 255\n0 1 0 0 0 255\n";
    const auto by_vertex = look(folder.write("v.ply", head + "end_header\n" + vertices + "3 0 1 2\n3 0 2 3\n"));
    ASSERT_TRUE(by_vertex);
    EXPECT_EQ(screen_color(*by_vertex, 0, {1, 0, 0}), red);
    EXPECT_EQ(screen_color(*by_vertex, 0, {0, 0, 1}), blue);
    EXPECT_FALSE(by_vertex->is_plain(0));
    const auto by_face =
        look(folder.write("f.ply", head + "property float r\nproperty float g\nproperty float b\nend_header\n" +
                                       vertices + "3 0 1 2 0 1 0\n3 0 2 3 1 1 1\n"));
    ASSERT_TRUE(by_face);
    EXPECT_EQ(screen_color(*by_face, 0), green);
    EXPECT_EQ(screen_color(*by_face, 1), white);
    EXPECT_TRUE(by_face->is_plain(0));
}

TEST(Appearance, OffColoursOfBothKindsAndScales) {
    const Folder folder;
    const auto bytes = look(folder.write("a.off", "OFF\n4 2 0\n" + square + "3 0 1 2 255 0 0\n3 0 2 3 0 0 255 128\n"));
    ASSERT_TRUE(bytes);
    EXPECT_EQ(screen_color(*bytes, 0), red);
    EXPECT_EQ(screen_color(*bytes, 1), blue);
    const auto fractions = look(folder.write("b.off", "OFF\n4 2 0\n" + square + "3 0 1 2 1 0 0\n3 0 2 3\n"));
    ASSERT_TRUE(fractions);
    EXPECT_EQ(screen_color(*fractions, 0), red);
    EXPECT_FALSE(is_known(fractions->color_at(1, middle)));
    const auto corners =
        look(folder.write("c.off", "COFF\n3 1 0\n0 0 0 255 0 0 255\n1 0 0 0 255 0 255\n0 1 0 0 0 255 255\n3 0 1 2\n"));
    ASSERT_TRUE(corners);
    EXPECT_EQ(screen_color(*corners, 0, {0, 1, 0}), green);
    const auto with_normals = look(folder.write(
        "n.off", "CNOFF\n3 1 0\n0 0 0 0 0 1 1 0 0 1\n1 0 0 0 0 1 1 0 0 1\n0 1 0 0 0 1 1 0 0 1\n3 0 1 2\n"));
    ASSERT_TRUE(with_normals);
    EXPECT_EQ(screen_color(*with_normals, 0), red);
    EXPECT_FALSE(look(folder.write("d.off", "OFF\n4 2 0\n" + square + "3 0 1 2\n3 0 2 3\n")));
}

TEST(Appearance, ColoursFollowPolygonsThatAreCutTurnedAndWelded) {
    const Folder folder;
    // Two quads of one sheet, the second one wound the other way and with vertices of its own; a long one with 40
    // corners.
    std::string text = "COFF\n48 3 0\n";
    for (const char* p : {"0 0 0 1 0 0", "1 0 0 0 1 0", "1 1 0 0 0 1", "0 1 0 1 1 1"}) text += std::string(p) + " 1\n";
    for (const char* p : {"1 0 0 0 1 0", "2 0 0 1 0 0", "2 1 0 1 1 1", "1 1 0 0 0 1"}) text += std::string(p) + " 1\n";
    std::string many = "40";
    for (int i = 0; i < 40; ++i) {
        const double angle = 2 * 3.14159265358979 * i / 40;
        text += std::to_string(5 + std::cos(angle)) + " " + std::to_string(std::sin(angle)) + " 0 " +
                (i < 20 ? "1 0 0 1\n" : "0 0 1 1\n");
        many += " " + std::to_string(8 + i);
    }
    const fs::path file = folder.write("sheet.off", text + "4 0 1 2 3\n4 7 6 5 4\n" + many + "\n");
    const LoadedMesh loaded = read_mesh(file);
    const auto appearance = read_appearance(file, loaded.sha256, loaded.mesh);
    ASSERT_TRUE(appearance);
    for (std::size_t t = 0; t < loaded.mesh.triangles.size(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& p = loaded.mesh.positions[static_cast<std::size_t>(loaded.mesh.triangles[t][i])];
            Eigen::Vector3f corner = Eigen::Vector3f::Zero();
            corner[static_cast<int>(i)] = 1;
            const Eigen::Vector3i color = screen_color(*appearance, t, corner);
            if (p.x() > 3)
                EXPECT_EQ(color, p.y() > -1e-9 && !(p.x() < 4.5 && p.y() < 1e-6) ? red : blue) << p.transpose();
            else
                EXPECT_EQ(color, p.y() == 0 ? (p.x() == 1 ? green : red) : (p.x() == 1 ? blue : white));
        }
}

TEST(Appearance, ObjMaterialsImagesAndVertexColours) {
    const Folder folder;
    folder.write(
        "paint.mtl",
        "# made by hand\nnewmtl glossy red\nKd 1 0 0\nKs 0.5 0.5 0.5\nNs 500\n\nnewmtl steel\nKd 0.1 0.1 0.1\nKs "
        "0.8 0.8 0.8\nNs 100\nnewmtl new\nPm 0.25\nPr 0.75\nKd 0 0 1\nnewmtl picture\nKd 1 1 1\nmap_Kd -s 1 1 "
        "-clamp on left right.png\n");
    folder.write("left right.png", to_png(make_image(2, 2, [](int x, int y) -> std::array<std::uint8_t, 3> {
                     if (y == 1) return {0, 0, 0};
                     return x == 0 ? std::array<std::uint8_t, 3>{255, 0, 0} : std::array<std::uint8_t, 3>{0, 0, 255};
                 })));
    const auto appearance = look(folder.write(
        "m.obj",
        "mtllib paint.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nusemtl glossy "
        "red\nf 1 2 3\nusemtl steel\nf 1 3 4\nusemtl new\nf 1 2 4\nusemtl picture\nf 2/2 3/3 4/4\n"));
    ASSERT_TRUE(appearance);
    EXPECT_EQ(screen_color(*appearance, 0), red);
    ASSERT_TRUE(appearance->material_of(0)->roughness);
    EXPECT_NEAR(*appearance->material_of(0)->roughness, 0.251, 0.01);
    EXPECT_EQ(appearance->material_of(0)->metallic, 0);
    EXPECT_EQ(appearance->material_of(1)->metallic, 1);
    EXPECT_EQ(screen_color(*appearance, 1), Eigen::Vector3i(204, 204, 204));
    EXPECT_EQ(appearance->material_of(2)->metallic, 0.25F);
    EXPECT_EQ(appearance->material_of(2)->roughness, 0.75F);
    EXPECT_FALSE(appearance->material_of(3)->roughness);
    const LoadedMesh loaded = read_mesh(folder.path() / "m.obj");
    for (std::size_t i = 0; i < 3; ++i) {  // v runs upwards: the red and blue row is at the top
        const Vec3& p = loaded.mesh.positions[static_cast<std::size_t>(loaded.mesh.triangles[3][i])];
        Eigen::Vector3f corner = Eigen::Vector3f::Constant(0.05F);
        corner[static_cast<int>(i)] = 0.9F;
        EXPECT_EQ(screen_color(*appearance, 3, corner), p.y() == 0   ? Eigen::Vector3i(0, 0, 0)
                                                        : p.x() == 0 ? red
                                                                     : blue)
            << p.transpose();
    }
    const auto vertices = look(folder.write("v.obj", "v 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nf 1 2 3\n"));
    ASSERT_TRUE(vertices);
    EXPECT_EQ(screen_color(*vertices, 0, {0, 1, 0}), green);
}

TEST(Appearance, PaintedExamplesAreReadBackFromEachFormat) {
    const Folder folder;
    std::vector<PaintedObject> all = signs();
    for (PaintedObject& wrong : wrong_signs()) all.push_back(std::move(wrong));
    for (const PaintedObject& painted : all) {
        SCOPED_TRACE(painted.object.name);
        const auto truth = appearance_of(painted);
        for (const auto& [name, bytes] : to_obj(painted)) folder.write(name, bytes);
        std::vector<fs::path> files{folder.write("sign.glb", to_glb(painted)),
                                    folder.path() / (painted.object.name + ".obj")};
        if (painted.points.empty()) files.push_back(folder.write("sign.ply", to_ply(painted)));
        for (const fs::path& file : files) {
            SCOPED_TRACE(file.extension());
            const LoadedMesh loaded = read_mesh(file);
            ASSERT_EQ(loaded.mesh.triangles.size(), painted.object.mesh.triangles.size());
            ASSERT_EQ(loaded.is_gltf, file.extension() == ".glb");
            const auto appearance = read_appearance(file, loaded.sha256, loaded.mesh);
            ASSERT_TRUE(appearance);
            for (std::size_t t = 0; t < loaded.mesh.triangles.size(); ++t) {
                ASSERT_EQ(loaded.mesh.input_faces[t], static_cast<int>(t));
                ASSERT_LE((appearance->color_at(t, middle) - truth->color_at(t, middle)).norm(), 1e-4) << t;
            }
        }
    }
}

TEST(Appearance, AFileThatChangedMeanwhileIsRefused) {
    const Folder folder;
    const fs::path file = folder.write("a.off", "OFF\n4 2 0\n" + square + "3 0 1 2 255 0 0\n3 0 2 3 0 0 255\n");
    const LoadedMesh loaded = read_mesh(file);
    folder.write("a.off", "OFF\n4 1 0\n" + square + "3 0 1 2 255 0 0\n");
    EXPECT_THROW(static_cast<void>(read_appearance(file, loaded.sha256, loaded.mesh)), MeshError);
}

TEST(Companions, OnlyFilesOfTheModelsFolderAreRead) {
    const Folder folder;
    const fs::path model = folder.write("m.obj", "v 0 0 0\n");
    folder.write("in.mtl", "newmtl a\n");
    folder.write("sub/deep.mtl", "newmtl a\n");
    write_file(folder.path().parent_path() / "secret.mtl", "newmtl secret\n");
    fs::create_symlink(folder.path().parent_path() / "secret.mtl", folder.path() / "link.mtl");
    fs::create_directory_symlink(folder.path().parent_path(), folder.path() / "out");
    fs::create_symlink("in.mtl", folder.path() / "inner.mtl");
    fs::create_directories(folder.path() / "folder.mtl");
    const Companions companions(model);
    for (const char* good : {"in.mtl", "sub/deep.mtl", "sub\\deep.mtl", "./in.mtl", "inner.mtl"})
        EXPECT_EQ(companions.read(good, "x", 1000), "newmtl a\n") << good;
    const std::pair<std::string, const char*> bad[] = {{"../secret.mtl", "outside"},
                                                       {"sub/../../secret.mtl", "outside"},
                                                       {"..\\secret.mtl", "outside"},
                                                       {"/etc/hostname", "absolute"},
                                                       {"\\\\server\\x", "absolute"},
                                                       {"C:\\x.mtl", "address"},
                                                       {"http://a.b/c", "address"},
                                                       {"file:///etc/hostname", "address"},
                                                       {"link.mtl", "link"},
                                                       {"out/secret.mtl", "link"},
                                                       {"folder.mtl", "ordinary"},
                                                       {"none.mtl", "missing"},
                                                       {"", "no name"},
                                                       {std::string("a\0b", 3), "zero byte"}};
    for (const auto& [name, word] : bad) {
        SCOPED_TRACE(name);
        EXPECT_FALSE(companions.has(name));
        try {
            static_cast<void>(companions.read(name, "m.obj: the image", 1000));
            ADD_FAILURE();
        } catch (const MeshError& error) {
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
            EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos);
        }
    }
    EXPECT_THROW(static_cast<void>(companions.read("in.mtl", "x", 3)), MeshError);
    EXPECT_THROW(static_cast<void>(Companions().read("in.mtl", "x", 1000)), MeshError);
}

TEST(Appearance, WhatIsMissingOrBrokenIsOneSentence) {
    const Folder folder;
    const std::string mesh = "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\n";
    const auto obj = [&](const std::string& text) { return folder.write("m.obj", mesh + text); };
    folder.write("ok.mtl", "newmtl red\nKd 1 0 0\n");
    folder.write("lost.mtl", "newmtl red\nmap_Kd lost.png\n");
    folder.write("up.mtl", "newmtl red\nKd 1 1 1\nmap_Kd ../../up.png\n");
    folder.write("text.mtl", "newmtl red\nmap_Kd ok.mtl\n");
    folder.write("cut.mtl", "newmtl red\nmap_Kd cut.png\n");
    const std::string png = to_png(make_image(40, 40, [](int x, int y) {
        return std::array<std::uint8_t, 3>{static_cast<std::uint8_t>(7 * x), static_cast<std::uint8_t>(y * x), 3};
    }));
    folder.write("cut.png", png.substr(0, png.size() / 2));
    std::string huge = png;
    huge[16] = huge[20] = 0x7f;
    folder.write("huge.mtl", "newmtl red\nmap_Kd huge.png\n");
    folder.write("huge.png", huge);
    const std::pair<std::string, const char*> cases[] = {
        {"mtllib none.mtl\nusemtl red\nf 1 2 3\n", "m.obj:5: the material library 'none.mtl' is missing"},
        {"mtllib ../x.mtl\nf 1 2 3\n", "outside the model's folder"},
        {"mtllib\nf 1 2 3\n", "name of a material library"},
        {"usemtl red\nf 1 2 3\n", "m.obj:5: there is no material 'red' in the material libraries; name them"},
        {"mtllib ok.mtl\nusemtl rad\nf 1 2 3\n", "did you mean \"red\"?"},
        {"mtllib lost.mtl\nusemtl red\nf 1/1 2/1 3/1\n", "lost.mtl:2: the image 'lost.png' is missing"},
        {"mtllib up.mtl\nusemtl red\nf 1/1 2/1 3/1\n", "up.mtl:3: the image '../../up.png' lies outside"},
        {"mtllib text.mtl\nusemtl red\nf 1/1 2/1 3/1\n", "is no PNG or JPEG image"},
        {"mtllib cut.mtl\nusemtl red\nf 1/1 2/1 3/1\n", "cut.png' is broken or cut off"},
        {"mtllib huge.mtl\nusemtl red\nf 1/1 2/1 3/1\n", "huge.png'"},
        {"f 1/2 2/1 3/1\n", "refers to texture point 2, but the file has 1"},
        {"f 1/x 2/1 3/1\n", "texture point of a corner"},
    };
    for (const auto& [text, word] : cases) {
        SCOPED_TRACE(text);
        const fs::path file = obj(text);
        const std::string error = error_of(file);
        EXPECT_NE(error.find(word), std::string::npos) << error;
        EXPECT_EQ(error.find('\n'), std::string::npos) << error;
        EXPECT_NO_THROW(static_cast<void>(read_mesh(file)));  // geometry needs none of it
    }
    for (const auto& [bytes, word] : {std::pair<const char*, const char*>{"Kd 1 1 1\n", "m.mtl:1: Kd stands before"},
                                      {"newmtl a\nKd 1 x 1\n", "m.mtl:2: 'x'"},
                                      {"newmtl a\nNs nan\n", "finite"},
                                      {"newmtl\n", "newmtl needs"},
                                      {"newmtl a\nmap_Kd -clamp on\n", "map_Kd needs"}}) {
        try {
            static_cast<void>(parse_mtl(bytes, "m.mtl"));
            ADD_FAILURE() << bytes;
        } catch (const MeshError& error) {
            EXPECT_NE(std::string(error.what()).find(word), std::string::npos) << error.what();
        }
    }
}

TEST(Appearance, ImagesRepeatMirrorAndEnd) {
    const Image image = make_image(4, 1, [](int x, int) {
        return std::array<std::uint8_t, 3>{static_cast<std::uint8_t>(x == 0 ? 255 : 0), 0, 0};
    });
    const auto is_red = [&](float u, Wrap wrap) { return image.color_at({u, 0.5F}, wrap, wrap).x() > 0.5F; };
    EXPECT_TRUE(is_red(0.1F, Wrap::repeat));
    EXPECT_TRUE(is_red(5.1F, Wrap::repeat));
    EXPECT_TRUE(is_red(-0.9F, Wrap::repeat));
    EXPECT_FALSE(is_red(1.1F, Wrap::mirror));
    EXPECT_TRUE(is_red(1.9F, Wrap::mirror));
    EXPECT_TRUE(is_red(-0.1F, Wrap::mirror));
    EXPECT_FALSE(is_red(7, Wrap::clamp));
    EXPECT_TRUE(is_red(-7, Wrap::clamp));
    EXPECT_TRUE(is_red(std::numeric_limits<float>::quiet_NaN(), Wrap::repeat));
}

TEST(Color, OkLabOfKnownColours) {
    const auto lab = [](float r, float g, float b) { return lab_from_linear(linear_from_srgb({r, g, b})); };
    EXPECT_NEAR(lab(1, 1, 1).lightness, 1, 1e-3);
    EXPECT_NEAR(lab(1, 1, 1).chroma(), 0, 1e-3);
    EXPECT_NEAR(lab(1, 0, 0).lightness, 0.628, 1e-3);  // as CSS gives oklch() of its colours
    EXPECT_NEAR(lab(1, 0, 0).chroma(), 0.2577, 1e-3);
    EXPECT_NEAR(lab(1, 0, 0).hue_degrees(), 29.23, 0.1);
    EXPECT_NEAR(lab(0, 0, 1).hue_degrees(), 264.05, 0.1);
    EXPECT_NEAR(lab(0, 1, 0).hue_degrees(), 142.5, 0.1);
}

}  // namespace
}  // namespace partonomy
