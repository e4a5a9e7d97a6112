#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <utility>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "shape/solids.h"

namespace partonomy::solids {

/// Where a function is zero, facing where it is positive: each cube of a lattice is cut into six tetrahedra, and these
/// by the surface. `inside` should tell about the distance, so that things melt into each other as organic models do.
inline TriangleMesh level_set(const std::function<double(const Vec3&)>& inside, const Vec3& low, const Vec3& high,
                              double step) {
    const Eigen::Vector3i count = ((high - low) / step).array().ceil().cast<int>();
    const auto number = [&](int x, int y, int z) { return (z * (count[1] + 1) + y) * (count[0] + 1) + x; };
    std::vector<double> values(static_cast<std::size_t>(number(count[0], count[1], count[2]) + 1));
    std::vector<Vec3> places(values.size());
    for (int z = 0; z <= count[2]; ++z)
        for (int y = 0; y <= count[1]; ++y)
            for (int x = 0; x <= count[0]; ++x) {
                const auto k = static_cast<std::size_t>(number(x, y, z));
                places[k] = low + step * Vec3(x, y, z);
                values[k] = inside(places[k]);
                if (std::abs(values[k]) < 0.05 * step) values[k] = 0.05 * step;  // no slivers around a corner
            }
    TriangleMesh mesh;
    std::map<std::pair<int, int>, std::int32_t> cuts;  // of edges of the lattice
    const auto cut = [&](int a, int b) {
        const auto [found, is_new] =
            cuts.try_emplace(std::minmax(a, b), static_cast<std::int32_t>(mesh.positions.size()));
        if (is_new) {
            const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
            mesh.positions.emplace_back(places[i] + values[i] / (values[i] - values[j]) * (places[j] - places[i]));
        }
        return found->second;
    };
    const auto add = [&](std::int32_t a, std::int32_t b, std::int32_t c, const Vec3& outward) {
        const Vec3 &p = mesh.positions[static_cast<std::size_t>(a)], &q = mesh.positions[static_cast<std::size_t>(b)],
                   &r = mesh.positions[static_cast<std::size_t>(c)];
        if ((q - p).cross(r - p).dot(outward) < 0) std::swap(b, c);
        mesh.triangles.push_back({a, b, c});
    };
    // Along the diagonal from corner 0 to corner 7, once around.
    constexpr std::array<std::array<int, 4>, 6> tetrahedra{
        {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}}};
    for (int z = 0; z < count[2]; ++z)
        for (int y = 0; y < count[1]; ++y)
            for (int x = 0; x < count[0]; ++x)
                for (const auto& corners : tetrahedra) {
                    std::vector<int> in, out;
                    for (const int c : corners) {
                        const int k = number(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2));
                        (values[static_cast<std::size_t>(k)] < 0 ? in : out).push_back(k);
                    }
                    if (in.empty() || out.empty()) continue;
                    Vec3 outward = Vec3::Zero();
                    for (const int k : out)
                        outward += places[static_cast<std::size_t>(k)] / static_cast<double>(out.size());
                    for (const int k : in)
                        outward -= places[static_cast<std::size_t>(k)] / static_cast<double>(in.size());
                    if (in.size() == 2) {
                        const std::int32_t a = cut(in[0], out[0]), b = cut(in[0], out[1]), c = cut(in[1], out[1]),
                                           d = cut(in[1], out[0]);
                        add(a, b, c, outward);
                        add(a, c, d, outward);
                    } else {
                        const int tip = in.size() == 1 ? in[0] : out[0];
                        const std::vector<int>& base = in.size() == 1 ? out : in;
                        add(cut(tip, base[0]), cut(tip, base[1]), cut(tip, base[2]), outward);
                    }
                }
    return finish(std::move(mesh));
}

/// How far a point is from a line between two others.
inline double from_line(const Vec3& p, const Vec3& a, const Vec3& b) {
    const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
    return (p - a - share * (b - a)).norm();
}

}  // namespace partonomy::solids
