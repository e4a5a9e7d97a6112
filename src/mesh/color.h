#pragma once

#include <Eigen/Core>

namespace partonomy {

/// Red, green and blue in linear light, 0 to 1 each. Not finite: unknown.
using Color = Eigen::Vector3f;

/// A screen's colour, 0 to 1 each, in linear light: the sRGB curve undone. Beyond 0 and 1 it is cut.
[[nodiscard]] Color linear_from_srgb(const Color& srgb);

/// The colour that no file told.
[[nodiscard]] Color unknown_color();
[[nodiscard]] inline bool is_known(const Color& color) { return color.allFinite(); }

/// A colour as people see it: OKLab, by Björn Ottosson. Distances are alike all over it; 0.02 is just seen.
struct Lab {
    double lightness;                     ///< 0 black to 1 white
    double a, b;                          ///< green to red, blue to yellow; 0 for grey
    [[nodiscard]] double chroma() const;  ///< 0 grey to about 0.32 for the most vivid colours of a screen
    [[nodiscard]] double hue_degrees()
        const;  ///< [0, 360): red 29, orange 60, yellow 110, green 142, blue 264, purple 310
};
[[nodiscard]] Lab lab_from_linear(const Color& color);
[[nodiscard]] double distance(const Lab& x, const Lab& y);

}  // namespace partonomy
