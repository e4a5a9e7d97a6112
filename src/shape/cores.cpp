// The sure part of each part.
//
// Idea: two triangles belong together when they are walls of the same thickness side by side, or opposite each other. A
// triangle is a wall when its inward ray meets a triangle that looks the other way. Neighbouring walls of alike
// thickness are joined unless a concave crease runs between them, and each is joined with its opposite; connected sets
// are found by union-find, so no seed and no order is involved. At a joint of two parts the ray runs into the other
// part, so the thickness jumps and the set ends by itself. What remains is taken apart in a second way:
//
// A set that is a plain slab, bar or block is a core as it is (plain_pieces.cpp).
//
// Any other set may still be a comb: back posts as thick as the backrest they carry. Sampled triangles therefore look
// around from the middle between their two walls, along the walls: a stick is as narrow as thick, a board wider than
// twice its thickness, and where it is far narrower than thick the walls are the two ends of something thin (the rim of
// a seat faces the other rim across the whole seat) and no core (cells.cpp). A set is cut between board and stick,
// where sticks of different directions meet (divide.cpp), and where narrow boards end at a wide one
// (narrow_boards.cpp).
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

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>

#include "base/ranges.h"
#include "shape/divide.h"
#include "shape/pieces.h"
#include "shape/plain_pieces.h"

namespace partonomy {

namespace {

const double parallel_cosine = std::cos(30 * std::numbers::pi / 180);
const double slanted_cosine = std::cos(65 * std::numbers::pi / 180);
const double crease_cosine = std::cos(30 * std::numbers::pi / 180);
constexpr double odd_thickness = 1.8;
constexpr double least_share = 1e-3;        // of the whole surface: less is no part
constexpr std::size_t least_triangles = 4;  // of a component

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
    const Pieces pieces = number_sets(sets, count, s.threads, [&](std::int32_t i) { return wall[i] != 0; });
    const Groups groups = group_members(pieces.piece_of, pieces.size(), s.threads);
    std::vector<std::size_t> large;
    for (std::size_t k = 0; k < groups.size(); ++k)
        if (groups[k].size() >= least_triangles) large.push_back(k);
    std::vector<Core> components(large.size());
    for_each_range(
        large.size(), s.threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                const auto triangles = groups[large[k]];
                components[k].triangles.assign(triangles.begin(), triangles.end());
                for (const std::int32_t i : triangles) components[k].area += s.geometry.areas[i];
            }
        },
        16);
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
    std::vector<std::vector<std::int32_t>> seeds(components.size());  // of what is not plain
    for_each_range(
        components.size(), s.threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) {
                Core& component = components[k];
                component.thickness = median_thickness(s, component.triangles);
                if (too_small(component)) {
                    component.triangles.clear();
                    continue;
                }
                drop_odd_thickness(s, component, slanted);
                if (!slanted) plain[k] = as_plain_piece(s, component.triangles, component.thickness, component.area);
                if (!plain[k]) seeds[k] = choose_seeds(s, component, total_area);
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
        sampled.push_back({std::move(component), std::move(seeds[k]), {}});
    }
    look_around(s, sampled, slanted);
    Division division(s, sampled);
    std::vector<std::vector<Core>> divided(sampled.size());
    for_each_range(
        sampled.size(), s.threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                divide_component(s, slanted, division, k, std::move(sampled[k]), divided[k]);
        },
        1);
    for (std::vector<Core>& found : divided) std::ranges::move(found, std::back_inserter(cores));
    std::erase_if(cores, [&](const Core& core) { return core.kind == Solidity::unknown || too_small(core); });
    return cores;
}

/// Whether what is a stick here and there is one on the whole: noise joins walls that have nothing to do with each
/// other.
bool is_slim(const Surface& s, const Core& stick) {
    const double widest = s.grain > 0 ? 0.8 : 1.2;  // thicknesses from the axis, as root of the mean square
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
    const double total = sum(s.geometry.areas, s.threads);
    std::vector<char> taken(s.count(), 0);
    std::vector<Core> cores = divide(s, find_components(s, taken, {parallel_cosine, 1.25}), total, 1, false);
    for (const Core& core : cores)
        for (const std::int32_t i : core.triangles) taken[i] = 1;
    // Walls that are not parallel, such as those of a stick with three sides, in what is left.
    const double least_cubes = s.grain > 0 ? 2 : 4;  // surface in squares of the thickness; noise takes some away
    for (Core& core : divide(s, find_components(s, taken, {slanted_cosine, 4}), total, least_cubes, true))
        if (core.kind == Solidity::stick && is_slim(s, core)) cores.push_back(std::move(core));
    std::stable_sort(cores.begin(), cores.end(), [](const Core& a, const Core& b) { return a.area > b.area; });
    Cores result{std::move(cores), std::vector<std::int32_t>(s.count(), -1)};
    for (std::size_t k = 0; k < result.cores.size(); ++k)
        for (const std::int32_t i : result.cores[k].triangles) result.core_of[i] = static_cast<std::int32_t>(k);
    return result;
}

}  // namespace partonomy
