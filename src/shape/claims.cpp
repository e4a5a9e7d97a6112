#include "shape/claims.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace partonomy {

namespace {

/// A board's middle plane and half thickness at a place.
struct Frame {
    Vec3 middle;
    Vec3 normal;
    double half = 0;
};

Frame local_frame(const Surface& s, std::int32_t i) {
    const double half = s.thickness.distances[i] / 2.0;
    return {s.geometry.barycentres[i] - s.normals[i] * half, s.normals[i], half};
}

struct PlaneFit {
    Frame frame;
    double deviation = 0;  ///< root mean square distance of the middle points from the plane
};

PlaneFit fit_plane(const Surface& s, const Core& core) {
    Vec3 centre = Vec3::Zero();
    double area = 0, half = 0;
    for (const std::int32_t i : core.triangles) {
        const Frame f = local_frame(s, i);
        centre += s.geometry.areas[i] * f.middle;
        half += s.geometry.areas[i] * f.half;
        area += s.geometry.areas[i];
    }
    centre /= area;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const std::int32_t i : core.triangles) {
        const Vec3 d = local_frame(s, i).middle - centre;
        spread += s.geometry.areas[i] * d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(spread);
    return {{centre, eigen.eigenvectors().col(0), half / area}, std::sqrt(std::max(0.0, eigen.eigenvalues()[0]) / area)};
}

/// Numbers of the boards: level ones first, large ones first.
std::vector<std::int32_t> boards_in_order(const Surface& s, const Vec3& up, const Parts& parts) {
    std::vector<std::int32_t> order;
    std::vector<bool> level(parts.parts.size());
    for (std::size_t k = 0; k < parts.parts.size(); ++k) {
        if (parts.parts[k].kind != Solidity::board) continue;
        order.push_back(static_cast<std::int32_t>(k));
        level[k] = std::abs(fit_plane(s, parts.parts[k]).frame.normal.dot(up)) > std::sqrt(0.5);
    }
    std::stable_sort(order.begin(), order.end(), [&](std::int32_t a, std::int32_t b) {
        return level[a] != level[b] ? level[a] : parts.parts[a].area > parts.parts[b].area;
    });
    return order;
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
    // Two thirds of pieces are found above; marks never stay behind because every piece gets a number or -1.
}

}  // namespace

void cut_at_boards(const Surface& s, const Vec3& up, Parts& parts) {
    for (const std::int32_t b : boards_in_order(s, up, parts)) {
        const PlaneFit fit = fit_plane(s, parts.parts[b]);
        const Frame& plane = fit.frame;
        const std::size_t existing = parts.parts.size();
        for (std::size_t k = 0; k < existing; ++k) {
            const Core& stick = parts.parts[k];
            if (stick.kind != Solidity::stick || stick.area >= parts.parts[b].area) continue;
            double above = 0, below = 0;
            std::vector<std::int32_t> within;
            for (const std::int32_t i : stick.triangles) {
                const double u = (s.geometry.barycentres[i] - plane.middle).dot(plane.normal);
                if (u > plane.half) above += s.geometry.areas[i];
                if (u < -plane.half) below += s.geometry.areas[i];
                if (std::abs(u) <= plane.half) within.push_back(i);
            }
            if (std::min(above, below) < 0.1 * stick.area || within.empty()) continue;
            double nearest = s.size;
            const std::size_t step = std::max<std::size_t>(1, parts.parts[b].triangles.size() / 500);
            for (std::size_t w = 0; w < within.size(); w += 1 + within.size() / 30)
                for (std::size_t q = 0; q < parts.parts[b].triangles.size(); q += step)
                    nearest = std::min(nearest, (s.geometry.barycentres[within[w]] -
                                                 s.geometry.barycentres[parts.parts[b].triangles[q]]).norm());
            if (nearest > 2 * (stick.thickness + parts.parts[b].thickness)) continue;
            for (const std::int32_t i : within) parts.part_of[i] = -1;
            std::erase_if(parts.parts[k].triangles, [&](std::int32_t i) { return parts.part_of[i] < 0; });
            split_into_pieces(s, parts, static_cast<std::int32_t>(k));
        }
    }
}

void claim_slabs(const Surface& s, const Vec3& up, Parts& parts) {
    constexpr double planar = 0.12, exact = 1.02, loose = 1.1, reach = 4;
    std::vector<Frame> frame(s.count());
    for (const std::int32_t b : boards_in_order(s, up, parts)) {
        const Core& board = parts.parts[b];
        const PlaneFit fit = fit_plane(s, board);
        const bool flat = fit.deviation < planar * board.thickness;
        std::vector<std::int32_t> queue = board.triangles;
        for (const std::int32_t i : queue) frame[i] = local_frame(s, i);
        for (std::size_t at = 0; at < queue.size(); ++at)
            for (const std::int32_t j : s.adjacency.neighbours[queue[at]]) {
                if (j < 0 || parts.part_of[j] >= 0) continue;
                const Frame& f = flat ? fit.frame : frame[queue[at]];
                const Vec3 offset = s.geometry.barycentres[j] - f.middle;
                const double u = offset.dot(f.normal);
                if (std::abs(u) > f.half * (flat ? exact : loose)) continue;
                if (!flat && offset.squaredNorm() > reach * reach * 4 * f.half * f.half) continue;
                frame[j] = frame[queue[at]];
                parts.part_of[j] = b;
                queue.push_back(j);
            }
    }
}

void found_new_parts(const Surface& s, Parts& parts) {
    const double total = std::accumulate(s.geometry.areas.begin(), s.geometry.areas.end(), 0.0);
    std::vector<char> seen(s.count(), 0);
    for (std::size_t start = 0; start < s.count(); ++start) {
        if (parts.part_of[start] >= 0 || seen[start]) continue;
        std::vector<std::int32_t> piece{static_cast<std::int32_t>(start)};
        seen[start] = 1;
        double area = 0, facing = 0;
        for (std::size_t at = 0; at < piece.size(); ++at) {
            area += s.geometry.areas[piece[at]];
            for (const std::int32_t j : s.adjacency.neighbours[piece[at]])
                if (j >= 0 && parts.part_of[j] < 0 && !seen[j]) {
                    seen[j] = 1;
                    piece.push_back(j);
                }
        }
        if (area < 2e-3 * total) continue;
        std::sort(piece.begin(), piece.end());
        for (const std::int32_t i : piece) {
            const std::int32_t o = s.thickness.opposites[i];
            if (o >= 0 && std::binary_search(piece.begin(), piece.end(), o)) facing += s.geometry.areas[i];
        }
        if (facing < 0.6 * area) continue;
        Core core;
        core.kind = Solidity::stick;
        core.triangles = piece;
        core.area = area;
        std::vector<float> all;
        for (const std::int32_t i : piece) all.push_back(s.thickness.distances[i]);
        std::nth_element(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2), all.end());
        core.thickness = all[all.size() / 2];
        if (area < 3 * core.thickness * core.thickness) continue;
        for (const std::int32_t i : piece) parts.part_of[i] = static_cast<std::int32_t>(parts.parts.size());
        parts.parts.push_back(std::move(core));
    }
}

}  // namespace partonomy
