// Denoising that keeps creases: guided normal filtering (Zhang, Deng, Zhang, Bouaziz and Liu 2015) and the vertex
// update of Sun, Rosin, Martin and Langbein (2007).
//
// calm() takes out noise by smoothing, and blurs creases over some triangles; the wall of a hole that is a few
// triangles wide is gone. Here normals are filtered first. Each triangle has a patch: the triangles around its corners.
// Of all patches that a triangle is in, the one whose normals agree best guides it, and that is one on its own side of
// a crease; neighbours count by their area, their nearness, and how like their guides are. After some rounds the
// vertices follow: each moves along the normals of its triangles until these are what they are now.
//
// Where we depart: how well a patch agrees is one minus the length of its mean normal, O(1) a triangle, instead of the
// largest difference of two normals in it. Cost: O(n) a round, about 13 neighbours a triangle.

#include "shape/sharpen.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <span>

#include "base/ranges.h"

namespace partonomy {
namespace {

constexpr int normal_rounds = 10, vertex_rounds = 10;
constexpr double alike = 0.35;           // distance of two guides that still counts for a good part
constexpr std::size_t most_around = 40;  // triangles in a patch; fans of more are cut off

/// Lists of numbers, one after the other.
struct Lists {
    std::vector<std::int32_t> begins, items;
    [[nodiscard]] std::span<const std::int32_t> of(std::size_t i) const {
        return std::span(items).subspan(static_cast<std::size_t>(begins[i]),
                                        static_cast<std::size_t>(begins[i + 1] - begins[i]));
    }
};

Lists triangles_at_vertices(const TriangleMesh& mesh) {
    Lists lists;
    lists.begins.assign(mesh.positions.size() + 1, 0);
    for (const auto& corners : mesh.triangles)
        for (const std::int32_t v : corners) ++lists.begins[static_cast<std::size_t>(v) + 1];
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) lists.begins[v + 1] += lists.begins[v];
    lists.items.resize(static_cast<std::size_t>(lists.begins.back()));
    std::vector<std::int32_t> fill(lists.begins.begin(), lists.begins.end() - 1);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        for (const std::int32_t v : mesh.triangles[t])
            lists.items[static_cast<std::size_t>(fill[static_cast<std::size_t>(v)]++)] = static_cast<std::int32_t>(t);
    return lists;
}

/// Of each triangle itself and those that share a vertex with it.
Lists patches_of_triangles(const TriangleMesh& mesh, const Lists& at_vertices) {
    Lists lists;
    lists.begins.push_back(0);
    std::vector<std::int32_t> around;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        around.assign(1, static_cast<std::int32_t>(t));
        for (const std::int32_t v : mesh.triangles[t])
            for (const std::int32_t other : at_vertices.of(static_cast<std::size_t>(v)))
                if (around.size() < most_around && std::ranges::find(around, other) == around.end())
                    around.push_back(other);
        lists.items.insert(lists.items.end(), around.begin(), around.end());
        lists.begins.push_back(static_cast<std::int32_t>(lists.items.size()));
    }
    return lists;
}

void filter_normals(const TriangleGeometry& geometry, const Lists& patches, std::vector<Vec3>& normals, int threads) {
    const std::size_t count = normals.size();
    double reach = 0, pairs = 0;
    for (std::size_t t = 0; t < count; ++t)
        for (const std::int32_t other : patches.of(t))
            if (static_cast<std::size_t>(other) > t) {
                reach += (geometry.barycentres[t] - geometry.barycentres[static_cast<std::size_t>(other)]).norm();
                pairs += 1;
            }
    if (!(reach > 0)) return;
    const double near = 0.5 * (pairs / reach) * (pairs / reach), like = 0.5 / (alike * alike);
    std::vector<Vec3> means(count), guides(count), next(count);
    std::vector<double> spreads(count);
    for (int round = 0; round < normal_rounds; ++round) {
        for_each_range(count, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t) {
                Vec3 sum = Vec3::Zero();
                double area = 0;
                for (const std::int32_t other : patches.of(t)) {
                    sum += geometry.areas[static_cast<std::size_t>(other)] * normals[static_cast<std::size_t>(other)];
                    area += geometry.areas[static_cast<std::size_t>(other)];
                }
                const double length = sum.norm();
                means[t] = length > 0 ? Vec3(sum / length) : normals[t];
                spreads[t] = area > 0 ? 1 - length / area : 1;
            }
        });
        for_each_range(count, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t) {
                std::size_t best = t;
                for (const std::int32_t other : patches.of(t))
                    if (spreads[static_cast<std::size_t>(other)] < spreads[best])
                        best = static_cast<std::size_t>(other);
                guides[t] = means[best];
            }
        });
        for_each_range(count, threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t) {
                Vec3 sum = Vec3::Zero();
                for (const std::int32_t other : patches.of(t)) {
                    const auto o = static_cast<std::size_t>(other);
                    const double far = (geometry.barycentres[t] - geometry.barycentres[o]).squaredNorm();
                    const double unlike = (guides[t] - guides[o]).squaredNorm();
                    sum += geometry.areas[o] * std::exp(-near * far - like * unlike) * normals[o];
                }
                const double length = sum.norm();
                next[t] = length > 0 ? Vec3(sum / length) : normals[t];
            }
        });
        normals.swap(next);
    }
}

void follow(TriangleMesh& mesh, const Lists& at_vertices, const std::vector<Vec3>& normals, int threads) {
    std::vector<Vec3> middles(mesh.triangles.size()), next(mesh.positions.size());
    for (int round = 0; round < vertex_rounds; ++round) {
        for_each_range(middles.size(), threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t t = begin; t < end; ++t) {
                middles[t] = Vec3::Zero();
                for (const std::int32_t v : mesh.triangles[t])
                    middles[t] += mesh.positions[static_cast<std::size_t>(v)] / 3;
            }
        });
        for_each_range(next.size(), threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                const std::span<const std::int32_t> around = at_vertices.of(v);
                Vec3 way = Vec3::Zero();
                for (const std::int32_t t : around) {
                    const Vec3& normal = normals[static_cast<std::size_t>(t)];
                    way += normal * normal.dot(middles[static_cast<std::size_t>(t)] - mesh.positions[v]);
                }
                next[v] = mesh.positions[v];
                if (!around.empty()) next[v] += way / static_cast<double>(around.size());
            }
        });
        mesh.positions.swap(next);
    }
}

}  // namespace

void sharpen(TriangleMesh& mesh, TriangleGeometry& geometry, int threads) {
    const Lists at_vertices = triangles_at_vertices(mesh);
    std::vector<Vec3> normals = geometry.normals;
    filter_normals(geometry, patches_of_triangles(mesh, at_vertices), normals, threads);
    follow(mesh, at_vertices, normals, threads);
    geometry = compute_geometry(mesh);
    geometry.normals = std::move(normals);
}

}  // namespace partonomy
