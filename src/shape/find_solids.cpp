#include "shape/find_solids.h"

#include <Eigen/Geometry>
#include <cmath>

namespace partonomy {

std::vector<std::int32_t> find_solids(const TriangleMesh& mesh, const Adjacency& adjacency) {
    constexpr double least_filling = 1e-4;  // volume / area^1.5; of a ball 0.094
    const std::size_t count = mesh.triangles.size();
    std::vector<std::int32_t> shell_of(count, -1), order;
    order.reserve(count);
    std::vector<char> is_closed;
    for (std::size_t start = 0; start < count; ++start) {
        if (shell_of[start] >= 0) continue;
        const auto shell = static_cast<std::int32_t>(is_closed.size());
        is_closed.push_back(1);
        std::size_t at = order.size();
        order.push_back(static_cast<std::int32_t>(start));
        shell_of[start] = shell;
        for (; at < order.size(); ++at)
            for (const std::int32_t j : adjacency.neighbours[order[at]]) {
                if (j < 0) {
                    is_closed[shell] = 0;
                } else if (shell_of[j] < 0) {
                    shell_of[j] = shell;
                    order.push_back(j);
                }
            }
    }
    if (is_closed.size() < 2) return {};
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
    for (std::int32_t& shell : shell_of) shell = number[shell];
    return shell_of;
}

}  // namespace partonomy
