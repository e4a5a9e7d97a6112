// Borders that lie where people would draw them.
//
// Growing ends where a wall ends, which under noise and on fillets is near the crease between two parts, not on it. So
// each border between two parts is drawn again: among the triangles not much farther from it than the
// thinner part is thick, the cheapest closed cut (a minimum cut, found as a maximum flow by Dinic's algorithm) that
// still parts the two. An edge costs its length, less where it runs along a concave crease: the bend over the distance
// of the two triangles, times the thickness, tells a crease from the slow bend of a wall on any mesh. A triangle that
// changes sides costs its area over half the thickness, so a border moves to a crease nearby, and without one it
// stays.
//
// Coarse meshes are not settled: their borders are edges that someone drew. Cost: about linear in the triangles near
// borders, whose strip is at most some triangles wide: without that limit the flow took a quarter of all time on five
// million triangles.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "base/ranges.h"
#include "shape/claims.h"

namespace partonomy {

namespace {

constexpr double strip = 0.7;  // thicknesses to each side of the border
constexpr double widest = 12;  // edges to each side: growing ends nearer to the crease than that on any fine mesh
constexpr double crease = 2;   // bend over a thickness (radians) that makes half the cost
constexpr double noisy_crease = 6;  // under noise walls bend, too
constexpr double inertia = 1;  // cost of a changed triangle: its area / thickness, times this
constexpr double noisy_inertia = 0.6;  // under noise growing ends farther from the crease
constexpr double units = 1 << 20;      // of capacity for one mean edge
constexpr std::size_t most_teams = 4;  // each holds some numbers for every triangle

using Capacity = std::int64_t;

/// The strip along one border as a flow network: a node a triangle, an arc an edge.
struct Network {
    std::vector<std::array<std::int32_t, 3>> to;  ///< node across each edge, or -1
    std::vector<std::array<Capacity, 3>> room;
    std::vector<Capacity> terminal;  ///< > 0: from the source, < 0: to the sink

    /// Fills the network; afterwards `level` >= 0 tells the nodes on the source's side.
    void fill() {
        level.resize(to.size());
        next.resize(to.size());
        while (find_levels()) {
            std::fill(next.begin(), next.end(), std::int8_t{0});
            for (std::size_t i = 0; i < to.size(); ++i)
                while (terminal[i] > 0 && push_from(static_cast<std::int32_t>(i))) {
                }
        }
    }

    std::vector<std::int32_t> level;

private:
    bool find_levels() {
        queue.clear();
        std::fill(level.begin(), level.end(), -1);
        for (std::size_t i = 0; i < to.size(); ++i)
            if (terminal[i] > 0) level[i] = 0, queue.push_back(static_cast<std::int32_t>(i));
        bool reached = false;
        for (std::size_t at = 0; at < queue.size(); ++at) {
            const std::int32_t i = queue[at];
            if (terminal[i] < 0) reached = true;
            for (int e = 0; e < 3; ++e) {
                const std::int32_t j = to[i][e];
                if (j < 0 || room[i][e] == 0 || level[j] >= 0) continue;
                level[j] = level[i] + 1;
                queue.push_back(j);
            }
        }
        return reached;
    }

    /// Sends flow along one way down the levels; false when there is none left.
    bool push_from(std::int32_t source) {
        way.assign(1, source);
        while (!way.empty()) {
            const std::int32_t i = way.back();
            if (terminal[i] < 0) return send(), true;
            bool goes_on = false;
            for (; next[i] < 3 && !goes_on; next[i] += !goes_on) {
                const std::int32_t j = to[i][next[i]];
                goes_on = j >= 0 && room[i][next[i]] > 0 && level[j] == level[i] + 1;
                if (goes_on) way.push_back(j);
            }
            if (goes_on) continue;
            way.pop_back();
            if (!way.empty()) ++next[way.back()];
        }
        return false;
    }

    void send() {
        Capacity flow = std::min(terminal[way.front()], -terminal[way.back()]);
        for (std::size_t k = 0; k + 1 < way.size(); ++k) flow = std::min(flow, room[way[k]][next[way[k]]]);
        for (std::size_t k = 0; k + 1 < way.size(); ++k) {
            room[way[k]][next[way[k]]] -= flow;
            const auto& back = to[way[k + 1]];
            room[way[k + 1]][std::find(back.begin(), back.end(), way[k]) - back.begin()] += flow;
        }
        terminal[way.front()] -= flow;
        terminal[way.back()] += flow;
    }

    std::vector<std::int8_t> next;
    std::vector<std::int32_t> queue, way;
};

class Settler {
public:
    Settler(const Surface& surface, const Parts& parts)
        : s_(surface), parts_(parts), node_of_(surface.count(), -1), distance_(surface.count()) {}

    /// Triangles that change from one of two parts to the other.
    std::vector<std::int32_t> settle(std::int32_t a, std::int32_t b, const std::vector<std::int32_t>& border) {
        std::vector<std::int32_t> changing;
        const double thickness = std::min(parts_.parts[a].thickness, parts_.parts[b].thickness);
        if (!(thickness > 0)) return changing;
        double area = 0;
        for (const std::int32_t i : border) area += s_.geometry.areas[i];
        const double edge = 1.5 * std::sqrt(area / static_cast<double>(border.size()));
        collect(a, b, border, std::min(strip * thickness, widest * edge));
        build(a, b, thickness);
        network_.fill();
        for (std::size_t k = 0; k < strip_.size(); ++k) {
            if (parts_.part_of[strip_[k]] != (network_.level[k] >= 0 ? a : b)) changing.push_back(strip_[k]);
            node_of_[strip_[k]] = -1;
        }
        return changing;
    }

private:
    /// The triangles of both parts within reach of the border, along the surface.
    void collect(std::int32_t a, std::int32_t b, const std::vector<std::int32_t>& border, double reach) {
        strip_.clear();
        const auto visit = [&](std::int32_t i, double distance) {
            if (distance > reach) return;
            if (node_of_[i] < 0) {
                node_of_[i] = static_cast<std::int32_t>(strip_.size());
                strip_.push_back(i);
                distance_[i] = distance;
            }
        };
        for (const std::int32_t i : border) visit(i, 0);
        for (std::size_t at = 0; at < strip_.size(); ++at)
            for (const std::int32_t j : s_.adjacency.neighbours[strip_[at]])
                if (j >= 0 && (parts_.part_of[j] == a || parts_.part_of[j] == b))
                    visit(j, distance_[strip_[at]] +
                                 (s_.geometry.barycentres[j] - s_.geometry.barycentres[strip_[at]]).norm());
    }

    void build(std::int32_t a, std::int32_t b, double thickness) {
        network_.to.assign(strip_.size(), {-1, -1, -1});
        network_.room.assign(strip_.size(), {0, 0, 0});
        network_.terminal.assign(strip_.size(), 0);
        double sum = 0;
        for (const std::int32_t i : strip_) sum += std::sqrt(s_.geometry.areas[i]);
        const double unit = units * static_cast<double>(strip_.size()) / sum;
        for (std::size_t k = 0; k < strip_.size(); ++k) {
            const std::int32_t i = strip_[k];
            const int side = parts_.part_of[i] == a ? 1 : -1;
            bool is_edge = false;
            for (int e = 0; e < 3; ++e) {
                const std::int32_t j = s_.adjacency.neighbours[i][e];
                if (j < 0 || (parts_.part_of[j] != a && parts_.part_of[j] != b)) continue;
                if (node_of_[j] < 0) {
                    is_edge = true;
                    continue;
                }
                network_.to[k][e] = node_of_[j];
                network_.room[k][e] = 1 + std::llround(unit * cost(i, e, j, thickness));
            }
            const double stay = unit * (s_.grain > 0 ? noisy_inertia : inertia) * s_.geometry.areas[i] / thickness;
            network_.terminal[k] =
                side * (is_edge ? std::numeric_limits<std::int32_t>::max() * Capacity{1024} : std::llround(stay));
        }
    }

    [[nodiscard]] double cost(std::int32_t i, int e, std::int32_t j, double thickness) const {
        const auto& corners = s_.mesh.triangles[i];
        const double length = (s_.mesh.positions[corners[e]] - s_.mesh.positions[corners[(e + 1) % 3]]).norm();
        const Vec3 way = s_.geometry.barycentres[j] - s_.geometry.barycentres[i];
        if (way.dot(s_.geometry.normals[i] - s_.geometry.normals[j]) <= 0) return length;
        const double bend =
            (s_.geometry.normals[i] - s_.geometry.normals[j]).norm() / std::max(way.norm(), 1e-9 * s_.size);
        return length / (1 + bend * thickness / (s_.grain > 0 ? noisy_crease : crease));
    }

    const Surface& s_;
    const Parts& parts_;
    std::vector<std::int32_t> node_of_, strip_;
    std::vector<double> distance_;
    Network network_;
};

}  // namespace

void settle_borders(const Surface& s, Parts& parts) {
    struct Border {
        std::int32_t a, b;
        std::vector<std::int32_t> triangles, changing;
    };
    std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::int32_t>> along;
    for (std::size_t i = 0; i < s.count(); ++i) {
        const std::int32_t own = parts.part_of[i];
        if (own < 0) continue;
        for (const std::int32_t j : s.adjacency.neighbours[i])
            if (j >= 0 && parts.part_of[j] >= 0 && parts.part_of[j] != own)
                along[std::minmax(own, parts.part_of[j])].push_back(static_cast<std::int32_t>(i));
    }
    std::vector<Border> borders;
    for (auto& [pair, triangles] : along) borders.push_back({pair.first, pair.second, std::move(triangles), {}});
    // Each border is drawn as if it were alone. Where two meet, the first takes the triangles that both want.
    const std::size_t teams = std::min(borders.size(), most_teams);
    for_each_range(
        teams, s.threads,
        [&](std::size_t begin, std::size_t end) {
            Settler settler(s, parts);
            for (std::size_t team = begin; team < end; ++team)
                for (std::size_t k = team; k < borders.size(); k += teams)
                    borders[k].changing = settler.settle(borders[k].a, borders[k].b, borders[k].triangles);
        },
        1);
    std::vector<char> has_changed(s.count(), 0);
    for (const auto& [a, b, triangles, changing] : borders)
        for (const std::int32_t i : changing) {
            if (std::exchange(has_changed[i], 1) != 0) continue;
            parts.part_of[i] = parts.part_of[i] == a ? b : a;
        }
}

}  // namespace partonomy
