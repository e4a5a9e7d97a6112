/* What `./dev bench` prints: times as medians of several runs, beside a named reference measured in the same run. */

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <functional>
#include <vector>

#include "base/files.h"
#include "base/heap.h"
#include "bench/bench_hermit.h"
#include "bench/bench_knowledge.h"
#include "bench/bench_relations.h"
#include "bench/bench_scale.h"
#include "bench/embree_reference.h"
#include "examples/objects.h"
#include "expert/annotate.h"
#include "knowledge/decision_tree.h"
#include "mesh/read_mesh.h"
#include "mesh/write_off.h"

namespace partonomy::bench {
namespace {

namespace fs = std::filesystem;

double median_ms(int runs, const std::function<void()>& work) {
    std::vector<double> times;
    for (int i = 0; i < runs; ++i) {
        const auto start = std::chrono::steady_clock::now();
        work();
        times.push_back(std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count());
    }
    std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
    return times[static_cast<std::size_t>(runs / 2)];
}

/// Runs the program, its output thrown away; its exit code must not be an error. It is spawned, not forked: a fork
/// copies this process's own page tables, which by then takes longer than some of what is timed.
void run_program(const std::vector<std::string>& arguments) {
    std::vector<char*> argv;
    for (const std::string& argument : arguments) argv.push_back(const_cast<char*>(argument.c_str()));
    argv.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    ::posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    pid_t child = 0;
    const int failed = ::posix_spawn(&child, argv[0], &actions, nullptr, argv.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (failed != 0) {
        fmt::print(stderr, "bench: {} cannot be started: {}\n", arguments[0], std::strerror(failed));
        std::exit(1);
    }
    int status = 0;
    ::waitpid(child, &status, 0);
    const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 127;
    if (code != 0 && code != 2) {
        fmt::print(stderr, "bench: {} failed with {}\n", fmt::join(arguments, " "), code);
        std::exit(1);
    }
}

const std::string ontology = PARTONOMY_SOURCE_DIR "/ontologies/furniture.ttl";

void bench_whole_process(const fs::path& folder) {
    fmt::print("\nWhole process, warm cache, all formats (floor: --version, which only starts the program)\n");
    const double floor = median_ms(41, [] { run_program({PARTONOMY_BINARY, "--version"}); });
    fmt::print("  {:<18} {:>9} {:>12} {:>9} {:>12}\n", "object", "triangles", "1 thread ms", "x floor", "all cores ms");
    fmt::print("  {:<18} {:>9} {:>12.1f} {:>9.1f}\n", "--version", "", floor, 1.0);
    const std::string out = (folder / "out").string();
    for (const ExampleObject& object : paper_objects()) {
        const std::string mesh = (folder / (object.name + ".off")).string();
        write_file(mesh, to_off(object.mesh));
        const auto time = [&](const char* threads) {
            return median_ms(21, [&] {
                run_program({PARTONOMY_BINARY, "annotate", mesh, "--ontology", ontology, "-o", out, "--threads",
                             threads, "--quiet"});
            });
        };
        const double one = time("1"), all = time("0");
        fmt::print("  {:<18} {:>9} {:>12.1f} {:>9.1f} {:>12.1f}\n", object.name, object.mesh.triangles.size(), one,
                   one / floor, all);
    }
}

void bench_ontology() {
    fmt::print("\nOntologies in process, medians in ms (the paper: 11450 ms from file to saved tree)\n");
    fmt::print("  {:<20} {:>14} {:>6} {:>8} {:>14} {:>6} {:>6}\n", "", "configurations", "read", "compile",
               "gain per cost", "saved", "all");
    for (const char* name : {"paper-furniture.ttl", "furniture.ttl"}) {
        const std::string path = std::string(PARTONOMY_SOURCE_DIR "/ontologies/") + name;
        const owl::LoadOptions options{{}, false};
        const double load = median_ms(41, [&] { static_cast<void>(owl::load_ontology(path, options)); });
        const owl::Ontology loaded = owl::load_ontology(path, options);
        const double compile = median_ms(41, [&] { static_cast<void>(knowledge::compile(loaded)); });
        const knowledge::Domain domain = knowledge::compile(loaded);
        knowledge::PlanOptions plan;
        for (std::size_t c = 0; c < domain.regions.concepts.size(); ++c)
            plan.wanted.push_back(static_cast<knowledge::ConceptId>(c));
        const double grown = median_ms(21, [&] { static_cast<void>(build_tree(domain.regions, plan)); });
        const knowledge::DecisionTree tree = build_tree(domain.regions, plan);
        const double saved = median_ms(21, [&] { static_cast<void>(to_json(tree, domain)); });
        fmt::print("  {:<20} {:>14} {:>6.2f} {:>8.2f} {:>14.2f} {:>6.2f} {:>6.2f}\n", name,
                   domain.regions.possible.count(), load, compile, grown, saved, load + compile + grown + saved);
    }
}

void bench_find_parts(const std::string& name, const TriangleMesh& mesh) {
    constexpr int runs = 9;
    const TriangleGeometry geometry = compute_geometry(mesh);
    EmbreeTimes embree;
    const double embree_ms = median_ms(runs, [&] { embree = time_embree(mesh, geometry); });
    StageTimes stages;
    std::size_t parts = 0;
    const double ours = median_ms(runs, [&] {
        stages.clear();
        parts = find_parts(mesh, {}, &stages).size();
    });
    fmt::print("\n{}: {} triangles, {} parts, one thread\n", name, mesh.triangles.size(), parts);
    fmt::print("  reference: Embree build {:.1f} + one ray per triangle {:.1f} = {:.1f} ms (with set-up {:.1f} ms)\n",
               embree.build, embree.rays, embree.total(), embree_ms);
    fmt::print("  find parts: {:.1f} ms = {:.2f} x reference\n", ours, ours / embree.total());
    for (const auto& [stage, ms] : stages)
        fmt::print("    {:<28} {:>8.1f} ms {:>6.2f} x\n", stage, ms, ms / embree.total());
}

}  // namespace
}  // namespace partonomy::bench

int main(int count, char** arguments) {
    using namespace partonomy;
    keep_freed_memory();  // as the program does
    if (count > 1 && std::string(arguments[1]) == "scale") {
        bench::bench_scale();
        return 0;
    }
    if (count > 1 && std::string(arguments[1]) == "relations") {
        bench::print_relations(2000);
        return 0;
    }
    if (count > 1 && std::string(arguments[1]) == "hermit") {
        bench::bench_hermit(true);
        return 0;
    }
    namespace fs = std::filesystem;
    const fs::path folder = fs::temp_directory_path() / ("partonomy-bench-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    bench::bench_ontology();
    bench::bench_hermit(false);
    bench::bench_knowledge();
    bench::bench_whole_process(folder);
    bool has_data = false;
    for (const char* name : {"fig16_75k", "fig16_75k_n05", "fig16_75k_n10"}) {
        const fs::path path = fs::path(PARTONOMY_SHARED_DATA) / "fig16" / (std::string(name) + ".ply");
        if (!fs::exists(path)) continue;
        has_data = true;
        bench::bench_find_parts(name, read_mesh(path).mesh);
    }
    if (!has_data) fmt::print("\nfig16: skipped, ../shared/data/fig16 is absent\n");
    fs::remove_all(folder);
    return 0;
}
