#include "algorithms/mirror_plane.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "solids.h"

using namespace partonomy;
using solids::block;
using solids::Block;
using solids::Stage;

namespace {

/// A fuselage along x, wings and tail planes swept back; the smallest rectangle around it lies along neither.
/// `left`: length of the left wing, over the right one's.
std::vector<Block> aeroplane(double sweep, double left = 1) {
    std::vector<Block> blocks{block(Vec3(-5, -0.5, 0), Vec3(5, 0.5, 1)), block(Vec3(-5, -0.1, 1), Vec3(-4, 0.1, 3))};
    for (const double side : {-1.0, 1.0})
        for (const auto& [root, length, width] : {std::array{1.0, 5.0, 1.6}, std::array{-4.2, 1.8, 0.8}}) {
            const double half = (side > 0 && root > 0 ? left : 1) * length / 2;
            const Eigen::AngleAxisd turn(side * sweep * std::numbers::pi / 180, Vec3::UnitZ());
            const Vec3 middle = Vec3(root, 0, 0.5) + turn * Vec3(0, side * half, 0);
            blocks.push_back({middle, Vec3(width / 2, half, 0.1), turn.toRotationMatrix()});
        }
    return blocks;
}

double degrees_off(const Eigen::Matrix3d& frame, const Vec3& side) {
    const double cosine =
        std::max(std::abs(frame.row(0).dot(side.transpose())), std::abs(frame.row(1).dot(side.transpose())));
    return std::acos(std::min(1.0, cosine)) * 180 / std::numbers::pi;
}

}  // namespace

TEST(MirrorPlane, IsASideOfTheFrameHoweverWingsAreSwept) {
    double most = 0;
    for (unsigned seed = 0; seed < 12; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const double sweep = std::uniform_real_distribution<double>(15, 45)(random);
        Stage stage(aeroplane(sweep), 12);
        const solids::Motion motion = solids::random_motion(random, seed % 2 == 0 ? 0 : 0.005);
        stage.move(motion, random);
        stage.finish();
        const Vec3 side = Eigen::AngleAxisd(motion.degrees * std::numbers::pi / 180, Vec3::UnitZ()) * Vec3::UnitY();
        EXPECT_LT(degrees_off(stage.scene.frame, side), 1);
        EXPECT_LT(mirror_asymmetry(stage.object, side), mirror_tolerance);
        for (const double away : {10.0, 30.0, 45.0}) {
            const Vec3 askew = Eigen::AngleAxisd(away * std::numbers::pi / 180, Vec3::UnitZ()) * side;
            most = std::max(most, mirror_asymmetry(stage.object, askew));
            EXPECT_GT(mirror_asymmetry(stage.object, askew), 2 * mirror_tolerance);
        }
    }
    EXPECT_GT(most, 0.3);
}

TEST(MirrorPlane, IsNotThereWithOneShortWing) {
    for (const double left : {0.4, 0.7}) {
        Stage stage(aeroplane(30, left), 6);
        stage.finish();
        EXPECT_FALSE(mirror_side(stage.object)) << left;
    }
}

TEST(MirrorPlane, LeavesTheSidesOfASquareTable) {
    std::vector<Block> blocks{block(Vec3(-1, -1, 1), Vec3(1, 1, 1.1))};
    for (const double x : {-0.9, 0.9})
        for (const double y : {-0.9, 0.9})
            blocks.push_back(block(Vec3(x - 0.1, y - 0.1, 0), Vec3(x + 0.1, y + 0.1, 1)));
    std::mt19937 random(7);
    Stage stage(blocks);
    stage.move({27, 1, 0, Vec3::Zero()}, random);
    stage.finish();
    const Eigen::AngleAxisd turn(27 * std::numbers::pi / 180, Vec3::UnitZ());
    EXPECT_LT(degrees_off(stage.scene.frame, turn * Vec3::UnitX()), 1e-6);
}

TEST(MirrorPlane, SumsDoNotHangOnTheTriangles) {
    Stage coarse(aeroplane(30, 0.5)), fine(aeroplane(30, 0.5), 40);
    coarse.finish();
    fine.finish();
    for (const double degrees : {0.0, 20.0, 75.0}) {
        const Vec3 side = Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vec3::UnitZ()) * Vec3::UnitX();
        EXPECT_NEAR(mirror_asymmetry(coarse.object, side), mirror_asymmetry(fine.object, side), 1e-3) << degrees;
    }
}
