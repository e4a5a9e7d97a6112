#include <fmt/format.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include "base/files.h"
#include "examples/brackets.h"
#include "mesh/write_off.h"

// Writes sound brackets (good-SEED.off) and as many with one defect each (bad-SEED-DEFECT.off, the kinds in turn) into
// a folder; and beside each, with .labels.txt instead of .off, the true label of each face.

int main(int argc, char** argv) {
    if (argc < 2 || argc > 4) {
        fmt::print(stderr, "usage: make_brackets FOLDER [NUMBER=200 [FIRST_SEED=1]]\n");
        return 1;
    }
    try {
        const std::filesystem::path folder = argv[1];
        const int count = argc > 2 ? std::stoi(argv[2]) : 200;
        const int first = argc > 3 ? std::stoi(argv[3]) : 1;
        std::filesystem::create_directories(folder);
        const auto write = [&](const std::string& name, const partonomy::ExampleObject& object) {
            partonomy::write_file(folder / (name + ".off"), partonomy::to_off(object.mesh));
            std::string labels;
            for (const std::string& label : object.labels) labels += label + '\n';
            partonomy::write_file(folder / (name + ".labels.txt"), labels);
        };
        const auto defects = partonomy::bracket_defects();
        for (int i = 0; i < count; ++i) {
            const auto seed = static_cast<std::uint32_t>(first + i);
            const std::string& defect = defects[static_cast<std::size_t>(i) % defects.size()];
            write(fmt::format("good-{}", seed), partonomy::bracket(seed));
            write(fmt::format("bad-{}-{}", seed, defect), partonomy::bracket(seed, defect));
        }
        fmt::print("{} sound brackets and {} with a defect, seeds {} to {}\n", count, count, first, first + count - 1);
    } catch (const std::exception& error) {
        fmt::print(stderr, "make_brackets: {}\n", error.what());
        return 1;
    }
    return 0;
}
