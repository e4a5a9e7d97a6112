#include "shape/find_solids.h"

#include <Eigen/Geometry>
#include <cmath>

#include "shape/pieces.h"

namespace partonomy {

std::vector<std::int32_t> find_solids(const TriangleMesh& mesh, const Adjacency& adjacency, int threads) {
    constexpr double least_filling = 1e-4;  // volume / area^1.5; of a ball 0.094
    const std::size_t count = mesh.triangles.size();
    const auto [shell_of, lowest] = find_pieces(adjacency, threads, [](std::int32_t, std::int32_t) { return true; });
    if (lowest.size() < 2) return {};
    std::vector<char> is_closed(lowest.size(), 1);
    for (std::size_t t = 0; t < count; ++t)
        for (const std::int32_t j : adjacency.neighbours[t])
            if (j < 0) is_closed[shell_of[t]] = 0;
    std::vector<double> volume(is_closed.size(), 0.0), area(is_closed.size(), 0.0);
    std::vector<std::int32_t> first(is_closed.size(), -1);
    for (std::size_t t = 0; t < count; ++t) {
        const std::int32_t shell = shell_of[t];
        const auto& [a, b, c] = mesh.triangles[t];
        if (first[shell] < 0) first[shell] = a;
        const Vec3& corner = mesh.positions[a];
        const Vec3 twice = (mesh.positions[b] - corner).cross(mesh.positions[c] - corner);
        volume[shell] += (corner - mesh.positions[first[shell]]).dot(twice) / 6;
        area[shell] += twice.norm() / 2;
    }
    std::vector<std::int32_t> number(is_closed.size(), -1);
    std::int32_t solids = 0;
    for (std::size_t k = 0; k < number.size(); ++k)
        if (is_closed[k] != 0 && volume[k] > least_filling * area[k] * std::sqrt(area[k])) number[k] = solids++;
    if (solids < 2) return {};
    std::vector<std::int32_t> solid_of(count);
    for (std::size_t t = 0; t < count; ++t) solid_of[t] = number[shell_of[t]];
    return solid_of;
}

}  // namespace partonomy
