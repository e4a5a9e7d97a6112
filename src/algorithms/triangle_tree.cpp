/* Distances between surfaces.
 *
 * Two triangles (Ericson, "Real-Time Collision Detection", 2005, chapter 5): 0 when an edge of one pierces the other,
 * else the smallest of vertex to triangle (6) and edge to edge (9). Two surfaces: their triangles are sorted into boxes
 * within boxes, halved at the median of the longest side; pairs of boxes are opened, the nearer pair first, and left
 * when they cannot beat the smallest distance so far. Cost: O(n log n) to build, then about as many pairs of triangles
 * as lie near each other. */

#include "algorithms/triangle_tree.h"

#include <Eigen/Geometry>
#include <algorithm>
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

double distance_of_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    const Vec3 u = b - a, v = d - c, w = a - c;
    const double uu = u.squaredNorm(), vv = v.squaredNorm(), uv = u.dot(v), determinant = uu * vv - uv * uv;
    double nearest = std::min({(a - nearest_on_segment(a, c, d)).norm(), (b - nearest_on_segment(b, c, d)).norm(),
                               (c - nearest_on_segment(c, a, b)).norm(), (d - nearest_on_segment(d, a, b)).norm()});
    if (determinant > 1e-12 * uu * vv) {
        const double s = (uv * v.dot(w) - vv * u.dot(w)) / determinant,
                     t = (uu * v.dot(w) - uv * u.dot(w)) / determinant;
        if (s >= 0 && s <= 1 && t >= 0 && t <= 1) nearest = std::min(nearest, (a + s * u - c - t * v).norm());
    }
    return nearest;
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
    double nearest = infinity;
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec3 &from = a[i], &to = a[(i + 1) % 3];
        if (pierces(from, to, b) || pierces(b[i], b[(i + 1) % 3], a)) return 0;
        nearest = std::min({nearest, distance_to_triangle(from, b), distance_to_triangle(b[i], a)});
        for (std::size_t j = 0; j < 3; ++j)
            nearest = std::min(nearest, distance_of_segments(from, to, b[j], b[(j + 1) % 3]));
    }
    return nearest;
}

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
        for (std::size_t i = a.first; i < a.last; ++i)
            for (std::size_t j = b.first; j < b.last; ++j)
                nearest = std::min(nearest, distance_of_triangles(triangles_[i], other.triangles_[j]));
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
