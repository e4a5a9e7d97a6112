// Concave creases of a calmed mesh.
//
// Calming (calm.cpp) spreads a sharp crease over some triangles, each of which bends but little. So the normals around
// each triangle are averaged, by passing them on from neighbour to neighbour a few times: where they point different
// ways the mean is short, however many triangles share the bend. The crease is concave when the surroundings, averaged
// the same way, lie above the triangle. Cost: O(n).

#include <cmath>
#include <numbers>

#include "base/ranges.h"
#include "shape/surface.h"

namespace partonomy {

namespace {

constexpr int passes = 12;                                                     // reach some triangles far
const float bent = static_cast<float>(std::cos(24 * std::numbers::pi / 180));  // half of the least angle of a crease

/// What is averaged, side by side: a pass waits for memory more than it computes.
struct Around {
    Eigen::Vector3f normal, place;  ///< the place in sizes of the mesh, from its first triangle
};

/// Each value becomes the mean of its own and its neighbours'.
void spread(const Surface& s, std::vector<Around>& values, std::vector<Around>& old) {
    old.swap(values);
    for_each_range(old.size(), s.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Around sum = old[i];
            for (const std::int32_t j : s.adjacency.neighbours[i]) {
                const Around& other = old[j >= 0 ? static_cast<std::size_t>(j) : i];
                sum.normal += other.normal;
                sum.place += other.place;
            }
            values[i] = {sum.normal / 4, sum.place / 4};
        }
    });
}

}  // namespace

std::vector<char> find_creases(const Surface& s) {
    std::vector<char> creases(s.count());
    if (creases.empty()) return creases;
    const Vec3 start = s.geometry.barycentres.front();
    const auto place = [&](std::size_t i) -> Eigen::Vector3f {
        return ((s.geometry.barycentres[i] - start) / s.size).cast<float>();
    };
    std::vector<Around> around(s.count()), old(s.count());
    for_each_range(s.count(), s.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) around[i] = {s.geometry.normals[i].cast<float>(), place(i)};
    });
    for (int pass = 0; pass < passes; ++pass) spread(s, around, old);
    for_each_range(s.count(), s.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            creases[i] = around[i].normal.norm() < bent && (around[i].place - place(i)).dot(around[i].normal) > 0;
    });
    return creases;
}

}  // namespace partonomy
