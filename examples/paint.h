#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "examples/objects.h"
#include "mesh/appearance.h"

namespace partonomy {

/// What faces of an example are painted with; the colour as on a screen.
struct Paint {
    std::string name;
    std::array<std::uint8_t, 3> rgb{255, 255, 255};
    double metallic = 0, roughness = 0.9;
    std::optional<Image> image;  ///< in place of the colour
};

/// An example with colours.
struct PaintedObject {
    ExampleObject object;
    std::vector<Paint> paints;
    std::vector<int> paint_of;                        ///< per triangle: into `paints`
    std::vector<std::array<TexturePoint, 3>> points;  ///< per triangle: places in the image; empty without images
};

/// An image of so many pixels whose colour at (x, y) is `color(x, y)`.
template <class ColorAt>
[[nodiscard]] Image make_image(int width, int height, const ColorAt& color) {
    Image image{width, height, {}};
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            for (const std::uint8_t byte : std::array<std::uint8_t, 3>(color(x, y))) image.rgb.push_back(byte);
    return image;
}

/// A PNG file of the image.
[[nodiscard]] std::string to_png(const Image& image);

/// ASCII PLY with the colours of faces; images become white.
[[nodiscard]] std::string to_ply(const PaintedObject& painted);

/// GLB: +y up, metres, a primitive for each run of faces with one paint, images inside.
[[nodiscard]] std::string to_glb(const PaintedObject& painted);

/// An OBJ file, its material library and its images by file name: NAME.obj, NAME.mtl, NAME-0.png …
[[nodiscard]] std::vector<std::pair<std::string, std::string>> to_obj(const PaintedObject& painted);

/// The appearance that a file of it would give.
[[nodiscard]] std::shared_ptr<const Appearance> appearance_of(const PaintedObject& painted);

}  // namespace partonomy
