#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/errors.h"
#include "mesh/read_mesh.h"
#include "mesh/readers.h"

// One target a format: the reader without detection, so that every input reaches it, then cleaning. FUZZ_READER is the
// reader's name. Our own errors are the expected answer to most inputs; anything else is a finding.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace partonomy {
namespace {

/// STL is two formats with one name.
[[maybe_unused]] PolygonSoup parse_stl(std::string_view bytes, const std::string& name) {
    return looks_like_binary_stl(bytes) ? parse_stl_binary(bytes, name) : parse_stl_ascii(bytes, name);
}

}  // namespace
}  // namespace partonomy

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view bytes(reinterpret_cast<const char*>(data), size);
    try {
        static_cast<void>(partonomy::detect_mesh_format(bytes));
        partonomy::MeshReport report;
        const partonomy::PolygonSoup soup = partonomy::FUZZ_READER(bytes, "fuzz");
        const partonomy::TriangleMesh mesh = partonomy::clean_mesh(soup, "fuzz", report);
        static_cast<void>(partonomy::build_adjacency(mesh));
        static_cast<void>(report.sentences());
        if (!partonomy::validate(mesh).empty()) std::abort();
        if (partonomy::compute_topology(mesh).shells != report.shells) std::abort();
    } catch (const partonomy::Error&) {
    }
    return 0;
}
