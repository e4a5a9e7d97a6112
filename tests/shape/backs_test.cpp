// Backs of chairs: what is in one plane and as thick as its neighbours is told apart by how wide it is.

#include <gtest/gtest.h>

#include <map>

#include "shape/find_parts.h"
#include "shape/shapes.h"

namespace partonomy {
namespace {

using shapes::Block;

/// Share of the triangles that lie in the one region that holds most of their part, when each part has such a region of
/// its own; else 0.
double agreement(const shapes::Labelled& back) {
    std::map<int, std::pair<std::size_t, std::size_t>> best;  // of a part: triangles in its region, which region
    std::size_t right = 0;
    const std::vector<PartRegion> regions = find_parts(back.mesh);
    for (std::size_t r = 0; r < regions.size(); ++r) {
        std::map<int, std::size_t> counts;
        for (const std::int32_t t : regions[r].region.triangles) ++counts[back.parts[static_cast<std::size_t>(t)]];
        for (const auto& [part, count] : counts)
            if (count > best[part].first) best[part] = {count, r};
    }
    std::map<std::size_t, int> owners;
    for (const auto& [part, region] : best) {
        right += region.first;
        if (!owners.emplace(region.second, part).second) return 0;
    }
    return static_cast<double>(right) / static_cast<double>(back.parts.size());
}

double between(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution(low, high)(random);
}

/// Leans the back by some degrees.
void lean(shapes::Labelled& back, std::mt19937& random) {
    const double slope = std::tan(between(random, 0, 0.25));
    for (Vec3& point : back.mesh.positions) point.y() += slope * point.z();
}

TEST(Backs, SlatsComeOffTheRailThatTheyCarry) {
    std::mt19937 random(51);
    for (int round = 0; round < 20; ++round) {
        SCOPED_TRACE("seed 51, round " + std::to_string(round));
        const int slats = 2 + round % 3;
        const double thickness = between(random, 0.015, 0.03), height = between(random, 0.35, 0.5);
        const double width = between(random, 2.4, 3) * thickness, rail = between(random, 1.8, 3) * width;
        const double gap = between(random, 1, 1.5) * width;
        std::vector<Block> blocks;
        for (int i = 0; i < slats; ++i) {
            const double left = gap + i * (width + gap);
            blocks.push_back({{left, 0, 0}, {left + width, thickness, height}, i + 1});
        }
        blocks.push_back({{0, 0, height}, {gap + slats * (width + gap), thickness, height + rail}, 0});
        shapes::Labelled back = shapes::join(blocks, 0.008);
        lean(back, random);
        EXPECT_GT(agreement(back), 0.95);
    }
}

TEST(Backs, PostsBesideARailKeepTheirLength) {
    std::mt19937 random(52);
    for (int round = 0; round < 20; ++round) {
        SCOPED_TRACE("seed 52, round " + std::to_string(round));
        const double post = between(random, 0.03, 0.05), width = between(random, 0.3, 0.4),
                     height = between(random, 0.4, 0.6);
        const double thickness = between(random, 0.5, 0.8) * post, front = between(random, 0, 1) * (post - thickness);
        const double rail = between(random, 0.08, 0.12);
        std::vector<Block> blocks{{{0, 0, 0}, {post, post, height}, 0},
                                  {{post + width, 0, 0}, {2 * post + width, post, height}, 1}};
        const int rails = 1 + round % 3;
        for (int i = 0; i < rails; ++i) {
            const double top = height - 0.02 - i * 1.4 * rail;
            blocks.push_back({{post, front, top - rail}, {post + width, front + thickness, top}, 2 + i});
        }
        shapes::Labelled back = shapes::join(blocks, 0.008);
        lean(back, random);
        EXPECT_GT(agreement(back), 0.97);
    }
}

}  // namespace
}  // namespace partonomy
