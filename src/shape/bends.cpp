// Boards and sticks with a tight bend: a seat and a back of one sheet, a frame of one tube.
//
// Idea: the walls of a bent board face many directions, but not equally. Where flat sides are long and the bend between
// them is short, nearly all of the area faces one of two directions; a board of constant curvature faces all of them
// alike. So the direction that most of a piece faces is found, then the one that most of the rest faces, at a good
// angle to the first, and so on. The piece is cut between these sides when what faces none of them is small against
// each: then each is a board of its own, and the bend a border that its maker drew with a radius. The curved back of a
// chair faces many directions, but changes slowly from cell to cell: so where no flat sides are found, cells that turn
// no faster than a gentle arc are one side (only flat sides can be told where cells are as large as the bend). A cell
// that turns faster than that within itself lies across an edge, and is on no side: rows of such cells along the edge
// of a tray would lead from its floor to its wall in small steps. Sticks
// are told by the direction in which they run. Noise tilts a cell, so a cell faces what its triangles face on average.
// Cost: the square of the number of cells of pieces that are not straight, and O(n) for these.

#include "shape/bends.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace partonomy {

namespace {

/// How far what faces a flat side may be from its direction, and how far apart sides must be. Noise tilts cells.
struct Angles {
    double alike_cosine, apart_cosine;
    double tilt;  ///< radians: neighbouring cells less far apart are on one side
};
const Angles clean{std::cos(15 * std::numbers::pi / 180), std::cos(45 * std::numbers::pi / 180),
                   5 * std::numbers::pi / 180};
const Angles noisy{std::cos(22 * std::numbers::pi / 180), std::cos(60 * std::numbers::pi / 180),
                   22 * std::numbers::pi / 180};
constexpr double gentle_radius = 7;    // thicknesses: an arc so wide does not end a side
constexpr double most_between = 0.35;  // of the smallest side
constexpr double least_side = 0.1;     // of the piece
constexpr std::size_t most_sides = 4;
constexpr double hardly_bent = 0.03;  // share of the second direction: no side is so small

using Tensor = Eigen::Matrix3d;

Vec3 main_direction(const Tensor& tensor) {
    return Eigen::SelfAdjointEigenSolver<Tensor>(tensor).eigenvectors().col(2);
}

/// Where the triangles of a cell are and what they face.
struct Spread {
    double area = 0;
    Vec3 place = Vec3::Zero();  ///< from the component's first triangle
    Tensor places = Tensor::Zero(), facing = Tensor::Zero();

    [[nodiscard]] double length() const {  ///< were it even
        const Vec3 middle = place / area;
        return std::sqrt(12 * std::max(0.0, eigenvalues_of(places / area - middle * middle.transpose())[2]));
    }
    [[nodiscard]] double own_turn() const {  ///< radians, were it between two sides
        const Vec3 shares = eigenvalues_of(facing) / area;
        return 2 * std::sqrt(std::max(0.0, shares[0] + shares[1]));
    }

private:
    static Vec3 eigenvalues_of(const Tensor& tensor) {
        return Eigen::SelfAdjointEigenSolver<Tensor>(tensor, Eigen::EigenvaluesOnly).eigenvalues();
    }
};

std::vector<Spread> spreads_of_cells(const CellMap& m) {
    std::vector<Spread> spreads(m.cells.size());
    const Vec3& origin = m.surface.geometry.barycentres[m.component.triangles.front()];
    for (const std::int32_t i : m.component.triangles) {
        Spread& spread = spreads[m.cell_of[i]];
        const double area = m.surface.geometry.areas[i];
        const Vec3 place = m.surface.geometry.barycentres[i] - origin;
        const Vec3& normal = m.surface.geometry.normals[i];
        spread.area += area;
        spread.place += area * place;
        spread.places += area * place * place.transpose();
        spread.facing += area * normal * normal.transpose();
    }
    return spreads;
}

/// A piece: its cells, which direction each has, and how much of the surface each is.
struct Directions {
    std::vector<std::int32_t> cells;
    std::vector<Vec3> lines;
    std::vector<double> areas;
    std::vector<double> own_turns;  ///< of a board's cells, radians; empty for sticks, and under noise
    std::vector<double> lengths;    ///< and how long they are

    [[nodiscard]] bool is_straight() const {
        Tensor sum = Tensor::Zero();
        double area = 0;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            sum += areas[k] * lines[k] * lines[k].transpose();
            area += areas[k];
        }
        const Vec3 shares = Eigen::SelfAdjointEigenSolver<Tensor>(sum).eigenvalues();
        return !(shares[1] > hardly_bent * area);
    }

    /// The flat side that each cell is on, or is nearest to in direction; none when what is between them is too large.
    [[nodiscard]] std::vector<std::int32_t> flat_sides(const Angles& angles) const {
        std::vector<Vec3> found;
        std::vector<char> is_left(cells.size(), 1);
        double all = 0, between = 0, least = 0;
        for (const double area : areas) all += area;
        between = all;
        while (found.size() < most_sides) {
            std::size_t best = 0;
            double most = 0;
            for (std::size_t a = 0; a < cells.size(); ++a) {
                if (!is_left[a] || std::ranges::any_of(found, [&](const Vec3& side) {
                        return std::abs(side.dot(lines[a])) > angles.apart_cosine;
                    }))
                    continue;
                double alike = 0;
                for (std::size_t b = 0; b < cells.size(); ++b)
                    if (is_left[b] && std::abs(lines[a].dot(lines[b])) > angles.alike_cosine) alike += areas[b];
                if (alike > most) most = alike, best = a;
            }
            if (most < least_side * all) break;
            const Vec3 side = lines[best];
            for (std::size_t b = 0; b < cells.size(); ++b)
                if (is_left[b] && std::abs(side.dot(lines[b])) > angles.alike_cosine) is_left[b] = 0;
            between -= most;
            least = most;
            found.push_back(side);
        }
        if (found.size() < 2 || between > most_between * least) return {};
        std::vector<std::int32_t> side_of;
        for (const Vec3& line : lines) side_of.push_back(nearest_side(found, line));
        return side_of;
    }

    /// The same for sides that may be curved: cells that hang together, each turning but slowly from the next.
    [[nodiscard]] std::vector<std::int32_t> slow_sides(const CellMap& m, const Angles& angles) const {
        struct Side {
            double area = 0;
            Tensor facing = Tensor::Zero();
            std::int32_t number = -1;
        };
        std::vector<std::int32_t> place(m.cells.size(), -1);
        for (std::size_t k = 0; k < cells.size(); ++k) place[cells[k]] = static_cast<std::int32_t>(k);
        const std::vector<char> is_across = tell_across(m, angles);
        Sets sets = join_slow_turns(m, place, is_across, angles);
        std::map<std::int32_t, Side> sides;
        double all = 0;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            all += areas[k];
            if (is_across[k]) continue;
            Side& side = sides[sets.find(static_cast<std::int32_t>(k))];
            side.area += areas[k];
            side.facing += areas[k] * lines[k] * lines[k].transpose();
        }
        std::vector<Vec3> found;
        std::vector<double> found_area;
        for (auto& [root, side] : sides) {
            if (side.area < least_side * all) continue;
            const Vec3 line = main_direction(side.facing);
            const auto same = std::ranges::find_if(
                found, [&](const Vec3& other) { return std::abs(line.dot(other)) > angles.apart_cosine; });
            side.number = static_cast<std::int32_t>(same - found.begin());
            if (same == found.end()) {
                found.push_back(line);
                found_area.push_back(0);
            }
            found_area[side.number] += side.area;
        }
        if (found.size() < 2) return {};
        std::vector<std::int32_t> side_of;
        double between = 0;
        for (std::size_t k = 0; k < cells.size(); ++k) {
            const auto side = sides.find(sets.find(static_cast<std::int32_t>(k)));
            const bool is_on_side = side != sides.end() && side->second.number >= 0;
            side_of.push_back(is_on_side ? side->second.number : nearest_side(found, lines[k]));
            if (!is_on_side && !is_across[k]) between += areas[k];
        }
        // An edge has no area: what lies across it faces one side or the other, triangle by triangle.
        for (const std::int32_t i : m.component.triangles)
            if (const std::int32_t k = place[m.cell_of[i]];
                k >= 0 && is_across[k] && std::ranges::none_of(found, [&](const Vec3& side) {
                    return std::abs(side.dot(m.surface.geometry.normals[i])) > angles.alike_cosine;
                }))
                between += m.surface.geometry.areas[i];
        if (between > most_between * std::ranges::min(found_area)) return {};
        return side_of;
    }

private:
    static std::int32_t nearest_side(const std::vector<Vec3>& sides, const Vec3& line) {
        const auto nearest =
            std::ranges::max_element(sides, {}, [&](const Vec3& side) { return std::abs(side.dot(line)); });
        return static_cast<std::int32_t>(nearest - sides.begin());
    }

    /// Which cells turn faster than a gentle arc within themselves.
    [[nodiscard]] std::vector<char> tell_across(const CellMap& m, const Angles& angles) const {
        std::vector<char> is_across(cells.size(), 0);
        for (std::size_t k = 0; k < own_turns.size(); ++k)
            is_across[k] = own_turns[k] > angles.tilt + lengths[k] / (gentle_radius * m.component.thickness);
        return is_across;
    }

    [[nodiscard]] Sets join_slow_turns(const CellMap& m, const std::vector<std::int32_t>& place,
                                       const std::vector<char>& is_across, const Angles& angles) const {
        const auto where = [&](std::size_t k) { return m.surface.geometry.barycentres[m.seeds[cells[k]]]; };
        Sets sets(cells.size());
        for (std::size_t k = 0; k < cells.size(); ++k)
            for (const std::int32_t neighbour : m.cells[cells[k]].neighbours) {
                const std::int32_t b = place[neighbour];
                if (b < 0 || is_across[k] || is_across[b]) continue;
                const double turn = std::acos(std::min(1.0, std::abs(lines[k].dot(lines[b]))));
                const double way = (where(b) - where(k)).norm();
                if (turn < std::max(angles.tilt, way / (gentle_radius * m.component.thickness)))
                    sets.join(static_cast<std::int32_t>(k), b);
            }
        return sets;
    }
};

}  // namespace

std::vector<std::int32_t> tell_sides_of_bends(const CellMap& m, Sets& pieces) {
    std::vector<std::int32_t> side_of(m.cells.size(), 0);
    std::vector<Directions> of_piece(m.cells.size());
    const auto line_of_seed = [&](std::size_t k) {
        return m.cells[k].kind == Solidity::stick ? m.cells[k].along : m.surface.geometry.normals[m.seeds[k]];
    };
    for (std::size_t k = 0; k < m.cells.size(); ++k) {
        if (m.cells[k].kind != Solidity::board && m.cells[k].kind != Solidity::stick) continue;
        Directions& piece = of_piece[pieces.find(static_cast<std::int32_t>(k))];
        piece.cells.push_back(static_cast<std::int32_t>(k));
        piece.lines.push_back(line_of_seed(k));
        piece.areas.push_back(m.cells[k].area);
    }
    std::vector<Spread> spreads;  // of cells, if any piece asks
    for (Directions& piece : of_piece) {
        if (piece.cells.size() < 2 || piece.is_straight()) continue;
        if (m.cells[piece.cells.front()].kind == Solidity::board) {
            if (spreads.empty()) spreads = spreads_of_cells(m);
            for (std::size_t k = 0; k < piece.cells.size(); ++k) {
                const Spread& spread = spreads[piece.cells[k]];
                piece.lines[k] = main_direction(spread.facing);
                if (m.surface.grain > 0) continue;
                piece.own_turns.push_back(spread.own_turn());
                piece.lengths.push_back(spread.length());
            }
        }
        const Angles& angles = m.surface.grain > 0 ? noisy : clean;
        std::vector<std::int32_t> sides = piece.flat_sides(angles);
        if (sides.empty()) sides = piece.slow_sides(m, angles);
        for (std::size_t k = 0; k < sides.size(); ++k) side_of[piece.cells[k]] = sides[k];
    }
    return side_of;
}

}  // namespace partonomy
