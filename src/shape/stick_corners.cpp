// Whose the corner is where sticks meet.
//
// End to end. Cores end where the walls of the other stick begin to be seen, so filling leaves the corner cut anyhow.
// It belongs to the level one, as that of two boards does: what is above rests on it, what is below carries it. The
// border is the wall of the level stick that faces the other one, continued. A stick that goes on beyond the other has
// no corner to give away.
//
// End to side. Where a stick ends at another one as thick, it may as well go through it and halve it. Of the two halves
// and what lies between their walls, continued, one bar is made: it is simpler that one stick ends than that two do at
// the same place and in line (good continuation; Wertheimer 1923). Two sticks that cross stay as they are, and so do
// halves that a board lies across: a rear leg and a back post are two where the seat is.
//
// Cost: O(n), if there are such sticks.

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <span>

#include "base/quantile.h"
#include "shape/claims.h"

namespace partonomy {

namespace {

const double facing_cosine = std::cos(40 * std::numbers::pi / 180);
const double across_cosine = std::cos(60 * std::numbers::pi / 180);
constexpr double more_level = 0.3;   // difference of the cosines to `up`
constexpr double long_enough = 2;    // of its thickness is a stick with a direction
constexpr double most_beyond = 0.5;  // of the thickness of the other one: farther, and the stick goes on
constexpr double far_end = 0.02;     // of the area: what lies beyond is no end
constexpr double least_wall = 0.04;  // of the area

/// One stick: its triangles and the direction that none of its walls faces.
struct Stick {
    std::span<const std::int32_t> triangles;
    double area = 0;
    Vec3 axis = Vec3::Zero(), middle = Vec3::Zero();

    Stick(const Surface& s, std::span<const std::int32_t> members, const Core& core) : triangles(members) {
        Eigen::Matrix3d facing = Eigen::Matrix3d::Zero();
        for (const std::int32_t i : core.triangles)
            facing += s.geometry.areas[i] * s.geometry.normals[i] * s.geometry.normals[i].transpose();
        axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(facing).eigenvectors().col(0);
        for (const std::int32_t i : triangles) {
            area += s.geometry.areas[i];
            middle += s.geometry.areas[i] * s.geometry.barycentres[i];
        }
        middle /= area;
    }

    /// How far out the wall is that faces a direction.
    [[nodiscard]] std::optional<double> wall(const Surface& s, const Vec3& direction) const {
        std::vector<Weighted> facing;
        double sum = 0;
        for (const std::int32_t i : triangles)
            if (s.geometry.normals[i].dot(direction) > facing_cosine) {
                facing.emplace_back(s.geometry.barycentres[i].dot(direction), s.geometry.areas[i]);
                sum += s.geometry.areas[i];
            }
        if (sum < least_wall * area) return std::nullopt;
        return quantile(facing, 0.5);
    }

    /// How far it reaches along a direction.
    [[nodiscard]] double end(const Surface& s, const Vec3& direction) const {
        std::vector<Weighted> places;
        for (const std::int32_t i : triangles)
            places.emplace_back(s.geometry.barycentres[i].dot(direction), s.geometry.areas[i]);
        return quantile(places, 1 - far_end);
    }
};

/// Between two walls that face away from each other: where they are and how far apart.
struct Across {
    double near, far;  ///< along a direction, and against it
    [[nodiscard]] double thickness() const { return near + far; }
    [[nodiscard]] bool is_alike(const Across& other, double slack) const {
        return std::abs(near - other.near) < slack && std::abs(far - other.far) < slack;
    }
};

std::optional<Across> across(const Surface& s, const Stick& stick, const Vec3& direction) {
    const auto near = stick.wall(s, direction), far = stick.wall(s, -direction);
    if (!near || !far || !(*near + *far > 0)) return std::nullopt;
    return Across{*near, *far};
}

/// Draws the border of two sticks, of which the first is the level one, if they meet in a corner.
void draw_border(const Surface& s, const Stick& level, const Stick& other, std::int32_t own, std::int32_t others,
                 std::vector<std::int32_t>& part_of) {
    if (std::abs(level.axis.dot(other.axis)) > across_cosine) return;
    Vec3 to_other = (other.axis - other.axis.dot(level.axis) * level.axis).normalized();
    if ((other.middle - level.middle).dot(to_other) < 0) to_other = -to_other;
    Vec3 to_level = (level.axis - level.axis.dot(other.axis) * other.axis).normalized();
    if ((level.middle - other.middle).dot(to_level) < 0) to_level = -to_level;
    const auto walls = across(s, level, to_other), other_walls = across(s, other, to_level);
    if (!walls || !other_walls) return;
    if (other.end(s, to_other) - walls->near < long_enough * other_walls->thickness()) return;
    if (level.end(s, to_level) - other_walls->near < long_enough * walls->thickness()) return;
    if (other.end(s, -to_other) - walls->far > most_beyond * walls->thickness()) return;
    if (level.end(s, -to_level) - other_walls->far > most_beyond * other_walls->thickness()) return;
    for (const std::int32_t i : other.triangles)
        if (s.geometry.barycentres[i].dot(to_other) < walls->near) part_of[i] = own;
    for (const std::int32_t i : level.triangles)
        if (s.geometry.barycentres[i].dot(to_other) > walls->near &&
            s.geometry.barycentres[i].dot(to_level) < other_walls->near)
            part_of[i] = others;
}

/// The wall of a bar that a post stands on.
struct Ground {
    Vec3 up;       ///< out of the bar, along the post
    double place;  ///< of the wall along it
};

/// Where two pieces are the halves of a bar that a post cuts: the wall that it should stand on.
std::optional<Ground> ground_of_post(const Surface& s, const Stick& one, const Stick& other, const Stick& post) {
    constexpr double in_line = 0.95, alike = 0.25, roomy = 1.25, stout = 1.5;
    const Vec3 along = (other.middle - one.middle).normalized();
    if (std::abs(along.dot(one.axis)) < in_line || std::abs(along.dot(other.axis)) < in_line) return std::nullopt;
    if (std::abs(along.dot(post.axis)) > across_cosine) return std::nullopt;
    Vec3 up = (post.axis - post.axis.dot(along) * along).normalized();
    if ((post.middle - one.middle).dot(up) < 0) up = -up;
    const Vec3 side = along.cross(up);
    const auto height = across(s, one, up), other_height = across(s, other, up);
    const auto width = across(s, one, side), other_width = across(s, other, side), post_width = across(s, post, along);
    if (!height || !other_height || !width || !other_width || !post_width) return std::nullopt;
    const double thickness = std::max(height->thickness(), width->thickness());
    if (!height->is_alike(*other_height, alike * thickness) || !width->is_alike(*other_width, alike * thickness))
        return std::nullopt;
    if (post_width->thickness() > stout * thickness) return std::nullopt;
    if (-other.end(s, -along) - one.end(s, along) > roomy * post_width->thickness()) return std::nullopt;
    const double near = (height->near + other_height->near) / 2, far = (height->far + other_height->far) / 2;
    if (post.end(s, -up) - far > alike * thickness) return std::nullopt;  // it goes on beyond
    if (post.end(s, up) - near < long_enough * post_width->thickness()) return std::nullopt;
    return Ground{up, near};
}

/// The parts that are asked about, and which of them meet.
struct Meetings {
    Groups members;                                           ///< triangles of all parts
    std::set<std::pair<std::int32_t, std::int32_t>> borders;  ///< of parts that are asked about, the lower number first

    /// Looks at nothing where there are fewer than `least` such parts.
    template <class IsAsked>
    Meetings(const Surface& s, const Parts& parts, std::ptrdiff_t least, const IsAsked& is_asked) {
        const auto counts = [&](const Core& part) { return !part.triangles.empty() && is_asked(part); };
        if (std::ranges::count_if(parts.parts, counts) < least) return;
        borders = meeting_groups(s.adjacency, parts.part_of, s.threads);
        std::erase_if(borders, [&](const auto& pair) {
            return !counts(parts.parts[pair.first]) || !counts(parts.parts[pair.second]);
        });
        if (!borders.empty()) members = group_members(parts.part_of, parts.parts.size(), s.threads);
    }
};

/// Whether a board lies across the place where two halves meet: a rear leg and a back post, say, at the seat.
bool is_at_board(const Parts& parts, const Stick& one, const Stick& other) {
    constexpr double lies_across = 0.7;
    const Vec3 along = (other.middle - one.middle).normalized(), place = (one.middle + other.middle) / 2;
    const double reach = (other.middle - one.middle).norm() / 2;
    return std::ranges::any_of(parts.parts, [&](const Core& board) {
        if (board.kind != Solidity::board || !(board.half > 0)) return false;
        const double slope = board.normal.dot(along);
        if (std::abs(slope) < lies_across) return false;
        return std::abs((board.middle - place).dot(board.normal) / slope) < reach;
    });
}

}  // namespace

void join_halved_bars(const Surface& s, Parts& parts) {
    const Meetings meetings(s, parts, 3, [](const Core& core) { return core.kind != Solidity::board; });
    std::map<std::int32_t, std::set<std::int32_t>> around;
    for (const auto& [a, b] : meetings.borders) around[a].insert(b), around[b].insert(a);
    std::map<std::int32_t, Stick> sticks;  // of parts that did not change
    const auto stick_of = [&](std::int32_t k) -> const Stick& {
        const auto found = sticks.find(k);
        return found != sticks.end() ? found->second
                                     : sticks.try_emplace(k, s, meetings.members[k], parts.parts[k]).first->second;
    };
    std::vector<char> was_changed(parts.parts.size(), 0);
    for (const auto& [post, others] : around)
        for (const std::int32_t a : others)
            for (const std::int32_t b : others) {
                if (b <= a || was_changed[post] || was_changed[a] || was_changed[b]) continue;
                const Stick &one = stick_of(a), &other = stick_of(b), &between = stick_of(post);
                const auto ground = ground_of_post(s, one, other, between);
                if (!ground || is_at_board(parts, one, other)) continue;
                for (const std::int32_t i : between.triangles)
                    if (s.geometry.barycentres[i].dot(ground->up) < ground->place) parts.part_of[i] = a;
                for (const std::int32_t i : other.triangles) parts.part_of[i] = a;
                Core &whole = parts.parts[a], &half = parts.parts[b];
                whole.triangles.insert(whole.triangles.end(), half.triangles.begin(), half.triangles.end());
                whole.area += half.area;
                whole.kind = Solidity::stick;
                half.triangles.clear();
                half.area = 0;
                was_changed[post] = was_changed[a] = was_changed[b] = 1;
            }
}

void give_corners_to_level_sticks(const Surface& s, const Vec3& up, Parts& parts) {
    const Meetings meetings(s, parts, 2, [](const Core& core) { return core.kind == Solidity::stick; });
    for (const auto& [a, b] : meetings.borders) {
        const Stick first(s, meetings.members[a], parts.parts[a]), second(s, meetings.members[b], parts.parts[b]);
        const double rise = std::abs(first.axis.dot(up)) - std::abs(second.axis.dot(up));
        if (rise < -more_level) draw_border(s, first, second, a, b, parts.part_of);
        if (rise > more_level) draw_border(s, second, first, b, a, parts.part_of);
    }
}

}  // namespace partonomy
