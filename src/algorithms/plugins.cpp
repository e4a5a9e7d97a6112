/* Algorithms from outside (include/partonomy/plugin.h): each becomes a measure beside the built-in ones, of a region or
 * between regions, and nothing else of the program knows the difference.
 *
 * A plugin is somebody else's code in our process. What can be caught is caught: exceptions, and numbers that are none,
 * leave the question open, and a note tells which plugin it was. A crash or an endless loop cannot be. */

#include "algorithms/plugins.h"

#include <dlfcn.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <exception>
#include <filesystem>
#include <limits>
#include <mutex>
#include <set>

#include "algorithms/linked_algorithms.h"
#include "algorithms/measures.h"
#include "algorithms/relations.h"
#include "base/errors.h"
#include "partonomy/plugin.h"

namespace partonomy {
namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

struct Troubles {
    std::mutex mutex;
    std::set<std::string> sentences;
};

Troubles& troubles() {
    static Troubles all;
    return all;
}

void note(const std::string& sentence) {
    const std::scoped_lock lock(troubles().mutex);
    troubles().sentences.insert(sentence);
}

/// One region as plugins see it.
struct Shown {
    std::vector<double> corners;
    PartonomyRegion region{};

    Shown(const Object& object, std::span<const std::int32_t> triangles, const Vec3& lengths) {
        corners.reserve(9 * triangles.size());
        for (const std::int32_t t : triangles)
            for (const std::int32_t v : object.mesh.triangles[static_cast<std::size_t>(t)]) {
                const Vec3& p = object.mesh.positions[static_cast<std::size_t>(v)];
                corners.insert(corners.end(), {p.x(), p.y(), p.z()});
            }
        region = {corners.data(), triangles.size(), {lengths[0], lengths[1], lengths[2]}};
    }
};

double call(const PartonomyAlgorithm& algorithm, const std::string& origin, const Object& object,
            const std::vector<PartonomyRegion>& regions) {
    const Vec3& up = object.placement.up;
    const PartonomyObject shown{
        {up.x(), up.y(), up.z()}, object.low, object.high, object.placement.metres_per_unit.value_or(0)};
    const auto left_open = [&](const std::string& what) {
        note(fmt::format("{}: \"{}\" {}; what hangs on it stays open", origin, algorithm.name, what));
        return nothing;
    };
    try {
        const double value = algorithm.measure(&shown, regions.data());
        return std::isfinite(value) ? value : left_open(fmt::format("returned {}, which is no number", value));
    } catch (const std::exception& error) {
        return left_open(fmt::format("threw an exception: {}", error.what()));
    } catch (...) {
        return left_open("threw something that is no exception");
    }
}

/// What is wrong with an algorithm; empty when it can be used.
std::string complaint(const PartonomyAlgorithm* algorithm) {
    if (!algorithm) return "its partonomy_algorithm returns no algorithm";
    if (algorithm->version != PARTONOMY_PLUGIN_VERSION)
        return fmt::format(
            "it was made for version {} of the plugin interface and this program has version {}; "
            "compile it again with this program's partonomy/plugin.h",
            algorithm->version, PARTONOMY_PLUGIN_VERSION);
    for (const char* text : {algorithm->name, algorithm->unit, algorithm->description})
        if (!text || !*text) return "its algorithm should have a name, a unit and a description";
    if (algorithm->region_count < 1 || algorithm->region_count > 3)
        return fmt::format("\"{}\" measures {} regions; it should be 1, 2 or 3", algorithm->name,
                           algorithm->region_count);
    if (!algorithm->measure) return fmt::format("\"{}\" has no function that measures", algorithm->name);
    if (find_measure(algorithm->name) || find_relation_measure(algorithm->name))
        return fmt::format("there is a measure \"{}\" already; choose another name", algorithm->name);
    return {};
}

}  // namespace

void add_algorithm(const PartonomyAlgorithm* algorithm, const std::string& origin) {
    if (const std::string wrong = complaint(algorithm); !wrong.empty()) throw FileError(at(origin, 0, wrong));
    if (algorithm->region_count == 1) {
        add_measure({algorithm->name, algorithm->unit, algorithm->description, false, Effort::on_demand,
                     [algorithm, origin](const Object& object, const RegionMeasurements& region) {
                         return call(*algorithm, origin, object,
                                     {Shown(object, region.triangles, region.lengths).region});
                     }});
        return;
    }
    add_relation_measure(
        {algorithm->name, static_cast<std::size_t>(algorithm->region_count), algorithm->unit, algorithm->description,
         [algorithm, origin](const Scene& scene, RelationMeasure::Regions places) {
             std::vector<Shown> shown;
             for (const RegionPlace* place : places)
                 shown.emplace_back(*scene.object, place->part->region.triangles, place->part->box.lengths);
             std::vector<PartonomyRegion> regions;
             for (const Shown& each : shown) regions.push_back(each.region);
             const double value = call(*algorithm, origin, *scene.object, regions);
             return std::isnan(value) ? std::nullopt : std::optional(value);
         }});
}

void load_plugin(const std::string& path) {
    static std::set<std::filesystem::path> loaded;
    std::error_code error;
    const std::filesystem::path file = std::filesystem::canonical(path, error);
    if (error)
        throw FileError(at(path, 0, "there is no such plugin; --plugin needs a shared library, such as ./mine.so"));
    if (!loaded.insert(file).second) return;
    void* library = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!library) throw FileError(at(path, 0, fmt::format("cannot be loaded as a plugin: {}", ::dlerror())));
    using Entry = const PartonomyAlgorithm* (*)();
    const auto entry = reinterpret_cast<Entry>(::dlsym(library, "partonomy_algorithm"));
    if (!entry)
        throw FileError(
            at(path, 0, "is no plugin of Partonomy: it exports no function partonomy_algorithm (see docs/plugins.md)"));
    const PartonomyAlgorithm* algorithm = nullptr;
    try {
        algorithm = entry();
    } catch (...) {
        throw FileError(at(path, 0, "its function partonomy_algorithm throws; it should return an algorithm"));
    }
    add_algorithm(algorithm, path);
}

void add_linked_algorithms() {
    static const bool done = [] {
        for (const LinkedAlgorithm& each : linked_algorithms()) add_algorithm(each.entry(), each.file);
        return true;
    }();
    static_cast<void>(done);
}

std::vector<std::string> plugin_troubles() {
    const std::scoped_lock lock(troubles().mutex);
    return {troubles().sentences.begin(), troubles().sentences.end()};
}

}  // namespace partonomy
