#pragma once

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <random>
#include <vector>

#include "algorithms/relations.h"
#include "shape/part_box.h"

// Scenes of turned boxes and tubes, each a region, with all there is to know about them.

namespace partonomy::solids {

/// A box around `centre` with sides 2 `half` along the columns of `axes`.
struct Block {
    Vec3 centre, half;
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    [[nodiscard]] Vec3 at(double x, double y, double z) const {
        return centre + axes * Vec3(x * half.x(), y * half.y(), z * half.z());
    }
};

inline Block block(const Vec3& low, const Vec3& high, double degrees_about_z = 0) {
    return {(low + high) / 2, (high - low) / 2,
            Eigen::AngleAxisd(degrees_about_z * std::numbers::pi / 180, Vec3::UnitZ()).toRotationMatrix()};
}

/// How a scene is moved as a whole, and how rough its surface is.
struct Motion {
    double degrees = 0, scale = 1, noise = 0;  ///< noise: root mean square shift of a vertex, over the diagonal
    Vec3 shift = Vec3::Zero();
};

inline Motion random_motion(std::mt19937& random, double noise) {
    std::uniform_real_distribution<double> any(0, 1);
    const double degrees = 360 * any(random), scale = std::pow(10, 4 * any(random) - 2);
    return {degrees, scale, noise, 100 * scale * Vec3(any(random), any(random), any(random))};
}

/// Regions of one object and what relations read of them.
class Stage {
public:
    /// Each face of a box is cut into `steps` by `steps` squares.
    explicit Stage(const std::vector<Block>& blocks, int steps = 1) {
        for (const Block& each : blocks) add(each, steps);
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    void add(const Block& box, int steps = 1) {
        begin();
        for (int axis = 0; axis < 3; ++axis)
            for (const double side : {-1.0, 1.0}) {
                const auto first = static_cast<std::int32_t>(object.mesh.positions.size());
                for (int i = 0; i <= steps; ++i)
                    for (int j = 0; j <= steps; ++j) {
                        Vec3 p;
                        p[axis] = side;
                        p[(axis + 1) % 3] = 2.0 * i / steps - 1;
                        p[(axis + 2) % 3] = 2.0 * j / steps - 1;
                        object.mesh.positions.push_back(box.at(p.x(), p.y(), p.z()));
                    }
                for (int i = 0; i < steps; ++i)
                    for (int j = 0; j < steps; ++j) {
                        const std::int32_t a = first + i * (steps + 1) + j, b = a + steps + 1;
                        quad(a, b, b + 1, a + 1, side < 0);
                    }
            }
    }
    /// Any surface.
    void add(const TriangleMesh& mesh, const Vec3& at = Vec3::Zero()) {
        begin();
        const auto first = static_cast<std::int32_t>(object.mesh.positions.size());
        for (const Vec3& p : mesh.positions) object.mesh.positions.push_back(p + at);
        for (const auto& [a, b, c] : mesh.triangles) triangle({first + a, first + b, first + c});
    }
    /// The wall of a tube around z.
    void add_ring(const Vec3& centre, double radius, double half_height, int around = 48) {
        begin();
        const auto first = static_cast<std::int32_t>(object.mesh.positions.size());
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * std::numbers::pi * i / around;
            for (const double z : {-half_height, half_height})
                object.mesh.positions.push_back(centre + Vec3(radius * std::cos(angle), radius * std::sin(angle), z));
        }
        for (int i = 0; i < around; ++i) {
            const std::int32_t next = (i + 1) % around;
            quad(first + 2 * i, first + 2 * next, first + 2 * next + 1, first + 2 * i + 1, false);
        }
    }
    /// After the last region was added.
    void move(const Motion& motion, std::mt19937& random) {
        const double size = compute_bounds(object.mesh).diagonal();
        std::normal_distribution<double> shake(0, motion.noise * size / std::sqrt(3.0));
        object.is_noisy = motion.noise > 0;
        const Eigen::AngleAxisd turn(motion.degrees * std::numbers::pi / 180, Vec3::UnitZ());
        for (Vec3& p : object.mesh.positions) {
            if (motion.noise > 0) p += Vec3(shake(random), shake(random), shake(random));
            p = motion.scale * (turn * p) + motion.shift;
        }
    }
    void finish() {
        object.geometry = compute_geometry(object.mesh);
        for (PartRegion& part : parts)
            part.box = measure_part(object.mesh, object.geometry, part.region.triangles, object.is_noisy).box;
        scene = scene_of(object);
        places.clear();
        for (const PartRegion& part : parts) places.push_back(place_of(scene, part));
    }
    [[nodiscard]] std::vector<const RegionPlace*> at(const std::vector<int>& regions) const {
        std::vector<const RegionPlace*> result;
        for (const int region : regions) result.push_back(&places[static_cast<std::size_t>(region)]);
        return result;
    }

    Object object;
    std::vector<PartRegion> parts;
    Scene scene;
    std::vector<RegionPlace> places;

private:
    void begin() { parts.emplace_back(); }
    void triangle(const std::array<std::int32_t, 3>& corners) {
        parts.back().region.triangles.push_back(static_cast<std::int32_t>(object.mesh.triangles.size()));
        parts.back().region.memberships.push_back(1);
        object.mesh.triangles.push_back(corners);
    }
    void quad(std::int32_t a, std::int32_t b, std::int32_t c, std::int32_t d, bool reversed) {
        for (std::array<std::int32_t, 3> triangle : {std::array{a, b, c}, std::array{a, c, d}}) {
            if (reversed) std::swap(triangle[1], triangle[2]);
            this->triangle(triangle);
        }
    }
};

}  // namespace partonomy::solids
