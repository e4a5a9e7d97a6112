// Fitting planes, cylinders, spheres, cones and tori to points with normals, by linear least squares only.
//
//   plane     the direction in which the points spread least
//   cylinder  the axis is the direction that all normals are most perpendicular to; a circle in the projection along it
//   sphere    |p|² = 2 c·p + d
//   cone      the normals keep one angle with the axis, so they spread least along it; the axis passes where the
//             projected normal lines meet; the radius grows linearly along it
//   torus     all normal lines meet the axis of a surface of revolution: of the linear complexes a·(p x n) + b·n = 0
//             the one with the least squares (Pottmann and Randrup 1998); then a circle in the half plane about the
//             axis
//
// A fit counts when its normals are those of the points: two walls back to back are no plane. Distances are cut at the
// nearest nineteen twentieths, so that a rim that noise has blurred does not spoil a patch. O(#points) each.

#include "shape/primitive.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace partonomy {
namespace {

constexpr double kept_share = 0.95;
constexpr double most_turned = 25 * std::numbers::pi / 180;  // mean angle between normals
constexpr double flat_radius = 12;                           // of the size: rounder than that is flat
constexpr double least_slope = 0.015;                        // of a cone; less is a cylinder
// Residual that counts as fitting, and as hardly worse than the best: of the root of the area, or of the radius.
constexpr double fitting = 0.008, alike = 0.003, fitting_of_radius = 0.03;

using Matrix6 = Eigen::Matrix<double, 6, 6>;
using Vector6 = Eigen::Matrix<double, 6, 1>;

struct Frame {
    Vec3 middle = Vec3::Zero();
    double size = 0;  ///< root mean square distance from the middle
};

Frame frame_of(const std::vector<Vec3>& points) {
    Frame frame;
    for (const Vec3& p : points) frame.middle += p / static_cast<double>(points.size());
    for (const Vec3& p : points) frame.size += (p - frame.middle).squaredNorm() / static_cast<double>(points.size());
    frame.size = std::sqrt(frame.size);
    return frame;
}

/// Unit eigenvector of the least eigenvalue.
Vec3 least_direction(const Eigen::Matrix3d& matrix) {
    return Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(matrix).eigenvectors().col(0);
}

struct Circle {
    double x = 0, y = 0, radius = 0;
};

std::optional<Circle> fit_circle(const std::vector<Eigen::Vector2d>& points) {
    Eigen::Matrix3d a = Eigen::Matrix3d::Zero();
    Vec3 b = Vec3::Zero();
    for (const Eigen::Vector2d& p : points) {
        const Vec3 row(2 * p.x(), 2 * p.y(), 1);
        a += row * row.transpose();
        b += p.squaredNorm() * row;
    }
    const Vec3 solution = a.ldlt().solve(b);
    const double squared = solution[2] + solution[0] * solution[0] + solution[1] * solution[1];
    if (!(squared > 0) || !std::isfinite(squared)) return std::nullopt;
    return Circle{solution[0], solution[1], std::sqrt(squared)};
}

Primitive fit_plane(const PointSet& set, const Frame& frame) {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3& p : set.points) spread += (p - frame.middle) * (p - frame.middle).transpose();
    return {SurfaceKind::flat, frame.middle, least_direction(spread)};
}

std::optional<Primitive> fit_cylinder(const PointSet& set, const Frame& frame) {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3& n : set.normals) spread += n * n.transpose();
    const Vec3 axis = least_direction(spread), x = axis.unitOrthogonal(), y = axis.cross(x);
    std::vector<Eigen::Vector2d> flat;
    for (const Vec3& p : set.points)
        flat.emplace_back((p - frame.middle).dot(x) / frame.size, (p - frame.middle).dot(y) / frame.size);
    const auto circle = fit_circle(flat);
    if (!circle || circle->radius > flat_radius) return std::nullopt;
    return Primitive{SurfaceKind::cylinder, frame.middle + frame.size * (circle->x * x + circle->y * y), axis,
                     circle->radius * frame.size};
}

std::optional<Primitive> fit_sphere(const PointSet& set, const Frame& frame) {
    Eigen::Matrix4d a = Eigen::Matrix4d::Zero();
    Eigen::Vector4d b = Eigen::Vector4d::Zero();
    for (const Vec3& point : set.points) {
        const Vec3 p = (point - frame.middle) / frame.size;
        const Eigen::Vector4d row(2 * p.x(), 2 * p.y(), 2 * p.z(), 1);
        a += row * row.transpose();
        b += p.squaredNorm() * row;
    }
    const Eigen::Vector4d solution = a.ldlt().solve(b);
    const double squared = solution[3] + solution.head<3>().squaredNorm();
    if (!(squared > 0) || !std::isfinite(squared) || squared > flat_radius * flat_radius) return std::nullopt;
    return Primitive{SurfaceKind::sphere, frame.middle + frame.size * solution.head<3>(), Vec3::UnitZ(),
                     std::sqrt(squared) * frame.size};
}

std::optional<Primitive> fit_cone(const PointSet& set, const Frame& frame) {
    Vec3 mean = Vec3::Zero();
    for (const Vec3& n : set.normals) mean += n / static_cast<double>(set.normals.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const Vec3& n : set.normals) spread += (n - mean) * (n - mean).transpose();
    const Vec3 axis = least_direction(spread);
    Eigen::Matrix3d a = 1e-12 * Eigen::Matrix3d::Identity();
    Vec3 b = Vec3::Zero();
    for (std::size_t i = 0; i < set.points.size(); ++i) {  // where the projected normal lines meet
        const Vec3 across = set.normals[i] - axis * axis.dot(set.normals[i]);
        if (across.squaredNorm() < 1e-6) continue;
        const Vec3 side = axis.cross(across).normalized();
        a += side * side.transpose();
        b += side * side.dot((set.points[i] - frame.middle) / frame.size);
    }
    a += axis * axis.transpose();
    const Vec3 point = frame.middle + frame.size * Vec3(a.ldlt().solve(b));
    double hh = 0, hr = 0, h1 = 0, r1 = 0;
    const auto count = static_cast<double>(set.points.size());
    for (const Vec3& p : set.points) {
        const double h = (p - point).dot(axis), r = (p - point - h * axis).norm();
        hh += h * h / count, hr += h * r / count, h1 += h / count, r1 += r / count;
    }
    const double variance = hh - h1 * h1;
    if (!(variance > 0)) return std::nullopt;
    const double slope = (hr - h1 * r1) / variance;
    if (!std::isfinite(slope) || std::abs(slope) < least_slope || r1 > flat_radius * frame.size) return std::nullopt;
    return Primitive{SurfaceKind::cone, point, axis, r1 - slope * h1, slope};
}

std::optional<Primitive> fit_torus(const PointSet& set, const Frame& frame) {
    Matrix6 spread = Matrix6::Zero();
    for (std::size_t i = 0; i < set.points.size(); ++i) {
        Vector6 line;
        line << ((set.points[i] - frame.middle) / frame.size).cross(set.normals[i]), set.normals[i];
        spread += line * line.transpose();
    }
    const Vector6 complex = Eigen::SelfAdjointEigenSolver<Matrix6>(spread).eigenvectors().col(0);
    const Vec3 a = complex.head<3>(), moment = complex.tail<3>();
    if (a.norm() < 1e-3) return std::nullopt;
    const Vec3 axis = a.normalized();
    const Vec3 point = frame.middle + frame.size * Vec3(a.cross(moment) / a.squaredNorm());
    std::vector<Eigen::Vector2d> half_plane;
    for (const Vec3& p : set.points) {
        const double h = (p - point).dot(axis);
        half_plane.emplace_back(h / frame.size, (p - point - h * axis).norm() / frame.size);
    }
    const auto circle = fit_circle(half_plane);
    if (!circle || circle->radius > flat_radius || !(circle->y > 0) || circle->y > flat_radius) return std::nullopt;
    return Primitive{SurfaceKind::torus, point + frame.size * circle->x * axis, axis, frame.size * circle->y,
                     frame.size * circle->radius};
}

/// Angle between two lines along unit vectors, within 0.3 %: by the series of the arc over its chord.
double angle_of_lines(const Vec3& a, const Vec3& b) {
    const double squared = 2 - 2 * std::min(1.0, std::abs(a.dot(b)));  // of the chord
    return std::sqrt(squared) * (1 + squared * (1.0 / 24 + squared * (3.0 / 640 + squared * (5.0 / 7168))));
}

/// Fills in the residual; false when the normals are others.
bool judge(const PointSet& set, Primitive& primitive) {
    const double limit = most_turned * static_cast<double>(set.points.size());
    double turned = 0;
    for (std::size_t i = 0; i < set.points.size() && turned <= limit; ++i)
        turned += angle_of_lines(primitive.normal(set.points[i]), set.normals[i]);
    if (!(turned <= limit)) return false;
    std::vector<double> squares;
    squares.reserve(set.points.size());
    for (const Vec3& p : set.points) {
        const double d = primitive.distance(p);
        squares.push_back(d * d);
    }
    const auto kept = static_cast<std::size_t>(std::ceil(kept_share * static_cast<double>(squares.size())));
    if (kept < squares.size()) std::ranges::nth_element(squares, squares.begin() + static_cast<std::ptrdiff_t>(kept));
    double sum = 0;
    for (std::size_t i = 0; i < kept; ++i) sum += squares[i];
    primitive.residual = std::sqrt(sum / static_cast<double>(kept));
    return std::isfinite(primitive.residual);
}

/// What `fitting` and `alike` are shares of: a thin round stick has a large area, and yet its radius is small.
double measure_of(const Primitive& primitive, double size) {
    const double round = primitive.kind == SurfaceKind::torus ? primitive.slope : primitive.radius;
    const bool is_round = primitive.kind == SurfaceKind::cylinder || primitive.kind == SurfaceKind::sphere ||
                          primitive.kind == SurfaceKind::torus;
    return is_round ? std::min(size, fitting_of_radius / fitting * round) : size;
}

void add_fit(const PointSet& set, std::optional<Primitive> primitive, std::vector<Primitive>& fits) {
    if (primitive && judge(set, *primitive)) fits.push_back(*primitive);
}

void add_round_fits(const PointSet& set, const Frame& frame, std::vector<Primitive>& fits) {
    add_fit(set, fit_cylinder(set, frame), fits);
    add_fit(set, fit_sphere(set, frame), fits);
    add_fit(set, fit_cone(set, frame), fits);
    add_fit(set, fit_torus(set, frame), fits);
}

}  // namespace

double Primitive::distance(const Vec3& at) const {
    const Vec3 way = at - point;
    const double h = way.dot(axis), r = (way - h * axis).norm();
    switch (kind) {
        case SurfaceKind::flat:
            return std::abs(h);
        case SurfaceKind::cylinder:
            return std::abs(r - radius);
        case SurfaceKind::sphere:
            return std::abs(way.norm() - radius);
        case SurfaceKind::cone:
            return std::abs(r - radius - slope * h) / std::sqrt(1 + slope * slope);
        case SurfaceKind::torus:
            return std::abs(std::hypot(r - radius, h) - slope);
        default:
            return 0;
    }
}

Vec3 Primitive::normal(const Vec3& at) const {
    const Vec3 way = at - point;
    const double h = way.dot(axis);
    const Vec3 outward = way - h * axis;
    const Vec3 across = outward.norm() > 0 ? Vec3(outward.normalized()) : axis.unitOrthogonal();
    Vec3 result = axis;
    if (kind == SurfaceKind::cylinder) result = across;
    if (kind == SurfaceKind::sphere) result = way;
    if (kind == SurfaceKind::cone) result = across - slope * axis;
    if (kind == SurfaceKind::torus) result = way - radius * across;
    return result.norm() > 0 ? Vec3(result.normalized()) : axis;
}

double tolerance(const Primitive& primitive, double size, double noise) {
    return fitting * measure_of(primitive, size) + noise;
}

double residual_of(const PointSet& set, const Primitive& primitive) {
    double sum = 0;
    for (const Vec3& p : set.points) sum += primitive.distance(p) * primitive.distance(p);
    return set.points.empty() ? 0 : std::sqrt(sum / static_cast<double>(set.points.size()));
}

std::vector<Primitive> fit_primitives(const PointSet& set) {
    std::vector<Primitive> fits;
    const Frame frame = frame_of(set.points);
    if (!(frame.size > 0)) return fits;
    add_fit(set, fit_plane(set, frame), fits);
    add_round_fits(set, frame, fits);
    return fits;
}

Primitive fit_primitive(const PointSet& set, double size, double noise) {
    std::vector<Primitive> fits;
    const Frame frame = frame_of(set.points);
    Primitive nothing;
    if (!(frame.size > 0)) return nothing;
    const auto is_good = [&](const Primitive& fit, double best) {
        return fit.residual <= 1.5 * best + alike * measure_of(fit, size) + noise / 2 &&
               fit.residual <= tolerance(fit, size, noise);
    };
    add_fit(set, fit_plane(set, frame), fits);
    if (!fits.empty() && is_good(fits.front(), 0)) return fits.front();  // whatever else would fit
    add_round_fits(set, frame, fits);
    if (fits.empty()) return nothing;
    nothing.residual = std::ranges::min_element(fits, {}, &Primitive::residual)->residual;
    const auto first = std::ranges::find_if(fits, [&](const Primitive& fit) { return is_good(fit, nothing.residual); });
    return first != fits.end() ? *first : nothing;
}

}  // namespace partonomy
