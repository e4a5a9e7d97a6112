// Eighteen colours that stay apart in print and on screens, in an order where neighbours differ most; the first ten are
// near the palette of furniture.ttl. White, black and the grey of unlabelled triangles are left free.

#include <charconv>
#include <cstddef>
#include <optional>
#include <string_view>

#include "report/write.h"

namespace partonomy {
namespace {

using Color = std::array<std::uint8_t, 3>;

constexpr std::array<Color, 18> palette{{
    {78, 121, 167},
    {242, 142, 43},
    {89, 161, 79},
    {225, 87, 89},
    {176, 122, 161},
    {237, 201, 72},
    {118, 183, 178},
    {156, 117, 95},
    {255, 157, 167},
    {44, 82, 140},
    {160, 203, 232},
    {155, 190, 60},
    {148, 64, 110},
    {0, 128, 128},
    {200, 110, 20},
    {120, 90, 190},
    {60, 110, 50},
    {214, 120, 200},
}};

/// "#rrggbb"; nullopt for anything else.
std::optional<Color> parse_color(std::string_view text) {
    if (text.size() != 7 || text[0] != '#') return std::nullopt;
    Color color{};
    for (std::size_t i = 0; i < 3; ++i) {
        const char* begin = text.data() + 1 + 2 * i;
        const auto [stop, error] = std::from_chars(begin, begin + 2, color[i], 16);
        if (error != std::errc() || stop != begin + 2) return std::nullopt;
    }
    return color;
}

}  // namespace

std::array<std::uint8_t, 3> color_of(const AnnotatedPart& part) {
    if (const auto own = parse_color(part.color)) return *own;
    const auto count = static_cast<long long>(palette.size());
    const long long index = ((static_cast<long long>(part.id) - 1) % count + count) % count;
    return palette[static_cast<std::size_t>(index)];
}

}  // namespace partonomy
