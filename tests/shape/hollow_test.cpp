// Things with a hollow: a floor whose two sides are joined by nothing but the solid between them, and solids that reach
// into each other's walls.

#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "shape/find_parts.h"
#include "shape/find_solids.h"
#include "shape/shapes.h"
#include "shape/solids.h"

namespace partonomy {
namespace {

constexpr double radius = 0.04, height = 0.095, wall = 0.004, floor_thickness = 0.006;

/// A cup, standing on z = 0, as one closed surface.
TriangleMesh cup() {
    const solids::Outline corners{{0, 0},
                                  {radius, 0},
                                  {radius, height},
                                  {radius - wall, height},
                                  {radius - wall, floor_thickness},
                                  {0, floor_thickness}};
    return solids::revolve(solids::profile(corners, 0.004), 48, true);
}

/// A round stick along x whose end is hidden in the wall of the cup.
TriangleMesh peg() {
    TriangleMesh stick = shapes::cylinder(0.006, 0.06, 24, 12);
    for (Vec3& p : stick.positions) p = Vec3(p.z() + radius - wall / 2, p.y(), height / 2 - p.x());
    return stick;
}

TriangleMesh both(TriangleMesh mesh, const TriangleMesh& other) {
    const auto first = static_cast<std::int32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), other.positions.begin(), other.positions.end());
    for (const auto& [a, b, c] : other.triangles) mesh.triangles.push_back({a + first, b + first, c + first});
    return solids::finish(std::move(mesh));
}

TEST(Hollow, AFloorHasBothItsSidesAndItsThickness) {
    const TriangleMesh mesh = cup();
    const std::vector<PartRegion> parts = find_parts(mesh, {});
    ASSERT_EQ(parts.size(), 2U);
    const PartRegion& floor = parts[parts[0].box.lengths[2] < parts[1].box.lengths[2] ? 0 : 1];
    EXPECT_NEAR(floor.box.lengths[2], floor_thickness, 0.02 * floor_thickness);
    double above = 0, below = 0;
    const TriangleGeometry geometry = compute_geometry(mesh);
    for (const std::int32_t t : floor.region.triangles) {
        const auto i = static_cast<std::size_t>(t);
        if (geometry.normals[i].z() > 0.9) above += geometry.areas[i];
        if (geometry.normals[i].z() < -0.9) below += geometry.areas[i];
    }
    EXPECT_GT(above, 0.8 * below);
    EXPECT_GT(below, 0.8 * std::numbers::pi * (radius - wall) * (radius - wall));
}

TEST(Hollow, AStickThatEndsWithinAWallIsOnePartWithItsEnd) {
    const TriangleMesh vessel = cup(), mesh = both(vessel, peg());
    const std::vector<PartRegion> parts = find_parts(mesh, {});
    const auto first = static_cast<std::int32_t>(vessel.triangles.size());
    std::size_t of_the_peg = 0;
    for (const PartRegion& part : parts)
        if (part.region.triangles.back() >= first) {
            ++of_the_peg;
            EXPECT_GE(part.region.triangles.front(), first);
            EXPECT_EQ(part.region.triangles.size(), mesh.triangles.size() - vessel.triangles.size());
            EXPECT_NEAR(part.box.lengths[0], 0.06, 0.001);
        }
    EXPECT_EQ(of_the_peg, 1U);
}

TEST(Hollow, SolidsAreClosedShellsThatFaceOutward) {
    const TriangleMesh vessel = cup(), stick = peg(), mesh = both(vessel, stick);
    const std::vector<std::int32_t> solid_of = find_solids(mesh, build_adjacency(mesh));
    ASSERT_EQ(solid_of.size(), mesh.triangles.size());
    const auto count = [&](std::int32_t solid) { return std::ranges::count(solid_of, solid); };
    EXPECT_EQ(count(0), static_cast<std::ptrdiff_t>(vessel.triangles.size()));
    EXPECT_EQ(count(1), static_cast<std::ptrdiff_t>(stick.triangles.size()));

    TriangleMesh open = mesh;  // a sheet is no solid, and one solid alone needs telling from nothing
    open.triangles.pop_back();
    EXPECT_TRUE(find_solids(solids::finish(open), build_adjacency(open)).empty());

    TriangleMesh cavity = mesh;
    for (std::size_t t = vessel.triangles.size(); t < cavity.triangles.size(); ++t)
        std::swap(cavity.triangles[t][0], cavity.triangles[t][1]);
    EXPECT_TRUE(find_solids(cavity, build_adjacency(cavity)).empty());
}

}  // namespace
}  // namespace partonomy
