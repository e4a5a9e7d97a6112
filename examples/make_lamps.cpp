#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "base/files.h"
#include "examples/lamps.h"
#include "mesh/write_off.h"

// Writes the lamps of docs/guide.md into a folder: NAME.off, and NAME.labels.txt with the true label of each face.

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: make_lamps FOLDER\n");
        return 1;
    }
    try {
        const std::filesystem::path folder = argv[1];
        std::filesystem::create_directories(folder);
        for (const partonomy::ExampleObject& lamp : partonomy::lamps()) {
            partonomy::write_file(folder / (lamp.name + ".off"), partonomy::to_off(lamp.mesh));
            std::string labels;
            for (const std::string& label : lamp.labels) labels += label + '\n';
            partonomy::write_file(folder / (lamp.name + ".labels.txt"), labels);
            fmt::print("{}: {} parts, {} triangles\n", lamp.name, lamp.part_count, lamp.mesh.triangles.size());
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "make_lamps: {}\n", error.what());
        return 1;
    }
    return 0;
}
