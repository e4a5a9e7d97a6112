#pragma once

#include <span>

struct PartonomyAlgorithm;  // include/partonomy/plugin.h

namespace partonomy {

/// A file of a folder whose algorithms are compiled into the program: what plugins export, under a name of its own.
struct LinkedAlgorithm {
    const char* file;
    const PartonomyAlgorithm* (*entry)();
};

/// Those of src/algorithms/linked, by file name. CMake writes it (link_algorithms.cmake).
[[nodiscard]] std::span<const LinkedAlgorithm> linked_algorithms();

}  // namespace partonomy
