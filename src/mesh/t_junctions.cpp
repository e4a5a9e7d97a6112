// Programs that cut one face and not its neighbour leave a vertex in the middle of the neighbour's edge. For the eye
// the surface is closed there, for whoever walks over it it is open: a plate would fall into pieces. From one end of
// each open edge we walk along open edges that lie on it; where the walk comes to the other end, the triangle is cut at
// the vertices on the way. A triangle with such vertices on its sides is a convex polygon with corners of 180 degrees.
// Its smallest corner is cut off until nothing is left; three vertices on one side are no corner, whatever rounding
// says.

#include "mesh/t_junctions.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <utility>

namespace partonomy {
namespace {

using Triangle = std::array<std::int32_t, 3>;
using Link = std::pair<std::int32_t, std::int32_t>;  ///< from a vertex to another along an open edge

constexpr double straight = 1e-6;           ///< of the mesh's diagonal: how far off the edge a vertex may lie
constexpr double progress = 1e-3;           ///< of the edge: how far apart vertices on it are at least
constexpr std::ptrdiff_t most_links = 256;  ///< of a vertex: where more open edges meet is no side of a face, but a fan

class Walker {
public:
    Walker(const TriangleMesh& mesh, const EdgeTable& edges) : mesh_(mesh) {
        for (std::size_t e = 0; e < edges.size(); ++e) {
            if (edges[e].size() != 1) continue;
            const std::int32_t h = edges[e][0];
            open_.push_back(h);
            links_.emplace_back(corner(h), corner(next(h)));
            links_.emplace_back(corner(next(h)), corner(h));
        }
        if (open_.empty()) return;
        std::sort(links_.begin(), links_.end());
        reach_ = straight * compute_used_bounds(mesh).diagonal();
    }

    [[nodiscard]] const std::vector<std::int32_t>& open_edges() const { return open_; }

    /// Vertices on the way from the start of half-edge h to its end along other open edges; empty when there is none.
    [[nodiscard]] std::vector<std::int32_t> on_the_way(std::int32_t h) const {
        const std::int32_t from = corner(h), to = corner(next(h));
        const Vec3& start = at(from);
        const Vec3 way = at(to) - start;
        const double length = way.norm(), off = std::min(reach_, 0.01 * length);
        std::vector<std::int32_t> vertices;
        std::int32_t here = from;
        double share = 0;
        while (length > 0 && here != to) {
            const auto first = std::lower_bound(links_.begin(), links_.end(), Link{here, -1});
            if (links_.end() - first > most_links && (first + most_links)->first == here) return {};
            std::int32_t nearest = -1;
            double nearest_share = 2;
            for (auto link = first; link != links_.end() && link->first == here; ++link) {
                if (here == from && link->second == to) continue;  // the edge itself
                const Vec3 there = at(link->second) - start;
                const double s = link->second == to ? 1 : there.dot(way) / (length * length);
                if (s < share + progress || s >= nearest_share || (link->second != to && s > 1 - progress) ||
                    (there - s * way).norm() > off)
                    continue;
                nearest = link->second;
                nearest_share = s;
            }
            if (nearest < 0) return {};
            if (nearest != to) vertices.push_back(nearest);
            here = nearest;
            share = nearest_share;
        }
        return vertices;
    }

private:
    [[nodiscard]] std::int32_t corner(std::int32_t h) const {
        return mesh_.triangles[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>(h % 3)];
    }
    static std::int32_t next(std::int32_t h) { return h - h % 3 + (h % 3 + 1) % 3; }
    [[nodiscard]] const Vec3& at(std::int32_t v) const { return mesh_.positions[static_cast<std::size_t>(v)]; }

    const TriangleMesh& mesh_;
    double reach_ = 0;
    std::vector<std::int32_t> open_;
    std::vector<Link> links_;
};

/// A vertex of a triangle that is to be cut, and the sides of the triangle that it is on, a bit each.
struct OnSides {
    std::int32_t vertex;
    unsigned sides;
};

/// Cuts corners off the polygon until it is used up.
void cut_up(const std::vector<Vec3>& positions, std::vector<OnSides> polygon, std::vector<Triangle>& triangles) {
    const auto at = [&](const OnSides& v) -> const Vec3& { return positions[static_cast<std::size_t>(v.vertex)]; };
    const auto leaves_one_side = [&](std::size_t cut) {
        unsigned common = ~0U;
        for (std::size_t i = 0; i < polygon.size(); ++i)
            if (i != cut) common &= polygon[i].sides;
        return polygon.size() > 3 && common != 0;
    };
    while (polygon.size() >= 3) {
        const std::size_t count = polygon.size();
        std::size_t smallest = 0;
        double smallest_area = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < count; ++i) {
            const OnSides &a = polygon[(i + count - 1) % count], &b = polygon[i], &c = polygon[(i + 1) % count];
            if ((a.sides & b.sides & c.sides) != 0 || leaves_one_side(i)) continue;
            const double area = (at(b) - at(a)).cross(at(c) - at(a)).norm();
            if (area < smallest_area) smallest = i, smallest_area = area;
        }
        triangles.push_back({polygon[(smallest + count - 1) % count].vertex, polygon[smallest].vertex,
                             polygon[(smallest + 1) % count].vertex});
        polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(smallest));
    }
}

/// Of a triangle so flat that its third corner is on the way along its longest side.
bool meets_itself(const std::vector<OnSides>& polygon) {
    for (std::size_t i = 0; i < polygon.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (polygon[i].vertex == polygon[j].vertex) return true;
    return false;
}

}  // namespace

std::int64_t cut_at_t_junctions(TriangleMesh& mesh, const EdgeTable& edges) {
    const Walker walker(mesh, edges);
    if (walker.open_edges().empty()) return 0;
    std::map<std::int32_t, std::vector<std::int32_t>> on_edge;  // by half-edge
    for (const std::int32_t h : walker.open_edges())
        if (std::vector<std::int32_t> vertices = walker.on_the_way(h); !vertices.empty())
            on_edge.emplace(h, std::move(vertices));
    if (on_edge.empty()) return 0;
    std::vector<Triangle> triangles;
    std::vector<std::int32_t> input_faces;
    auto cut = on_edge.begin();
    std::int64_t count = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        std::vector<OnSides> polygon;
        const auto first = cut;
        for (unsigned e = 0; e < 3; ++e) {
            polygon.push_back({mesh.triangles[t][e], 1U << e | 1U << (e + 2) % 3});
            if (cut == on_edge.end() || cut->first != static_cast<std::int32_t>(3 * t + e)) continue;
            for (const std::int32_t vertex : cut->second) polygon.push_back({vertex, 1U << e});
            ++cut;
        }
        if (polygon.size() == 3 || meets_itself(polygon))
            triangles.push_back(mesh.triangles[t]);
        else {
            cut_up(mesh.positions, std::move(polygon), triangles);
            count += std::distance(first, cut);
        }
        input_faces.resize(triangles.size(), mesh.input_faces[t]);
    }
    mesh.triangles = std::move(triangles);
    mesh.input_faces = std::move(input_faces);
    return count;
}

}  // namespace partonomy
