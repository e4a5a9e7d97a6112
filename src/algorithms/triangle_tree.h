#pragma once

#include <array>
#include <limits>
#include <vector>

#include "mesh/triangle_mesh.h"

namespace partonomy {

using Triangle = std::array<Vec3, 3>;

/// 0 when they meet.
[[nodiscard]] double distance_of_triangles(const Triangle& a, const Triangle& b);
[[nodiscard]] double distance_of_edge(const Vec3& from, const Vec3& to, const Triangle& triangle);
[[nodiscard]] double distance_to_triangle(const Vec3& point, const Triangle& triangle);

/// Triangles sorted into boxes within boxes.
class TriangleTree {
public:
    explicit TriangleTree(std::vector<Triangle> triangles);

    /// Smallest distance to a triangle of the other tree, or `limit` when that is not nearer.
    [[nodiscard]] double distance(const TriangleTree& other,
                                  double limit = std::numeric_limits<double>::infinity()) const;
    /// Smallest distance of a point, or `limit`.
    [[nodiscard]] double distance(const Vec3& point, double limit) const;
    /// Calls visit(triangle) for each whose box comes as near to the box from low to high as `reach`.
    template <typename Visit>
    void for_each_near(const Vec3& low, const Vec3& high, double reach, const Visit& visit,
                       std::size_t node = 0) const {
        const Node& at = nodes_[node];
        if (((at.low - high).array() > reach).any() || ((low - at.high).array() > reach).any()) return;
        for (std::size_t i = at.first; at.is_leaf() && i < at.last; ++i) visit(triangles_[i]);
        if (at.is_leaf()) return;
        for_each_near(low, high, reach, visit, node + 1);
        for_each_near(low, high, reach, visit, at.second);
    }
    [[nodiscard]] const std::vector<Triangle>& triangles() const { return triangles_; }

private:
    struct Node {
        Vec3 low, high;
        std::size_t first = 0, last = 0;  ///< triangles
        std::size_t second = 0;           ///< child; the first one comes right after this node. 0: a leaf
        [[nodiscard]] bool is_leaf() const { return second == 0; }
        [[nodiscard]] Vec3 middle() const { return (low + high) / 2; }
    };
    std::size_t build(std::size_t first, std::size_t last);
    static double apart(const Node& a, const Node& b);
    void approach(const TriangleTree& other, std::size_t mine, std::size_t theirs, double& nearest) const;
    void approach(const Vec3& point, std::size_t node, double& nearest) const;

    std::vector<Triangle> triangles_;
    std::vector<Node> nodes_;  ///< none without triangles
};

}  // namespace partonomy
