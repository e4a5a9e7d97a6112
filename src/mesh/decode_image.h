#pragma once

#include <string>
#include <string_view>

#include "mesh/appearance.h"

namespace partonomy {

/// No image is wider, higher or has more pixels.
inline constexpr int largest_image_side = 16384;
inline constexpr std::int64_t largest_image_pixels = std::int64_t{1} << 26;

/// No image file is larger.
inline constexpr std::uintmax_t largest_image_bytes = std::uintmax_t{1} << 28;

/// The pixels of a PNG or JPEG file. `what` begins the error sentence: "chair.gltf: image 2". Throws MeshError: another
/// format, too large, broken.
[[nodiscard]] Image decode_image(std::string_view bytes, const std::string& what);

}  // namespace partonomy
