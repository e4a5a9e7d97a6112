#include "report/eval_pictures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/errors.h"
#include "picture.h"
#include "report/boundaries.h"
#include "report/canvas.h"
#include "report/write.h"

namespace partonomy {
namespace {

/// A sheet of n x n unit squares, two triangles each.
TriangleMesh sheet(int n) {
    TriangleMesh mesh;
    for (int y = 0; y <= n; ++y)
        for (int x = 0; x <= n; ++x) mesh.positions.emplace_back(x, y, 0.3 * x * y / n);
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) {
            const int a = y * (n + 1) + x, b = a + 1, c = b + n + 1, d = c - 1;
            mesh.triangles.push_back({a, b, c});
            mesh.triangles.push_back({a, c, d});
            mesh.input_faces.insert(mesh.input_faces.end(), 2, mesh.input_face_count++);
        }
    return mesh;
}

std::vector<std::string> halves(int n, int border) {
    std::vector<std::string> labels;
    for (int y = 0; y < n; ++y)
        for (int x = 0; x < n; ++x) labels.emplace_back(x < border ? "Seat" : "Leg");
    return labels;
}

TEST(Boundaries, AreNearOrNot) {
    const int n = 20;
    const TriangleMesh mesh = sheet(n);
    const auto f = [&](int border, double tolerance) {
        return compare_boundaries(mesh, halves(n, border), halves(n, 10), tolerance).f();
    };
    EXPECT_DOUBLE_EQ(f(10, 0.01), 1);
    EXPECT_DOUBLE_EQ(f(11, 0.01), 0);  // a column of 1 beside a diagonal of 28.9
    EXPECT_DOUBLE_EQ(f(11, 0.04), 1);
    EXPECT_DOUBLE_EQ(f(0, 0.01), 0) << "no border where there is a true one";
    EXPECT_DOUBLE_EQ(compare_boundaries(mesh, halves(n, 0), halves(n, 20)).f(), 1) << "no border on either side";
    std::vector<std::string> unknown = halves(n, 10);
    for (int y = 0; y < n; ++y) unknown[static_cast<std::size_t>(y * n + 10)] = "-";
    EXPECT_DOUBLE_EQ(compare_boundaries(mesh, halves(n, 10), unknown).f(), 1) << "what has no truth is not compared";
    EXPECT_THROW((void)compare_boundaries(mesh, {"Seat"}, halves(n, 10)), UsageError);
    EXPECT_EQ(compare_boundaries(TriangleMesh{}, {}, {}).f(), 1);
}

/// Precision by looking at every pair of fine points on the borders.
double brute_share(const TriangleMesh& mesh, const std::vector<std::string>& labels,
                   const std::vector<std::string>& others, double distance) {
    const auto border_points = [&](const std::vector<std::string>& names) {
        std::vector<Vec3> points;
        for (std::size_t s = 0; s < mesh.triangles.size(); ++s)
            for (std::size_t t = s + 1; t < mesh.triangles.size(); ++t) {
                if (names[static_cast<std::size_t>(mesh.input_faces[s])] ==
                    names[static_cast<std::size_t>(mesh.input_faces[t])])
                    continue;
                std::vector<int> common;
                for (const int v : mesh.triangles[s])
                    if (std::ranges::find(mesh.triangles[t], v) != mesh.triangles[t].end()) common.push_back(v);
                if (common.size() != 2) continue;
                const Vec3 &a = mesh.positions[static_cast<std::size_t>(common[0])],
                           &b = mesh.positions[static_cast<std::size_t>(common[1])];
                for (int k = 0; k < 40; ++k) points.emplace_back(a + (k + 0.5) / 40 * (b - a));
            }
        return points;
    };
    const std::vector<Vec3> own = border_points(labels), other = border_points(others);
    double near = 0;
    for (const Vec3& p : own)
        near += std::ranges::any_of(other, [&](const Vec3& q) { return (p - q).norm() <= distance; });
    return own.empty() ? 1 : near / static_cast<double>(own.size());
}

TEST(Boundaries, AgreeWithBruteForce) {
    for (unsigned seed = 1; seed <= 12; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const int n = 6;
        TriangleMesh mesh = sheet(n);
        for (Vec3& position : mesh.positions) position.z() = 0;  // border edges of one length: pairs stand for lengths
        std::vector<std::string> labels, truth;
        for (int i = 0; i < n * n; ++i) {
            labels.emplace_back(random() % 4 == 0 ? "a" : "b");
            truth.emplace_back(random() % 4 == 0 ? "a" : "b");
        }
        const double diagonal = std::sqrt(2.0) * n, tolerance = 0.4 / diagonal;
        const BoundaryScore score = compare_boundaries(mesh, labels, truth, tolerance);
        EXPECT_NEAR(score.precision, brute_share(mesh, labels, truth, 0.4), 0.05);
        EXPECT_NEAR(score.recall, brute_share(mesh, truth, labels, 0.4), 0.05);
    }
}

TEST(ConfusionPicture, TintsTheCells) {
    const Picture picture = decode(confusion_picture({{"Seat", {{"Seat", 3}, {"Leg", 1}}}, {"Leg", {{"Leg", 1}}}}));
    int green = 0, red = 0;
    for (const Color& pixel : picture.pixels) {
        green += pixel[1] > pixel[0] + 20;
        red += pixel[0] > pixel[1] + 20;
    }
    EXPECT_GT(green, 2 * 70 * 30);
    EXPECT_GT(red, 70 * 28);
    EXPECT_LT(red, green);
    EXPECT_GT(decode(confusion_picture({})).width, 0);
}

TEST(ContactSheet, ShowsTruthBesideLabels) {
    const int n = 6;
    const SheetEntry right{"right", sheet(n), halves(n, 3), halves(n, 3), Vec3::UnitY()};
    SheetEntry wrong = right;
    wrong.labels.assign(static_cast<std::size_t>(n) * n, "Leg");
    const Picture picture = decode(contact_sheet({right, wrong}));
    const auto count = [&](const Color& color, int from, int to) {
        Picture part{to - from, picture.height - 40, {}};
        for (int y = 40; y < picture.height; ++y)
            for (int x = from; x < to; ++x) part.pixels.push_back(picture.at(x, y));
        return shaded_pixels(part, color);
    };
    AnnotatedPart leg, seat;
    leg.id = 1, seat.id = 2;  // labels in the order of the alphabet
    ASSERT_NE(color_of(leg), color_of(seat));
    EXPECT_GT(count(color_of(seat), 0, 255), 1000);
    EXPECT_NEAR(count(color_of(seat), 0, 255), count(color_of(seat), 260, 510), 50) << "truth and labels agree";
    EXPECT_GT(count(color_of(seat), 530, 780), 1000);
    EXPECT_LT(count(color_of(seat), 790, 1040), 50) << "no seat was labelled in the second";
    EXPECT_EQ(contact_sheet({right, wrong}, 1), contact_sheet({right, wrong}, 2));
    wrong.labels.pop_back();
    EXPECT_THROW((void)contact_sheet({wrong}), UsageError);
    EXPECT_THROW((void)contact_sheet({}), UsageError);
}

}  // namespace
}  // namespace partonomy
