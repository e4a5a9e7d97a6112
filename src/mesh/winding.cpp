#include "mesh/winding.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

// A patch is a set of triangles connected over edges with exactly two triangles. Breadth-first search over a patch
// turns each triangle to agree with the one it was reached from; when that turned the majority, the whole patch is
// turned back, so the file's own opinion wins. Then the outside is found:
//   closed patch      its signed volume must be positive. Exception: inside another closed patch, wound opposite to it
//                     in the file, and consistently: the wall of a cavity, which rightly faces inward. Patches are
//                     asked from the largest to the smallest, and the smallest one around a patch is its container.
//   nearly closed     the vector areas of a closed surface sum to zero; below a quarter of the total area the volume
//                     about the barycentre still tells the outside (a box without its bottom).
//   sheet             nobody knows; as the file has it.
// Containment is one ray from one vertex against the triangles of each patch whose box contains the box of the asking
// one. Only asked when closed patches disagree. Cost: O(#T), plus #patches^2 box tests and #T of the boxes that pass;
// files of more than 4096 closed patches (leaves, nuts and bolts) are not searched for cavities.

namespace partonomy {
namespace {

constexpr std::size_t most_patches_with_cavities = 4096;

struct Patch {
    std::size_t first = 0, last = 0;  ///< in Patches::order
    bool closed = true;               ///< every edge has two triangles, and they agree
    bool as_in_file = true;           ///< nothing was turned so far
    bool inverted = false;            ///< still to be turned as a whole
    double file_volume = 0;           ///< signed, after the neighbours agree
    double vector_area_ratio = 0;
    Bounds bounds{Vec3::Zero(), Vec3::Zero()};
};

struct Patches {
    std::vector<std::int32_t> order;  ///< triangles, patch after patch
    std::vector<char> turned;         ///< per triangle
    std::vector<Patch> patches;
    std::int64_t one_sided = 0;
};

/// Per half-edge: the half-edge across an edge of two triangles, -1 elsewhere.
std::vector<std::int32_t> opposite_half_edges(std::size_t triangle_count, const EdgeTable& edges) {
    std::vector<std::int32_t> opposite(3 * triangle_count, -1);
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto around = edges[e];
        if (around.size() != 2) continue;
        opposite[static_cast<std::size_t>(around[0])] = around[1];
        opposite[static_cast<std::size_t>(around[1])] = around[0];
    }
    return opposite;
}

Patches collect_patches(const TriangleMesh& mesh, const EdgeTable& edges) {
    const std::vector<std::int32_t> opposite = opposite_half_edges(mesh.triangles.size(), edges);
    Patches all;
    all.order.reserve(mesh.triangles.size());
    all.turned.assign(mesh.triangles.size(), 2);  // 2: not reached yet
    for (std::size_t seed = 0; seed < mesh.triangles.size(); ++seed) {
        if (all.turned[seed] != 2) continue;
        Patch patch;
        patch.first = all.order.size();
        std::size_t turned_count = 0;
        bool one_sided = false;
        all.order.push_back(static_cast<std::int32_t>(seed));
        all.turned[seed] = 0;
        for (std::size_t i = patch.first; i < all.order.size(); ++i) {
            const std::int32_t t = all.order[i];
            for (std::int32_t h = 3 * t; h < 3 * t + 3; ++h) {
                const std::int32_t other = opposite[static_cast<std::size_t>(h)];
                if (other < 0) {
                    patch.closed = false;
                    continue;
                }
                const bool disagree = runs_up(mesh.triangles, h) == runs_up(mesh.triangles, other);
                const char wanted = static_cast<char>(all.turned[static_cast<std::size_t>(t)] ^ (disagree ? 1 : 0));
                char& turned = all.turned[static_cast<std::size_t>(other / 3)];
                if (turned == 2) {
                    turned = wanted;
                    turned_count += static_cast<std::size_t>(wanted);
                    all.order.push_back(other / 3);
                } else if (turned != wanted) {
                    one_sided = true;
                }
            }
        }
        patch.last = all.order.size();
        if (one_sided) {
            patch.closed = false;
            ++all.one_sided;
        }
        patch.as_in_file = turned_count == 0;
        patch.inverted = 2 * turned_count > patch.last - patch.first;
        all.patches.push_back(patch);
    }
    return all;
}

/// Volume, vector area and bounds, with `inverted` taken into account.
void measure(const TriangleMesh& mesh, const Patches& all, Patch& patch) {
    const auto corner = [&](std::int32_t t, std::size_t i) -> const Vec3& {
        return mesh.positions[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(t)][i])];
    };
    Vec3 centre = Vec3::Zero(), vector_area = Vec3::Zero();
    double area = 0;
    patch.bounds = {corner(all.order[patch.first], 0), corner(all.order[patch.first], 0)};
    for (std::size_t i = patch.first; i < patch.last; ++i) {
        const std::int32_t t = all.order[i];
        const Vec3 &p = corner(t, 0), &q = corner(t, 1), &r = corner(t, 2);
        const Vec3 cross = (q - p).cross(r - p);
        const double length = cross.norm();
        centre += length * (p + q + r) / 3;
        area += length;
        vector_area += all.turned[static_cast<std::size_t>(t)] ? Vec3(-cross) : cross;
        patch.bounds.low = patch.bounds.low.cwiseMin(p.cwiseMin(q).cwiseMin(r));
        patch.bounds.high = patch.bounds.high.cwiseMax(p.cwiseMax(q).cwiseMax(r));
    }
    centre /= area;
    patch.vector_area_ratio = vector_area.norm() / area;
    double volume = 0;
    for (std::size_t i = patch.first; i < patch.last; ++i) {
        const std::int32_t t = all.order[i];
        const double six = (corner(t, 0) - centre).dot((corner(t, 1) - centre).cross(corner(t, 2) - centre));
        volume += all.turned[static_cast<std::size_t>(t)] ? -six / 6 : six / 6;
    }
    patch.file_volume = patch.inverted ? -volume : volume;
}

/// Whether `point` is inside a closed patch: the parity of hits of a ray upward.
bool contains(const TriangleMesh& mesh, const Patches& all, const Patch& patch, const Vec3& point) {
    if ((point.array() < patch.bounds.low.array()).any() || (point.array() > patch.bounds.high.array()).any())
        return false;
    const auto side = [&](const Vec3& a, const Vec3& b) {  // of the ray's shadow; half-open by the order of the ends
        return (b.x() - a.x()) * (point.y() - a.y()) - (b.y() - a.y()) * (point.x() - a.x());
    };
    bool inside = false;
    for (std::size_t i = patch.first; i < patch.last; ++i) {
        const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(all.order[i])];
        const Vec3& p = mesh.positions[static_cast<std::size_t>(a)];
        const Vec3& q = mesh.positions[static_cast<std::size_t>(b)];
        const Vec3& r = mesh.positions[static_cast<std::size_t>(c)];
        if (point.x() < std::min({p.x(), q.x(), r.x()}) || point.x() > std::max({p.x(), q.x(), r.x()})) continue;
        const double u = side(q, r), v = side(r, p), w = side(p, q);
        const bool hit = (u > 0 && v > 0 && w > 0) || (u < 0 && v < 0 && w < 0);
        if (!hit) continue;
        const double z = (u * p.z() + v * q.z() + w * r.z()) / (u + v + w);
        if (z > point.z()) inside = !inside;
    }
    return inside;
}

/// A point of a patch that is in no special position: inside its first triangle, off its centre and its axes.
Vec3 probe(const TriangleMesh& mesh, const Patches& all, const Patch& patch) {
    const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(all.order[patch.first])];
    return 0.4637 * mesh.positions[static_cast<std::size_t>(a)] + 0.3128 * mesh.positions[static_cast<std::size_t>(b)] +
           0.2235 * mesh.positions[static_cast<std::size_t>(c)];
}

/// Closed patches: outward, but for the walls of cavities. `final_sign` is +1 for outward.
std::int64_t turn_closed(const TriangleMesh& mesh, Patches& all) {
    std::vector<std::size_t> closed;
    for (std::size_t i = 0; i < all.patches.size(); ++i)
        if (all.patches[i].closed) closed.push_back(i);
    std::stable_sort(closed.begin(), closed.end(), [&](std::size_t a, std::size_t b) {
        return std::abs(all.patches[a].file_volume) > std::abs(all.patches[b].file_volume);
    });
    bool search = false;
    for (const std::size_t i : closed)
        search |= (all.patches[i].file_volume < 0) != (all.patches[closed.front()].file_volume < 0);
    search &= closed.size() <= most_patches_with_cavities;
    std::int64_t cavities = 0;
    std::vector<int> final_sign(all.patches.size(), 1);
    for (std::size_t k = 0; k < closed.size(); ++k) {
        Patch& patch = all.patches[closed[k]];
        const bool negative = patch.file_volume < 0;
        if (search && patch.as_in_file) {
            const Vec3 point = probe(mesh, all, patch);
            for (std::size_t j = k; j-- > 0;) {
                const Patch& around = all.patches[closed[j]];
                if ((around.bounds.low.array() > patch.bounds.low.array()).any() ||
                    (around.bounds.high.array() < patch.bounds.high.array()).any() ||
                    !contains(mesh, all, around, point))
                    continue;
                if (around.as_in_file && (around.file_volume < 0) != negative)
                    final_sign[closed[k]] = -final_sign[closed[j]];
                break;
            }
        }
        if (final_sign[closed[k]] < 0) ++cavities;
        if (negative != (final_sign[closed[k]] < 0)) patch.inverted = !patch.inverted;
    }
    return cavities;
}

/// Patches that meet at an edge of more than two triangles belong to one shell.
std::int64_t count_shells(const Patches& all, const EdgeTable& edges) {
    std::vector<std::size_t> patch_of(all.order.size()), parent(all.patches.size());
    for (std::size_t p = 0; p < parent.size(); ++p) {
        parent[p] = p;
        for (std::size_t i = all.patches[p].first; i < all.patches[p].last; ++i)
            patch_of[static_cast<std::size_t>(all.order[i])] = p;
    }
    const auto root = [&](std::int32_t half_edge) {
        std::size_t p = patch_of[static_cast<std::size_t>(half_edge / 3)];
        while (parent[p] != p) p = parent[p] = parent[parent[p]];
        return p;
    };
    auto shells = static_cast<std::int64_t>(all.patches.size());
    for (std::size_t e = 0; e < edges.size() && shells > 1; ++e) {
        const auto around = edges[e];
        for (std::size_t i = 1; i < around.size() && around.size() > 2; ++i) {
            const std::size_t a = root(around[0]), b = root(around[i]);
            if (a == b) continue;
            parent[std::max(a, b)] = std::min(a, b);
            --shells;
        }
    }
    return shells;
}

}  // namespace

WindingReport unify_winding(TriangleMesh& mesh, const EdgeTable& edges) {
    constexpr double nearly_closed = 0.25;
    Patches all = collect_patches(mesh, edges);
    for (Patch& patch : all.patches) measure(mesh, all, patch);
    WindingReport report;
    report.one_sided = all.one_sided;
    report.shells = all.patches.size() > 1 ? count_shells(all, edges) : static_cast<std::int64_t>(all.patches.size());
    report.cavities = turn_closed(mesh, all);
    for (Patch& patch : all.patches) {
        if (!patch.closed && patch.vector_area_ratio < nearly_closed && patch.file_volume < 0)
            patch.inverted = !patch.inverted;
        for (std::size_t i = patch.first; i < patch.last; ++i) {
            const auto t = static_cast<std::size_t>(all.order[i]);
            if ((all.turned[t] != 0) == patch.inverted) continue;
            std::swap(mesh.triangles[t][1], mesh.triangles[t][2]);
            ++report.flipped;
        }
    }
    return report;
}

}  // namespace partonomy
