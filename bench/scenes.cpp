// The surface is made square by square: the boxes cut space into a few large cells, and each wall between a full cell
// and an empty one is cut into small squares at the grid planes of the whole, so that neighbours meet corner to corner.

#include "bench/scenes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

namespace partonomy::bench {

namespace {

struct Box {
    Vec3 low, high;
};

const std::array<Box, 4> boxes{{{{0, 0, 0}, {1, 1, 1}},
                                {{0.1, 0.7, 1}, {0.9, 0.9, 1.7}},
                                {{1, 0.1, 0.5}, {1.5, 0.9, 0.64}},
                                {{0.1, 0.1, -0.8}, {0.4, 0.4, 0}}}};
constexpr double total_area = 9.15;

/// One axis: where the boxes begin and end, and how the stretches between are cut.
struct Axis {
    std::vector<double> marks, planes;
    std::vector<std::uint32_t> first;  ///< plane of each mark

    Axis(int axis, double step) {
        for (const Box& box : boxes) {
            marks.push_back(box.low[axis]);
            marks.push_back(box.high[axis]);
        }
        std::sort(marks.begin(), marks.end());
        marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
        for (std::size_t m = 0; m < marks.size(); ++m) {
            first.push_back(static_cast<std::uint32_t>(planes.size()));
            if (m + 1 == marks.size()) break;
            const double length = marks[m + 1] - marks[m];
            const auto pieces = std::max(1L, std::lround(length / step));
            for (long k = 0; k < pieces; ++k)
                planes.push_back(marks[m] + length * static_cast<double>(k) / static_cast<double>(pieces));
        }
        planes.push_back(marks.back());
    }
};

}  // namespace

Scene figure_16(std::size_t triangles) {
    const double step = std::sqrt(2 * total_area / static_cast<double>(triangles));
    const std::array<Axis, 3> axes{Axis(0, step), Axis(1, step), Axis(2, step)};
    const auto part_at = [&](const std::array<int, 3>& cell) {
        Vec3 middle;
        for (int a = 0; a < 3; ++a) {
            const auto& marks = axes[static_cast<std::size_t>(a)].marks;
            const int c = cell[static_cast<std::size_t>(a)];
            if (c < 0 || c + 1 >= static_cast<int>(marks.size())) return -1;
            middle[a] = (marks[static_cast<std::size_t>(c)] + marks[static_cast<std::size_t>(c) + 1]) / 2;
        }
        const auto box = std::find_if(boxes.begin(), boxes.end(), [&](const Box& x) {
            return (middle.array() > x.low.array()).all() && (middle.array() < x.high.array()).all();
        });
        return box == boxes.end() ? -1 : static_cast<int>(box - boxes.begin());
    };
    using Corner = std::array<std::uint32_t, 3>;
    std::vector<std::array<Corner, 4>> squares;
    Scene scene;
    const auto add_wall = [&](const std::array<int, 3>& cell, std::size_t a, bool ahead) {
        const std::size_t b = (a + 1) % 3, c = (a + 2) % 3;
        const auto at = [&](std::size_t axis, int offset) {
            return axes[axis].first[static_cast<std::size_t>(cell[axis] + offset)];
        };
        for (std::uint32_t i = at(b, 0); i < at(b, 1); ++i)
            for (std::uint32_t j = at(c, 0); j < at(c, 1); ++j) {
                const auto corner = [&](std::uint32_t di, std::uint32_t dj) {
                    Corner p{};
                    p[a] = at(a, ahead ? 1 : 0), p[b] = i + di, p[c] = j + dj;
                    return p;
                };
                squares.push_back({corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)});
                if (!ahead) std::swap(squares.back()[1], squares.back()[3]);
            }
    };
    std::array<int, 3> cell{};
    const auto cells = [&](std::size_t a) { return static_cast<int>(axes[a].marks.size()) - 1; };
    for (cell[0] = 0; cell[0] < cells(0); ++cell[0])
        for (cell[1] = 0; cell[1] < cells(1); ++cell[1])
            for (cell[2] = 0; cell[2] < cells(2); ++cell[2])
                for (std::size_t a = 0; a < 3 && part_at(cell) >= 0; ++a)
                    for (const bool ahead : {false, true}) {
                        std::array<int, 3> next = cell;
                        next[a] += ahead ? 1 : -1;
                        if (part_at(next) >= 0) continue;
                        add_wall(cell, a, ahead);
                        scene.parts.resize(2 * squares.size(), part_at(cell));
                    }
    std::vector<Corner> corners;
    for (const auto& square : squares) corners.insert(corners.end(), square.begin(), square.end());
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    TriangleMesh& mesh = scene.mesh;
    for (const Corner& p : corners)
        mesh.positions.emplace_back(axes[0].planes[p[0]], axes[1].planes[p[1]], axes[2].planes[p[2]]);
    for (const auto& square : squares) {
        std::array<std::int32_t, 4> v{};
        for (std::size_t k = 0; k < 4; ++k)
            v[k] = static_cast<std::int32_t>(std::lower_bound(corners.begin(), corners.end(), square[k]) -
                                             corners.begin());
        mesh.triangles.push_back({v[0], v[1], v[2]});
        mesh.triangles.push_back({v[0], v[2], v[3]});
    }
    mesh.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    for (std::int32_t t = 0; t < mesh.input_face_count; ++t) mesh.input_faces.push_back(t);
    return scene;
}

void add_noise(TriangleMesh& mesh, double level, std::uint32_t seed) {
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> phase(0, 2 * std::numbers::pi);
    const double size = compute_bounds(mesh).diagonal();
    const double edge = std::sqrt(total_area / static_cast<double>(mesh.triangles.size()));
    std::vector<double> height(mesh.positions.size(), 0.0);
    for (double length = size / 2; length > 4 * edge; length /= 2)
        for (int k = 0; k < 8; ++k) {
            Vec3 wave(normal(random), normal(random), normal(random));
            wave *= 2 * std::numbers::pi / (length * wave.norm());
            const double start = phase(random);
            for (std::size_t v = 0; v < height.size(); ++v)
                height[v] += length * std::sin(mesh.positions[v].dot(wave) + start);
        }
    double sum = 0;
    for (const double h : height) sum += h * h;
    const double scale = level * size / std::sqrt(sum / static_cast<double>(height.size()));
    std::vector<Vec3> normals(mesh.positions.size(), Vec3::Zero());
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 n =
            (mesh.positions[static_cast<std::size_t>(b)] - mesh.positions[static_cast<std::size_t>(a)])
                .cross(mesh.positions[static_cast<std::size_t>(c)] - mesh.positions[static_cast<std::size_t>(a)]);
        for (const std::int32_t v : {a, b, c}) normals[static_cast<std::size_t>(v)] += n;
    }
    for (std::size_t v = 0; v < height.size(); ++v) mesh.positions[v] += scale * height[v] * normals[v].normalized();
}

}  // namespace partonomy::bench
