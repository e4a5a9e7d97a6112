// Each figure comes from a child process of its own that inherits the mesh, so that peaks of memory do not mix. Memory
// is what a child's peak (VmHWM) is above what it began with, that is, without the mesh.

#include "bench/bench_scale.h"

#include <fmt/format.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <functional>
#include <map>

#include "bench/embree_reference.h"
#include "bench/scenes.h"
#include "shape/find_parts.h"

namespace partonomy::bench {
namespace {

struct Stage {
    std::array<char, 16> name{};
    double ms = 0;
};

struct Measured {
    double ms = 0;
    double megabytes = 0;  ///< at the peak, above the mesh
    std::size_t parts = 0;
    double accuracy = 0;  ///< share of the triangles in a region that is mostly of their part
    std::array<Stage, 24> stages{};
};

double accuracy(const std::vector<PartRegion>& regions, const std::vector<int>& truth) {
    std::size_t good = 0;
    for (const PartRegion& region : regions) {
        std::map<int, std::size_t> votes;
        for (const std::int32_t t : region.region.triangles) ++votes[truth[static_cast<std::size_t>(t)]];
        std::size_t most = 0;
        for (const auto& [part, count] : votes) most = std::max(most, count);
        good += most;
    }
    return static_cast<double>(good) / static_cast<double>(truth.size());
}

/// A line of /proc/self/status in megabytes.
double memory(const char* name) {
    double megabytes = 0;
    if (std::FILE* file = std::fopen("/proc/self/status", "r")) {
        std::array<char, 256> line{};
        while (std::fgets(line.data(), static_cast<int>(line.size()), file))
            if (std::strncmp(line.data(), name, std::strlen(name)) == 0)
                megabytes = std::atof(line.data() + std::strlen(name)) / 1024;
        std::fclose(file);
    }
    return megabytes;
}

/// Runs the work in a child; a failed one has 0 ms.
Measured in_child(const std::function<void(Measured&)>& work) {
    std::fflush(stdout);
    std::array<int, 2> ends{};
    Measured result;
    if (::pipe(ends.data()) != 0) return result;
    const pid_t child = ::fork();
    if (child == 0) {
        const double before = memory("VmRSS:");
        if (std::FILE* file = std::fopen("/proc/self/clear_refs", "w")) {  // the peak begins here
            std::fputs("5", file);
            std::fclose(file);
        }
        work(result);
        result.megabytes = memory("VmHWM:") - before;
        ::_exit(::write(ends[1], &result, sizeof result) == sizeof result ? 0 : 1);
    }
    ::close(ends[1]);
    if (::read(ends[0], &result, sizeof result) != sizeof result) result = {};
    ::close(ends[0]);
    int status = 0;
    ::waitpid(child, &status, 0);
    return result;
}

/// The better of two measurements of the same.
void keep_better(Measured& best, const Measured& other) {
    const double megabytes = std::max(best.megabytes, other.megabytes);
    if (best.ms == 0 || other.ms < best.ms) best = other;
    best.megabytes = megabytes;
}

Measured measure_embree(const TriangleMesh& mesh, const TriangleGeometry& geometry, int threads, int runs) {
    return in_child([&](Measured& m) {
        m.ms = time_embree(mesh, geometry, threads).total();
        for (int run = 1; run < runs; ++run) m.ms = std::min(m.ms, time_embree(mesh, geometry, threads).total());
    });
}

Measured measure_ours(const Scene& scene, int threads, int runs) {
    return in_child([&](Measured& m) {
        for (int run = 0; run < runs; ++run) {
            StageTimes stages;
            const auto start = std::chrono::steady_clock::now();
            const std::vector<PartRegion> regions = find_parts(scene.mesh, {.threads = threads}, &stages);
            const double ms =
                std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
            m.parts = regions.size();
            m.accuracy = accuracy(regions, scene.parts);
            if (run > 0 && ms >= m.ms) continue;
            m.ms = ms;
            for (std::size_t k = 0; k < std::min(stages.size(), m.stages.size()); ++k) {
                m.stages[k].ms = stages[k].second;
                std::strncpy(m.stages[k].name.data(), stages[k].first.c_str(), m.stages[k].name.size() - 1);
            }
        }
    });
}

}  // namespace

void bench_scale() {
    fmt::print(
        "find_parts beside Embree (tree + one ray per triangle), best of three rounds; x: times Embree on one thread; "
        "faster: one thread's time over that of two; MB are the peak above the mesh\n");
    fmt::print("{:>9} {:>6} {:>10} {:>16} {:>6} {:>6} {:>8} {:>9} {:>6} {:>10} {:>7} {:>6}\n", "triangles", "noise",
               "Embree ms", "2 threads faster", "MB", "parts", "accuracy", "1 thread", "x", "2 threads", "faster",
               "MB x");
    for (const std::size_t triangles : {75'000U, 500'000U, 5'000'000U})
        for (const double noise : {0.0, 0.01}) {
            Scene scene = figure_16(triangles);
            if (noise > 0) add_noise(scene.mesh, noise, 1);
            const int runs = triangles > 1'000'000 ? 1 : triangles > 100'000 ? 2 : 4;
            const TriangleGeometry geometry = compute_geometry(scene.mesh);
            Measured embree, embree_two, one, two;  // in turn: the machine is not as fast at all times
            for (int round = 0; round < 3; ++round) {
                keep_better(embree, measure_embree(scene.mesh, geometry, 1, runs));
                keep_better(one, measure_ours(scene, 1, runs));
                keep_better(embree_two, measure_embree(scene.mesh, geometry, 2, runs));
                keep_better(two, measure_ours(scene, 2, runs));
            }
            fmt::print(
                "{:>9} {:>5.1f}% {:>10.0f} {:>16.2f} {:>6.0f} {:>6} {:>8.4f} {:>9.0f} {:>6.2f} {:>10.0f} {:>7.2f} "
                "{:>6.2f}\n",
                scene.mesh.triangles.size(), noise * 100, embree.ms, embree.ms / embree_two.ms, embree.megabytes,
                one.parts, one.accuracy, one.ms, one.ms / embree.ms, two.ms, one.ms / two.ms,
                std::max(one.megabytes, two.megabytes) / embree.megabytes);
            for (std::size_t k = 0; k < one.stages.size() && one.stages[k].name[0] != 0; ++k)
                fmt::print("{}{} {:.1f} ms, {:.2f}", k == 0 ? "    " : "; ", one.stages[k].name.data(),
                           one.stages[k].ms, one.stages[k].ms / two.stages[k].ms);
            fmt::print("\n");
        }
}

}  // namespace partonomy::bench
