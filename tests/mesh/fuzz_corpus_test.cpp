#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <vector>

#include "base/errors.h"
#include "base/files.h"
#include "mesh/appearance.h"
#include "mesh/companions.h"
#include "mesh/material_library.h"

// The seeds of the fuzz targets, and every finding of theirs, run as an ordinary test: each is accepted or refused.

namespace partonomy {
namespace {

TEST(FuzzCorpus, IsAcceptedOrRefused) {
    for (const char* target : {"off", "obj", "stl", "ply", "gltf", "colors"}) {
        std::vector<std::filesystem::path> files;
        for (const auto& entry :
             std::filesystem::directory_iterator(std::filesystem::path(PARTONOMY_SOURCE_DIR) / "fuzz/corpus" / target))
            files.push_back(entry.path());
        std::sort(files.begin(), files.end());
        EXPECT_GE(files.size(), 3U) << target;
        int accepted = 0;
        for (const auto& file : files) {
            SCOPED_TRACE(file.filename());
            try {
                MeshReport report;
                const TriangleMesh mesh = clean_mesh(parse_mesh(read_file(file), "seed"), "seed", report);
                EXPECT_EQ(validate(mesh), "");
                ++accepted;
                SoupAppearance colors;
                const PolygonSoup soup = parse_mesh(read_file(file), "seed", {}, &colors);
                const Appearance appearance = bind_appearance(std::move(colors), soup, mesh);
                for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
                    static_cast<void>(appearance.color_at(t, Eigen::Vector3f::Constant(1.0F / 3)));
            } catch (const MeshError& error) {
                EXPECT_NE(std::string(error.what()).find("seed"), std::string::npos);
            }
        }
        EXPECT_GE(accepted, 2) << target;
    }
}

TEST(FuzzCorpus, OfMaterialLibraries) {
    int accepted = 0, files = 0;
    for (const auto& entry :
         std::filesystem::directory_iterator(std::filesystem::path(PARTONOMY_SOURCE_DIR) / "fuzz/corpus/mtl")) {
        ++files;
        try {
            static_cast<void>(parse_mtl(read_file(entry.path()), "seed"));
            ++accepted;
        } catch (const MeshError& error) {
            EXPECT_NE(std::string(error.what()).find("seed"), std::string::npos);
        }
    }
    EXPECT_GE(files, 3);
    EXPECT_GE(accepted, 2);
}

}  // namespace
}  // namespace partonomy
