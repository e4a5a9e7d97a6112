// A street has hundreds of things, and none is a thousandth of it. Cut as a whole, small things would be lost in the
// tolerances of large ones, and rays would pass from one thing into the next. So it is first cut into pieces by their
// creases; a plain piece is a region, the others are meshes of their own that find_parts cuts, side by side on all
// threads. Cost: O(n log n).

#include "shape/find_scene_parts.h"

#include "base/ranges.h"
#include "mesh/parallel.h"
#include "shape/collect_parts.h"
#include "shape/scene_pieces.h"

namespace partonomy {

namespace {

/// The triangles of a piece as a mesh; its faces are their numbers in the piece. `vertex_of` is -1 all over, before and
/// after.
TriangleMesh mesh_of(const TriangleMesh& mesh, const std::vector<std::int32_t>& triangles,
                     std::vector<std::int32_t>& vertex_of) {
    TriangleMesh result;
    for (const std::int32_t t : triangles) {
        auto& corners = result.triangles.emplace_back();
        for (std::size_t i = 0; i < 3; ++i) {
            std::int32_t& vertex = vertex_of[mesh.triangles[t][i]];
            if (vertex < 0) {
                vertex = static_cast<std::int32_t>(result.positions.size());
                result.positions.push_back(mesh.positions[mesh.triangles[t][i]]);
            }
            corners[i] = vertex;
        }
        result.input_faces.push_back(result.input_face_count++);
    }
    for (const std::int32_t t : triangles)
        for (const std::int32_t v : mesh.triangles[t]) vertex_of[v] = -1;
    return result;
}

}  // namespace

std::vector<PartRegion> find_scene_parts(const TriangleMesh& mesh, const FindPartsOptions& options, StageTimes* times) {
    StageClock clock(times);
    const Adjacency adjacency = build_adjacency(mesh, options.threads);
    const TriangleGeometry geometry = compute_geometry(mesh, options.threads);
    clock.done("adjacency");
    const std::vector<ScenePiece> pieces = scene_pieces(mesh, adjacency, geometry);
    clock.done("pieces");
    std::vector<std::vector<PartRegion>> parts(pieces.size());
    for_each_range(
        pieces.size(), options.threads,
        [&](std::size_t begin, std::size_t end) {
            std::vector<std::int32_t> vertex_of;
            for (std::size_t k = begin; k < end; ++k) {
                if (pieces[k].is_plain) continue;
                vertex_of.resize(mesh.positions.size(), -1);
                parts[k] = find_parts(mesh_of(mesh, pieces[k].triangles, vertex_of), {.up = options.up});
            }
        },
        1);
    std::vector<std::int32_t> part_of(mesh.triangles.size());
    std::int32_t count = 0;
    bool is_noisy = false;
    for (std::size_t k = 0; k < pieces.size(); ++k) {
        for (const std::int32_t t : pieces[k].triangles) part_of[t] = count;  // what is in no part of it stays together
        ++count;
        for (const PartRegion& part : parts[k]) {
            for (const std::int32_t t : part.region.triangles) part_of[pieces[k].triangles[t]] = count;
            is_noisy |= part.is_noisy;
            ++count;
        }
    }
    clock.done("parts of pieces");
    std::vector<PartRegion> regions = collect_parts(mesh, geometry, part_of, is_noisy, options.threads);
    clock.done("boxes");
    return regions;
}

}  // namespace partonomy
