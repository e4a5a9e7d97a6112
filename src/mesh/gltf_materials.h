#pragma once

#include <map>
#include <optional>
#include <set>

#include "mesh/appearance.h"
#include "mesh/gltf_file.h"

namespace partonomy {

/// Gathers the materials and images that the primitives of a glTF file use.
class MaterialMaps {
public:
    MaterialMaps(GltfFile& file, SoupAppearance& appearance) : file_(file), appearance_(appearance) {}

    /// What one primitive's faces and corners are painted with.
    struct Use {
        std::int32_t material = -1;
        std::optional<GltfNumbers> points;  ///< texture points, where the material has an image
        Eigen::Matrix<float, 2, 3> transform = Eigen::Matrix<float, 2, 3>::Identity();  ///< of texture points
    };
    /// Throws MeshError for a broken material, image or list of texture points.
    [[nodiscard]] Use use(const GltfValue& primitive, std::size_t vertex_count);

    void add_corner(const Use& use, std::size_t vertex);
    void add_face(const Use& use);

private:
    struct Known {
        std::int32_t number;
        std::uint64_t points_set = 0;
        Eigen::Matrix<float, 2, 3> transform = Eigen::Matrix<float, 2, 3>::Identity();
    };
    Known read(const GltfValue& material);
    int read_image(const GltfValue& texture);

    GltfFile& file_;
    SoupAppearance& appearance_;
    std::map<std::size_t, Known> materials_;  ///< by number in the file
    std::map<std::size_t, int> images_;
    std::size_t corners_ = 0;  ///< told so far
};

}  // namespace partonomy
