#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "mesh/color.h"
#include "mesh/read_mesh.h"

namespace partonomy {

/// A place in an image: (0, 0) is its upper left corner, (1, 1) its lower right one.
using TexturePoint = Eigen::Vector2f;

/// What an image shows beyond its borders.
enum class Wrap { repeat, mirror, clamp };

/// A decoded image, three sRGB bytes a pixel, row by row from the top.
struct Image {
    int width = 0, height = 0;
    std::vector<std::uint8_t> rgb;
    [[nodiscard]] Color color_at(const TexturePoint& point, Wrap u, Wrap v) const;  ///< of the nearest pixel
};

/// What a part's surface is painted with.
struct Material {
    std::string name;
    Color color = Color::Ones();               ///< times the image, where there is one
    std::optional<float> metallic, roughness;  ///< [0, 1]; nullopt where the file tells nothing
    int image = -1;                            ///< into `images`
    Wrap wrap_u = Wrap::repeat, wrap_v = Wrap::repeat;
};

/// The colours of a PolygonSoup, as a file holds them. Each list is empty where the file has none of its kind.
struct SoupAppearance {
    std::vector<Color> vertex_colors;          ///< #V
    std::vector<Color> face_colors;            ///< #F; where known they hide the vertices' colours
    std::vector<TexturePoint> corner_points;   ///< one per corner of the soup
    std::vector<std::int32_t> face_materials;  ///< #F index into `materials`, or -1
    std::vector<Material> materials;
    std::vector<Image> images;
    [[nodiscard]] bool is_empty() const;
};

/// sRGB numbers as files write them to linear light; all counted to 255 when any of them is above 1.
void from_srgb(std::vector<Color>& colors);

/// Colours and finish of a mesh's surface, kept aside from its geometry: only ontologies that speak of colour pay for
/// it.
struct Appearance {
    std::vector<std::array<Color, 3>> corner_colors;  ///< #T or empty; times the material's, unknown: none of its own
    std::vector<std::array<TexturePoint, 3>> corner_points;  ///< #T or empty
    std::vector<std::int32_t> face_materials;                ///< #T index into `materials`, or -1; or empty
    std::vector<Material> materials;
    std::vector<Image> images;

    /// The colour of triangle t where its corners have these weights; unknown where the file tells none.
    [[nodiscard]] Color color_at(std::size_t t, const Eigen::Vector3f& weights) const;
    /// The material of a triangle; null when it has none.
    [[nodiscard]] const Material* material_of(std::size_t t) const;
    /// Whether the triangle has the same colour all over.
    [[nodiscard]] bool is_plain(std::size_t t) const;
};

/// The appearance of the mesh that was cleaned from `soup`.
[[nodiscard]] Appearance bind_appearance(SoupAppearance colors, const PolygonSoup& soup, const TriangleMesh& mesh);

/// Reads the colours of the file that `mesh` was read from, its material library and images, too; null when there are
/// none. Throws FileError, MeshError: a material library or image that is missing or lies outside the file's folder, a
/// broken image, a file that changed since it was read.
[[nodiscard]] std::shared_ptr<const Appearance> read_appearance(const std::filesystem::path& path,
                                                                const std::string& sha256_when_read,
                                                                const TriangleMesh& mesh);

}  // namespace partonomy
