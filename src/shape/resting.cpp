// Standing firmly: what touches the ground are the points close above the lowest one. The centre of mass must be above
// their convex hull, and the larger that is beside the whole outline, the firmer the object stands. How close counts as
// touching is tried twice, since worn or scanned feet are uneven, and the mean is taken. The centre is that of the
// surface: meshes may be open. It is inside when adding it to the hull makes the hull no larger.

#include "shape/resting.h"

#include <Eigen/Geometry>
#include <limits>
#include <vector>

#include "shape/hull_area.h"

namespace partonomy {

namespace {

constexpr std::array<double, 2> touching = {0.02, 0.05};  // of the height

double resting_score(const TriangleMesh& mesh, const Vec3& centre, const Vec3& up) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const Vec3& position : mesh.positions) {
        const double z = position.dot(up);
        low = std::min(low, z);
        high = std::max(high, z);
    }
    const Vec3 x = up.unitOrthogonal(), y = up.cross(x);
    std::vector<Eigen::Vector2d> all;
    all.reserve(mesh.positions.size());
    for (const Vec3& position : mesh.positions) all.emplace_back(position.dot(x), position.dot(y));
    const double outline = hull_area(all);
    if (!(outline > 0)) return 0;
    double score = 0;
    for (const double height : touching) {
        std::vector<Eigen::Vector2d> ground;
        for (std::size_t v = 0; v < all.size(); ++v)
            if (mesh.positions[v].dot(up) - low <= height * (high - low)) ground.push_back(all[v]);
        const double base = hull_area(ground);
        ground.emplace_back(centre.dot(x), centre.dot(y));
        if (hull_area(std::move(ground)) <= base * (1 + 1e-9)) score += base / outline / touching.size();
    }
    return score;
}

}  // namespace

const std::array<Vec3, 6>& axis_directions() {
    static const std::array<Vec3, 6> directions = {Vec3(Vec3::UnitX()),  Vec3(-Vec3::UnitX()), Vec3(Vec3::UnitY()),
                                                   Vec3(-Vec3::UnitY()), Vec3(Vec3::UnitZ()),  Vec3(-Vec3::UnitZ())};
    return directions;
}

std::array<double, 6> resting_scores(const TriangleMesh& mesh, const TriangleGeometry& geometry) {
    Vec3 centre = Vec3::Zero();
    double area = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        centre += geometry.areas[t] * geometry.barycentres[t];
        area += geometry.areas[t];
    }
    if (area > 0) centre /= area;
    std::array<double, 6> scores{};
    for (std::size_t k = 0; k < scores.size(); ++k) scores[k] = resting_score(mesh, centre, axis_directions()[k]);
    return scores;
}

}  // namespace partonomy
