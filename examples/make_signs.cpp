#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "base/files.h"
#include "examples/signs.h"

// Writes traffic signs, right and wrong ones, into a folder: each as PLY with coloured faces, as GLB, and as OBJ with
// its material library; and NAME.labels.txt with the true label of each face.

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: make_signs FOLDER\n");
        return 1;
    }
    try {
        const std::filesystem::path folder = argv[1];
        for (const char* kind : {"ply", "glb", "obj"}) std::filesystem::create_directories(folder / kind);
        std::vector<partonomy::PaintedObject> all = partonomy::signs();
        for (partonomy::PaintedObject& wrong : partonomy::wrong_signs()) all.push_back(std::move(wrong));
        for (const partonomy::PaintedObject& painted : all) {
            const std::string& name = painted.object.name;
            partonomy::write_file(folder / "ply" / (name + ".ply"), partonomy::to_ply(painted));
            partonomy::write_file(folder / "glb" / (name + ".glb"), partonomy::to_glb(painted));
            for (const auto& [file, bytes] : partonomy::to_obj(painted))
                partonomy::write_file(folder / "obj" / file, bytes);
            std::string labels;
            for (const std::string& label : painted.object.labels) labels += label + '\n';
            partonomy::write_file(folder / (name + ".labels.txt"), labels);
            fmt::print("{}: {} parts, {} triangles\n", name, painted.object.part_count,
                       painted.object.mesh.triangles.size());
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "make_signs: {}\n", error.what());
        return 1;
    }
    return 0;
}
