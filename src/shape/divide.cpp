// Taking a component apart where what it is changes.
//
// Idea: the cells of a component (cells.cpp) vote with their neighbours whether they are board or stick, and which way
// a stick runs. Neighbouring cells that agree are one piece; where they do not, the component is cut: posts come off
// the backrest that they carry, a leg off its stretcher, a seat off the back that it bends up into (bends.cpp), and
// slats off their rail (narrow_boards.cpp). Pieces too small
// for a part join a neighbour. Cost: O(n) and the square of the number of cells around a cell.

#include "shape/divide.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "base/ranges.h"
#include "shape/bends.h"
#include "shape/narrow_boards.h"

namespace partonomy {

namespace {

const double turn_cosine = std::cos(38 * std::numbers::pi / 180);
constexpr double least_agreement = 0.75;  // of directions around a cell, unless sticks meet there

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
        const bool has_narrow = tell_narrow_boards(cells_);
        const CellMap map{s_, component, seeds_, cells_, cell_of_, component_of_, own_};
        std::vector<std::int32_t> sides(cells_.size(), 0);
        if (!slanted_) {
            Sets of_any_width = join_alike(sides, [](const Cell&, const Cell&) { return true; });
            sides = tell_sides_of_bends(map, of_any_width);
        }
        Sets sets = join_alike(sides, [](const Cell& a, const Cell& b) { return a.is_narrow == b.is_narrow; });
        if (has_narrow) parted_ = part_narrow_boards(map, sides, sets);
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
        for (const std::int32_t i : component.triangles) cells_[cell_of_[i]].area += s_.geometry.areas[i];
        for (const auto& [a, b] : meeting_cells(component)) cells_[a].neighbours.push_back(b);
    }

    using Pairs = std::vector<std::pair<std::int32_t, std::int32_t>>;

    /// Cells that meet over an edge or face each other; each pair both ways, sorted.
    [[nodiscard]] Pairs meeting_cells(const Core& component) const {
        const auto sort_out = [](Pairs& pairs) {
            std::sort(pairs.begin(), pairs.end());
            pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
        };
        const auto of_blocks =
            map_blocks(component.triangles.size(), s_.threads, [&](std::size_t begin, std::size_t end) {
                Pairs pairs;
                std::array<std::pair<std::int32_t, std::int32_t>, 256> last{};  // most pairs come again and again
                const auto meet = [&](std::int32_t i, std::int32_t j) {
                    if (!is_own(j) || cell_of_[i] == cell_of_[j]) return;
                    const std::pair pair(cell_of_[i], cell_of_[j]);
                    auto& before = last[static_cast<std::size_t>(pair.first * 31 + pair.second) % last.size()];
                    if (before == pair) return;
                    before = pair;
                    pairs.push_back(pair);
                    pairs.emplace_back(pair.second, pair.first);
                };
                for (std::size_t k = begin; k < end; ++k) {
                    const std::int32_t i = component.triangles[k];
                    for (const std::int32_t j : s_.adjacency.neighbours[i]) meet(i, j);
                    meet(i, s_.thickness.opposites[i]);
                }
                sort_out(pairs);
                return pairs;
            });
        Pairs pairs;
        for (const Pairs& some : of_blocks) pairs.insert(pairs.end(), some.begin(), some.end());
        sort_out(pairs);
        return pairs;
    }

    /// A cell takes the median width of its neighbourhood, and its main direction.
    void smooth() {
        std::vector<Cell> smoothed = cells_;
        const auto smooth_one = [&](std::size_t a) {
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
        };
        for_each_range(
            cells_.size(), s_.threads,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t a = begin; a < end; ++a) smooth_one(a);
            },
            64);
        cells_ = std::move(smoothed);
    }

    static bool same_part(const Cell& a, const Cell& b, bool slanted) {
        if (a.kind != b.kind || a.is_junction || b.is_junction) return false;
        return slanted || a.kind != Solidity::stick || std::abs(a.along.dot(b.along)) > turn_cosine;
    }

    /// Neighbours that are alike, and on the same side of a bend.
    template <class Alike>
    [[nodiscard]] Sets join_alike(const std::vector<std::int32_t>& sides, const Alike& alike) const {
        Sets sets(cells_.size());
        for (std::size_t a = 0; a < cells_.size(); ++a)
            for (const std::int32_t b : cells_[a].neighbours)
                if (sides[a] == sides[b] && alike(cells_[a], cells_[b]) && same_part(cells_[a], cells_[b], slanted_))
                    sets.join(static_cast<std::int32_t>(a), b);
        return sets;
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
        for (std::size_t k = 0; k < votes.size(); ++k) {
            const auto best = std::max_element(votes[k].begin(), votes[k].end()) - votes[k].begin();
            out[first + k].kind = static_cast<Solidity>(best);
            out[first + k].width /= std::accumulate(votes[k].begin(), votes[k].end(), 0.0);
            out[first + k].axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spreads[k]).eigenvectors().col(2);
        }
        for (const auto& [slat, rail] : parted_) {
            const std::int32_t a = number[sets.find(slat)], b = number[sets.find(rail)];
            if (a != b) out[first + a].family = out[first + b].family = component.triangles.front();
        }
        if (votes.size() == 1) {
            out[first].triangles = component.triangles;
            out[first].area = component.area;
        } else {
            for (const std::int32_t i : component.triangles) {
                Core& core = out[first + number[sets.find(cell_of_[i])]];
                core.triangles.push_back(i);
                core.area += s_.geometry.areas[i];
            }
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
    std::vector<PartedBoards> parted_;
};

}  // namespace

void divide_component(const Surface& surface, bool slanted, Division& division, std::size_t component, Sampled sampled,
                      std::vector<Core>& pieces) {
    Divider(surface, slanted, division, component).divide(std::move(sampled), pieces);
}

}  // namespace partonomy
