#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "base/errors.h"
#include "mesh/edges.h"
#include "mesh/read_mesh.h"
#include "mesh/t_junctions.h"
#include "mesh/triangulate.h"
#include "mesh/weld.h"
#include "mesh/winding.h"

// From the polygons of a file to a mesh that the rest can trust, in this order: weld, triangulate, leave out what has
// no area and what is there twice, number the vertices that remain in file order, cut edges at T-junctions, make the
// winding agree. Each step is linear but for small sorts. Nothing moves: every position that stays has exactly the
// coordinates of the file.

namespace partonomy {
namespace {

using Triangle = std::array<std::int32_t, 3>;

std::vector<std::int32_t> weld(const PolygonSoup& soup, const CleanOptions& options, MeshReport& report) {
    std::vector<bool> used(soup.positions.size(), false);
    for (const std::int32_t v : soup.corners) used[static_cast<std::size_t>(v)] = true;
    report.unused_vertices = std::count(used.begin(), used.end(), false);
    Vec3 low = Vec3::Zero(), high = Vec3::Zero();
    bool first = true;
    for (std::size_t v = 0; v < used.size(); ++v) {
        if (!used[v]) continue;
        low = first ? soup.positions[v] : Vec3(low.cwiseMin(soup.positions[v]));
        high = first ? soup.positions[v] : Vec3(high.cwiseMax(soup.positions[v]));
        first = false;
    }
    std::vector<std::int32_t> merged = weld_points(soup.positions, used, options.weld_tolerance * (high - low).norm());
    for (std::size_t v = 0; v < used.size(); ++v) report.welded_vertices += used[v] && merged[v] != static_cast<int>(v);
    return merged;
}

void triangulate(const PolygonSoup& soup, const std::vector<std::int32_t>& merged, TriangleMesh& mesh,
                 MeshReport& report) {
    mesh.triangles.reserve(soup.corners.size() - std::min(soup.corners.size(), 2 * (soup.face_starts.size() - 1)));
    mesh.input_faces.reserve(mesh.triangles.capacity());
    std::vector<std::int32_t> corners;
    for (std::size_t f = 0; f + 1 < soup.face_starts.size(); ++f) {
        corners.clear();
        for (std::int64_t i = soup.face_starts[f]; i < soup.face_starts[f + 1]; ++i)
            corners.push_back(merged[static_cast<std::size_t>(soup.corners[static_cast<std::size_t>(i)])]);
        triangulate_polygon(soup.positions, corners, mesh.triangles);
        if (mesh.input_faces.size() == mesh.triangles.size()) ++report.degenerate_faces;
        mesh.input_faces.resize(mesh.triangles.size(), static_cast<std::int32_t>(f));
    }
}

using Twins = std::vector<std::pair<std::size_t, std::size_t>>;  ///< triangle, the one before it in the same place

/// Takes those twins off the list that are where two solids touch: they face each other, and all around where they lie
/// each solid goes on. The two sides of a sheet end together, and those of a surface that is there twice never end.
void keep_contacts(const TriangleMesh& mesh, const EdgeTable& edges, Twins& twins) {
    constexpr std::int32_t none = -1;
    std::vector<std::int32_t> twin_of(mesh.triangles.size(), none);  // place in `twins`
    std::vector<char> is_contact(twins.size(), 1), ends(twins.size(), 0);
    for (std::size_t i = 0; i < twins.size(); ++i) {
        const Triangle &a = mesh.triangles[twins[i].first], &b = mesh.triangles[twins[i].second];
        const auto corner = static_cast<std::size_t>(std::find(b.begin(), b.end(), a[0]) - b.begin());
        if (b[(corner + 1) % 3] == a[1]) is_contact[i] = 0;  // faces the same way
        for (const std::size_t triangle : {twins[i].first, twins[i].second}) {
            if (twin_of[triangle] != none) is_contact[i] = is_contact[static_cast<std::size_t>(twin_of[triangle])] = 0;
            twin_of[triangle] = static_cast<std::int32_t>(i);
        }
    }
    std::vector<std::size_t> patch(twins.size());
    std::iota(patch.begin(), patch.end(), std::size_t{0});
    const auto find = [&](std::size_t i) {
        while (patch[i] != i) i = patch[i] = patch[patch[i]];
        return i;
    };
    for (std::size_t e = 0; e < edges.size(); ++e) {
        std::optional<std::size_t> first;
        bool goes_on = false;
        for (const std::int32_t h : edges[e]) {
            const std::int32_t twin = twin_of[static_cast<std::size_t>(h / 3)];
            goes_on |= twin == none;
            if (twin == none) continue;
            const std::size_t root = find(static_cast<std::size_t>(twin));
            if (first)
                patch[std::max(find(*first), root)] = std::min(find(*first), root);
            else
                first = root;
        }
        if (!first) continue;
        if (edges[e].size() < 4 || edges[e].size() % 2 != 0) is_contact[*first] = 0;
        if (goes_on) ends[*first] = 1;
    }
    for (std::size_t i = 0; i < twins.size(); ++i) {
        if (!is_contact[i]) is_contact[find(i)] = 0;
        if (ends[i]) ends[find(i)] = 1;
    }
    std::size_t kept = 0;
    for (std::size_t i = 0; i < twins.size(); ++i)
        if (!is_contact[find(i)] || !ends[find(i)]) twins[kept++] = twins[i];
    twins.resize(kept);
}

/// Leaves the first of the triangles with the same three corners, but for two solids that touch. Twins share their
/// edges, so only triangles around an edge of more than two, or of two with the same third corner, are compared.
void drop_duplicates(TriangleMesh& mesh, const EdgeTable& edges, MeshReport& report) {
    const auto third = [&](std::int32_t h) {
        return mesh.triangles[static_cast<std::size_t>(h / 3)][static_cast<std::size_t>((h % 3 + 2) % 3)];
    };
    std::vector<bool> dropped(mesh.triangles.size(), false);
    std::vector<std::pair<std::int32_t, std::int32_t>> thirds;  // third corner, triangle
    Twins twins;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const auto around = edges[e];
        if (around.size() < 2 || (around.size() == 2 && third(around[0]) != third(around[1]))) continue;
        thirds.clear();
        for (const std::int32_t h : around) thirds.emplace_back(third(h), h / 3);
        std::sort(thirds.begin(), thirds.end());
        for (std::size_t i = 1; i < thirds.size(); ++i)
            if (thirds[i].first == thirds[i - 1].first) {
                const auto twin = static_cast<std::size_t>(thirds[i].second);
                if (!dropped[twin]) twins.emplace_back(twin, static_cast<std::size_t>(thirds[i - 1].second));
                dropped[twin] = true;
            }
    }
    if (twins.empty()) return;
    keep_contacts(mesh, edges, twins);
    dropped.assign(dropped.size(), false);
    for (const auto& [twin, first] : twins) dropped[twin] = true;
    report.duplicate_faces = std::count(dropped.begin(), dropped.end(), true);
    if (report.duplicate_faces == 0) return;
    std::sort(twins.begin(),
              twins.end());  // by dropped triangle: a twin of a twin comes later and finds its face settled
    std::vector<bool> has_own(static_cast<std::size_t>(mesh.input_face_count), false);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (!dropped[t]) has_own[static_cast<std::size_t>(mesh.input_faces[t])] = true;
    for (const auto& [twin, first] : twins)
        if (!has_own[static_cast<std::size_t>(mesh.input_faces[twin])])
            mesh.repeated_faces.emplace_back(mesh.input_faces[twin], mesh.input_faces[first]);
    std::size_t kept = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        if (dropped[t]) continue;
        mesh.triangles[kept] = mesh.triangles[t];
        mesh.input_faces[kept++] = mesh.input_faces[t];
    }
    mesh.triangles.resize(kept);
    mesh.input_faces.resize(kept);
}

void number_vertices(const PolygonSoup& soup, TriangleMesh& mesh) {
    std::vector<std::int32_t> number(soup.positions.size(), -1);
    for (const Triangle& triangle : mesh.triangles)
        for (const std::int32_t v : triangle) number[static_cast<std::size_t>(v)] = 0;
    for (std::size_t v = 0; v < number.size(); ++v) {
        if (number[v] < 0) continue;
        number[v] = static_cast<std::int32_t>(mesh.positions.size());
        mesh.positions.push_back(soup.positions[v]);
    }
    for (Triangle& triangle : mesh.triangles)
        for (std::int32_t& v : triangle) v = number[static_cast<std::size_t>(v)];
}

std::string counted(std::int64_t n, const char* one, const char* many) {
    return n == 1 ? fmt::format("1 {}", one) : fmt::format("{} {}", n, many);
}

}  // namespace

std::vector<std::string> MeshReport::sentences() const {
    std::vector<std::string> all = notes;
    if (welded_vertices > 0)
        all.push_back(counted(welded_vertices, "vertex lay", "vertices lay") + " at the place of another one and " +
                      (welded_vertices == 1 ? "was" : "were") + " merged into it.");
    if (unused_vertices > 0)
        all.push_back(counted(unused_vertices, "vertex belongs", "vertices belong") + " to no face.");
    if (degenerate_faces > 0)
        all.push_back(counted(degenerate_faces, "face has", "faces have") + " no area and will carry no label.");
    if (duplicate_faces > 0)
        all.push_back(counted(duplicate_faces, "triangle repeats", "triangles repeat") +
                      " another one with the same corners; they share its label.");
    if (flipped_triangles > 0)
        all.push_back(counted(flipped_triangles, "triangle was", "triangles were") +
                      " turned over, to agree with the neighbours and face outward.");
    if (one_sided_shells > 0)
        all.push_back(counted(one_sided_shells, "piece of the surface is", "pieces of the surface are") +
                      " one-sided, like a Moebius strip: inside and outside cannot be told there.");
    if (cavities > 0)
        all.push_back(counted(cavities, "closed shell lies", "closed shells lie") +
                      " inside another one and faces inward: taken for a cavity.");
    if (boundary_edges > 0)
        all.push_back("The surface is open: " + counted(boundary_edges, "edge has", "edges have") +
                      " a triangle on one side only.");
    if (non_manifold_edges > 0)
        all.push_back(counted(non_manifold_edges, "edge is", "edges are") + " shared by more than two triangles.");
    return all;
}

TriangleMesh clean_mesh(const PolygonSoup& soup, const std::string& name, MeshReport& report,
                        const CleanOptions& options) {
    report = MeshReport{};
    report.notes = soup.notes;
    report.input_vertices = static_cast<std::int64_t>(soup.positions.size());
    report.input_faces = soup.face_count();
    TriangleMesh mesh;
    mesh.input_face_count = static_cast<std::int32_t>(soup.face_count());
    if (soup.face_count() > 0) triangulate(soup, weld(soup, options, report), mesh, report);
    if (mesh.triangles.empty())
        throw MeshError(at(name, 0,
                           fmt::format("none of its {} has an area; a mesh needs at least one triangle",
                                       counted(report.input_faces, "face", "faces"))));
    if (mesh.triangles.size() > (std::size_t{1} << 31) / 3 - 1)
        throw MeshError(at(name, 0, "has more than 715 million triangles; cut it into several files"));
    number_vertices(soup, mesh);
    EdgeTable edges = build_edges(mesh.triangles, mesh.positions.size());
    drop_duplicates(mesh, edges, report);
    if (report.duplicate_faces > 0) edges = build_edges(mesh.triangles, mesh.positions.size());
    if (const std::int64_t cut = cut_at_t_junctions(mesh, edges); cut > 0) {
        report.notes.push_back(counted(cut, "edge runs", "edges run") +
                               " along several shorter ones (T-junctions); the surface was closed there.");
        edges = build_edges(mesh.triangles, mesh.positions.size());
    }
    for (std::size_t e = 0; e < edges.size(); ++e) {
        report.boundary_edges += edges[e].size() == 1;
        report.non_manifold_edges += edges[e].size() > 2;
    }
    const WindingReport winding = unify_winding(mesh, edges);
    report.flipped_triangles = winding.flipped;
    report.cavities = winding.cavities;
    report.one_sided_shells = winding.one_sided;
    report.shells = winding.shells;
    return mesh;
}

}  // namespace partonomy
