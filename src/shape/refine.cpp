// Cutting large triangles, so that all later steps may think in small pieces.
//
// Every edge longer than the limit is halved, all at once, until none is left. Whether an edge is cut depends on the
// edge alone, so both its triangles agree and no T-junction appears. A triangle with one, two or three cut edges
// becomes two, three or four; of the two ways to cut the quadrilateral in the middle case the shorter diagonal is
// taken. Meshes that are fine already pass unchanged. Cost: linear in the result.
//
// The rounds are kept, so that a point of a large triangle finds its piece by a few steps from round to round: rays are
// shot at the large triangles, whose tree is built in a moment, and land on small ones.

#include "shape/refine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "base/ranges.h"
#include "mesh/edges.h"

namespace partonomy {

namespace {

using Corners = std::array<std::int32_t, 3>;

constexpr std::uint8_t other_diagonal = 8;

class Halver {
public:
    Halver(TriangleMesh& mesh, double longest) : mesh_(mesh), limit_(longest * longest) {}

    /// One round; nothing when no edge was too long.
    std::optional<Refinement::Round> halve() {
        if (!find_middles()) return std::nullopt;
        Refinement::Round round;
        std::vector<Corners> triangles;
        std::vector<std::int32_t> faces;
        triangles.reserve(4 * mesh_.triangles.size());
        faces.reserve(4 * mesh_.triangles.size());
        round.begins.reserve(mesh_.triangles.size());
        round.pattern.reserve(mesh_.triangles.size());
        for (std::size_t t = 0; t < mesh_.triangles.size(); ++t) {
            round.begins.push_back(static_cast<std::int32_t>(triangles.size()));
            round.pattern.push_back(
                cut(mesh_.triangles[t], {middle_[3 * t], middle_[3 * t + 1], middle_[3 * t + 2]}, triangles));
            faces.resize(triangles.size(), mesh_.input_faces[t]);
        }
        mesh_.triangles = std::move(triangles);
        mesh_.input_faces = std::move(faces);
        return round;
    }

private:
    [[nodiscard]] double squared(std::int32_t a, std::int32_t b) const {
        return (mesh_.positions[a] - mesh_.positions[b]).squaredNorm();
    }

    /// Makes the vertex in the middle of each long edge; false when there is none.
    bool find_middles() {
        const auto is_long = [&](const Corners& t, int e) { return squared(t[e], t[(e + 1) % 3]) > limit_; };
        if (std::ranges::none_of(mesh_.triangles,
                                 [&](const Corners& t) { return is_long(t, 0) || is_long(t, 1) || is_long(t, 2); }))
            return false;
        middle_.assign(3 * mesh_.triangles.size(), -1);
        const EdgeTable edges = build_edges(mesh_.triangles, mesh_.positions.size());
        for (std::size_t i = 0; i < edges.size(); ++i) {
            const std::int32_t h = edges[i].front();
            const Corners& t = mesh_.triangles[h / 3];
            if (!is_long(t, h % 3)) continue;
            for (const std::int32_t half_edge : edges[i])
                middle_[half_edge] = static_cast<std::int32_t>(mesh_.positions.size());
            mesh_.positions.push_back((mesh_.positions[t[h % 3]] + mesh_.positions[t[(h % 3 + 1) % 3]]) / 2);
        }
        return true;
    }

    /// Adds the pieces of a triangle whose edges have the middles `m`, -1 where an edge stays whole; their pattern.
    std::uint8_t cut(const Corners& t, const Corners& m, std::vector<Corners>& out) const {
        auto pattern = static_cast<std::uint8_t>((m[0] >= 0 ? 1 : 0) | (m[1] >= 0 ? 2 : 0) | (m[2] >= 0 ? 4 : 0));
        const int cuts = (m[0] >= 0) + (m[1] >= 0) + (m[2] >= 0);
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
                pattern |= other_diagonal;
            }
        }
        return pattern;
    }

    TriangleMesh& mesh_;
    double limit_;
    std::vector<std::int32_t> middle_;  ///< by half-edge
};

// What a coarse mesh is cut into, about: few triangles are few parts.
constexpr double pieces_a_triangle = 24, fewest_pieces = 1400, most_pieces = 2500;
constexpr double shortest_limit = 0.012;  // of the size: no finer than this

}  // namespace

double refinement_length(const TriangleMesh& mesh, double size, int threads) {
    struct Sizes {
        double area = 0, longest = 0;
    };
    const auto of_blocks = map_blocks(mesh.triangles.size(), threads, [&](std::size_t begin, std::size_t end) {
        Sizes sizes;
        for (std::size_t i = begin; i < end; ++i) {
            const Corners& t = mesh.triangles[i];
            const Vec3& a = mesh.positions[t[0]];
            const Vec3 u = mesh.positions[t[1]] - a, v = mesh.positions[t[2]] - a;
            sizes.area += std::sqrt(std::max(0.0, u.squaredNorm() * v.squaredNorm() - u.dot(v) * u.dot(v))) / 2;
            sizes.longest = std::max({sizes.longest, u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
        }
        return sizes;
    });
    double area = 0, longest = 0;
    for (const Sizes& some : of_blocks) {
        area += some.area;
        longest = std::max(longest, some.longest);
    }
    const double wanted =
        std::clamp(pieces_a_triangle * static_cast<double>(mesh.triangles.size()), fewest_pieces, most_pieces);
    // Halving leaves edges of 0.7 of the limit on average, and triangles of about a quarter of its square.
    const double limit = std::max(shortest_limit * size, std::sqrt(area / wanted / 0.25));
    return longest > limit * limit ? limit : std::numeric_limits<double>::infinity();
}

Refinement refine(const TriangleMesh& mesh, double longest) {
    Refinement refinement;
    TriangleMesh& fine = refinement.mesh;
    fine = mesh;
    fine.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    for (std::size_t t = 0; t < fine.input_faces.size(); ++t) fine.input_faces[t] = static_cast<std::int32_t>(t);
    if (!(longest < std::numeric_limits<double>::infinity())) return refinement;
    Halver halver(fine, longest);
    while (std::optional<Refinement::Round> round = halver.halve()) refinement.rounds.push_back(std::move(*round));
    return refinement;
}

// The piece that holds the point, and the point's barycentric coordinates there, follow from its coordinates in the
// whole by writing the lost corners in terms of the middles: t1 = 2 m - t0 for m in the middle of t0 and t1.
std::int32_t Refinement::piece_at(std::int32_t triangle, double u, double v) const {
    std::array<double, 3> w{1 - u - v, u, v};
    for (const Round& round : rounds) {
        const std::uint8_t pattern = round.pattern[triangle];
        triangle = round.begins[triangle];
        switch (pattern & 7) {
            case 0:
                break;
            case 7:
                if (w[0] >= 0.5) {
                    w = {w[0] - w[1] - w[2], 2 * w[1], 2 * w[2]};
                } else if (w[1] >= 0.5) {
                    w = {2 * w[0], w[1] - w[0] - w[2], 2 * w[2]};
                    triangle += 1;
                } else if (w[2] >= 0.5) {
                    w = {2 * w[0], 2 * w[1], w[2] - w[0] - w[1]};
                    triangle += 2;
                } else {
                    w = {w[0] + w[1] - w[2], w[1] + w[2] - w[0], w[0] + w[2] - w[1]};
                    triangle += 3;
                }
                break;
            case 1:
            case 2:
            case 4: {
                const std::size_t e = (pattern & 7) == 4 ? 2 : (pattern & 7) - 1;
                const double a = w[e], b = w[(e + 1) % 3], c = w[(e + 2) % 3];
                if (a >= b) {
                    w = {a - b, 2 * b, c};
                } else {
                    w = {2 * a, b - a, c};
                    triangle += 1;
                }
                break;
            }
            default: {
                const std::size_t stays = (pattern & 1) == 0 ? 0 : (pattern & 2) == 0 ? 1 : 2;
                const double a = w[stays], b = w[(stays + 1) % 3], c = w[(stays + 2) % 3];
                if (c >= 0.5) {
                    w = {2 * a, 2 * b, c - a - b};
                } else if ((pattern & other_diagonal) == 0) {
                    triangle += b >= c ? 1 : 2;
                    if (b >= c)
                        w = {a, b - c, 2 * c};
                    else
                        w = {a + b - c, 2 * b, 2 * (c - b)};
                } else {
                    triangle += a >= c ? 1 : 2;
                    if (a >= c)
                        w = {a - c, b, 2 * c};
                    else
                        w = {a + b - c, 2 * (c - a), 2 * a};
                }
            }
        }
    }
    return triangle;
}

}  // namespace partonomy
