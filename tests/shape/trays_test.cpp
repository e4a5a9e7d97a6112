// Trays: open boxes of one sheet whose walls lean outward.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>

#include "mesh/triangle_mesh.h"
#include "shape/find_parts.h"
#include "shape/level_set.h"

namespace partonomy {
namespace {

struct Tray {
    double length, width, height, sheet;
    double flare;  ///< what walls lean outward on their height
};

Tray random_tray(std::mt19937& random) {
    const auto between = [&](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    return {between(0.6, 1), between(0.4, 0.65), between(0.18, 0.3), between(0.025, 0.035), between(0.1, 0.4)};
}

/// Below 0 within the sheet, above the floor's underside at z = 0.
double from_sheet(const Tray& tray, const Vec3& p) {
    const double lean = tray.flare * p.z();
    const auto solid = [&](double thinner, double low, double high) {
        return std::max({std::abs(p.x()) - tray.length / 2 + thinner - lean,
                         std::abs(p.y()) - tray.width / 2 + thinner - lean, low - p.z(), p.z() - high});
    };
    return std::max(solid(0, 0, tray.height), -solid(tray.sheet, tray.sheet, 2 * tray.height));
}

TriangleMesh make(const Tray& tray) {
    constexpr double step = 0.011;
    const double lean = tray.flare * tray.height;
    const Vec3 high(tray.length / 2 + lean + 0.05, tray.width / 2 + lean + 0.05, tray.height + 0.05);
    return solids::level_set([&](const Vec3& p) { return from_sheet(tray, p); },
                             Vec3(-high.x(), -high.y(), -0.05) + Vec3(0.003, 0.002, 0.001), high, step);
}

enum Piece { floor, front, back, left, right };

Piece piece_at(const Tray& tray, const Vec3& p) {
    const double lean = tray.flare * p.z();
    const double x = tray.length / 2 + lean - std::abs(p.x()), y = tray.width / 2 + lean - std::abs(p.y());
    if (p.z() < 1.1 * tray.sheet) return floor;
    if (x < y) return p.x() > 0 ? front : back;
    return p.y() > 0 ? right : left;
}

/// Share of the surface in parts that are mainly one piece of the tray, each piece of the sheet in one part.
double share_apart(const Tray& tray) {
    const TriangleMesh mesh = make(tray);
    const TriangleGeometry geometry = compute_geometry(mesh);
    double good = 0, all = 0;
    std::map<Piece, double> largest;  // part of each piece
    for (const double area : geometry.areas) all += area;
    for (const PartRegion& part : find_parts(mesh)) {
        std::map<Piece, double> areas;
        for (const std::int32_t t : part.region.triangles) {
            const auto i = static_cast<std::size_t>(t);
            areas[piece_at(tray, geometry.barycentres[i])] += geometry.areas[i];
        }
        const auto& [piece, area] = *std::ranges::max_element(areas, {}, [](const auto& each) { return each.second; });
        largest[piece] = std::max(largest[piece], area);
    }
    for (const auto& [piece, area] : largest) good += area;
    return good / all;
}

/// The mean over some trays.
double mean_share_apart(unsigned seed) {
    constexpr int trays = 6;
    std::mt19937 random(seed);
    double sum = 0;
    for (int n = 0; n < trays; ++n) {
        sum += share_apart(random_tray(random));
    }
    return sum / trays;
}

TEST(Trays, FloorAndWallsAreBoardsOfTheirOwn) {
    for (const unsigned seed : {2, 3}) EXPECT_GT(mean_share_apart(seed), 0.96) << "seed " << seed;
}

}  // namespace
}  // namespace partonomy
