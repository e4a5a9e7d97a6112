// Box lengths that noise does not inflate, and the fitting score of paper §6.4.
//
// The smallest box gives the axes, and on a clean mesh the lengths. On a noisy mesh, the pair of its sides that most of
// the part faces tells how rough the part is: how far the triangles that face these sides lie from a plane through
// them, on average. A part that is flat there (a two-hundredth of the length) keeps the smallest box exactly, whatever
// its outline: a triangular board has slanted sides, no noise. Otherwise each side is looked at as a wall: the
// triangles in the outer half that face that way, and the area-weighted median of how far out they are. Where the
// outermost point is hardly farther out than the wall (a fiftieth of the length), the side stays; else the axes are
// turned to the mean normals of the walls, and the walls count.
//
// A vessel faces up with its floor, within, and outward with its far wall, within: these are in the inner half, or much
// of the part lies beyond them, and they are no walls of the box. Nor are slanted walls, and round ones, which turn
// away on both sides; their median is well within the outermost place. A side without a wall (a rim, the end of a leg
// that goes on as a seat, the tip of a cone) is where the area ends: the places beyond which a two-hundredth and a
// fiftieth of it lie show how it thins out, and the end is as far beyond the first as that is beyond the second. This
// is the tip of a cone exactly, and a hundredth beyond the end of a stick at most, but no farther than the outermost
// point; a spike has no such area. Triangles that are long beside the part count in pieces, for one that runs from end
// to end is not all in its middle.
//
// The fitting score of a triangle looks for the best of the six sides. Its distance d from the side's plane, relative
// to the size of the part's cross-section w = sqrt(l1 l2), scores 1 up to d = 0.12 w and falls to 0 at d = 0.7 w; the
// angle between its normal and the side's scores 1 up to 40 degrees and falls to 0 at 90. The score is the product; the
// fit is the area-weighted mean over the part. A clean box scores 1, a round stick about 0.9, a ball about 0.7.

#include "shape/part_box.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "base/quantile.h"
#include "base/ranges.h"
#include "shape/corners.h"
#include "shape/membership.h"

namespace partonomy {

namespace {

constexpr double hardly_rough = 0.005;
constexpr double rounding = 1e-7;  // of the longest side
constexpr double hardly_farther = 0.02;
constexpr double least_wall_share = 0.04;  // of the part's area: less facing one way is no wall
constexpr double noise_deviations = 4;     // median ones: hardly any noise goes beyond
constexpr std::size_t most_samples = 3000;
constexpr double end_quantile = 0.995, thinning_quantile = 0.98;
constexpr int most_pieces = 100;  // of a triangle that is as long as the part
const double facing_cosine = std::cos(40 * std::numbers::pi / 180);
const double slanted_cosine = std::cos(15 * std::numbers::pi / 180);
const double askew_cosine = std::cos(20 * std::numbers::pi / 180);
constexpr double round_share = 1.0 / 3;     // of a round wall one half is askew
constexpr double least_bow = 0.25;          // correlation of places and normals: of a level wall under noise 0
constexpr double least_membership = 0.001;  // a triangle of the part is not outside of it
constexpr Trapezoid near_wall{0, 0, 0.12, 0.7};
constexpr Trapezoid along_wall{0, 0, 40, 90};
const double fully_along_cosine = std::cos(39.9 * std::numbers::pi / 180);  // along_wall is 1: no angle is needed

struct Sides {
    Vec3 low, high;               ///< along the three axes
    bool is_noisy = false;        ///< within the outermost points
    bool has_rough_wall = false;  ///< a level one
};

/// Points with weights, and how far they lie from the plane that fits them best.
struct Patch {
    double area = 0;
    Vec3 sum = Vec3::Zero();
    Eigen::Matrix3d products = Eigen::Matrix3d::Zero();
    void add(const Vec3& point, double weight) {
        area += weight;
        sum += weight * point;
        products += weight * point * point.transpose();
    }
    [[nodiscard]] double variance() const { return area > 0 ? std::max(0.0, solve().eigenvalues()[0]) : 0; }
    /// Whether the plane is clearly no wall across `direction`.
    [[nodiscard]] bool is_slanted(const Vec3& direction) const {
        const auto solution = solve();
        const bool is_plane = solution.eigenvalues()[1] > 9 * solution.eigenvalues()[0];
        return is_plane && std::abs(solution.eigenvectors().col(0).dot(direction)) < slanted_cosine;
    }

private:
    [[nodiscard]] Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solve() const {
        const Vec3 mean = sum / area;
        return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(products / area - mean * mean.transpose());
    }
};

/// Of two values, weighted: in [-1, 1].
struct Correlation {
    double weight = 0;
    Eigen::Vector2d sum = Eigen::Vector2d::Zero();
    Eigen::Matrix2d products = Eigen::Matrix2d::Zero();
    void add(double a, double b, double w) {
        const Eigen::Vector2d both(a, b);
        weight += w;
        sum += w * both;
        products += w * both * both.transpose();
    }
    [[nodiscard]] double value() const {
        const Eigen::Matrix2d m = products / weight - sum * sum.transpose() / (weight * weight);
        return m(0, 0) > 0 && m(1, 1) > 0 ? m(0, 1) / std::sqrt(m(0, 0) * m(1, 1)) : 0;
    }
};

class Measurer {
public:
    Measurer(const TriangleMesh& mesh, const TriangleGeometry& geometry, const std::vector<std::int32_t>& triangles,
             bool is_noisy, int threads)
        : mesh_(mesh), geometry_(geometry), triangles_(triangles), is_noisy_(is_noisy), threads_(threads) {
        const std::vector<std::int32_t> corners = corners_of(mesh, triangles);
        points_.reserve(corners.size());
        for (const std::int32_t v : corners) points_.push_back(mesh.positions[v]);
        const std::size_t stride = 1 + triangles.size() / most_samples;
        for (std::size_t k = 0; k < triangles.size(); ++k) {
            area_ += geometry.areas[triangles[k]];
            if (k % stride == 0) samples_.push_back(triangles[k]);
        }
        for (const std::int32_t t : samples_) sampled_area_ += geometry.areas[t];
    }

    PartBox measure() {
        OrientedBox box = smallest_box(points_);
        const Vec3 middle = box.axes.transpose() * box.centre;
        Sides outer{middle - box.lengths / 2, middle + box.lengths / 2};
        if (!(area_ > 0)) return {box, 1, std::vector<float>(triangles_.size(), 1.0F)};
        if (!is_noisy_ || !is_rough(box.axes, outer)) return fit(box);
        Sides sides = walls(box.axes, outer);
        Eigen::Matrix3d axes = box.axes;
        if (sides.has_rough_wall) {
            axes = mean_axes(box.axes);
            outer = extremes(axes);
            sides = walls(axes, outer);
        }
        if (sides.is_noisy) box = make_box(axes, sides);
        return fit(box);
    }

private:
    [[nodiscard]] Sides extremes(const Eigen::Matrix3d& axes) const {
        Sides sides{axes.transpose() * points_.front(), axes.transpose() * points_.front()};
        for (const Vec3& point : points_) {
            const Vec3 p = axes.transpose() * point;
            sides.low = sides.low.cwiseMin(p);
            sides.high = sides.high.cwiseMax(p);
        }
        return sides;
    }

    /// Whether the two walls that most of the part faces are no planes.
    [[nodiscard]] bool is_rough(const Eigen::Matrix3d& axes, const Sides& outer) const {
        std::array<Patch, 6> patches;
        for (const std::int32_t t : samples_)
            for (int side = 0; side < 6; ++side)
                if ((side % 2 == 0 ? 1 : -1) * geometry_.normals[t].dot(axes.col(side / 2)) > facing_cosine)
                    patches[side].add(geometry_.barycentres[t] - points_.front(), geometry_.areas[t]);
        int most = 0;
        for (const int k : {1, 2})
            if (patches[2 * k].area + patches[2 * k + 1].area > patches[2 * most].area + patches[2 * most + 1].area)
                most = k;
        const Patch &front = patches[2 * most], &back = patches[2 * most + 1];
        const double area = front.area + back.area;
        if (!(area > 0)) return false;
        const double variance = (front.area * front.variance() + back.area * back.variance()) / area;
        const Vec3 lengths = outer.high - outer.low;  // a sheet is no rougher than its rounding
        return std::sqrt(variance) > std::max(hardly_rough * lengths[most], rounding * lengths.maxCoeff());
    }

    [[nodiscard]] Sides walls(const Eigen::Matrix3d& axes, const Sides& outer) {
        Sides sides = outer;
        for (int k = 0; k < 3; ++k) {
            const double length = outer.high[k] - outer.low[k];
            const double middle = (outer.low[k] + outer.high[k]) / 2;
            for (const int sign : {-1, 1}) {
                double& side = sign > 0 ? sides.high[k] : sides.low[k];
                Eigen::Matrix3d frame;
                frame << sign * axes.col(k), axes.col((k + 1) % 3), axes.col((k + 2) % 3);
                const std::optional<double> place = wall(frame, sign * middle);
                const double at = sign * (place ? *place : end(frame.col(0), sign * side, length));
                if (std::abs(side - at) > hardly_farther * length) {
                    side = at;
                    sides.is_noisy = true;
                    sides.has_rough_wall |= place.has_value();
                }
            }
        }
        return sides;
    }

    /// How far out the level wall is that faces the first axis of `frame` beyond `middle`; none where little of the
    /// part faces that way, or the wall is slanted or a round one around a hollow, or much of the part lies farther
    /// out.
    [[nodiscard]] std::optional<double> wall(const Eigen::Matrix3d& frame, double middle) {
        const Vec3 direction = frame.col(0);
        Patch patch;
        std::array<Correlation, 2> bows;  // of places along the wall and normals
        double askew = 0, within = 0, beyond = 0;
        places_.clear();
        for (const std::int32_t t : samples_) {
            const Vec3 normal = frame.transpose() * geometry_.normals[t];
            const double place = geometry_.barycentres[t].dot(direction), area = geometry_.areas[t];
            if (!(normal[0] > facing_cosine)) continue;
            if (!(place > middle)) {
                within += area;
                continue;
            }
            if (normal[0] < askew_cosine) askew += area;
            const Vec3 from_start = geometry_.barycentres[t] - points_.front();
            for (int k = 0; k < 2; ++k) bows[k].add(from_start.dot(frame.col(k + 1)), normal[k + 1], area);
            patch.add(from_start, area);
            places_.emplace_back(place, area);
        }
        const double least_area = least_wall_share * sampled_area_;
        if (!(patch.area > 0) || patch.area < least_area || patch.is_slanted(direction)) return std::nullopt;
        if (within > least_area && askew > round_share * patch.area &&
            std::max(bows[0].value(), bows[1].value()) > least_bow)
            return std::nullopt;
        const double level = quantile(places_, 0.5);
        for (auto& [place, area] : places_) place = std::abs(place - level);
        const double limit = level + noise_deviations * quantile(places_, 0.5);
        for (const std::int32_t t : samples_)
            if (geometry_.barycentres[t].dot(direction) > limit) beyond += geometry_.areas[t];
        return beyond > least_area ? std::nullopt : std::optional(level);
    }

    /// Where the area of the part, `length` long, ends in a direction, at most `outermost`.
    [[nodiscard]] double end(const Vec3& direction, double outermost, double length) {
        places_.clear();
        for (const std::int32_t t : samples_) spread(t, direction, length);
        const double end = quantile(places_, end_quantile);
        return std::min(outermost, 2 * end - quantile(places_, thinning_quantile));
    }

    /// Adds where the area of a triangle lies along a direction: in one place, or in many when it is long.
    void spread(std::int32_t t, const Vec3& direction, double length) {
        const double area = geometry_.areas[t];
        std::array<double, 3> at;
        for (int k = 0; k < 3; ++k) at[k] = mesh_.positions[mesh_.triangles[t][k]].dot(direction);
        std::sort(at.begin(), at.end());
        const auto& [a, b, c] = at;
        if (!(c - a > length / most_pieces)) {
            places_.emplace_back((a + b + c) / 3, area);
            return;
        }
        const auto share_below = [&](double x) {
            return x < b   ? (x - a) * (x - a) / ((b - a) * (c - a))
                   : c > b ? 1 - (c - x) * (c - x) / ((c - b) * (c - a))
                           : 1.0;
        };
        const int pieces = std::min(most_pieces, 1 + static_cast<int>(most_pieces * (c - a) / length));
        double below = 0;
        for (int k = 1; k <= pieces; ++k) {
            const double share = k == pieces ? 1 : share_below(a + k * (c - a) / pieces);
            places_.emplace_back(a + (k - 0.5) * (c - a) / pieces, (share - below) * area);
            below = share;
        }
    }

    /// The axes turned to the mean normals of the walls, the axis with most wall first.
    [[nodiscard]] Eigen::Matrix3d mean_axes(Eigen::Matrix3d axes) const {
        for (int round = 0; round < 5; ++round) {
            Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
            for (const std::int32_t t : samples_) {
                const Vec3 along = axes.transpose() * geometry_.normals[t];
                Eigen::Index k = 0;
                along.cwiseAbs().maxCoeff(&k);
                sum.col(k) += (along[k] > 0 ? geometry_.areas[t] : -geometry_.areas[t]) * geometry_.normals[t];
            }
            std::array<int, 3> order{0, 1, 2};
            std::stable_sort(order.begin(), order.end(),
                             [&](int a, int b) { return sum.col(a).squaredNorm() > sum.col(b).squaredNorm(); });
            if (!(sum.col(order[1]).squaredNorm() > 0)) return axes;
            axes.col(0) = sum.col(order[0]).normalized();
            const Vec3 second = sum.col(order[1]) - axes.col(0) * axes.col(0).dot(sum.col(order[1]));
            axes.col(1) = second.normalized();
            axes.col(2) = axes.col(0).cross(axes.col(1));
        }
        return axes;
    }

    static OrientedBox make_box(const Eigen::Matrix3d& axes, const Sides& sides) {
        Vec3 lengths = (sides.high - sides.low).cwiseMax(0.0);
        lengths = (lengths.array() < rounding * lengths.maxCoeff()).select(0.0, lengths);
        std::array<int, 3> order{0, 1, 2};
        std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return lengths[a] > lengths[b]; });
        OrientedBox box;
        box.centre = axes * ((sides.low + sides.high) / 2);
        for (int k = 0; k < 3; ++k) {
            box.axes.col(k) = axes.col(order[k]);
            box.lengths[k] = lengths[order[k]];
        }
        if (box.axes.determinant() < 0) box.axes.col(2) *= -1;
        return box;
    }

    [[nodiscard]] PartBox fit(const OrientedBox& box) const {
        PartBox part{box, 1, std::vector<float>(triangles_.size(), 1.0F)};
        const double width = std::sqrt(box.lengths[1] * box.lengths[2]);
        if (!(width > 0)) return part;
        constexpr std::size_t chunk = 4096;  // sums of fixed chunks round alike on any number of threads
        std::vector<double> sums((triangles_.size() + chunk - 1) / chunk, 0.0);
        for_each_range(
            sums.size(), threads_,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t c = begin; c < end; ++c) {
                    double sum = 0;
                    for (std::size_t at = c * chunk; at < std::min(triangles_.size(), (c + 1) * chunk); ++at) {
                        const double score = fitting_score(box, width, triangles_[at]);
                        sum += geometry_.areas[triangles_[at]] * score;
                        part.memberships[at] = static_cast<float>(std::max(score, least_membership));
                    }
                    sums[c] = sum;
                }
            },
            4);
        part.fit = std::min(1.0, std::accumulate(sums.begin(), sums.end(), 0.0) / area_);
        return part;
    }

    [[nodiscard]] double fitting_score(const OrientedBox& box, double width, std::int32_t t) const {
        const Vec3 along = box.axes.transpose() * geometry_.normals[t];
        const Vec3 place = box.axes.transpose() * (geometry_.barycentres[t] - box.centre);
        double best = 0;
        for (int k = 0; k < 3; ++k) {
            const double sign = along[k] > 0 ? 1 : -1;
            const double distance = std::abs(sign * place[k] - box.lengths[k] / 2);
            const double near = near_wall(distance / width);
            if (near <= best) continue;
            if (std::abs(along[k]) > fully_along_cosine) {
                best = near;
                continue;
            }
            const double angle = std::acos(std::abs(along[k])) * 180 / std::numbers::pi;
            best = std::max(best, near * along_wall(angle));
        }
        return best;
    }

    const TriangleMesh& mesh_;
    const TriangleGeometry& geometry_;
    const std::vector<std::int32_t>& triangles_;
    bool is_noisy_;
    int threads_;
    std::vector<std::int32_t> samples_;  ///< what walls are measured on: medians need no more
    std::vector<Vec3> points_;
    std::vector<Weighted> places_;
    double area_ = 0, sampled_area_ = 0;
};

}  // namespace

PartBox measure_part(const TriangleMesh& mesh, const TriangleGeometry& geometry,
                     const std::vector<std::int32_t>& triangles, bool is_noisy, int threads) {
    return Measurer(mesh, geometry, triangles, is_noisy, threads).measure();
}

}  // namespace partonomy
