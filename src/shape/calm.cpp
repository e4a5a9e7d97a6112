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
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "base/buckets.h"
#include "base/ranges.h"
#include "mesh/parallel.h"

namespace partonomy {

namespace {

constexpr double clean_degrees = 0.3, blurred_degrees = 3;
constexpr int most_rounds = 12, steps_a_round = 3;
constexpr double grain = 3;  // of the root of the mean area of a triangle
constexpr double forth = 0.6, back = -0.62;
constexpr std::size_t most_samples = 6000;

/// Moves vertices towards the mean of their neighbours.
class Relaxation {
public:
    Relaxation(const TriangleMesh& mesh, int threads)
        : around_(sort_into_buckets<Side>(mesh.triangles.size(), mesh.positions.size(), threads,
                                          [&](std::size_t t, const auto& put) {
                                              const auto& [a, b, c] = mesh.triangles[t];
                                              put(a, Side{b, c}), put(b, Side{c, a}), put(c, Side{a, b});
                                          })),
          threads_(threads) {}

    /// Where vertices come to when each goes the part `share` of its way.
    void relax(const std::vector<Vec3>& positions, double share, std::vector<Vec3>& relaxed) {
        next_.resize(positions.size());
        for_each_range(positions.size(), threads_, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v) {
                Vec3 sum = Vec3::Zero();
                const auto around = std::as_const(around_)[v];
                for (const auto& [a, b] : around) {
                    sum += positions[a];
                    sum += positions[b];
                }
                const auto count = static_cast<double>(2 * around.size());
                next_[v] = count > 0 ? Vec3(positions[v] + share * (sum / count - positions[v])) : positions[v];
            }
        });
        relaxed.swap(next_);
    }

private:
    using Side = std::array<std::int32_t, 2>;
    Buckets<Side> around_;  ///< neighbours of each vertex: the opposite side of each triangle
    int threads_;
    std::vector<Vec3> next_;
};

}  // namespace

double roughness(const Adjacency& adjacency, const TriangleGeometry& geometry, int threads) {
    const std::size_t count = geometry.normals.size(), stride = 1 + count / most_samples;
    std::vector<double> turns((count + stride - 1) / stride);
    const auto measure = [&](std::size_t i) {
        double convex = 1, concave = 1;  // smallest cosines
        for (const std::int32_t j : adjacency.neighbours[i]) {
            if (j < 0) continue;
            const double cosine = geometry.normals[i].dot(geometry.normals[j]);
            const bool in = (geometry.barycentres[j] - geometry.barycentres[i]).dot(geometry.normals[i]) > 0;
            double& least = in ? concave : convex;
            least = std::min(least, cosine);
        }
        return std::max(convex, concave);
    };
    for_each_range(turns.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) turns[k] = measure(k * stride);
    });
    if (turns.empty()) return 0;
    const auto middle = turns.begin() + static_cast<std::ptrdiff_t>(turns.size() / 2);
    std::nth_element(turns.begin(), middle, turns.end());
    return std::acos(std::clamp(*middle, -1.0, 1.0)) * 180 / std::numbers::pi;
}

Calming calm(const TriangleMesh& mesh, const Adjacency& adjacency, TriangleGeometry& geometry, int threads,
             double calm_degrees) {
    const double before = roughness(adjacency, geometry, threads);
    if (before < clean_degrees) return {};
    const double area = sum(geometry.areas, threads);
    Calming result{{{}, mesh.triangles, mesh.input_faces, mesh.input_face_count, mesh.repeated_faces},
                   grain * std::sqrt(area / static_cast<double>(geometry.areas.size())),
                   before > blurred_degrees};
    Relaxation relaxation(mesh, threads);
    std::vector<Vec3>& positions = result.mesh.positions;
    for (int round = 0; round < most_rounds; ++round) {
        for (int step = 0; step < steps_a_round; ++step) {
            relaxation.relax(round + step == 0 ? mesh.positions : positions, forth, positions);
            relaxation.relax(positions, back, positions);
        }
        compute_geometry(result.mesh, threads, geometry);
        if (roughness(adjacency, geometry, threads) < calm_degrees) break;
    }
    return result;
}

}  // namespace partonomy
