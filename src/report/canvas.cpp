// The PNG is written by libpng with rows unfiltered and fast compression: pictures of parts are flat areas on white,
// where more effort saves a few kilobytes and costs more time than the rays.

#include "report/canvas.h"

#include <png.h>

#include <algorithm>
#include <cstring>
#include <memory>
#include <optional>

#include "base/errors.h"
#include "report/font.h"

namespace partonomy {
namespace {

/// Ink of a glyph at twice its size: a corner is cut where two neighbours of the same colour meet (the Scale2x rule).
bool smooth_pixel(char c, int x, int y) {
    const int px = x >> 1, py = y >> 1;
    const bool here = glyph_pixel(c, px, py);
    const bool side = glyph_pixel(c, px + ((x & 1) != 0 ? 1 : -1), py);
    const bool other_side = glyph_pixel(c, px + ((x & 1) != 0 ? -1 : 1), py);
    const bool above = glyph_pixel(c, px, py + ((y & 1) != 0 ? 1 : -1));
    const bool below = glyph_pixel(c, px, py + ((y & 1) != 0 ? -1 : 1));
    return side == above && side != below && above != other_side ? side : here;
}

struct Palette {
    std::vector<Color> colors;
    std::vector<std::uint8_t> pixels;  ///< index into colors
};

/// The picture as numbers of colours in the order of their first appearance; nullopt when there are more than 256.
std::optional<Palette> make_palette(const Canvas& canvas) {
    constexpr std::size_t slots = 1024;       // open addressing, at most a quarter full
    std::array<std::int32_t, slots> table{};  // 0 for free, else index + 1
    Palette palette;
    palette.pixels.resize(canvas.rgb.size() / 3);
    Color last{};
    std::uint8_t last_index = 0;
    constexpr std::size_t run = 8;  // most pixels are like the ones before them
    std::array<std::uint8_t, 3 * run> like_last{};
    for (std::size_t p = 0; p < palette.pixels.size(); ++p) {
        while (p > 0 && p + run <= palette.pixels.size() &&
               std::memcmp(&canvas.rgb[3 * p], like_last.data(), like_last.size()) == 0) {
            std::memset(&palette.pixels[p], last_index, run);
            p += run;
        }
        if (p == palette.pixels.size()) break;
        const Color color{canvas.rgb[3 * p], canvas.rgb[3 * p + 1], canvas.rgb[3 * p + 2]};
        if (p == 0 || color != last) {
            const std::uint32_t key = color[0] | color[1] << 8 | color[2] << 16;
            std::size_t slot = (key * 2654435761U) >> 22;
            while (table[slot] != 0 && palette.colors[static_cast<std::size_t>(table[slot] - 1)] != color)
                slot = (slot + 1) % slots;
            if (table[slot] == 0) {
                if (palette.colors.size() == 256) return std::nullopt;
                palette.colors.push_back(color);
                table[slot] = static_cast<std::int32_t>(palette.colors.size());
            }
            last = color;
            last_index = static_cast<std::uint8_t>(table[slot] - 1);
            for (std::size_t i = 0; i < run; ++i) std::memcpy(&like_last[3 * i], color.data(), color.size());
        }
        palette.pixels[p] = last_index;
    }
    return palette;
}

}  // namespace

void Canvas::fill(int x, int y, int w, int h, Color color) {
    for (int j = std::max(y, 0); j < std::min(y + h, height); ++j)
        for (int i = std::max(x, 0); i < std::min(x + w, width); ++i) set(i, j, color);
}

void Canvas::text(int x, int y, std::string_view characters, Color color, int scale) {
    for (const char c : characters) {
        for (int j = 0; j < glyph_height * scale; ++j)
            for (int i = 0; i < glyph_width * scale; ++i)
                if (scale == 2 ? smooth_pixel(c, i, j) : glyph_pixel(c, i / scale, j / scale)) set(x + i, y + j, color);
        x += glyph_advance * scale;
    }
}

int Canvas::text_width(std::string_view characters, int scale) {
    return static_cast<int>(characters.size()) * glyph_advance * scale;
}

std::string encode_png(const Canvas& canvas) {
    const std::optional<Palette> palette = make_palette(canvas);
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    image.width = static_cast<png_uint_32>(canvas.width);
    image.height = static_cast<png_uint_32>(canvas.height);
    image.format = palette ? PNG_FORMAT_RGB_COLORMAP : PNG_FORMAT_RGB;
    image.flags = PNG_IMAGE_FLAG_FAST;
    image.colormap_entries = palette ? static_cast<png_uint_32>(palette->colors.size()) : 0;
    const void* pixels = palette ? palette->pixels.data() : canvas.rgb.data();
    const void* colors = palette ? palette->colors.data() : nullptr;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(image);
    const auto bytes = std::make_unique_for_overwrite<char[]>(size);  // little of it will be touched
    if (png_image_write_to_memory(&image, bytes.get(), &size, 0, pixels, 0, colors) == 0)
        throw Error(std::string("the preview cannot be encoded as PNG: ") + image.message);
    return {bytes.get(), size};
}

}  // namespace partonomy
