// The quick answer for what most parts of clean models are: a plain board, a straight stick or a cube.
//
// Two walls make a slab when all their triangles face along one direction and lie in one of two planes, and when their
// outline leaves little of its convex hull empty, and the hull little of its smallest rectangle. Four walls make a bar
// when all face across one axis and their area is that of the sides of a convex prism along it, whose cross-section,
// again, is nearly a rectangle. Six walls make a block when each lies in a side of one box and covers most of it. In
// such a piece there is nothing to be cut, and looking around with rays would tell no more. Slight bends and tapers
// pass: what is asked later is whether one way is twice another.
//
// Cost: O(n log n) for n triangles.

#include "shape/plain_pieces.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/ranges.h"
#include "shape/corners.h"
#include "shape/rectangle.h"

namespace partonomy {

namespace {

const double flat_cosine = std::cos(12 * std::numbers::pi / 180);
const double across_cosine = std::cos(84 * std::numbers::pi / 180);
constexpr double flatness = 0.15;         // of the thickness: as far from its plane may a wall lie
constexpr double least_convexity = 0.95;  // of the area of a convex outline or prism
constexpr double least_side = 0.6;        // of two sides of a block: other parts may stand on them
constexpr double least_squareness = 0.8;  // of a rectangle's area

/// The triangles' corners as seen along a direction.
struct Outline {
    Vec3 x, y;
    std::vector<Planar> hull;

    Outline(const Surface& s, const std::vector<std::int32_t>& triangles, const Vec3& direction)
        : x(direction.unitOrthogonal()), y(direction.cross(x)) {
        const Vec3& start = s.geometry.barycentres[triangles.front()];
        const std::vector<std::int32_t> corners = corners_of(s.mesh, triangles);
        std::vector<Planar> points;
        points.reserve(corners.size());
        for (const std::int32_t corner : corners) {
            const Vec3 p = s.mesh.positions[corner] - start;
            points.push_back({p.dot(x), p.dot(y)});
        }
        convex_hull(points, hull);
    }
};

/// The rectangle around an outline that nearly fills it, its width the longer side.
std::optional<Rectangle> as_rectangle(const std::vector<Planar>& hull, double size) {
    Rectangle rectangle = smallest_rectangle(hull, size);
    if (!(rectangle.height > 0) || area_of(hull) < least_squareness * rectangle.width * rectangle.height)
        return std::nullopt;
    if (rectangle.width < rectangle.height) {
        std::swap(rectangle.width, rectangle.height);
        rectangle.side = {-rectangle.side.y, rectangle.side.x};
    }
    return rectangle;
}

std::optional<PlainPiece> as_slab(const Surface& s, const std::vector<std::int32_t>& triangles, double thickness,
                                  double area) {
    const Vec3 facing = s.geometry.normals[triangles.front()];
    Vec3 sum = Vec3::Zero();
    for (const std::int32_t i : triangles) {
        const double along = s.geometry.normals[i].dot(facing);
        if (std::abs(along) < flat_cosine) return std::nullopt;
        sum += (along > 0 ? s.geometry.areas[i] : -s.geometry.areas[i]) * s.geometry.normals[i];
    }
    const Vec3 normal = sum.normalized(), start = s.geometry.barycentres[triangles.front()];
    for (const std::int32_t i : triangles) {
        const double plane = s.geometry.normals[i].dot(normal) > 0 ? 0 : -thickness;
        const double place = (s.geometry.barycentres[i] - start).dot(normal);
        if (std::abs(place - plane) > flatness * thickness) return std::nullopt;
    }
    const Outline outline(s, triangles, normal);
    if (area / 2 < least_convexity * area_of(outline.hull)) return std::nullopt;
    const auto rectangle = as_rectangle(outline.hull, s.size);
    if (!rectangle) return std::nullopt;
    return PlainPiece{area_of(outline.hull) / rectangle->width, rectangle->width,
                      rectangle->side.x * outline.x + rectangle->side.y * outline.y};
}

std::optional<PlainPiece> as_bar(const Surface& s, const std::vector<std::int32_t>& triangles, double thickness,
                                 double area) {
    Eigen::Matrix3d facing = Eigen::Matrix3d::Zero();
    for (const std::int32_t i : triangles)
        facing += s.geometry.areas[i] * s.geometry.normals[i] * s.geometry.normals[i].transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(facing);
    const Vec3 axis = eigen.eigenvectors().col(0);
    double low = 0, high = 0;
    const Vec3 start = s.geometry.barycentres[triangles.front()];
    for (const std::int32_t i : triangles) {
        if (std::abs(s.geometry.normals[i].dot(axis)) > across_cosine) return std::nullopt;
        for (const std::int32_t corner : s.mesh.triangles[i]) {
            const double place = (s.mesh.positions[corner] - start).dot(axis);
            low = std::min(low, place), high = std::max(high, place);
        }
    }
    const Outline outline(s, triangles, axis);
    if (area < least_convexity * perimeter_of(outline.hull) * (high - low)) return std::nullopt;
    const auto section = as_rectangle(outline.hull, s.size);
    if (!section || section->height < flatness * thickness) return std::nullopt;
    const double across = section->width * section->height / thickness;  // the side that is not the thickness
    if (across < high - low) return PlainPiece{across, high - low, axis};
    return PlainPiece{high - low, across, section->side.x * outline.x + section->side.y * outline.y};
}

/// Six walls, each in one side of a box.
std::optional<PlainPiece> as_block(const Surface& s, const std::vector<std::int32_t>& triangles, double thickness) {
    const Vec3 facing = s.geometry.normals[triangles.front()], start = s.geometry.barycentres[triangles.front()];
    const auto beside = std::ranges::find_if(
        triangles, [&](std::int32_t i) { return std::abs(s.geometry.normals[i].dot(facing)) < across_cosine; });
    if (beside == triangles.end()) return std::nullopt;
    Eigen::Matrix3d axes;
    axes.col(0) = facing;
    axes.col(2) = facing.cross(s.geometry.normals[*beside]).normalized();
    axes.col(1) = axes.col(2).cross(facing);
    struct Walls {
        bool are_sides = true;
        Vec3 areas = Vec3::Zero();                     // of those across each axis
        Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // as far as the triangles' middles reach
    };
    const auto map_triangles = [&](const auto& look) {
        return map_blocks(triangles.size(), s.threads, [&](std::size_t begin, std::size_t end) {
            Walls walls;
            for (std::size_t k = begin; k < end && walls.are_sides; ++k) {
                const std::int32_t i = triangles[k];
                const Vec3 normal = axes.transpose() * s.geometry.normals[i];
                Eigen::Index axis = 0;
                normal.cwiseAbs().maxCoeff(&axis);
                look(walls, i, axis, normal[axis]);
            }
            return walls;
        });
    };
    Walls all;
    for (const Walls& some : map_triangles([&](Walls&walls, std::int32_t i, Eigen::Index axis, double cosine) {
             walls.are_sides = std::abs(cosine) > flat_cosine;
             walls.areas[axis] += s.geometry.areas[i];
             const Vec3 place = axes.transpose() * (s.geometry.barycentres[i] - start);
             walls.low = walls.low.cwiseMin(place);
             walls.high = walls.high.cwiseMax(place);
         })) {
        if (!some.are_sides) return std::nullopt;
        all.areas += some.areas;
        all.low = all.low.cwiseMin(some.low);
        all.high = all.high.cwiseMax(some.high);
    }
    const Vec3 lengths = all.high - all.low;
    for (int a = 0; a < 3; ++a)
        if (all.areas[a] < least_side * 2 * lengths[(a + 1) % 3] * lengths[(a + 2) % 3]) return std::nullopt;
    for (const Walls& some : map_triangles([&](Walls&walls, std::int32_t i, Eigen::Index axis, double cosine) {
             const double place = axes.col(axis).dot(s.geometry.barycentres[i] - start);
             walls.are_sides = std::abs(place - (cosine > 0 ? all.high : all.low)[axis]) < flatness * thickness;
         }))
        if (!some.are_sides) return std::nullopt;
    std::array<int, 3> order{0, 1, 2};
    std::ranges::stable_sort(order, {}, [&](int a) { return lengths[a]; });
    return PlainPiece{lengths[order[1]], lengths[order[2]], axes.col(order[2])};
}

}  // namespace

std::optional<PlainPiece> as_plain_piece(const Surface& s, const std::vector<std::int32_t>& triangles, double thickness,
                                         double area) {
    if (const auto slab = as_slab(s, triangles, thickness, area)) return slab;
    if (const auto block = as_block(s, triangles, thickness)) return block;
    return as_bar(s, triangles, thickness, area);
}

}  // namespace partonomy
