// Cutting a surface into planes, cylinders, spheres, cones and tori.
//
// Leaves are grown first: triangles whose normals stay near that of the seed, without crossing a sharp edge. A plane is
// one leaf, a round stick some strips, a ball some caps. Then neighbouring leaves merge, the pair first whose union is
// fitted best (hierarchical fitting of primitives, Attene, Falcidieno and Spagnuolo 2006), as long as one primitive
// fits the union. Where we depart: leaves, not triangles, are merged, so there are few pairs; no pair merges across a
// crease, whatever fits; and a simple primitive is preferred to one that fits a little better, so that noise and facets
// do not turn cylinders into tori. Noise folds a fine mesh, and makes creases around pieces of a few triangles; these
// go to a neighbour whatever is between, or there would be thousands of patches.
//
// A patch is seen through at most 160 points, so a fit costs the same for any number of triangles. Cost: O(n log n) to
// grow leaves, then some ten fits a leaf.

#include "shape/patches.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <queue>
#include <set>

#include "shape/rectangle.h"

namespace partonomy {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double leaf_angle = 14 * degree;
constexpr double sharp = 38 * degree;  // ten sides and more are round
constexpr double crumb = 0.002;        // of the area: such leaves go to a neighbour
constexpr std::size_t most_points = 160;
// Under noise: what is smaller is no leaf, whatever it is bounded by.
constexpr std::size_t fold_triangles = 12;
constexpr double fold_size = 10;  // of the noise that is left

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// A leaf, or what leaves were merged to.
struct Cluster {
    std::vector<std::int32_t> triangles;
    PointSet set;
    double area = 0;
    Primitive primitive;
    std::map<int, std::pair<double, double>> borders;  ///< neighbour -> length, and angle times length
    bool is_alive = true;
    int version = 0;
};

class Segmenter {
public:
    Segmenter(const PatchSurface& surface, std::span<const std::int32_t> triangles)
        : surface_(surface), triangles_(triangles), owner_(surface.mesh.triangles.size(), outside) {
        for (const std::int32_t t : triangles) {
            owner_[at(t)] = free_;
            total_ += surface.geometry.areas[at(t)];
        }
    }

    std::vector<Patch> run() {
        grow_leaves();
        find_borders();
        sweep_crumbs();
        for (Cluster& cluster : clusters_)
            if (cluster.is_alive) describe(cluster);
        merge_all();
        for (Cluster& cluster : clusters_)
            if (cluster.is_alive && cluster.version > 0) describe_again(cluster);
        std::vector<Patch> patches;
        for (Cluster& cluster : clusters_) {
            if (!cluster.is_alive) continue;
            std::ranges::sort(cluster.triangles);
            patches.push_back({std::move(cluster.triangles), cluster.primitive, cluster.area});
        }
        std::ranges::sort(patches, {}, [](const Patch& patch) { return patch.triangles.front(); });
        return patches;
    }

private:
    static constexpr int outside = -2, free_ = -1;
    static std::size_t at(std::int32_t i) { return static_cast<std::size_t>(i); }
    [[nodiscard]] const Vec3& normal(std::int32_t t) const { return surface_.geometry.normals[at(t)]; }
    [[nodiscard]] const std::array<std::int32_t, 3>& neighbours(std::int32_t t) const {
        return surface_.adjacency.neighbours[at(t)];
    }

    void grow_leaves() {
        // Seeds: where the surface bends least first, so that planes are not begun at their rims.
        std::vector<std::pair<double, std::int32_t>> seeds;
        for (const std::int32_t t : triangles_) {
            double bend = 0;
            for (const std::int32_t n : neighbours(t))
                bend = std::max(bend, n >= 0 ? angle_between(normal(t), normal(n)) : 0.0);
            seeds.emplace_back(std::round(bend / degree), t);
        }
        std::ranges::sort(seeds);
        for (const auto& [bend, seed] : seeds) {
            if (owner_[at(seed)] != free_) continue;
            const int number = static_cast<int>(clusters_.size());
            Cluster leaf;
            leaf.triangles.push_back(seed);
            owner_[at(seed)] = number;
            Vec3 sum = surface_.geometry.areas[at(seed)] * normal(seed);
            for (std::size_t i = 0; i < leaf.triangles.size(); ++i)
                for (const std::int32_t n : neighbours(leaf.triangles[i])) {
                    if (n < 0 || owner_[at(n)] != free_) continue;
                    if (angle_between(normal(n), normal(leaf.triangles[i])) > sharp) continue;
                    if (angle_between(normal(n), normal(seed)) > leaf_angle ||
                        (sum.norm() > 0 && angle_between(normal(n), sum) > leaf_angle))
                        continue;
                    owner_[at(n)] = number;
                    sum += surface_.geometry.areas[at(n)] * normal(n);
                    leaf.triangles.push_back(n);
                }
            for (const std::int32_t t : leaf.triangles) leaf.area += surface_.geometry.areas[at(t)];
            clusters_.push_back(std::move(leaf));
        }
    }

    void find_borders() {
        for (const std::int32_t t : triangles_)
            for (std::size_t e = 0; e < 3; ++e) {
                const std::int32_t n = neighbours(t)[e];
                if (n < 0 || owner_[at(n)] < 0 || owner_[at(n)] == owner_[at(t)]) continue;
                const auto& corners = surface_.mesh.triangles[at(t)];
                const double length =
                    (surface_.mesh.positions[at(corners[e])] - surface_.mesh.positions[at(corners[(e + 1) % 3])])
                        .norm();
                auto& [sum, angles] = clusters_[at(owner_[at(t)])].borders[owner_[at(n)]];
                sum += length;
                angles += length * angle_between(normal(t), normal(n));
            }
    }

    static bool is_crease(const std::pair<double, double>& border) { return border.second > sharp * border.first; }

    void join(int into, int from) {
        Cluster &a = clusters_[at(into)], &b = clusters_[at(from)];
        a.triangles.insert(a.triangles.end(), b.triangles.begin(), b.triangles.end());
        a.area += b.area;
        for (const auto& [other, border] : b.borders) {
            clusters_[at(other)].borders.erase(from);
            if (other == into) continue;
            for (auto* one : {&a.borders[other], &clusters_[at(other)].borders[into]}) {
                one->first += border.first;
                one->second += border.second;
            }
        }
        b.is_alive = false;
        b.triangles.clear();
        b.borders.clear();
        ++a.version;
    }

    /// Whether a cluster is so small that noise may have made it, and the creases around it.
    [[nodiscard]] bool is_fold(const Cluster& cluster) const {
        const double size = fold_size * surface_.noise;
        return surface_.noise > 0 && (cluster.triangles.size() < fold_triangles || cluster.area < size * size);
    }

    /// What noise leaves between leaves goes to the neighbour with the longest border; smallest first.
    void sweep_crumbs() {
        std::vector<std::pair<double, int>> crumbs;
        for (std::size_t c = 0; c < clusters_.size(); ++c)
            if (clusters_[c].area < crumb * total_) crumbs.emplace_back(clusters_[c].area, static_cast<int>(c));
        std::ranges::sort(crumbs);
        for (const auto& [area, c] : crumbs) {
            const Cluster& cluster = clusters_[at(c)];
            if (cluster.area >= crumb * total_) continue;  // has grown by others
            const bool is_free = is_fold(cluster);
            int best = -1;
            bool is_smooth = false;
            double longest = 0;
            for (const auto& [other, border] : cluster.borders) {
                const bool smooth = !is_crease(border);
                if (!smooth && (is_smooth || !is_free)) continue;
                if (smooth == is_smooth && border.first <= longest) continue;
                longest = border.first, best = other, is_smooth = smooth;
            }
            if (best >= 0) join(best, c);
        }
    }

    /// Points at equal steps of area, and what fits them.
    void describe(Cluster& cluster) const {
        const double step = cluster.area / most_points;
        double next = step / 2, sum = 0, u = 0.5, v = 0.5;
        std::ranges::sort(cluster.triangles);
        for (const std::int32_t t : cluster.triangles) {
            sum += surface_.geometry.areas[at(t)];
            for (; next < sum && step > 0; next += step) {
                u = std::fmod(u + 0.7548776662466927, 1.0), v = std::fmod(v + 0.5698402909980532, 1.0);
                const double a = u + v > 1 ? 1 - u : u, b = u + v > 1 ? 1 - v : v;
                const auto& corners = surface_.mesh.triangles[at(t)];
                const Vec3& first = surface_.mesh.positions[at(corners[0])];
                cluster.set.points.push_back(first + a * (surface_.mesh.positions[at(corners[1])] - first) +
                                             b * (surface_.mesh.positions[at(corners[2])] - first));
                cluster.set.normals.push_back(normal(t));
            }
        }
        cluster.primitive = fit(cluster.set, cluster.area);
    }

    /// What leaves were merged to is judged once more by points that no merging has thinned out.
    void describe_again(Cluster& cluster) const {
        const Primitive before = cluster.primitive;
        cluster.set = {};
        describe(cluster);
        if (cluster.primitive.kind == SurfaceKind::freeform) cluster.primitive = before;
    }

    [[nodiscard]] Primitive fit(const PointSet& set, double area) const {
        return set.points.size() < 3 ? Primitive{} : fit_primitive(set, std::sqrt(area), surface_.noise);
    }

    /// Points of both, thinned so that each stands for as much area.
    static PointSet together(const Cluster& a, const Cluster& b) {
        PointSet set;
        for (const Cluster* c : {&a, &b}) {
            const double wanted = static_cast<double>(most_points) * c->area / (a.area + b.area);
            const auto count = static_cast<double>(c->set.points.size());
            double next = 0;
            for (std::size_t i = 0; i < c->set.points.size(); ++i) {
                next += std::min(1.0, wanted / count);
                if (next < 1 - 1e-9) continue;
                next -= 1;
                set.points.push_back(c->set.points[i]);
                set.normals.push_back(c->set.normals[i]);
            }
        }
        return set;
    }

    /// Two neighbours and what it costs to merge them, or cost before one of them grew.
    struct Pair {
        double cost;
        int a, b, version_a, version_b;
        bool is_estimate;
        Primitive primitive;
        bool operator>(const Pair& other) const {
            return std::tie(cost, a, b) > std::tie(other.cost, other.a, other.b);
        }
    };

    /// What is known of two neighbours: the last cost, infinite when nothing fitted both, and their area then.
    struct Trial {
        double cost = 0, area = 0;
    };

    /// Merges what costs least first. A pair costs more when one of the two has grown, so that it is fitted again only
    /// when its old cost comes first; what nothing fitted is tried again when it is a good deal larger.
    void merge_all() {
        constexpr double much_larger = 1.5;
        constexpr double never = std::numeric_limits<double>::infinity();
        std::priority_queue<Pair, std::vector<Pair>, std::greater<>> queue;
        std::map<std::pair<int, int>, Trial> trials;
        const auto area_of = [&](int a, int b) { return clusters_[at(a)].area + clusters_[at(b)].area; };
        const auto push = [&](double cost, int a, int b, bool is_estimate, const Primitive& primitive) {
            queue.push({cost, a, b, clusters_[at(a)].version, clusters_[at(b)].version, is_estimate, primitive});
        };
        const auto consider = [&](int a, int b) {
            if (a > b) std::swap(a, b);
            const Cluster &x = clusters_[at(a)], &y = clusters_[at(b)];
            Trial& trial = trials[{a, b}] = {never, x.area + y.area};
            if (is_crease(x.borders.at(b))) return;
            const PointSet set = together(x, y);
            const Primitive primitive = fit(set, x.area + y.area);
            if (primitive.kind == SurfaceKind::freeform) return;
            // A small piece must not hide behind a large one that fits.
            const double most = 2 * tolerance(primitive, std::sqrt(x.area + y.area), surface_.noise);
            if (residual_of(x.set, primitive) > most || residual_of(y.set, primitive) > most) return;
            trial.cost = primitive.residual * primitive.residual * (x.area + y.area);
            push(trial.cost, a, b, false, primitive);
        };
        const auto known = [&](int a, int b) {
            const auto found = trials.find(std::minmax(a, b));
            return found != trials.end() ? found->second : Trial{never, 0};
        };
        for (std::size_t c = 0; c < clusters_.size(); ++c)
            for (const auto& [other, border] : clusters_[c].borders)
                if (at(other) > c) consider(static_cast<int>(c), other);
        const auto try_again = [&] {  // what nothing fitted, and has grown since
            for (std::size_t c = 0; c < clusters_.size(); ++c)
                for (const auto& [other, border] : clusters_[c].borders)
                    if (at(other) > c && known(static_cast<int>(c), other).area < area_of(static_cast<int>(c), other))
                        consider(static_cast<int>(c), other);
            return !queue.empty();
        };
        while (!queue.empty() || try_again()) {
            const Pair pair = queue.top();
            queue.pop();
            Cluster &a = clusters_[at(pair.a)], &b = clusters_[at(pair.b)];
            if (!a.is_alive || !b.is_alive || a.version != pair.version_a || b.version != pair.version_b) continue;
            if (pair.is_estimate) {
                consider(pair.a, pair.b);
                continue;
            }
            PointSet set = together(a, b);
            join(pair.a, pair.b);
            a.set = std::move(set);
            a.primitive = pair.primitive;
            for (const auto& [other, border] : a.borders) {
                const Trial own = known(pair.a, other), others = known(pair.b, other);
                const Trial last{std::min(own.cost, others.cost), std::max(own.area, others.area)};
                trials[std::minmax(pair.a, other)] = last;
                if (last.cost < never)
                    push(last.cost / 2, std::min(pair.a, other), std::max(pair.a, other), true, {});
                else if (area_of(pair.a, other) > much_larger * last.area)
                    consider(pair.a, other);
            }
        }
    }

    const PatchSurface& surface_;
    std::span<const std::int32_t> triangles_;
    std::vector<int> owner_;
    std::vector<Cluster> clusters_;
    double total_ = 0;
};

}  // namespace

std::vector<Patch> find_patches(const PatchSurface& surface, std::span<const std::int32_t> triangles) {
    return Segmenter(surface, triangles).run();
}

Outline outline_of(const PatchSurface& surface, const Patch& patch) {
    if (patch.primitive.kind != SurfaceKind::flat) return {};
    const Vec3 x = patch.primitive.axis.unitOrthogonal(), y = patch.primitive.axis.cross(x);
    std::set<std::array<std::int32_t, 2>> rims;
    std::vector<Planar> points;
    for (const std::int32_t t : patch.triangles) {
        const auto& c = surface.mesh.triangles[static_cast<std::size_t>(t)];
        for (std::size_t e = 0; e < 3; ++e) {
            const Vec3& p = surface.mesh.positions[static_cast<std::size_t>(c[e])];
            points.push_back({p.dot(x), p.dot(y)});
            if (rims.erase({c[(e + 1) % 3], c[e]}) == 0) rims.insert({c[e], c[(e + 1) % 3]});
        }
    }
    // Area inside of each rim by the shoelace formula, rims told apart by their vertices; the largest is the outline.
    std::map<std::int32_t, std::int32_t> parent;
    const auto root = [&](std::int32_t v) {
        while (parent.at(v) != v) v = parent[v] = parent.at(parent.at(v));
        return v;
    };
    for (const auto& rim : rims)
        for (const std::int32_t v : rim) parent.emplace(v, v);
    for (const auto& [a, b] : rims) parent[root(a)] = root(b);
    std::map<std::int32_t, double> areas;
    for (const auto& [a, b] : rims) {
        const Vec3 &p = surface.mesh.positions[static_cast<std::size_t>(a)],
                   &q = surface.mesh.positions[static_cast<std::size_t>(b)];
        areas[root(a)] += (p.dot(x) * q.dot(y) - p.dot(y) * q.dot(x)) / 2;
    }
    double area = 0;
    for (const auto& [rim, inside] : areas) area = std::max(area, std::abs(inside));
    std::vector<Planar> hull;
    convex_hull(points, hull);
    const double size = std::sqrt(std::max(patch.area, 1e-300));
    Outline outline;
    const Rectangle box = smallest_rectangle(hull, size);
    double widest = 0;
    for (const Planar& p : hull)
        for (const Planar& q : hull) widest = std::max(widest, std::hypot(p.x - q.x, p.y - q.y));
    if (box.area > 0 && std::isfinite(box.area)) outline.rectangle = std::min(1.0, area / box.area);
    if (widest > 0) outline.disc = std::min(1.0, area / (std::numbers::pi / 4 * widest * widest));
    return outline;
}

}  // namespace partonomy
