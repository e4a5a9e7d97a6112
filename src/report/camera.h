#pragma once

#include <Eigen/Geometry>

#include "mesh/triangle_mesh.h"

namespace partonomy {

/// A rectangle of pixels.
struct Frame {
    int left = 0, top = 0, width = 0, height = 0;
};

/// A parallel projection. Unit vectors at right angles; the point p of the (placed) mesh is seen at pixel
/// (center_x + scale p.right, center_y + scale p.down), p.into behind the middle.
struct Camera {
    Vec3 right = Vec3::UnitX(), down = Vec3::UnitY(), into = Vec3::UnitZ();
    double scale = 1;  ///< pixels for a length of 1
    double center_x = 0, center_y = 0;

    /// Pixel column, pixel row and depth.
    [[nodiscard]] Vec3 see(const Vec3& point) const {
        return {center_x + scale * point.dot(right), center_y + scale * point.dot(down), point.dot(into)};
    }
};

/// A mesh whose used points are moved to the middle of their bounding box and scaled to a diagonal of 1, so that
/// cameras need not care about its units.
class PlacedMesh {
public:
    /// The mesh must outlive this.
    explicit PlacedMesh(const TriangleMesh& mesh) : mesh_(mesh) {
        if (mesh.triangles.empty()) return;
        const Bounds bounds = compute_used_bounds(mesh);
        middle_ = bounds.middle();
        const double diagonal = (bounds.high / 2 - bounds.low / 2).stableNorm() * 2;
        if (diagonal > 0) scale_ = 1 / diagonal;
    }

    [[nodiscard]] std::size_t triangle_count() const { return mesh_.triangles.size(); }
    [[nodiscard]] Vec3 place(const Vec3& point) const { return (point - middle_) * scale_; }
    [[nodiscard]] Vec3 corner(std::size_t triangle, std::size_t i) const {
        return place(mesh_.positions[static_cast<std::size_t>(mesh_.triangles[triangle][i])]);
    }

private:
    const TriangleMesh& mesh_;
    Vec3 middle_ = Vec3::Zero();
    double scale_ = 1;
};

}  // namespace partonomy
