#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "mesh/appearance.h"

namespace partonomy {

/// A material as an MTL file tells it.
struct LibraryMaterial {
    Material material;
    std::string library;                     ///< name of the MTL file
    std::string folder;                      ///< of the MTL file inside the model's, with a slash; mostly empty
    std::string image;                       ///< map_Kd as written; empty: none
    long image_line = 0;                     ///< where it stands
    TexturePoint scale{1, 1}, offset{0, 0};  ///< of texture points
    /// `image` seen from the model's folder.
    [[nodiscard]] std::string image_path() const;
};

/// No material library is larger.
inline constexpr std::uintmax_t largest_library_bytes = std::uintmax_t{1} << 26;

/// Reads an MTL file: newmtl, Kd, Ks, Ns, Pm, Pr, map_Kd; the rest is stepped over. Throws MeshError naming the line.
[[nodiscard]] std::vector<LibraryMaterial> parse_mtl(std::string_view bytes, const std::string& name);

}  // namespace partonomy
