#pragma once

#include <array>

#include "mesh/color.h"

namespace partonomy {

/// The eleven basic colour terms, by which people of most languages sort all colours (Berlin and Kay).
inline constexpr std::array<const char*, 11> color_names = {"black", "grey", "white",  "red",  "orange", "yellow",
                                                            "green", "blue", "purple", "pink", "brown"};

/// How much a colour is called by each name: at least 0, together 1. In the middle of a name's range it is 1; where two
/// names meet it goes over from one to the other.
[[nodiscard]] std::array<double, 11> name_color(const Lab& color);

}  // namespace partonomy
