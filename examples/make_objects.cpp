#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>
#include <vector>

#include "base/files.h"
#include "examples/objects.h"
#include "mesh/write_off.h"

// Writes the paper's seven objects, and two with headrests, into a folder: NAME.off, and NAME.labels.txt with the true
// label of each face.

int main(int argc, char** argv) {
    if (argc != 2) {
        fmt::print(stderr, "usage: make_objects FOLDER\n");
        return 1;
    }
    try {
        const std::filesystem::path folder = argv[1];
        std::filesystem::create_directories(folder);
        std::vector<partonomy::ExampleObject> objects = partonomy::paper_objects();
        objects.push_back(partonomy::headrest_chair());
        objects.push_back(partonomy::headrest_chair(false));
        for (const partonomy::ExampleObject& object : objects) {
            partonomy::write_file(folder / (object.name + ".off"), partonomy::to_off(object.mesh));
            std::string labels;
            for (const std::string& label : object.labels) labels += label + '\n';
            partonomy::write_file(folder / (object.name + ".labels.txt"), labels);
            fmt::print("{}: {} parts, {} triangles\n", object.name, object.part_count, object.mesh.triangles.size());
        }
    } catch (const std::exception& error) {
        fmt::print(stderr, "make_objects: {}\n", error.what());
        return 1;
    }
    return 0;
}
