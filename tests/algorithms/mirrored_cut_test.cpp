#include "algorithms/mirrored_cut.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <map>

#include "shape/level_set.h"
#include "shape/part_box.h"

using namespace partonomy;

namespace {

/// A ball with a bent arm on each side; the hook of the left one may be missing.
Object figure(bool has_left_hook = true) {
    const auto inside = [&](const Vec3& p) {
        double distance = p.norm() - 0.6;
        for (const double side : {-1.0, 1.0}) {
            const Vec3 elbow(2 * side, 0.3, 0);
            distance = std::min(distance, solids::from_line(p, Vec3(0.4 * side, 0, 0), elbow) - 0.16);
            if (side > 0 || has_left_hook)
                distance = std::min(distance, solids::from_line(p, elbow, Vec3(2.3 * side, 0.4, -0.9)) - 0.16);
        }
        return distance;
    };
    // The lattice is no mirror image of itself.
    return make_object(solids::level_set(inside, Vec3(-2.61, -0.7, -1.2), Vec3(2.6, 0.7, 0.7), 0.06), {});
}

using Cut = std::function<int(const Vec3&)>;

void cut_by_hand(Object& object, const Cut& part_of) {
    std::map<int, std::vector<std::int32_t>> parts;
    for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t)
        parts[part_of(object.geometry.barycentres[t])].push_back(static_cast<std::int32_t>(t));
    object.candidates.clear();
    for (auto& [number, triangles] : parts) {
        PartBox box = measure_part(object.mesh, object.geometry, triangles, false);
        object.candidates.push_back({{triangles, std::move(box.memberships)}, box.box, box.fit});
    }
}

/// Areas of the parts on one side of the mirror plane, ascending.
std::vector<double> areas_beside(const Object& object, double side) {
    std::vector<double> areas;
    for (const PartRegion& part : object.candidates) {
        if (side * part.box.centre.x() < 0.5) continue;
        areas.push_back(0);
        for (const std::int32_t t : part.region.triangles)
            areas.back() += object.geometry.areas[static_cast<std::size_t>(t)];
    }
    std::ranges::sort(areas);
    return areas;
}

bool is_arm(const Vec3& p) { return std::abs(p.x()) > 0.65; }
bool is_hook(const Vec3& p) { return is_arm(p) && p.z() < -0.2; }

}  // namespace

TEST(MirroredCut, BothSidesGetTheFinerCut) {
    for (const double side : {-1.0, 1.0}) {
        Object object = figure();
        cut_by_hand(object, [&](const Vec3& p) {
            if (!is_arm(p)) return 0;
            if (p.x() * side < 0) return 1;
            return is_hook(p) ? 2 : 3;
        });
        cut_both_sides_alike(object);
        const std::vector<double> left = areas_beside(object, -1), right = areas_beside(object, 1);
        ASSERT_EQ(object.candidates.size(), 5U);
        ASSERT_EQ(left.size(), 2U);
        ASSERT_EQ(right.size(), 2U);
        for (const int k : {0, 1}) EXPECT_NEAR(left[k], right[k], 0.03 * right[k]);
        std::vector<int> seen(object.mesh.triangles.size(), 0);  // every triangle is still in one part
        for (const PartRegion& part : object.candidates)
            for (const std::int32_t t : part.region.triangles) ++seen[static_cast<std::size_t>(t)];
        EXPECT_EQ(std::ranges::count(seen, 1), static_cast<std::ptrdiff_t>(seen.size()));
    }
}

TEST(MirroredCut, BordersAtDifferentPlacesBecomeOne) {
    Object object = figure();
    cut_by_hand(object, [&](const Vec3& p) {
        if (!is_arm(p)) return 0;
        const bool is_outer = is_hook(p) || (p.x() < -1.4);
        return (p.x() < 0 ? 1 : 3) + (is_outer ? 1 : 0);
    });
    cut_both_sides_alike(object);
    const std::vector<double> left = areas_beside(object, -1), right = areas_beside(object, 1);
    ASSERT_EQ(left.size(), 2U);
    ASSERT_EQ(right.size(), 2U);
    for (const int k : {0, 1}) EXPECT_NEAR(left[k], right[k], 0.03 * right[k]);
}

TEST(MirroredCut, WhatIsAlikeOrNoMirrorImageStays) {
    Object alike = figure();
    cut_by_hand(alike, [](const Vec3& p) { return !is_arm(p) ? 0 : (p.x() < 0 ? 1 : 3) + (is_hook(p) ? 1 : 0); });
    const auto before = alike.candidates;
    cut_both_sides_alike(alike);
    ASSERT_EQ(alike.candidates.size(), before.size());
    for (std::size_t k = 0; k < before.size(); ++k)
        EXPECT_EQ(alike.candidates[k].region.triangles, before[k].region.triangles);

    Object lame = figure(false);
    cut_by_hand(lame, [](const Vec3& p) { return !is_arm(p) ? 0 : p.x() < 0 ? 1 : is_hook(p) ? 2 : 3; });
    cut_both_sides_alike(lame);
    EXPECT_EQ(lame.candidates.size(), 4U);
}

TEST(MirroredCut, IsTheSameOnAnyNumberOfThreads) {
    std::vector<std::vector<std::int32_t>> one;
    for (const int threads : {1, 3}) {
        Object object = figure();
        cut_by_hand(object, [](const Vec3& p) { return !is_arm(p) ? 0 : p.x() < 0 ? 1 : is_hook(p) ? 2 : 3; });
        cut_both_sides_alike(object, threads);
        std::vector<std::vector<std::int32_t>> parts;
        for (const PartRegion& part : object.candidates) parts.push_back(part.region.triangles);
        if (threads == 1) one = parts;
        EXPECT_EQ(parts, one);
    }
}
