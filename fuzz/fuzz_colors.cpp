#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "base/errors.h"
#include "mesh/appearance.h"
#include "mesh/material_library.h"
#include "mesh/readers.h"

// Readers with the colours of what they read: FUZZ_COLORS is gltf, mtl, or mesh for the format that is told by content.
// There are no files beside the input, so images come from the input itself.

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

namespace partonomy {
namespace {

void look_at(const PolygonSoup& soup, SoupAppearance colors) {
    MeshReport report;
    const TriangleMesh mesh = clean_mesh(soup, "fuzz", report);
    if (!validate(mesh).empty()) std::abort();
    const Appearance appearance = bind_appearance(std::move(colors), soup, mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Color color = appearance.color_at(t, Eigen::Vector3f::Constant(1.0F / 3));
        if (is_known(color) && (color.minCoeff() < 0 || color.maxCoeff() > 1.0001F)) std::abort();
    }
}

[[maybe_unused]] void try_gltf(std::string_view bytes) {
    SoupAppearance colors;
    const PolygonSoup soup = parse_gltf(bytes, "fuzz", {}, &colors);
    look_at(soup, std::move(colors));
}

[[maybe_unused]] void try_mesh(std::string_view bytes) {
    SoupAppearance colors;
    const PolygonSoup soup = parse_mesh(bytes, "fuzz", {}, &colors);
    look_at(soup, std::move(colors));
}

[[maybe_unused]] void try_mtl(std::string_view bytes) {
    for (const LibraryMaterial& material : parse_mtl(bytes, "fuzz"))
        if (!material.image.empty()) static_cast<void>(material.image_path());
}

}  // namespace
}  // namespace partonomy

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    try {
        partonomy::FUZZ_COLORS({reinterpret_cast<const char*>(data), size});
    } catch (const partonomy::Error&) {
    }
    return 0;
}
