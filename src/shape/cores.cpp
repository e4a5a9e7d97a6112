#include "shape/cores.h"

#include <Eigen/Geometry>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

namespace partonomy {

namespace {

/// Sets of triangles that grow together; the lowest number stands for its set, so the order of joining does not matter.
class Sets {
public:
    explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0); }
    std::int32_t find(std::int32_t i) {
        while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
        return i;
    }
    void join(std::int32_t a, std::int32_t b) {
        a = find(a), b = find(b);
        if (a != b) parent_[std::max(a, b)] = std::min(a, b);
    }

private:
    std::vector<std::int32_t> parent_;
};

const double wall_cosine = std::cos(30 * std::numbers::pi / 180);
const double crease_cosine = std::cos(30 * std::numbers::pi / 180);
const double square_cosine = std::cos(35 * std::numbers::pi / 180);
const double turn_cosine = std::cos(38 * std::numbers::pi / 180);
constexpr double thickness_step = 1.25;
constexpr double least_share = 1e-3;  // of the whole surface: less is no part

/// What rays from the middle between two walls, along them, tell about a part: how narrow and how long it is there.
struct Chords {
    double narrow = 0;  ///< shortest way across, wall to wall
    double wide = 0;    ///< longest way
    Vec3 along = Vec3::Zero();
};

/// Only ways that meet both walls squarely tell a width: near a corner of a board the diagonal is short and means nothing.
Chords chords_around(const Surface& s, std::int32_t t) {
    const Vec3 n = s.normals[t];
    const Vec3 middle = s.geometry.barycentres[t] - n * (s.thickness.distances[t] / 2);
    const Vec3 x = n.unitOrthogonal(), y = n.cross(x);
    constexpr int lines = 8;
    Chords chords;
    double square = s.size, any = s.size;
    for (int k = 0; k < lines; ++k) {
        const double angle = std::numbers::pi * k / lines;
        const Vec3 d = std::cos(angle) * x + std::sin(angle) * y;
        const WallHit ahead = s.scene->exit_wall(middle, d), behind = s.scene->exit_wall(middle, -d);
        const double length = std::min<double>(ahead.distance, s.size) + std::min<double>(behind.distance, s.size);
        any = std::min(any, length);
        if (ahead.triangle >= 0 && behind.triangle >= 0 && s.normals[ahead.triangle].dot(d) > square_cosine &&
            -s.normals[behind.triangle].dot(d) > square_cosine)
            square = std::min(square, length);
        if (length > chords.wide) chords.wide = length, chords.along = d;
    }
    chords.narrow = square < s.size ? square : any;
    return chords;
}

/// A patch of a component around one sampled triangle, both walls.
struct Cell {
    double ratio = 0;  ///< width / thickness
    double reach = 0;  ///< length / thickness
    Vec3 along = Vec3::Zero();
    double area = 0;
    Solidity kind = Solidity::unknown;
    std::vector<std::int32_t> neighbours;
};

Solidity kind_of(double ratio, double reach) {
    if (ratio < 0.7) return Solidity::unknown;
    if (ratio > 2) return Solidity::board;
    return reach > 2 ? Solidity::stick : Solidity::cube;
}

/// Cuts one component where it changes between board and stick or where a stick turns a corner.
class Divider {
public:
    Divider(const Surface& surface, std::vector<std::int32_t>& cell_of) : s_(surface), cell_of_(cell_of) {}

    void divide(const Core& component, std::vector<Core>& out) {
        sample(component);
        spread(component);
        smooth();
        Sets sets(cells_.size());
        for (std::size_t a = 0; a < cells_.size(); ++a)
            for (const std::int32_t b : cells_[a].neighbours)
                if (same_part(cells_[a], cells_[b])) sets.join(static_cast<std::int32_t>(a), b);
        absorb_small(sets, component);
        emit(component, sets, out);
        for (const std::int32_t i : component.triangles) cell_of_[i] = -1;
    }

private:
    void sample(const Core& component) {
        cells_.clear();
        seeds_.clear();
        const double wanted = std::clamp(component.area / (1.0 * component.thickness * component.thickness), 16.0, 220.0);
        const double step = component.area / wanted;
        double next = step / 2, sum = 0;
        for (const std::int32_t i : component.triangles) {
            sum += s_.geometry.areas[i];
            if (sum < next) continue;
            while (next <= sum) next += step;
            const Chords c = chords_around(s_, i);
            const double t = s_.thickness.distances[i];
            cells_.push_back({c.narrow / t, c.wide / t, c.along, 0, Solidity::unknown, {}});
            seeds_.push_back(i);
        }
    }

    void spread(const Core& component) {
        for (const std::int32_t i : component.triangles) cell_of_[i] = -2;
        std::vector<std::int32_t> queue;
        for (std::size_t k = 0; k < seeds_.size(); ++k) {
            cell_of_[seeds_[k]] = static_cast<std::int32_t>(k);
            queue.push_back(seeds_[k]);
            const std::int32_t o = s_.thickness.opposites[seeds_[k]];
            if (o >= 0 && cell_of_[o] == -2) {
                cell_of_[o] = static_cast<std::int32_t>(k);
                queue.push_back(o);
            }
        }
        const auto visit = [&](std::int32_t from, std::int32_t to) {
            if (to < 0 || cell_of_[to] != -2) return;
            cell_of_[to] = cell_of_[from];
            queue.push_back(to);
        };
        for (std::size_t at = 0; at < queue.size(); ++at)
            for (const std::int32_t j : s_.adjacency.neighbours[queue[at]]) visit(queue[at], j);
        for (std::size_t at = 0; at < queue.size(); ++at) visit(queue[at], s_.thickness.opposites[queue[at]]);
        for (const std::int32_t i : component.triangles) {
            if (cell_of_[i] < 0) {
                const std::int32_t o = s_.thickness.opposites[i];
                cell_of_[i] = o >= 0 && cell_of_[o] >= 0 ? cell_of_[o] : 0;
            }
        }
        std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
        const auto meet = [&](std::int32_t i, std::int32_t j) {
            if (j >= 0 && cell_of_[j] >= 0 && cell_of_[i] != cell_of_[j]) {
                pairs.emplace_back(cell_of_[i], cell_of_[j]);
                pairs.emplace_back(cell_of_[j], cell_of_[i]);
            }
        };
        for (const std::int32_t i : component.triangles) {
            cells_[cell_of_[i]].area += s_.geometry.areas[i];
            for (const std::int32_t j : s_.adjacency.neighbours[i]) meet(i, j);
            meet(i, s_.thickness.opposites[i]);
        }
        std::sort(pairs.begin(), pairs.end());
        pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        for (const auto& [a, b] : pairs) cells_[a].neighbours.push_back(b);
    }

    /// A cell takes the median width of its neighbourhood, and its main direction.
    void smooth() {
        std::vector<Cell> smoothed = cells_;
        for (std::size_t a = 0; a < cells_.size(); ++a) {
            std::vector<double> ratios{cells_[a].ratio}, reaches{cells_[a].reach};
            Eigen::Matrix3d spread = cells_[a].along * cells_[a].along.transpose();
            for (const std::int32_t b : cells_[a].neighbours) {
                ratios.push_back(cells_[b].ratio);
                reaches.push_back(cells_[b].reach);
                spread += cells_[b].along * cells_[b].along.transpose();
            }
            std::sort(ratios.begin(), ratios.end());
            std::sort(reaches.begin(), reaches.end());
            smoothed[a].ratio = ratios[ratios.size() / 2];
            smoothed[a].reach = reaches[reaches.size() / 2];
            smoothed[a].along = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
            smoothed[a].kind = kind_of(smoothed[a].ratio, smoothed[a].reach);
        }
        cells_ = std::move(smoothed);
    }

    static bool same_part(const Cell& a, const Cell& b) {
        if (a.kind != b.kind) return false;
        return a.kind != Solidity::stick || std::abs(a.along.dot(b.along)) > turn_cosine;
    }

    /// Pieces too small to be a part join the neighbour with the longest common border.
    void absorb_small(Sets& sets, const Core& component) {
        for (int round = 0; round < 4; ++round) {
            std::vector<double> area(cells_.size());
            for (std::size_t a = 0; a < cells_.size(); ++a) area[sets.find(static_cast<std::int32_t>(a))] += cells_[a].area;
            std::vector<std::int32_t> into(cells_.size(), -1);
            std::vector<std::vector<std::pair<std::int32_t, int>>> borders(cells_.size());
            for (std::size_t a = 0; a < cells_.size(); ++a) {
                const std::int32_t own = sets.find(static_cast<std::int32_t>(a));
                if (area[own] >= least_area(component)) continue;
                for (const std::int32_t b : cells_[a].neighbours) {
                    const std::int32_t other = sets.find(b);
                    if (other == own) continue;
                    auto at = std::find_if(borders[own].begin(), borders[own].end(),
                                           [&](const auto& entry) { return entry.first == other; });
                    if (at == borders[own].end()) at = borders[own].insert(at, {other, 0});
                    ++at->second;
                }
            }
            bool changed = false;
            for (std::size_t a = 0; a < cells_.size(); ++a) {
                if (borders[a].empty()) continue;
                const auto best = std::max_element(borders[a].begin(), borders[a].end(), [&](const auto& x, const auto& y) {
                    return x.second != y.second ? x.second < y.second : area[x.first] < area[y.first];
                });
                sets.join(static_cast<std::int32_t>(a), best->first);
                changed = true;
            }
            if (!changed) break;
        }
    }

    [[nodiscard]] double least_area(const Core& component) const {
        return std::min(0.2 * component.area, 6 * component.thickness * component.thickness);
    }

    void emit(const Core& component, Sets& sets, std::vector<Core>& out) const {
        std::vector<std::int32_t> number(cells_.size(), -1);
        const std::size_t first = out.size();
        std::vector<std::array<double, 4>> votes;
        std::vector<Eigen::Matrix3d> spreads;
        for (std::size_t a = 0; a < cells_.size(); ++a) {
            const std::int32_t root = sets.find(static_cast<std::int32_t>(a));
            if (number[root] < 0) {
                number[root] = static_cast<std::int32_t>(votes.size());
                out.emplace_back();
                votes.push_back({});
                spreads.emplace_back(Eigen::Matrix3d::Zero());
            }
            votes[number[root]][static_cast<std::size_t>(cells_[a].kind)] += cells_[a].area;
            spreads[number[root]] += cells_[a].area * cells_[a].along * cells_[a].along.transpose();
        }
        for (std::size_t k = 0; k < votes.size(); ++k) {
            const auto best = std::max_element(votes[k].begin(), votes[k].end()) - votes[k].begin();
            out[first + k].kind = static_cast<Solidity>(best);
            out[first + k].axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spreads[k]).eigenvectors().col(2);
        }
        for (const std::int32_t i : component.triangles) {
            Core& core = out[first + number[sets.find(cell_of_[i])]];
            core.triangles.push_back(i);
            core.area += s_.geometry.areas[i];
        }
    }

    const Surface& s_;
    std::vector<std::int32_t>& cell_of_;
    std::vector<Cell> cells_;
    std::vector<std::int32_t> seeds_;
};

double median_thickness(const Surface& s, const std::vector<std::int32_t>& triangles) {
    std::vector<float> all;
    all.reserve(triangles.size());
    for (const std::int32_t i : triangles) all.push_back(s.thickness.distances[i]);
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return *middle;
}

}  // namespace

Cores find_cores(const Surface& s) {
    const std::size_t count = s.count();
    const auto& t = s.thickness.distances;
    const auto& opposite = s.thickness.opposites;
    std::vector<char> wall(count);
    for (std::size_t i = 0; i < count; ++i)
        wall[i] = opposite[i] >= 0 && -s.normals[i].dot(s.normals[opposite[i]]) > wall_cosine;
    Sets sets(count);
    const auto alike = [&](std::int32_t i, std::int32_t j) {
        return wall[i] && wall[j] && t[i] < thickness_step * t[j] && t[j] < thickness_step * t[i];
    };
    for (std::size_t i = 0; i < count; ++i) {
        const auto self = static_cast<std::int32_t>(i);
        if (!wall[i]) continue;
        for (const std::int32_t j : s.adjacency.neighbours[i]) {
            if (j < self || !alike(self, j)) continue;
            const bool concave = (s.geometry.barycentres[j] - s.geometry.barycentres[i]).dot(s.normals[i]) > 0;
            if (concave && s.normals[i].dot(s.normals[j]) < crease_cosine) continue;
            sets.join(self, j);
        }
        if (alike(self, opposite[i])) sets.join(self, opposite[i]);
    }
    std::vector<std::int32_t> number(count, -1);
    std::vector<Core> cores;
    for (std::size_t i = 0; i < count; ++i) {
        if (!wall[i]) continue;
        const std::int32_t root = sets.find(static_cast<std::int32_t>(i));
        if (number[root] < 0) {
            number[root] = static_cast<std::int32_t>(cores.size());
            cores.emplace_back();
        }
        Core& core = cores[number[root]];
        core.triangles.push_back(static_cast<std::int32_t>(i));
        core.area += s.geometry.areas[i];
    }
    std::vector<Core> components = std::move(cores);
    cores.clear();
    std::vector<std::int32_t> cell_of(count, -1);
    Divider divider(s, cell_of);
    const double total = std::accumulate(s.geometry.areas.begin(), s.geometry.areas.end(), 0.0);
    for (Core& component : components) {
        component.thickness = median_thickness(s, component.triangles);
        if (component.area < least_share * total) continue;
        if (component.area < component.thickness * component.thickness || component.triangles.size() < 4) continue;
        divider.divide(component, cores);
    }
    for (Core& core : cores) {
        core.thickness = median_thickness(s, core.triangles);
        if (core.area < core.thickness * core.thickness || core.area < least_share * total) core.kind = Solidity::unknown;
    }
    std::erase_if(cores, [](const Core& core) { return core.kind == Solidity::unknown; });
    std::stable_sort(cores.begin(), cores.end(), [](const Core& a, const Core& b) { return a.area > b.area; });
    Cores result{std::move(cores), std::vector<std::int32_t>(count, -1)};
    for (std::size_t k = 0; k < result.cores.size(); ++k)
        for (const std::int32_t i : result.cores[k].triangles) result.core_of[i] = static_cast<std::int32_t>(k);
    return result;
}

}  // namespace partonomy
