#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <random>
#include <vector>

#include "mesh/triangle_mesh.h"

// Shapes with known parts, made by code.

namespace partonomy::shapes {

/// A mesh and the part that each triangle belongs to.
struct Labelled {
    TriangleMesh mesh;
    std::vector<int> parts;
};

/// The closed surface of a set of unit-grid blocks: cell (i, j, k) holds the number of its part, or -1 for air. Grid
/// planes are at the given coordinates. A surface square belongs to the part behind it and is cut into two triangles.
inline Labelled blocks(const std::array<std::vector<double>, 3>& planes,
                       const std::function<int(int, int, int)>& part) {
    Labelled out;
    std::map<std::array<int, 3>, std::int32_t> vertices;
    const auto at = [&](std::array<int, 3> g) {
        const auto [it, is_new] = vertices.try_emplace(g, static_cast<std::int32_t>(out.mesh.positions.size()));
        if (is_new)
            out.mesh.positions.emplace_back(planes[0][static_cast<std::size_t>(g[0])],
                                            planes[1][static_cast<std::size_t>(g[1])],
                                            planes[2][static_cast<std::size_t>(g[2])]);
        return it->second;
    };
    const auto cell = [&](const std::array<int, 3>& g) {
        for (std::size_t a = 0; a < 3; ++a)
            if (g[a] < 0 || g[a] + 1 >= static_cast<int>(planes[a].size())) return -1;
        return part(g[0], g[1], g[2]);
    };
    const auto size = [&](std::size_t a) { return static_cast<int>(planes[a].size()) - 1; };
    for (int i = 0; i < size(0); ++i)
        for (int j = 0; j < size(1); ++j)
            for (int k = 0; k < size(2); ++k) {
                const std::array<int, 3> g{i, j, k};
                const int own = cell(g);
                if (own < 0) continue;
                for (std::size_t a = 0; a < 3; ++a)
                    for (const int side : {-1, 1}) {
                        std::array<int, 3> next = g;
                        next[a] += side;
                        if (cell(next) >= 0) continue;
                        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
                        std::array<int, 3> p = g;
                        if (side > 0) ++p[a];
                        std::array<int, 3> q = p, r = p, t = p;
                        ++q[b];
                        ++r[b], ++r[c];
                        ++t[c];
                        std::array<std::int32_t, 4> v{at(p), at(q), at(r), at(t)};
                        if (side < 0) std::swap(v[1], v[3]);
                        for (const auto& triangle : {std::array{v[0], v[1], v[2]}, std::array{v[0], v[2], v[3]}}) {
                            out.mesh.triangles.push_back(triangle);
                            out.parts.push_back(own);
                        }
                    }
            }
    for (std::size_t t = 0; t < out.mesh.triangles.size(); ++t)
        out.mesh.input_faces.push_back(static_cast<std::int32_t>(t));
    out.mesh.input_face_count = static_cast<std::int32_t>(out.mesh.triangles.size());
    return out;
}

/// Grid planes: each stretch between two marks cut into steps of about `step`.
inline std::vector<double> grid(const std::vector<double>& marks, double step) {
    std::vector<double> planes{marks.front()};
    for (std::size_t m = 1; m < marks.size(); ++m) {
        const double length = marks[m] - marks[m - 1];
        const int pieces = std::max(1, static_cast<int>(std::lround(length / step)));
        for (int k = 1; k <= pieces; ++k) planes.push_back(marks[m - 1] + length * k / pieces);
    }
    return planes;
}

/// An axis-parallel box from `low` to `high` that holds part `number`.
struct Block {
    Vec3 low, high;
    int number;
};

/// The union of boxes that touch, as one closed surface; where boxes overlap the later one counts.
inline Labelled join(const std::vector<Block>& parts, double step) {
    std::array<std::vector<double>, 3> planes;
    for (int a = 0; a < 3; ++a) {
        std::vector<double> marks;
        for (const Block& block : parts) {
            marks.push_back(block.low[a]);
            marks.push_back(block.high[a]);
        }
        std::sort(marks.begin(), marks.end());
        marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
        planes[static_cast<std::size_t>(a)] = grid(marks, step);
    }
    return blocks(planes, [&](int i, int j, int k) {
        const auto middle = [](const std::vector<double>& p, int at) {
            return (p[static_cast<std::size_t>(at)] + p[static_cast<std::size_t>(at) + 1]) / 2;
        };
        const Vec3 centre(middle(planes[0], i), middle(planes[1], j), middle(planes[2], k));
        int part = -1;
        for (const Block& block : parts)
            if ((centre.array() > block.low.array()).all() && (centre.array() < block.high.array()).all())
                part = block.number;
        return part;
    });
}

/// A closed round stick along z from 0 to `length`.
inline TriangleMesh cylinder(double radius, double length, int around, int along) {
    TriangleMesh mesh;
    for (int j = 0; j <= along; ++j)
        for (int i = 0; i < around; ++i) {
            const double angle = 2 * std::numbers::pi * i / around;
            mesh.positions.emplace_back(radius * std::cos(angle), radius * std::sin(angle), length * j / along);
        }
    const auto bottom = static_cast<std::int32_t>(mesh.positions.size()), top = bottom + 1;
    mesh.positions.emplace_back(0, 0, 0);
    mesh.positions.emplace_back(0, 0, length);
    for (int i = 0; i < around; ++i) {
        const int next = (i + 1) % around;
        for (int j = 0; j < along; ++j) {
            const std::int32_t a = j * around + i, b = j * around + next, c = b + around, d = a + around;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
        }
        mesh.triangles.push_back({bottom, next, i});
        mesh.triangles.push_back({top, along * around + i, along * around + next});
    }
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.input_faces.push_back(static_cast<std::int32_t>(t));
    mesh.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    return mesh;
}

inline void turn(TriangleMesh& mesh, const Eigen::Quaterniond& by) {
    for (Vec3& point : mesh.positions) point = by * point;
}

inline Eigen::Quaterniond random_turn(std::mt19937& random) {
    std::normal_distribution<double> normal;
    return Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
}

}  // namespace partonomy::shapes
