#pragma once

#include <functional>
#include <string>
#include <vector>

#include "examples/paint.h"
#include "examples/solid.h"
#include "examples/transforms.h"

// Painted boards, and boards with an image.

namespace partonomy {

using Rgb = std::array<std::uint8_t, 3>;

/// A board whose upper and lower sides are n x n squares, painted by `paint_at(i, j)`; its rim has the first paint.
inline PaintedObject quilt(int n, const std::vector<Paint>& paints, const std::function<int(int, int)>& paint_at) {
    Solid solid;
    PaintedObject result;
    result.paints = paints;
    std::vector<int> parts;
    solid.begin_part("Quilt");
    const auto paint = [&](int p, std::vector<Solid::Vertex> corners) {
        solid.face(std::move(corners));
        parts.push_back(p);
    };
    const auto at = [&](int i, int j, double z) { return solid.at(double(i) / n, double(j) / n, z); };
    constexpr double high = 0.1;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            paint(paint_at(i, j), {at(i, j, high), at(i + 1, j, high), at(i + 1, j + 1, high), at(i, j + 1, high)});
            paint(paint_at(i, j), {at(i, j, 0), at(i, j + 1, 0), at(i + 1, j + 1, 0), at(i + 1, j, 0)});
        }
    for (int i = 0; i < n; ++i) {
        paint(0, {at(i, 0, 0), at(i + 1, 0, 0), at(i + 1, 0, high), at(i, 0, high)});
        paint(0, {at(i + 1, n, 0), at(i, n, 0), at(i, n, high), at(i + 1, n, high)});
        paint(0, {at(0, i + 1, 0), at(0, i, 0), at(0, i, high), at(0, i + 1, high)});
        paint(0, {at(n, i, 0), at(n, i + 1, 0), at(n, i + 1, high), at(n, i, high)});
    }
    result.object = std::move(solid).finish("quilt", "");
    for (const int part : parts) result.paint_of.insert(result.paint_of.end(), 2, part);  // a quad is two triangles
    return result;
}

inline Paint paint(const Rgb& rgb, double metallic = 0, double roughness = 0.9) {
    return {"p" + std::to_string(rgb[0]) + "-" + std::to_string(rgb[1]) + "-" + std::to_string(rgb[2]), rgb, metallic,
            roughness, std::nullopt};
}

/// A board with an image on its sides, one copy across.
inline PaintedObject pictured_board(int pixels, const std::function<Rgb(int, int)>& color, double degrees = 0) {
    PaintedObject board = quilt(1, {paint({250, 250, 250})}, [](int, int) { return 0; });
    board.paints[0].image = make_image(pixels, pixels, color);
    for (const auto& triangle : board.object.mesh.triangles) {
        auto& points = board.points.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& p = board.object.mesh.positions[static_cast<std::size_t>(triangle[i])];
            points[i] = {static_cast<float>(p.x()), static_cast<float>(p.y())};
        }
    }
    board.object = rotated_about_z(board.object, degrees);
    return board;
}

}  // namespace partonomy
