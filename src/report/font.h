#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace partonomy {

inline constexpr int glyph_width = 5, glyph_height = 9,
                     glyph_advance = 6;  ///< pixels; the last two rows hang below the line

/// Character 127 of the font is the multiplication sign.
inline constexpr char times_sign = 127;

/// Whether a pixel of a character is ink; false outside the glyph. Characters 32 to 127 exist, any other looks like
/// '?'.
[[nodiscard]] bool glyph_pixel(char character, int x, int y);

/// UTF-8 as characters that the font has: accents are dropped ("Rückenlehne" -> "Ruckenlehne"), the multiplication sign
/// becomes `times_sign`, what has no likeness '?'. Combining marks vanish; bytes that are not UTF-8 are '?' each.
[[nodiscard]] std::string to_font(std::string_view utf8);

}  // namespace partonomy
