// Sticks that meet rings as thick as they are: the front of a pair of spectacles, in one piece.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mesh/triangle_mesh.h"
#include "shape/find_parts.h"
#include "shape/level_set.h"

namespace partonomy {
namespace {

struct Front {
    double width, height;  ///< half of a lens
    double tube;           ///< radius of the rims
    double bridge;         ///< radius of the bridge
    double place;          ///< of the bridge above the middle of the lenses
    double arch;
};

constexpr double gap = 10;  // half the way between the rims

double middle_of(const Front& front) { return gap + front.tube + front.width; }

/// In millimetres; x across, z up.
TriangleMesh make(const Front& front, double step) {
    const auto rounded = [](double a, double b) {  // melts the two together
        const double h = std::max(0.6 - std::abs(a - b), 0.0) / 0.6;
        return std::min(a, b) - 0.15 * h * h;
    };
    const auto inside = [&](const Vec3& p) {
        const double x = std::abs(p.x()) - middle_of(front);
        const double out = (Eigen::Vector2d(x / front.width, p.z() / front.height).norm() - 1) *
                           std::min(front.width, front.height);  // about the distance from the outline
        const double rim = std::hypot(out, p.y()) - front.tube, lens = std::max(out, std::abs(p.y()) - 1);
        const double end = gap + 2;
        double bridge = 1e9;
        for (int k = 0; k < 8; ++k) {
            const auto at = [&](int i) {
                const double u = i / 4.0 - 1;
                return Vec3(end * u, 0, front.place + front.arch * (1 - u * u));
            };
            bridge = std::min(bridge, solids::from_line(p, at(k), at(k + 1)) - front.bridge);
        }
        return rounded(rounded(rim, lens), bridge);
    };
    const double side = middle_of(front) + front.width + front.tube + 2 * step;
    // The lattice is no mirror image of itself.
    const Vec3 corner(side, front.tube + 2 * step, front.height + front.tube + 2 * step);
    return solids::level_set(inside, -corner - Vec3(0.3, 0.2, 0.1) * step, corner, step);
}

/// Whether the bridge is a part of its own: some part holds nearly all between the rims, and little beside: the rest is
/// where it meets the rims.
bool has_bridge(const Front& front) {
    const TriangleMesh mesh = make(front, 1.1);
    const TriangleGeometry geometry = compute_geometry(mesh);
    const auto is_between = [&](std::int32_t t) {
        return std::abs(geometry.barycentres[static_cast<std::size_t>(t)].x()) < gap - 3;
    };
    double all = 0, most = 0, own = 0;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
        if (is_between(static_cast<std::int32_t>(t))) all += geometry.areas[t];
    for (const PartRegion& part : find_parts(mesh)) {
        double between = 0, area = 0;
        for (const std::int32_t t : part.region.triangles) {
            area += geometry.areas[static_cast<std::size_t>(t)];
            if (is_between(t)) between += geometry.areas[static_cast<std::size_t>(t)];
        }
        if (between > most) most = between, own = area;
    }
    return most > 0.9 * all && most > 0.5 * own;
}

}  // namespace

/// A bridge hardly ever was it was as thick as the rims: 1 of these 12. Where the core of the bridge holds a long arc
/// of a rim, it still is not.
TEST(Rims, BridgeAsThickAsTheRimsIsMostlyAPart) {
    int found = 0;
    for (const double ratio : {0.92, 1.0, 1.08})
        for (const double place : {2.0, 6.0})
            for (const double arch : {0.0, 4.0}) found += has_bridge({24, 21, 2.3, 2.3 * ratio, place, arch});
    EXPECT_GE(found, 9) << "of 12";
}

TEST(Rims, ThinBridgeIsAPart) {
    for (const double place : {2.0, 4.0}) EXPECT_TRUE(has_bridge({24, 21, 2.3, 2.3 * 0.7, place, 2}));
}

}  // namespace partonomy
