// Boxes of vessels: most of what faces a side of the box from within, floor or far wall, is not where the box ends.
// Their truth is the smallest box of the points without noise.

#include <gtest/gtest.h>

#include <numeric>

#include "shape/calm.h"
#include "shape/part_box.h"
#include "shape/shapes.h"
#include "shape/solids.h"

namespace partonomy {
namespace {

using solids::Outline;

constexpr double step = 0.05;

struct Vessel {
    const char* name;
    Outline outer;  ///< radius and height, from the foot up
    bool is_square = false, is_tube = false;
};

std::vector<Vessel> vessels(double h) {
    constexpr double r = 0.5;
    return {{"cup", {{r, 0}, {r, h}}},
            {"bucket", {{0.6 * r, 0}, {r, h}}},
            {"flask", {{r, 0}, {0.6 * r, h}}},
            {"vase", {{0.7 * r, 0}, {0.95 * r, h / 4}, {r, 0.4 * h}, {0.95 * r, h / 2}, {0.65 * r, h}}},
            {"open box", {{r, 0}, {r, h}}, true},
            {"tube", {{r, 0}, {r, h}}, false, true},
            {"duct", {{r, 0}, {r, h}}, true, true}};
}

/// Round, or square around the same axis, open above; a tube is open below, too.
TriangleMesh make(const Vessel& vessel, double wall) {
    Outline corners = vessel.outer;
    const Outline& outer = vessel.outer;
    const double floor = std::min(1.3 * wall, 0.6 * outer.back().y());
    if (!vessel.is_tube) corners.insert(corners.begin(), {0, 0});
    for (std::size_t i = outer.size(); i-- > 0;) {
        Eigen::Vector2d p = outer[i];
        const bool is_low = !vessel.is_tube && p.y() < floor;
        if (is_low) p += (floor - p.y()) / (outer[i + 1].y() - p.y()) * (outer[i + 1] - p);
        corners.emplace_back(p.x() - wall, p.y());
        if (is_low) break;
    }
    if (!vessel.is_tube) corners.emplace_back(0, floor);
    Outline profile = solids::polygon(corners, step);  // closed; from the last corner on it runs along the axis
    if (!vessel.is_tube)
        while (profile.back().x() == 0 && profile.back().y() != floor) profile.pop_back();
    TriangleMesh mesh = solids::revolve(profile, 64, !vessel.is_tube);
    if (vessel.is_square)
        mesh = solids::moved(std::move(mesh), [](const Vec3& p) -> Vec3 {
            const double most = p.head<2>().cwiseAbs().maxCoeff();
            const double out = most > 0 ? p.head<2>().norm() / most : 1;
            return {out * p.x(), out * p.y(), p.z()};
        });
    return mesh;
}

Vec3 measured_lengths(const TriangleMesh& mesh, bool is_noisy) {
    std::vector<std::int32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    return measure_part(mesh, compute_geometry(mesh), all, is_noisy).box.lengths;
}

void expect_lengths(const TriangleMesh& mesh, const Vec3& truth, double share) {
    const Vec3 lengths = measured_lengths(mesh, true);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(lengths[k], truth[k], share * truth[k]) << "length " << k;
}

void for_all_vessels(const std::function<void(const TriangleMesh&)>& test) {
    for (const double height : {0.5, 1.0, 2.0, 4.0})
        for (const Vessel& vessel : vessels(height))
            for (const double wall : {0.02, 0.05, 0.15}) {
                SCOPED_TRACE(testing::Message() << vessel.name << ", " << height << " high, wall " << wall);
                test(make(vessel, wall));
            }
}

TEST(Vessels, HaveTheirOwnBoxWhereAMeshIsTakenForNoisy) {
    for_all_vessels([](const TriangleMesh& mesh) { expect_lengths(mesh, measured_lengths(mesh, false), 0.01); });
}

TEST(Vessels, KeepItUnderNoise) {
    constexpr unsigned seed = 21;
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    for (const double noise : {0.0025, 0.01})
        for_all_vessels([&](const TriangleMesh& clean) {
            double scale = 1;
            const TriangleMesh noisy = solids::disturbed(clean, noise, random, &scale);
            TriangleGeometry geometry = compute_geometry(noisy);
            const Calming calmed = calm(noisy, build_adjacency(noisy), geometry, 1);
            ASSERT_GT(calmed.grain, 0);
            expect_lengths(calmed.mesh, measured_lengths(clean, false), 0.09);
        });
}

TEST(Vessels, AreStillMeasuredWhereTheirFloorIsAboveTheMiddle) {
    const double h = 2, wall = 0.05, floor = 1.2;  // an egg cup on a hollow foot
    const Outline corners{{0, floor - wall}, {0.5 - wall, floor - wall}, {0.5 - wall, 0}, {0.5, 0}, {0.5, h},
                          {0.5 - wall, h},   {0.5 - wall, floor},        {0, floor}};
    Outline profile = solids::polygon(corners, step);
    while (profile.back().x() == 0 && profile.back().y() != floor) profile.pop_back();
    const TriangleMesh mesh = solids::revolve(profile, 64, true);
    expect_lengths(mesh, measured_lengths(mesh, false), 0.01);
}

}  // namespace
}  // namespace partonomy
