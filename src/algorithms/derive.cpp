/* `find all` where no algorithm of its own exists: candidates scored by `is a` (paper §3.4.2).
 *
 * The candidates are nodes of a forest. Its middle are the parts of find_parts. Above them, neighbouring parts are
 * merged pair by pair, the most alike first: of like thickness, facing the same way, and without a concave crease
 * between them; this mends what was cut too fine. Below them, when the question is about surfaces, are the patches of
 * each part. A node is worth its area times its score times its fit when the score is 0.5 or more, and nothing
 * otherwise; from the leaves upwards, a node is chosen when it is worth at least as much as what was chosen below it.
 * So a seat in two halves is found as one, a corner of two boards is not (its box fits badly), and the wall of a hole
 * is found inside of a plate.
 *
 * What we left: scoring all connected unions of patches. They are too many, and the best-scoring ones are slivers. */

#include "algorithms/derive.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <numeric>

#include "algorithms/form.h"
#include "shape/membership.h"
#include "shape/part_box.h"

namespace partonomy {
namespace {

constexpr double too_different = 1;        // parts are not merged beyond
constexpr std::size_t most_together = 16;  // parts: so that merging a long row of them stays cheap
constexpr std::size_t least_curved = 8;    // triangles: fewer are a fold, no cylinder
constexpr std::size_t least_noisy = 24;    // triangles: under noise fewer are a fold, too, and no plane, either
constexpr double hardly_less = 0.999;
constexpr Trapezoid near_surface{0, 0, 1, 4};  // distance over tolerance

struct Node {
    PartRegion part;
    std::vector<std::size_t> of;
    std::vector<std::size_t> below;
    double area = 0;
    bool is_part = false;
};

class Forest {
public:
    Forest(const Object& object, std::span<const PartRegion* const> parts)
        : object_(object), surface_(calm_surface(object)) {
        for (std::size_t i = 0; i < parts.size(); ++i) {
            nodes_.push_back({*parts[i], {i}, {}, area_of(*parts[i]), true});
            roots_.push_back(i);
        }
    }

    /// Merges neighbouring parts, the most alike first.
    void merge_parts() {
        const std::size_t count = nodes_.size();
        owner_.assign(object_.mesh.triangles.size(), -1);
        for (std::size_t i = 0; i < count; ++i)
            for (const std::int32_t t : nodes_[i].part.region.triangles)
                owner_[static_cast<std::size_t>(t)] = static_cast<std::int32_t>(i);
        std::map<std::pair<std::int32_t, std::int32_t>, std::pair<double, double>> borders;  // length, concave angle
        for (std::size_t t = 0; t < owner_.size(); ++t)
            for (std::size_t e = 0; e < 3; ++e) {
                const std::int32_t n = surface_.adjacency.neighbours[t][e];
                if (n < 0 || owner_[t] < 0 || owner_[static_cast<std::size_t>(n)] <= owner_[t]) continue;
                const auto& corners = surface_.mesh.triangles[t];
                const Vec3& a = surface_.mesh.positions[static_cast<std::size_t>(corners[e])];
                const Vec3& b = surface_.mesh.positions[static_cast<std::size_t>(corners[(e + 1) % 3])];
                const Vec3 &n0 = surface_.geometry.normals[t],
                           &n1 = surface_.geometry.normals[static_cast<std::size_t>(n)];
                const double turn = std::atan2(n0.cross(n1).dot((b - a).normalized()), n0.dot(n1));
                auto& [length, angle] = borders[{owner_[t], owner_[static_cast<std::size_t>(n)]}];
                length += (b - a).norm();
                angle += (b - a).norm() * std::max(0.0, -turn);
            }
        std::vector<std::pair<double, std::pair<std::int32_t, std::int32_t>>> pairs;
        for (const auto& [pair, border] : borders) {
            const double concave = border.first > 0 ? border.second / border.first / (std::numbers::pi / 2) : 0;
            const double unlike = concave + difference(nodes_[static_cast<std::size_t>(pair.first)].part.box,
                                                       nodes_[static_cast<std::size_t>(pair.second)].part.box);
            if (unlike < too_different) pairs.emplace_back(unlike, pair);
        }
        std::ranges::sort(pairs);
        std::vector<std::size_t> root(count);
        std::iota(root.begin(), root.end(), 0U);
        for (const auto& [unlike, pair] : pairs) {
            const std::size_t a = root[static_cast<std::size_t>(pair.first)],
                              b = root[static_cast<std::size_t>(pair.second)];
            if (a == b || nodes_[a].of.size() + nodes_[b].of.size() > most_together) continue;
            Node node;
            node.below = {a, b};
            std::ranges::merge(nodes_[a].of, nodes_[b].of, std::back_inserter(node.of));
            std::vector<std::int32_t> triangles;
            std::ranges::merge(nodes_[a].part.region.triangles, nodes_[b].part.region.triangles,
                               std::back_inserter(triangles));
            node.part = boxed(std::move(triangles));
            node.area = nodes_[a].area + nodes_[b].area;
            for (const std::size_t i : node.of) root[i] = nodes_.size();
            std::erase(roots_, a);
            std::erase(roots_, b);
            roots_.push_back(nodes_.size());
            nodes_.push_back(std::move(node));
        }
    }

    /// Patches below each part that has more than one.
    void cut_parts() {
        const std::size_t count = nodes_.size();
        const PatchSurface surface{surface_.mesh, surface_.geometry, surface_.adjacency, surface_.noise};
        for (std::size_t i = 0; i < count; ++i) {
            if (!nodes_[i].is_part) continue;
            const std::vector<Patch> patches = find_patches(surface, nodes_[i].part.region.triangles);
            double fit = 0;
            for (const Patch& patch : patches) {
                if (patches.size() > 1 && surface.noise > 0 && patch.triangles.size() < least_noisy) continue;
                Node node;
                node.of = {i};
                node.part = boxed(patch.triangles);
                node.part.fit = 0;
                const double most = tolerance(patch.primitive, std::sqrt(patch.area), surface.noise);
                for (std::size_t k = 0; k < patch.triangles.size(); ++k) {
                    const auto t = static_cast<std::size_t>(patch.triangles[k]);
                    const double way = most > 0 ? patch.primitive.distance(surface_.geometry.barycentres[t]) / most : 0;
                    const double score = std::max(0.001, near_surface(way));
                    node.part.region.memberships[k] = static_cast<float>(score);
                    node.part.fit += score * surface_.geometry.areas[t] / patch.area;
                }
                node.part.fit = std::min(1.0, node.part.fit);
                node.area = area_of(node.part);
                fit += node.part.fit * node.area;
                if (patches.size() == 1) break;
                if (patch.primitive.kind != SurfaceKind::flat && patch.triangles.size() < least_curved) continue;
                nodes_[i].below.push_back(nodes_.size());
                nodes_.push_back(std::move(node));
            }
            if (nodes_[i].area > 0) surface_fits_[i] = fit / nodes_[i].area;
        }
    }

    DerivedRegions choose(const std::function<std::optional<double>(const RegionMeasurements&)>& is_a) {
        DerivedRegions result;
        std::vector<std::size_t> chosen;
        for (const std::size_t root : roots_) {
            const auto [worth, nodes] = best_below(root, is_a);
            chosen.insert(chosen.end(), nodes.begin(), nodes.end());
        }
        std::ranges::sort(chosen, {}, [&](std::size_t i) { return nodes_[i].part.region.triangles.front(); });
        std::map<std::size_t, std::vector<std::int32_t>> taken;  // part -> triangles, where not all of it
        for (const std::size_t i : chosen) {
            Node& node = nodes_[i];
            if (!node.is_part && node.of.size() == 1) {
                auto& triangles = taken[node.of.front()];
                triangles.insert(triangles.end(), node.part.region.triangles.begin(), node.part.region.triangles.end());
            }
            result.found.push_back({node.part, scores_.at(i), node.of, node.is_part});
        }
        for (auto& [part, triangles] : taken) {
            std::ranges::sort(triangles);
            std::vector<std::int32_t> rest;
            std::ranges::set_difference(nodes_[part].part.region.triangles, triangles, std::back_inserter(rest));
            for (std::vector<std::int32_t>& piece : connected_pieces(rest)) result.rests.push_back(boxed(piece));
        }
        return result;
    }

private:
    [[nodiscard]] double area_of(const PartRegion& part) const {
        double area = 0;
        for (const std::int32_t t : part.region.triangles) area += object_.geometry.areas[static_cast<std::size_t>(t)];
        return area;
    }

    [[nodiscard]] PartRegion boxed(std::vector<std::int32_t> triangles) const {
        PartBox box = measure_part(object_.mesh, object_.geometry, triangles, object_.is_noisy);
        return {{std::move(triangles), std::move(box.memberships)}, box.box, box.fit};
    }

    /// 0 for boxes of one thickness with parallel walls.
    static double difference(const OrientedBox& a, const OrientedBox& b) {
        const double thicker = std::max(a.lengths[2], b.lengths[2]), thinner = std::min(a.lengths[2], b.lengths[2]);
        if (!(thicker > 0)) return 1 - std::abs(a.axes.col(2).dot(b.axes.col(2)));
        if (!(thinner > 0)) return std::numeric_limits<double>::infinity();
        double parallel = 0;  // sticks and blocks have more than one pair of walls
        for (int i = 0; i < 3; ++i)
            if (a.lengths[i] < 1.25 * a.lengths[2])
                for (int j = 0; j < 3; ++j)
                    if (b.lengths[j] < 1.25 * b.lengths[2])
                        parallel = std::max(parallel, std::abs(a.axes.col(i).dot(b.axes.col(j))));
        return std::log2(thicker / thinner) + 1 - parallel;
    }

    /// The best choice at or below a node, and what it is worth.
    std::pair<double, std::vector<std::size_t>> best_below(
        std::size_t i, const std::function<std::optional<double>(const RegionMeasurements&)>& is_a) {
        double worth = 0;
        std::vector<std::size_t> chosen;
        for (const std::size_t child : nodes_[i].below) {
            const auto [more, nodes] = best_below(child, is_a);
            worth += more;
            chosen.insert(chosen.end(), nodes.begin(), nodes.end());
        }
        const double score = is_a(measure_region(object_, nodes_[i].part)).value_or(0);
        const auto surface_fit = surface_fits_.find(i);
        const double fit = surface_fit != surface_fits_.end() ? surface_fit->second : nodes_[i].part.fit;
        const double own = score >= 0.5 ? nodes_[i].area * score * fit : 0;
        if (own > 0 && own >= hardly_less * worth) {
            scores_[i] = score;
            return {own, {i}};
        }
        return {worth, chosen};
    }

    [[nodiscard]] std::vector<std::vector<std::int32_t>> connected_pieces(const std::vector<std::int32_t>& rest) const {
        std::vector<std::vector<std::int32_t>> pieces;
        std::vector<char> is_free(rest.size(), 1);
        const auto place = [&](std::int32_t t) {
            const auto found = std::ranges::lower_bound(rest, t);
            return found != rest.end() && *found == t ? found - rest.begin() : -1;
        };
        for (std::size_t i = 0; i < rest.size(); ++i) {
            if (!is_free[i]) continue;
            std::vector<std::int32_t> piece{rest[i]};
            is_free[i] = 0;
            for (std::size_t k = 0; k < piece.size(); ++k)
                for (const std::int32_t n : surface_.adjacency.neighbours[static_cast<std::size_t>(piece[k])]) {
                    const auto at = n < 0 ? -1 : place(n);
                    if (at < 0 || !is_free[static_cast<std::size_t>(at)]) continue;
                    is_free[static_cast<std::size_t>(at)] = 0;
                    piece.push_back(n);
                }
            std::ranges::sort(piece);
            pieces.push_back(std::move(piece));
        }
        return pieces;
    }

    const Object& object_;
    const CalmSurface& surface_;
    std::vector<Node> nodes_;
    std::vector<std::size_t> roots_;
    std::vector<std::int32_t> owner_;
    std::map<std::size_t, double> surface_fits_;  ///< of parts that were cut into patches: mean fit of these
    std::map<std::size_t, double> scores_;
};

}  // namespace

DerivedRegions derive_find_all(const Object& object, std::span<const PartRegion* const> parts, Grain grain,
                               const std::function<std::optional<double>(const RegionMeasurements&)>& is_a) {
    Forest forest(object, parts);
    forest.merge_parts();
    if (grain == Grain::patches) forest.cut_parts();
    return forest.choose(is_a);
}

}  // namespace partonomy
