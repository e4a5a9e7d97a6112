// Taking out noise that is finer than the parts.
//
// Noise makes a surface turn to and fro from triangle to triangle: each has convex and concave edges. Neither a box nor
// a round stick does so, however coarse its triangles, so this is what tells noise from shape, and clean meshes pass
// untouched. A rough mesh is smoothed in rounds until it is calm: each vertex moves towards the mean of its neighbours
// and a little less far back (Taubin 1995), which takes out what is shorter than some edges and does not shrink the
// rest. Waves longer than that stay: walls that bend are what the later steps are made for. Cost: O(n) a round.

#include "shape/calm.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace partonomy {

namespace {

constexpr double clean_degrees = 0.3, calm_degrees = 3;
constexpr int most_rounds = 12, steps_a_round = 3;
constexpr double grain = 3;  // of the root of the mean area of a triangle
constexpr double forth = 0.6, back = -0.62;
constexpr std::size_t most_samples = 6000;

/// Every vertex goes the part `share` of its way to the mean of its neighbours.
void relax(TriangleMesh& mesh, double share, std::vector<Vec3>& sum, std::vector<std::int32_t>& count) {
    sum.assign(mesh.positions.size(), Vec3::Zero());
    count.assign(mesh.positions.size(), 0);
    for (const auto& t : mesh.triangles) {
        const Vec3 all = mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]];
        for (const std::int32_t v : t) {
            sum[v] += all - mesh.positions[v];
            count[v] += 2;
        }
    }
    for (std::size_t v = 0; v < sum.size(); ++v)
        if (count[v] > 0) mesh.positions[v] += share * (sum[v] / count[v] - mesh.positions[v]);
}

}  // namespace

double roughness(const Adjacency& adjacency, const TriangleGeometry& geometry) {
    const std::size_t count = geometry.normals.size(), stride = 1 + count / most_samples;
    std::vector<double> turns;
    for (std::size_t i = 0; i < count; i += stride) {
        double convex = 1, concave = 1;  // smallest cosines
        for (const std::int32_t j : adjacency.neighbours[i]) {
            if (j < 0) continue;
            const double cosine = geometry.normals[i].dot(geometry.normals[j]);
            const bool in = (geometry.barycentres[j] - geometry.barycentres[i]).dot(geometry.normals[i]) > 0;
            double& least = in ? concave : convex;
            least = std::min(least, cosine);
        }
        turns.push_back(std::max(convex, concave));
    }
    if (turns.empty()) return 0;
    const auto middle = turns.begin() + static_cast<std::ptrdiff_t>(turns.size() / 2);
    std::nth_element(turns.begin(), middle, turns.end());
    return std::acos(std::clamp(*middle, -1.0, 1.0)) * 180 / std::numbers::pi;
}

Calming calm(TriangleMesh& mesh, const Adjacency& adjacency, TriangleGeometry& geometry) {
    const double before = roughness(adjacency, geometry);
    if (before < clean_degrees) return {};
    double area = 0;
    for (const double a : geometry.areas) area += a;
    std::vector<Vec3> sum;
    std::vector<std::int32_t> count;
    for (int round = 0; round < most_rounds; ++round) {
        for (int step = 0; step < steps_a_round; ++step) {
            relax(mesh, forth, sum, count);
            relax(mesh, back, sum, count);
        }
        geometry = compute_geometry(mesh);
        if (roughness(adjacency, geometry) < calm_degrees) break;
    }
    return {grain * std::sqrt(area / static_cast<double>(geometry.areas.size())), before > calm_degrees};
}

}  // namespace partonomy
