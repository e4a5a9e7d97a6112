// Borders that lie where people would draw them.
//
// Growing ends where a wall ends, which under noise and on fillets is near the crease between two parts, not on it. So
// each border between two parts is drawn again: among the triangles not much farther from it than the
// thinner part is thick, the cheapest closed cut (a minimum cut, found as a maximum flow) that still parts the two. An
// edge costs its length, less where it runs along a concave crease: the bend over the distance of the two triangles,
// times the thickness, tells a crease from the slow bend of a wall on any mesh. A triangle that changes sides costs its
// area over half the thickness, so a border moves to a crease nearby, and without one it stays.
//
// Coarse meshes are not settled: their borders are edges that someone drew. Cost: about linear in the triangles near
// borders, whose strip is at most some triangles wide: without that limit the flow took a quarter of all time on five
// million triangles.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <numeric>
#include <optional>
#include <utility>

#include "base/ranges.h"
#include "shape/claims.h"

namespace partonomy {

namespace {

constexpr double strip = 0.7;       // thicknesses to each side of the border
constexpr double widest = 12;       // edges to each side: growing ends nearer to the crease than that on any fine mesh
constexpr double crease = 2;        // bend over a thickness (radians) that makes half the cost
constexpr double noisy_crease = 6;  // under noise walls bend, too
constexpr double inertia = 1;       // cost of a changed triangle: its area / thickness, times this
constexpr double noisy_inertia = 0.6;  // under noise growing ends farther from the crease
constexpr double units = 1 << 20;      // of capacity for one mean edge

using Capacity = std::int64_t;
constexpr Capacity fixed = std::numeric_limits<std::int32_t>::max() * Capacity{1024};

enum class Tree : std::uint8_t { none, source, sink };

/// The strip along one border as a flow network: a node a triangle, an arc an edge.
///
/// Two trees of arcs with room grow towards each other, one from the source and one to the sink. Where they meet, flow
/// is sent; what comes off its tree by that looks for another place in it (Boykov and Kolmogorov 2004). Dinic's
/// algorithm, tried first, began anew with each length of ways, of which noisy borders of five million triangles have
/// 170: four times as long.
class Network {
public:
    struct Node {
        std::array<std::int32_t, 3> to{-1, -1, -1};  ///< node across each edge, or -1
        std::array<Capacity, 3> room{};
        Capacity terminal = 0;               ///< > 0: from the source, < 0: to the sink
        std::array<std::uint8_t, 3> back{};  ///< number of the edge in the node across
        Tree tree = Tree::none;
        std::uint8_t parent = no_parent;  ///< edge to it
        bool is_active = false;
        std::int32_t time = 0, distance = 0;  ///< to the root of the tree, as it was at a time
    };
    std::vector<Node> nodes;

    /// Fills the network; afterwards the source's tree holds all that can be reached from the source.
    void fill() {
        tell_ways_back();
        now_ = 0;
        for (std::size_t i = 0; i < nodes.size(); ++i)
            if (Node& node = nodes[i]; node.terminal != 0) {
                node.tree = node.terminal > 0 ? Tree::source : Tree::sink;
                node.parent = at_terminal;
                node.distance = 1;
                activate(static_cast<std::int32_t>(i));
            }
        while (!active_.empty()) {
            const std::int32_t i = active_.front();
            const std::optional<Arc> bridge = nodes[i].tree == Tree::none ? std::nullopt : grow(i);
            if (!bridge) {
                active_.pop_front();
                nodes[i].is_active = false;
                continue;
            }
            ++now_;
            send_over(*bridge);
            for (; !orphans_.empty();) {
                const std::int32_t orphan = orphans_.front();
                orphans_.pop_front();
                adopt(orphan);
            }
        }
    }

private:
    static constexpr std::uint8_t at_terminal = 3, no_parent = 4, orphaned = 5;
    struct Arc {
        std::int32_t from;
        std::size_t edge;
    };

    void tell_ways_back() {
        for (std::size_t i = 0; i < nodes.size(); ++i)
            for (std::size_t e = 0; e < 3; ++e) {
                if (nodes[i].to[e] < 0) continue;
                std::ptrdiff_t before = std::count(nodes[i].to.begin(), nodes[i].to.begin() + e, nodes[i].to[e]);
                const auto& other = nodes[nodes[i].to[e]].to;
                std::size_t f = 0;
                while (other[f] != static_cast<std::int32_t>(i) || before-- > 0) ++f;
                nodes[i].back[e] = static_cast<std::uint8_t>(f);
            }
    }

    void activate(std::int32_t i) {
        if (std::exchange(nodes[i].is_active, true)) return;
        active_.push_back(i);
    }

    /// Room of the arc over edge e of node i, in the direction in which flow runs in its tree: away from the node in
    /// the source's, towards it in the sink's.
    [[nodiscard]] Capacity room_beyond(const Node& node, std::size_t e) const {
        return node.tree == Tree::source ? node.room[e] : nodes[node.to[e]].room[node.back[e]];
    }
    /// The same from the node across, as if that were the parent.
    [[nodiscard]] Capacity room_before(const Node& node, std::size_t e) const {
        return node.tree == Tree::source ? nodes[node.to[e]].room[node.back[e]] : node.room[e];
    }

    /// Takes free neighbours into the tree of a node; the arc from the source's tree to the sink's when there is one.
    std::optional<Arc> grow(std::int32_t i) {
        const Node& node = nodes[i];
        for (std::size_t e = 0; e < 3; ++e) {
            if (node.to[e] < 0 || room_beyond(node, e) == 0) continue;
            Node& next = nodes[node.to[e]];
            if (next.tree != Tree::none && next.tree != node.tree)
                return node.tree == Tree::source ? Arc{i, e} : Arc{node.to[e], node.back[e]};
            const bool is_free = next.tree == Tree::none;
            if (!is_free && (next.time > node.time || next.distance <= node.distance)) continue;
            next.tree = node.tree;
            next.parent = node.back[e];
            next.time = node.time;
            next.distance = node.distance + 1;
            if (is_free) activate(node.to[e]);
        }
        return std::nullopt;
    }

    void send_over(const Arc& bridge) {
        const std::int32_t start = bridge.from, end = nodes[start].to[bridge.edge];
        Capacity flow = nodes[start].room[bridge.edge];
        const auto root_of = [&](std::int32_t i) {
            for (; nodes[i].parent != at_terminal; i = nodes[i].to[nodes[i].parent])
                flow = std::min(flow, room_before(nodes[i], nodes[i].parent));
            return i;
        };
        flow = std::min(flow, nodes[root_of(start)].terminal);
        flow = std::min(flow, -nodes[root_of(end)].terminal);
        move(start, bridge.edge, flow);
        const auto send_from_root = [&](std::int32_t i) {
            while (nodes[i].parent != at_terminal) {
                Node& node = nodes[i];
                const std::uint8_t e = node.parent;
                const std::int32_t parent = node.to[e];
                if (node.tree == Tree::source)
                    move(parent, node.back[e], flow);
                else
                    move(i, e, flow);
                if (room_before(node, e) == 0) orphan(i);
                i = parent;
            }
            Node& root = nodes[i];
            root.terminal += root.tree == Tree::source ? -flow : flow;
            if (root.terminal == 0) orphan(i);
        };
        send_from_root(start);
        send_from_root(end);
    }

    void move(std::int32_t from, std::size_t e, Capacity flow) {
        Node& node = nodes[from];
        node.room[e] -= flow;
        nodes[node.to[e]].room[node.back[e]] += flow;
    }

    void orphan(std::int32_t i) {
        nodes[i].parent = orphaned;
        orphans_.push_back(i);
    }

    /// Length of the way from a node to the root of its tree; none when it leads to an orphan.
    std::optional<std::int32_t> distance_to_root(std::int32_t i) {
        std::int32_t steps = 0;
        std::int32_t at = i;
        while (nodes[at].time != now_) {
            if (nodes[at].parent == orphaned) return std::nullopt;
            if (nodes[at].parent == at_terminal) {
                nodes[at].time = now_;
                nodes[at].distance = 1;
                break;
            }
            ++steps;
            at = nodes[at].to[nodes[at].parent];
        }
        const std::int32_t distance = nodes[at].distance + steps;
        for (std::int32_t d = distance; nodes[i].time != now_; i = nodes[i].to[nodes[i].parent], --d) {
            nodes[i].time = now_;
            nodes[i].distance = d;
        }
        return distance;
    }

    /// Hangs an orphan to the neighbour that is nearest to the root, or takes it out of its tree.
    void adopt(std::int32_t i) {
        Node& node = nodes[i];
        std::int32_t nearest = std::numeric_limits<std::int32_t>::max();
        for (std::size_t e = 0; e < 3; ++e) {
            if (node.to[e] < 0 || nodes[node.to[e]].tree != node.tree || room_before(node, e) == 0) continue;
            const std::optional<std::int32_t> distance = distance_to_root(node.to[e]);
            if (!distance || *distance >= nearest) continue;
            nearest = *distance;
            node.parent = static_cast<std::uint8_t>(e);
            node.distance = nearest + 1;
            node.time = now_;
        }
        if (node.parent != orphaned) return;
        for (std::size_t e = 0; e < 3; ++e) {
            if (node.to[e] < 0 || nodes[node.to[e]].tree != node.tree) continue;
            if (room_before(node, e) > 0) activate(node.to[e]);
            if (nodes[node.to[e]].parent == node.back[e]) orphan(node.to[e]);
        }
        node.tree = Tree::none;
        node.parent = no_parent;
    }

    std::int32_t now_ = 0;
    std::deque<std::int32_t> active_, orphans_;
};

class Settler {
public:
    Settler(const Surface& surface, const Parts& parts) : s_(surface), parts_(parts), node_of_(surface.count(), -1) {}

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
        keep_heart(a);
        keep_heart(b);
        network_.fill();
        for (std::size_t k = 0; k < strip_.size(); ++k) {
            if (parts_.part_of[strip_[k]] != (network_.nodes[k].tree == Tree::source ? a : b))
                changing.push_back(strip_[k]);
            node_of_[strip_[k]] = -1;
        }
        return changing;
    }

private:
    /// The triangles of both parts within reach of the border, along the surface.
    void collect(std::int32_t a, std::int32_t b, const std::vector<std::int32_t>& border, double reach) {
        strip_.clear();
        distance_.clear();
        const auto visit = [&](std::int32_t i, double distance) {
            if (distance > reach) return;
            if (node_of_[i] < 0) {
                node_of_[i] = static_cast<std::int32_t>(strip_.size());
                strip_.push_back(i);
                distance_.push_back(distance);
            }
        };
        for (const std::int32_t i : border) visit(i, 0);
        for (std::size_t at = 0; at < strip_.size(); ++at)
            for (const std::int32_t j : s_.adjacency.neighbours[strip_[at]])
                if (j >= 0 && (parts_.part_of[j] == a || parts_.part_of[j] == b))
                    visit(j, distance_[at] + (s_.geometry.barycentres[j] - s_.geometry.barycentres[strip_[at]]).norm());
    }

    void build(std::int32_t a, std::int32_t b, double thickness) {
        network_.nodes.assign(strip_.size(), {});
        double sum = 0;
        for (const std::int32_t i : strip_) sum += std::sqrt(s_.geometry.areas[i]);
        const double unit = units * static_cast<double>(strip_.size()) / sum;
        constexpr std::size_t grain = 512;
        for_each_range(
            strip_.size(), s_.threads,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k) build_node(k, a, b, thickness, unit);
            },
            grain);
    }

    void build_node(std::size_t k, std::int32_t a, std::int32_t b, double thickness, double unit) {
        const std::int32_t i = strip_[k];
        Network::Node& node = network_.nodes[k];
        const int side = parts_.part_of[i] == a ? 1 : -1;
        bool is_edge = false;
        for (int e = 0; e < 3; ++e) {
            const std::int32_t j = s_.adjacency.neighbours[i][e];
            if (j < 0 || (parts_.part_of[j] != a && parts_.part_of[j] != b)) continue;
            if (node_of_[j] < 0) {
                is_edge = true;
                continue;
            }
            node.to[e] = node_of_[j];
            node.room[e] = 1 + std::llround(unit * cost(i, e, j, thickness));
        }
        const double stay = unit * (s_.grain > 0 ? noisy_inertia : inertia) * s_.geometry.areas[i] / thickness;
        node.terminal = side * (is_edge ? fixed : std::llround(stay));
    }

    /// Of a part that is all within reach of the border, the farther half stays, lest it vanish.
    void keep_heart(std::int32_t part) {
        double farthest = 0;
        for (std::size_t k = 0; k < strip_.size(); ++k) {
            if (parts_.part_of[strip_[k]] != part) continue;
            if (std::abs(network_.nodes[k].terminal) == fixed) return;
            farthest = std::max(farthest, distance_[k]);
        }
        for (std::size_t k = 0; k < strip_.size(); ++k)
            if (parts_.part_of[strip_[k]] == part && distance_[k] > farthest / 2)
                network_.nodes[k].terminal = network_.nodes[k].terminal < 0 ? -fixed : fixed;
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
    std::vector<double> distance_;  ///< of the strip from the border
    Network network_;
};

/// Settlers are used again: each holds a number for every triangle.
class SettlerPool {
public:
    SettlerPool(const Surface& surface, const Parts& parts) : s_(surface), parts_(parts) {}

    std::unique_ptr<Settler> take() {
        const std::lock_guard lock(mutex_);
        if (idle_.empty()) return std::make_unique<Settler>(s_, parts_);
        std::unique_ptr<Settler> settler = std::move(idle_.back());
        idle_.pop_back();
        return settler;
    }
    void give_back(std::unique_ptr<Settler> settler) {
        const std::lock_guard lock(mutex_);
        idle_.push_back(std::move(settler));
    }

private:
    const Surface& s_;
    const Parts& parts_;
    std::mutex mutex_;
    std::vector<std::unique_ptr<Settler>> idle_;
};

}  // namespace

void settle_borders(const Surface& s, Parts& parts) {
    struct Border {
        std::int32_t a, b;
        std::vector<std::int32_t> triangles, changing;
    };
    using Lists = std::map<std::pair<std::int32_t, std::int32_t>, std::vector<std::int32_t>>;
    const auto of_blocks = map_blocks(s.count(), s.threads, [&](std::size_t begin, std::size_t end) {
        Lists along;
        for (std::size_t i = begin; i < end; ++i) {
            const std::int32_t own = parts.part_of[i];
            if (own < 0) continue;
            for (const std::int32_t j : s.adjacency.neighbours[i])
                if (j >= 0 && parts.part_of[j] >= 0 && parts.part_of[j] != own)
                    along[std::minmax(own, parts.part_of[j])].push_back(static_cast<std::int32_t>(i));
        }
        return along;
    });
    Lists along;
    for (const Lists& some : of_blocks)
        for (const auto& [pair, triangles] : some) {
            std::vector<std::int32_t>& all = along[pair];
            all.insert(all.end(), triangles.begin(), triangles.end());
        }
    std::vector<Border> borders;
    for (auto& [pair, triangles] : along) borders.push_back({pair.first, pair.second, std::move(triangles), {}});
    std::vector<std::size_t> long_first(borders.size());
    std::iota(long_first.begin(), long_first.end(), 0);
    std::ranges::stable_sort(long_first, std::greater<>(), [&](std::size_t k) { return borders[k].triangles.size(); });
    // Each border is drawn as if it were alone. Where two meet, the first takes the triangles that both want.
    SettlerPool pool(s, parts);
    for_each_range(
        borders.size(), s.threads,
        [&](std::size_t begin, std::size_t end) {
            std::unique_ptr<Settler> settler = pool.take();
            for (std::size_t k = begin; k < end; ++k) {
                Border& border = borders[long_first[k]];
                border.changing = settler->settle(border.a, border.b, border.triangles);
            }
            pool.give_back(std::move(settler));
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
