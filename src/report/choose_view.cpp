// Eight views, seen from 27 degrees above the horizon: each of the four sides of the object, from 33 degrees to its
// left and to its right. The sides are those of the vertical faces: with n their horizontal normals as complex numbers,
// the argument of sum area * n^4 is four times their common direction, since n^4 is the same for n, i n, -n and -i n.
//
// A view is as good as the sum over the parts of the square root of the pixels that show it: the root makes a hidden
// leg worth more than a larger tabletop. 32 x 32 rays a view answer that well enough.

#include "report/choose_view.h"

#include <Eigen/Geometry>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>

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

Sides find_sides(const PictureRays& rays, const TriangleMesh& mesh, const Vec3& up, const Vec3& first,
                 const Vec3& second) {
    using Complex = std::complex<double>;
    Complex fourth = 0, place_sum = 0, place_height_sum = 0;
    double area_sum = 0, height_sum = 0, height_square = 0, place_square = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
        const Vec3 corner = rays.place(mesh.positions[static_cast<std::size_t>(a)]);
        const Vec3 side = rays.place(mesh.positions[static_cast<std::size_t>(b)]) - corner;
        const Vec3 other_side = rays.place(mesh.positions[static_cast<std::size_t>(c)]) - corner;
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

/// Scale and centre that let the used points fill the frame.
void fit(Camera& camera, const PictureRays& rays, const TriangleMesh& mesh, const Frame& frame) {
    const double infinity = std::numeric_limits<double>::infinity();
    double left = infinity, right = -infinity, top = infinity, bottom = -infinity;
    for (const auto& triangle : mesh.triangles)
        for (const std::int32_t corner : triangle) {
            const Vec3 point = rays.place(mesh.positions[static_cast<std::size_t>(corner)]);
            const double x = point.dot(camera.right), y = point.dot(camera.down);
            left = std::min(left, x), right = std::max(right, x);
            top = std::min(top, y), bottom = std::max(bottom, y);
        }
    if (left > right) return;
    camera.scale = std::min(frame.width / std::max(right - left, 1e-6), frame.height / std::max(bottom - top, 1e-6));
    camera.center_x = frame.left + frame.width / 2.0 - camera.scale * (left + right) / 2;
    camera.center_y = frame.top + frame.height / 2.0 - camera.scale * (top + bottom) / 2;
}

double goodness(const PictureRays& rays, const Camera& camera, const Annotation& annotation, int size) {
    std::vector<int> pixels(annotation.parts.size() + 1, 0);
    RayPacket packet;
    for (int y = 0; y < size; y += 4)
        for (int x = 0; x < size; x += 4) {
            for (std::size_t i = 0; i < RayPacket::size; ++i) {
                packet.x[i] = static_cast<float>(x + static_cast<int>(i % 4)) + 0.51F;
                packet.y[i] = static_cast<float>(y + static_cast<int>(i / 4)) + 0.52F;
            }
            rays.cast(camera, packet);
            for (const std::int32_t triangle : packet.triangle)
                if (triangle >= 0)
                    ++pixels[static_cast<std::size_t>(annotation.part_of_triangle[static_cast<std::size_t>(triangle)] +
                                                      1)];
        }
    double sum = 0;
    for (const int count : pixels) sum += std::sqrt(count);
    return sum;
}

}  // namespace

Camera choose_view(const PictureRays& rays, const TriangleMesh& mesh, const Annotation& annotation, const Vec3& up,
                   const Frame& frame) {
    constexpr int probe_size = 32;
    const Vec3 top = up.stableNormalized();
    const Vec3 first = any_horizontal(top), second = top.cross(first);
    const Sides sides = find_sides(rays, mesh, top, first, second);
    Camera best;
    double best_goodness = -1;
    for (int i = 0; i < 8; ++i) {
        const double angle = sides.angle - 90 * degree + (i / 2) * 90 * degree + (i % 2 == 0 ? azimuth : -azimuth);
        Camera camera = look_from(top, std::cos(angle) * first + std::sin(angle) * second);
        fit(camera, rays, mesh, {0, 0, probe_size, probe_size});
        const double tall_in_front = (sides.tall_end * std::polar(1.0, -angle)).real();
        const double value = goodness(rays, camera, annotation, probe_size) * (1 - 0.25 * tall_in_front);
        if (value <= best_goodness * 1.02) continue;  // a small gain may be chance
        best = camera;
        best_goodness = value;
    }
    fit(best, rays, mesh, frame);
    return best;
}

}  // namespace partonomy
