/* Distances between surfaces.
 *
 * Two triangles (Ericson, "Real-Time Collision Detection", 2005, chapter 5): 0 when an edge of one pierces the other,
 * else the smallest of vertex to plane, where it is above the triangle (6), and edge to edge (9). Two surfaces: their
 * triangles are sorted into boxes within boxes, halved at the median of the longest side; pairs of boxes are opened,
 * the nearer pair first, and left when they cannot beat the smallest distance so far. Cost: O(n log n) to build, then
 * about as many pairs of triangles as lie near each other. */

#include "algorithms/triangle_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

namespace partonomy {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::size_t leaf_size = 4;

Vec3 nearest_on_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 ab = b - a;
    const double length = ab.squaredNorm();
    return length > 0 ? Vec3(a + std::clamp((p - a).dot(ab) / length, 0.0, 1.0) * ab) : a;
}

/// Of the segments from p to p + u and from q to q + v.
double squared_distance_of_segments(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) {
    const Vec3 w = p - q;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), uw = u.dot(w), vw = v.dot(w);
    const double determinant = uu * vv - uv * uv;
    double s = determinant > 1e-12 * uu * vv ? std::clamp((uv * vw - uw * vv) / determinant, 0.0, 1.0) : 0;
    double t = vv > 0 ? (uv * s + vw) / vv : 0;
    if (!(t >= 0 && t <= 1)) {
        t = t < 0 ? 0 : 1;
        s = uu > 0 ? std::clamp((uv * t - uw) / uu, 0.0, 1.0) : 0;
    }
    return (w + s * u - t * v).squaredNorm();
}

/// 1 over the squared length of the triangle's normal; 0 when it has none.
double scale_of(const Vec3& normal) { return normal.squaredNorm() > 0 ? 1 / normal.squaredNorm() : 0; }

/// Whether the foot of the perpendicular from p is within the triangle.
bool is_above(const Vec3& p, const Triangle& t, const Vec3& normal) {
    for (std::size_t i = 0; i < 3; ++i)
        if (!((t[(i + 1) % 3] - t[i]).cross(p - t[i]).dot(normal) >= 0)) return false;
    return true;
}

struct Box {
    explicit Box(const Triangle& t)
        : low(t[0].cwiseMin(t[1]).cwiseMin(t[2])), high(t[0].cwiseMax(t[1]).cwiseMax(t[2])) {}
    Vec3 low, high;
};

double squared_apart(const Box& a, const Box& b) {
    return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0.0).squaredNorm();
}

bool pierces(const Vec3& a, const Vec3& b, const Triangle& t) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double from = (a - t[0]).dot(normal), to = (b - t[0]).dot(normal);
    if (from == to || (from > 0) == (to > 0)) return false;
    const Vec3 p = a + from / (from - to) * (b - a);
    for (std::size_t i = 0; i < 3; ++i)
        if ((t[(i + 1) % 3] - t[i]).cross(p - t[i]).dot(normal) < 0) return false;
    return true;
}

}  // namespace

double distance_to_triangle(const Vec3& p, const Triangle& t) {
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    const double size = normal.norm();
    if (size > 0) {
        bool inside = true;
        for (std::size_t i = 0; i < 3; ++i) inside &= (t[(i + 1) % 3] - t[i]).cross(p - t[i]).dot(normal) >= 0;
        if (inside) return std::abs((p - t[0]).dot(normal)) / size;
    }
    double nearest = infinity;
    for (std::size_t i = 0; i < 3; ++i)
        nearest = std::min(nearest, (p - nearest_on_segment(p, t[i], t[(i + 1) % 3])).norm());
    return nearest;
}

double distance_of_triangles(const Triangle& a, const Triangle& b) {
    const bool may_meet = squared_apart(Box(a), Box(b)) == 0;
    const std::array<Vec3, 3> u{a[1] - a[0], a[2] - a[1], a[0] - a[2]}, v{b[1] - b[0], b[2] - b[1], b[0] - b[2]};
    const Vec3 normal_a = u[0].cross(u[1]), normal_b = v[0].cross(v[1]);
    const double scale_a = scale_of(normal_a), scale_b = scale_of(normal_b);
    double nearest = infinity;  // squared
    for (std::size_t i = 0; i < 3; ++i) {
        if (may_meet && (pierces(a[i], a[i] + u[i], b) || pierces(b[i], b[i] + v[i], a))) return 0;
        if (scale_b > 0 && is_above(a[i], b, normal_b)) {
            const double height = (a[i] - b[0]).dot(normal_b);
            nearest = std::min(nearest, height * height * scale_b);
        }
        if (scale_a > 0 && is_above(b[i], a, normal_a)) {
            const double height = (b[i] - a[0]).dot(normal_a);
            nearest = std::min(nearest, height * height * scale_a);
        }
        for (std::size_t j = 0; j < 3; ++j)
            nearest = std::min(nearest, squared_distance_of_segments(a[i], u[i], b[j], v[j]));
    }
    return std::sqrt(nearest);
}

double distance_of_edge(const Vec3& p, const Vec3& q, const Triangle& t) { return distance_of_triangles({p, q, q}, t); }

TriangleTree::TriangleTree(std::vector<Triangle> triangles) : triangles_(std::move(triangles)) {
    if (triangles_.empty()) return;
    nodes_.reserve(triangles_.size());
    build(0, triangles_.size());
}

std::size_t TriangleTree::build(std::size_t first, std::size_t last) {
    const std::size_t index = nodes_.size();
    Node node{Vec3::Constant(infinity), Vec3::Constant(-infinity), first, last, 0};
    for (std::size_t i = first; i < last; ++i)
        for (const Vec3& corner : triangles_[i]) {
            node.low = node.low.cwiseMin(corner);
            node.high = node.high.cwiseMax(corner);
        }
    nodes_.push_back(node);
    if (last - first <= leaf_size) return index;
    int axis = 0;
    (node.high - node.low).maxCoeff(&axis);
    const auto at = [&](std::size_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
    const std::size_t half = first + (last - first) / 2;
    std::nth_element(at(first), at(half), at(last), [&](const Triangle& a, const Triangle& b) {
        return a[0][axis] + a[1][axis] + a[2][axis] < b[0][axis] + b[1][axis] + b[2][axis];
    });
    build(first, half);
    const std::size_t second = build(half, last);  // before it is stored: nodes_ moves while it grows
    nodes_[index].second = second;
    return index;
}

double TriangleTree::apart(const Node& a, const Node& b) {
    return (a.low - b.high).cwiseMax(b.low - a.high).cwiseMax(0.0).norm();
}

void TriangleTree::approach(const TriangleTree& other, std::size_t mine, std::size_t theirs, double& nearest) const {
    const Node &a = nodes_[mine], &b = other.nodes_[theirs];
    if (nearest == 0 || apart(a, b) >= nearest) return;
    if (a.is_leaf() && b.is_leaf()) {
        for (std::size_t i = a.first; i < a.last; ++i) {
            const Box box(triangles_[i]);
            for (std::size_t j = b.first; j < b.last; ++j)
                if (squared_apart(box, Box(other.triangles_[j])) < nearest * nearest)
                    nearest = std::min(nearest, distance_of_triangles(triangles_[i], other.triangles_[j]));
        }
        return;
    }
    const bool open_mine = !a.is_leaf() && (b.is_leaf() || a.last - a.first >= b.last - b.first);
    std::array<std::pair<std::size_t, std::size_t>, 2> pairs;
    if (open_mine)
        pairs = {{{mine + 1, theirs}, {a.second, theirs}}};
    else
        pairs = {{{mine, theirs + 1}, {mine, b.second}}};
    const auto distance = [&](const auto& pair) { return apart(nodes_[pair.first], other.nodes_[pair.second]); };
    const auto middles = [&](const auto& pair) {  // where boxes overlap, the nearer middles first
        return (nodes_[pair.first].middle() - other.nodes_[pair.second].middle()).squaredNorm();
    };
    const std::pair first(distance(pairs[0]), middles(pairs[0])), second(distance(pairs[1]), middles(pairs[1]));
    if (second < first) std::swap(pairs[0], pairs[1]);
    for (const auto& [x, y] : pairs) approach(other, x, y, nearest);
}

double TriangleTree::distance(const TriangleTree& other, double limit) const {
    double nearest = limit;
    if (!nodes_.empty() && !other.nodes_.empty()) approach(other, 0, 0, nearest);
    return nearest;
}

void TriangleTree::approach(const Vec3& point, std::size_t node, double& nearest) const {
    const Node& at = nodes_[node];
    if ((point - point.cwiseMax(at.low).cwiseMin(at.high)).norm() >= nearest) return;
    if (at.is_leaf()) {
        for (std::size_t i = at.first; i < at.last; ++i)
            nearest = std::min(nearest, distance_to_triangle(point, triangles_[i]));
        return;
    }
    const bool swapped =
        (point - nodes_[at.second].middle()).squaredNorm() < (point - nodes_[node + 1].middle()).squaredNorm();
    approach(point, swapped ? at.second : node + 1, nearest);
    approach(point, swapped ? node + 1 : at.second, nearest);
}

double TriangleTree::distance(const Vec3& point, double limit) const {
    double nearest = limit;
    if (!nodes_.empty()) approach(point, 0, nearest);
    return nearest;
}

}  // namespace partonomy
