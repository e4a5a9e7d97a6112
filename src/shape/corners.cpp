#include "shape/corners.h"

#include <algorithm>

namespace partonomy {

std::vector<std::int32_t> corners_of(const TriangleMesh& mesh, const std::vector<std::int32_t>& triangles) {
    std::vector<std::int32_t> corners;
    if (triangles.empty()) return corners;
    std::int32_t low = mesh.triangles[triangles.front()][0], high = low;
    for (const std::int32_t t : triangles)
        for (const std::int32_t v : mesh.triangles[t]) low = std::min(low, v), high = std::max(high, v);
    const auto range = static_cast<std::size_t>(high - low) + 1;
    if (range < 16 * triangles.size()) {  // marking and counting beats sorting
        std::vector<char> is_corner(range, 0);
        for (const std::int32_t t : triangles)
            for (const std::int32_t v : mesh.triangles[t]) is_corner[v - low] = 1;
        for (std::size_t k = 0; k < range; ++k)
            if (is_corner[k]) corners.push_back(low + static_cast<std::int32_t>(k));
        return corners;
    }
    corners.reserve(3 * triangles.size());
    for (const std::int32_t t : triangles)
        corners.insert(corners.end(), mesh.triangles[t].begin(), mesh.triangles[t].end());
    std::sort(corners.begin(), corners.end());
    corners.erase(std::unique(corners.begin(), corners.end()), corners.end());
    return corners;
}

}  // namespace partonomy
