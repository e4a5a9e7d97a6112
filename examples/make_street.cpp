#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <string>

#include "base/files.h"
#include "examples/street.h"
#include "mesh/write_off.h"

// Writes a street into a folder: NAME.off, and NAME.labels.txt with the true label of each face.

int main(int argc, char** argv) {
    if (argc < 3) {
        fmt::print(stderr,
                   "usage: make_street FOLDER NAME [seed=1] [triangles=200000] [style=mixed|slabs|solid|carved] "
                   "[trees=yes|no] [FAULT…]\n");
        return 1;
    }
    try {
        partonomy::StreetOptions options;
        for (int i = 3; i < argc; ++i) {
            const std::string word = argv[i], value = word.substr(word.find('=') + 1);
            if (word.starts_with("seed="))
                options.seed = std::stoull(value);
            else if (word.starts_with("triangles="))
                options.triangles = std::stoull(value);
            else if (word.starts_with("style="))
                options.style = value == "slabs"    ? partonomy::BuildingStyle::slabs
                                : value == "solid"  ? partonomy::BuildingStyle::solid
                                : value == "carved" ? partonomy::BuildingStyle::carved
                                                    : partonomy::BuildingStyle::mixed;
            else if (word.starts_with("trees="))
                options.has_trees = value != "no";
            else
                options.faults.push_back(word);
        }
        const std::filesystem::path folder = argv[1];
        const std::string name = argv[2];
        std::filesystem::create_directories(folder);
        const partonomy::ExampleObject object = partonomy::street(options);
        partonomy::write_file(folder / (name + ".off"), partonomy::to_off(object.mesh));
        std::string labels;
        for (const std::string& label : object.labels) labels += label + '\n';
        partonomy::write_file(folder / (name + ".labels.txt"), labels);
        fmt::print("{}: {} parts, {} triangles\n", name, object.part_count, object.mesh.triangles.size());
    } catch (const std::exception& error) {
        fmt::print(stderr, "make_street: {}\n", error.what());
        return 1;
    }
    return 0;
}
