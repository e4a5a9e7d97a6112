/* A shelf of two boards, one above the other, and what is above and below them. */

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <random>

#include "algorithms/measures.h"

namespace partonomy {
namespace {

void add_box(TriangleMesh& mesh, const Vec3& low, const Vec3& high) {
    const auto first = static_cast<std::int32_t>(mesh.positions.size());
    for (int i = 0; i < 8; ++i)
        mesh.positions.emplace_back((i & 1) ? high.x() : low.x(), (i & 2) ? high.y() : low.y(),
                                    (i & 4) ? high.z() : low.z());
    for (const auto& [a, b, c] : std::initializer_list<std::array<std::int32_t, 3>>{{0, 2, 3},
                                                                                    {0, 3, 1},
                                                                                    {4, 5, 7},
                                                                                    {4, 7, 6},
                                                                                    {0, 1, 5},
                                                                                    {0, 5, 4},
                                                                                    {2, 6, 7},
                                                                                    {2, 7, 3},
                                                                                    {0, 4, 6},
                                                                                    {0, 6, 2},
                                                                                    {1, 3, 7},
                                                                                    {1, 7, 5}})
        mesh.triangles.push_back({first + a, first + b, first + c});
}

TEST(Surroundings, OfTwoBoards) {
    TriangleMesh mesh;
    add_box(mesh, {0, 0, 0.5}, {2, 1, 0.55});   // the lower one
    add_box(mesh, {0, 0, 0.95}, {2, 1, 1.0});   // the upper one, as large
    add_box(mesh, {2, 0, 0}, {2.1, 0.1, 0.2});  // what makes the ground lower
    mesh.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    for (std::int32_t t = 0; t < mesh.input_face_count; ++t) mesh.input_faces.push_back(t);
    const Object object = make_object(mesh, {});
    EXPECT_NEAR(object.footprint, 2 * 1 + 0.1 * 0.1 + 0.5 * 0.1 * 0.9, 1e-9);
    int boards = 0;
    for (const PartRegion& part : object.candidates) {
        const RegionMeasurements region = measure_region(object, part);
        if (region.plan_area < 1) continue;
        ++boards;
        EXPECT_NEAR(region.plan_area, 2, 1e-9);
        EXPECT_FALSE(region.surroundings.has_value());
        const Surroundings& around = look_around(object, region);
        const bool is_upper = region.high > 0.9;
        EXPECT_EQ(around.open_above, is_upper ? 1 : 0);
        EXPECT_EQ(around.room_above, 1);  // 0.4 m, more than a tenth of the height
        EXPECT_NEAR(around.room_below, is_upper ? 0.5 / 1.0 : 0.5 / 0.55, 1e-4);
        EXPECT_NEAR(find_measure("extent")->value(object, region), 0.05, 1e-9);
        EXPECT_NEAR(find_measure("footprint share")->value(object, region), 2 / object.footprint, 1e-9);
    }
    EXPECT_EQ(boards, 2);
}

/// A long stick with a block on its end, as it stands and turned in any way.
TEST(Surroundings, SharesOfTheObjectAreTheSameHoweverItLies) {
    TriangleMesh mesh;
    add_box(mesh, {0, 0, 0}, {0.1, 0.1, 2});
    add_box(mesh, {-0.2, -0.1, 2.01}, {0.3, 0.2, 2.31});
    mesh.positions.push_back({90, 90, 90});  // an unused vertex is no part of the object
    mesh.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    for (std::int32_t t = 0; t < mesh.input_face_count; ++t) mesh.input_faces.push_back(t);
    const double stick = 2 * 0.01 + 4 * 0.2, block = 2 * (0.5 * 0.3 + 0.5 * 0.3 + 0.3 * 0.3), whole = stick + block;
    double length = 0;  // of the whole, turned or not
    std::mt19937 random(3);
    std::normal_distribution<double> normal;
    for (int round = 0; round < 4; ++round) {
        SCOPED_TRACE("seed 3, round " + std::to_string(round));
        const Object object = make_object(mesh, {});
        ASSERT_EQ(object.candidates.size(), 2U);
        for (const PartRegion& part : object.candidates) {
            const RegionMeasurements region = measure_region(object, part);
            const bool is_stick = region.lengths[0] > 1;
            EXPECT_NEAR(find_measure("area share")->value(object, region), (is_stick ? stick : block) / whole, 1e-6);
            const double share = find_measure("length share")->value(object, region);
            if (length == 0) length = region.lengths[0] / share;
            EXPECT_NEAR(share, region.lengths[0] / length, 1e-6);
            EXPECT_NEAR(share, is_stick ? 2 / 2.31 : 0.5 / 2.31, 0.02);
        }
        const Eigen::Quaterniond turn =
            Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random)).normalized();
        for (Vec3& point : mesh.positions) point = turn * point;
    }
}

/// A seat with a back of two posts and a rail, and armrests, turned about up: which way its parts run.
TEST(Surroundings, WhatHasABackHasSides) {
    std::mt19937 random(4);
    for (int round = 0; round < 4; ++round) {
        SCOPED_TRACE("seed 4, round " + std::to_string(round));
        TriangleMesh mesh;
        add_box(mesh, {-0.2, -0.2, 0}, {0.2, 0.2, 0.4});
        if (round < 3) {
            add_box(mesh, {-0.2, 0.15, 0.41}, {-0.15, 0.2, 0.9});
            add_box(mesh, {0.15, 0.15, 0.41}, {0.2, 0.2, 0.9});
            add_box(mesh, {-0.14, 0.16, 0.6}, {0.14, 0.18, 0.65});
            for (const double x : {-0.25, 0.21}) add_box(mesh, {x, -0.1, 0.55}, {x + 0.04, 0.2, 0.57});
        }
        mesh.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
        for (std::int32_t t = 0; t < mesh.input_face_count; ++t) mesh.input_faces.push_back(t);
        const double angle = std::uniform_real_distribution(0.0, 6.3)(random);
        for (Vec3& point : mesh.positions) point = Eigen::AngleAxisd(angle, Vec3::UnitZ()) * point;
        const Object object = make_object(mesh, {});
        ASSERT_EQ(object.candidates.size(), round < 3 ? 6U : 1U);
        for (const PartRegion& part : object.candidates) {
            const RegionMeasurements region = measure_region(object, part);
            const double crosswise = find_measure("crosswise angle")->value(object, region);
            const double incline = find_measure("length inclination")->value(object, region);
            const bool is_block = region.low<0.1, is_post = region.high> 0.8 && !is_block;
            const bool is_rail = region.low > 0.59;  // a block has no back
            if (!is_block || round == 3) {
                EXPECT_NEAR(crosswise, is_rail ? 90 : 0, 1);
            }
            EXPECT_NEAR(incline, is_post ? 90 : is_block ? incline : 0, 0.1);
        }
    }
}

}  // namespace
}  // namespace partonomy
