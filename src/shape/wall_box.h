#pragma once

#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "shape/surface.h"

namespace partonomy {

/// A box whose sides are where the walls of a part are, on the mean: noise does not move it, as it moves a smallest
/// box.
struct WallBox {
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  ///< columns: what most walls face, then most of the others
    Vec3 centre = Vec3::Zero(), lengths = Vec3::Zero();

    [[nodiscard]] double area() const {
        return 2 * (lengths[0] * lengths[1] + lengths[1] * lengths[2] + lengths[2] * lengths[0]);
    }
    /// A point as seen from the centre, along the axes.
    [[nodiscard]] Vec3 place(const Vec3& point) const { return axes.transpose() * (point - centre); }
    /// How far a point is outside of each pair of sides; negative inside.
    [[nodiscard]] Vec3 outside(const Vec3& point) const { return place(point).cwiseAbs() - lengths / 2; }
};

/// A part of a surface, some of its triangles, and how far these are from the sides of its box.
struct Boxed {
    double area = 0;
    std::vector<std::int32_t> some;
    WallBox box;
    std::vector<std::pair<double, double>> distances;  ///< and areas
};

/// Puts some triangles of a part, a few hundred of them, into a box. O(some hundreds).
[[nodiscard]] Boxed put_in_box(const Surface& surface, std::vector<std::int32_t> some, double area);
/// The same for all triangles of a part.
[[nodiscard]] Boxed box_of_part(const Surface& surface, std::span<const std::int32_t> triangles);
/// The boxes of all parts, by number; `part_of` tells the part of each triangle, -1 for none. The same on any number of
/// threads.
[[nodiscard]] std::vector<Boxed> boxes_of_parts(const Surface& surface, std::span<const std::int32_t> part_of,
                                                std::size_t parts);
/// Two parts as if they were one; its triangles are as dense in one as in the other.
[[nodiscard]] Boxed put_in_one_box(const Surface& surface, const Boxed& a, const Boxed& b);

/// How far noise reaches from the sides of boxes: farther out is hardly one point of a hundred. Measured: half of the
/// surface of a box lies within 0.67 standard deviations of its sides, if these are flat. Curved parts make it larger
/// than it is.
[[nodiscard]] double reach_of_noise(const std::vector<Boxed>& parts);

}  // namespace partonomy
