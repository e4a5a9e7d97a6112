#include "mesh/color.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace partonomy {

Color linear_from_srgb(const Color& srgb) {
    return srgb.unaryExpr([](float s) {
        if (std::isnan(s)) return s;
        s = std::clamp(s, 0.0F, 1.0F);
        return s <= 0.04045F ? s / 12.92F : std::pow((s + 0.055F) / 1.055F, 2.4F);
    });
}

Color unknown_color() { return Color::Constant(std::numeric_limits<float>::quiet_NaN()); }

double Lab::chroma() const { return std::hypot(a, b); }

double Lab::hue_degrees() const {
    const double degrees = std::atan2(b, a) * 180 / std::numbers::pi;
    return degrees < 0 ? degrees + 360 : degrees;
}

Lab lab_from_linear(const Color& color) {
    const double r = color.x(), g = color.y(), b = color.z();
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

double distance(const Lab& x, const Lab& y) { return std::hypot(x.lightness - y.lightness, x.a - y.a, x.b - y.b); }

}  // namespace partonomy
