#include "shape/thickness.h"

#include <gtest/gtest.h>

#include "shape/ray_scene.h"
#include "shape/shapes.h"

namespace partonomy {
namespace {

TEST(Thickness, OfABoxIsTheDistanceOfItsWalls) {
    const Vec3 sides(1, 0.5, 0.04);
    for (const double step : {10.0, 0.03}) {
        TriangleMesh mesh = shapes::join({{Vec3(0, 0, 0), sides, 0}}, step).mesh;
        const std::vector<Vec3> straight = compute_geometry(mesh).normals;
        constexpr unsigned seed = 23;
        SCOPED_TRACE(seed);
        std::mt19937 random(seed);
        shapes::turn(mesh, shapes::random_turn(random));
        const TriangleGeometry geometry = compute_geometry(mesh);
        const Thickness thickness = measure_thickness(mesh, geometry);
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
            EXPECT_NEAR(thickness.distances[t], std::abs(straight[t].dot(sides)), 1e-5);
            ASSERT_GE(thickness.opposites[t], 0);
            EXPECT_NEAR(geometry.normals[t].dot(geometry.normals[static_cast<std::size_t>(thickness.opposites[t])]), -1,
                        1e-9);
        }
    }
}

TEST(Thickness, OfATubeIsItsDiameter) {
    const double radius = 0.05;
    const int around = 64;
    const TriangleMesh mesh = shapes::cylinder(radius, 1, around, 50);
    const TriangleGeometry geometry = compute_geometry(mesh);
    const Thickness thickness = measure_thickness(mesh, geometry);
    const double flats = 2 * radius * std::cos(std::numbers::pi / around);  // between opposite facets of the prism
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (std::abs(geometry.normals[t].z()) < 0.5) {
            EXPECT_NEAR(thickness.distances[t], flats, 1e-3 * flats);
        }
}

TEST(Thickness, OpenSheetsAndLooseTrianglesMeetNothing) {
    TriangleMesh mesh;
    mesh.positions = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
    mesh.triangles = {{0, 1, 2}};
    mesh.input_faces = {0};
    mesh.input_face_count = 1;
    const Thickness thickness = measure_thickness(mesh, compute_geometry(mesh));
    EXPECT_TRUE(std::isinf(thickness.distances[0]));
    EXPECT_EQ(thickness.opposites[0], -1);
}

TEST(Thickness, PassesWallsThatAreMetFromOutside) {
    // Two boxes that overlap: from the big one's top the ray enters the small one and leaves through the big one's
    // bottom.
    const shapes::Labelled big = shapes::join({{Vec3(0, 0, 0), Vec3(1, 1, 1), 0}}, 10);
    const shapes::Labelled small = shapes::join({{Vec3(0.2, 0.2, 0.2), Vec3(0.8, 0.8, 0.4), 0}}, 10);
    TriangleMesh mesh = big.mesh;
    const auto shift = static_cast<std::int32_t>(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), small.mesh.positions.begin(), small.mesh.positions.end());
    for (auto triangle : small.mesh.triangles) {
        for (std::int32_t& corner : triangle) corner += shift;
        mesh.triangles.push_back(triangle);
        mesh.input_faces.push_back(static_cast<std::int32_t>(mesh.input_faces.size()));
    }
    mesh.input_face_count = static_cast<std::int32_t>(mesh.input_faces.size());
    const RayScene scene(mesh);
    const WallHit hit = scene.exit_wall({Vec3(0.45, 0.5, 0.9), Vec3(0, 0, -1)});
    EXPECT_NEAR(hit.distance, 0.7, 1e-6);  // the small box's bottom is the first wall that is left
}

TEST(Thickness, IsTheSameOnAnyNumberOfThreads) {
    const TriangleMesh mesh = shapes::cylinder(0.1, 1, 60, 100);
    const TriangleGeometry geometry = compute_geometry(mesh);
    const Thickness one = measure_thickness(mesh, geometry, 1), all = measure_thickness(mesh, geometry, 0);
    EXPECT_EQ(one.distances, all.distances);
    EXPECT_EQ(one.opposites, all.opposites);
}

}  // namespace
}  // namespace partonomy
