// Pieces of one box that noise tore apart.
//
// Waves along a wall change the thickness of a part by as much as they are high, so the core of a thin leg ends where
// it grows thin and another one begins. Kinds, thicknesses and axes of such pieces say little. What says more is
// whether one box accounts for both: nearly all of their surface lies on its sides, no farther than noise reaches, and
// makes up nearly all of them. A dent that noise could have made is no border (minimum description length: one box
// instead of two, unless the second explains something).
//
// How far noise reaches is measured: half of the surface of a box lies within 0.67 standard deviations of its sides,
// if these are flat. Curved parts make it larger than it is. Cost: O(n), and one box of some hundred triangles a part
// and a border.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "base/quantile.h"
#include "base/ranges.h"
#include "shape/claims.h"

namespace partonomy {

namespace {

constexpr std::size_t enough = 400;                    // triangles of a part that are looked at
constexpr double deviations = 2.5;                     // farther out than so many is one part of a hundred
constexpr double half_within = 0.67449;                // standard deviations
constexpr double least_cover = 0.8, most_cover = 1.3;  // surface of the two over that of their box
constexpr double some_of_it = 0.5;   // of each may lie farther from the common box than noise reaches: where it is torn
constexpr double least_wall = 0.04;  // of the area: less facing one way is no wall
constexpr double end_quantile = 0.995;  // of the area: an end without a wall
const double facing_cosine = std::cos(50 * std::numbers::pi / 180);
const double alike_cosine = std::cos(25 * std::numbers::pi / 180);

/// A part, some of its triangles, and how far these are from the sides of its box.
struct Boxed {
    double area = 0, box_area = 0;
    std::vector<std::int32_t> some;
    std::vector<std::pair<double, double>> distances;  ///< and areas
};

/// Evenly fewer of them.
std::vector<std::int32_t> thin_out(const std::vector<std::int32_t>& triangles) {
    std::vector<std::int32_t> some;
    const std::size_t step = 1 + triangles.size() / enough;
    for (std::size_t k = step / 2; k < triangles.size(); k += step) some.push_back(triangles[k]);
    return some;
}

/// Three directions that the walls of a part face: that of most walls first, refined to the mean of what is near each.
Eigen::Matrix3d wall_axes(const Surface& s, const std::vector<std::int32_t>& triangles) {
    const auto most_faced = [&](const auto& direction_of) {
        constexpr std::size_t tries = 24;
        Vec3 best = Vec3::UnitZ();
        double most = -1;
        const std::size_t step = 1 + triangles.size() / tries;
        for (std::size_t k = 0; k < triangles.size(); k += step) {
            const Vec3 direction = direction_of(triangles[k]);
            double facing = 0;
            for (const std::int32_t t : triangles) {
                const double along = std::abs(s.geometry.normals[t].dot(direction));
                if (along > alike_cosine) facing += s.geometry.areas[t] * along;
            }
            if (facing > most) most = facing, best = direction;
        }
        return best;
    };
    Eigen::Matrix3d axes;
    axes.col(0) = most_faced([&](std::int32_t t) { return s.geometry.normals[t]; });
    axes.col(1) = most_faced([&](std::int32_t t) -> Vec3 {
        const Vec3 across = s.geometry.normals[t].cross(axes.col(0));
        return across.norm() > facing_cosine ? Vec3(axes.col(0).cross(across).normalized())
                                             : axes.col(0).unitOrthogonal();
    });
    for (int round = 0; round < 3; ++round) {
        axes.col(2) = axes.col(0).cross(axes.col(1));
        Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
        for (const std::int32_t t : triangles) {
            const Vec3 along = axes.transpose() * s.geometry.normals[t];
            Eigen::Index k = 0;
            along.cwiseAbs().maxCoeff(&k);
            sum.col(k) += (along[k] > 0 ? s.geometry.areas[t] : -s.geometry.areas[t]) * s.geometry.normals[t];
        }
        if (!(sum.col(0).squaredNorm() > 0 && sum.col(1).squaredNorm() > 0)) break;
        axes.col(0) = sum.col(0).normalized();
        axes.col(1) = (sum.col(1) - axes.col(0) * axes.col(0).dot(sum.col(1))).normalized();
    }
    axes.col(2) = axes.col(0).cross(axes.col(1));
    return axes;
}

/// The box whose sides are where the walls are; where there is no wall, it is where the part ends.
void put_in_box(const Surface& s, Boxed& part) {
    const Eigen::Matrix3d axes = wall_axes(s, part.some);
    double area = 0;
    for (const std::int32_t t : part.some) area += s.geometry.areas[t];
    Vec3 lengths = Vec3::Zero(), centre = Vec3::Zero();
    std::vector<std::pair<double, double>> places;
    for (int k = 0; k < 3; ++k) {
        std::array<double, 2> ends{};
        for (const int side : {0, 1}) {
            const Vec3 direction = (side == 0 ? -1 : 1) * axes.col(k);
            const auto collect = [&](double least_cosine) {
                places.clear();
                double sum = 0;
                for (const std::int32_t t : part.some)
                    if (s.geometry.normals[t].dot(direction) > least_cosine) {
                        places.emplace_back(s.geometry.barycentres[t].dot(direction), s.geometry.areas[t]);
                        sum += s.geometry.areas[t];
                    }
                return sum;
            };
            const bool is_wall = collect(facing_cosine) > least_wall * area;
            if (!is_wall) collect(-2);
            ends[side] = quantile(places, is_wall ? 0.5 : end_quantile);
        }
        lengths[k] = std::max(0.0, ends[0] + ends[1]);
        centre[k] = (ends[1] - ends[0]) / 2;
    }
    part.box_area = 2 * (lengths[0] * lengths[1] + lengths[1] * lengths[2] + lengths[2] * lengths[0]);
    for (const std::int32_t t : part.some) {
        const Vec3 along = axes.transpose() * s.geometry.normals[t];
        const Vec3 place = axes.transpose() * s.geometry.barycentres[t] - centre;
        const Vec3 outside = place.cwiseAbs() - lengths / 2;
        double nearest = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 3; ++k)
            if (along[k] * place[k] > facing_cosine * std::abs(place[k]))
                nearest = std::min(nearest, std::abs(outside[k]));
        part.distances.emplace_back(std::max({nearest, 0.0, outside.maxCoeff()}), s.geometry.areas[t]);
    }
}

/// Two parts as if they were one; its triangles are as dense in one as in the other.
Boxed put_in_one_box(const Surface& s, const Boxed& a, const Boxed& b) {
    Boxed both;
    both.area = a.area + b.area;
    const auto density = [](const Boxed& part) { return static_cast<double>(part.some.size()) / part.area; };
    const double least = std::min(density(a), density(b));
    for (const Boxed* part : {&a, &b})
        for (double k = 0; k < static_cast<double>(part->some.size()); k += density(*part) / least)
            both.some.push_back(part->some[static_cast<std::size_t>(k)]);
    std::ranges::sort(both.some);
    put_in_box(s, both);
    return both;
}

/// How much of a part is farther than `limit` from the sides of a box that holds it and another one.
double share_beyond(const Boxed& both, const Boxed& part, double limit) {
    double all = 0, out = 0;
    for (std::size_t k = 0; k < both.some.size(); ++k) {
        if (!std::ranges::binary_search(part.some, both.some[k])) continue;
        const auto& [distance, area] = both.distances[k];
        all += area;
        if (distance > limit) out += area;
    }
    return all > 0 ? out / all : 1;
}

/// The standard deviation of the surface from the sides of the boxes, if it is noise.
double measure_noise(const std::vector<Boxed>& parts) {
    std::vector<std::pair<double, double>> all;
    double total = 0, sum = 0;
    for (const Boxed& part : parts) {
        double own = 0;
        for (const auto& [distance, area] : part.distances) own += area;
        for (const auto& [distance, area] : part.distances) all.emplace_back(distance, area * part.area / own);
        total += part.area;
    }
    std::ranges::sort(all);
    for (const auto& [distance, area] : all)
        if ((sum += area) >= total / 2) return distance / half_within;
    return 0;
}

/// Two parts in one box.
struct Union {
    Boxed both;
    double beyond = 1;  ///< share of the part that it suits less that is farther from it than noise reaches
};

Union join(const Surface& s, const Boxed& a, const Boxed& b, double limit) {
    Union result{put_in_one_box(s, a, b)};
    const double cover = result.both.area / result.both.box_area;
    if (cover > least_cover && cover < most_cover)
        result.beyond = std::max(share_beyond(result.both, a, limit), share_beyond(result.both, b, limit));
    return result;
}

using Pair = std::pair<std::int32_t, std::int32_t>;

}  // namespace

void rejoin_torn_parts(const Surface& s, Parts& parts) {
    const std::size_t count = parts.parts.size();
    std::vector<std::vector<std::int32_t>> members(count);
    std::set<Pair> borders;
    std::vector<Boxed> boxed(count);
    for (std::size_t i = 0; i < s.count(); ++i) {
        const std::int32_t own = parts.part_of[i];
        if (own < 0) continue;
        members[own].push_back(static_cast<std::int32_t>(i));
        boxed[own].area += s.geometry.areas[i];
        for (const std::int32_t j : s.adjacency.neighbours[i])
            if (j >= 0 && parts.part_of[j] > own) borders.emplace(own, parts.part_of[j]);
    }
    if (borders.empty()) return;
    const auto for_each_of = [&](std::size_t things, const auto& work) {
        for_each_range(
            things, s.threads,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k) work(k);
            },
            1);
    };
    for_each_of(count, [&](std::size_t k) {
        if (members[k].empty()) return;
        boxed[k].some = thin_out(members[k]);
        put_in_box(s, boxed[k]);
    });
    const double limit = deviations * measure_noise(boxed);
    std::map<Pair, Union> unions;
    for (;;) {
        std::vector<Pair> untried;
        std::ranges::copy_if(borders, std::back_inserter(untried), [&](Pair pair) { return !unions.contains(pair); });
        std::vector<Union> tried(untried.size());
        for_each_of(untried.size(), [&](std::size_t k) {
            tried[k] = join(s, boxed[untried[k].first], boxed[untried[k].second], limit);
        });
        for (std::size_t k = 0; k < untried.size(); ++k) unions.emplace(untried[k], std::move(tried[k]));
        const auto best = std::ranges::min_element(unions, {}, [](const auto& entry) { return entry.second.beyond; });
        if (best == unions.end() || best->second.beyond > some_of_it) return;
        auto [to, from] = best->first;
        if (boxed[to].area < boxed[from].area) std::swap(to, from);
        for (std::int32_t& part : parts.part_of)
            if (part == from) part = to;
        boxed[to] = std::move(best->second.both);
        std::set<Pair> left;
        for (auto [a, b] : borders) {
            if (a == from) a = to;
            if (b == from) b = to;
            if (a != b) left.insert(std::minmax(a, b));
        }
        borders = std::move(left);
        std::erase_if(unions, [&](const auto& entry) {
            const auto [a, b] = entry.first;
            return a == to || a == from || b == to || b == from;
        });
    }
}

}  // namespace partonomy
