/* How long TF takes on a street of boxes, against asking T of everybody: ./dev bench relations. */

#include "bench/bench_relations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <random>

#include "algorithms/related_index.h"
#include "examples/solid.h"
#include "knowledge/theory.h"

namespace partonomy::bench {
namespace {

/// Of the processor: one thread works.
double seconds(const auto& work) {
    const std::clock_t start = std::clock();
    work();
    return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// Boxes of several sizes, spread over a square; each has 12 triangles.
Object street(int count) {
    std::mt19937 random(1);
    const auto any = [&](double from, double to) {
        return from + (to - from) * static_cast<double>(random()) / 4294967296.0;
    };
    Solid solid;
    for (int i = 0; i < count; ++i) {
        solid.begin_part("Box");
        const double x = any(0, 100), y = any(0, 100), z = any(0, 5), w = any(0.2, 1.5), d = any(0.2, 1.5);
        const std::vector<Solid::Vertex> base{solid.at(x, y, z), solid.at(x + w, y, z), solid.at(x + w, y + d, z),
                                              solid.at(x, y + d, z)};
        solid.prism(base, z + any(0.2, 3));
        solid.face(base, true);
    }
    Object object;
    object.mesh = std::move(solid).finish("street", "").mesh;
    object.geometry = compute_geometry(object.mesh);
    return object;
}

}  // namespace

void print_relations(int count) {
    const Object object = street(count);
    std::vector<PartRegion> parts(static_cast<std::size_t>(count));
    for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t)
        parts[t / (object.mesh.triangles.size() / parts.size())].region.triangles.push_back(
            static_cast<std::int32_t>(t));
    for (PartRegion& part : parts) {
        std::vector<Vec3> points;
        for (const std::int32_t t : part.region.triangles)
            for (const std::int32_t v : object.mesh.triangles[static_cast<std::size_t>(t)])
                points.push_back(object.mesh.positions[static_cast<std::size_t>(v)]);
        part.box = smallest_box(points);
    }
    const Scene scene = scene_of(object);
    std::vector<RegionPlace> places;
    for (const PartRegion& part : parts) places.push_back(place_of(scene, part));
    std::vector<const RegionPlace*> pointers;
    for (const RegionPlace& place : places) pointers.push_back(&place);
    const double build = seconds([&] { static_cast<void>(RelatedIndex(scene, pointers)); });
    const RelatedIndex index(scene, pointers);
    fmt::print("{} regions; the index takes {:.1f} ms to build\n", count, 1e3 * build);
    fmt::print("{:<14} {:>12} {:>10} {:>15}\n", "relation", "TF of all", "found", "T of everybody");
    constexpr int sampled = 20;  // references of whom everybody is asked by T
    for (const knowledge::Relation& relation :
         knowledge::find_relations(owl::parse_ontology(owl::core_ontology_text(), "core.ttl"))) {
        const auto references = [&](int i) {  // of three regions: another one beside it
            return relation.arity == 2 ? std::vector{-1, i} : std::vector{-1, i, (i + 1) % count};
        };
        std::size_t found = 0;
        const double all = seconds([&] {
            for (int i = 0; i < count; ++i) found += index.find(relation.criteria, references(i)).size();
        });
        const double asked = seconds([&] {
            for (int i = 0; i < sampled; ++i) {
                std::vector<const RegionPlace*> tuple;
                for (const int r : references(i)) tuple.push_back(pointers[static_cast<std::size_t>(std::max(r, 0))]);
                for (const RegionPlace* place : pointers) {
                    tuple[0] = place;
                    static_cast<void>(relation_score(relation.criteria, scene, tuple));
                }
            }
        });
        fmt::print("{:<14} {:>10.3f} s {:>10} {:>13.3f} s\n", owl::local_name(relation.iri), all, found,
                   asked / sampled * count);
        std::fflush(stdout);
    }
}

}  // namespace partonomy::bench
