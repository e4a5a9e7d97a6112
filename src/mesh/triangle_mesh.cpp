#include "mesh/triangle_mesh.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/ranges.h"
#include "mesh/edges.h"
#include "mesh/parallel.h"

// Adjacency. An edge with two triangles links them. At an edge with more, the triangles are sorted by their angle
// around the edge. A triangle that runs down the edge (from the larger vertex index to the smaller) has its inside at
// growing angle, one that runs up has it at falling angle; so "down" opens a wedge of solid and the next "up" closes
// it, and the two are matched like brackets on a circle. Two boxes that touch along an edge thus stay two solids, also
// when they touch side to side: of walls at the same angle, those that close a wedge come first. Angles are the same up
// to what coordinates of single precision leave of them: short triangles far from the origin turn by 1e-4. What finds
// no partner, such as the third wall at a T-joint of sheets, is left open.

namespace partonomy {
namespace {

constexpr double same = 1e-6, most_blur = 0.01;  // radians
constexpr double rounding = 2.5e-7;              // of a coordinate: twice what single precision or seven digits keep

struct Spoke {
    double angle, blur;  ///< in radians; how far rounded coordinates may turn it
    std::int32_t half_edge;
    bool up;
};

void link(Adjacency& adjacency, std::int32_t a, std::int32_t b) {
    adjacency.neighbours[static_cast<std::size_t>(a / 3)][static_cast<std::size_t>(a % 3)] = b / 3;
    adjacency.neighbours[static_cast<std::size_t>(b / 3)][static_cast<std::size_t>(b % 3)] = a / 3;
}

std::vector<Spoke> spokes_around(const TriangleMesh& mesh, std::span<const std::int32_t> half_edges) {
    const auto point = [&](std::int32_t h, int corner) -> const Vec3& {
        const auto& triangle = mesh.triangles[static_cast<std::size_t>(h / 3)];
        return mesh.positions[static_cast<std::size_t>(triangle[static_cast<std::size_t>((h % 3 + corner) % 3)])];
    };
    const bool first_up = runs_up(mesh.triangles, half_edges.front());
    const Vec3& low = point(half_edges.front(), first_up ? 0 : 1);
    const Vec3 edge = point(half_edges.front(), first_up ? 1 : 0) - low, axis = edge.normalized();
    const Vec3 x = axis.unitOrthogonal(), y = axis.cross(x);
    std::vector<Spoke> spokes;
    for (const std::int32_t h : half_edges) {
        const Vec3 spoke = point(h, 2) - low;
        const double across = std::hypot(spoke.dot(x), spoke.dot(y));
        // The tip moves, and so do the ends of the edge, the more the farther the tip is from between them.
        const double lever = 1 + std::abs(spoke.dot(axis)) / edge.norm();
        const double blur = across > 0 ? rounding * low.cwiseAbs().maxCoeff() * lever / across : 0;
        spokes.push_back(
            {std::atan2(spoke.dot(y), spoke.dot(x)), std::min(same + blur, most_blur), h, runs_up(mesh.triangles, h)});
    }
    const auto by_angle = [](const Spoke& a, const Spoke& b) {
        return a.angle != b.angle ? a.angle < b.angle : a.half_edge < b.half_edge;
    };
    std::sort(spokes.begin(), spokes.end(), by_angle);
    // What lies side by side up to rounding gets one angle, and one solid ends before the next begins.
    constexpr double turn = 2 * std::numbers::pi;
    for (Spoke& spoke : spokes)
        if (spoke.angle > spokes.front().angle + turn - std::max(spoke.blur, spokes.front().blur)) spoke.angle -= turn;
    std::sort(spokes.begin(), spokes.end(), by_angle);
    for (std::size_t i = 1; i < spokes.size(); ++i)
        if (spokes[i].angle < spokes[i - 1].angle + std::max(spokes[i].blur, spokes[i - 1].blur))
            spokes[i].angle = spokes[i - 1].angle;
    std::stable_sort(spokes.begin(), spokes.end(), [](const Spoke& a, const Spoke& b) {
        return a.angle != b.angle ? a.angle < b.angle : a.up && !b.up;
    });
    return spokes;
}

void link_around(const TriangleMesh& mesh, std::span<const std::int32_t> half_edges, Adjacency& adjacency) {
    const std::vector<Spoke> spokes = spokes_around(mesh, half_edges);
    std::vector<std::int32_t> open;  // "down" spokes that wait for their "up"; two rounds close the circle
    std::vector<bool> done(spokes.size(), false);
    for (int round = 0; round < 2; ++round)
        for (std::size_t i = 0; i < spokes.size(); ++i) {
            if (done[i]) continue;
            if (!spokes[i].up) {
                if (round == 0) open.push_back(static_cast<std::int32_t>(i));
            } else if (!open.empty()) {
                const auto partner = static_cast<std::size_t>(open.back());
                open.pop_back();
                done[i] = done[partner] = true;
                link(adjacency, spokes[i].half_edge, spokes[partner].half_edge);
            }
        }
}

}  // namespace

Adjacency build_adjacency(const TriangleMesh& mesh) { return build_adjacency(mesh, 1); }

TriangleGeometry compute_geometry(const TriangleMesh& mesh) { return compute_geometry(mesh, 1); }

Adjacency build_adjacency(const TriangleMesh& mesh, int threads) {
    Adjacency adjacency;
    const auto half_edges = half_edges_of_vertices(mesh.triangles, mesh.positions.size(), threads);
    adjacency.neighbours.assign(mesh.triangles.size(), {-1, -1, -1});
    for_each_range(half_edges.size(), threads, [&](std::size_t begin, std::size_t end) {
        std::vector<std::int32_t> around;
        for (std::size_t v = begin; v < end; ++v)
            for_each_edge(half_edges[v], [&](std::span<const std::uint64_t> edge) {
                if (edge.size() == 2) link(adjacency, half_edge_of(edge[0]), half_edge_of(edge[1]));
                if (edge.size() <= 2) return;
                around.clear();
                for (const std::uint64_t key : edge) around.push_back(half_edge_of(key));
                link_around(mesh, around, adjacency);
            });
    });
    return adjacency;
}

TriangleGeometry compute_geometry(const TriangleMesh& mesh, int threads) {
    TriangleGeometry geometry;
    compute_geometry(mesh, threads, geometry);
    return geometry;
}

void compute_geometry(const TriangleMesh& mesh, int threads, TriangleGeometry& geometry) {
    geometry.areas.resize(mesh.triangles.size());
    geometry.normals.resize(mesh.triangles.size());
    geometry.barycentres.resize(mesh.triangles.size());
    for_each_range(mesh.triangles.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t t = begin; t < end; ++t) {
            const auto& [a, b, c] = mesh.triangles[t];
            const Vec3& p = mesh.positions[static_cast<std::size_t>(a)];
            const Vec3& q = mesh.positions[static_cast<std::size_t>(b)];
            const Vec3& r = mesh.positions[static_cast<std::size_t>(c)];
            const Vec3 cross = (q - p).cross(r - p);
            const double length = cross.norm();
            geometry.areas[t] = length / 2;
            geometry.normals[t] = length > 0 ? Vec3(cross / length) : Vec3(Vec3::Zero());
            geometry.barycentres[t] = (p + q + r) / 3;
        }
    });
}

namespace {

/// Bounds of what points_of(i, add) adds for each i in [0, count).
template <class PointsOf>
Bounds bounds_of(const Vec3& start, std::size_t count, int threads, const PointsOf& points_of) {
    const auto of_blocks = map_blocks(count, threads, [&](std::size_t begin, std::size_t end) {
        Bounds bounds{start, start};
        for (std::size_t i = begin; i < end; ++i)
            points_of(i, [&](const Vec3& point) {
                bounds.low = bounds.low.cwiseMin(point);
                bounds.high = bounds.high.cwiseMax(point);
            });
        return bounds;
    });
    Bounds all{start, start};
    for (const Bounds& some : of_blocks) {
        all.low = all.low.cwiseMin(some.low);
        all.high = all.high.cwiseMax(some.high);
    }
    return all;
}

}  // namespace

Bounds compute_bounds(const TriangleMesh& mesh) { return compute_bounds(mesh, 1); }

Bounds compute_used_bounds(const TriangleMesh& mesh) { return compute_used_bounds(mesh, 1); }

Bounds compute_bounds(const TriangleMesh& mesh, int threads) {
    return bounds_of(mesh.positions.front(), mesh.positions.size(), threads,
                     [&](std::size_t v, const auto& add) { add(mesh.positions[v]); });
}

Bounds compute_used_bounds(const TriangleMesh& mesh, int threads) {
    const Vec3& start = mesh.positions[static_cast<std::size_t>(mesh.triangles.front()[0])];
    return bounds_of(start, mesh.triangles.size(), threads, [&](std::size_t t, const auto& add) {
        for (const std::int32_t corner : mesh.triangles[t]) add(mesh.positions[static_cast<std::size_t>(corner)]);
    });
}

std::string validate(const TriangleMesh& mesh) {
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (!mesh.positions[v].allFinite()) return fmt::format("position {} is not finite", v);
    if (mesh.input_faces.size() != mesh.triangles.size())
        return fmt::format("{} triangles have {} input faces", mesh.triangles.size(), mesh.input_faces.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& [a, b, c] = mesh.triangles[t];
        for (const std::int32_t v : mesh.triangles[t])
            if (v < 0 || static_cast<std::size_t>(v) >= mesh.positions.size())
                return fmt::format("triangle {} refers to position {} of {}", t, v, mesh.positions.size());
        if (a == b || b == c || c == a) return fmt::format("triangle {} has the same corner twice", t);
        if (mesh.input_faces[t] < 0 || mesh.input_faces[t] >= mesh.input_face_count)
            return fmt::format("triangle {} has input face {} of {}", t, mesh.input_faces[t], mesh.input_face_count);
    }
    return {};
}

Topology compute_topology(const TriangleMesh& mesh) {
    Topology topology;
    const EdgeTable edges = build_edges(mesh.triangles, mesh.positions.size());
    topology.edges = static_cast<std::int64_t>(edges.size());
    std::vector<std::size_t> parent(mesh.triangles.size());
    for (std::size_t t = 0; t < parent.size(); ++t) parent[t] = t;
    const auto root = [&](std::size_t t) {
        while (parent[t] != t) t = parent[t] = parent[parent[t]];
        return t;
    };
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto around = edges[e];
        if (around.size() == 1) ++topology.boundary_edges;
        if (around.size() > 2) ++topology.non_manifold_edges;
        if (around.size() == 2 && runs_up(mesh.triangles, around[0]) == runs_up(mesh.triangles, around[1]))
            ++topology.disagreeing_edges;
        for (const std::int32_t h : around)
            parent[root(static_cast<std::size_t>(h / 3))] = root(static_cast<std::size_t>(around.front() / 3));
    }
    for (std::size_t t = 0; t < parent.size(); ++t) topology.shells += parent[t] == t;

    std::vector<bool> used(mesh.positions.size(), false);
    for (const auto& triangle : mesh.triangles)
        for (const std::int32_t v : triangle) used[static_cast<std::size_t>(v)] = true;
    topology.euler =
        std::count(used.begin(), used.end(), true) - topology.edges + static_cast<std::int64_t>(mesh.triangles.size());
    if (mesh.positions.empty()) return topology;
    const Bounds bounds = compute_bounds(mesh);
    const Vec3 origin = (bounds.low + bounds.high) / 2;
    for (const auto& [a, b, c] : mesh.triangles)
        topology.volume += (mesh.positions[static_cast<std::size_t>(a)] - origin)
                               .dot((mesh.positions[static_cast<std::size_t>(b)] - origin)
                                        .cross(mesh.positions[static_cast<std::size_t>(c)] - origin)) /
                           6;
    return topology;
}

}  // namespace partonomy
