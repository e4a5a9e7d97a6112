#include "algorithms/appearance.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <functional>
#include <numbers>
#include <random>

#include "algorithms/quilt.h"
#include "knowledge/domain.h"
#include "mesh/appearance.h"
#include "owl/ontology.h"
#include "shape/membership.h"

namespace partonomy {
namespace {

Lab lab_of(const Rgb& rgb) { return lab_from_linear(linear_from_srgb(Color(rgb[0], rgb[1], rgb[2]) / 255)); }

double share(const Rgb& rgb, const std::string& name) {
    const std::array<double, 11> names = name_color(lab_of(rgb));
    for (std::size_t i = 0; i < names.size(); ++i)
        if (name == color_names[i]) return names[i];
    return -1;
}

TEST(ColorNames, OfColoursThatNobodyDoubts) {
    const std::pair<Rgb, const char*> known[] = {
        {{0, 0, 0}, "black"},      {{25, 25, 25}, "black"},    {{128, 128, 128}, "grey"},  {{192, 192, 192}, "grey"},
        {{105, 105, 105}, "grey"}, {{255, 255, 255}, "white"}, {{245, 245, 245}, "white"}, {{255, 250, 240}, "white"},
        {{255, 0, 0}, "red"},      {{220, 20, 60}, "red"},     {{139, 0, 0}, "red"},       {{200, 16, 30}, "red"},
        {{255, 165, 0}, "orange"}, {{255, 140, 0}, "orange"},  {{255, 255, 0}, "yellow"},  {{255, 215, 0}, "yellow"},
        {{0, 128, 0}, "green"},    {{0, 255, 0}, "green"},     {{34, 139, 34}, "green"},   {{107, 142, 35}, "green"},
        {{0, 0, 255}, "blue"},     {{0, 0, 128}, "blue"},      {{70, 130, 180}, "blue"},   {{135, 206, 235}, "blue"},
        {{128, 0, 128}, "purple"}, {{75, 0, 130}, "purple"},   {{148, 0, 211}, "purple"},  {{255, 192, 203}, "pink"},
        {{255, 105, 180}, "pink"}, {{255, 20, 147}, "pink"},   {{139, 69, 19}, "brown"},   {{160, 82, 45}, "brown"},
        {{101, 67, 33}, "brown"},  {{0, 40, 0}, "green"},      {{60, 0, 0}, "red"},        {{20, 0, 0}, "black"}};
    for (const auto& [rgb, name] : known)
        EXPECT_GT(share(rgb, name), 0.6) << int(rgb[0]) << " " << int(rgb[1]) << " " << int(rgb[2]) << " is not "
                                         << name;
}

TEST(ColorNames, SharesAddUpEverywhereAndChangeGently) {
    double steepest = 0;
    for (int r = 0; r < 256; r += 5)
        for (int g = 0; g < 256; g += 5)
            for (int b = 0; b < 256; b += 5) {
                const Lab lab =
                    lab_of({static_cast<std::uint8_t>(r), static_cast<std::uint8_t>(g), static_cast<std::uint8_t>(b)});
                const std::array<double, 11> names = name_color(lab);
                double sum = 0;
                for (const double x : names) {
                    ASSERT_GE(x, -1e-12);
                    sum += x;
                }
                ASSERT_NEAR(sum, 1, 1e-9) << r << " " << g << " " << b;
                const std::array<double, 11> beside = name_color({lab.lightness + 1e-4, lab.a + 1e-4, lab.b - 1e-4});
                for (std::size_t i = 0; i < names.size(); ++i)
                    steepest = std::max(steepest, std::abs(names[i] - beside[i]));
            }
    EXPECT_LT(steepest, 0.05);  // a twentieth for a change that nobody sees
}

TEST(ColorNames, BordersGoOverInTheMiddle) {
    // Along the hue circle at one lightness and chroma, from red through all hues back to red.
    std::vector<std::string> order;
    for (int degree = 29; degree < 29 + 360; ++degree) {
        const double angle = degree * std::numbers::pi / 180;
        const std::array<double, 11> names = name_color({0.7, 0.15 * std::cos(angle), 0.15 * std::sin(angle)});
        const auto most = static_cast<std::size_t>(std::ranges::max_element(names) - names.begin());
        EXPECT_GE(names[most], 0.5 - 1e-9) << degree;
        if (order.empty() || order.back() != color_names[most]) order.emplace_back(color_names[most]);
    }
    EXPECT_EQ(order, (std::vector<std::string>{"red", "orange", "yellow", "green", "blue", "purple", "pink", "red"}));
}

/// The whole mesh as one region, whatever its colours.
struct Whole {
    Object object;
    RegionMeasurements region;
    explicit Whole(const PaintedObject& painted, double degrees = 0) {
        object = make_object(painted.object.mesh, {});
        object.appearance = appearance_of(painted);
        PartRegion part;
        for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t)
            part.region.triangles.push_back(static_cast<std::int32_t>(t));
        part.box.centre = Vec3(0.5, 0.5, 0.05);
        part.box.lengths = Vec3(1, 1, 0.1);
        part.box.axes = Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Vec3::UnitZ()).toRotationMatrix();
        parts.push_back(part);
        region = measure_region(object, parts.front());
    }
    [[nodiscard]] std::optional<double> value(const std::string& name) const {
        return evaluate(*find_measure(name), object, region);
    }

private:
    std::vector<PartRegion> parts;
};

/// The score of an elementary concept of the built-in core.
double score(const Whole& whole, const std::string& name) {
    static const owl::Ontology core = owl::load_ontology(PARTONOMY_SOURCE_DIR "/ontologies/core.ttl");
    double lowest = -1;
    for (const owl::Annotation& annotation : core.annotations.at(std::string(owl::core_prefix) + name)) {
        const std::string property = owl::local_name(annotation.property);
        std::string text = annotation.literal.value;
        if (property == "measure")
            for (const owl::Annotation& other : core.annotations.at(std::string(owl::core_prefix) + name))
                if (owl::local_name(other.property) == "membership") text += " " + other.literal.value;
        if (property != "measure" && property != "criterion") continue;
        std::array<double, 4> a{};
        for (int i = 3; i >= 0; --i) {
            const std::size_t blank = text.rfind(' ');
            a[static_cast<std::size_t>(i)] = std::stod(text.substr(blank + 1));
            text.resize(blank);
        }
        const auto x = whole.value(text.c_str());
        if (!x) return -1;
        const double own = Trapezoid{a[0], a[1], a[2], a[3]}(*x);
        lowest = lowest < 0 ? own : std::min(lowest, own);
    }
    return lowest;
}

/// Exactly one value of the range holds: `name`.
void expect_only(const Whole& whole, const std::vector<std::string>& values, const std::string& name) {
    for (const std::string& value : values)
        EXPECT_EQ(score(whole, value) >= 0.5, value == name) << value << " " << score(whole, value);
}

const std::vector<std::string> colors = {"Black", "Grey", "White",  "Red",  "Orange", "Yellow",
                                         "Green", "Blue", "Purple", "Pink", "Brown"};
const std::vector<std::string> patterns = {"PlainTexture", "Striped", "Checked", "Noisy"};
const Rgb red{220, 20, 30}, white{250, 250, 250}, blue{0, 70, 170}, black{10, 10, 10};

TEST(Colour, EachNamedColourAndNoOther) {
    const Rgb samples[] = {{10, 10, 10},  {128, 128, 128}, {250, 250, 250}, {220, 20, 30},
                           {255, 140, 0}, {250, 215, 0},   {0, 140, 60},    {0, 70, 170},
                           {128, 0, 128}, {255, 150, 190}, {120, 70, 30}};
    for (std::size_t i = 0; i < colors.size(); ++i)
        expect_only(Whole(quilt(2, {paint(samples[i])}, [](int, int) { return 0; })), colors, colors[i]);
}

TEST(Colour, SharesDecideAndHalvesAreTheBorder) {
    for (int n = 0; n <= 10; ++n) {
        const Whole whole(quilt(10, {paint(red), paint(blue)}, [&](int i, int) { return i < n ? 0 : 1; }));
        const double painted = (n * 0.2 + 0.4) / 2.4;  // both sides of n columns, and the rim
        ASSERT_NEAR(whole.value("share of red").value(), painted, 1e-9);
        EXPECT_NEAR(score(whole, "Red"), std::clamp((painted - 0.4) / 0.2, 0.0, 1.0), 1e-6);
        EXPECT_NEAR(score(whole, "Red") + score(whole, "Blue"), 1, 1e-6);
    }
}

TEST(Colour, ValueSaturationAndUniformity) {
    const auto plain = [](const Rgb& rgb) { return Whole(quilt(2, {paint(rgb)}, [](int, int) { return 0; })); };
    const std::vector<std::string> values = {"Dark", "Medium", "Bright"}, saturations = {"Neutral", "Muted", "Vivid"},
                                   uniformities = {"UniformColour", "VariedColour"};
    expect_only(plain({20, 20, 60}), values, "Dark");
    expect_only(plain({120, 120, 120}), values, "Medium");
    expect_only(plain({240, 230, 200}), values, "Bright");
    expect_only(plain({120, 120, 120}), saturations, "Neutral");
    expect_only(plain({140, 110, 110}), saturations, "Muted");
    expect_only(plain({220, 20, 30}), saturations, "Vivid");
    expect_only(plain(red), uniformities, "UniformColour");
    // Two greys that differ by more and more: uniform as long as nobody sees it, varied when everybody does.
    double last = 1;
    for (int step = 0; step <= 100; step += 4) {
        const auto light = static_cast<std::uint8_t>(100 + step);
        const Whole whole(
            quilt(2, {paint({100, 100, 100}), paint({light, light, light})}, [](int i, int) { return i; }));
        const double uniform = score(whole, "UniformColour");
        EXPECT_LE(uniform, last + 1e-9);
        EXPECT_NEAR(uniform + score(whole, "VariedColour"), 1, 1e-9);
        if (step <= 8 || step >= 60) {
            EXPECT_EQ(uniform >= 0.5, step <= 8) << step;
        }
        last = uniform;
    }
}

TEST(Reflectance, FromMaterials) {
    const std::vector<std::string> values = {"Metallic", "Glossy", "Matte"};
    const auto of = [](double metallic, double roughness) {
        return Whole(quilt(2, {paint(white, metallic, roughness)}, [](int, int) { return 0; }));
    };
    expect_only(of(1, 0.2), values, "Metallic");
    expect_only(of(1, 0.9), values, "Metallic");
    expect_only(of(0, 0.2), values, "Glossy");
    expect_only(of(0, 0.9), values, "Matte");
    EXPECT_NEAR(score(of(0.5, 0.9), "Metallic"), 0.5, 1e-6);
    EXPECT_NEAR(score(of(0, 0.45), "Glossy"), 0.5, 1e-6);
    EXPECT_NEAR(score(of(0, 0.45), "Matte"), 0.5, 1e-6);
}

Whole pictured(int pixels, const std::function<Rgb(int, int)>& color, double degrees = 0) {
    return Whole(pictured_board(pixels, color, degrees), degrees);
}

TEST(TexturePattern, ImagesOnTwoTriangles) {
    std::mt19937 random(7);
    expect_only(pictured(64, [](int, int) { return red; }), patterns, "PlainTexture");
    for (const int width : {4, 7, 10, 16})  // pixels of 128 a stripe: 16 periods to 4
        for (const double degrees : {0.0, 17.0, 45.0}) {
            SCOPED_TRACE(testing::Message() << width << " at " << degrees);
            expect_only(pictured(
                            128, [&](int x, int) { return x / width % 2 ? red : white; }, degrees),
                        patterns, "Striped");
            expect_only(pictured(
                            128, [&](int x, int y) { return (x + y) / width % 2 ? black : white; }, degrees),
                        patterns, "Striped");
            expect_only(pictured(
                            128, [&](int x, int y) { return (x / width + y / width) % 2 ? red : white; }, degrees),
                        patterns, "Checked");
        }
    // Lines that cross, as on a tablecloth.
    expect_only(pictured(128,
                         [&](int x, int y) {
                             const auto level = static_cast<std::uint8_t>(70 * (x / 8 % 2) + 70 * (y / 8 % 2) + 60);
                             return Rgb{level, level, level};
                         }),
                patterns, "Checked");
    for (const int grain : {1, 2, 4})
        for (int round = 0; round < 3; ++round) {
            std::vector<int> noise(64 * 64);
            for (int& x : noise) x = static_cast<int>(random() % 2);
            expect_only(pictured(64,
                                 [&](int x, int y) {
                                     return noise[static_cast<std::size_t>(64 * (y / grain) + x / grain)] ? black
                                                                                                          : white;
                                 }),
                        patterns, "Noisy");
        }
    // Two halves, a shade and a disc vary, but repeat nothing.
    expect_only(pictured(64, [](int x, int) { return x < 32 ? red : white; }), patterns, "");
    expect_only(pictured(64,
                         [](int x, int) {
                             return Rgb{static_cast<std::uint8_t>(4 * x), static_cast<std::uint8_t>(4 * x), 0};
                         }),
                patterns, "");
    expect_only(
        pictured(64, [](int x, int y) { return (x - 32) * (x - 32) + (y - 32) * (y - 32) < 500 ? red : white; }),
        patterns, "");
}

TEST(TexturePattern, FacesPaintedOneByOne) {
    std::mt19937 random(11);
    const std::vector<Paint> two = {paint(red), paint(white)};
    expect_only(Whole(quilt(12, two, [](int i, int) { return i % 2; })), patterns, "Striped");
    expect_only(Whole(quilt(12, two, [](int i, int j) { return (i + j) % 2; })), patterns, "Checked");
    std::vector<int> noise(32 * 32);
    for (int& x : noise) x = static_cast<int>(random() % 2);
    expect_only(Whole(quilt(32, two, [&](int i, int j) { return noise[static_cast<std::size_t>(32 * i + j)]; })),
                patterns, "Noisy");
    // More and more squares of a chessboard painted at random: checked goes over to noisy, never to striped.
    double last = 1;
    for (int spoiled = 0; spoiled <= 100; spoiled += 20) {
        const Whole whole(quilt(16, two, [&](int i, int j) {
            const auto k = static_cast<std::size_t>(32 * i + j);
            return (i * 7 + j * 13) % 100 < spoiled ? noise[k] : (i + j) % 2;
        }));
        EXPECT_LT(score(whole, "Striped"), 0.5) << spoiled;
        EXPECT_LE(whole.value("checks").value(), last + 0.1);
        last = whole.value("checks").value();
    }
}

TEST(Appearance, NothingIsToldWithoutColours) {
    PaintedObject board = quilt(2, {paint(red)}, [](int, int) { return 0; });
    Whole whole(board);
    EXPECT_TRUE(whole.value("share of red"));
    EXPECT_TRUE(tells(whole.object, AppearanceNeed::finish));
    whole.region.colors = nullptr;
    whole.region.asked.clear();
    whole.object.appearance = nullptr;
    for (const Measure& measure : appearance_measures()) EXPECT_FALSE(whole.value(measure.name)) << measure.name;
    EXPECT_FALSE(tells(whole.object, AppearanceNeed::colors));

    Appearance partly;  // a file that tells the colour of some faces and no finish
    partly.corner_colors.assign(board.object.mesh.triangles.size(),
                                {unknown_color(), unknown_color(), unknown_color()});
    partly.corner_colors[0].fill(Color(1, 0, 0));
    whole.object.appearance = std::make_shared<const Appearance>(partly);
    EXPECT_FALSE(whole.value("share of red"));
    EXPECT_FALSE(whole.value("metallic"));
    EXPECT_FALSE(tells(whole.object, AppearanceNeed::finish));
}

TEST(Appearance, HueIsACircle) {
    const auto hue = [](const Rgb& rgb, const char* name) {
        return Whole(quilt(1, {paint(rgb)}, [](int, int) { return 0; })).value(name);
    };
    EXPECT_NEAR(hue({255, 0, 0}, "hue").value(), 29.2, 0.2);
    EXPECT_NEAR(hue({255, 0, 0}, "hue from red").value(), 0, 0.3);
    EXPECT_NEAR(hue({255, 20, 147}, "hue from red").value(), -32, 1);  // deep pink, on the other side of 0
    EXPECT_NEAR(hue({0, 0, 255}, "hue from red").value(), -125, 1);
    EXPECT_FALSE(hue({128, 128, 128}, "hue"));
}

std::vector<std::size_t> sizes(const PaintedObject& painted) {
    Object object = make_object(painted.object.mesh, {});
    EXPECT_EQ(object.candidates.size(), 1U);
    paint(object, appearance_of(painted));
    std::vector<std::size_t> all;
    std::size_t sum = 0;
    for (const PartRegion& part : object.candidates) {
        EXPECT_TRUE(std::ranges::is_sorted(part.region.triangles));
        EXPECT_EQ(part.region.memberships.size(), part.region.triangles.size());
        all.push_back(part.region.triangles.size());
        sum += all.back();
    }
    EXPECT_EQ(sum, painted.object.mesh.triangles.size());
    return all;
}

TEST(SplitByColor, FlushFieldsArePiecesAndPatternsAreNot) {
    const std::vector<Paint> paints = {paint(red), paint(white), paint(blue)};
    const std::size_t count = 12 * 12 * 4 + 12 * 8;
    EXPECT_EQ(sizes(quilt(12, paints, [](int, int) { return 0; })), (std::vector<std::size_t>{count}));
    // A white field in the middle of either side.
    EXPECT_EQ(sizes(quilt(12, paints, [](int i, int j) { return i > 2 && i < 9 && j > 2 && j < 9; })),
              (std::vector<std::size_t>{count - 144, 72, 72}));
    // Three flags of one colour each hang together around the rim, which is red.
    EXPECT_EQ(sizes(quilt(12, paints, [](int i, int) { return i / 4; })).size(), 5U);
    EXPECT_EQ(sizes(quilt(12, paints, [](int i, int) { return i % 2; })).size(), 1U);               // stripes
    EXPECT_EQ(sizes(quilt(12, paints, [](int i, int j) { return (i + j) % 2; })).size(), 1U);       // a chessboard
    EXPECT_EQ(sizes(quilt(12, paints, [](int i, int j) { return i == 3 && j == 4; })).size(), 1U);  // a speck
    std::vector<Paint> close = paints;
    close[1] = paint({225, 25, 30});
    EXPECT_EQ(sizes(quilt(12, close, [](int i, int) { return i < 6; })).size(), 1U);  // hardly another colour
}

}  // namespace
}  // namespace partonomy
