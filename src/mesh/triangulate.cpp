#include "mesh/triangulate.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

// Ear clipping (Meisters 1975) in the plane of the polygon's mean normal (Newell's sum). A convex corner is an ear when
// no corner that is not convex lies in its triangle. Small polygons give the fattest ear first, since slivers spoil
// normals later; large ones take every other corner in turn. Cost: corners x non-convex corners, and O(n^2) for the
// small ones, n <= 64. Corners in line with their neighbours are not dropped, because the face across the edge may use
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
        for (std::size_t i = 0; i < n; ++i)
            if (turn(i) <= flat_) blockers_.push_back(i);
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
        for (std::size_t k = 0; k < blockers_.size();) {
            const std::size_t j = blockers_[k];
            if (gone_[j] || turn(j) > flat_) {  // once convex, a corner stays so
                blockers_[k] = blockers_.back();
                blockers_.pop_back();
                continue;
            }
            ++k;
            ++tests_;
            const Vec2& p = points_[j];
            if (p.x() < low.x() || p.x() > high.x() || p.y() < low.y() || p.y() > high.y()) continue;
            if (p == a || p == b || p == c) continue;
            if (cross(a, b, p) >= 0 && cross(b, c, p) >= 0 && cross(c, a, p) >= -flat_) return false;
        }
        return true;
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
    std::vector<std::size_t> next_, previous_, blockers_;
    std::vector<bool> gone_;
    double flat_ = 0;
    std::int64_t tests_ = 0;
};

/// The shorter diagonal that leaves both triangles facing the quad's way; false when there is none.
bool split_quad(std::span<const Vec3> p, std::span<const std::int32_t> v,
                std::vector<std::array<std::int32_t, 3>>& triangles) {
    const Vec3 normal = newell_normal(p);
    const auto fits = [&](std::size_t a, std::size_t b, std::size_t c) {
        return !has_no_area(p[a], p[b], p[c]) && (p[b] - p[a]).cross(p[c] - p[a]).dot(normal) > 0;
    };
    const bool by_02 = fits(0, 1, 2) && fits(0, 2, 3), by_13 = fits(0, 1, 3) && fits(1, 2, 3);
    if (!by_02 && !by_13) return false;
    if (by_02 && (!by_13 || (p[2] - p[0]).squaredNorm() <= (p[3] - p[1]).squaredNorm())) {
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
