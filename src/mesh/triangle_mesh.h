#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace partonomy {

using Vec3 = Eigen::Vector3d;

/// One indexed triangle mesh. Every triangle remembers the face of the input file that it was cut from, so that label i
/// of the output belongs to face i of the input.
struct TriangleMesh {
    std::vector<Vec3> positions;  ///< #V points, in the units of the file
    std::vector<std::array<std::int32_t, 3>>
        triangles;                          ///< #T vertex indices in [0, #V), counter-clockwise from outside
    std::vector<std::int32_t> input_faces;  ///< #T input face of each triangle, in [0, input_face_count)
    std::int32_t input_face_count = 0;      ///< faces in the file, degenerate ones included
    /// Input faces without a triangle of their own because an earlier face lies in the same place: (face, that earlier
    /// face).
    std::vector<std::pair<std::int32_t, std::int32_t>> repeated_faces;
};

/// The triangle across each edge. Edge e of a triangle runs from its corner e to corner (e + 1) % 3.
struct Adjacency {
    std::vector<std::array<std::int32_t, 3>> neighbours;  ///< #T; -1 where the surface is open
};

/// Per triangle: area and unit outward normal (zero vector when the area is 0).
struct TriangleGeometry {
    std::vector<double> areas;
    std::vector<Vec3> normals;
    std::vector<Vec3> barycentres;
};

/// Smallest and largest coordinates.
struct Bounds {
    Vec3 low, high;
    [[nodiscard]] Vec3 middle() const { return low / 2 + high / 2; }
    [[nodiscard]] double diagonal() const { return (high - low).norm(); }
};

/// Edges shared by two triangles are linked; where more than two meet (non-manifold), triangles are paired by turning
/// around the edge, so that each pair bounds one solid. O(#T log #T). Deterministic.
[[nodiscard]] Adjacency build_adjacency(const TriangleMesh& mesh);

[[nodiscard]] TriangleGeometry compute_geometry(const TriangleMesh& mesh);

/// Bounds of a mesh with at least one position.
[[nodiscard]] Bounds compute_bounds(const TriangleMesh& mesh);

/// Bounds of the positions that triangles use, so that an unused vertex far away counts for nothing; for a mesh with at
/// least one triangle.
[[nodiscard]] Bounds compute_used_bounds(const TriangleMesh& mesh);

/// The first promise of TriangleMesh that `mesh` breaks, as a sentence; empty when it keeps all of them. For tests and
/// for meshes that were made by hand.
[[nodiscard]] std::string validate(const TriangleMesh& mesh);

/// What kind of surface a mesh is, counted edge by edge.
struct Topology {
    std::int64_t edges = 0;
    std::int64_t boundary_edges = 0;      ///< with one triangle
    std::int64_t non_manifold_edges = 0;  ///< with more than two
    std::int64_t disagreeing_edges = 0;   ///< with two triangles that run along it in the same direction
    std::int64_t shells = 0;              ///< sets of triangles that are connected over edges
    std::int64_t euler = 0;               ///< used vertices - edges + triangles; 2 (1 - genus) for one closed shell
    double volume = 0;                    ///< signed; positive when closed and facing outward
};

[[nodiscard]] Topology compute_topology(const TriangleMesh& mesh);

}  // namespace partonomy
