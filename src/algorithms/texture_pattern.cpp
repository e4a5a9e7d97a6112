/* Stripes, checks and grain, told by the waves in a region's colours.
 *
 * The two larger sides of the region's box are looked at from the front, one after the other, through a window of 64 x
 * 64 points that fits them; the one whose colours vary more is judged. The colours along their main axis (red and white
 * stripes: the line from red to white) are a picture in grey, and its Fourier transform tells its waves:
 *
 *     stripes      one wave with its harmonics holds most of the variance, about 0.9 of it
 *     checks       two waves that cross, of like strength: 0.66 for a chessboard, more for a plaid
 *     grain        no wave holds much, and little is in waves of one period: not a border between two colours, or a
 * shade
 *
 * A wave is a peak: no neighbour is stronger, and its own neighbours count with it, since a pattern seldom has a whole
 * number of periods in the window. Waves of fewer than two periods are no pattern. Cost: 64^3 products, about a
 * millisecond, once a region. Patterns of more than about 20 periods across a region are too fine for the window. */

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "algorithms/appearance.h"
#include "mesh/appearance.h"

namespace partonomy {
namespace {

constexpr int side = 64, waves = 24;  // points of the window, periods at most
constexpr double facing = 0.7;        // cosine between a triangle's normal and the look
constexpr double least_spread = 0.01;

using Window = std::vector<Eigen::Vector3d>;  ///< OKLab by point, not a number where the region is not

/// The window's place: along two sides of the region's box.
struct Frame {
    Vec3 x, y;
    Eigen::Vector2d low, size;
    Frame(const Object& object, const std::vector<std::int32_t>& triangles, const Vec3& along, const Vec3& across)
        : x(along), y(across) {
        Eigen::Vector2d high = Eigen::Vector2d::Constant(-std::numeric_limits<double>::infinity());
        low = -high;
        for (const std::int32_t t : triangles)
            for (const std::int32_t corner : object.mesh.triangles[static_cast<std::size_t>(t)]) {
                const Vec3& p = object.mesh.positions[static_cast<std::size_t>(corner)];
                low = low.cwiseMin(Eigen::Vector2d(p.dot(x), p.dot(y)));
                high = high.cwiseMax(Eigen::Vector2d(p.dot(x), p.dot(y)));
            }
        size = (high - low).cwiseMax(1e-12 * (high - low).maxCoeff() + std::numeric_limits<double>::min());
    }
    [[nodiscard]] Eigen::Vector2d place(const Vec3& p) const {
        return (Eigen::Vector2d(p.dot(x), p.dot(y)) - low).cwiseQuotient(size) * side;
    }
};

/// What is seen of the region along the side `axis` of its box, or against it when `sign` is -1.
Window look_along(const Object& object, const RegionMeasurements& region, int axis, int sign) {
    const Vec3 look = sign * region.axes.col(axis);
    std::vector<std::int32_t> front;
    for (const std::int32_t t : region.triangles)
        if (object.geometry.normals[static_cast<std::size_t>(t)].dot(look) > facing &&
            object.geometry.areas[static_cast<std::size_t>(t)] > 0)
            front.push_back(t);
    if (front.empty()) return {};
    const Frame frame(object, front, region.axes.col((axis + 1) % 3), region.axes.col((axis + 2) % 3));
    Window window(side * side, Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN()));
    for (const std::int32_t triangle : front) {
        const auto t = static_cast<std::size_t>(triangle);
        std::array<Eigen::Vector2d, 3> p;
        for (std::size_t i = 0; i < 3; ++i)
            p[i] = frame.place(object.mesh.positions[static_cast<std::size_t>(object.mesh.triangles[t][i])]);
        const Eigen::Vector2d e = p[1] - p[0], f = p[2] - p[0];
        const double twice = e.x() * f.y() - e.y() * f.x();
        if (twice == 0) continue;
        const auto first = [](double a, double b, double c) {
            return std::clamp(static_cast<int>(std::floor(std::min({a, b, c}) - 0.5)), 0, side - 1);
        };
        const auto last = [](double a, double b, double c) {
            return std::clamp(static_cast<int>(std::ceil(std::max({a, b, c}) - 0.5)), 0, side - 1);
        };
        for (int y = first(p[0].y(), p[1].y(), p[2].y()); y <= last(p[0].y(), p[1].y(), p[2].y()); ++y)
            for (int x = first(p[0].x(), p[1].x(), p[2].x()); x <= last(p[0].x(), p[1].x(), p[2].x()); ++x) {
                Eigen::Vector3d& point = window[static_cast<std::size_t>(y * side + x)];
                if (!std::isnan(point.x())) continue;
                const Eigen::Vector2d d = Eigen::Vector2d(x + 0.5, y + 0.5) - p[0];
                const double a = (d.x() * f.y() - d.y() * f.x()) / twice, b = (e.x() * d.y() - e.y() * d.x()) / twice;
                if (a < -1e-9 || b < -1e-9 || a + b > 1 + 1e-9) continue;
                const Color color = object.appearance->color_at(t, Eigen::Vector3d(1 - a - b, a, b).cast<float>());
                if (!is_known(color)) continue;
                const Lab lab = lab_from_linear(color);
                point = {lab.lightness, lab.a, lab.b};
            }
    }
    return window;
}

/// The window along the main axis of its colours, their mean taken off; 0 where the region is not. `variance`: the sum
/// of squares.
std::vector<double> in_grey(const Window& window, double& variance) {
    Eigen::Vector3d mean = Eigen::Vector3d::Zero();
    int count = 0;
    for (const auto& p : window)
        if (!std::isnan(p.x())) mean += p, ++count;
    std::vector<double> grey(window.size(), 0.0);
    variance = 0;
    if (count == 0) return grey;
    mean /= count;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const auto& p : window)
        if (!std::isnan(p.x())) spread += (p - mean) * (p - mean).transpose();
    const Eigen::Vector3d axis = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
    for (std::size_t i = 0; i < window.size(); ++i)
        if (!std::isnan(window[i].x())) grey[i] = (window[i] - mean).dot(axis), variance += grey[i] * grey[i];
    if (variance < count * least_spread * least_spread) variance = 0;
    return grey;
}

/// Shares of the variance by wave: k periods along the window, l across it. A wave and its opposite are one.
class Spectrum {
public:
    Spectrum(const std::vector<double>& grey, double variance)
        : power_((waves + 1) * width, 0.0), used_(power_.size()) {
        using Number = std::complex<double>;
        std::array<Number, side> turn;
        for (int i = 0; i < side; ++i)
            turn[static_cast<std::size_t>(i)] = std::polar(1.0, -2 * std::numbers::pi * i / side);
        const auto turned = [&](int i) { return turn[static_cast<std::size_t>(((i % side) + side) % side)]; };
        std::array<Number, side> column;
        for (int k = 0; k <= waves; ++k) {
            for (int y = 0; y < side; ++y) {
                Number sum = 0;
                for (int x = 0; x < side; ++x) sum += grey[static_cast<std::size_t>(y * side + x)] * turned(k * x);
                column[static_cast<std::size_t>(y)] = sum;
            }
            for (int l = -waves; l <= waves; ++l) {
                Number sum = 0;
                for (int y = 0; y < side; ++y) sum += column[static_cast<std::size_t>(y)] * turned(l * y);
                power_[at(k, l)] = 2 * std::norm(sum) / (side * side * variance);
            }
        }
        for (int l = -waves; l <= 0; ++l) power_[at(0, l)] = 0;  // those of k = 0, l > 0 stand for them
    }

    struct Wave {
        int k = 0, l = 0;
        double share = 0;
    };

    /// The strongest wave of two periods or more that no neighbour outdoes and that does not run along `other`, with
    /// its neighbours and harmonics; takes them out.
    Wave take_strongest(const Wave& other) {
        Wave best;
        double most = 0;
        for (int k = 0; k <= waves; ++k)
            for (int l = -waves; l <= waves; ++l) {
                if (std::max(k, std::abs(l)) < 2 || !is_peak(k, l)) continue;
                const double cross = k * other.l - l * other.k;
                if (other.share > 0 && std::abs(cross) < 0.3 * std::hypot(k, l) * std::hypot(other.k, other.l))
                    continue;
                if (const double sum = around(k, l, false); sum > most) {
                    most = sum;
                    best = {k, l, 0};
                }
            }
        if (most > 0)
            for (int n = 1; n * std::max(best.k, std::abs(best.l)) <= waves; ++n)
                best.share += around(n * best.k, n * best.l, true);
        return best;
    }

    [[nodiscard]] double low() const {
        double sum = 0;
        for (int k = 0; k <= 1; ++k)
            for (int l = -1; l <= 1; ++l) sum += power_[at(k, l)];
        return sum;
    }

private:
    static constexpr int width = 2 * waves + 1;
    static std::size_t at(int k, int l) { return static_cast<std::size_t>(k * width + l + waves); }
    /// The place of a wave, or of its opposite; nowhere beyond the finest.
    static std::optional<std::size_t> place(int k, int l) {
        if (k < 0 || (k == 0 && l < 0)) k = -k, l = -l;
        if (k > waves || std::abs(l) > waves || (k == 0 && l == 0)) return std::nullopt;
        return at(k, l);
    }
    [[nodiscard]] bool is_peak(int k, int l) const {
        const double own = power_[at(k, l)];
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j)
                if (const auto other = place(k + i, l + j); other && power_[*other] > own) return false;
        return own > 0;
    }
    double around(int k, int l, bool take) {
        double sum = 0;
        std::array<std::size_t, 9> seen{};
        std::size_t count = 0;
        for (int i = -1; i <= 1; ++i)
            for (int j = -1; j <= 1; ++j) {
                const auto other = place(k + i, l + j);
                if (!other || used_[*other] ||
                    std::find(seen.begin(), seen.begin() + count, *other) != seen.begin() + count)
                    continue;
                seen[count++] = *other;
                sum += power_[*other];
                if (take) used_[*other] = true;
            }
        return sum;
    }

    std::vector<double> power_;
    std::vector<bool> used_;
};

RegionPattern measure_pattern(const Object& object, const RegionMeasurements& region) {
    Vec3 seen_along = Vec3::Zero();
    for (const std::int32_t t : region.triangles)
        seen_along += object.geometry.areas[static_cast<std::size_t>(t)] *
                      (region.axes.transpose() * object.geometry.normals[static_cast<std::size_t>(t)]).cwiseAbs2();
    int axis = 0;
    seen_along.maxCoeff(&axis);
    double variance = 0;
    std::vector<double> grey;
    for (const int sign : {1, -1}) {
        double own = 0;
        std::vector<double> seen = in_grey(look_along(object, region, axis, sign), own);
        if (own <= variance) continue;
        variance = own;
        grey = std::move(seen);
    }
    RegionPattern pattern;
    if (!(variance > 0)) return pattern;
    Spectrum spectrum(grey, variance);
    const double low = spectrum.low();
    const Spectrum::Wave first = spectrum.take_strongest({}), second = spectrum.take_strongest(first);
    pattern.stripes = std::max(0.0, first.share - second.share);
    pattern.checks = 2 * std::min(first.share, second.share);
    pattern.grain = std::max(0.0, 1 - low - first.share - second.share);
    return pattern;
}

}  // namespace

const RegionPattern& look_at_pattern(const Object& object, const RegionMeasurements& region) {
    if (!region.pattern) region.pattern = std::make_shared<const RegionPattern>(measure_pattern(object, region));
    return *region.pattern;
}

}  // namespace partonomy
