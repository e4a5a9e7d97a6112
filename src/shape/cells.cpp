// What sampled triangles see around them.
//
// Idea: from the middle between its two walls a seed looks along the walls, in eight directions to both sides: the
// shortest way across tells how narrow the part is there, the longest how far it runs. Each seed stands for the patch
// of walls around it, its cell. Sticks whose walls are slanted are looked at from the middle of the stick. Cost: 16
// rays a seed, 24 seeds and more a component, 1,000 or so in all.

#include "shape/cells.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/ranges.h"

namespace partonomy {

namespace {

const double square_cosine = std::cos(35 * std::numbers::pi / 180);
constexpr double cell_area = 0.2;  // of thickness squared: as fine as cells get
constexpr double fewest_cells = 24;
constexpr double triangles_a_cell = 25;  // on average, but at least and at most so many cells in all:
constexpr double least_cells = 100, most_cells = 1000;

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

}  // namespace

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

}  // namespace partonomy
