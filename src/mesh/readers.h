#pragma once

#include <string>
#include <string_view>

#include "mesh/companions.h"
#include "mesh/read_mesh.h"

namespace partonomy {

// One reader a format, each in its own file; parse_mesh picks one. All of them throw MeshError. They check every number
// but leave "no vertices, no faces" to parse_mesh. Where `appearance` is null, colours are stepped over.

[[nodiscard]] PolygonSoup parse_off(std::string_view bytes, const std::string& name,
                                    SoupAppearance* appearance = nullptr);
[[nodiscard]] PolygonSoup parse_obj(std::string_view bytes, const std::string& name, const Companions& companions = {},
                                    SoupAppearance* appearance = nullptr);
[[nodiscard]] PolygonSoup parse_stl_ascii(std::string_view bytes, const std::string& name);
[[nodiscard]] PolygonSoup parse_stl_binary(std::string_view bytes, const std::string& name);
[[nodiscard]] PolygonSoup parse_ply(std::string_view bytes, const std::string& name,
                                    SoupAppearance* appearance = nullptr);
[[nodiscard]] PolygonSoup parse_gltf(std::string_view bytes, const std::string& name, const Companions& companions = {},
                                     SoupAppearance* appearance = nullptr);

/// Whether the bytes are a binary STL file, whole or cut off, even when its header begins with "solid".
[[nodiscard]] bool looks_like_binary_stl(std::string_view bytes);

/// Whether a word is the magic word of an OFF file: OFF with the prefixes ST, C, N, 4, n.
[[nodiscard]] bool is_off_header(std::string_view word);

/// Vertices and faces are numbered by 32-bit integers; this many there can be.
inline constexpr std::int64_t largest_count = 0x7fffffff;

}  // namespace partonomy
