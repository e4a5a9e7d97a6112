/* Names of colours, as shares that add up to one.
 *
 * Hue runs in a circle, and brown is a dark orange, pink a light red: no trapezoid over one number tells them. So the
 * circle is cut into sectors whose borders are ramps a few degrees wide, light and dark colours of a sector are told
 * apart by ramps over lightness, and what has hardly any colour goes to black, grey and white. All borders lie in
 * OKLCh: lightness 0 to 1, chroma 0 to about 0.3, hue in degrees. Where they lie was chosen by the named colours of
 * CSS that carry one of the eleven words, and by those whose name people do not doubt (navy is blue, gold is yellow).
 *
 * A region's share of a name is the mean over its area, and that is a number for trapezoids. */

#include "algorithms/color_names.h"

#include <algorithm>

namespace partonomy {
namespace {

enum Name { black, grey, white, red, orange, yellow, green, blue, purple, pink, brown };

/// 0 below low, 1 above high.
double ramp(double x, double low, double high) { return std::clamp((x - low) / (high - low), 0.0, 1.0); }

struct Border {
    double degrees, half_width;
};

/// Sectors of the hue circle, each with the border at which it begins; the last one ends where the first begins.
enum Sector { rose, reds, oranges, yellows, greens, blues, purples, sector_count };
constexpr std::array<Border, sector_count> borders = {
    {{342, 6}, {12, 4}, {43, 4}, {85, 4}, {120, 4}, {192, 5}, {290, 5}}};

/// How much a hue lies in each sector; together 1.
std::array<double, sector_count> sectors_of(double hue) {
    std::array<double, sector_count> shares{};
    for (int s = 0; s < sector_count; ++s) {
        const auto turned = [&](double degrees) { return degrees - 360 * (degrees >= 180) + 360 * (degrees < -180); };
        const auto past = [&](const Border& border) {
            return ramp(turned(hue - border.degrees), -border.half_width, border.half_width);
        };
        const Border& begin = borders[static_cast<std::size_t>(s)];
        const Border& end = borders[static_cast<std::size_t>((s + 1) % sector_count)];
        // No sector is as wide as half of the circle, so what lies past its begin and not past its end lies in it.
        shares[static_cast<std::size_t>(s)] = std::max(0.0, past(begin) - past(end));
    }
    return shares;
}

}  // namespace

std::array<double, 11> name_color(const Lab& color) {
    std::array<double, 11> names{};
    const double light = color.lightness, chroma = color.chroma();
    const double too_dark = 1 - ramp(light, 0.14, 0.2);  // for any hue to be seen
    const double colored = ramp(chroma, 0.025, 0.045) * (1 - too_dark);
    const double dark = std::max(too_dark, 1 - ramp(light, 0.26, 0.36)), pale = ramp(light, 0.88, 0.95);
    names[black] = (1 - colored) * dark;
    names[white] = (1 - colored) * pale;
    names[grey] = (1 - colored) * (1 - dark - pale);
    if (colored == 0) return names;

    const std::array<double, sector_count> shares = sectors_of(color.hue_degrees());
    const auto give = [&](Sector sector, Name a, Name b, double share_of_b) {
        const double share = colored * shares[sector];
        names[a] += share * (1 - share_of_b);
        names[b] += share * share_of_b;
    };
    const double is_past_zero = color.hue_degrees() < 180 ? 1 : ramp(color.hue_degrees(), 350, 358);
    const double rose_is_pink = ramp(light, 0.56, 0.64);
    give(rose, purple, pink, rose_is_pink);
    const double deep_rose = colored * shares[rose] * (1 - rose_is_pink) * is_past_zero;  // crimson, wine
    names[purple] -= deep_rose;
    names[red] += deep_rose;
    give(reds, red, pink, ramp(light, 0.72, 0.8));
    give(oranges, brown, orange, ramp(light, 0.6, 0.67));
    give(yellows, brown, yellow, ramp(light, 0.62, 0.7));
    const double olive = ramp(color.hue_degrees(), 98, 106);  // dark yellows are brown or green
    const double dark_yellow = colored * shares[yellows] * (1 - ramp(light, 0.62, 0.7)) * olive;
    names[brown] -= dark_yellow;
    names[green] += dark_yellow;
    names[green] += colored * shares[greens];
    names[blue] += colored * shares[blues];
    give(purples, purple, pink, ramp(light, 0.82, 0.9));
    return names;
}

}  // namespace partonomy
