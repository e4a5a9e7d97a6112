// Cutting a mesh into boards, sticks and cubes: `find all` of paper §6.4, taken on to real shapes.
//
// The paper grows two planes from a triangle and its opposite, adds the lateral surface, and judges the box. We keep
// its idea (a part is what lies between two walls that face each other) and its single inward ray per triangle, but let
// all parts grow at once, on measurements that are local, so that bent boards and round sticks are in scope:
//
//   refine     large triangles are cut, so that a CAD mesh and a scan look alike (refine.cpp)
//   calm       a rough mesh is smoothed, so that all later steps see walls (calm.cpp)
//   rays       the distance to the opposite wall of each triangle (thickness.cpp)
//   cores      walls of alike thickness grow together with their opposite walls; the result is cut where it changes
//              between board and stick or turns a corner (cores.cpp)
//   claims     sticks are cut where a board crosses them; boards take their rims and corners (claims.cpp)
//   fill       what is left goes to the part that reaches it first, concave creases being far to cross (fill.cpp)
//   merge      two parts that face each other at close range, or continue each other, are one (merge.cpp); so are
//              pieces of one box that noise tore apart (rejoin.cpp), while what it joined is parted (protrusions.cpp); and
//              the halves of a bar that another stick ends at; the corner of two sticks is the level one's
//              (stick_corners.cpp)
//   settle     borders of fine meshes move to the creases nearby (settle.cpp)
//   vote       each triangle of the caller goes to the part that holds most of its area
//   connect    pieces that came off their part go to a neighbour, or are parts (connect.cpp)
//   boxes      smallest boxes with lengths that noise does not inflate, fitting scores (part_box.cpp)
//
// No step looks at a length that is not relative to a thickness or to the whole. `up` is used for corners only: where a
// level and an upright part are flush, the corner belongs to the level one.
//
// Cost: O(n log n) for n triangles; most of it is Embree's tree and the rays.

#include "shape/find_parts.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>

#include "base/ranges.h"
#include "mesh/parallel.h"
#include "shape/calm.h"
#include "shape/claims.h"
#include "shape/collect_parts.h"
#include "shape/connect.h"
#include "shape/cores.h"
#include "shape/find_scene_parts.h"
#include "shape/find_solids.h"
#include "shape/part_box.h"
#include "shape/pieces.h"
#include "shape/refine.h"
#include "shape/surface.h"

namespace partonomy {

namespace {

/// The part that holds most of each of the caller's triangles, or -1.
std::vector<std::int32_t> vote(const Surface& s, const std::vector<std::int32_t>& part_of) {
    using Share = std::pair<std::int32_t, double>;
    std::vector<std::int32_t> winner(s.mesh.input_face_count, -1);
    std::vector<Share> shares;
    const auto close = [&](std::int32_t face) {
        if (shares.empty()) return;
        const auto best = std::max_element(shares.begin(), shares.end(), [](const Share& a, const Share& b) {
            return a.second != b.second ? a.second < b.second : a.first > b.first;
        });
        winner[face] = best->first;
        shares.clear();
    };
    // Refining keeps the pieces of one triangle together.
    for (std::size_t i = 0; i < s.count(); ++i) {
        if (part_of[i] >= 0) {
            auto at = std::find_if(shares.begin(), shares.end(), [&](const Share& x) { return x.first == part_of[i]; });
            if (at == shares.end()) at = shares.insert(at, {part_of[i], 0.0});
            at->second += s.geometry.areas[i];
        }
        if (i + 1 == s.count() || s.mesh.input_faces[i + 1] != s.mesh.input_faces[i]) close(s.mesh.input_faces[i]);
    }
    return winner;
}

/// The solids of the mesh that rays meet: the fine one, or the caller's.
std::vector<std::int32_t> solids_of(const Surface& s, const TriangleMesh* callers) {
    std::vector<std::int32_t> fine = find_solids(s.mesh, s.adjacency, s.threads);
    if (fine.empty() || callers == nullptr || callers->triangles.size() == fine.size()) return fine;
    std::vector<std::int32_t> solids(callers->triangles.size(), -1);
    for (std::size_t i = 0; i < fine.size(); ++i) solids[s.mesh.input_faces[i]] = fine[i];
    return solids;
}

}  // namespace

std::vector<PartRegion> collect_parts(const TriangleMesh& mesh, const TriangleGeometry& geometry,
                                      const std::vector<std::int32_t>& part_of, bool is_noisy, int threads) {
    std::vector<std::int32_t> highest = map_blocks(part_of.size(), threads, [&](std::size_t begin, std::size_t end) {
        return *std::max_element(part_of.begin() + begin, part_of.begin() + end);
    });
    const std::size_t parts = highest.empty() ? 0 : static_cast<std::size_t>(1 + std::ranges::max(highest));
    const Groups members = group_members(part_of, parts, threads);
    std::vector<std::size_t> order;  // parts by their lowest triangle
    for (std::size_t part = 0; part < parts; ++part)
        if (!members[part].empty()) order.push_back(part);
    std::ranges::sort(order, {}, [&](std::size_t part) { return members[part].front(); });
    std::vector<std::size_t> large_first(order.size());  // what is begun last should not take long
    std::iota(large_first.begin(), large_first.end(), 0);
    std::ranges::stable_sort(large_first, std::greater<>(), [&](std::size_t k) { return members[order[k]].size(); });
    std::vector<PartRegion> regions(order.size());
    for_each_range(
        regions.size(), threads,
        [&](std::size_t begin, std::size_t end) {
            for (std::size_t at = begin; at < end; ++at) {
                const auto triangles = members[order[large_first[at]]];
                PartRegion& part = regions[large_first[at]];
                part.region.triangles.assign(triangles.begin(), triangles.end());
                PartBox measured = measure_part(mesh, geometry, part.region.triangles, is_noisy, threads);
                part.region.memberships = std::move(measured.memberships);
                part.box = measured.box;
                part.fit = measured.fit;
                part.is_noisy = is_noisy;
            }
        },
        1);
    return regions;
}

std::vector<PartRegion> find_parts(const TriangleMesh& mesh, const FindPartsOptions& options, StageTimes* times) {
    if (mesh.triangles.empty()) return {};
    if (options.is_scene) return find_scene_parts(mesh, options, times);
    StageClock clock(times);
    const double size = compute_bounds(mesh, options.threads).diagonal();
    Refinement refinement;
    const double limit = refinement_length(mesh, size, options.threads);
    const bool is_refined = limit < std::numeric_limits<double>::infinity();
    if (is_refined) refinement = refine(mesh, limit);
    const TriangleMesh& fine = is_refined ? refinement.mesh : mesh;
    clock.done("refine");
    Adjacency adjacency = build_adjacency(fine, options.threads);
    TriangleGeometry fine_geometry = compute_geometry(fine, options.threads);
    clock.done("adjacency");
    const Calming calming = calm(fine, adjacency, fine_geometry, options.threads);
    const bool was_rough = calming.grain > 0;
    Surface s(was_rough ? calming.mesh : fine);
    s.adjacency = std::move(adjacency);
    s.geometry = std::move(fine_geometry);
    s.threads = options.threads;
    s.size = size;
    s.grain = calming.grain;
    if (calming.is_blurred) s.creases = find_creases(s);
    clock.done("calm");
    // A calmed mesh is another one: the caller's triangles are no longer what rays should meet.
    s.scene = was_rough ? std::make_unique<RayScene>(s.mesh, options.threads)
                        : std::make_unique<RayScene>(mesh, options.tree, &refinement, options.threads);
    s.scene->tell_apart(solids_of(s, was_rough ? nullptr : &mesh));
    if (was_rough || !options.tree) clock.done("tree");
    s.thickness = measure_thickness(*s.scene, s.geometry, options.threads);
    clock.done("rays");
    Cores cores = find_cores(s);
    clock.done("cores");
    Parts parts{std::move(cores.cores), std::move(cores.core_of)};
    if (options.is_joined) merge_parts(s, parts);  // walls of one stick that were found apart are no rims
    claim(s, options.up, parts);
    {
        const Groups free = free_pieces(s, parts);
        found_new_parts(s, free, parts);
        clock.done("claims");
        s.scene.reset();
        fill(s, free, parts);
    }
    clock.done("fill");
    if (options.is_joined) merge_parts(s, parts);
    if (options.is_joined && was_rough) {
        rejoin_torn_parts(s, parts);
        part_protrusions(s, parts);
    }
    if (options.is_joined) join_halved_bars(s, parts);
    give_corners_to_level_sticks(s, options.up, parts);
    clock.done("merge");
    if (!is_refined || was_rough) settle_borders(s, parts);
    clock.done("settle");
    if (!is_refined) {
        connect(s, s.mesh, s.adjacency, s.geometry, parts.part_of);
        clock.done("vote");
        std::vector<PartRegion> regions = collect_parts(s.mesh, s.geometry, parts.part_of, was_rough, options.threads);
        clock.done("boxes");
        return regions;
    }
    TriangleMesh calmed;  // the caller's triangles, when they were rough
    if (was_rough) {
        calmed = mesh;
        std::copy_n(s.mesh.positions.begin(), mesh.positions.size(), calmed.positions.begin());
    }
    const TriangleMesh& measured = was_rough ? calmed : mesh;
    const TriangleGeometry geometry = compute_geometry(measured);
    std::vector<std::int32_t> part_of = vote(s, parts.part_of);
    connect(s, measured, build_adjacency(mesh), geometry, part_of);
    clock.done("vote");
    std::vector<PartRegion> regions = collect_parts(measured, geometry, part_of, was_rough, options.threads);
    clock.done("boxes");
    return regions;
}

}  // namespace partonomy
