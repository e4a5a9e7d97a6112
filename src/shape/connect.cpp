// Regions that hang together, over edges or through the solid. Pieces that come off their part go to a neighbour, and
// that may cut another part, so it is done again until nothing changes.

#include "shape/connect.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "shape/pieces.h"

namespace partonomy {

namespace {

constexpr double least_share = 1e-3;   // of the surface: smaller shells without a part stay without
constexpr double least_piece = 5e-3;   // of the surface: smaller pieces of parts are left to their neighbours,
constexpr double least_of_part = 0.2;  // and so are those much smaller than the part's largest piece

/// What pieces of one part are to each other. The two sides of a thin sheet within one shell are one through the solid,
/// as the floor of a mug and its underside are, or the panel of a door and what is seen of it from behind. A piece that
/// mostly faces itself is a solid of its own: a leg below the seat that its back post ends on.
struct Facing {
    Sets sheets;
    std::vector<char> is_solid;
};

Facing look_across(const Surface& s, const Adjacency& adjacency, const std::vector<std::int32_t>& part_of,
                   const std::vector<std::int32_t>& piece_of, std::size_t pieces) {
    constexpr double facing = 0.5;  // of a piece's area
    constexpr double thin = 0.15;   // of the piece's width
    Facing facing_of{Sets(pieces), std::vector<char>(pieces, 0)};
    Sets shells(pieces);
    for_each_range(piece_of.size(), s.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            for (const std::int32_t j : adjacency.neighbours[i])
                if (j >= 0 && piece_of[j] != piece_of[i]) shells.join(piece_of[i], piece_of[j]);
    });
    struct Faced {
        double area = 0, volume = 0;
    };
    std::vector<double> area(pieces, 0.0), own_area(pieces, 0.0);
    std::map<std::pair<std::int32_t, std::int32_t>, Faced> seen;
    const bool is_refined = part_of.size() != s.count();
    const auto caller = [&](std::size_t i) {
        return is_refined ? s.mesh.input_faces[i] : static_cast<std::int32_t>(i);
    };
    for (std::size_t i = 0; i < s.count(); ++i) {
        const std::int32_t own = caller(i), o = s.thickness.opposites[i];
        area[piece_of[own]] += s.geometry.areas[i];
        if (o < 0 || part_of[own] < 0) continue;
        const std::int32_t other = caller(static_cast<std::size_t>(o)), a = piece_of[own], b = piece_of[other];
        if (a == b) own_area[a] += s.geometry.areas[i];
        if (a == b || part_of[other] != part_of[own] || shells.find(a) != shells.find(b)) continue;
        Faced& faced = seen[{a, b}];
        faced.area += s.geometry.areas[i];
        faced.volume += s.geometry.areas[i] * s.thickness.distances[i];
    }
    for (const auto& [pair, faced] : seen) {
        const double whole = area[pair.first];
        if (faced.area > facing * whole && faced.volume < thin * faced.area * std::sqrt(whole))
            facing_of.sheets.join(pair.first, pair.second);
    }
    for (std::size_t k = 0; k < pieces; ++k) facing_of.is_solid[k] = own_area[k] > facing * area[k];
    return facing_of;
}

}  // namespace

void connect(const Surface& s, const TriangleMesh& mesh, const Adjacency& adjacency, const TriangleGeometry& geometry,
             std::vector<std::int32_t>& part_of) {
    const double total = sum(geometry.areas, s.threads);
    for (int round = 0; round < 8; ++round) {
        const auto& [piece_of, lowest] =
            find_pieces(adjacency, s.threads, [&](std::int32_t i, std::int32_t j) { return part_of[i] == part_of[j]; });
        std::int32_t parts = 0;
        std::vector<std::int32_t> owners;
        for (const std::int32_t first : lowest)
            if (const std::int32_t part = part_of[first]; part >= 0) {
                owners.push_back(part);
                parts = std::max(parts, part + 1);
            }
        std::sort(owners.begin(), owners.end());
        const bool is_whole = std::adjacent_find(owners.begin(), owners.end()) == owners.end();
        if (is_whole && owners.size() == lowest.size()) break;
        const Groups pieces = group_members(piece_of, lowest.size(), s.threads);
        std::vector<double> area(pieces.size(), 0.0);
        for_each_range(
            pieces.size(), s.threads,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k)
                    for (const std::int32_t i : pieces[k]) area[k] += geometry.areas[i];
            },
            16);
        Facing facing = is_whole ? Facing{Sets(pieces.size()), std::vector<char>(pieces.size(), 0)}
                                 : look_across(s, adjacency, part_of, piece_of, pieces.size());
        const auto set_of = [&](std::size_t piece) { return facing.sheets.find(static_cast<std::int32_t>(piece)); };
        std::vector<double> set_area(pieces.size(), 0.0);
        for (std::size_t k = 0; k < pieces.size(); ++k) set_area[set_of(k)] += area[k];
        std::vector<std::int32_t> largest(parts, -1);  // set of pieces
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            const std::int32_t part = part_of[pieces[k].front()];
            if (part >= 0 && (largest[part] < 0 || set_area[set_of(k)] > set_area[largest[part]]))
                largest[part] = set_of(k);
        }
        bool changed = false;
        const std::vector<std::int32_t> before = part_of;
        for (std::size_t k = 0; k < pieces.size(); ++k) {
            const std::int32_t part = before[pieces[k].front()];
            if (part >= 0 && largest[part] == set_of(k)) continue;
            std::vector<std::pair<std::int32_t, double>> borders;
            for (const std::int32_t i : pieces[k])
                for (int e = 0; e < 3; ++e) {
                    const std::int32_t j = adjacency.neighbours[i][e];
                    if (j < 0 || before[j] < 0 || before[j] == part) continue;
                    const auto& corners = mesh.triangles[i];
                    const double length = (mesh.positions[corners[e]] - mesh.positions[corners[(e + 1) % 3]]).norm();
                    auto at = std::find_if(borders.begin(), borders.end(),
                                           [&](const auto& x) { return x.first == before[j]; });
                    if (at == borders.end()) at = borders.insert(at, {before[j], 0.0});
                    at->second += length;
                }
            std::int32_t to = -1;
            const bool is_part = part >= 0 && facing.is_solid[k] != 0 && area[k] > least_piece * total &&
                                 area[k] > least_of_part * area[static_cast<std::size_t>(largest[part])];
            if (is_part) {
                to = parts++;
            } else if (!borders.empty()) {
                to = std::max_element(borders.begin(), borders.end(), [](const auto& a, const auto& b) {
                         return a.second != b.second ? a.second < b.second : a.first > b.first;
                     })->first;
            } else if (part >= 0 || area[k] > least_share * total) {
                to = parts++;
            } else {
                continue;
            }
            for (const std::int32_t i : pieces[k]) part_of[i] = to;
            changed = true;
        }
        if (!changed) break;
    }
}

}  // namespace partonomy
