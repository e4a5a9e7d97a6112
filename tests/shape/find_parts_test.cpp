#include "shape/find_parts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "shape/shapes.h"

namespace partonomy {
namespace {

using shapes::Block;
using shapes::Labelled;

char shape_of(const OrientedBox& box) {
    const double a = box.lengths[0] / box.lengths[1], b = box.lengths[1] / box.lengths[2];
    return b > 2 ? 'B' : a > 2 ? 'S' : 'C';
}

std::vector<int> found(const TriangleMesh& mesh, const std::vector<PartRegion>& parts) {
    std::vector<int> of(mesh.triangles.size(), -1);
    for (std::size_t k = 0; k < parts.size(); ++k)
        for (const std::int32_t t : parts[k].region.triangles) {
            EXPECT_EQ(of[static_cast<std::size_t>(t)], -1) << "a triangle in two regions";
            of[static_cast<std::size_t>(t)] = static_cast<int>(k);
        }
    return of;
}

/// The share of triangles that are in the region which holds most of their true part.
double accuracy(const Labelled& object, const std::vector<PartRegion>& parts) {
    std::size_t good = 0;
    for (const PartRegion& part : parts) {
        std::map<int, std::size_t> votes;
        for (const std::int32_t t : part.region.triangles) ++votes[object.parts[static_cast<std::size_t>(t)]];
        std::size_t best = 0;
        for (const auto& [number, count] : votes) best = std::max(best, count);
        good += best;
    }
    return static_cast<double>(good) / static_cast<double>(object.mesh.triangles.size());
}

void expect_regions_are_sound(const TriangleMesh& mesh, const std::vector<PartRegion>& parts) {
    const Adjacency adjacency = build_adjacency(mesh);
    const std::vector<int> of = found(mesh, parts);
    std::int32_t lowest = -1;
    for (const PartRegion& part : parts) {
        const auto& triangles = part.region.triangles;
        ASSERT_FALSE(triangles.empty());
        EXPECT_TRUE(std::is_sorted(triangles.begin(), triangles.end()));
        ASSERT_EQ(triangles.size(), part.region.memberships.size());
        const TriangleGeometry geometry = compute_geometry(mesh);
        double belonging = 0, area = 0;
        for (std::size_t k = 0; k < triangles.size(); ++k) {
            EXPECT_GT(part.region.memberships[k], 0);
            EXPECT_LE(part.region.memberships[k], 1);
            area += geometry.areas[static_cast<std::size_t>(triangles[k])];
            belonging += geometry.areas[static_cast<std::size_t>(triangles[k])] * part.region.memberships[k];
        }
        EXPECT_NEAR(part.fit, belonging / area, 0.02);  // areas differ where noise was taken out
        EXPECT_GT(triangles.front(), lowest);
        lowest = triangles.front();
        EXPECT_GE(part.fit, 0);
        EXPECT_LE(part.fit, 1);
        std::set<std::int32_t> reached{triangles.front()};
        std::vector<std::int32_t> queue{triangles.front()};
        while (!queue.empty()) {
            const std::int32_t t = queue.back();
            queue.pop_back();
            for (const std::int32_t n : adjacency.neighbours[static_cast<std::size_t>(t)])
                if (n >= 0 && of[static_cast<std::size_t>(n)] == of[static_cast<std::size_t>(t)] &&
                    reached.insert(n).second)
                    queue.push_back(n);
        }
        EXPECT_EQ(reached.size(), triangles.size()) << "a region in two pieces";
    }
}

Labelled table(double step) {
    std::vector<Block> parts{{Vec3(0, 0, 0.7), Vec3(1.2, 0.8, 0.74), 0}};
    int number = 1;
    for (const double x : {0.1, 1.04})
        for (const double y : {0.1, 0.64}) parts.push_back({Vec3(x, y, 0), Vec3(x + 0.06, y + 0.06, 0.7), number++});
    return shapes::join(parts, step);
}

TEST(FindParts, OneBoxIsOnePart) {
    for (const auto& [sides, shape] :
         {std::pair(Vec3(1, 0.6, 0.05), 'B'), std::pair(Vec3(1, 0.1, 0.1), 'S'), std::pair(Vec3(1, 1, 1), 'C')})
        for (const double step : {10.0, 0.05}) {
            const Labelled box = shapes::join({{Vec3(0, 0, 0), sides, 0}}, step);
            const std::vector<PartRegion> parts = find_parts(box.mesh);
            ASSERT_EQ(parts.size(), 1U) << shape << step;
            EXPECT_EQ(parts[0].region.triangles.size(), box.mesh.triangles.size());
            EXPECT_EQ(shape_of(parts[0].box), shape);
            for (int k = 0; k < 3; ++k) EXPECT_NEAR(parts[0].box.lengths[k], sides[k], 1e-6);
            EXPECT_NEAR(parts[0].fit, 1, 1e-9);
        }
}

TEST(FindParts, ARoundStickIsOneStick) {
    const std::vector<PartRegion> parts = find_parts(shapes::cylinder(0.05, 1, 24, 40));
    ASSERT_EQ(parts.size(), 1U);
    EXPECT_EQ(shape_of(parts[0].box), 'S');
    EXPECT_GT(parts[0].fit, 0.7);
}

TEST(FindParts, TwoBoardsAtARightAngle) {
    for (const double step : {10.0, 0.03}) {
        const Labelled object =
            shapes::join({{Vec3(0, 0, 0), Vec3(0.6, 0.5, 0.04), 0}, {Vec3(0, 0, 0.04), Vec3(0.04, 0.5, 0.6), 1}}, step);
        const std::vector<PartRegion> parts = find_parts(object.mesh);
        ASSERT_EQ(parts.size(), 2U) << step;
        EXPECT_EQ(accuracy(object, parts), 1) << step;
        for (const PartRegion& part : parts) EXPECT_EQ(shape_of(part.box), 'B');
    }
}

TEST(FindParts, ABoardThatCarriesAnotherInItsMiddleIsOneBoard) {
    for (const double step : {10.0, 0.02}) {
        const Labelled object =
            shapes::join({{Vec3(0, 0, 0), Vec3(1, 0.6, 0.1), 0}, {Vec3(0.45, 0, 0.1), Vec3(0.55, 0.6, 0.8), 1}}, step);
        const std::vector<PartRegion> parts = find_parts(object.mesh);
        EXPECT_EQ(parts.size(), 2U) << step;
        EXPECT_EQ(accuracy(object, parts), 1) << step;
    }
}

TEST(FindParts, ATableIsATopAndFourLegs) {
    for (const double step : {10.0, 0.04, 0.015}) {
        const Labelled object = table(step);
        const std::vector<PartRegion> parts = find_parts(object.mesh);
        ASSERT_EQ(parts.size(), 5U) << step;
        EXPECT_EQ(accuracy(object, parts), 1) << step;
        EXPECT_EQ(std::count_if(parts.begin(), parts.end(), [](const auto& p) { return shape_of(p.box) == 'S'; }), 4);
        expect_regions_are_sound(object.mesh, parts);
    }
}

TEST(FindParts, LegsFlushWithTheSeatEndAtItsLowerSide) {
    for (const double step : {10.0, 0.02}) {
        std::vector<Block> blocks{{Vec3(0, 0, 0.4), Vec3(0.5, 0.5, 0.44), 0},
                                  {Vec3(0, 0.46, 0.44), Vec3(0.5, 0.5, 0.9), 5}};
        int number = 1;
        for (const double x : {0.0, 0.46})
            for (const double y : {0.0, 0.46})
                blocks.push_back({Vec3(x, y, 0), Vec3(x + 0.04, y + 0.04, 0.4), number++});
        const Labelled object = shapes::join(blocks, step);
        const std::vector<PartRegion> parts = find_parts(object.mesh);
        EXPECT_EQ(parts.size(), 6U) << step;
        EXPECT_EQ(accuracy(object, parts), 1) << step;
    }
}

TEST(FindParts, DoesNotDependOnTurnPlaceSizeOrFaceOrder) {
    const Labelled object = table(0.04);
    constexpr unsigned seed = 9;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    std::vector<std::size_t> order(object.mesh.triangles.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    for (int round = 0; round < 3; ++round) {
        Labelled other = object;
        std::shuffle(order.begin(), order.end(), random);
        for (std::size_t t = 0; t < order.size(); ++t) {
            other.mesh.triangles[t] = object.mesh.triangles[order[t]];
            other.parts[t] = object.parts[order[t]];
        }
        const Eigen::Quaterniond by = shapes::random_turn(random);
        for (Vec3& point : other.mesh.positions) point = by * (37.0 * point) + Vec3(100, -20, 3);
        const std::vector<PartRegion> parts = find_parts(other.mesh, {by * Vec3::UnitZ(), 1});
        EXPECT_EQ(parts.size(), 5U);
        EXPECT_EQ(accuracy(other, parts), 1);
    }
}

TEST(FindParts, IsTheSameOnAnyNumberOfThreads) {
    const Labelled object = table(0.015);
    const std::vector<PartRegion> one = find_parts(object.mesh, {Vec3::UnitZ(), 1});
    const std::vector<PartRegion> two = find_parts(object.mesh, {Vec3::UnitZ(), 2});
    ASSERT_EQ(one.size(), two.size());
    for (std::size_t k = 0; k < one.size(); ++k) {
        EXPECT_EQ(one[k].region.triangles, two[k].region.triangles);
        EXPECT_EQ(one[k].box.lengths, two[k].box.lengths);
        EXPECT_EQ(one[k].fit, two[k].fit);
    }
}

TEST(FindParts, SmallNoiseChangesLittle) {
    constexpr unsigned seed = 4;
    SCOPED_TRACE(seed);
    std::mt19937 random(seed);
    Labelled object = table(0.015);
    std::normal_distribution<double> normal(0, 0.0005);
    for (Vec3& point : object.mesh.positions) point += Vec3(normal(random), normal(random), normal(random));
    const std::vector<PartRegion> parts = find_parts(object.mesh);
    EXPECT_EQ(parts.size(), 5U);
    EXPECT_GT(accuracy(object, parts), 0.99);
    expect_regions_are_sound(object.mesh, parts);
}

TEST(FindParts, OddInputIsNoTrouble) {
    EXPECT_TRUE(find_parts(TriangleMesh{}).empty());
    TriangleMesh sheet;
    sheet.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 1, 0), Vec3(0, 1, 0)};
    sheet.triangles = {{0, 1, 2}, {0, 2, 3}};
    sheet.input_faces = {0, 1};
    sheet.input_face_count = 2;
    EXPECT_LE(find_parts(sheet).size(), 1U);
    // Two boxes that do not touch.
    Labelled apart = shapes::join({{Vec3(0, 0, 0), Vec3(1, 0.5, 0.05), 0}, {Vec3(0, 0, 1), Vec3(1, 0.5, 1.05), 1}}, 10);
    EXPECT_EQ(find_parts(apart.mesh).size(), 2U);
}

}  // namespace
}  // namespace partonomy
