#pragma once

#include <string>
#include <vector>

struct PartonomyAlgorithm;  // include/partonomy/plugin.h

namespace partonomy {

/// Adds the algorithm of a shared library to the measures that ontologies may name. Throws FileError with one sentence:
/// no such file, no shared library, no entry point, another version of the interface, an algorithm that cannot be used
/// or has the name of one that there is. Loading the same file again does nothing.
void load_plugin(const std::string& path);

/// The same for an algorithm that is linked in; `origin` is what errors call it. Throws FileError.
void add_algorithm(const PartonomyAlgorithm* algorithm, const std::string& origin);

/// Adds the algorithms that were compiled into the program (linked_algorithms.h); once, however often it is called.
/// Throws FileError as above.
void add_linked_algorithms();

/// What went wrong while algorithms of plugins measured, a sentence each, sorted, without repetition.
[[nodiscard]] std::vector<std::string> plugin_troubles();

}  // namespace partonomy
