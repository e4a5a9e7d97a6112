// A box by its walls: directions that most of the surface faces, sides at the middle of what faces each.

#include "shape/wall_box.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "base/quantile.h"
#include "base/ranges.h"
#include "shape/pieces.h"

namespace partonomy {

namespace {

constexpr std::size_t enough = 400;      // triangles of a part that are looked at
constexpr double deviations = 2.5;       // farther out than so many is one part of a hundred
constexpr double half_within = 0.67449;  // standard deviations
constexpr double least_wall = 0.04;      // of the area: less facing one way is no wall
constexpr double end_quantile = 0.995;   // of the area: an end without a wall
const double facing_cosine = std::cos(50 * std::numbers::pi / 180);
const double alike_cosine = std::cos(25 * std::numbers::pi / 180);

/// Evenly fewer of them.
std::vector<std::int32_t> thin_out(std::span<const std::int32_t> triangles) {
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

}  // namespace

Boxed put_in_box(const Surface& s, std::vector<std::int32_t> some, double area) {
    Boxed part{area, std::move(some), {}, {}};
    part.box.axes = wall_axes(s, part.some);
    double weight = 0;
    for (const std::int32_t t : part.some) weight += s.geometry.areas[t];
    Vec3 middle = Vec3::Zero();
    std::vector<std::pair<double, double>> places;
    for (int k = 0; k < 3; ++k) {
        std::array<double, 2> ends{};
        for (const int side : {0, 1}) {
            const Vec3 direction = (side == 0 ? -1 : 1) * part.box.axes.col(k);
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
            const bool is_wall = collect(facing_cosine) > least_wall * weight;
            if (!is_wall) collect(-2);
            ends[side] = quantile(places, is_wall ? 0.5 : end_quantile);
        }
        part.box.lengths[k] = std::max(0.0, ends[0] + ends[1]);
        middle[k] = (ends[1] - ends[0]) / 2;
    }
    part.box.centre = part.box.axes * middle;
    for (const std::int32_t t : part.some) {
        const Vec3 along = part.box.axes.transpose() * s.geometry.normals[t];
        const Vec3 place = part.box.place(s.geometry.barycentres[t]);
        const Vec3 outside = place.cwiseAbs() - part.box.lengths / 2;
        double nearest = std::numeric_limits<double>::infinity();
        for (int k = 0; k < 3; ++k)
            if (along[k] * place[k] > facing_cosine * std::abs(place[k]))
                nearest = std::min(nearest, std::abs(outside[k]));
        part.distances.emplace_back(std::max({nearest, 0.0, outside.maxCoeff()}), s.geometry.areas[t]);
    }
    return part;
}

Boxed box_of_part(const Surface& s, std::span<const std::int32_t> triangles) {
    double area = 0;
    for (const std::int32_t t : triangles) area += s.geometry.areas[t];
    return put_in_box(s, thin_out(triangles), area);
}

std::vector<Boxed> boxes_of_parts(const Surface& s, std::span<const std::int32_t> part_of, std::size_t parts) {
    const Groups members = group_members(part_of, parts, s.threads);
    std::vector<Boxed> boxed(parts);
    for_each_range(
        parts, s.threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k)
                if (!members[k].empty()) boxed[k] = box_of_part(s, members[k]);
        },
        1);
    return boxed;
}

Boxed put_in_one_box(const Surface& s, const Boxed& a, const Boxed& b) {
    std::vector<std::int32_t> some;
    const auto density = [](const Boxed& part) { return static_cast<double>(part.some.size()) / part.area; };
    const double least = std::min(density(a), density(b));
    for (const Boxed* part : {&a, &b})
        for (double k = 0; k < static_cast<double>(part->some.size()); k += density(*part) / least)
            some.push_back(part->some[static_cast<std::size_t>(k)]);
    std::ranges::sort(some);
    return put_in_box(s, std::move(some), a.area + b.area);
}

double reach_of_noise(const std::vector<Boxed>& parts) {
    std::vector<Weighted> all;
    for (const Boxed& part : parts) {
        double own = 0;
        for (const auto& [distance, area] : part.distances) own += area;
        if (!(own > 0)) continue;
        for (const auto& [distance, area] : part.distances) all.emplace_back(distance, area * part.area / own);
    }
    return all.empty() ? 0 : deviations * quantile(all, 0.5) / half_within;
}

}  // namespace partonomy
