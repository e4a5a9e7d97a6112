#include <algorithm>
#include <random>

#include "algorithms/concept_shapes.h"
#include "algorithms/quilt.h"

namespace partonomy {
namespace {

const Rgb white{250, 250, 250}, red{220, 20, 30};

KnownShape known(const std::string& name, PaintedObject painted, std::vector<std::string> is,
                 std::vector<std::string> border = {}) {
    return {name, painted.object.mesh, std::move(is), std::move(border), 0, appearance_of(painted)};
}

PaintedObject plain(const Rgb& rgb, double metallic = 0, double roughness = 0.9) {
    return quilt(2, {paint(rgb, metallic, roughness)}, [](int, int) { return 0; });
}

/// The first paint on half of the surface: four columns of ten, and the rim.
PaintedObject halves(const Rgb& one, const Rgb& other) {
    return quilt(10, {paint(one), paint(other)}, [](int i, int) { return i < 4 ? 0 : 1; });
}

Rgb grey(int level) {
    const auto byte = static_cast<std::uint8_t>(level);
    return {byte, byte, byte};
}

}  // namespace

std::vector<KnownShape> shapes_by_paint() {
    std::vector<KnownShape> all;
    const std::vector<std::pair<std::string, Rgb>> colors{
        {"Black", {10, 10, 10}},   {"Grey", {128, 128, 128}}, {"White", {250, 250, 250}}, {"Red", {220, 20, 30}},
        {"Orange", {255, 140, 0}}, {"Yellow", {250, 215, 0}}, {"Green", {0, 140, 60}},    {"Blue", {0, 70, 170}},
        {"Purple", {128, 0, 128}}, {"Pink", {255, 150, 190}}, {"Brown", {120, 70, 30}}};
    for (std::size_t i = 0; i < colors.size(); ++i) {
        const auto& [name, rgb] = colors[i];
        const auto& [next, other] = colors[(i + 1) % colors.size()];
        all.push_back(known(name, plain(rgb), {name, "UniformColour", "PlainTexture", "Matte"}));
        all.push_back(known(name + " and " + next, halves(rgb, other), {"VariedColour"}, {name, next}));
    }
    all.push_back(known("dark", plain({20, 20, 60}), {"Dark"}));
    all.push_back(known("medium and neutral", plain(grey(120)), {"Medium", "Neutral"}));
    all.push_back(known("bright", plain({240, 230, 200}), {"Bright"}));
    all.push_back(known("muted", plain({140, 110, 110}), {"Muted"}));
    all.push_back(known("vivid", plain({220, 20, 30}), {"Vivid"}));
    all.push_back(known("dark grey", plain(grey(85)), {}, {"Dark", "Medium"}));      // lightness 0.45
    all.push_back(known("light grey", plain(grey(189)), {}, {"Medium", "Bright"}));  // lightness 0.8
    all.push_back(known("hardly red", plain({150, 130, 130}), {}, {"Neutral", "Muted"}));
    all.push_back(known("rather red", plain({170, 90, 90}), {}, {"Muted", "Vivid"}));
    all.push_back(known("two greys", halves(grey(120), grey(146)), {"Neutral"}, {"UniformColour", "VariedColour"}));

    all.push_back(known("polished metal", plain(white, 1, 0.2), {"Metallic"}));
    all.push_back(known("raw metal", plain(white, 1, 0.9), {"Metallic"}));
    all.push_back(known("lacquer", plain(white, 0, 0.2), {"Glossy"}));
    all.push_back(known("plaster", plain(white, 0, 0.9), {"Matte"}));
    all.push_back(known("half a metal, smooth", plain(white, 0.5, 0.2), {}, {"Metallic", "Glossy"}));
    all.push_back(known("half a metal, rough", plain(white, 0.5, 0.9), {}, {"Metallic", "Matte"}));
    all.push_back(known("silk", plain(white, 0, 0.45), {}, {"Glossy", "Matte"}));

    const auto striped = [](const Rgb& one, const Rgb& other) {
        return pictured_board(128, [=](int x, int) { return x / 8 % 2 ? one : other; });
    };
    all.push_back(known("stripes", striped(red, white), {"Striped", "VariedColour"}));
    all.push_back(
        known("stripes that are hardly seen", striped(grey(120), grey(146)), {}, {"PlainTexture", "Striped"}));
    all.push_back(known("chessboard",
                        pictured_board(128, [](int x, int y) { return (x / 8 + y / 8) % 2 ? red : white; }),
                        {"Checked", "VariedColour"}));
    // A field of grain: the first so many of a hundred fields are drawn, the others those of a chessboard.
    const auto spoiled = [](int drawn, int size) {
        std::mt19937 random(7);
        std::vector<int> draws(64 * 64);
        for (int& draw : draws) draw = static_cast<int>(random() % 200);
        return pictured_board(64, [=](int x, int y) {
            const int field = draws[static_cast<std::size_t>(64 * (y / size) + x / size)];
            const bool is_red = field / 2 < drawn ? field % 2 == 0 : (x / size + y / size) % 2 == 0;
            return is_red ? red : white;
        });
    };
    all.push_back(known("grain", spoiled(100, 2), {"Noisy", "VariedColour"}));
    all.push_back(known("chessboard that is spoiled", spoiled(38, 2), {}, {"Checked", "Noisy"}));
    return all;
}

}  // namespace partonomy
