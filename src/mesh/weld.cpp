#include "mesh/weld.h"

#include <algorithm>
#include <bit>
#include <cmath>

// A grid of cells that are 16 welding distances wide, kept in a hash table from cell to the representatives inside it.
// A point looks into its own cell, and into a neighbour only where it lies within the welding distance of the wall: on
// average 1.4 cells, where cells as wide as the distance would need 8. The grid is shifted off the origin because the
// coordinates of made objects like round numbers, and walls through them would make every point look twice.

namespace partonomy {
namespace {

using Cell = Eigen::Matrix<std::int64_t, 3, 1>;

class PointTable {
public:
    PointTable(std::span<const Vec3> points, std::size_t expected)
        : points_(points), next_(points.size(), -1), heads_(std::bit_ceil(2 * expected + 1), -1) {}

    /// The first representative in `cell` that is not further than `distance` from `point`, -1 when there is none.
    [[nodiscard]] std::int32_t find(const Cell& cell, const Vec3& point, double distance) const {
        std::int32_t best = -1;
        for (std::int32_t i = heads_[slot(cell)]; i >= 0; i = next_[static_cast<std::size_t>(i)]) {
            const Vec3& other = points_[static_cast<std::size_t>(i)];
            if (other == point || (other - point).squaredNorm() < distance * distance)
                best = i;  // chains run backwards
        }
        return best;
    }

    void add(const Cell& cell, std::int32_t index) {
        std::int32_t& head = heads_[slot(cell)];
        next_[static_cast<std::size_t>(index)] = head;
        head = index;
    }

private:
    [[nodiscard]] std::size_t slot(const Cell& cell) const {
        auto hash = static_cast<std::uint64_t>(cell.x()) * 0x9E3779B97F4A7C15U;
        hash = (hash ^ (hash >> 29) ^ static_cast<std::uint64_t>(cell.y())) * 0xBF58476D1CE4E5B9U;
        hash = (hash ^ (hash >> 32) ^ static_cast<std::uint64_t>(cell.z())) * 0x94D049BB133111EBU;
        return static_cast<std::size_t>(hash ^ (hash >> 31)) & (heads_.size() - 1);
    }

    std::span<const Vec3> points_;
    std::vector<std::int32_t> next_;
    std::vector<std::int32_t> heads_;
};

struct Grid {
    Vec3 origin;
    double scale;   ///< cells per unit
    double border;  ///< the welding distance, in cells

    Grid(std::span<const Vec3> points, const std::vector<bool>& used, double distance) {
        Vec3 low = Vec3::Constant(std::numeric_limits<double>::infinity()), high = -low;
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (!used[i]) continue;
            low = low.cwiseMin(points[i]);
            high = high.cwiseMax(points[i]);
        }
        const double size = std::max((high - low).maxCoeff(), std::numeric_limits<double>::min());
        const double cell = std::max(16 * distance, size * 1e-7);  // at most 1e7 cells a side: they fit integers
        scale = 1 / cell;
        if (!std::isfinite(scale)) scale = 0;
        border = distance * scale * (1 + 1e-9);
        origin = low - Vec3(0.38, 0.27, 0.31) * cell;
    }
};

}  // namespace

std::vector<std::int32_t> weld_points(std::span<const Vec3> points, const std::vector<bool>& used, double distance) {
    std::vector<std::int32_t> merged(points.size(), -1);
    const Grid grid(points, used, distance);
    PointTable table(points, static_cast<std::size_t>(std::count(used.begin(), used.end(), true)));
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!used[i]) continue;
        const Vec3 place = (points[i] - grid.origin) * grid.scale;
        const Vec3 floor(std::floor(place.x()), std::floor(place.y()), std::floor(place.z()));
        const Cell cell = floor.cast<std::int64_t>();
        const Vec3 inside = place - floor;
        Cell low = cell, high = cell;
        for (int axis = 0; axis < 3; ++axis) {
            if (inside[axis] <= grid.border) --low[axis];
            if (inside[axis] >= 1 - grid.border) ++high[axis];
        }
        std::int32_t found = -1;
        for (std::int64_t x = low.x(); x <= high.x(); ++x)
            for (std::int64_t y = low.y(); y <= high.y(); ++y)
                for (std::int64_t z = low.z(); z <= high.z(); ++z) {
                    const std::int32_t other = table.find({x, y, z}, points[i], distance);
                    if (other >= 0 && (found < 0 || other < found)) found = other;
                }
        if (found < 0) table.add(cell, static_cast<std::int32_t>(i));
        merged[i] = found < 0 ? static_cast<std::int32_t>(i) : found;
    }
    return merged;
}

}  // namespace partonomy
