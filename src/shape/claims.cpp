// What boards take beyond their cores, and what they cut.
//
// The rim of a board is neither wall nor core. A triangle is on the rim when from just below it both walls of the board
// are met, to both sides, on a way not much longer than the board is thick: the virtual facet of paper §6.4, asked with
// two rays. The test holds under noise, and it may take triangles from a much thicker part that grew over the rim.
// Beyond that, free triangles between the continued walls belong to the board: the hole in a seat's top side above a
// leg, the corner above a flush leg. How far that may go depends on how true the walls are: without limit between two
// exact planes, four thicknesses otherwise. Level boards come before upright ones and large before small, so a seat
// keeps its corners.
//
// A stick that runs along the rim of a board for a while and then turns off it is cut there. (A core that holds a long
// arc of a rim has no way that could be told, and stays as it is.)
//
// Boards that are exact planes give back what strayed into their core. Cost: O(n) and two rays per rim triangle.

#include "shape/claims.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <set>
#include <span>
#include <utility>

#include "base/ranges.h"

namespace partonomy {

namespace {

/// A board's middle plane and half thickness at a place.
struct Frame {
    Vec3 middle = Vec3::Zero();
    Vec3 normal = Vec3::Zero();
    double half = 0;
};

Frame local_frame(const Surface& s, std::int32_t i) {
    const double half = s.thickness.distances[i] / 2.0;
    return {s.geometry.barycentres[i] - s.geometry.normals[i] * half, s.geometry.normals[i], half};
}

struct PlaneFit {
    Frame frame;
    double deviation = 0;  ///< root mean square distance of the middle points from the plane
    double spread = 0;     ///< root mean square difference of half the thickness from the mean
};

PlaneFit fit_plane_to(const Surface& s, const std::vector<std::int32_t>& triangles) {
    Vec3 centre = Vec3::Zero();
    double area = 0, half = 0, half_square = 0;
    for (const std::int32_t i : triangles) {
        const Frame f = local_frame(s, i);
        centre += s.geometry.areas[i] * f.middle;
        half += s.geometry.areas[i] * f.half;
        half_square += s.geometry.areas[i] * f.half * f.half;
        area += s.geometry.areas[i];
    }
    centre /= area;
    half /= area;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const std::int32_t i : triangles) {
        const Vec3 d = local_frame(s, i).middle - centre;
        spread += s.geometry.areas[i] * d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(spread);
    return {{centre, eigen.eigenvectors().col(0), half},
            std::sqrt(std::max(0.0, eigen.eigenvalues()[0]) / area),
            std::sqrt(std::max(0.0, half_square / area - half * half))};
}

/// The middle plane of a board's core; triangles that stray from it are left out while most of the core agrees.
PlaneFit fit_plane(const Surface& s, const Core& core) {
    PlaneFit fit = fit_plane_to(s, core.triangles);
    for (int round = 0; round < 3; ++round) {
        if (fit.deviation < 1e-3 * core.thickness) break;
        std::vector<std::int32_t> near;
        double area = 0;
        const double limit = std::max(1.5 * fit.deviation, 1e-3 * core.thickness);
        for (const std::int32_t i : core.triangles)
            if (std::abs((local_frame(s, i).middle - fit.frame.middle).dot(fit.frame.normal)) < limit) {
                near.push_back(i);
                area += s.geometry.areas[i];
            }
        if (near.empty() || area < 0.8 * core.area) break;
        fit = fit_plane_to(s, near);
    }
    return fit;
}

/// A board among the parts.
struct Board {
    std::int32_t number;
    PlaneFit fit;
};

/// The boards: level ones first, large ones first.
std::vector<Board> boards_in_order(const Surface& s, const Vec3& up, const Parts& parts) {
    std::vector<Board> boards;
    for (std::size_t k = 0; k < parts.parts.size(); ++k)
        if (parts.parts[k].kind == Solidity::board) boards.push_back({static_cast<std::int32_t>(k), {}});
    for_each_range(
        boards.size(), s.threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) boards[k].fit = fit_plane(s, parts.parts[boards[k].number]);
        },
        1);
    const auto is_level = [&](const Board& board) { return std::abs(board.fit.frame.normal.dot(up)) > std::sqrt(0.5); };
    std::stable_sort(boards.begin(), boards.end(), [&](const Board& a, const Board& b) {
        const bool level = is_level(a);
        return level != is_level(b) ? level : parts.parts[a.number].area > parts.parts[b.number].area;
    });
    return boards;
}

/// Splits part k into its connected pieces; the first keeps the number.
void split_into_pieces(const Surface& s, Parts& parts, std::int32_t k) {
    const std::vector<std::int32_t> all = std::move(parts.parts[k].triangles);
    Core model = parts.parts[k];
    bool first = true;
    std::vector<std::int32_t> piece;
    for (const std::int32_t start : all) {
        if (parts.part_of[start] != k) continue;
        piece.assign(1, start);
        const auto mark = static_cast<std::int32_t>(-2);
        parts.part_of[start] = mark;
        for (std::size_t at = 0; at < piece.size(); ++at)
            for (const std::int32_t j : s.adjacency.neighbours[piece[at]])
                if (j >= 0 && parts.part_of[j] == k) {
                    parts.part_of[j] = mark;
                    piece.push_back(j);
                }
        std::sort(piece.begin(), piece.end());
        Core core = model;
        core.triangles = piece;
        core.area = 0;
        for (const std::int32_t i : piece) core.area += s.geometry.areas[i];
        std::int32_t number = k;
        if (first) {
            parts.parts[k] = std::move(core);
        } else if (core.area < core.thickness * core.thickness) {
            number = -1;
        } else {
            number = static_cast<std::int32_t>(parts.parts.size());
            parts.parts.push_back(std::move(core));
        }
        first = false;
        for (const std::int32_t i : piece) parts.part_of[i] = number;
    }
}

/// How many of the triangles are nearer to the board's core than a distance; sampled.
double share_near(const Surface& s, const std::vector<std::int32_t>& triangles, const Core& board, double distance) {
    const std::size_t step = 1 + board.triangles.size() / 600, own_step = 1 + triangles.size() / 40;
    int near = 0, all = 0;
    for (std::size_t w = own_step / 2; w < triangles.size(); w += own_step) {
        ++all;
        for (std::size_t q = 0; q < board.triangles.size(); q += step)
            if ((s.geometry.barycentres[triangles[w]] - s.geometry.barycentres[board.triangles[q]]).squaredNorm() <
                distance * distance) {
                ++near;
                break;
            }
    }
    return all > 0 ? static_cast<double>(near) / all : 0;
}

/// Whether a stick ends at the board, like a post, instead of running along it.
bool points_to(const Surface& s, const Core& stick, const Core& board) {
    Vec3 middle = Vec3::Zero();
    for (const std::int32_t i : stick.triangles) middle += s.geometry.areas[i] * s.geometry.barycentres[i];
    middle /= stick.area;
    Vec3 way = Vec3::Constant(s.size);
    const std::size_t step = 1 + board.triangles.size() / 600;
    for (std::size_t q = 0; q < board.triangles.size(); q += step) {
        const Vec3 to = s.geometry.barycentres[board.triangles[q]] - middle;
        if (to.squaredNorm() < way.squaredNorm()) way = to;
    }
    return way.norm() > stick.thickness && std::abs(way.dot(stick.axis)) > 0.8 * way.norm();
}

/// Frees parts that are but the thick rim of a board: they lie between its walls, along it, and do not end at it.
void absorb_rims(const Surface& s, const std::vector<Board>& boards, Parts& parts) {
    for (const auto& [b, fit] : boards) {
        Core& board = parts.parts[b];
        if (board.triangles.empty()) continue;  // a rim of another one
        const Frame& plane = fit.frame;
        for (std::size_t k = 0; k < parts.parts.size(); ++k) {
            Core& rim = parts.parts[k];
            if (static_cast<std::int32_t>(k) == b || rim.triangles.empty() || rim.area > 0.25 * board.area) continue;
            if (rim.family >= 0 && rim.family == board.family) continue;  // one of them is a slat of the other
            double within = 0, flush = 0;
            for (const std::int32_t i : rim.triangles) {
                const double u = std::abs((s.geometry.barycentres[i] - plane.middle).dot(plane.normal));
                if (u < plane.half + rim.thickness) within += s.geometry.areas[i];
                if (std::abs(u - plane.half) < 0.1 * plane.half) flush += s.geometry.areas[i];
            }
            if (within < 0.8 * rim.area || std::abs(rim.axis.dot(plane.normal)) > 0.4) continue;
            if (share_near(s, rim.triangles, board, 0.75 * (board.thickness + rim.thickness)) < 0.4) continue;
            if (flush < 0.7 * rim.area && points_to(s, rim, board)) continue;
            for (const std::int32_t i : rim.triangles) parts.part_of[i] = -1;
            rim.triangles.clear();
            rim.area = 0;
        }
    }
}

/// Which way some triangles of a stick run: none of them faces it.
Vec3 way_of(const Surface& s, const std::vector<std::int32_t>& triangles) {
    Eigen::Matrix3d facing = Eigen::Matrix3d::Zero();
    for (const std::int32_t i : triangles)
        facing += s.geometry.areas[i] * s.geometry.normals[i] * s.geometry.normals[i].transpose();
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(facing).eigenvectors().col(0);
}

/// Some triangles of a stick: those that lie along a board between its walls, and the others.
struct Along {
    std::vector<std::int32_t> along, beyond;
    double along_area = 0, area = 0;
    Vec3 to_board = Vec3::Zero();  ///< mean way to it
};

/// Looks at every so many triangles.
Along tell_along(const Surface& s, const Core& stick, const Core& board, const Frame& plane, std::size_t every) {
    const double reach = 0.75 * (board.thickness + stick.thickness);
    const std::size_t step = 1 + board.triangles.size() / 600;
    Along result;
    for (std::size_t w = every / 2; w < stick.triangles.size(); w += every) {
        const std::int32_t i = stick.triangles[w];
        const Vec3& place = s.geometry.barycentres[i];
        Vec3 nearest = Vec3::Constant(s.size);
        if (std::abs((place - plane.middle).dot(plane.normal)) < plane.half + stick.thickness)
            for (std::size_t q = 0; q < board.triangles.size(); q += step) {
                const Vec3 way = s.geometry.barycentres[board.triangles[q]] - place;
                if (way.squaredNorm() < nearest.squaredNorm()) nearest = way;
            }
        result.area += s.geometry.areas[i];
        if (nearest.norm() > reach) {
            result.beyond.push_back(i);
            continue;
        }
        result.along.push_back(i);
        result.along_area += s.geometry.areas[i];
        result.to_board += s.geometry.areas[i] * nearest;
    }
    return result;
}

/// Whether a stick runs along a board, and then off to the side.
bool turns_off(const Surface& s, const Along& stick) {
    constexpr double least = 0.1, most_to_it = 0.5, most_straight_on = 0.55;
    if (stick.along_area < least * stick.area || stick.along_area > (1 - least) * stick.area) return false;
    const Vec3 way = way_of(s, stick.along);
    return std::abs(way.dot(stick.to_board)) <= most_to_it * stick.to_board.norm() &&
           std::abs(way.dot(way_of(s, stick.beyond))) <= most_straight_on;
}

/// Cuts sticks where they turn off the rim of a board, as the bridge of spectacles does: what runs along the board
/// becomes free, and the rest is a stick of its own. A post that goes straight on beyond the board stays whole.
void cut_at_rims(const Surface& s, const std::vector<Board>& boards, Parts& parts) {
    constexpr std::size_t enough = 400;  // triangles, to tell
    for (const auto& [b, fit] : boards) {
        const std::size_t existing = parts.parts.size();
        for (std::size_t k = 0; k < existing; ++k) {
            const Core &stick = parts.parts[k], &board = parts.parts[b];
            if (stick.kind != Solidity::stick || stick.triangles.empty() || stick.area > board.area) continue;
            const std::size_t every = 1 + stick.triangles.size() / enough;
            if (!turns_off(s, tell_along(s, stick, board, fit.frame, every))) continue;
            Along all = tell_along(s, stick, board, fit.frame, 1);
            for (const std::int32_t i : all.along) parts.part_of[i] = -1;
            parts.parts[k].triangles = std::move(all.beyond);
            split_into_pieces(s, parts, static_cast<std::int32_t>(k));
        }
    }
}

/// Cuts sticks where a board crosses them: what lies between the board's walls becomes free, and the pieces above and
/// below become sticks of their own.
void cut_at_boards(const Surface& s, const std::vector<Board>& boards, Parts& parts) {
    constexpr double crossing = 0.3, most_beside = 0.7;
    constexpr double long_enough = 8;  // surface in squares of the thickness: length is two
    for (const auto& [b, fit] : boards) {
        const Frame& plane = fit.frame;
        const std::size_t existing = parts.parts.size();
        for (std::size_t k = 0; k < existing; ++k) {
            const Core& stick = parts.parts[k];
            if (stick.kind != Solidity::stick || stick.area >= parts.parts[b].area) continue;
            const bool is_long = stick.area > long_enough * stick.thickness * stick.thickness;
            if (is_long && std::abs(stick.axis.dot(plane.normal)) < crossing &&
                share_near(s, stick.triangles, parts.parts[b], 0.75 * (stick.thickness + parts.parts[b].thickness)) <
                    most_beside)
                continue;  // a post that runs along the board and on
            double above = 0, below = 0;
            std::vector<std::int32_t> within;
            for (const std::int32_t i : stick.triangles) {
                const double u = (s.geometry.barycentres[i] - plane.middle).dot(plane.normal);
                if (u > plane.half) above += s.geometry.areas[i];
                if (u < -plane.half) below += s.geometry.areas[i];
                if (std::abs(u) <= plane.half) within.push_back(i);
            }
            if (std::min(above, below) < 0.1 * stick.area || within.empty()) continue;
            if (share_near(s, within, parts.parts[b], 2 * (stick.thickness + parts.parts[b].thickness)) == 0) continue;
            for (const std::int32_t i : within) parts.part_of[i] = -1;
            std::erase_if(parts.parts[k].triangles, [&](std::int32_t i) { return parts.part_of[i] < 0; });
            if (parts.parts[k].cut < 0) parts.parts[k].cut = static_cast<std::int32_t>(k);
            split_into_pieces(s, parts, static_cast<std::int32_t>(k));
        }
    }
}

/// What is seen from just below a triangle beside the growing board, along the board's normal, to both sides.
struct Look {
    std::int32_t from, triangle;
    bool is_turned_away;  ///< too much like a wall to be on the rim: nothing is looked at
    std::array<WallHit, 2> seen{};
};

/// Whether the triangle is on the rim of a board: the board's two walls are met to both sides before a way longer than
/// the board is thick.
bool on_rim(const Parts& parts, std::int32_t board, const Frame& f, const Look& look) {
    if (look.is_turned_away) return false;
    double way = 0;
    for (const WallHit& hit : look.seen) {
        if (hit.triangle < 0 || parts.part_of[hit.triangle] != board) return false;
        way += hit.distance;
    }
    return way < 3 * f.half;
}

/// One board's growth over the triangles around its core.
class SlabClaim {
public:
    SlabClaim(const Surface& surface, Parts& parts)
        : s_(surface),
          parts_(parts),
          origin_(std::make_unique_for_overwrite<std::int32_t[]>(surface.count())),
          beyond_(std::make_unique_for_overwrite<float[]>(surface.count())),
          look_of_(surface.count()) {}

    void grow(std::int32_t number, const PlaneFit& fit) {
        board_ = number;
        const Core& board = parts_.parts[number];
        flat_ = fit.deviation < planar * board.thickness || (s_.grain > 0 && fit.deviation < like_noise * fit.spread);
        exact_ = fit.deviation < 0.01 * board.thickness && fit.spread < 0.03 * board.thickness;
        plane_ = fit.frame;
        reach_ = board.family >= 0 ? short_reach : exact_ ? std::numeric_limits<double>::infinity() : reach;
        room_ = exact * plane_.half + std::min(2 * (fit.deviation + fit.spread), most_noise * plane_.half);
        if (exact_) release_strays(number);
        Core& part = parts_.parts[number];
        part.is_exact = exact_;
        part.middle = plane_.middle;
        part.normal = plane_.normal;
        part.half = plane_.half;
        queue_ = board.triangles;
        for (const std::int32_t i : queue_) {
            origin_[i] = i;
            beyond_[i] = 0;
        }
        looks_.clear();
        for (std::size_t begin = 0; begin < queue_.size();) {
            const std::size_t end = queue_.size();
            if (!flat_) looks_.clear();
            std::vector<Candidate> candidates = beside(begin, end);
            look_at(candidates);
            for (const Candidate& candidate : candidates)
                if (parts_.part_of[candidate.triangle] != number) consider(candidate);
            begin = end;
        }
    }

private:
    struct Candidate {
        std::int32_t from, triangle;
        bool is_turned_away;  ///< see Look
        std::size_t look = 0;
    };

    /// A wedge that leans on an exact board may have come in with its thin end.
    void release_strays(std::int32_t number) {
        std::erase_if(parts_.parts[number].triangles, [&](std::int32_t i) {
            const double u = std::abs((s_.geometry.barycentres[i] - plane_.middle).dot(plane_.normal));
            const bool stray = std::abs(u - plane_.half) > 0.1 * plane_.half;
            if (stray) parts_.part_of[i] = -1;
            return stray;
        });
    }

    [[nodiscard]] Frame frame_at(std::int32_t from) const { return flat_ ? plane_ : local_frame(s_, origin_[from]); }

    /// Whether the board may take the triangle: a free one, or one of a much thicker part.
    [[nodiscard]] bool is_takeable(std::int32_t j) const {
        const std::int32_t part = parts_.part_of[j];
        return part < 0 || parts_.parts[part].thickness >= thicker * parts_.parts[board_].thickness;
    }

    /// Triangles beside a stretch of the queue, in order.
    [[nodiscard]] std::vector<Candidate> beside(std::size_t first, std::size_t last) const {
        constexpr std::size_t block = 512;
        auto of_blocks = map_blocks(
            last - first, s_.threads,
            [&](std::size_t begin, std::size_t end) {
                std::vector<Candidate> some;
                for (std::size_t at = first + begin; at < first + end; ++at)
                    for (const std::int32_t j : s_.adjacency.neighbours[queue_[at]])
                        if (j >= 0 && parts_.part_of[j] != board_ && is_takeable(j))
                            some.push_back({queue_[at], j, is_turned_away(queue_[at], j)});
                return some;
            },
            block);
        if (of_blocks.size() == 1) return std::move(of_blocks.front());
        std::vector<Candidate> all;
        for (const std::vector<Candidate>& some : of_blocks) all.insert(all.end(), some.begin(), some.end());
        return all;
    }

    [[nodiscard]] bool is_turned_away(std::int32_t from, std::int32_t j) const {
        const Vec3 normal = flat_ ? plane_.normal : s_.geometry.normals[origin_[from]];
        return std::abs(s_.geometry.normals[j].dot(normal)) > 0.8;
    }

    /// Looks below all candidates side by side; once for each triangle where the board has one frame everywhere.
    void look_at(std::vector<Candidate>& candidates) {
        asking_.clear();
        for (Candidate& candidate : candidates) {
            const auto known = static_cast<std::size_t>(look_of_[candidate.triangle]);
            if (flat_ && known < looks_.size() && looks_[known].triangle == candidate.triangle) {
                candidate.look = known;
                continue;
            }
            candidate.look = looks_.size();
            look_of_[candidate.triangle] = static_cast<std::int32_t>(looks_.size());
            if (!candidate.is_turned_away) asking_.push_back(looks_.size());
            looks_.push_back({candidate.from, candidate.triangle, candidate.is_turned_away});
        }
        // Packets of rays are the same on any number of threads.
        constexpr std::size_t packet = 8, packets_at_once = 2;
        for_each_range(
            (asking_.size() + packet - 1) / packet, s_.threads,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t k = begin; k < end; ++k)
                    look(std::span(asking_).subspan(k * packet, std::min(packet, asking_.size() - k * packet)));
            },
            packets_at_once);
    }

    void look(std::span<const std::size_t> asking) {
        constexpr std::size_t most = 16;
        std::array<InnerRay, most> rays;
        std::array<WallHit, most> hits;
        for (std::size_t k = 0; k < asking.size(); ++k) {
            const Look& one = looks_[asking[k]];
            const std::int32_t i = one.triangle;
            const Frame f = frame_at(one.from);
            const Vec3 inside = s_.geometry.barycentres[i] - s_.geometry.normals[i] * (0.5 * f.half);
            rays[2 * k] = {inside, f.normal, -1, i};
            rays[2 * k + 1] = {inside, -f.normal, -1, i};
        }
        s_.scene->exit_walls({rays.data(), 2 * asking.size()}, {hits.data(), 2 * asking.size()});
        for (std::size_t k = 0; k < asking.size(); ++k) looks_[asking[k]].seen = {hits[2 * k], hits[2 * k + 1]};
    }

    void consider(const Candidate& candidate) {
        const auto [from, j] = std::pair(candidate.from, candidate.triangle);
        const bool free = parts_.part_of[j] < 0;
        const Frame f = frame_at(from);
        float beyond = 0;
        if (!on_rim(parts_, board_, f, looks_[candidate.look])) {
            if (!free) return;
            beyond =
                beyond_[from] + static_cast<float>((s_.geometry.barycentres[j] - s_.geometry.barycentres[from]).norm());
            if (beyond > reach_ * parts_.parts[board_].thickness) return;
            const Vec3 way = s_.geometry.barycentres[j] - s_.geometry.barycentres[from];
            const bool concave = way.dot(s_.geometry.normals[from]) > 0;
            if (concave && s_.geometry.normals[from].dot(s_.geometry.normals[j]) < crease) return;
            if (s_.in_crease(j)) return;
            const double u = (s_.geometry.barycentres[j] - f.middle).dot(f.normal);
            if (std::abs(u) > (flat_ ? room_ : f.half * loose)) return;
        }
        origin_[j] = origin_[from];
        beyond_[j] = beyond;
        parts_.part_of[j] = board_;
        queue_.push_back(j);
    }

    static constexpr double planar = 0.12;  // of the thickness: less deviation from a plane is none
    /// Noise moves the two walls by themselves, so it spreads the thickness as much as it does the middle; a bend does
    /// not.
    static constexpr double like_noise = 1.5;
    static constexpr double exact = 1.02, loose = 1.1, most_noise = 0.35;
    static constexpr double reach = 4;  // thicknesses beyond the last sure place, unless both walls are true planes
    static constexpr double short_reach = 1;  // where narrow boards go on in the same plane
    static constexpr double thicker = 1.5;    // parts by so much thicker may lose their triangles to a board's rim
    static constexpr double crease = 0.866;

    const Surface& s_;
    Parts& parts_;
    std::unique_ptr<std::int32_t[]> origin_;  ///< of the board's: the triangle of the core whose frame goes on here
    std::unique_ptr<float[]> beyond_;         ///< of the board's: how far it is from the last sure place
    std::vector<std::int32_t> queue_;
    std::vector<Look> looks_;
    std::vector<std::size_t> asking_;    ///< numbers of looks that are to be taken
    std::vector<std::int32_t> look_of_;  ///< number of the last look below each triangle, whatever the board
    std::int32_t board_ = -1;
    bool flat_ = false, exact_ = false;
    Frame plane_;
    double reach_ = 0;
    double room_ = 0;  ///< how far from the middle plane the board may go
};

/// Whether a free piece lies between the two planes of a board that it meets, as the bridge between a hole and the edge
/// of a plate does.
bool is_of_a_board(const Surface& s, std::span<const std::int32_t> piece, double area, const Parts& parts) {
    constexpr double nearly_all = 0.98, beyond = 1.02;
    std::set<std::int32_t> boards;
    for (const std::int32_t i : piece)
        for (const std::int32_t j : s.adjacency.neighbours[i])
            if (j >= 0 && parts.part_of[j] >= 0 && parts.parts[parts.part_of[j]].is_exact)
                boards.insert(parts.part_of[j]);
    return std::ranges::any_of(boards, [&](std::int32_t number) {
        const Core& board = parts.parts[number];
        double within = 0;
        for (const std::int32_t i : piece)
            if (std::abs((s.geometry.barycentres[i] - board.middle).dot(board.normal)) < beyond * board.half)
                within += s.geometry.areas[i];
        return within > nearly_all * area;
    });
}

}  // namespace

void claim(const Surface& s, const Vec3& up, Parts& parts) {
    const std::vector<Board> boards = boards_in_order(s, up, parts);
    absorb_rims(s, boards, parts);
    cut_at_rims(s, boards, parts);
    cut_at_boards(s, boards, parts);
    SlabClaim slab(s, parts);
    for (const auto& [number, fit] : boards) slab.grow(number, fit);
}

Groups free_pieces(const Surface& s, const Parts& parts) {
    const Pieces pieces = find_pieces(s.adjacency, s.threads, [&](std::int32_t i, std::int32_t j) {
        return parts.part_of[i] < 0 && parts.part_of[j] < 0;
    });
    return group_members(pieces.piece_of, pieces.size(), s.threads);
}

void found_new_parts(const Surface& s, const Groups& free_pieces, Parts& parts) {
    const double total = sum(s.geometry.areas, s.threads);
    struct Measured {
        double area = 0, facing = 0;
    };
    std::vector<Measured> measured(free_pieces.size());
    const auto add_up = [&](std::span<const std::int32_t> piece, const auto& value) {
        const auto sums = map_blocks(piece.size(), s.threads, [&](std::size_t begin, std::size_t end) {
            double sum = 0;
            for (std::size_t k = begin; k < end; ++k) sum += value(piece[k]);
            return sum;
        });
        return std::accumulate(sums.begin(), sums.end(), 0.0);
    };
    const auto measure = [&](std::span<const std::int32_t> piece) {
        Measured result{add_up(piece, [&](std::int32_t i) { return s.geometry.areas[i]; })};
        if (result.area < 2e-3 * total) return result;
        result.facing = add_up(piece, [&](std::int32_t i) {
            const std::int32_t o = s.thickness.opposites[i];
            if (o < 0 || parts.part_of[o] >= 0) return 0.0;
            // Noise makes neighbours face each other: such a ray goes hardly deeper than the triangle is large.
            if (s.thickness.distances[i] < std::sqrt(s.geometry.areas[i])) return 0.0;
            return std::ranges::binary_search(piece, o) ? s.geometry.areas[i] : 0.0;
        });
        return result;
    };
    constexpr std::size_t grain = 64;
    for_each_range(
        measured.size(), s.threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) measured[k] = measure(free_pieces[k]);
        },
        grain);
    for (std::size_t k = 0; k < free_pieces.size(); ++k) {
        const auto piece = free_pieces[k];
        const auto [area, facing] = measured[k];
        if (area < 2e-3 * total || facing < 0.6 * area || is_of_a_board(s, piece, area, parts)) continue;
        Core core;
        core.kind = Solidity::stick;
        core.triangles.assign(piece.begin(), piece.end());
        core.area = area;
        std::vector<float> all;
        for (const std::int32_t i : piece) all.push_back(s.thickness.distances[i]);
        std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
        core.thickness = all[all.size() / 2];
        if (is_fin(s, core.thickness, area / total) || area < 3 * core.thickness * core.thickness) continue;
        for (const std::int32_t i : piece) parts.part_of[i] = static_cast<std::int32_t>(parts.parts.size());
        parts.parts.push_back(std::move(core));
    }
}

}  // namespace partonomy
