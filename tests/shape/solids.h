#pragma once

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include "mesh/triangle_mesh.h"

// Closed shapes with a known form, made by code, in small triangles of about equal size.

namespace partonomy::solids {

using Outline = std::vector<Eigen::Vector2d>;

inline TriangleMesh finish(TriangleMesh mesh) {
    mesh.input_faces.clear();
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) mesh.input_faces.push_back(static_cast<std::int32_t>(t));
    mesh.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    return mesh;
}

/// Points at equal steps along a polygon, its corners among them.
inline Outline polygon(const Outline& corners, double step) {
    Outline points;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Eigen::Vector2d &a = corners[i], &b = corners[(i + 1) % corners.size()];
        const int pieces = std::max(1, static_cast<int>(std::lround((b - a).norm() / step)));
        for (int k = 0; k < pieces; ++k) points.push_back(a + (b - a) * k / pieces);
    }
    return points;
}

/// What revolve() turns into a closed solid: points at equal steps along corners of which the first and the last lie on
/// the axis, and nothing on the axis between the two.
inline Outline profile(const Outline& corners, double step) {
    Outline points = polygon(corners, step);
    while (points.back().x() == 0 && points.back().y() < corners.back().y()) points.pop_back();
    return points;
}

inline Outline ellipse(double a, double b, double step) {
    const int count = std::max(16, static_cast<int>(std::lround(std::numbers::pi * (a + b) / step)));
    Outline points;
    for (int i = 0; i < count; ++i) {
        const double turn = 2 * std::numbers::pi * i / count;
        points.emplace_back(a * std::cos(turn), b * std::sin(turn));
    }
    return points;
}

inline Outline rectangle(double width, double height, double step) {
    const double x = width / 2, y = height / 2;
    return polygon({{-x, -y}, {x, -y}, {x, y}, {-x, y}}, step);
}

inline Outline regular(int corners, double radius, double step) {
    Outline points;
    for (int i = 0; i < corners; ++i) {
        const double turn = 2 * std::numbers::pi * i / corners;
        points.emplace_back(radius * std::cos(turn), radius * std::sin(turn));
    }
    return polygon(points, step);
}

/// An outline swept through z = 0 … length, counter-clockwise from above. `place` moves the point (x, y) of the outline
/// at share t of the way; without it the sweep is straight up.
inline TriangleMesh sweep(const Outline& outline, double length, double step,
                          const std::function<Vec3(double, const Eigen::Vector2d&)>& place = {}) {
    TriangleMesh mesh;
    const int around = static_cast<int>(outline.size());
    const int along = std::max(1, static_cast<int>(std::lround(length / step)));
    double radius = 0;
    for (const Eigen::Vector2d& p : outline) radius = std::max(radius, p.norm());
    const int rings = std::max(1, static_cast<int>(std::lround(radius / step)));
    const auto at = [&](double t, const Eigen::Vector2d& p) -> Vec3 {
        return place ? place(t, p) : Vec3(p.x(), p.y(), t * length);
    };
    std::vector<std::vector<std::int32_t>> levels;  // closed rings, from the middle of the foot to that of the top
    const auto ring = [&](double t, double share) {
        std::vector<std::int32_t> level;
        for (const Eigen::Vector2d& p : outline) {
            level.push_back(static_cast<std::int32_t>(mesh.positions.size()));
            mesh.positions.push_back(at(t, share * p));
        }
        levels.push_back(level);
    };
    for (int k = 1; k < rings; ++k) ring(0, static_cast<double>(k) / rings);
    for (int j = 0; j <= along; ++j) ring(static_cast<double>(j) / along, 1);
    for (int k = rings - 1; k >= 1; --k) ring(1, static_cast<double>(k) / rings);
    const auto foot = static_cast<std::int32_t>(mesh.positions.size()), top = foot + 1;
    mesh.positions.push_back(at(0, Eigen::Vector2d::Zero()));
    mesh.positions.push_back(at(1, Eigen::Vector2d::Zero()));
    for (int i = 0; i < around; ++i) {
        const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>((i + 1) % around);
        mesh.triangles.push_back({foot, levels.front()[b], levels.front()[a]});
        mesh.triangles.push_back({top, levels.back()[a], levels.back()[b]});
        for (std::size_t l = 0; l + 1 < levels.size(); ++l) {
            mesh.triangles.push_back({levels[l][a], levels[l][b], levels[l + 1][b]});
            mesh.triangles.push_back({levels[l][a], levels[l + 1][b], levels[l + 1][a]});
        }
    }
    return finish(std::move(mesh));
}

/// A closed outline (x >= 0 is the distance from the z axis, y is z; counter-clockwise) turned about the z axis. Where
/// the outline meets the axis, it stops there: give it from its lower to its upper end with `is_open`.
inline TriangleMesh revolve(const Outline& profile, int around, bool is_open) {
    TriangleMesh mesh;
    const std::size_t count = profile.size();
    std::vector<std::vector<std::int32_t>> rings;
    for (const Eigen::Vector2d& p : profile) {
        std::vector<std::int32_t> ring;
        for (int i = 0; i < around; ++i) {
            if (p.x() > 0 || i == 0) {
                const double turn = 2 * std::numbers::pi * i / around;
                ring.push_back(static_cast<std::int32_t>(mesh.positions.size()));
                mesh.positions.emplace_back(p.x() * std::cos(turn), p.x() * std::sin(turn), p.y());
            } else {
                ring.push_back(ring.front());
            }
        }
        rings.push_back(ring);
    }
    for (std::size_t j = 0; j + (is_open ? 1 : 0) < count; ++j)
        for (int i = 0; i < around; ++i) {
            const auto a = static_cast<std::size_t>(i), b = static_cast<std::size_t>((i + 1) % around);
            const auto &low = rings[j], &high = rings[(j + 1) % count];
            if (low[a] != low[b]) mesh.triangles.push_back({low[a], low[b], high[b]});
            if (high[a] != high[b]) mesh.triangles.push_back({low[a], high[b], high[a]});
        }
    return finish(std::move(mesh));
}

inline TriangleMesh ball(double radius, double step) {
    const int along = static_cast<int>(std::lround(std::numbers::pi * radius / step));
    Outline profile;
    for (int j = 0; j <= along; ++j) {
        const double turn = std::numbers::pi * (static_cast<double>(j) / along - 0.5);
        profile.emplace_back(j == 0 || j == along ? 0 : radius * std::cos(turn), radius * std::sin(turn));
    }
    return revolve(profile, 2 * along, true);
}

inline TriangleMesh torus(double radius, double tube, double step) {
    const int around = static_cast<int>(std::lround(2 * std::numbers::pi * radius / step));
    Outline profile = ellipse(tube, tube, step);
    for (Eigen::Vector2d& p : profile) p.x() += radius;
    return revolve(profile, around, false);
}

inline TriangleMesh moved(TriangleMesh mesh, const std::function<Vec3(const Vec3&)>& move) {
    for (Vec3& p : mesh.positions) p = move(p);
    return mesh;
}

/// Tilted from upright, by turning about the y axis.
inline TriangleMesh tilted(TriangleMesh mesh, double degrees) {
    const Eigen::AngleAxisd turn(degrees * std::numbers::pi / 180, Vec3::UnitY());
    return moved(std::move(mesh), [&](const Vec3& p) -> Vec3 { return turn * p; });
}

/// Turned about up, scaled, and with noise of `noise` of the diagonal (root mean square) at each vertex.
inline TriangleMesh disturbed(TriangleMesh mesh, double noise, std::mt19937& random, double* scale = nullptr) {
    const double size = compute_bounds(mesh).diagonal();
    std::normal_distribution<double> normal(0, noise * size / std::sqrt(3.0));
    if (noise > 0)
        for (Vec3& p : mesh.positions) p += Vec3(normal(random), normal(random), normal(random));
    std::uniform_real_distribution<double> share(0, 1);
    const double factor = scale ? *scale : std::pow(10, 2 * share(random) - 1);
    const Eigen::AngleAxisd turn(2 * std::numbers::pi * share(random), Vec3::UnitZ());
    const Vec3 shift(share(random), share(random), share(random));
    for (Vec3& p : mesh.positions) p = factor * (turn * p + shift);
    return mesh;
}

}  // namespace partonomy::solids
