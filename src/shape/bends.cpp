// Boards and sticks with a tight bend: a seat and a back of one sheet, a frame of one tube.
//
// Idea: the walls of a bent board face many directions, but not equally. Where flat sides are long and the bend between
// them is short, nearly all of the area faces one of two directions; a board of constant curvature faces all of them
// alike. So the direction that most of a piece faces is found, then the one that most of the rest faces, at a good
// angle to the first, and so on. The piece is cut between these sides when what faces none of them is small against
// each: then each is a board of its own, and the bend a border that its maker drew with a radius. Sticks are told by
// the direction in which they run. Noise tilts a cell, so a cell faces what its triangles face on average. Cost: the
// square of the number of cells of pieces that are not straight, and O(n) for these.

#include "shape/bends.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace partonomy {

namespace {

/// How far what faces a side may be from its direction, and how far apart sides must be. Noise tilts cells.
struct Angles {
    double alike_cosine, apart_cosine;
};
const Angles clean{std::cos(15 * std::numbers::pi / 180), std::cos(45 * std::numbers::pi / 180)};
const Angles noisy{std::cos(22 * std::numbers::pi / 180), std::cos(60 * std::numbers::pi / 180)};
constexpr double most_between = 0.35;  // of the smallest side
constexpr double least_side = 0.1;     // of the piece
constexpr std::size_t most_sides = 4;
constexpr double hardly_bent = 0.03;  // share of the second direction: no side is so small

using Tensor = Eigen::Matrix3d;

Vec3 main_direction(const Tensor& tensor) {
    return Eigen::SelfAdjointEigenSolver<Tensor>(tensor).eigenvectors().col(2);
}

/// A piece: its cells, which direction each has, and how much of the surface each is.
struct Directions {
    std::vector<std::int32_t> cells;
    std::vector<Vec3> lines;
    std::vector<double> areas;

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

    /// The directions of the flat sides; fewer than two when the piece is not bent tightly.
    [[nodiscard]] std::vector<Vec3> sides(const Angles& angles) const {
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
        if (between > most_between * least) found.clear();
        return found;
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
    std::vector<Tensor> facing;  // of cells, if any piece asks
    for (Directions& piece : of_piece) {
        if (piece.cells.size() < 2 || piece.is_straight()) continue;
        if (m.cells[piece.cells.front()].kind == Solidity::board) {
            if (facing.empty()) {
                facing.assign(m.cells.size(), Tensor::Zero());
                for (const std::int32_t i : m.component.triangles) {
                    const Vec3& normal = m.surface.geometry.normals[i];
                    facing[m.cell_of[i]] += m.surface.geometry.areas[i] * normal * normal.transpose();
                }
            }
            for (std::size_t k = 0; k < piece.cells.size(); ++k)
                piece.lines[k] = main_direction(facing[piece.cells[k]]);
        }
        const std::vector<Vec3> sides = piece.sides(m.surface.grain > 0 ? noisy : clean);
        if (sides.size() < 2) continue;
        for (std::size_t k = 0; k < piece.cells.size(); ++k) {
            const auto nearest = std::ranges::max_element(
                sides, {}, [&](const Vec3& side) { return std::abs(side.dot(piece.lines[k])); });
            side_of[piece.cells[k]] = static_cast<std::int32_t>(nearest - sides.begin());
        }
    }
    return side_of;
}

}  // namespace partonomy
