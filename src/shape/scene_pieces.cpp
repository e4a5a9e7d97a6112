// Where the things of a scene end.
//
// What stands on the ground, hangs on a wall or is set into it, ends in a concave crease that leads all around it: the
// foot of a lamp post, the outline of a door. So the surface is first cut into flat or smooth sides, at every edge that
// turns by 20 degrees; sides that meet in a convex edge grow together again, and what a concave crease parts on all
// ways stays apart. Shells that touch nowhere are apart anyhow.
//
// A side most of whose outline is concave is a piece of its own even where the rest of its outline is convex: the
// bottom of a recess that reaches the foot of a wall, the road between two kerbs that ends with the ground. What counts
// is the longest loop of its outline: the feet of houses within the ground do not make it end. Single triangles are not
// taken for such sides: on a coarse bumpy tree top each triangle is a side.
//
// A piece is plain when no two large sides of it (a hundredth of its surface each) meet in a concave crease: a box, a
// ball, a wall with windows carved into it. The others (a house with two wings, a bench whose legs are flush with its
// seat) are for find_parts. Cost: O(n).

#include "shape/scene_pieces.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace partonomy {

namespace {

const double crease_cosine = std::cos(20 * std::numbers::pi / 180);
constexpr double mostly = 0.7;       // of its outline is concave: a side on its own
constexpr double large_side = 0.01;  // of a piece's surface

class Union {
public:
    explicit Union(std::size_t count) : parents_(count) { std::iota(parents_.begin(), parents_.end(), 0); }
    std::int32_t find(std::int32_t i) {
        while (parents_[i] != i) i = parents_[i] = parents_[parents_[i]];
        return i;
    }
    /// The lower number stays.
    void join(std::int32_t a, std::int32_t b) {
        a = find(a), b = find(b);
        parents_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::int32_t> parents_;
};

constexpr double much_larger = 3;     // in area
constexpr double faces_alike = 0.99;  // cosine

struct Side {
    double area = 0, outline = 0, concave = 0;  // the latter two of the longest loop of its outline
    std::int32_t triangles = 0;
    Vec3 normal = Vec3::Zero();  // sum over its area
};

struct Border {
    double convex = 0, concave = 0;
};
using Borders = std::map<std::pair<std::int32_t, std::int32_t>, Border>;

/// An edge of a side's outline.
struct Rim {
    std::int32_t side, from, to;
    double length;
    bool is_concave;
};

/// The longest loop of each side's outline: how long it is, and how much of it is concave.
void measure_outlines(std::vector<Rim>& rims, std::vector<Side>& sides) {
    std::ranges::stable_sort(rims, {}, &Rim::side);
    std::vector<std::int32_t> corners;
    for (std::size_t begin = 0, end = 0; begin < rims.size(); begin = end) {
        corners.clear();
        for (end = begin; end < rims.size() && rims[end].side == rims[begin].side; ++end)
            corners.insert(corners.end(), {rims[end].from, rims[end].to});
        std::ranges::sort(corners);
        corners.erase(std::ranges::unique(corners).begin(), corners.end());
        const auto number_of = [&](std::int32_t corner) {
            return static_cast<std::int32_t>(std::ranges::lower_bound(corners, corner) - corners.begin());
        };
        Union loops(corners.size());
        for (std::size_t i = begin; i < end; ++i) loops.join(number_of(rims[i].from), number_of(rims[i].to));
        std::vector<double> length(corners.size(), 0), concave(corners.size(), 0);
        for (std::size_t i = begin; i < end; ++i) {
            const std::int32_t loop = loops.find(number_of(rims[i].from));
            length[loop] += rims[i].length;
            if (rims[i].is_concave) concave[loop] += rims[i].length;
        }
        const auto longest = std::ranges::max_element(length) - length.begin();
        sides[rims[begin].side].outline = length[longest];
        sides[rims[begin].side].concave = concave[longest];
    }
}

/// Sides that would join two much larger ones that face the same way; with which of those each goes.
std::map<std::int32_t, std::int32_t> bridges(const std::vector<Side>& sides, const Borders& borders) {
    std::map<std::int32_t, std::vector<std::pair<double, std::int32_t>>> larger;  // length of the border, other side
    for (const auto& [pair, border] : borders) {
        if (border.convex <= border.concave) continue;
        for (const auto& [small, large] : {pair, std::pair(pair.second, pair.first)})
            if (sides[large].area > much_larger * sides[small].area) larger[small].emplace_back(border.convex, large);
    }
    std::map<std::int32_t, std::int32_t> found;
    for (const auto& [small, around] : larger)
        for (std::size_t i = 0; i < around.size(); ++i)
            for (std::size_t j = 0; j < i; ++j) {
                const Side &a = sides[around[i].second], &b = sides[around[j].second];
                if (a.normal.dot(b.normal) > faces_alike * a.area * b.area)
                    found[small] = std::ranges::max(around).second;
            }
    return found;
}

}  // namespace

std::vector<ScenePiece> scene_pieces(const TriangleMesh& mesh, const Adjacency& adjacency,
                                     const TriangleGeometry& geometry) {
    const auto count = static_cast<std::int32_t>(mesh.triangles.size());
    const auto for_each_edge = [&](const auto& visit) {  // visit(triangle, higher neighbour, edge of the first)
        for (std::int32_t i = 0; i < count; ++i)
            for (int e = 0; e < 3; ++e)
                if (const std::int32_t j = adjacency.neighbours[i][e]; j > i) visit(i, j, e);
    };
    const auto is_smooth = [&](std::int32_t i, std::int32_t j) {
        return geometry.normals[i].dot(geometry.normals[j]) > crease_cosine || !(geometry.areas[i] > 0) ||
               !(geometry.areas[j] > 0);
    };
    Union sides(mesh.triangles.size());
    for_each_edge([&](std::int32_t i, std::int32_t j, int) {
        if (is_smooth(i, j)) sides.join(i, j);
    });
    std::vector<std::int32_t> side_of(count);
    std::vector<Side> measured;
    for (std::int32_t i = 0; i < count; ++i) {
        if (const std::int32_t first = sides.find(i); first == i) {
            side_of[i] = static_cast<std::int32_t>(measured.size());
            measured.emplace_back();
        } else {
            side_of[i] = side_of[first];
        }
        Side& side = measured[side_of[i]];
        side.area += geometry.areas[i];
        side.normal += geometry.areas[i] * geometry.normals[i];
        ++side.triangles;
    }
    Borders borders;
    std::vector<Rim> rims;
    for_each_edge([&](std::int32_t i, std::int32_t j, int e) {
        const std::int32_t a = side_of[i], b = side_of[j];
        if (a == b) return;
        const auto& corners = mesh.triangles[i];
        const double length = (mesh.positions[corners[e]] - mesh.positions[corners[(e + 1) % 3]]).norm();
        const Vec3 across = geometry.barycentres[j] - geometry.barycentres[i];
        const bool is_concave = across.dot(geometry.normals[i]) > across.dot(geometry.normals[j]);
        Border& border = borders[std::minmax(a, b)];
        (is_concave ? border.concave : border.convex) += length;
        for (const std::int32_t side : {a, b})
            rims.push_back({side, corners[e], corners[(e + 1) % 3], length, is_concave});
    });
    measure_outlines(rims, measured);
    const auto stands_alone = [&](std::int32_t side) {
        return measured[side].triangles > 1 && measured[side].concave > mostly * measured[side].outline;
    };
    Union pieces(measured.size());
    const std::map<std::int32_t, std::int32_t> goes_with = bridges(measured, borders);
    for (const auto& [small, large] : goes_with) pieces.join(small, large);
    for (const auto& [pair, border] : borders)
        if (border.convex > border.concave && !stands_alone(pair.first) && !stands_alone(pair.second) &&
            !goes_with.contains(pair.first) && !goes_with.contains(pair.second))
            pieces.join(pair.first, pair.second);
    std::vector<double> areas(measured.size(), 0);
    for (std::size_t side = 0; side < measured.size(); ++side)
        areas[pieces.find(static_cast<std::int32_t>(side))] += measured[side].area;
    std::vector<char> is_winding(measured.size(), 0);
    for (const auto& [pair, border] : borders) {
        const std::int32_t piece = pieces.find(pair.first);
        if (border.concave > border.convex && piece == pieces.find(pair.second) &&
            std::min(measured[pair.first].area, measured[pair.second].area) > large_side * areas[piece])
            is_winding[piece] = 1;
    }
    std::vector<ScenePiece> result;
    std::vector<std::int32_t> number(measured.size(), -1);
    for (std::int32_t i = 0; i < count; ++i) {
        const std::int32_t piece = pieces.find(side_of[i]);
        if (number[piece] < 0) {
            number[piece] = static_cast<std::int32_t>(result.size());
            result.emplace_back().is_plain = !is_winding[piece];
        }
        result[number[piece]].triangles.push_back(i);
    }
    return result;
}

}  // namespace partonomy
