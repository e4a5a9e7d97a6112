// Parts that are one after all.
//
// A part that faces another one for a good deal of its area lies across it in the same solid: two walls of one leg.
// Where a concave crease is between them the way must not be longer than a part is thick: a rail under a floor faces
// the floor's upper side through both. Two
// sticks are one when they are in line and pass into each other over most of their common border, without a concave
// crease; when one of them is a stump without a direction and they lie to both sides of a ring, like two halves of a
// stick that was sawn through; or when they lie in the same place, as do the two pairs of walls of a stick whose edges
// noise has torn open. What runs around, as a rim does, is in line with nothing on the whole; it is asked where the two
// meet. They stay two where the thick one ends with a shoulder, as the handle of a screwdriver does: a
// taper changes little in a short way. Two boards are one when they lie in the same plane and pass into each other, as
// a board does whose one wall is parted by what stands on it. Whatever their kind, two parts without a dent between
// them are one when each lies behind the surface of the other: a drum, its lid and its wall, is a convex solid, and
// people see parts where a surface bends inward (the minima rule of Hoffman and Richards 1984).
//
// Noise tears more. Then a piece of a stick also joins the one whose line it continues, whatever creases the noise has
// made between them, and a bulge of a board joins the board that is all around it. Cost: O(n) a round; a round joins at
// least one pair.

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <numbers>

#include "base/ranges.h"
#include "shape/claims.h"
#include "shape/sets.h"

namespace partonomy {

namespace {

/// Something for each pair of parts; neighbouring triangles mostly ask for the same one.
template <class Value>
struct PairMap {
    using Key = std::pair<std::int32_t, std::int32_t>;
    std::map<Key, Value> all;

    Value& at(std::int32_t a, std::int32_t b) {
        if (last == nullptr || last->first != Key(a, b)) last = &*all.try_emplace({a, b}).first;
        return last->second;
    }
    void operator+=(const PairMap& other) {
        for (const auto& [pair, value] : other.all) at(pair.first, pair.second) += value;
    }

private:
    std::pair<const Key, Value>* last = nullptr;
};

/// Where each part is and which way it runs.
struct Lie {
    Vec3 middle = Vec3::Zero(), axis = Vec3::Zero();
    double length = 0, breadth = 0;  ///< along the axis, and most across it
    Vec3 inside = Vec3::Zero();      ///< mean of the points halfway between its walls

    /// Whether it runs around, as a ring does, so that the axis is none of a stick.
    [[nodiscard]] bool runs_around(double thickness) const {
        constexpr double broad = 0.5, broader_than_thick = 2;
        return breadth > broad * length && breadth > broader_than_thick * thickness;
    }
};

/// What the lie of a part follows from.
struct LieSums {
    double area = 0, walls = 0;
    Vec3 sum = Vec3::Zero(), inside = Vec3::Zero();
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();

    void operator+=(const LieSums& other) {
        area += other.area;
        walls += other.walls;
        sum += other.sum;
        inside += other.inside;
        spread += other.spread;
    }
    [[nodiscard]] Lie lie() const {
        Lie result;
        if (!(area > 0)) return result;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(spread / area -
                                                                   sum * sum.transpose() / (area * area));
        result.middle = sum / area;
        result.axis = eigen.eigenvectors().col(2);
        result.length = std::sqrt(12 * std::max(0.0, eigen.eigenvalues()[2]));  // of a straight line
        result.breadth = std::sqrt(12 * std::max(0.0, eigen.eigenvalues()[1]));
        result.inside = walls > 0 ? Vec3(inside / walls) : result.middle;
        return result;
    }
};

std::vector<Lie> lies(const Surface& s, const Parts& parts) {
    const auto of_blocks = map_blocks(s.count(), s.threads, [&](std::size_t begin, std::size_t end) {
        std::vector<LieSums> sums(parts.parts.size());
        for (std::size_t i = begin; i < end; ++i) {
            const std::int32_t k = parts.part_of[i];
            if (k < 0) continue;
            const Vec3& b = s.geometry.barycentres[i];
            const double area = s.geometry.areas[i];
            sums[k].area += area;
            sums[k].sum += area * b;
            sums[k].spread += area * b * b.transpose();
            const std::int32_t o = s.thickness.opposites[i];
            if (o < 0 || parts.part_of[o] != k) continue;
            sums[k].walls += area;
            sums[k].inside += area * (b - s.geometry.normals[i] * (s.thickness.distances[i] / 2.0));
        }
        return sums;
    });
    std::vector<LieSums> all(parts.parts.size());
    for (const std::vector<LieSums>& some : of_blocks)
        for (std::size_t k = 0; k < all.size(); ++k) all[k] += some[k];
    std::vector<Lie> result;
    for (const LieSums& sums : all) result.push_back(sums.lie());
    return result;
}

/// The common border of two parts.
struct Border {
    double smooth = 0;                 ///< length without a concave crease
    Vec3 start_to_end = Vec3::Zero();  ///< sum of the edges; none for rings
    Vec3 sum = Vec3::Zero(), turn = Vec3::Zero();
    double length = 0;

    void add(const Vec3& from, const Vec3& to) {
        const double edge = (to - from).norm();
        start_to_end += to - from;
        sum += edge * (from + to) / 2;
        turn += from.cross(to);
        length += edge;
    }
    void operator+=(const Border& other) {
        smooth += other.smooth;
        start_to_end += other.start_to_end;
        sum += other.sum;
        turn += other.turn;
        length += other.length;
    }
    [[nodiscard]] Vec3 centre() const { return sum / length; }
    /// Across the ring, as long as what it encloses is large.
    [[nodiscard]] Vec3 area() const { return (turn - centre().cross(start_to_end)) / 2; }
};

/// Whether a piece too short to have a direction and another one lie to either side of a ring, as the halves of a stick
/// do that was sawn through.
bool is_sawn(const Border& border, const Lie& a, const Lie& b, double thickness) {
    constexpr double straight = 0.85, least_section = 0.3, stump = 2;
    const Vec3 area = border.area();
    if (std::min(a.length, b.length) > stump * thickness) return false;
    if (area.norm() < least_section * thickness * thickness) return false;
    const Vec3 to_a = (a.middle - border.centre()).normalized(), to_b = (b.middle - border.centre()).normalized();
    const double along_a = to_a.dot(area.normalized()), along_b = to_b.dot(area.normalized());
    return along_a * along_b < 0 && std::min(std::abs(along_a), std::abs(along_b)) > straight;
}

constexpr double noise_of_thickness = 1.5;  // ratio of thicknesses that noise alone makes

/// Whether a piece of a stick lies where the line of a longer one goes on, and their sections meet: all of them where
/// the two are not alike in thickness.
bool goes_on(const Border& border, const Lie& piece, const Lie& stick, double thin, double thick) {
    constexpr double beside = 0.35, across = 0.7, least_section = 0.3, least_alike = 0.1, stump = 2, in_line = 0.5;
    if (piece.length > stump * thick && std::abs(piece.axis.dot(stick.axis)) < in_line) return false;  // the bar of a T
    const Vec3 area = border.area();
    const bool is_alike = thick < noise_of_thickness * thin;
    if (area.norm() < (is_alike ? least_alike * thin * thin : least_section * thick * thick)) return false;
    if (std::abs(area.dot(stick.axis)) < across * area.norm()) return false;
    const Vec3 way = piece.inside - stick.inside;
    return (way - way.dot(stick.axis) * stick.axis).norm() < beside * thick + 0.1 * way.norm();
}

/// Whether the border is nearly a whole section of a stick of this length and surface.
bool is_section(const Border& border, const Lie& lie, double surface) {
    constexpr double least = 0.35;  // of a circle as long around as the stick
    const double around = surface / lie.length;
    return border.area().norm() > least * around * around / (4 * std::numbers::pi);
}

/// Whether the ring between a thin piece and a thick one is the foot of something thin: the thick one ends there, or
/// goes on beside it.
bool is_step(const Border& border, double thin, double thick) {
    constexpr double closed = 0.2, least_section = 0.4;
    return thick > noise_of_thickness * thin && border.start_to_end.norm() < closed * border.length &&
           border.area().norm() < least_section * thick * thick;
}

/// Whether two sticks lie in the same place, as do the two pairs of walls of one stick.
bool is_same_place(const Lie& a, const Lie& b, double thickness) {
    constexpr double long_enough = 1.5, beside = 0.35, straight = 0.9;
    if (std::min(a.length, b.length) < long_enough * thickness || std::abs(a.axis.dot(b.axis)) < straight) return false;
    const Vec3 way = b.inside - a.inside;
    const double along = way.dot(b.axis);
    return (way - along * b.axis).norm() < beside * thickness && std::abs(along) < (a.length + b.length) / 4;
}

/// Whether a stick ends with a shoulder where a long and much thinner one goes on, as the handle of a screwdriver does:
/// so near to their border that a taper changes little, one is twice as far from the common axis as the other.
bool is_shouldered(const Surface& s, const Parts& parts, const Border& common, std::int32_t a, std::int32_t b,
                   const Lie& lie_a, const Lie& lie_b) {
    constexpr double unlike = 1.8, twice = 2, long_enough = 4, nearest = 0.5, farthest = 2;
    const bool a_is_thin = parts.parts[a].thickness < parts.parts[b].thickness;
    const double thin = parts.parts[a_is_thin ? a : b].thickness, thick = parts.parts[a_is_thin ? b : a].thickness;
    const Lie &slim = a_is_thin ? lie_a : lie_b, &stout = a_is_thin ? lie_b : lie_a;
    if (thick < unlike * thin || slim.length < long_enough * thin) return false;
    const Vec3 centre = common.centre(),
               axis = slim.axis.dot(slim.middle - stout.middle) > 0 ? slim.axis : Vec3(-slim.axis);
    struct Around {
        double area = 0, radius = 0;
    };
    const auto mean_radius = [&](std::int32_t part, double side) {
        const auto of_blocks = map_blocks(s.count(), s.threads, [&](std::size_t begin, std::size_t end) {
            Around some;
            for (std::size_t i = begin; i < end; ++i) {
                if (parts.part_of[i] != part || std::abs(s.geometry.normals[i].dot(axis)) > 0.5) continue;
                const Vec3 way = s.geometry.barycentres[i] - centre;
                const double along = way.dot(axis);
                if (side * along < nearest * thin || side * along > farthest * thin) continue;
                some.area += s.geometry.areas[i];
                some.radius += s.geometry.areas[i] * (way - along * axis).norm();
            }
            return some;
        });
        Around all;
        for (const Around& some : of_blocks) all.area += some.area, all.radius += some.radius;
        return all.area > 0 ? all.radius / all.area : 0;
    };
    const double beyond = mean_radius(a_is_thin ? a : b, 1), before = mean_radius(a_is_thin ? b : a, -1);
    return beyond > 0 && before > twice * beyond;
}

bool is_in_line(const Vec3& axis, const Vec3& other) { return std::abs(axis.dot(other)) > 0.8; }

/// Which way a part runs near a place on it: its walls there face across that.
Vec3 direction_near(const Surface& s, const Parts& parts, std::int32_t part, const Vec3& place) {
    constexpr double near = 2;  // thicknesses
    const double reach = near * parts.parts[part].thickness;
    const auto of_blocks = map_blocks(s.count(), s.threads, [&](std::size_t begin, std::size_t end) {
        Eigen::Matrix3d some = Eigen::Matrix3d::Zero();
        for (std::size_t i = begin; i < end; ++i)
            if (parts.part_of[i] == part && (s.geometry.barycentres[i] - place).squaredNorm() < reach * reach)
                some += s.geometry.areas[i] * s.geometry.normals[i] * s.geometry.normals[i].transpose();
        return some;
    });
    Eigen::Matrix3d facing = Eigen::Matrix3d::Zero();
    for (const Eigen::Matrix3d& some : of_blocks) facing += some;
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(facing).eigenvectors().col(0);
}

/// The rings that the common border of two parts consists of, the longest first: halves of a ring meet at two places.
std::vector<Border> rings(const Surface& s, const Parts& parts, std::int32_t a, std::int32_t b) {
    using Edge = std::array<std::int32_t, 2>;
    const auto of_blocks = map_blocks(s.count(), s.threads, [&](std::size_t begin, std::size_t end) {
        std::vector<Edge> some;
        for (std::size_t i = begin; i < end; ++i) {
            if (parts.part_of[i] != a) continue;
            const auto& corners = s.mesh.triangles[i];
            for (int e = 0; e < 3; ++e)
                if (const std::int32_t j = s.adjacency.neighbours[i][e]; j >= 0 && parts.part_of[j] == b)
                    some.push_back({corners[e], corners[(e + 1) % 3]});
        }
        return some;
    });
    std::map<std::int32_t, std::int32_t> number;  // of vertices
    for (const std::vector<Edge>& some : of_blocks)
        for (const Edge& edge : some)
            for (const std::int32_t v : edge) number.try_emplace(v, static_cast<std::int32_t>(number.size()));
    Sets sets(number.size());
    for (const std::vector<Edge>& some : of_blocks)
        for (const Edge& edge : some) sets.join(number[edge[0]], number[edge[1]]);
    std::map<std::int32_t, Border> of_set;
    for (const std::vector<Edge>& some : of_blocks)
        for (const Edge& edge : some)
            of_set[sets.find(number[edge[0]])].add(s.mesh.positions[edge[0]], s.mesh.positions[edge[1]]);
    std::vector<Border> all;
    for (const auto& [set, ring] : of_set) all.push_back(ring);
    std::ranges::stable_sort(all, std::greater<>(), &Border::length);
    return all;
}

/// Whether two sticks, of which one runs around, run the same way wherever they meet: the longest way across a ring is
/// the way of nothing.
bool are_in_line_where_they_meet(const Surface& s, const Parts& parts, std::int32_t a, std::int32_t b) {
    constexpr double least = 0.25;  // of the longest ring: less is a flaw of it
    const std::vector<Border> all = rings(s, parts, a, b);
    return std::ranges::all_of(all, [&](const Border& ring) {
        return ring.length < least * all.front().length ||
               is_in_line(direction_near(s, parts, a, ring.centre()), direction_near(s, parts, b, ring.centre()));
    });
}

using Borders = PairMap<Border>;

/// Whether a board lies across the place where two sticks in line meet, as the seat does where a rear leg becomes a
/// back post.
bool is_crossed(const Parts& parts, const Borders& borders, std::int32_t a, std::int32_t b, const Border& common,
                const Vec3& axis) {
    constexpr double across = 0.7;
    if (parts.parts[a].cut >= 0 && parts.parts[a].cut == parts.parts[b].cut) return true;
    for (std::size_t k = 0; k < parts.parts.size(); ++k) {
        const Core& board = parts.parts[k];
        if (board.kind != Solidity::board || !(board.half > 0) || std::abs(axis.dot(board.normal)) < across) continue;
        if (std::abs((common.centre() - board.middle).dot(board.normal)) > board.half) continue;
        const auto number = static_cast<std::int32_t>(k);
        if (borders.all.contains({a, number}) && borders.all.contains({b, number})) return true;
    }
    return false;
}

/// Whether the middle of a part lies between the walls of a board, continued.
bool is_within(const Lie& lie, const Core& board) {
    return board.half > 0 && std::abs((lie.middle - board.middle).dot(board.normal)) < 0.75 * board.half;
}

/// Whether two boards were parted because one is narrower than the other.
bool are_unlike_in_width(const Core& a, const Core& b) {
    constexpr double alike = 1.3;
    const auto [narrow, wide] = std::minmax(a.width, b.width);
    return a.family >= 0 && a.family == b.family && wide > alike * narrow;
}

/// Whether two boards lie in the same plane and pass into each other.
bool is_same_board(const Border& border, const Core& a, const Core& b, const Lie& lie_a, const Lie& lie_b) {
    constexpr double parallel = 0.9, wide_enough = 2;
    if (border.smooth < wide_enough * (a.thickness + b.thickness) / 2) return false;
    if (std::abs(a.normal.dot(b.normal)) < parallel) return false;
    const Vec3 way = lie_b.inside - lie_a.inside;
    const double reach = 0.1 * way.norm() + std::max(a.thickness, b.thickness) / 2;
    return std::abs(way.dot(b.normal)) < reach && std::abs(way.dot(a.normal)) < reach;
}

/// A few triangles of each part.
std::vector<std::vector<std::int32_t>> sample(const Surface& s, const Parts& parts) {
    constexpr std::size_t enough = 48;
    const Groups members = group_members(parts.part_of, parts.parts.size(), s.threads);
    std::vector<std::vector<std::int32_t>> samples(members.size());
    for (std::size_t k = 0; k < members.size(); ++k)
        for (std::size_t at = 0; at < members[k].size(); at += 1 + members[k].size() / enough)
            samples[k].push_back(members[k][at]);
    return samples;
}

/// Whether each of two parts lies behind the surface of the other, as the pieces of one convex solid do.
bool are_convex_together(const Surface& s, const std::vector<std::int32_t>& a, const std::vector<std::int32_t>& b) {
    constexpr double level = 0.02, few = 0.02;  // sine of an angle; share of the pairs
    std::size_t before = 0;
    for (const std::int32_t i : a)
        for (const std::int32_t j : b) {
            const Vec3 way = s.geometry.barycentres[j] - s.geometry.barycentres[i];
            const double limit = level * way.norm();
            before += way.dot(s.geometry.normals[i]) > limit || -way.dot(s.geometry.normals[j]) > limit;
        }
    return static_cast<double>(before) <= few * static_cast<double>(a.size() * b.size());
}

/// How much of each part there is, and where it faces and meets others.
struct Encounters {
    std::vector<double> area;
    std::vector<double> border, free;  ///< length to parts, and to none
    PairMap<double> seen;              ///< area of the first that faces the second
    PairMap<double> seen_through;      ///< of sticks, so far away on a board that the way may lead through both
    Borders borders;
};

/// Whether a way from wall to wall is so long that it may lead through one part and then through the other, as from the
/// underside of a rail to the upper side of the floor that it carries.
bool goes_through_both(double way, const Core& a, const Core& b) {
    const auto [thin, thick] = std::minmax(a.thickness, b.thickness);
    return way > thick + thin / 2;
}

void count_encounter(const Surface& s, const Parts& parts, std::size_t i, Encounters& all) {
    const std::int32_t own = parts.part_of[i], o = s.thickness.opposites[i];
    if (own < 0) return;
    all.area[own] += s.geometry.areas[i];
    if (o >= 0 && parts.part_of[o] >= 0 && parts.part_of[o] != own) {
        const std::int32_t other = parts.part_of[o];
        const bool is_far = parts.parts[own].kind == Solidity::stick && parts.parts[other].kind == Solidity::board &&
                            goes_through_both(s.thickness.distances[i], parts.parts[own], parts.parts[other]);
        (is_far ? all.seen_through : all.seen).at(own, other) += s.geometry.areas[i];
    }
    for (int e = 0; e < 3; ++e) {
        const std::int32_t j = s.adjacency.neighbours[i][e];
        if (j < 0 || parts.part_of[j] == own) continue;
        const auto& corners = s.mesh.triangles[i];
        const Vec3 &from = s.mesh.positions[corners[e]], &to = s.mesh.positions[corners[(e + 1) % 3]];
        if (parts.part_of[j] < 0) {
            all.free[own] += (to - from).norm();
            continue;
        }
        Border& common = all.borders.at(own, parts.part_of[j]);
        common.add(from, to);
        all.border[own] += (to - from).norm();
        const bool concave = (s.geometry.barycentres[j] - s.geometry.barycentres[i]).dot(s.geometry.normals[i]) > 0;
        if (!s.in_crease(i) && (!concave || s.geometry.normals[i].dot(s.geometry.normals[j]) > 0.94))
            common.smooth += (to - from).norm();
    }
}

Encounters count_encounters(const Surface& s, const Parts& parts) {
    const std::vector<double> none(parts.parts.size(), 0.0);
    const auto of_blocks = map_blocks(s.count(), s.threads, [&](std::size_t begin, std::size_t end) {
        Encounters some{none, none, none, {}, {}, {}};
        for (std::size_t i = begin; i < end; ++i) count_encounter(s, parts, i, some);
        return some;
    });
    Encounters all{none, none, none, {}, {}, {}};
    for (const Encounters& some : of_blocks) {
        for (std::size_t k = 0; k < none.size(); ++k) {
            all.area[k] += some.area[k];
            all.border[k] += some.border[k];
            all.free[k] += some.free[k];
        }
        all.seen += some.seen;
        all.seen_through += some.seen_through;
        all.borders += some.borders;
    }
    return all;
}

/// Whether two parts meet along a concave crease, as far as can be told before borders lie on creases.
bool is_creased(const Borders& borders, const std::pair<std::int32_t, std::int32_t>& pair) {
    constexpr double least = 0.2;
    const auto border = borders.all.find(pair);
    return border != borders.all.end() && border->second.smooth < (1 - least) * border->second.length;
}

}  // namespace

void merge_parts(const Surface& s, Parts& parts) {
    constexpr double facing = 0.4, surrounded = 0.8, exactly_alike = 1.25, far_unlike = 4, all_around = 0.95,
                     mostly = 0.8, mostly_free = 0.5;
    const bool is_noisy = s.grain > 0;
    const double unlike = is_noisy ? 2.5 : 1.8;
    for (bool changed = true; changed;) {
        changed = false;
        auto [area, border, free, seen, seen_through, borders] = count_encounters(s, parts);
        for (const auto& [pair, facing_area] : seen_through.all)
            if (!is_creased(borders, pair)) seen.at(pair.first, pair.second) += facing_area;
        std::vector<Lie> lie;  // for the few borders that ask
        const auto lie_of = [&](std::int32_t part) -> const Lie& {
            if (lie.empty()) lie = lies(s, parts);
            return lie[part];
        };
        std::vector<std::vector<std::int32_t>> samples;
        for (const auto& [pair, common] : borders.all) {
            const auto [a, b] = pair;
            if (area[a] > area[b] || are_unlike_in_width(parts.parts[a], parts.parts[b])) continue;
            if (common.smooth > all_around * common.length) {
                if (samples.empty()) samples = sample(s, parts);
                if (are_convex_together(s, samples[a], samples[b])) {
                    seen.at(a, b) += area[a];
                    continue;
                }
            }
            const bool is_board = parts.parts[a].kind == Solidity::board;
            const double thin = std::min(parts.parts[a].thickness, parts.parts[b].thickness);
            const double thick = std::max(parts.parts[a].thickness, parts.parts[b].thickness);
            if (!is_board && parts.parts[b].kind == Solidity::board) {
                if (is_noisy && common.smooth > surrounded * (border[a] + free[a]) &&
                    is_within(lie_of(a), parts.parts[b]))
                    seen.at(a, b) += area[a];
                continue;
            }
            if (is_board != (parts.parts[b].kind == Solidity::board)) continue;
            if (is_board) {
                if (thick < (is_noisy ? unlike : exactly_alike) * thin && parts.parts[a].half > 0 &&
                    parts.parts[b].half > 0 &&
                    is_same_board(common, parts.parts[a], parts.parts[b], lie_of(a), lie_of(b)))
                    seen.at(a, b) += area[a];
                continue;
            }
            // Before the parts are filled, their border is but a piece of the ring that would tell a step.
            const bool is_ring = !is_noisy || free[a] < mostly_free * (border[a] + free[a]);
            const bool alike =
                thick < (is_ring ? unlike : noise_of_thickness) * thin && !(is_noisy && is_step(common, thin, thick));
            // Sticks in line meet all around, not only where noise lets their cores touch; unless they are alike in
            // thickness, nothing but a whole ring will do.
            const bool meet = common.smooth > 0.5 * border[a] && common.smooth > (alike ? 2 : 3) * thin;
            const bool are_sticks = parts.parts[a].kind == Solidity::stick && parts.parts[b].kind == Solidity::stick;
            const auto runs_around = [&](std::int32_t part) {
                return !is_noisy && lie_of(part).runs_around(parts.parts[part].thickness);
            };
            const auto are_in_line = [&, a = a, b = b] {
                return runs_around(a) || runs_around(b) ? are_in_line_where_they_meet(s, parts, a, b)
                                                        : is_in_line(lie_of(a).axis, lie_of(b).axis);
            };
            if (!(meet && (((alike || are_sticks) && are_in_line()) ||
                           (alike && is_sawn(common, lie_of(a), lie_of(b), thin)))) &&
                !(alike && is_same_place(lie_of(a), lie_of(b), thin)) &&
                !(are_sticks &&
                  (is_noisy ? thick < (is_ring ? far_unlike : noise_of_thickness) * thin
                            : thick < exactly_alike * thin && common.smooth > mostly * common.length &&
                                  is_section(common, lie_of(a), area[a]) && is_section(common, lie_of(b), area[b]) &&
                                  !runs_around(a) && !runs_around(b)) &&
                  goes_on(common, lie_of(a), lie_of(b), thin, thick)))
                continue;
            if (!is_noisy && are_sticks && is_crossed(parts, borders, a, b, common, lie_of(b).axis)) continue;
            if (are_sticks && is_shouldered(s, parts, common, a, b, lie_of(a), lie_of(b))) continue;
            seen.at(a, b) += area[a];
        }
        std::vector<std::int32_t> into(parts.parts.size(), -1);
        for (const auto& [pair, facing_area] : seen.all) {
            const auto [a, b] = pair;
            if (area[a] > area[b] || facing_area < facing * area[a]) continue;
            if (into[a] >= 0 || into[b] >= 0) continue;
            into[a] = b;
            changed = true;
        }
        if (!changed) break;
        for_each_range(s.count(), s.threads, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                if (std::int32_t& part = parts.part_of[i]; part >= 0 && into[part] >= 0) part = into[part];
        });
    }
}

}  // namespace partonomy
