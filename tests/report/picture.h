#pragma once

#include <gtest/gtest.h>
#include <png.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace partonomy {

using Color = std::array<std::uint8_t, 3>;

struct Picture {
    int width = 0, height = 0;
    std::vector<Color> pixels;
    [[nodiscard]] Color at(int x, int y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }
};

inline Picture decode(const std::string& bytes) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_memory(&image, bytes.data(), bytes.size()), 0) << image.message;
    image.format = PNG_FORMAT_RGB;
    Picture picture{static_cast<int>(image.width), static_cast<int>(image.height), {}};
    picture.pixels.resize(image.width * image.height);
    EXPECT_NE(png_image_finish_read(&image, nullptr, picture.pixels.data(), 0, nullptr), 0) << image.message;
    return picture;
}

/// Pixels of a part's colour, in whatever light.
inline int shaded_pixels(const Picture& picture, Color color) {
    const Eigen::Vector3d wanted = Eigen::Vector3d(color[0], color[1], color[2]).normalized();
    return static_cast<int>(std::ranges::count_if(picture.pixels, [&](const Color& pixel) {
        const Eigen::Vector3d seen(pixel[0], pixel[1], pixel[2]);
        return seen.norm() > 80 && seen.normalized().dot(wanted) > 0.9985;
    }));
}

}  // namespace partonomy
