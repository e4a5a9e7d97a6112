#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>

#include "mesh/triangle_mesh.h"

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

/// The mesh as Embree likes it: built once, on one thread so that the tree and thus every tie is always the same.
class PictureRays {
public:
    /// Throws Error when Embree cannot start.
    explicit PictureRays(const TriangleMesh& mesh);
    ~PictureRays();
    PictureRays(const PictureRays&) = delete;
    PictureRays& operator=(const PictureRays&) = delete;

    /// May be called by several threads.
    void cast(const Camera& camera, RayPacket& packet) const;

    /// A point of the mesh in the frame of cameras.
    [[nodiscard]] Vec3 place(const Vec3& point) const { return (point - middle_) * factor_; }

private:
    struct Scene;
    Vec3 middle_ = Vec3::Zero();
    double factor_ = 1;
    std::unique_ptr<Scene> scene_;
};

/// Calls work(i) for i in [0, count), on up to `threads` threads, in any order.
void for_each_index(int threads, int count, const std::function<void(int)>& work);

}  // namespace partonomy
