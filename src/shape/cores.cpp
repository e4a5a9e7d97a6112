// The sure part of each part.
//
// Idea: two triangles belong together when they are walls of the same thickness side by side, or opposite each other. A
// triangle is a wall when its inward ray meets a triangle that looks the other way. Neighbouring walls of alike
// thickness are joined unless a concave crease runs between them, and each is joined with its opposite; connected sets
// are found by union-find, so no seed and no order is involved. At a joint of two parts the ray runs into the other
// part, so the thickness jumps and the set ends by itself. What remains is taken apart in a second way:
//
// A set that is a plain slab or bar is a core as it is (plain_pieces.cpp).
//
// Any other set may still be a comb: back posts as thick as the backrest they carry. Sampled triangles therefore look
// around from the middle between their two walls, along the walls: a stick is as narrow as thick, a board wider than
// twice its thickness, and where it is far narrower than thick the walls are the two ends of something thin (the rim of
// a seat faces the other rim across the whole seat) and no core. The samples' surroundings (cells) vote with their
// neighbours, and a set is cut between board and stick and where sticks of different directions meet.
//
// Sticks with three sides have no parallel walls; a second, more generous search among what is left finds them. Their
// thickness falls to nothing towards each edge, so there the samples look around from the middle of the stick, and the
// core is the whole stick. (Looking around from halfway between two walls, as in the first search, found fragments of
// short posts that changed with every turn of the mesh.)
//
// Departures from paper §6.4: no seeds by ascending thickness and no planes that are refitted, since neither bent
// boards nor round sticks have planes; tried first were region growing from seeds (depends on the order of faces) and
// thickness bands without looking around (glues posts to backrests). Cost: O(n) and at most 1,000 x 16 rays beyond the
// one per triangle.

#include "shape/cores.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <numbers>
#include <numeric>

#include "base/ranges.h"
#include "shape/plain_pieces.h"
#include "shape/sets.h"

namespace partonomy {

namespace {

const double parallel_cosine = std::cos(30 * std::numbers::pi / 180);
const double slanted_cosine = std::cos(65 * std::numbers::pi / 180);
const double crease_cosine = std::cos(30 * std::numbers::pi / 180);
const double square_cosine = std::cos(35 * std::numbers::pi / 180);
const double turn_cosine = std::cos(38 * std::numbers::pi / 180);
constexpr double narrowest = 0.7, narrowest_slanted = 0.4;  // width / thickness of a stick, at least
constexpr double cell_area = 0.2;                           // of thickness squared: as fine as cells get
constexpr double least_agreement = 0.75;                    // of directions around a cell, unless sticks meet there
constexpr double fewest_cells = 24;
constexpr double triangles_a_cell = 25;  // on average, but at least and at most so many cells in all:
constexpr double least_cells = 100, most_cells = 1000;
constexpr double odd_thickness = 1.8;
constexpr double narrowest_end = 0.5, widest_end = 1.75, least_length = 1.5;  // of a narrow board, in widths
constexpr double least_hidden = 0.15;            // of a narrow board from its wide one, share of the lines of sight
constexpr double shoulders = 1.3;                // of the end of a narrow board: as wide is the wide one there
constexpr double gap = 0.3, most_between = 0.1;  // of logarithms of widths; share of the smaller side within the gap
constexpr double least_narrow = 0.05;            // of a component's boards
constexpr double least_share = 1e-3;             // of the whole surface: less is no part

/// What rays from the middle between two walls, along them, tell about a part: how narrow and how long it is there.
struct Chords {
    double narrow = 0;  ///< shortest way across, wall to wall
    double wide = 0;    ///< longest way
    Vec3 along = Vec3::Zero();
};

/// Only ways that meet both walls squarely tell a width: near a corner of a board the diagonal is short and means
/// nothing.
Chords chords_around(const Surface& s, std::int32_t t) {
    const Vec3 n = s.geometry.normals[t];
    const Vec3 middle = s.geometry.barycentres[t] - n * (s.thickness.distances[t] / 2);
    const Vec3 x = n.unitOrthogonal(), y = n.cross(x);
    constexpr std::size_t lines = 8;
    Chords chords;
    double square = s.size, any = s.size;
    std::array<InnerRay, 2 * lines> rays;
    std::array<WallHit, 2 * lines> hits;
    for (std::size_t k = 0; k < lines; ++k) {
        const double angle = std::numbers::pi * static_cast<double>(k) / lines;
        const Vec3 d = std::cos(angle) * x + std::sin(angle) * y;
        rays[k] = {middle, d, -1, t};
        rays[k + lines] = {middle, -d, -1, t};
    }
    s.scene->exit_walls(rays, hits);
    for (std::size_t k = 0; k < lines; ++k) {
        const Vec3& d = rays[k].direction;
        const WallHit &ahead = hits[k], &behind = hits[k + lines];
        const double length = std::min<double>(ahead.distance, s.size) + std::min<double>(behind.distance, s.size);
        any = std::min(any, length);
        if (ahead.triangle >= 0 && behind.triangle >= 0 && s.geometry.normals[ahead.triangle].dot(d) > square_cosine &&
            -s.geometry.normals[behind.triangle].dot(d) > square_cosine)
            square = std::min(square, length);
        if (length > chords.wide) chords.wide = length, chords.along = d;
    }
    chords.narrow = square < s.size ? square : any;
    return chords;
}

/// The same, for sticks whose walls are slanted, from the middle of the stick: halfway between two such walls may be
/// near an edge, where everything is narrow. `thickness` becomes the way through the middle.
Chords chords_through_middle(const Surface& s, std::int32_t t, double& thickness) {
    Chords chords = chords_around(s, t);
    const Vec3 n = s.geometry.normals[t], x = chords.along.cross(n);
    Vec3 middle = s.geometry.barycentres[t] - n * (s.thickness.distances[t] / 2);
    const auto centre = [&](const Vec3& d) {
        const double ahead = std::min<double>(s.scene->exit_wall({middle, d, -1, t}).distance, s.size);
        const double behind = std::min<double>(s.scene->exit_wall({middle, -d, -1, t}).distance, s.size);
        middle += d * ((ahead - behind) / 2);
        return ahead + behind;
    };
    for (int round = 0; round < 2; ++round) {
        chords.narrow = centre(x);
        thickness = centre(n);
    }
    return chords;
}

/// A patch of a component around one sampled triangle, both walls.
struct Cell {
    double thickness = 0;
    double ratio = 0;  ///< width / thickness
    double reach = 0;  ///< length / thickness
    Vec3 along = Vec3::Zero();
    double area = 0;
    Solidity kind = Solidity::unknown;
    bool is_junction = false;  ///< around it, sticks run in different directions
    bool is_narrow = false;    ///< a board, on the narrow side of a gap in the widths of its component
    std::vector<std::int32_t> neighbours;
};

Solidity kind_of(double ratio, double reach, double least_ratio) {
    if (ratio < least_ratio) return Solidity::unknown;
    if (ratio > 2) return Solidity::board;
    return reach > 2 ? Solidity::stick : Solidity::cube;
}

double median_thickness(const Surface& s, const std::vector<std::int32_t>& triangles) {
    std::vector<float> all;
    all.reserve(triangles.size());
    for (const std::int32_t i : triangles) all.push_back(s.thickness.distances[i]);
    const auto middle = all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2);
    std::nth_element(all.begin(), middle, all.end());
    return *middle;
}

/// A component and what its sampled triangles, the seeds of its cells, see around them.
struct Sampled {
    Core component;
    std::vector<std::int32_t> seeds;
    std::vector<Cell> cells;
};

/// Triangles spread evenly over the area of a component.
std::vector<std::int32_t> choose_seeds(const Surface& s, const Core& component, double total_area) {
    const double all_cells = std::clamp(static_cast<double>(s.count()) / triangles_a_cell, least_cells, most_cells);
    const double wanted = std::clamp(component.area / (cell_area * component.thickness * component.thickness),
                                     fewest_cells, fewest_cells + all_cells * component.area / total_area);
    const double step = component.area / wanted;
    double next = step / 2, sum = 0;
    std::vector<std::int32_t> seeds;
    for (const std::int32_t i : component.triangles) {
        sum += s.geometry.areas[i];
        if (sum < next) continue;
        while (next <= sum) next += step;
        seeds.push_back(i);
    }
    return seeds;
}

/// Looks around from the seeds of all components; one loop over all of them keeps every thread busy.
void look_around(const Surface& s, std::vector<Sampled>& components, bool slanted) {
    std::vector<std::pair<Sampled*, std::size_t>> places;
    for (Sampled& sampled : components) {
        sampled.cells.resize(sampled.seeds.size());
        for (std::size_t k = 0; k < sampled.seeds.size(); ++k) places.emplace_back(&sampled, k);
    }
    constexpr std::size_t seeds_a_piece = 8;
    for_each_range(
        places.size(), s.threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const auto& [sampled, k] = places[i];
                const std::int32_t seed = sampled->seeds[k];
                double t = s.thickness.distances[seed];
                const Chords c = slanted ? chords_through_middle(s, seed, t) : chords_around(s, seed);
                sampled->cells[k] = {t, c.narrow / t, c.wide / t, c.along, 0, Solidity::unknown, false, false, {}};
            }
        },
        seeds_a_piece);
}

/// Which component each triangle belongs to, or -1, and in it which cell. Components can be divided side by side: each
/// looks at the cells of its own triangles only.
struct Division {
    std::vector<std::int32_t> component_of, cell_of;

    Division(const Surface& s, const std::vector<Sampled>& sampled)
        : component_of(s.count(), -1), cell_of(sampled.empty() ? 0 : s.count(), -1) {
        for (std::size_t k = 0; k < sampled.size(); ++k)
            for (const std::int32_t i : sampled[k].component.triangles) component_of[i] = static_cast<std::int32_t>(k);
    }
};

/// Cuts one component where it changes between board and stick or where a stick turns a corner.
class Divider {
public:
    Divider(const Surface& surface, bool slanted, Division& division, std::size_t component)
        : s_(surface),
          slanted_(slanted),
          component_of_(division.component_of),
          own_(static_cast<std::int32_t>(component)),
          cell_of_(division.cell_of) {}

    void divide(Sampled sampled, std::vector<Core>& out) {
        const Core& component = sampled.component;
        seeds_ = std::move(sampled.seeds);
        cells_ = std::move(sampled.cells);
        spread(component);
        smooth();
        tell_narrow_boards();
        Sets sets(cells_.size());
        for (std::size_t a = 0; a < cells_.size(); ++a)
            for (const std::int32_t b : cells_[a].neighbours)
                if (same_part(cells_[a], cells_[b], slanted_)) sets.join(static_cast<std::int32_t>(a), b);
        if (has_narrow_) rejoin_sides(component, sets);
        absorb_small(sets, component);
        emit(component, sets, out);
    }

private:
    [[nodiscard]] bool is_own(std::int32_t i) const { return i >= 0 && component_of_[i] == own_; }

    [[nodiscard]] std::int32_t nearest_seed(std::int32_t i) const {
        const auto distance = [&](std::int32_t seed) {
            return (s_.geometry.barycentres[seed] - s_.geometry.barycentres[i]).squaredNorm();
        };
        const auto nearest = std::min_element(
            seeds_.begin(), seeds_.end(), [&](std::int32_t a, std::int32_t b) { return distance(a) < distance(b); });
        return static_cast<std::int32_t>(nearest - seeds_.begin());
    }

    /// Every triangle goes to the seed that reaches it first, over edges, then through the thickness; islands without a
    /// seed go to the nearest one.
    void spread(const Core& component) {
        std::vector<std::int32_t> queue;
        for (std::size_t k = 0; k < seeds_.size(); ++k) {
            cell_of_[seeds_[k]] = static_cast<std::int32_t>(k);
            queue.push_back(seeds_[k]);
            const std::int32_t o = s_.thickness.opposites[seeds_[k]];
            if (is_own(o) && cell_of_[o] < 0) {
                cell_of_[o] = static_cast<std::int32_t>(k);
                queue.push_back(o);
            }
        }
        const auto visit = [&](std::int32_t from, std::int32_t to) {
            if (!is_own(to) || cell_of_[to] >= 0) return;
            cell_of_[to] = cell_of_[from];
            queue.push_back(to);
        };
        for (std::size_t at = 0; at < queue.size(); ++at)
            for (const std::int32_t j : s_.adjacency.neighbours[queue[at]]) visit(queue[at], j);
        for (std::size_t at = 0; at < queue.size(); ++at) visit(queue[at], s_.thickness.opposites[queue[at]]);
        for (const std::int32_t i : component.triangles) {
            if (cell_of_[i] >= 0) continue;
            cell_of_[i] = nearest_seed(i);
            queue.assign(1, i);
            for (std::size_t at = 0; at < queue.size(); ++at) {
                for (const std::int32_t j : s_.adjacency.neighbours[queue[at]]) visit(queue[at], j);
                visit(queue[at], s_.thickness.opposites[queue[at]]);
            }
        }
        std::vector<std::pair<std::int32_t, std::int32_t>> pairs;
        const auto meet = [&](std::int32_t i, std::int32_t j) {
            if (is_own(j) && cell_of_[i] != cell_of_[j]) {
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
            const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(spread);
            smoothed[a].along = eigen.eigenvectors().col(2);
            smoothed[a].kind = kind_of(smoothed[a].ratio, smoothed[a].reach, slanted_ ? narrowest_slanted : narrowest);
            smoothed[a].is_junction = smoothed[a].kind == Solidity::stick && !slanted_ &&
                                      eigen.eigenvalues()[2] < least_agreement * eigen.eigenvalues().sum();
        }
        cells_ = std::move(smoothed);
    }

    /// Boards whose widths leave a gap are of two kinds, such as the slats of a back and the rail that they carry:
    /// widths that change step by step leave none.
    void tell_narrow_boards() {
        struct Width {
            double log, area;
        };
        std::vector<Width> widths;
        double all = 0;
        for (const Cell& cell : cells_)
            if (cell.kind == Solidity::board) {
                widths.push_back({std::log(cell.ratio), cell.area});
                all += cell.area;
            }
        std::ranges::sort(widths, {}, &Width::log);
        double below = 0;
        for (std::size_t i = 0; i + 1 < widths.size() && !has_narrow_; ++i) {
            below += widths[i].area;
            const double middle = (widths[i].log + widths[i + 1].log) / 2;
            double within = 0, within_below = 0;
            for (std::size_t k = i + 1; k-- > 0 && widths[k].log > middle - gap / 2;) within_below += widths[k].area;
            for (std::size_t k = i + 1; k < widths.size() && widths[k].log < middle + gap / 2; ++k)
                within += widths[k].area;
            const double narrow = below - within_below, wide = all - below - within;
            if (narrow < least_narrow * all || within + within_below > most_between * std::min(narrow, wide)) continue;
            has_narrow_ = true;
            for (Cell& cell : cells_) cell.is_narrow = cell.kind == Solidity::board && std::log(cell.ratio) < middle;
        }
    }

    static bool same_part(const Cell& a, const Cell& b, bool slanted) {
        if (a.kind != b.kind || a.is_narrow != b.is_narrow || a.is_junction || b.is_junction) return false;
        return slanted || a.kind != Solidity::stick || std::abs(a.along.dot(b.along)) > turn_cosine;
    }

    /// A narrow board ends at a wide one; what lies along it is its side.
    void rejoin_sides(const Core& component, Sets& sets) {
        std::vector<double> area(cells_.size(), 0.0), width(cells_.size(), 0.0);
        std::vector<std::int32_t> piece_of(cells_.size());  // as it is before any are joined
        for (std::size_t a = 0; a < cells_.size(); ++a) {
            const std::int32_t root = piece_of[a] = sets.find(static_cast<std::int32_t>(a));
            area[root] += cells_[a].area;
            width[root] += cells_[a].area * cells_[a].ratio * cells_[a].thickness;
        }
        std::vector<Vec3> centre(cells_.size(), Vec3::Zero());
        for (const std::int32_t i : component.triangles)
            centre[piece_of[cell_of_[i]]] += s_.geometry.areas[i] * s_.geometry.barycentres[i];
        struct Border {
            double length = 0;
            Vec3 sum = Vec3::Zero();
            Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
        };
        std::map<std::pair<std::int32_t, std::int32_t>, Border> borders;
        const Vec3& origin = s_.geometry.barycentres[component.triangles.front()];
        for (const std::int32_t i : component.triangles)
            for (std::size_t e = 0; e < 3; ++e) {
                const std::int32_t j = s_.adjacency.neighbours[i][e];
                if (!is_own(j) || cell_of_[j] == cell_of_[i]) continue;
                const std::int32_t a = piece_of[cell_of_[i]], b = piece_of[cell_of_[j]];
                if (a == b || cells_[a].kind != Solidity::board || cells_[b].kind != Solidity::board) continue;
                const auto& corners = s_.mesh.triangles[i];
                const Vec3 &from = s_.mesh.positions[corners[e]], &to = s_.mesh.positions[corners[(e + 1) % 3]];
                const Vec3 place = (from + to) / 2 - origin;
                Border& border = borders[std::minmax(a, b)];
                border.length += (to - from).norm();
                border.sum += (to - from).norm() * place;
                border.spread += (to - from).norm() * place * place.transpose();
            }
        for (const auto& [pair, border] : borders) {
            const auto [a, b] = pair;
            const bool is_first = width[a] / area[a] < width[b] / area[b];
            const std::int32_t slat = is_first ? a : b, rail = is_first ? b : a;
            const double narrow = width[slat] / area[slat];
            const Vec3 middle = border.sum / border.length;
            const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(border.spread / border.length -
                                                                       middle * middle.transpose());
            // Cells make borders crooked: this long were they straight.
            const double end = std::sqrt(12 * std::max(0.0, eigen.eigenvalues()[2]));
            const Vec3 place = origin + middle;
            const Vec3 across = s_.geometry.normals[seeds_[rail]].cross(place - centre[slat] / area[slat]).normalized();
            if (end < narrowest_end * narrow || end > widest_end * narrow ||
                area[slat] < 2 * least_length * narrow * narrow || !is_corner_between(piece_of, slat, rail) ||
                width_beyond(component, piece_of, slat, place, across, 1.5 * end) < shoulders * end)
                sets.join(a, b);
            else
                parted_.emplace_back(slat, rail);
        }
        // What touches through the board only lies along it, too.
        for (std::size_t k = 0; k < cells_.size(); ++k)
            for (const std::int32_t n : cells_[k].neighbours)
                if (cells_[k].kind == Solidity::board && cells_[n].kind == Solidity::board && !cells_[k].is_junction &&
                    !cells_[n].is_junction && !borders.contains(std::minmax(piece_of[k], piece_of[n])))
                    sets.join(piece_of[k], piece_of[n]);
    }

    /// Whether the outline turns a corner between two pieces of a board: one is out of the other's sight for a good
    /// part, unlike the tip of a triangle or of an ellipse.
    [[nodiscard]] bool is_corner_between(const std::vector<std::int32_t>& piece_of, std::int32_t a,
                                         std::int32_t b) const {
        constexpr std::size_t samples = 6;
        const auto places = [&](std::int32_t piece) {
            std::vector<std::int32_t> seeds;
            for (std::size_t k = 0; k < piece_of.size(); ++k)
                if (piece_of[k] == piece) seeds.push_back(seeds_[k]);
            std::vector<std::int32_t> some;
            for (std::size_t k = 0; k < samples; ++k) some.push_back(seeds[k * (seeds.size() - 1) / (samples - 1)]);
            return some;
        };
        const auto middle_of = [&](std::int32_t seed) {
            return Vec3(s_.geometry.barycentres[seed] - s_.geometry.normals[seed] * (s_.thickness.distances[seed] / 2));
        };
        std::size_t hidden = 0;
        const std::vector<std::int32_t> others = places(b);
        for (const std::int32_t from : places(a))
            for (const std::int32_t to : others) {
                const Vec3 way = middle_of(to) - middle_of(from);
                const WallHit hit = s_.scene->exit_wall({middle_of(from), way.normalized(), -1, from});
                hidden += hit.triangle >= 0 && hit.distance < way.norm() - s_.thickness.distances[from] / 2;
            }
        return static_cast<double>(hidden) > least_hidden * samples * samples;
    }

    /// How far the board reaches along a direction beyond a piece, near a place.
    [[nodiscard]] double width_beyond(const Core& component, const std::vector<std::int32_t>& piece_of,
                                      std::int32_t piece, const Vec3& place, const Vec3& along, double radius) const {
        double low = 0, high = 0;
        for (const std::int32_t i : component.triangles) {
            const Vec3 way = s_.geometry.barycentres[i] - place;
            if (way.squaredNorm() > radius * radius || piece_of[cell_of_[i]] == piece) continue;
            low = std::min(low, way.dot(along));
            high = std::max(high, way.dot(along));
        }
        return high - low;
    }

    /// Pieces too small to be a part join the neighbour with the longest common border.
    void absorb_small(Sets& sets, const Core& component) {
        for (int round = 0; round < 4; ++round) {
            std::vector<double> area(cells_.size());
            for (std::size_t a = 0; a < cells_.size(); ++a)
                area[sets.find(static_cast<std::int32_t>(a))] += cells_[a].area;
            std::vector<std::int32_t> into(cells_.size(), -1);
            std::vector<std::vector<std::pair<std::int32_t, int>>> borders(cells_.size());
            for (std::size_t a = 0; a < cells_.size(); ++a) {
                const std::int32_t own = sets.find(static_cast<std::int32_t>(a));
                if (area[own] >= least_area(component) || cells_[a].kind == Solidity::unknown) continue;
                for (const std::int32_t b : cells_[a].neighbours) {
                    const std::int32_t other = sets.find(b);
                    if (other == own || cells_[b].kind == Solidity::unknown) continue;
                    auto at = std::find_if(borders[own].begin(), borders[own].end(),
                                           [&](const auto& entry) { return entry.first == other; });
                    if (at == borders[own].end()) at = borders[own].insert(at, {other, 0});
                    ++at->second;
                }
            }
            bool changed = false;
            for (std::size_t a = 0; a < cells_.size(); ++a) {
                if (borders[a].empty()) continue;
                const auto best =
                    std::max_element(borders[a].begin(), borders[a].end(), [&](const auto& x, const auto& y) {
                        return x.second != y.second ? x.second < y.second : area[x.first] < area[y.first];
                    });
                sets.join(static_cast<std::int32_t>(a), best->first);
                changed = true;
            }
            if (!changed) break;
        }
    }

    [[nodiscard]] double least_area(const Core& component) const {
        return std::min(0.2 * component.area, 3 * component.thickness * component.thickness);
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
            out[first + number[root]].thickness += cells_[a].area * cells_[a].thickness;
            out[first + number[root]].width += cells_[a].area * cells_[a].ratio * cells_[a].thickness;
            spreads[number[root]] += cells_[a].area * cells_[a].along * cells_[a].along.transpose();
        }
        std::vector<double> areas(votes.size(), 0.0);
        for (std::size_t k = 0; k < votes.size(); ++k) {
            const auto best = std::max_element(votes[k].begin(), votes[k].end()) - votes[k].begin();
            out[first + k].kind = static_cast<Solidity>(best);
            out[first + k].axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spreads[k]).eigenvectors().col(2);
        }
        for (std::size_t a = 0; a < cells_.size(); ++a)
            areas[number[sets.find(static_cast<std::int32_t>(a))]] += cells_[a].area;
        for (std::size_t k = 0; k < votes.size(); ++k) out[first + k].width /= areas[k];
        for (const auto& [slat, rail] : parted_) {
            const std::int32_t a = number[sets.find(slat)], b = number[sets.find(rail)];
            if (a != b) out[first + a].family = out[first + b].family = component.triangles.front();
        }
        for (const std::int32_t i : component.triangles) {
            Core& core = out[first + number[sets.find(cell_of_[i])]];
            core.triangles.push_back(i);
            core.area += s_.geometry.areas[i];
        }
        for (std::size_t k = first; k < out.size(); ++k)
            out[k].thickness = slanted_ ? out[k].thickness / out[k].area : median_thickness(s_, out[k].triangles);
    }

    const Surface& s_;
    bool slanted_;  ///< the second search: walls that are not parallel; sticks are not parted where they turn
    const std::vector<std::int32_t>& component_of_;
    std::int32_t own_;  ///< number of the component
    std::vector<std::int32_t>& cell_of_;
    std::vector<Cell> cells_;
    std::vector<std::int32_t> seeds_;
    bool has_narrow_ = false;
    std::vector<std::pair<std::int32_t, std::int32_t>>
        parted_;  ///< cells of a narrow board and of the wide one at its end
};

/// How alike neighbours must be to belong to one component.
struct Likeness {
    double wall_cosine;     ///< a wall and its opposite look away from each other at least so much
    double thickness_step;  ///< largest ratio of thicknesses from a triangle to the next
};

/// Connected sets of free triangles that are walls of alike thickness, each with its opposite wall; concave creases
/// part.
std::vector<Core> find_components(const Surface& s, const std::vector<char>& taken, const Likeness& like) {
    const std::size_t count = s.count();
    const auto& t = s.thickness.distances;
    const auto& opposite = s.thickness.opposites;
    std::vector<char> wall(count);
    for_each_range(count, s.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            wall[i] = !taken[i] && !s.in_crease(i) && opposite[i] >= 0 && !taken[opposite[i]] &&
                      -s.geometry.normals[i].dot(s.geometry.normals[opposite[i]]) > like.wall_cosine;
    });
    const auto step = static_cast<float>(like.thickness_step);
    const auto alike = [&](std::size_t i, std::int32_t j) {
        return wall[j] && t[i] < step * t[j] && t[j] < step * t[i];
    };
    Sets sets(count);
    for_each_range(count, s.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto self = static_cast<std::int32_t>(i);
            if (!wall[i]) continue;
            for (const std::int32_t j : s.adjacency.neighbours[i]) {
                if (j < self || !alike(i, j)) continue;
                const bool concave =
                    (s.geometry.barycentres[j] - s.geometry.barycentres[i]).dot(s.geometry.normals[i]) > 0;
                if (concave && s.geometry.normals[i].dot(s.geometry.normals[j]) < crease_cosine) continue;
                sets.join(self, j);
            }
            if (alike(i, opposite[i])) sets.join(self, opposite[i]);
        }
    });
    std::vector<std::int32_t> number(count, -1);
    std::vector<Core> components;
    for (std::size_t i = 0; i < count; ++i) {
        if (!wall[i]) continue;
        const std::int32_t root = sets.find(static_cast<std::int32_t>(i));
        if (number[root] < 0) {
            number[root] = static_cast<std::int32_t>(components.size());
            components.emplace_back();
        }
        Core& component = components[number[root]];
        component.triangles.push_back(static_cast<std::int32_t>(i));
        component.area += s.geometry.areas[i];
    }
    return components;
}

/// Thickness may change along a part, but not without limit: a wedge that stands on a board is not the board. Where
/// walls are slanted they meet at edges, and are thin there.
void drop_odd_thickness(const Surface& s, Core& component, bool slanted) {
    const auto low = slanted ? 0.0F : static_cast<float>(component.thickness / odd_thickness);
    const auto high = static_cast<float>(component.thickness * odd_thickness);
    std::erase_if(component.triangles,
                  [&](std::int32_t i) { return s.thickness.distances[i] < low || s.thickness.distances[i] > high; });
    component.area = 0;
    for (const std::int32_t i : component.triangles) component.area += s.geometry.areas[i];
}

/// The parts of components that can be cores.
std::vector<Core> divide(const Surface& s, std::vector<Core> components, double total_area, double least_cubes,
                         bool slanted) {
    const auto too_small = [&](const Core& core) {
        return core.area < least_share * total_area || is_fin(s, core.thickness, core.area / total_area) ||
               core.area < least_cubes * core.thickness * core.thickness;
    };
    std::vector<std::optional<PlainPiece>> plain(components.size());
    for_each_range(
        components.size(), s.threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                Core& component = components[k];
                if (component.triangles.size() >= 4) component.thickness = median_thickness(s, component.triangles);
                if (component.triangles.size() < 4 || too_small(component)) {
                    component.triangles.clear();
                    continue;
                }
                drop_odd_thickness(s, component, slanted);
                if (!slanted) plain[k] = as_plain_piece(s, component.triangles, component.thickness, component.area);
            }
        },
        1);
    std::vector<Core> cores;
    std::vector<Sampled> sampled;
    for (std::size_t k = 0; k < components.size(); ++k) {
        Core& component = components[k];
        if (component.triangles.empty()) continue;
        if (const auto& piece = plain[k]) {
            component.kind = kind_of(piece->narrow / component.thickness, piece->wide / component.thickness, narrowest);
            component.axis = piece->along;
            cores.push_back(std::move(component));
            continue;
        }
        std::vector<std::int32_t> seeds = choose_seeds(s, component, total_area);
        sampled.push_back({std::move(component), std::move(seeds), {}});
    }
    look_around(s, sampled, slanted);
    Division division(s, sampled);
    std::vector<std::vector<Core>> divided(sampled.size());
    for_each_range(
        sampled.size(), s.threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                Divider(s, slanted, division, k).divide(std::move(sampled[k]), divided[k]);
        },
        1);
    for (std::vector<Core>& found : divided) std::ranges::move(found, std::back_inserter(cores));
    std::erase_if(cores, [&](const Core& core) { return core.kind == Solidity::unknown || too_small(core); });
    return cores;
}

/// Whether what is a stick here and there is one on the whole: noise joins walls that have nothing to do with each
/// other.
bool is_slim(const Surface& s, const Core& stick) {
    constexpr double widest = 1.2;  // thicknesses from the axis, as root of the mean square
    Vec3 middle = Vec3::Zero();
    for (const std::int32_t i : stick.triangles) middle += s.geometry.areas[i] * s.geometry.barycentres[i];
    middle /= stick.area;
    double spread = 0;
    for (const std::int32_t i : stick.triangles)
        spread += s.geometry.areas[i] * (s.geometry.barycentres[i] - middle).cross(stick.axis).squaredNorm();
    return spread < widest * widest * stick.thickness * stick.thickness * stick.area;
}

}  // namespace

Cores find_cores(const Surface& s) {
    const double total = std::accumulate(s.geometry.areas.begin(), s.geometry.areas.end(), 0.0);
    std::vector<char> taken(s.count(), 0);
    std::vector<Core> cores = divide(s, find_components(s, taken, {parallel_cosine, 1.25}), total, 1, false);
    for (const Core& core : cores)
        for (const std::int32_t i : core.triangles) taken[i] = 1;
    // Walls that are not parallel, such as those of a stick with three sides, in what is left.
    for (Core& core : divide(s, find_components(s, taken, {slanted_cosine, 4}), total, 4, true))
        if (core.kind == Solidity::stick && is_slim(s, core)) cores.push_back(std::move(core));
    std::stable_sort(cores.begin(), cores.end(), [](const Core& a, const Core& b) { return a.area > b.area; });
    Cores result{std::move(cores), std::vector<std::int32_t>(s.count(), -1)};
    for (std::size_t k = 0; k < result.cores.size(); ++k)
        for (const std::int32_t i : result.cores[k].triangles) result.core_of[i] = static_cast<std::int32_t>(k);
    return result;
}

}  // namespace partonomy
