// The boxes of round parts, however they are cut into triangles: a few that run from end to end, or many.

#include "shape/part_box.h"

#include <gtest/gtest.h>

#include <numeric>

#include "shape/find_parts.h"
#include "shape/shapes.h"

namespace partonomy {
namespace {

constexpr double length = 1.2, radius = 0.1;

struct Form {
    const char* name;
    double (*share)(double);  ///< of the radius, at a share of the length
    double bend;              ///< sagitta over the length
};

const Form cylinder{"cylinder", [](double) { return 1.0; }, 0};
const Form cone{"cone", [](double t) { return 1 - t; }, 0};
const Form taper{"taper", [](double t) { return 1 - 0.5 * t; }, 0};
const Form bent{"bent stick", [](double) { return 1.0; }, 0.08};

/// A form of `around` sides and `along` rings, closed at both ends, upright.
TriangleMesh make(const Form& form, int around, int along) {
    TriangleMesh mesh = shapes::cylinder(radius, length, around, along);
    for (Vec3& point : mesh.positions) {
        const double t = point.z() / length;
        point.head<2>() *= form.share(t);
        point.x() += 4 * form.bend * length * t * (1 - t);
    }
    std::erase_if(mesh.triangles, [&](const auto& t) {  // those at the tip of a cone have no area
        const Vec3 &a = mesh.positions[static_cast<std::size_t>(t[0])],
                   &b = mesh.positions[static_cast<std::size_t>(t[1])],
                   &c = mesh.positions[static_cast<std::size_t>(t[2])];
        return (b - a).cross(c - a).norm() < 1e-12;
    });
    mesh.input_faces.resize(mesh.triangles.size());
    std::iota(mesh.input_faces.begin(), mesh.input_faces.end(), 0);
    mesh.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    return mesh;
}

PartBox measure(const TriangleMesh& mesh, bool is_noisy) {
    std::vector<std::int32_t> all(mesh.triangles.size());
    std::iota(all.begin(), all.end(), 0);
    return measure_part(mesh, compute_geometry(mesh), all, is_noisy);
}

/// Whether a box is as long and as wide as the form, give or take a share of each.
void expect_true(const Vec3& lengths, const Form& form, int around, double share) {
    const double narrow = 2 * radius * std::cos(std::numbers::pi / around) * (1 - share);
    EXPECT_GE(lengths[0], length * (1 - share));
    EXPECT_LE(lengths[0], length * (1 + share));  // a cone that leans on its side is 0.4 % longer
    EXPECT_GE(lengths[2], narrow);
    EXPECT_LE(lengths[2], 2 * radius * (1 + share));
    EXPECT_GE(lengths[1], narrow);
    EXPECT_LE(lengths[1], (2 * radius + form.bend * length) * (1 + share));
}

TEST(PartBox, OfRoundPartsIsTrueWhateverTheTriangles) {
    std::mt19937 random(11);
    for (const Form& form : {cylinder, cone, taper, bent})
        for (const int around : {6, 7, 8, 12, 20, 33, 64})
            for (const int along : {1, 3, 16, 60}) {
                if (form.bend > 0 && along < 16) continue;
                SCOPED_TRACE(testing::Message() << form.name << ", " << around << " sides, " << along << " rings");
                TriangleMesh mesh = make(form, around, along);
                shapes::turn(mesh, shapes::random_turn(random));
                expect_true(measure(mesh, false).box.lengths, form, around, 0.02);
                const std::vector<PartRegion> parts = find_parts(mesh);
                ASSERT_EQ(parts.size(), 1U);
                EXPECT_FALSE(parts.front().is_noisy);
                expect_true(parts.front().box.lengths, form, around, 0.02);
            }
}

TEST(PartBox, OfANoisyMeshKeepsTheLengthOfLongTriangles) {
    std::mt19937 random(12);
    for (const Form& form : {cylinder, cone, taper})
        for (const int around : {6, 12, 64})
            for (const int along : {1, 3, 16, 60}) {
                SCOPED_TRACE(testing::Message() << form.name << ", " << around << " sides, " << along << " rings");
                TriangleMesh mesh = make(form, around, along);
                shapes::turn(mesh, shapes::random_turn(random));
                EXPECT_NEAR(measure(mesh, true).box.lengths[0], length, 0.02 * length);
            }
}

TEST(PartBox, IsNotBlownUpByNoiseOrOneSpike) {
    for (const Form& form : {cylinder, cone, taper, bent})
        for (const double level : {0.005, 0.01}) {
            SCOPED_TRACE(testing::Message() << form.name << ", noise " << level);
            std::mt19937 random(13);
            constexpr int around = 64;
            TriangleMesh mesh = make(form, around, 120);
            std::normal_distribution<double> normal(0, level * compute_bounds(mesh).diagonal() / std::sqrt(3.0));
            for (Vec3& point : mesh.positions) point += Vec3(normal(random), normal(random), normal(random));
            mesh.positions[around].z() -= 0.12 * length;  // above the foot's edge: six small triangles
            shapes::turn(mesh, shapes::random_turn(random));
            const std::vector<PartRegion> parts = find_parts(mesh);
            const PartRegion& part = *std::max_element(parts.begin(), parts.end(), [](const auto& a, const auto& b) {
                return a.region.triangles.size() < b.region.triangles.size();
            });
            EXPECT_TRUE(part.is_noisy);
            EXPECT_NEAR(part.box.lengths[0], length, 0.06 * length);  // of the 0.12 that the spike adds
        }
}

}  // namespace
}  // namespace partonomy
