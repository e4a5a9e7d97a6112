#include "mesh/decode_image.h"

#include <fmt/format.h>

#include <memory>

#include "base/errors.h"

// PNG and JPEG by stb_image, compiled here with nothing else of it: one small file for both formats, no library to load
// when the program starts. Vector instructions are left out, since their rounding differs from processor to processor.
// The size is read first and bounded, so a file of a few bytes cannot ask for gigabytes.

#define STB_IMAGE_IMPLEMENTATION
#define STB_IMAGE_STATIC
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_NO_SIMD
#define STBI_NO_HDR
#define STBI_NO_LINEAR
#define STBI_MAX_DIMENSIONS 16384
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace partonomy {

Image decode_image(std::string_view bytes, const std::string& what) {
    if (!bytes.starts_with("\x89PNG\r\n\x1a\n") && !bytes.starts_with("\xff\xd8\xff"))
        throw MeshError(what + " is no PNG or JPEG image; only these are read");
    if (bytes.size() > largest_image_bytes)
        throw MeshError(fmt::format("{} has {} bytes; at most {} are read", what, bytes.size(), largest_image_bytes));
    const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
    const int size = static_cast<int>(bytes.size());
    Image image;
    int channels = 0;
    if (stbi_info_from_memory(data, size, &image.width, &image.height, &channels) == 0)
        throw MeshError(what + " is broken: its head cannot be read");
    if (image.width <= 0 || image.height <= 0 || image.width > largest_image_side ||
        image.height > largest_image_side || std::int64_t{image.width} * image.height > largest_image_pixels)
        throw MeshError(fmt::format("{} is {} x {} pixels; at most {} a side and {} in all are read", what, image.width,
                                    image.height, largest_image_side, largest_image_pixels));
    const std::unique_ptr<stbi_uc, void (*)(void*)> pixels(
        stbi_load_from_memory(data, size, &image.width, &image.height, &channels, 3), stbi_image_free);
    if (!pixels) throw MeshError(what + " is broken or cut off");
    const std::size_t count =
        std::size_t{3} * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
    image.rgb.assign(pixels.get(), pixels.get() + count);
    return image;
}

}  // namespace partonomy
