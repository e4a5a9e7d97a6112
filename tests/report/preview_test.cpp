#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

#include "base/errors.h"
#include "picture.h"
#include "report/choose_view.h"
#include "report/font.h"
#include "report/write.h"
#include "zoo.h"

namespace partonomy {
namespace {

TEST(Preview, ShowsEveryPartOnWhite) {
    const zoo::Annotated object = zoo::broken_bench();
    const Picture picture = decode(to_png(object.mesh, object.annotation, Vec3::UnitZ()));
    EXPECT_EQ(picture.width, 480);
    EXPECT_EQ(picture.height, 360);
    for (const AnnotatedPart& part : object.annotation.parts)
        EXPECT_GT(shaded_pixels(picture, color_of(part)), 1500) << part.concepts[0] << " " << part.id;
    const auto white = std::ranges::count(picture.pixels, Color{255, 255, 255});
    EXPECT_GT(white, 480 * 360 / 2);
    for (const int x : {0, 479})
        for (const int y : {0, 359}) EXPECT_EQ(picture.at(x, y), (Color{255, 255, 255}));
    const auto dark =
        std::ranges::count_if(picture.pixels, [](const Color& c) { return c[0] < 60 && c[1] < 60 && c[2] < 60; });
    EXPECT_GT(dark, 1000) << "lines and words";
    const auto red = std::ranges::count(picture.pixels, Color{190, 30, 30});
    EXPECT_GT(red, 200) << "the name of the diagnosis";
}

TEST(Preview, LegendHasTheExactColors) {
    const zoo::Annotated object = zoo::bench();
    const Picture picture = decode(to_png(object.mesh, object.annotation, Vec3::UnitZ()));
    for (const AnnotatedPart& part : object.annotation.parts)
        EXPECT_GE(std::ranges::count(picture.pixels, color_of(part)), 100) << part.id;
}

TEST(Preview, LegendNamesCompositePartsInTheColorsOfTheirPieces) {
    const zoo::Annotated plain = zoo::bench(), made_up = zoo::made_up_bench();
    const auto swatches = [](const zoo::Annotated& object, Color color) {  // exact colours occur in the legend alone
        const Picture picture = decode(to_png(object.mesh, object.annotation, Vec3::UnitZ()));
        int count = 0;
        for (int y = 0; y < picture.height; ++y)
            for (int x = picture.width / 2; x < picture.width; ++x) count += picture.at(x, y) == color ? 1 : 0;
        return count;
    };
    const Color seat{0x4e, 0x79, 0xa7}, backrest{0xf2, 0x8e, 0x2b};
    EXPECT_NEAR(swatches(made_up, seat), 2 * swatches(plain, seat), 20);          // also in Top
    EXPECT_NEAR(swatches(made_up, backrest), 3 * swatches(plain, backrest), 20);  // also in Back and Top
}

TEST(Preview, SameBytesOnAnyNumberOfThreadsAndEveryTime) {
    const zoo::Annotated object = zoo::broken_bench();
    const std::string once = to_png(object.mesh, object.annotation, Vec3::UnitZ());
    for (const int threads : {0, 1, 2, 3, 8})
        EXPECT_EQ(to_png(object.mesh, object.annotation, Vec3::UnitZ(), {.threads = threads}), once) << threads;
}

TEST(Preview, UpIsRespected) {
    // The same bench laid on its side, with the up direction told, is the same bench.
    const zoo::Annotated standing = zoo::bench();
    zoo::Annotated lying = zoo::bench();
    for (Vec3& point : lying.mesh.positions) point = Vec3(point.z(), point.x(), point.y());
    const Picture a = decode(to_png(standing.mesh, standing.annotation, Vec3::UnitZ()));
    const Picture b = decode(to_png(lying.mesh, lying.annotation, Vec3::UnitX()));
    std::size_t different = 0;
    for (std::size_t i = 0; i < a.pixels.size(); ++i) different += a.pixels[i] != b.pixels[i];
    EXPECT_LT(different, a.pixels.size() / 50);
    // and the backrest is above the legs
    const auto mean_row = [&](Color color) {
        double sum = 0, count = 0;
        for (int y = 60; y < a.height; ++y)
            for (int x = 0; x < 340; ++x) {
                const Color pixel = a.at(x, y);
                const Eigen::Vector3d seen(pixel[0], pixel[1], pixel[2]), wanted(color[0], color[1], color[2]);
                if (seen.norm() < 80 || seen.normalized().dot(wanted.normalized()) < 0.9985) continue;
                sum += y;
                ++count;
            }
        return sum / count;
    };
    EXPECT_LT(mean_row(color_of(standing.annotation.parts[1])) + 50, mean_row(color_of(standing.annotation.parts[2])));
}

TEST(Preview, ShowsTheFrontOfAChair) {
    // From behind, the backrest would hide much of the seat; whichever way the chair faces, the seat must be seen.
    for (const bool backwards : {false, true}) {
        zoo::Annotated object = zoo::bench();
        if (backwards)
            for (Vec3& point : object.mesh.positions) point = Vec3(-point.x(), -point.y(), point.z());
        const Picture picture = decode(to_png(object.mesh, object.annotation, Vec3::UnitZ()));
        EXPECT_GT(shaded_pixels(picture, color_of(object.annotation.parts[0])), 8000) << backwards;
    }
}

TEST(Preview, LongThingsAreSeenAcross) {
    std::mt19937 random(20261123);
    std::normal_distribution<double> normal;
    for (int trial = 0; trial < 200; ++trial) {
        const auto quaternion = Eigen::Quaterniond(normal(random), normal(random), normal(random), normal(random));
        const Eigen::Matrix3d turn = quaternion.normalized().toRotationMatrix();
        zoo::Annotated object;
        zoo::add_part(object, {"Handle"}, 1, "#4e79a7");
        zoo::add_box(object, 0, Vec3(0, 0, 0), Vec3(1, 0.06, 0.03));
        for (Vec3& point : object.mesh.positions) point = turn * point;
        zoo::complete(object);
        const PlacedMesh placed(object.mesh);
        const Camera camera = choose_view(placed, object.annotation, Vec3::UnitZ(), {0, 0, 100, 100});
        EXPECT_LT(std::abs(camera.into.dot(turn.col(0))), 0.71) << "seed 20261123, trial " << trial;
    }
}

TEST(Preview, SizeAndScaleOfTheMeshDoNotMatter) {
    const zoo::Annotated object = zoo::bench();
    const Picture usual = decode(to_png(object.mesh, object.annotation, Vec3::UnitZ()));
    for (const double factor : {1e-30, 1e-3, 1e4, 1e30}) {
        zoo::Annotated scaled = zoo::bench();
        for (Vec3& point : scaled.mesh.positions) point *= factor;
        const Picture picture = decode(to_png(scaled.mesh, scaled.annotation, Vec3::UnitZ() * factor));
        std::size_t different = 0;
        for (std::size_t i = 0; i < usual.pixels.size(); ++i) different += usual.pixels[i] != picture.pixels[i];
        EXPECT_LT(different, usual.pixels.size() / 100) << factor;
    }
    const zoo::Annotated far = zoo::bench(Vec3(1e6, 2e6, -3e6));
    const Picture picture = decode(to_png(far.mesh, far.annotation, Vec3::UnitZ()));
    for (const AnnotatedPart& part : far.annotation.parts) EXPECT_GT(shaded_pixels(picture, color_of(part)), 1500);
}

TEST(Preview, AnySizeDoesNotCrash) {
    const zoo::Annotated object = zoo::broken_bench();
    for (const auto& [width, height] :
         {std::pair{1, 1}, {3, 200}, {5, 5}, {16, 12}, {199, 119}, {200, 120}, {201, 333}, {1000, 700}}) {
        const Picture picture =
            decode(to_png(object.mesh, object.annotation, Vec3::UnitZ(), {.width = width, .height = height}));
        EXPECT_EQ(picture.width, width);
        EXPECT_EQ(picture.height, height);
    }
    for (const auto& [width, height] : {std::pair{0, 10}, {10, -1}, {100000, 10}})
        EXPECT_THROW((void)to_png(object.mesh, object.annotation, Vec3::UnitZ(), {.width = width, .height = height}),
                     UsageError);
    EXPECT_THROW((void)to_png(object.mesh, object.annotation, Vec3::Zero()), UsageError);
}

TEST(Preview, AwkwardObjects) {
    const Picture nothing = decode(to_png(TriangleMesh{}, Annotation{}, Vec3::UnitZ()));
    EXPECT_GT(std::ranges::count(nothing.pixels, Color{255, 255, 255}), 480 * 360 * 9 / 10);
    zoo::Annotated flat = zoo::bench();  // seen edge on from everywhere around
    for (Vec3& point : flat.mesh.positions) point.z() = 0;
    EXPECT_EQ(decode(to_png(flat.mesh, flat.annotation, Vec3::UnitZ())).width, 480);
    zoo::Annotated dot = zoo::bench();
    for (Vec3& point : dot.mesh.positions) point = Vec3(1, 2, 3);
    EXPECT_EQ(decode(to_png(dot.mesh, dot.annotation, Vec3::UnitZ())).width, 480);
    zoo::Annotated talkative = zoo::bench();
    for (int i = 0; i < 40; ++i)
        zoo::add_part(talkative, {std::string(200, 'W') + std::to_string(i)}, std::nan(""), "");
    talkative.annotation.classes = {std::string(300, 'x')};
    EXPECT_EQ(decode(to_png(talkative.mesh, talkative.annotation, Vec3::UnitZ())).width, 480);
}

TEST(Font, DropsAccentsAndSurvivesAnything) {
    EXPECT_EQ(to_font("R\xC3\xBC"
                      "ckenlehne \xC3\x97"
                      "2"),
              std::string("Ruckenlehne ") + times_sign + "2");
    EXPECT_EQ(to_font("\xC5\x99\xC3\x89\xC5\x82"), "rEl");     // r with caron, E with acute, l with stroke
    EXPECT_EQ(to_font("e\xCC\x81"), "e");                      // combining acute
    EXPECT_EQ(to_font("\xE6\xA4\x85\xF0\x9F\xAA\x91"), "??");  // a Chinese word, an emoji
    EXPECT_EQ(to_font("a\xFF\xC3"), "a??");                    // not UTF-8, and cut off
    EXPECT_EQ(to_font("\xE2\x80\x93\xE2\x80\x99"), "-'");
    for (int c = 33; c < 128; ++c) {
        int ink = 0;
        for (int y = 0; y < glyph_height; ++y)
            for (int x = 0; x < glyph_width; ++x) ink += glyph_pixel(static_cast<char>(c), x, y);
        EXPECT_GT(ink, 1) << c;
        EXPECT_LT(ink, 25) << c;
    }
    EXPECT_FALSE(glyph_pixel('A', -1, 0));
    EXPECT_FALSE(glyph_pixel('A', 5, 0));
}

}  // namespace
}  // namespace partonomy
