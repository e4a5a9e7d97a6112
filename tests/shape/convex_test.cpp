// Solids without a dent are one part, whatever their proportions, and so are those of which larger things are made; and
// sticks that meet, in line or across.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include "shape/find_parts.h"
#include "shape/shapes.h"
#include "shape/solids.h"

namespace partonomy {
namespace {

/// How many parts the surface has as it stands and turned at random.
void expect_parts(std::size_t count, TriangleMesh mesh, std::mt19937& random) {
    EXPECT_EQ(find_parts(mesh).size(), count) << "upright";
    shapes::turn(mesh, shapes::random_turn(random));
    EXPECT_EQ(find_parts(mesh).size(), count) << "turned";
}

class Solids : public testing::TestWithParam<int> {};  // sides

TEST_P(Solids, WithoutADentAreOnePart) {
    std::mt19937 random(31);
    for (const double top : {1.0, 0.7, 0.4})
        for (double height = 0.1; height < 6; height *= 1.25) {
            SCOPED_TRACE("seed 31, top " + std::to_string(top) + ", height " + std::to_string(height));
            expect_parts(1, solids::revolve({{0, 0}, {0.5, 0}, {0.5 * top, height}, {0, height}}, GetParam(), true),
                         random);
        }
}

TEST_P(Solids, OnABarAreAPartEach) {
    std::mt19937 random(32);
    for (const double bar : {0.1, 0.17, 0.25})
        for (double weight = 0.3; weight < 1.5; weight *= 1.3) {
            SCOPED_TRACE("seed 32, bar " + std::to_string(bar) + ", weight " + std::to_string(weight));
            const double end = 2 + weight;
            solids::Outline mallet{{0, 0}, {bar, 0}, {bar, 2}, {0.5, 2}, {0.5, end}, {0, end}}, dumbbell = mallet;
            dumbbell.insert(dumbbell.begin() + 1, {{0.5, 0}, {0.5, weight}});
            dumbbell[3].y() = weight;
            expect_parts(2, solids::revolve(mallet, GetParam(), true), random);
            expect_parts(3, solids::revolve(dumbbell, GetParam(), true), random);
        }
}

/// A round grip, narrower towards its end, that passes into a shaft by a fillet; finely meshed, as scans are.
TriangleMesh screwdriver(double grip, double shaft, double length) {
    const double end = 0.7 * grip, fillet = 0.3 * shaft;
    solids::Outline corners{{0, 0}, {grip, 0}, {grip, 5 * grip}, {end, 6 * grip}};
    for (double turn = 0; turn <= 90; turn += 30)
        corners.emplace_back(shaft + fillet * (1 - std::sin(turn * std::numbers::pi / 180)),
                             6 * grip + fillet * (1 - std::cos(turn * std::numbers::pi / 180)));
    corners.insert(corners.end(), {{shaft, 6 * grip + length}, {0, 6 * grip + length}});
    return solids::revolve(solids::profile(corners, 0.25 * shaft), 48, true);
}

TEST(Sticks, AreTwoWhereOneEndsWithAShoulderAndOneWhereTheyTaper) {
    const unsigned seed = std::random_device()();
    std::mt19937 random(seed);
    for (int i = 0; i < 6; ++i) {
        const double grip = std::uniform_real_distribution(3.5, 5.0)(random);
        const double length = std::uniform_real_distribution(20.0, 40.0)(random);
        SCOPED_TRACE("seed " + std::to_string(seed) + ", grip " + std::to_string(grip) + ", length " +
                     std::to_string(length));
        TriangleMesh driver = screwdriver(grip, 1, length);
        shapes::turn(driver, shapes::random_turn(random));
        EXPECT_EQ(find_parts(driver).size(), 2U);
        const solids::Outline cone =
            solids::profile({{0, 0}, {grip, 0}, {1, 6 * grip}, {1, 6 * grip + length}, {0, 6 * grip + length}}, 0.25);
        TriangleMesh taper = solids::revolve(cone, 48, true);
        shapes::turn(taper, shapes::random_turn(random));
        EXPECT_EQ(find_parts(taper).size(), 1U);
    }
}

/// Each vertex becomes the mean of its neighbours, some times over: edges are rounded, corners filled.
void round_off(TriangleMesh& mesh, int times) {
    for (int time = 0; time < times; ++time) {
        std::vector<Vec3> sums(mesh.positions.size(), Vec3::Zero());
        std::vector<double> counts(mesh.positions.size(), 0);
        for (const auto& t : mesh.triangles)
            for (std::size_t k = 0; k < 3; ++k) {
                const auto v = static_cast<std::size_t>(t[k]);
                sums[v] += mesh.positions[static_cast<std::size_t>(t[(k + 1) % 3])] +
                           mesh.positions[static_cast<std::size_t>(t[(k + 2) % 3])];
                counts[v] += 2;
            }
        for (std::size_t v = 0; v < sums.size(); ++v) mesh.positions[v] = sums[v] / counts[v];
    }
}

TEST(Sticks, AcrossTheEndOfAnotherOneAreAPartOfTheirOwn) {
    const unsigned seed = std::random_device()();
    std::mt19937 random(seed);
    for (int i = 0; i < 6; ++i) {
        const double handle = std::uniform_real_distribution(8.0, 14.0)(random);
        const double head = std::uniform_real_distribution(2.0, 3.0)(random);
        const double thick = std::uniform_real_distribution(0.95, 1.15)(random);
        SCOPED_TRACE("seed " + std::to_string(seed) + ", handle " + std::to_string(handle) + ", head " +
                     std::to_string(head) + ", thick " + std::to_string(thick));
        TriangleMesh hammer =
            shapes::join({{Vec3(-0.5, -0.5, 0), Vec3(0.5, 0.5, handle), 0},
                          {Vec3(-head, -thick / 2, handle), Vec3(head, thick / 2, handle + thick), 1}},
                         0.12)
                .mesh;
        round_off(hammer, 12);
        shapes::turn(hammer, shapes::random_turn(random));
        EXPECT_EQ(find_parts(hammer).size(), 2U);
    }
}

INSTANTIATE_TEST_SUITE_P(Sides, Solids, testing::Values(3, 4, 5, 6, 7, 12, 32),
                         [](const auto& sides) { return "Of" + std::to_string(sides.param); });

}  // namespace
}  // namespace partonomy
