#include <gtest/gtest.h>

#include <map>
#include <set>

#include "examples/objects.h"
#include "examples/transforms.h"
#include "shape/find_parts.h"

namespace partonomy {
namespace {

/// Triangles that are not in the region which holds most of their part.
std::size_t misplaced(const ExampleObject& object, const std::vector<PartRegion>& regions) {
    std::size_t wrong = object.mesh.triangles.size();
    std::set<int> parts;
    for (const PartRegion& region : regions) {
        std::map<int, std::size_t> votes;
        for (const std::int32_t t : region.region.triangles) ++votes[object.parts[static_cast<std::size_t>(t)]];
        const auto best = std::max_element(votes.begin(), votes.end(),
                                           [](const auto& a, const auto& b) { return a.second < b.second; });
        wrong -= best->second;
        EXPECT_TRUE(parts.insert(best->first).second) << object.name << ": two regions for one part";
    }
    return wrong;
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
            EXPECT_EQ(misplaced(variant, regions), 0U) << object.name;
        }
    }
}

TEST(PaperObjects, SubdividedTheyHaveTheSameParts) {
    // The labels follow the large triangles; where those lie aslant to a border, some of the small ones are across it.
    for (const ExampleObject& object : paper_objects()) {
        const ExampleObject fine = subdivided(object);
        const std::vector<PartRegion> regions = find_parts(fine.mesh);
        EXPECT_EQ(regions.size(), static_cast<std::size_t>(object.part_count)) << object.name;
        EXPECT_LE(misplaced(fine, regions), fine.mesh.triangles.size() / 20) << object.name;
    }
}

}  // namespace
}  // namespace partonomy
