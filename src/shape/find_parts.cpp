// Cutting a mesh into boards, sticks and cubes.
#include "shape/find_parts.h"
#include <chrono>
#include <cmath>
#include <algorithm>
#include "shape/claims.h"
#include "shape/surface.h"
#include "shape/cores.h"
namespace partonomy {
namespace {
class Clock {
public:
    explicit Clock(StageTimes* times) : times_(times) {}
    void done(const char* stage) {
        const auto now = std::chrono::steady_clock::now();
        if (times_) times_->emplace_back(stage, std::chrono::duration<double, std::milli>(now - start_).count());
        start_ = now;
    }
private:
    StageTimes* times_;
    std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};
}
std::vector<PartRegion> find_parts(const TriangleMesh& mesh, const FindPartsOptions& options, StageTimes* times) {
    Clock clock(times);
    Surface s;
    s.size = compute_bounds(mesh).diagonal();
    s.mesh = refine(mesh, refinement_length(mesh, s.size));
    clock.done("refine");
    s.adjacency = build_adjacency(s.mesh);
    s.geometry = compute_geometry(s.mesh);
    s.normals = s.geometry.normals;
    clock.done("adjacency");
    s.scene = std::make_unique<RayScene>(s.mesh);
    clock.done("tree");
    s.thickness = measure_thickness(*s.scene, s.geometry, options.threads);
    clock.done("rays");
    Cores cores = find_cores(s);
    clock.done("cores");
    Parts pieces{std::move(cores.cores), std::move(cores.core_of)};
    cut_at_boards(s, options.up, pieces);
    claim_slabs(s, options.up, pieces);
    found_new_parts(s, pieces);
    clock.done("claims");
    fill(s, pieces);
    clock.done("fill");
    std::vector<PartRegion> parts(pieces.parts.size());
    std::vector<std::int32_t> of(mesh.triangles.size(), -1);
    {
        std::vector<std::vector<std::pair<std::int32_t, double>>> votes(mesh.triangles.size());
        for (std::size_t i = 0; i < s.count(); ++i) {
            if (pieces.part_of[i] < 0) continue;
            auto& v = votes[s.mesh.input_faces[i]];
            auto at = std::find_if(v.begin(), v.end(), [&](const auto& x) { return x.first == pieces.part_of[i]; });
            if (at == v.end()) at = v.insert(at, {pieces.part_of[i], 0.0});
            at->second += s.geometry.areas[i];
        }
        for (std::size_t i = 0; i < of.size(); ++i)
            if (!votes[i].empty())
                of[i] = std::max_element(votes[i].begin(), votes[i].end(), [](const auto& x, const auto& y) { return x.second != y.second ? x.second < y.second : x.first > y.first; })->first;
    }
    for (std::size_t i = 0; i < of.size(); ++i) if (of[i] >= 0) parts[of[i]].region.triangles.push_back(int(i));
    std::vector<PartRegion> r;
    for (auto& p : parts) if (!p.region.triangles.empty()) {
        std::vector<Vec3> q;
        for (int t : p.region.triangles) for (int v : mesh.triangles[t]) q.push_back(mesh.positions[v]);
        p.region.memberships.assign(p.region.triangles.size(), 1.0F);
        p.box = smallest_box(q); r.push_back(std::move(p)); }
    return r;
}
}
