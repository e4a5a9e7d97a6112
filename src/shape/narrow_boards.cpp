// Slats and the rail that they carry: boards in one plane, as thick as each other, told apart by how wide they are.
//
// Idea: the widths of a component's cells leave a gap where narrow boards end at wide ones, while widths that change
// step by step (triangles, discs, tapered boards) leave none. A piece on the narrow side of the gap is a board of its
// own when it is long, when it meets the wide one along its end and not along its side, when the wide one reaches
// farther to the sides there, and when the outline turns a corner between them: from some places of one the other is
// out of sight. The corner turned in is where people see a part end (the minima rule of Hoffman and Richards 1984).
// Nothing of it is in the paper, whose boards are rectangles. Cost: sorting the cells, O(n) for the borders, 36 rays a
// pair.

#include "shape/narrow_boards.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

namespace partonomy {

namespace {

constexpr double gap = 0.3, most_between = 0.1;  // of logarithms of widths; share of the smaller side within the gap
constexpr double least_narrow = 0.05;            // of a component's boards
constexpr double narrowest_end = 0.5, widest_end = 1.75, least_length = 1.5;  // of a narrow board, in widths
constexpr double along_side = 0.6;     // of its length: a border so long is a side
constexpr double least_hidden = 0.08;  // of a narrow board from its wide one, share of the lines of sight
constexpr double shoulders = 1.3;      // of the end of a narrow board: as wide is the wide one there

/// The border of two pieces, as far as it is needed to tell where it lies and how long it would be straight.
struct Border {
    double length = 0;
    Vec3 sum = Vec3::Zero();
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
};

using Borders = std::map<std::pair<std::int32_t, std::int32_t>, Border>;

/// The borders of boards, places as seen from `origin`.
Borders borders_between(const CellMap& m, const std::vector<std::int32_t>& piece_of, const Vec3& origin) {
    const Surface& s = m.surface;
    Borders borders;
    for (const std::int32_t i : m.component.triangles)
        for (std::size_t e = 0; e < 3; ++e) {
            const std::int32_t j = s.adjacency.neighbours[i][e];
            if (!m.is_own(j) || m.cell_of[j] == m.cell_of[i]) continue;
            const std::int32_t a = piece_of[m.cell_of[i]], b = piece_of[m.cell_of[j]];
            if (a == b || m.cells[a].kind != Solidity::board || m.cells[b].kind != Solidity::board) continue;
            const auto& corners = s.mesh.triangles[i];
            const Vec3 &from = s.mesh.positions[corners[e]], &to = s.mesh.positions[corners[(e + 1) % 3]];
            const Vec3 place = (from + to) / 2 - origin;
            Border& border = borders[std::minmax(a, b)];
            border.length += (to - from).norm();
            border.sum += (to - from).norm() * place;
            border.spread += (to - from).norm() * place * place.transpose();
        }
    return borders;
}

/// Whether the outline turns a corner between two pieces of a board: one is out of the other's sight for a good
/// part, unlike the tip of a triangle or of an ellipse.
bool is_corner_between(const CellMap& m, const std::vector<std::int32_t>& piece_of, std::int32_t a, std::int32_t b) {
    const Surface& s = m.surface;
    constexpr std::size_t samples = 6;
    const auto places = [&](std::int32_t piece) {
        std::vector<std::int32_t> seeds;
        for (std::size_t k = 0; k < piece_of.size(); ++k)
            if (piece_of[k] == piece) seeds.push_back(m.seeds[k]);
        std::vector<std::int32_t> some;
        for (std::size_t k = 0; k < samples; ++k) some.push_back(seeds[k * (seeds.size() - 1) / (samples - 1)]);
        return some;
    };
    const auto middle_of = [&](std::int32_t seed) {
        return Vec3(s.geometry.barycentres[seed] - s.geometry.normals[seed] * (s.thickness.distances[seed] / 2));
    };
    std::size_t hidden = 0;
    const std::vector<std::int32_t> others = places(b);
    for (const std::int32_t from : places(a))
        for (const std::int32_t to : others) {
            const Vec3 way = middle_of(to) - middle_of(from);
            const WallHit hit = s.scene->exit_wall({middle_of(from), way.normalized(), -1, from});
            hidden += hit.triangle >= 0 && hit.distance < way.norm() - s.thickness.distances[from] / 2;
        }
    return static_cast<double>(hidden) > least_hidden * samples * samples;
}

/// How far the board reaches along a direction beyond a piece, near a place.
double width_beyond(const CellMap& m, const std::vector<std::int32_t>& piece_of, std::int32_t piece, const Vec3& place,
                    const Vec3& along, double radius) {
    const Surface& s = m.surface;
    double low = 0, high = 0;
    for (const std::int32_t i : m.component.triangles) {
        const Vec3 way = s.geometry.barycentres[i] - place;
        if (way.squaredNorm() > radius * radius || piece_of[m.cell_of[i]] == piece) continue;
        low = std::min(low, way.dot(along));
        high = std::max(high, way.dot(along));
    }
    return high - low;
}

}  // namespace

bool tell_narrow_boards(std::vector<Cell>& cells) {
    struct Width {
        double log, area;
    };
    std::vector<Width> widths;
    double all = 0;
    for (const Cell& cell : cells)
        if (cell.kind == Solidity::board) {
            widths.push_back({std::log(cell.ratio), cell.area});
            all += cell.area;
        }
    std::ranges::sort(widths, {}, &Width::log);
    double below = 0;
    for (std::size_t i = 0; i + 1 < widths.size(); ++i) {
        below += widths[i].area;
        const double middle = (widths[i].log + widths[i + 1].log) / 2;
        double within = 0, within_below = 0;
        for (std::size_t k = i + 1; k-- > 0 && widths[k].log > middle - gap / 2;) within_below += widths[k].area;
        for (std::size_t k = i + 1; k < widths.size() && widths[k].log < middle + gap / 2; ++k)
            within += widths[k].area;
        const double narrow = below - within_below, wide = all - below - within;
        if (narrow < least_narrow * all || within + within_below > most_between * std::min(narrow, wide)) continue;
        for (Cell& cell : cells) cell.is_narrow = cell.kind == Solidity::board && std::log(cell.ratio) < middle;
        return true;
    }
    return false;
}

std::vector<PartedBoards> part_narrow_boards(const CellMap& m, const std::vector<std::int32_t>& sides, Sets& sets) {
    const Surface& s = m.surface;
    std::vector<PartedBoards> parted;
    std::vector<double> area(m.cells.size(), 0.0), width(m.cells.size(), 0.0);
    std::vector<std::int32_t> piece_of(m.cells.size());  // as it is before any are joined
    for (std::size_t a = 0; a < m.cells.size(); ++a) {
        const std::int32_t root = piece_of[a] = sets.find(static_cast<std::int32_t>(a));
        area[root] += m.cells[a].area;
        width[root] += m.cells[a].area * m.cells[a].ratio * m.cells[a].thickness;
    }
    std::vector<Vec3> centre(m.cells.size(), Vec3::Zero());
    for (const std::int32_t i : m.component.triangles)
        centre[piece_of[m.cell_of[i]]] += s.geometry.areas[i] * s.geometry.barycentres[i];
    const Vec3& origin = s.geometry.barycentres[m.component.triangles.front()];
    const Borders borders = borders_between(m, piece_of, origin);
    for (const auto& [pair, border] : borders) {
        const auto [a, b] = pair;
        if (sides[a] != sides[b]) continue;
        if (!(border.length > 0 && area[a] > 0 && area[b] > 0)) {
            sets.join(a, b);
            continue;
        }
        const bool is_first = width[a] / area[a] < width[b] / area[b];
        const std::int32_t slat = is_first ? a : b, rail = is_first ? b : a;
        const double narrow = width[slat] / area[slat];
        const double length = area[slat] / (2 * narrow);
        const Vec3 middle = border.sum / border.length;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(border.spread / border.length -
                                                                   middle * middle.transpose());
        // Cells make borders crooked: this long were they straight.
        const double end = std::sqrt(12 * std::max(0.0, eigen.eigenvalues()[2]));
        const Vec3 place = origin + middle;
        const Vec3 across = s.geometry.normals[m.seeds[rail]].cross(place - centre[slat] / area[slat]).normalized();
        if (end < narrowest_end * narrow || end > std::max(widest_end * narrow, along_side * length) ||
            length < least_length * narrow || !is_corner_between(m, piece_of, slat, rail) ||
            width_beyond(m, piece_of, slat, place, across, 1.5 * end) < shoulders * end)
            sets.join(a, b);
        else
            parted.emplace_back(slat, rail);
    }
    // What touches through the board only lies along it, too.
    for (std::size_t k = 0; k < m.cells.size(); ++k)
        for (const std::int32_t n : m.cells[k].neighbours)
            if (sides[k] == sides[n] && m.cells[k].kind == Solidity::board && m.cells[n].kind == Solidity::board &&
                !m.cells[k].is_junction && !m.cells[n].is_junction &&
                !borders.contains(std::minmax(piece_of[k], piece_of[n])))
                sets.join(piece_of[k], piece_of[n]);
    return parted;
}

}  // namespace partonomy
