/* Parts whose borders do not cut what is round.
 *
 * Parts are cut by thickness: where the wall of a hole comes near the side of a plate, the thin bridge between them is
 * a part of its own, and takes its share of the wall along. So all parts are cut into patches together, and a curved
 * patch that lies on several of them goes to the one that holds most of it. Flat patches stay: two boards may well lie
 * in one plane; but what is left of a part that gave most of itself away goes along. Cost: that of find_patches on the
 * whole mesh. */

#include <algorithm>
#include <map>

#include "algorithms/derive.h"
#include "algorithms/form.h"
#include "shape/part_box.h"

namespace partonomy {

std::map<std::size_t, PartRegion> keep_patches_whole(const Object& object, std::span<const PartRegion* const> parts) {
    const CalmSurface& calm = calm_surface(object);
    std::vector<std::int32_t> part_of(object.mesh.triangles.size(), -1), triangles;
    for (std::size_t i = 0; i < parts.size(); ++i)
        for (const std::int32_t t : parts[i]->region.triangles)
            part_of[static_cast<std::size_t>(t)] = static_cast<std::int32_t>(i);
    for (std::size_t t = 0; t < part_of.size(); ++t)
        if (part_of[t] >= 0) triangles.push_back(static_cast<std::int32_t>(t));
    std::map<std::size_t, PartRegion> changed;
    std::map<std::int32_t, std::map<std::int32_t, double>> given;  // part -> part that took of it -> area
    for (const Patch& patch : find_patches({calm.mesh, calm.geometry, calm.adjacency, calm.noise}, triangles)) {
        if (patch.primitive.kind == SurfaceKind::flat || patch.primitive.kind == SurfaceKind::freeform) continue;
        std::map<std::int32_t, double> areas;
        for (const std::int32_t t : patch.triangles)
            areas[part_of[static_cast<std::size_t>(t)]] += object.geometry.areas[static_cast<std::size_t>(t)];
        if (areas.size() < 2) continue;
        const std::int32_t owner =
            std::ranges::max_element(areas, {}, [](const auto& part) { return part.second; })->first;
        for (const auto& [part, area] : areas) {
            changed[static_cast<std::size_t>(part)];
            if (part != owner) given[part][owner] += area;
        }
        for (const std::int32_t t : patch.triangles) part_of[static_cast<std::size_t>(t)] = owner;
    }
    for (const auto& [part, takers] : given) {
        const std::vector<std::int32_t>& all = parts[static_cast<std::size_t>(part)]->region.triangles;
        double left = 0, gone = 0;
        for (const auto& [taker, area] : takers) gone += area;
        for (const std::int32_t t : all)
            if (part_of[static_cast<std::size_t>(t)] == part)
                left += object.geometry.areas[static_cast<std::size_t>(t)];
        if (left >= gone) continue;
        const std::int32_t taker =
            std::ranges::max_element(takers, {}, [](const auto& each) { return each.second; })->first;
        for (const std::int32_t t : all)
            if (part_of[static_cast<std::size_t>(t)] == part) part_of[static_cast<std::size_t>(t)] = taker;
    }
    for (auto& [part, region] : changed) {
        std::vector<std::int32_t> mine;
        for (const std::int32_t t : triangles)
            if (part_of[static_cast<std::size_t>(t)] == static_cast<std::int32_t>(part)) mine.push_back(t);
        if (mine.empty()) continue;
        PartBox box = measure_part(object.mesh, object.geometry, mine, object.is_noisy);
        region = {{std::move(mine), std::move(box.memberships)}, box.box, box.fit};
    }
    return changed;
}

}  // namespace partonomy
