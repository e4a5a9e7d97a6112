// What `./dev bench peers` prints: CGAL's ways to cut a mesh beside find_parts, on the same meshes in the same run, one
// thread each. The Rand index error is the share of pairs of points on the surface that one side joins and the other
// parts; truths are the connected pieces of each label.
//
//   SDF             sdf_values with 25 rays and segmentation_from_sdf_values, with CGAL's own defaults (5 clusters,
//                   smoothing 0.26), and, on fig16, with the 4 clusters that there are
//   planes          region growing by planes: within 1 % of the diagonal and 25 degrees, at least 20 triangles; what is
//   in
//                   no region is one more. Planes are walls, not parts, so the error is for orientation only.
//   optimal box     oriented_bounding_box over the convex hull of each true part, beside smallest_box

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_polygon_mesh.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/mesh_segmentation.h>
#include <CGAL/optimal_bounding_box.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/errors.h"
#include "mesh/read_mesh.h"
#include "report/evaluate.h"
#include "shape/find_parts.h"

namespace partonomy::bench {
namespace {

namespace fs = std::filesystem;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Labels = std::vector<std::string>;

double time_ms(const std::function<void()>& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

/// A mesh, and the true segment of each triangle.
struct Subject {
    std::string name;
    TriangleMesh mesh;
    Vec3 up = Vec3::UnitZ();
    Labels truth;
    std::vector<double> areas;
};

Subject load(const fs::path& path, const fs::path& labels, const Vec3& up) {
    Subject subject{path.stem().string(), read_mesh(path).mesh, up, {}, {}};
    const TriangleMesh& mesh = subject.mesh;
    const Labels of_faces = read_truth(labels.string(), mesh.input_face_count);
    const Adjacency adjacency = build_adjacency(mesh);
    subject.areas = compute_geometry(mesh).areas;
    subject.truth.assign(mesh.triangles.size(), "");
    const auto label = [&](std::int32_t t) -> const std::string& {
        return of_faces[static_cast<std::size_t>(mesh.input_faces[static_cast<std::size_t>(t)])];
    };
    std::vector<std::int32_t> piece;
    for (std::size_t start = 0, number = 0; start < subject.truth.size(); ++start) {
        if (!subject.truth[start].empty() || label(static_cast<std::int32_t>(start)).empty()) continue;
        const std::string name = std::to_string(number++);
        piece.assign(1, static_cast<std::int32_t>(start));
        subject.truth[start] = name;
        for (std::size_t at = 0; at < piece.size(); ++at)
            for (const std::int32_t j : adjacency.neighbours[static_cast<std::size_t>(piece[at])])
                if (j >= 0 && subject.truth[static_cast<std::size_t>(j)].empty() && label(j) == label(piece[at])) {
                    subject.truth[static_cast<std::size_t>(j)] = name;
                    piece.push_back(j);
                }
    }
    return subject;
}

/// One road's answer: a segment of each triangle, and the time it took.
struct Answer {
    double ms = 0;
    Labels segments;
};

Answer ours(const Subject& subject) {
    Answer answer;
    std::vector<PartRegion> parts;
    answer.ms = time_ms([&] { parts = find_parts(subject.mesh, {.up = subject.up, .threads = 1}); });
    answer.segments.assign(subject.truth.size(), "none");
    for (std::size_t k = 0; k < parts.size(); ++k)
        for (const std::int32_t t : parts[k].region.triangles)
            answer.segments[static_cast<std::size_t>(t)] = std::to_string(k);
    return answer;
}

/// Face i is triangle i; empty when the surface is no manifold.
Mesh to_cgal(const TriangleMesh& mesh) {
    Mesh result;
    for (const Vec3& p : mesh.positions) result.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
    for (const auto& [a, b, c] : mesh.triangles)
        if (result.add_face(Mesh::Vertex_index(static_cast<unsigned>(a)), Mesh::Vertex_index(static_cast<unsigned>(b)),
                            Mesh::Vertex_index(static_cast<unsigned>(c))) == Mesh::null_face())
            return {};
    return result;
}

Answer by_diameter(const Mesh& mesh, std::size_t clusters) {
    Answer answer;
    Mesh copy = mesh;
    auto diameter = copy.add_property_map<Mesh::Face_index, double>("f:diameter").first;
    auto segment = copy.add_property_map<Mesh::Face_index, std::size_t>("f:segment").first;
    answer.ms = time_ms([&] {
        CGAL::sdf_values(copy, diameter);
        CGAL::segmentation_from_sdf_values(copy, diameter, segment, clusters);
    });
    for (const Mesh::Face_index f : copy.faces()) answer.segments.push_back(std::to_string(segment[f]));
    return answer;
}

Answer by_planes(const Mesh& mesh, double size) {
    using Query = CGAL::Shape_detection::Polygon_mesh::One_ring_neighbor_query<Mesh>;
    using Plane = CGAL::Shape_detection::Polygon_mesh::Least_squares_plane_fit_region<Kernel, Mesh>;
    using Growing = CGAL::Shape_detection::Region_growing<Mesh::Face_range, Query, Plane>;
    Answer answer;
    std::vector<std::vector<std::size_t>> regions;
    answer.ms = time_ms([&] {
        Query query(mesh);
        Plane plane(mesh, 0.01 * size, 25, 20, get(CGAL::vertex_point, mesh));
        const Mesh::Face_range faces = mesh.faces();
        Growing growing(faces, query, plane);
        growing.detect(std::back_inserter(regions));
    });
    answer.segments.assign(mesh.number_of_faces(), "none");
    for (std::size_t k = 0; k < regions.size(); ++k)
        for (const std::size_t f : regions[k]) answer.segments[f] = std::to_string(k);
    return answer;
}

struct Score {
    double ms = 0, error = 0;
    std::size_t segments = 0;
};

Score judge(const Subject& subject, const Answer& answer) {
    Labels names = answer.segments;
    std::sort(names.begin(), names.end());
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return {answer.ms, evaluate_labels(answer.segments, subject.truth, subject.areas).rand_index_error, names.size()};
}

void print(const std::string& mesh, const char* road, const Score& score) {
    fmt::print("  {:<16} {:<16} {:>10.0f} ms {:>9} segments   Rand index error {:.4f}\n", mesh, road, score.ms,
               score.segments, score.error);
    std::fflush(stdout);
}

std::map<std::string, Score> all_roads(const Subject& subject, bool knows_four) {
    std::map<std::string, Score> scores{{"ours", judge(subject, ours(subject))}};
    const Mesh mesh = to_cgal(subject.mesh);
    if (mesh.number_of_faces() != subject.truth.size()) return scores;
    scores["SDF"] = judge(subject, by_diameter(mesh, 5));
    if (knows_four) scores["SDF, told 4"] = judge(subject, by_diameter(mesh, 4));
    scores["planes"] = judge(subject, by_planes(mesh, compute_bounds(subject.mesh).diagonal()));
    return scores;
}

void boxes(const Subject& subject) {
    std::map<std::string, std::vector<std::int32_t>> parts;
    for (std::size_t t = 0; t < subject.truth.size(); ++t)
        for (const std::int32_t v : subject.mesh.triangles[t]) parts[subject.truth[t]].push_back(v);
    for (auto& [name, vertices] : parts) {
        std::sort(vertices.begin(), vertices.end());
        vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
        std::vector<Vec3> points;
        std::vector<Kernel::Point_3> theirs;
        for (const std::int32_t v : vertices) {
            points.push_back(subject.mesh.positions[static_cast<std::size_t>(v)]);
            theirs.emplace_back(points.back().x(), points.back().y(), points.back().z());
        }
        OrientedBox box;
        const double our_ms = time_ms([&] { box = smallest_box(points); });
        std::array<Kernel::Point_3, 8> corners;
        const double their_ms =
            time_ms([&] { CGAL::oriented_bounding_box(theirs, corners, CGAL::parameters::use_convex_hull(true)); });
        const auto edge = [&](std::size_t k) { return corners[k] - corners[0]; };
        const double volume = std::sqrt(edge(1).squared_length() * edge(3).squared_length() * edge(5).squared_length());
        fmt::print("  {:<16} part {} of {:>6} points: ours {:>6.1f} ms, CGAL {:>7.1f} ms, volume ours / CGAL {:.4f}\n",
                   subject.name, name, points.size(), our_ms, their_ms, box.lengths.prod() / volume);
    }
}

void figure_16(const fs::path& folder) {
    fmt::print("fig16 (Attene 2006, told four parts: .0019 / .0026 / .0048)\n");
    for (const char* name : {"fig16_75k", "fig16_75k_n05", "fig16_75k_n10"}) {
        const fs::path path = folder / (std::string(name) + ".ply");
        if (!fs::exists(path)) {
            fmt::print("  skipped: {} is absent\n", path.string());
            continue;
        }
        const Subject subject = load(path, folder / (std::string(name) + ".lab"), Vec3::UnitZ());
        for (const auto& [road, score] : all_roads(subject, true)) print(name, road.c_str(), score);
        boxes(subject);
    }
}

void organic_furniture(const fs::path& folder) {
    std::ifstream ups(folder / "up.csv");
    if (!ups) {
        fmt::print("LPSB: skipped, {} is absent\n", folder.string());
        return;
    }
    fmt::print("LPSB, means over the meshes\n");
    std::map<std::string, std::map<std::string, std::vector<Score>>> kinds;
    std::string line;
    std::getline(ups, line);
    while (std::getline(ups, line)) {
        const std::string mesh = line.substr(0, line.find(',')), axis = line.substr(line.find(',') + 1);
        Vec3 up = Vec3::Zero();
        up[axis[1] - 'x'] = axis[0] == '-' ? -1 : 1;
        const Subject subject = load(folder / (mesh + ".off"), folder / (mesh + "_labels.txt"), up);
        for (const auto& [road, score] : all_roads(subject, false)) kinds[mesh.substr(0, 5)][road].push_back(score);
    }
    for (const auto& [kind, roads] : kinds)
        for (const auto& [road, scores] : roads) {
            Score mean;
            for (const Score& score : scores) {
                mean.ms += score.ms / static_cast<double>(scores.size());
                mean.error += score.error / static_cast<double>(scores.size());
                mean.segments += score.segments;
            }
            mean.segments /= scores.size();
            print(fmt::format("{} ({})", kind, scores.size()), road.c_str(), mean);
        }
}

}  // namespace
}  // namespace partonomy::bench

int main() {
    try {
        partonomy::bench::figure_16(PARTONOMY_SHARED_DATA "/fig16");
        partonomy::bench::organic_furniture(PARTONOMY_SHARED_DATA "/lpsb");
    } catch (const partonomy::Error& error) {
        fmt::print(stderr, "bench: {}\n", error.what());
        return 1;
    }
    return 0;
}
