#pragma once

#include <array>
#include <cstdint>
#include <memory>

#include "mesh/triangle_mesh.h"
#include "shape/ray_tree.h"

namespace partonomy {

/// A parallel projection of the mesh, which is first moved to its middle and scaled to a diagonal of 1. Unit vectors at
/// right angles; pixel (x, y) looks along `into` at right * (x - center_x) / scale + down * (y - center_y) / scale.
struct Camera {
    Vec3 right = Vec3::UnitX(), down = Vec3::UnitY(), into = Vec3::UnitZ();
    double scale = 1;  ///< pixels for a length of 1
    double center_x = 0, center_y = 0;
};

/// Sixteen rays that are near each other: pixels in, triangles out.
struct RayPacket {
    static constexpr std::size_t size = 16;
    std::array<float, size> x{}, y{};           ///< pixels, fractions allowed
    std::array<std::int32_t, size> triangle{};  ///< first triangle hit, -1 for none
};

/// The mesh as the camera sees it.
class PictureRays {
public:
    /// With a tree of the mesh that is already there (it must outlive this), or nullptr. Throws what RayTree throws.
    PictureRays(const TriangleMesh& mesh, const RayTree* tree);

    /// May be called by several threads.
    void cast(const Camera& camera, RayPacket& packet) const;

    /// A point of the mesh in the frame of cameras.
    [[nodiscard]] Vec3 place(const Vec3& point) const { return tree_->place(point); }

private:
    std::unique_ptr<const RayTree> own_;
    const RayTree* tree_;
};

}  // namespace partonomy
