// What stands out of a part's box, and is a part of its own.
//
// Under noise the rays of one part go astray into the next, and a leg may come as one with the block that it carries.
// rejoin.cpp asks whether one box accounts for two pieces; here the question is turned round: what hangs together
// outside of the box of a part, farther than noise reaches, and has a box of its own, with walls that turn off from
// those of the part along most of their common border (the minima rule of Hoffman and Richards 1984), is another part.
// Walls that run on, as those of a bent board do, keep it. The border is rough; settle.cpp draws it along the crease.
//
// Cost: O(n), and one box of some hundred triangles a part and a protrusion.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/ranges.h"
#include "shape/cells.h"
#include "shape/claims.h"
#include "shape/wall_box.h"

namespace partonomy {

namespace {

constexpr double least_share = 0.04;  // of the part: less is a bump
constexpr double least_turned = 0.4;  // of the border: half of it, if a bar is flush with another one on two sides
const double turned_cosine = std::cos(45 * std::numbers::pi / 180);

/// The direction of the side of a box that a triangle lies on, by where it faces.
Vec3 side_of(const Surface& s, const WallBox& box, std::int32_t t) {
    const Vec3 along = box.axes.transpose() * s.geometry.normals[t];
    Eigen::Index k = 0;
    along.cwiseAbs().maxCoeff(&k);
    return along[k] > 0 ? Vec3(box.axes.col(k)) : Vec3(-box.axes.col(k));
}

double share_beyond(const Boxed& part, double limit) {
    double all = 0, beyond = 0;
    for (const auto& [distance, area] : part.distances) {
        all += area;
        if (distance > limit) beyond += area;
    }
    return all > 0 ? beyond / all : 1;
}

/// Whether a box accounts for what is in it; one end of it may be missing.
bool accounts_for(const Boxed& piece, double limit) {
    constexpr double least_cover = 0.6, most_cover = 1.3, most_beyond = 0.3;
    const double cover = piece.area / piece.box.area();
    return cover > least_cover && cover < most_cover && share_beyond(piece, limit) < most_beyond;
}

/// How much of the border between a piece and its part stands on a side of the part's box, off the rims, and turns off
/// from that side.
double turned_share(const Surface& s, const std::vector<std::int32_t>& part_of,
                    const std::vector<std::int32_t>& piece_of, std::span<const std::int32_t> piece,
                    const WallBox& part_box, const WallBox& own_box, double limit) {
    double all = 0, turned = 0;
    for (const std::int32_t i : piece)
        for (int e = 0; e < 3; ++e) {
            const std::int32_t j = s.adjacency.neighbours[i][e];
            if (j < 0 || piece_of[j] == piece_of[i] || part_of[j] != part_of[i]) continue;
            const auto& corners = s.mesh.triangles[i];
            const Vec3 &from = s.mesh.positions[corners[e]], &to = s.mesh.positions[corners[(e + 1) % 3]];
            all += (to - from).norm();
            Vec3 outside = part_box.outside((from + to) / 2);
            Eigen::Index up = 0;
            outside.maxCoeff(&up);
            outside[up] = -part_box.lengths[up];
            const bool turns = std::abs(part_box.axes.col(up).dot(side_of(s, own_box, i))) < turned_cosine;
            if (turns && outside.maxCoeff() < -limit) turned += (to - from).norm();
        }
    return all > 0 ? turned / all : 0;
}

/// A part of a box.
Core part_of_box(const Boxed& boxed) {
    std::array<Eigen::Index, 3> order{0, 1, 2};
    const Vec3& lengths = boxed.box.lengths;
    std::ranges::sort(order, {}, [&](Eigen::Index a) { return lengths[a]; });
    Core core;
    core.thickness = lengths[order[0]];
    core.kind = kind_of(lengths[order[1]] / core.thickness, lengths[order[2]] / core.thickness, narrowest);
    core.normal = boxed.box.axes.col(order[0]);
    core.axis = boxed.box.axes.col(order[2]);
    core.area = boxed.area;
    return core;
}

}  // namespace

void part_protrusions(const Surface& s, Parts& parts) {
    const std::vector<Boxed> boxed = boxes_of_parts(s, parts.part_of, parts.parts.size());
    const double limit = reach_of_noise(boxed);
    std::vector<char> stands_out(s.count(), 0);
    for_each_range(s.count(), s.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (const std::int32_t own = parts.part_of[i]; own >= 0)
                stands_out[i] = boxed[own].box.outside(s.geometry.barycentres[i]).maxCoeff() > limit;
    });
    const Pieces pieces = find_pieces(s.adjacency, s.threads, [&](std::int32_t i, std::int32_t j) {
        return stands_out[i] && stands_out[j] && parts.part_of[i] == parts.part_of[j];
    });
    const Groups groups = group_members(pieces.piece_of, pieces.size(), s.threads);
    std::vector<std::optional<Core>> found(groups.size());
    const auto look_at = [&](std::size_t k) {
        const Boxed& part = boxed[parts.part_of[groups[k].front()]];
        double area = 0;
        for (const std::int32_t i : groups[k]) area += s.geometry.areas[i];
        if (area < least_share * part.area) return;
        const Boxed piece = box_of_part(s, groups[k]);
        if (accounts_for(piece, limit) &&
            turned_share(s, parts.part_of, pieces.piece_of, groups[k], part.box, piece.box, limit) > least_turned)
            found[k] = part_of_box(piece);
    };
    for_each_range(
        groups.size(), s.threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = begin; k < end; ++k) look_at(k);
        },
        1);
    for (std::size_t k = 0; k < groups.size(); ++k) {
        if (!found[k]) continue;
        const auto number = static_cast<std::int32_t>(parts.parts.size());
        parts.parts.push_back(*std::move(found[k]));
        for (const std::int32_t i : groups[k]) parts.part_of[i] = number;
    }
}

}  // namespace partonomy
