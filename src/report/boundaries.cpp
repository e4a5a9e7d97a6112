// Borders are cut into pieces a quarter of the tolerance long. A piece is near when its middle is within the tolerance
// of a piece of the other side; those are found in a grid of cells as wide as the tolerance and a piece, kept as a
// sorted list. O(pieces log pieces).

#include "report/boundaries.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "base/errors.h"
#include "mesh/edges.h"

namespace partonomy {
namespace {

struct Piece {
    Vec3 from, to;
    [[nodiscard]] Vec3 middle() const { return (from + to) / 2; }
    [[nodiscard]] double length() const { return (to - from).norm(); }
    [[nodiscard]] double distance(const Vec3& point) const {
        const Vec3 way = to - from;
        const double square = way.squaredNorm();
        const double at = square > 0 ? std::clamp((point - from).dot(way) / square, 0.0, 1.0) : 0.0;
        return (point - from - at * way).norm();
    }
};

constexpr double pieces_a_tolerance = 4;

void cut(const Vec3& from, const Vec3& to, double length, std::vector<Piece>& pieces) {
    const auto count = static_cast<int>(std::ceil(std::max(1.0, (to - from).norm() / length)));
    for (int i = 0; i < count; ++i) {
        const Vec3 step = (to - from) / count;
        pieces.push_back({from + i * step, from + (i + 1) * step});
    }
}

/// Pieces by the cell that their middle is in.
class Grid {
public:
    Grid(const std::vector<Piece>& pieces, double width) : pieces_(pieces), width_(width) {
        for (std::size_t i = 0; i < pieces.size(); ++i) places_.push_back({cell_of(pieces[i].middle()), i});
        std::sort(places_.begin(), places_.end());
    }

    [[nodiscard]] bool is_near(const Vec3& point, double distance) const {
        const Cell centre = cell_of(point);
        for (std::int64_t x = -1; x <= 1; ++x)
            for (std::int64_t y = -1; y <= 1; ++y) {
                const Place first{{centre[0] + x, centre[1] + y, centre[2] - 1}, 0};
                for (auto at = std::lower_bound(places_.begin(), places_.end(), first);
                     at != places_.end() && at->first <= Cell{first.first[0], first.first[1], centre[2] + 1}; ++at)
                    if (pieces_[at->second].distance(point) <= distance) return true;
            }
        return false;
    }

private:
    using Cell = std::array<std::int64_t, 3>;
    using Place = std::pair<Cell, std::size_t>;

    [[nodiscard]] Cell cell_of(const Vec3& point) const {
        Cell cell;
        for (int k = 0; k < 3; ++k)
            cell[static_cast<std::size_t>(k)] = static_cast<std::int64_t>(std::floor(point[k] / width_));
        return cell;
    }

    const std::vector<Piece>& pieces_;
    double width_;
    std::vector<Place> places_;
};

double share_near(const std::vector<Piece>& pieces, const std::vector<Piece>& others, double distance) {
    const Grid grid(others, distance * (1 + 1 / pieces_a_tolerance));
    double near = 0, all = 0;
    for (const Piece& piece : pieces) {
        all += piece.length();
        if (grid.is_near(piece.middle(), distance)) near += piece.length();
    }
    return all > 0 ? near / all : 1;
}

}  // namespace

BoundaryScore compare_boundaries(const TriangleMesh& mesh, const std::vector<std::string>& labels,
                                 const std::vector<std::string>& truth, double tolerance) {
    const auto faces = static_cast<std::size_t>(mesh.input_face_count);
    if (labels.size() != faces || truth.size() != faces)
        throw UsageError("labels for " + std::to_string(labels.size()) + " faces and truth for " +
                         std::to_string(truth.size()) + " cannot be compared on a mesh of " + std::to_string(faces));
    if (mesh.triangles.empty()) return {};
    const double distance = tolerance * compute_used_bounds(mesh).diagonal();
    if (!(distance > 0)) return {};
    const double length = distance / pieces_a_tolerance;
    std::vector<Piece> borders, true_borders;
    const EdgeTable edges = build_edges(mesh.triangles, mesh.positions.size());
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto sides = edges[e];
        bool is_border = false, is_true_border = false, is_compared = true;
        const auto face_of = [&](std::int32_t half_edge) {
            return static_cast<std::size_t>(mesh.input_faces[static_cast<std::size_t>(half_edge / 3)]);
        };
        const std::size_t first = face_of(sides[0]);
        for (const std::int32_t side : sides) {
            const std::size_t face = face_of(side);
            is_compared &= !truth[face].empty() && truth[face] != "-";
            is_border |= labels[face] != labels[first];
            is_true_border |= truth[face] != truth[first];
        }
        if (!is_compared) continue;
        const auto& corners = mesh.triangles[static_cast<std::size_t>(sides[0] / 3)];
        const Vec3& from = mesh.positions[static_cast<std::size_t>(corners[static_cast<std::size_t>(sides[0] % 3)])];
        const Vec3& to =
            mesh.positions[static_cast<std::size_t>(corners[static_cast<std::size_t>((sides[0] % 3 + 1) % 3)])];
        if (is_border) cut(from, to, length, borders);
        if (is_true_border) cut(from, to, length, true_borders);
    }
    if (borders.empty() != true_borders.empty()) return {0, 0};
    return {share_near(borders, true_borders, distance), share_near(true_borders, borders, distance)};
}

}  // namespace partonomy
