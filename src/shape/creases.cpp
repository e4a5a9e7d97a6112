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

constexpr int passes = 12;                                  // reach some triangles far
const double bent = std::cos(24 * std::numbers::pi / 180);  // half of the least angle of a crease

/// Each value becomes the mean of its own and its neighbours'.
void spread(const Surface& s, std::vector<Vec3>& values, std::vector<Vec3>& old) {
    old.swap(values);
    for_each_range(old.size(), s.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            Vec3 sum = old[i];
            for (const std::int32_t j : s.adjacency.neighbours[i]) sum += old[j >= 0 ? static_cast<std::size_t>(j) : i];
            values[i] = sum / 4;
        }
    });
}

}  // namespace

std::vector<char> find_creases(const Surface& s) {
    std::vector<Vec3> normals = s.geometry.normals, places = s.geometry.barycentres, old(s.count());
    for (int pass = 0; pass < passes; ++pass) spread(s, normals, old);
    for (int pass = 0; pass < passes; ++pass) spread(s, places, old);
    std::vector<char> creases(s.count());
    for_each_range(s.count(), s.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            creases[i] = normals[i].norm() < bent && (places[i] - s.geometry.barycentres[i]).dot(normals[i]) > 0;
    });
    return creases;
}

}  // namespace partonomy
