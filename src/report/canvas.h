#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace partonomy {

using Color = std::array<std::uint8_t, 3>;

/// A picture in memory, white at first; rows from the top, three bytes a pixel. Drawing outside of it is clipped.
struct Canvas {
    int width, height;
    std::vector<std::uint8_t> rgb;

    Canvas(int w, int h)
        : width(w), height(h), rgb(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) * 3, 255) {}

    void set(int x, int y, Color color) {
        if (x < 0 || x >= width || y < 0 || y >= height) return;
        std::uint8_t* pixel =
            &rgb[(static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) * 3];
        pixel[0] = color[0], pixel[1] = color[1], pixel[2] = color[2];
    }

    void fill(int x, int y, int w, int h, Color color);

    /// Text in the font's characters (see to_font), its top left corner at (x, y). At scale 2 slanted strokes are
    /// smoothed.
    void text(int x, int y, std::string_view characters, Color color, int scale = 1);

    [[nodiscard]] static int text_width(std::string_view characters, int scale = 1);
};

/// The picture as a PNG file. Equal pictures give equal bytes.
[[nodiscard]] std::string encode_png(const Canvas& canvas);

}  // namespace partonomy
