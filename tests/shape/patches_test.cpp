// Surfaces of shapes made by code, cut into planes, cylinders, spheres, cones and tori: as they are, and turned, scaled
// and with noise of 0.5 %.

#include "shape/patches.h"

#include <gtest/gtest.h>

#include <map>
#include <numeric>

#include "shape/calm.h"
#include "shape/solids.h"

namespace partonomy {
namespace {

constexpr double pi = std::numbers::pi;
using solids::Outline;

const char* const kind_names[] = {"flat", "cylinder", "sphere", "cone", "torus", "freeform"};

struct Cut {
    TriangleMesh mesh;
    std::vector<Patch> patches;
    std::map<std::string, double> shares;  ///< of the area, by kind
    std::string text;
    explicit Cut(const TriangleMesh& input) : mesh(input) {
        const Adjacency adjacency = build_adjacency(mesh);
        TriangleGeometry geometry = compute_geometry(mesh);
        const Calming calming = calm(mesh, adjacency, geometry);
        double noise = 0;
        if (!calming.mesh.triangles.empty()) {
            for (std::size_t v = 0; v < mesh.positions.size(); ++v)
                noise += (mesh.positions[v] - calming.mesh.positions[v]).squaredNorm();
            noise = 0.3 * std::sqrt(noise / static_cast<double>(mesh.positions.size()));
            mesh = calming.mesh;
        }
        std::vector<std::int32_t> all(mesh.triangles.size());
        std::iota(all.begin(), all.end(), 0);
        patches = find_patches({mesh, geometry, adjacency, noise}, all);
        double total = 0;
        for (const Patch& patch : patches) total += patch.area;
        for (const Patch& patch : patches) {
            const std::string kind = kind_names[static_cast<std::size_t>(patch.primitive.kind)];
            shares[kind] += patch.area / total;
            text += kind + " " + std::to_string(patch.area / total) + " r " + std::to_string(patch.primitive.radius) +
                    " res " + std::to_string(patch.primitive.residual) + "\n";
        }
    }
};

struct Known {
    std::string name;
    TriangleMesh mesh;
    std::map<std::string, double> shares;
};

std::vector<Known> known_shapes() {
    using namespace solids;
    const double s = 0.05;
    std::vector<Known> all;
    all.push_back({"box", sweep(rectangle(1, 0.7, s), 0.5, s), {{"flat", 1}}});
    all.push_back({"coarse box", sweep(rectangle(1, 0.7, 2), 0.5, 2), {{"flat", 1}}});
    const double wall = 2 * pi * 0.3 * 2, ends = 2 * pi * 0.09;
    all.push_back({"round stick",
                   sweep(ellipse(0.3, 0.3, s), 2, s),
                   {{"cylinder", wall / (wall + ends)}, {"flat", ends / (wall + ends)}}});
    all.push_back({"sixteen-sided stick",
                   sweep(regular(16, 0.3, 1), 2, 2),
                   {{"cylinder", wall / (wall + ends)}, {"flat", ends / (wall + ends)}}});
    all.push_back({"six-sided stick", sweep(regular(6, 0.3, s), 2, s), {{"flat", 1}}});
    all.push_back({"ball", ball(0.6, s), {{"sphere", 1}}});
    all.push_back({"ring", torus(0.8, 0.25, s), {{"torus", 1}}});
    const double slant = std::hypot(0.4, 1.5);
    const double cone = pi * (0.6 + 0.2) * slant, caps = pi * (0.36 + 0.04);
    all.push_back({"blunt cone",
                   sweep(ellipse(0.6, 0.6, s), 1.5, s,
                         [](double t, const Eigen::Vector2d& p) -> Vec3 {
                             const double share = 1 - t * 2 / 3;
                             return {share * p.x(), share * p.y(), 1.5 * t};
                         }),
                   {{"cone", cone / (cone + caps)}, {"flat", caps / (cone + caps)}}});
    const double outside = 2 * pi * 0.5 * 1.2, inside = 2 * pi * 0.35 * 1.2, rims = 2 * pi * (0.25 - 0.1225);
    all.push_back(
        {"pipe",
         revolve(polygon({{0.35, 0}, {0.5, 0}, {0.5, 1.2}, {0.35, 1.2}}, s), 64, false),
         {{"cylinder", (outside + inside) / (outside + inside + rims)}, {"flat", rims / (outside + inside + rims)}}});
    Outline capsule;
    for (int i = 0; i <= 12; ++i)
        capsule.emplace_back(i == 0 ? 0 : 0.3 * std::sin(pi / 2 * i / 12), -0.3 * std::cos(pi / 2 * i / 12));
    for (int i = 1; i < 20; ++i) capsule.emplace_back(0.3, i * 0.06);
    for (int i = 12; i >= 0; --i)
        capsule.emplace_back(i == 0 ? 0 : 0.3 * std::sin(pi / 2 * i / 12), 1.2 + 0.3 * std::cos(pi / 2 * i / 12));
    all.push_back({"capsule", revolve(capsule, 40, true), {{"cylinder", 1.2 / 1.8}, {"sphere", 0.6 / 1.8}}});
    return all;
}

TEST(Patches, KnownSurfaces) {
    for (const Known& shape : known_shapes()) {
        SCOPED_TRACE(shape.name);
        const Cut cut(shape.mesh);
        for (const char* kind : kind_names) {
            const double wanted = shape.shares.contains(kind) ? shape.shares.at(kind) : 0;
            EXPECT_NEAR(cut.shares.contains(kind) ? cut.shares.at(kind) : 0, wanted, 0.06) << kind << "\n" << cut.text;
        }
        std::vector<int> seen(shape.mesh.triangles.size());
        for (const Patch& patch : cut.patches)
            for (const std::int32_t t : patch.triangles) ++seen[static_cast<std::size_t>(t)];
        EXPECT_TRUE(std::ranges::all_of(seen, [](int n) { return n == 1; }));
    }
}

TEST(Patches, NoiseSizeAndTurningChangeNothing) {
    for (const Known& shape : known_shapes())
        for (const unsigned seed : {1U, 2U}) {
            if (shape.mesh.triangles.size() < 500) continue;  // nothing to take the noise out of
            if (shape.name == "six-sided stick") continue;    // as far from a cylinder as the noise
            SCOPED_TRACE(shape.name + ", seed " + std::to_string(seed));
            std::mt19937 random(seed);
            const Cut cut(solids::disturbed(shape.mesh, 0.005, random));
            for (const char* kind : kind_names) {
                const double wanted = shape.shares.contains(kind) ? shape.shares.at(kind) : 0;
                EXPECT_NEAR(cut.shares.contains(kind) ? cut.shares.at(kind) : 0, wanted, 0.15) << kind << "\n"
                                                                                               << cut.text;
            }
        }
}

TEST(Patches, FoldsOfNoiseAreNone) {
    // The noise is as long as the triangles' edges.
    const TriangleMesh fine = solids::sweep(solids::rectangle(1, 0.7, 0.012), 0.3, 0.012);
    for (unsigned seed = 1; seed <= 3; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const Cut cut(solids::disturbed(fine, 0.01, random));
        for (const Patch& patch : cut.patches) EXPECT_GE(patch.triangles.size(), 12);
    }
}

}  // namespace
}  // namespace partonomy
