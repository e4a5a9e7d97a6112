#include <gtest/gtest.h>

#include <map>
#include <numeric>
#include <set>

#include "examples/objects.h"
#include "examples/transforms.h"
#include "shape/find_parts.h"

namespace partonomy {
namespace {

/// Share of the area that is not in the region which holds most of its part.
double misplaced(const ExampleObject& object, const std::vector<PartRegion>& regions) {
    const std::vector<double> areas = compute_geometry(object.mesh).areas;
    const double all = std::accumulate(areas.begin(), areas.end(), 0.0);
    double right = 0;
    std::set<int> parts;
    for (const PartRegion& region : regions) {
        std::map<int, double> votes;
        for (const std::int32_t t : region.region.triangles)
            votes[object.parts[static_cast<std::size_t>(t)]] += areas[static_cast<std::size_t>(t)];
        const auto best = std::max_element(votes.begin(), votes.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        right += best->second;
        EXPECT_TRUE(parts.insert(best->first).second) << object.name << ": two regions for one part";
    }
    return 1 - right / all;
}

TEST(PaperObjects, EveryTriangleIsInItsPart) {
    for (const ExampleObject& object : paper_objects()) {
        const ExampleObject variants[] = {object,
                                          rotated_about_z(object, 37),
                                          translated(object, Vec3(3, -2, 1)),
                                          with_permuted_faces(object, 7),
                                          scaled(object, 100),
                                          mirrored(object)};
        for (const ExampleObject& variant : variants) {
            const std::vector<PartRegion> regions = find_parts(variant.mesh);
            EXPECT_EQ(regions.size(), static_cast<std::size_t>(object.part_count)) << object.name;
            EXPECT_LT(misplaced(variant, regions), 1e-9) << object.name;
        }
    }
}

TEST(PaperObjects, SubdividedTheyHaveTheSameParts) {
    // The labels follow the large triangles; where those lie aslant to a border, some of the small ones are across it.
    for (const ExampleObject& object : paper_objects()) {
        const ExampleObject fine = subdivided(object);
        const std::vector<PartRegion> regions = find_parts(fine.mesh);
        EXPECT_EQ(regions.size(), static_cast<std::size_t>(object.part_count)) << object.name;
        EXPECT_LT(misplaced(fine, regions), 0.03) << object.name;
    }
}

}  // namespace
}  // namespace partonomy
