# Compiles every *.cpp of a folder into a target, each an algorithm as include/partonomy/plugin.h says, and a function of
# namespace partonomy that lists them. All export partonomy_algorithm, so each gets a name of its own here.
function(partonomy_link_algorithms target folder function)
  file(GLOB files CONFIGURE_DEPENDS ${folder}/*.cpp)
  set(declarations "")
  set(entries "")
  foreach(file ${files})
    get_filename_component(stem ${file} NAME_WE)
    string(MAKE_C_IDENTIFIER ${stem} name)
    set_source_files_properties(${file} PROPERTIES COMPILE_DEFINITIONS partonomy_algorithm=partonomy_algorithm_${name})
    string(APPEND declarations "extern \"C\" const PartonomyAlgorithm* partonomy_algorithm_${name}(void);\n")
    string(APPEND entries "    {\"${stem}.cpp\", partonomy_algorithm_${name}},\n")
  endforeach()
  list(LENGTH files count)
  set(list ${CMAKE_CURRENT_BINARY_DIR}/${function}.cpp)
  file(CONFIGURE OUTPUT ${list} @ONLY CONTENT [=[
#include <array>

#include "algorithms/linked_algorithms.h"

@declarations@
namespace partonomy {
std::span<const LinkedAlgorithm> @function@();
std::span<const LinkedAlgorithm> @function@() {
    static const std::array<LinkedAlgorithm, @count@> all{{
@entries@    }};
    return all;
}
}  // namespace partonomy
]=])
  target_sources(${target} PRIVATE ${files} ${list})
  target_include_directories(${target} PRIVATE ${PROJECT_SOURCE_DIR}/include ${PROJECT_SOURCE_DIR}/src)
endfunction()
