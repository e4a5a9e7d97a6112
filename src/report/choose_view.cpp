// Eight views, seen from 27 degrees above the horizon: each of the four sides of the object, from 33 degrees to its
// left and to its right. The sides are those of the vertical faces: with n their horizontal normals as complex numbers,
// the argument of sum area * n^4 is four times their common direction, since n^4 is the same for n, i n, -n and -i n.
//
// A view is as good as the sum over the parts of the square root of the pixels that show it: the root makes a hidden
// leg worth more than a larger tabletop. Points spread over the surface and 24 x 24 pixels a view answer that well
// enough, whatever the number of triangles.
//
// The object fills the picture from wherever it is seen, so a spoon along its length would fill it best. A long and
// slim object, the slimmer the more, therefore loses by how much shorter it looks than it is.

#include "report/choose_view.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

#include "base/ranges.h"

namespace partonomy {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double elevation = 27 * degree, azimuth = 33 * degree;

Vec3 any_horizontal(const Vec3& up) {
    int axis = 0;
    for (int i = 1; i < 3; ++i)
        if (std::abs(up[i]) < std::abs(up[axis]) - 1e-9) axis = i;
    return (Vec3::Unit(axis) - up * up[axis]).normalized();
}

/// What the surface says about its sides, in the horizontal plane spanned by two directions.
struct Sides {
    double angle = 0;  ///< of the vertical faces' normals
    std::complex<double> tall_end =
        0;  ///< where the object is tall, as seen from its middle: correlation with height, length <= 1
};

Sides find_sides(const PlacedMesh& mesh, const Vec3& up, const Vec3& first, const Vec3& second) {
    using Complex = std::complex<double>;
    Complex fourth = 0, place_sum = 0, place_height_sum = 0;
    double area_sum = 0, height_sum = 0, height_square = 0, place_square = 0;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t) {
        const Vec3 corner = mesh.corner(t, 0);
        const Vec3 side = mesh.corner(t, 1) - corner, other_side = mesh.corner(t, 2) - corner;
        const Vec3 cross = side.cross(other_side), middle = corner + (side + other_side) / 3;
        const double area = cross.norm(), height = middle.dot(up);
        const Complex place(middle.dot(first), middle.dot(second)), normal(cross.dot(first), cross.dot(second));
        area_sum += area;
        height_sum += area * height;
        height_square += area * height * height;
        place_sum += area * place;
        place_square += area * std::norm(place);
        place_height_sum += area * height * place;
        const double length = std::abs(normal);
        if (length == 0) continue;
        const Complex square = (normal / length) * (normal / length);
        fourth += length * square * square;
    }
    Sides sides;
    if (!(area_sum > 0)) return sides;
    if (std::abs(fourth) > 1e-9 * area_sum) sides.angle = std::arg(fourth) / 4;
    const double spread =
        (height_square - height_sum * height_sum / area_sum) * (place_square - std::norm(place_sum) / area_sum);
    if (spread > 1e-12 * area_sum * area_sum)
        sides.tall_end = (place_height_sum - place_sum * height_sum / area_sum) / std::sqrt(spread);
    return sides;
}

Camera look_from(const Vec3& up, const Vec3& towards) {
    Camera camera;
    camera.into = -(std::cos(elevation) * towards + std::sin(elevation) * up);
    camera.right = camera.into.cross(up).normalized();
    camera.down = camera.into.cross(camera.right);
    return camera;
}

/// A point of the surface and the part it belongs to (-1 for none).
struct SurfacePoint {
    Vec3 place;
    std::int32_t part;
};

/// Points spread evenly over the surface: one every so much area, within its triangle where the next point of a
/// sequence without clusters falls (the plastic number's).
std::vector<SurfacePoint> spread_points(const PlacedMesh& mesh, const Annotation& annotation, int count) {
    std::vector<double> areas(mesh.triangle_count());
    double area_sum = 0;
    for (std::size_t t = 0; t < areas.size(); ++t) {
        const Vec3 corner = mesh.corner(t, 0);
        areas[t] = (mesh.corner(t, 1) - corner).cross(mesh.corner(t, 2) - corner).norm();
        area_sum += areas[t];
    }
    std::vector<SurfacePoint> points;
    if (!(area_sum > 0)) return points;
    points.reserve(static_cast<std::size_t>(count) + 1);
    const double step = area_sum / count;
    double next = step / 2, passed = 0, u = 0.5, v = 0.5;
    for (std::size_t t = 0; t < areas.size(); ++t) {
        passed += areas[t];
        if (passed <= next) continue;
        const std::array<Vec3, 3> corners{mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)};
        for (; next < passed; next += step) {
            u += 0.7548776662466927, v += 0.5698402909980532;
            if (u >= 1) u -= 1;
            if (v >= 1) v -= 1;
            const double s = u + v > 1 ? 1 - u : u, r = u + v > 1 ? 1 - v : v;
            points.push_back({corners[0] + s * (corners[1] - corners[0]) + r * (corners[2] - corners[0]),
                              annotation.part_of_triangle[t]});
        }
    }
    return points;
}

/// Along what a long and slim object runs, and how slim it is.
struct Length {
    Vec3 direction = Vec3::UnitZ();
    double slimness = 0;  ///< [0, 1]: 0 where the points spread a third as widely, or more, in another direction

    /// What a view is worth that looks into a direction: 1 across, less where the object looks shorter.
    [[nodiscard]] double worth(const Vec3& into) const {
        const double along = into.dot(direction);
        return 1 - slimness * along * along;
    }
};

Length find_length(const std::vector<SurfacePoint>& points) {
    if (points.empty()) return {};
    Vec3 middle = Vec3::Zero();
    for (const SurfacePoint& point : points) middle += point.place / static_cast<double>(points.size());
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const SurfacePoint& point : points) spread += (point.place - middle) * (point.place - middle).transpose();
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);  // ascending
    const double longest = axes.eigenvalues()[2], next = std::max(0.0, axes.eigenvalues()[1]);
    if (!(longest > 0)) return {};
    return {axes.eigenvectors().col(2), std::max(0.0, 1 - 3 * std::sqrt(next / longest))};
}

/// A rectangle that grows around what the camera sees.
struct View {
    double left = std::numeric_limits<double>::infinity(), right = -left, top = left, bottom = -left;

    void add(double x, double y) {
        left = std::min(left, x), right = std::max(right, x);
        top = std::min(top, y), bottom = std::max(bottom, y);
    }

    /// Scale and centre that let it fill the frame.
    void fit(Camera& camera, const Frame& frame) const {
        if (left > right) return;
        camera.scale =
            std::min(frame.width / std::max(right - left, 1e-6), frame.height / std::max(bottom - top, 1e-6));
        camera.center_x = frame.left + frame.width / 2.0 - camera.scale * (left + right) / 2;
        camera.center_y = frame.top + frame.height / 2.0 - camera.scale * (top + bottom) / 2;
    }
};

/// Fits the camera to the points and counts the pixels that show each part.
double goodness(const std::vector<SurfacePoint>& points, Camera camera, std::size_t parts) {
    constexpr int size = 24;
    View view;
    for (const SurfacePoint& point : points) view.add(point.place.dot(camera.right), point.place.dot(camera.down));
    view.fit(camera, {0, 0, size, size});
    struct Pixel {
        double depth = std::numeric_limits<double>::infinity();
        std::int32_t part = -2;
    };
    std::array<Pixel, static_cast<std::size_t>(size * size)> pixels;
    for (const SurfacePoint& point : points) {
        const Vec3 seen = camera.see(point.place);
        const int x = std::clamp(static_cast<int>(seen.x()), 0, size - 1);
        const int y = std::clamp(static_cast<int>(seen.y()), 0, size - 1);
        Pixel& pixel = pixels[static_cast<std::size_t>(y * size + x)];
        if (seen.z() < pixel.depth) pixel = {seen.z(), point.part};
    }
    std::vector<int> counts(parts + 1, 0);
    for (const Pixel& pixel : pixels)
        if (pixel.part > -2) ++counts[static_cast<std::size_t>(pixel.part + 1)];
    double sum = 0;
    for (const int count : counts) sum += std::sqrt(count);
    return sum;
}

}  // namespace

Camera choose_view(const PlacedMesh& mesh, const Annotation& annotation, const Vec3& up, const Frame& frame,
                   int threads) {
    constexpr int point_count = 4096;
    const Vec3 top = up.stableNormalized();
    const Vec3 first = any_horizontal(top), second = top.cross(first);
    const Sides sides = find_sides(mesh, top, first, second);
    const std::vector<SurfacePoint> points = spread_points(mesh, annotation, point_count);
    const Length length = find_length(points);
    std::array<Camera, 8> cameras;
    std::array<double, 8> values{};
    for_each_range(
        cameras.size(), threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i) {
                const double side = static_cast<double>(i / 2) * 90 * degree;
                const double angle = sides.angle - 90 * degree + side + (i % 2 == 0 ? azimuth : -azimuth);
                cameras[i] = look_from(top, std::cos(angle) * first + std::sin(angle) * second);
                const double tall_in_front = (sides.tall_end * std::polar(1.0, -angle)).real();
                values[i] = goodness(points, cameras[i], annotation.parts.size()) * (1 - 0.25 * tall_in_front) *
                            length.worth(cameras[i].into);
            }
        },
        4);
    std::size_t chosen = 0;
    for (std::size_t i = 1; i < cameras.size(); ++i)
        if (values[i] > values[chosen] * 1.02) chosen = i;  // a small gain may be chance
    Camera best = cameras[chosen];
    View view;
    for (std::size_t t = 0; t < mesh.triangle_count(); ++t)
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3 corner = mesh.corner(t, i);
            view.add(corner.dot(best.right), corner.dot(best.down));
        }
    view.fit(best, frame);
    return best;
}

}  // namespace partonomy
