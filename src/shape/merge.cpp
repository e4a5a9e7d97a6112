// Parts that are one after all.
//
// A part that faces another one for a good deal of its area lies across it in the same solid: two walls of one leg. And
// two sticks in one line that pass into each other over most of their common border, without a concave crease, are one.
// Cost: O(n) a round; a round joins at least one pair.

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "shape/claims.h"

namespace partonomy {

namespace {

std::vector<Vec3> main_axes(const Surface& s, const Parts& parts) {
    std::vector<Vec3> sum(parts.parts.size(), Vec3::Zero());
    std::vector<double> area(parts.parts.size(), 0.0);
    std::vector<Eigen::Matrix3d> spread(parts.parts.size(), Eigen::Matrix3d::Zero());
    for (std::size_t i = 0; i < s.count(); ++i) {
        const std::int32_t k = parts.part_of[i];
        if (k < 0) continue;
        const Vec3& b = s.geometry.barycentres[i];
        sum[k] += s.geometry.areas[i] * b;
        spread[k] += s.geometry.areas[i] * b * b.transpose();
        area[k] += s.geometry.areas[i];
    }
    std::vector<Vec3> axes(parts.parts.size(), Vec3::Zero());
    for (std::size_t k = 0; k < axes.size(); ++k)
        if (area[k] > 0)
            axes[k] = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread[k] - sum[k] * sum[k].transpose() / area[k])
                          .eigenvectors()
                          .col(2);
    return axes;
}

}  // namespace

void merge_parts(const Surface& s, Parts& parts) {
    constexpr double facing = 0.4, unlike = 1.8;
    for (bool changed = true; changed;) {
        changed = false;
        std::vector<double> area(parts.parts.size(), 0.0);
        std::map<std::pair<std::int32_t, std::int32_t>, double> seen;
        for (std::size_t i = 0; i < s.count(); ++i) {
            const std::int32_t own = parts.part_of[i], o = s.thickness.opposites[i];
            if (own < 0) continue;
            area[own] += s.geometry.areas[i];
            if (o >= 0 && parts.part_of[o] >= 0 && parts.part_of[o] != own)
                seen[{own, parts.part_of[o]}] += s.geometry.areas[i];
        }
        std::vector<double> border(parts.parts.size(), 0.0);
        std::map<std::pair<std::int32_t, std::int32_t>, double> smooth;
        for (std::size_t i = 0; i < s.count(); ++i)
            for (int e = 0; e < 3; ++e) {
                const std::int32_t own = parts.part_of[i], j = s.adjacency.neighbours[i][e];
                if (own < 0 || j < 0 || parts.part_of[j] < 0 || parts.part_of[j] == own) continue;
                const auto& corners = s.mesh.triangles[i];
                const double length = (s.mesh.positions[corners[e]] - s.mesh.positions[corners[(e + 1) % 3]]).norm();
                border[own] += length;
                const bool concave = (s.geometry.barycentres[j] - s.geometry.barycentres[i]).dot(s.normals[i]) > 0;
                if (!concave || s.normals[i].dot(s.normals[j]) > 0.94) smooth[{own, parts.part_of[j]}] += length;
            }
        const std::vector<Vec3> axes = main_axes(s, parts);
        for (const auto& [pair, length] : smooth) {
            const auto [a, b] = pair;
            if (area[a] > area[b] || length < 0.5 * border[a]) continue;
            if (parts.parts[a].kind == Solidity::board || parts.parts[b].kind == Solidity::board) continue;
            if (std::abs(axes[a].dot(axes[b])) < 0.8) continue;
            // Sticks that are one meet all around, not only where noise lets their cores touch; unless they are alike in
            // thickness, nothing but a whole ring will do.
            const double thin = std::min(parts.parts[a].thickness, parts.parts[b].thickness);
            const double thick = std::max(parts.parts[a].thickness, parts.parts[b].thickness);
            if (length < (thick > unlike * thin ? 3 : 2) * thin) continue;
            seen[{a, b}] += area[a];
        }
        std::vector<std::int32_t> into(parts.parts.size(), -1);
        for (const auto& [pair, facing_area] : seen) {
            const auto [a, b] = pair;
            if (area[a] > area[b] || facing_area < facing * area[a]) continue;
            if (into[a] >= 0 || into[b] >= 0) continue;
            into[a] = b;
            changed = true;
        }
        for (std::int32_t& part : parts.part_of)
            if (part >= 0 && into[part] >= 0) part = into[part];
    }
}

}  // namespace partonomy
