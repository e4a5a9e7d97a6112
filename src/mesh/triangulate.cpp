#include "mesh/triangulate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

// Ear clipping (Meisters 1975) in the plane of the polygon's mean normal (Newell's sum). A convex corner is an ear when
// no corner that is not convex lies in its triangle. Small polygons give the fattest ear first, since slivers spoil
// normals later; large ones take every other corner in turn, and look up the corners that are not convex in a grid.
// Cost: O(n^2) for the small ones, n <= 64; nearly linear for large shapes that people draw, corners x non-convex
// corners at worst. Corners in line with their neighbours are not dropped, because the face across the edge may use
// them too. Polygons that cross themselves have no right answer: where no ear is left, the best convex corner is cut
// all the same.

namespace partonomy {
namespace {

using Vec2 = Eigen::Vector2d;

constexpr std::size_t small_polygon = 64;
constexpr std::int64_t patience = 400'000'000;  // point-in-ear tests; beyond, corners are cut without looking

double cross(const Vec2& a, const Vec2& b, const Vec2& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

Vec3 newell_normal(std::span<const Vec3> points) {
    Vec3 normal = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < points.size(); ++i)
        normal += (points[i] - points[0]).cross(points[i + 1] - points[0]);
    return normal;
}

/// Corners that may lie in an ear, in a grid with about one of them a cell.
class Blockers {
public:
    void fill(const std::vector<Vec2>& points, const std::vector<std::size_t>& which) {
        low_ = high_ = points[which.empty() ? 0 : which.front()];
        for (const std::size_t i : which) low_ = low_.cwiseMin(points[i]), high_ = high_.cwiseMax(points[i]);
        const Vec2 size = high_ - low_;
        const double n = static_cast<double>(std::max<std::size_t>(which.size(), 1));
        const double cell = std::max(std::sqrt(size.prod() / n), size.maxCoeff() / n);
        if (which.size() > 16 && cell > 0) {
            per_unit_ = 1 / cell;
            for (int axis = 0; axis < 2; ++axis) cells_[axis] += static_cast<std::size_t>(size[axis] * per_unit_);
        }
        lists_.resize(cells_[0] * cells_[1]);
        for (const std::size_t i : which)
            lists_[index(points[i].x(), 0) + cells_[0] * index(points[i].y(), 1)].push_back(i);
    }

    /// Whether `blocks(corner, forget)` holds for a corner near the box; those with `forget` set are dropped.
    template <class Test>
    bool any(const Vec2& low, const Vec2& high, const Test& blocks) {
        if ((low.array() > high_.array()).any() || (high.array() < low_.array()).any()) return false;
        for (std::size_t y = index(low.y(), 1); y <= index(high.y(), 1); ++y)
            for (std::size_t x = index(low.x(), 0); x <= index(high.x(), 0); ++x) {
                std::vector<std::size_t>& list = lists_[x + cells_[0] * y];
                for (std::size_t k = 0; k < list.size();) {
                    bool forget = false;
                    if (blocks(list[k], forget)) return true;
                    if (!forget) {
                        ++k;
                        continue;
                    }
                    list[k] = list.back();
                    list.pop_back();
                }
            }
        return false;
    }

private:
    [[nodiscard]] std::size_t index(double value, int axis) const {
        const double place = (value - low_[axis]) * per_unit_;
        return place <= 0 ? 0 : std::min(static_cast<std::size_t>(place), cells_[axis] - 1);
    }

    Vec2 low_, high_;
    double per_unit_ = 0;
    std::array<std::size_t, 2> cells_{1, 1};
    std::vector<std::vector<std::size_t>> lists_;
};

/// The polygon that remains, as a ring.
class EarClipper {
public:
    EarClipper(std::vector<Vec2> points, std::span<const std::int32_t> ids,
               std::vector<std::array<std::int32_t, 3>>& triangles)
        : points_(std::move(points)), ids_(ids), triangles_(triangles), left_(points_.size()) {
        const std::size_t n = points_.size();
        double size = 0;
        for (const Vec2& point : points_) size = std::max(size, (point - points_[0]).squaredNorm());
        flat_ = 1e-14 * size;
        next_.resize(n);
        previous_.resize(n);
        gone_.assign(n, false);
        for (std::size_t i = 0; i < n; ++i) next_[i] = (i + 1) % n, previous_[(i + 1) % n] = i;
        std::vector<std::size_t> blockers;
        for (std::size_t i = 0; i < n; ++i)
            if (turn(i) <= flat_) blockers.push_back(i);
        blockers_.fill(points_, blockers);
    }

    void run() {
        std::size_t at = 0;
        while (left_ > 3) {
            std::size_t ear = left_ <= small_polygon ? fattest_ear(true) : next_ear(at);
            if (ear == none) ear = fattest_ear(false);
            at = next_[next_[ear]];
            cut(ear);
        }
        cut(at);
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    [[nodiscard]] double turn(std::size_t i) const {
        return cross(points_[previous_[i]], points_[i], points_[next_[i]]);
    }

    [[nodiscard]] bool is_ear(std::size_t i) {
        if (turn(i) <= flat_) return false;
        const Vec2 &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
        const Vec2 low = a.cwiseMin(b).cwiseMin(c), high = a.cwiseMax(b).cwiseMax(c);
        return !blockers_.any(low, high, [&](std::size_t j, bool& forget) {
            forget = gone_[j] || turn(j) > flat_;  // once convex, a corner stays so
            ++tests_;
            const Vec2& p = points_[j];
            if (forget || p == a || p == b || p == c) return false;
            return cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= -flat_;
        });
    }

    /// Area over the sum of squared sides: 0.14 for equal sides, near 0 for slivers.
    [[nodiscard]] double fatness(std::size_t i) const {
        const Vec2 &a = points_[previous_[i]], &b = points_[i], &c = points_[next_[i]];
        return turn(i) / ((b - a).squaredNorm() + (c - b).squaredNorm() + (a - c).squaredNorm() + flat_);
    }

    [[nodiscard]] std::size_t fattest_ear(bool strict) {
        std::size_t first = 0;
        while (gone_[first]) ++first;
        std::size_t best = strict ? none : first;
        double best_fatness = strict ? 0 : -1;
        std::size_t i = first;
        for (std::size_t step = 0; step < left_; ++step, i = next_[i]) {
            const double value = fatness(i);
            if (value <= best_fatness || (strict && !is_ear(i))) continue;
            best = i;
            best_fatness = value;
            if (left_ > small_polygon && value > 0) break;
        }
        return best;
    }

    [[nodiscard]] std::size_t next_ear(std::size_t at) {
        for (std::size_t step = 0; step < left_ && tests_ < patience; ++step, at = next_[at])
            if (is_ear(at)) return at;
        return none;
    }

    void cut(std::size_t i) {
        if (turn(i) != 0) triangles_.push_back({ids_[previous_[i]], ids_[i], ids_[next_[i]]});
        next_[previous_[i]] = next_[i];
        previous_[next_[i]] = previous_[i];
        gone_[i] = true;
        --left_;
    }

    std::vector<Vec2> points_;
    std::span<const std::int32_t> ids_;
    std::vector<std::array<std::int32_t, 3>>& triangles_;
    std::size_t left_;
    std::vector<std::size_t> next_, previous_;
    Blockers blockers_;  ///< the corners that are not convex
    std::vector<bool> gone_;
    double flat_ = 0;
    std::int64_t tests_ = 0;
};

/// The shorter diagonal that leaves both triangles facing the quad's way; false when there is none. Of equal ones that
/// with the smallest vertex, so that the two sides of a sheet are cut alike.
bool split_quad(std::span<const Vec3> p, std::span<const std::int32_t> v,
                std::vector<std::array<std::int32_t, 3>>& triangles) {
    const Vec3 normal = newell_normal(p);
    const auto fits = [&](std::size_t a, std::size_t b, std::size_t c) {
        return !has_no_area(p[a], p[b], p[c]) && (p[b] - p[a]).cross(p[c] - p[a]).dot(normal) > 0;
    };
    const bool by_02 = fits(0, 1, 2) && fits(0, 2, 3), by_13 = fits(0, 1, 3) && fits(1, 2, 3);
    if (!by_02 && !by_13) return false;
    const double length_02 = (p[2] - p[0]).squaredNorm(), length_13 = (p[3] - p[1]).squaredNorm();
    const bool prefer_02 = length_02 != length_13 ? length_02 < length_13 : std::min(v[0], v[2]) < std::min(v[1], v[3]);
    if (by_02 && (!by_13 || prefer_02)) {
        triangles.push_back({v[0], v[1], v[2]});
        triangles.push_back({v[0], v[2], v[3]});
    } else {
        triangles.push_back({v[0], v[1], v[3]});
        triangles.push_back({v[1], v[2], v[3]});
    }
    return true;
}

void clip_ears(std::span<const Vec3> points, std::span<const std::int32_t> ids,
               std::vector<std::array<std::int32_t, 3>>& triangles) {
    const Vec3 normal = newell_normal(points);
    double reach = 0;
    for (const Vec3& point : points) reach = std::max(reach, (point - points[0]).squaredNorm());
    if (normal.norm() <=
        1e-12 * reach) {  // in line, or crossing itself so that its areas cancel: a fan takes what there is
        for (std::size_t i = 1; i + 1 < ids.size(); ++i) triangles.push_back({ids[0], ids[i], ids[i + 1]});
        return;
    }
    const Vec3 z = normal.normalized(), x = z.unitOrthogonal(), y = z.cross(x);
    std::vector<Vec2> flat;
    flat.reserve(points.size());
    for (const Vec3& point : points) flat.emplace_back((point - points[0]).dot(x), (point - points[0]).dot(y));
    EarClipper(std::move(flat), ids, triangles).run();
}

}  // namespace

bool has_no_area(const Vec3& a, const Vec3& b, const Vec3& c) {
    const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
    return !((b - a).cross(c - a).squaredNorm() > 1e-24 * longest * longest);
}

void triangulate_polygon(std::span<const Vec3> positions, std::span<const std::int32_t> corners,
                         std::vector<std::array<std::int32_t, 3>>& triangles) {
    const auto point = [&](std::int32_t v) -> const Vec3& { return positions[static_cast<std::size_t>(v)]; };
    const std::size_t before = triangles.size();
    if (corners.size() == 3) {
        triangles.push_back({corners[0], corners[1], corners[2]});
    } else {
        std::vector<std::int32_t> ids;
        for (const std::int32_t v : corners)
            if (ids.empty() || ids.back() != v) ids.push_back(v);
        while (ids.size() > 1 && ids.front() == ids.back()) ids.pop_back();
        if (ids.size() < 3) return;
        std::vector<Vec3> points;
        points.reserve(ids.size());
        for (const std::int32_t v : ids) points.push_back(point(v));
        if (ids.size() == 3)
            triangles.push_back({ids[0], ids[1], ids[2]});
        else if (ids.size() > 4 || !split_quad(points, ids, triangles))
            clip_ears(points, ids, triangles);
    }
    const auto added = triangles.begin() + static_cast<std::ptrdiff_t>(before);
    triangles.erase(std::remove_if(added, triangles.end(),
                                   [&](const auto& t) { return has_no_area(point(t[0]), point(t[1]), point(t[2])); }),
                    triangles.end());
}

}  // namespace partonomy
