// Cutting large triangles, so that all later steps may think in small pieces.
//
// Every edge longer than the limit is halved, all at once, until none is left. Whether an edge is cut depends on the
// edge alone, so both its triangles agree and no T-junction appears. A triangle with one, two or three cut edges
// becomes two, three or four; of the two ways to cut the quadrilateral in the middle case the shorter diagonal is
// taken. Meshes that are fine already pass unchanged. Cost: linear in the result.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "shape/surface.h"

namespace partonomy {

namespace {

using Corners = std::array<std::int32_t, 3>;

struct Edge {
    std::int32_t low, high;
    bool operator<(const Edge& other) const { return low != other.low ? low < other.low : high < other.high; }
    bool operator==(const Edge& other) const { return low == other.low && high == other.high; }
};

Edge edge_of(std::int32_t a, std::int32_t b) { return a < b ? Edge{a, b} : Edge{b, a}; }

class Halver {
public:
    Halver(TriangleMesh& mesh, double longest) : mesh_(mesh), limit_(longest * longest) {}

    /// One round; false when no edge was too long.
    bool halve() {
        collect_long_edges();
        if (long_.empty()) return false;
        const auto first = static_cast<std::int32_t>(mesh_.positions.size());
        for (const Edge& edge : long_)
            mesh_.positions.push_back((mesh_.positions[edge.low] + mesh_.positions[edge.high]) / 2);
        std::vector<Corners> triangles;
        std::vector<std::int32_t> faces;
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            const std::size_t before = triangles.size();
            cut(mesh_.triangles[t], first, triangles);
            faces.insert(faces.end(), triangles.size() - before, mesh_.input_faces[t]);
        }
        mesh_.triangles = std::move(triangles);
        mesh_.input_faces = std::move(faces);
        return true;
    }

private:
    [[nodiscard]] double squared(std::int32_t a, std::int32_t b) const {
        return (mesh_.positions[a] - mesh_.positions[b]).squaredNorm();
    }

    void collect_long_edges() {
        long_.clear();
        for (const Corners& t : mesh_.triangles)
            for (int e = 0; e < 3; ++e)
                if (squared(t[e], t[(e + 1) % 3]) > limit_) long_.push_back(edge_of(t[e], t[(e + 1) % 3]));
        std::sort(long_.begin(), long_.end());
        long_.erase(std::unique(long_.begin(), long_.end()), long_.end());
    }

    /// The new vertex in the middle of an edge, or -1.
    [[nodiscard]] std::int32_t middle(std::int32_t a, std::int32_t b, std::int32_t first) const {
        if (squared(a, b) <= limit_) return -1;
        const auto at = std::lower_bound(long_.begin(), long_.end(), edge_of(a, b));
        return first + static_cast<std::int32_t>(at - long_.begin());
    }

    void cut(const Corners& t, std::int32_t first, std::vector<Corners>& out) const {
        Corners m{};
        int cuts = 0;
        for (int e = 0; e < 3; ++e) cuts += (m[e] = middle(t[e], t[(e + 1) % 3], first)) >= 0;
        if (cuts == 0) {
            out.push_back(t);
        } else if (cuts == 3) {
            out.push_back({t[0], m[0], m[2]});
            out.push_back({m[0], t[1], m[1]});
            out.push_back({m[2], m[1], t[2]});
            out.push_back({m[0], m[1], m[2]});
        } else if (cuts == 1) {
            const int e = m[0] >= 0 ? 0 : m[1] >= 0 ? 1 : 2;
            out.push_back({t[e], m[e], t[(e + 2) % 3]});
            out.push_back({m[e], t[(e + 1) % 3], t[(e + 2) % 3]});
        } else {
            // The edge that stays runs from corner a to b; c is cut off, and a, b and the two middles make a
            // quadrilateral.
            const int stays = m[0] < 0 ? 0 : m[1] < 0 ? 1 : 2;
            const std::int32_t a = t[stays], b = t[(stays + 1) % 3], c = t[(stays + 2) % 3];
            const std::int32_t bc = m[(stays + 1) % 3], ca = m[(stays + 2) % 3];
            out.push_back({ca, bc, c});
            if (squared(a, bc) <= squared(b, ca)) {
                out.push_back({a, b, bc});
                out.push_back({a, bc, ca});
            } else {
                out.push_back({a, b, ca});
                out.push_back({b, bc, ca});
            }
        }
    }

    TriangleMesh& mesh_;
    double limit_;
    std::vector<Edge> long_;
};

constexpr double fine_triangles = 2500;   // what a coarse mesh is cut into, about
constexpr double shortest_limit = 0.012;  // of the size: no finer than this

}  // namespace

double refinement_length(const TriangleMesh& mesh, double size) {
    double area = 0, longest = 0;
    for (const Corners& t : mesh.triangles) {
        const Vec3& a = mesh.positions[t[0]];
        const Vec3 u = mesh.positions[t[1]] - a, v = mesh.positions[t[2]] - a;
        area += std::sqrt(std::max(0.0, u.squaredNorm() * v.squaredNorm() - u.dot(v) * u.dot(v))) / 2;
        longest = std::max({longest, u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
    }
    // Halving leaves edges of 0.7 of the limit on average, and triangles of about a quarter of its square.
    const double limit = std::max(shortest_limit * size, std::sqrt(area / fine_triangles / 0.25));
    return longest > limit * limit ? limit : std::numeric_limits<double>::infinity();
}

TriangleMesh refine(const TriangleMesh& mesh, double longest) {
    TriangleMesh fine = mesh;
    fine.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    for (std::size_t t = 0; t < fine.input_faces.size(); ++t) fine.input_faces[t] = static_cast<std::int32_t>(t);
    if (!(longest < std::numeric_limits<double>::infinity())) return fine;
    Halver halver(fine, longest);
    while (halver.halve()) {
    }
    return fine;
}

}  // namespace partonomy
