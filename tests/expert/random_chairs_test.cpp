/* Chairs with backs of every kind, of random sizes, as one closed surface each: what furniture.ttl calls their parts.
 */

#include <gtest/gtest.h>

#include "expert/furniture.h"
#include "shape/shapes.h"

namespace partonomy {
namespace {

struct NamedChair {
    shapes::Labelled surface;
    std::vector<std::string> names;  ///< of the parts
};

enum class Back { panel, crest, ladder, slats };

/// z up, in metres; the back leans.
NamedChair random_chair(Back kind, std::mt19937& random) {
    const auto between = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    const double width = between(0.38, 0.5), depth = between(0.38, 0.48), seat = between(0.4, 0.48);
    const double top = seat + between(0.4, 0.55), board = between(0.03, 0.05), leg = between(0.035, 0.05);
    const double inset = between(0, 0.02), thin = between(0.5, 0.8) * leg;
    NamedChair chair;
    std::vector<shapes::Block> blocks;
    const auto add = [&](const std::string& name, const Vec3& low, const Vec3& high) {
        blocks.push_back({low, high, static_cast<int>(chair.names.size())});
        chair.names.push_back(name);
    };
    for (const double x : {inset, width - inset - leg})
        for (const double y : {inset, depth - inset - leg}) add("Leg", {x, y, 0}, {x + leg, y + leg, seat - board});
    add("Seat", {0, 0, seat - board}, {width, depth, seat});
    if (between(0, 1) < 0.5) {  // stretchers from leg to leg
        const double low = between(0.2, 0.6) * seat, thick = between(0.4, 0.7) * leg,
                     middle = inset + (leg - thick) / 2;
        for (const double x : {middle, width - middle - thick})
            add("Leg", {x, inset + leg, low}, {x + thick, depth - inset - leg, low + thick});
        for (const double y : {middle, depth - middle - thick})
            add("Leg", {inset + leg, y, low + 1.5 * thick}, {width - inset - leg, y + thick, low + 2.5 * thick});
    }
    const double front = depth - inset - leg, back = depth - inset;  // of the posts
    const double left = inset + leg, right = width - inset - leg;    // between them
    const auto across = [&](double low, double high) {
        add("Backrest", {left, back - thin, low}, {right, back, high});
    };
    if (kind == Back::panel) {
        add("Backrest", {inset, back - thin, seat}, {width - inset, back, top});
    } else {
        for (const double x : {inset, right}) add("BackPost", {x, front, seat}, {x + leg, back, top});
    }
    const double height = top - seat;
    if (kind == Back::crest) across(top - between(0.25, 0.5) * height, top - 0.02);
    if (kind == Back::ladder) {
        const int rails = std::uniform_int_distribution(2, 3)(random);
        const double step = height / rails, rail = between(0.35, 0.55) * step;
        for (int i = 1; i <= rails; ++i) across(seat + i * step - rail - 0.02, seat + i * step - 0.02);
    }
    if (kind == Back::slats) {
        const double crest = top - between(0.2, 0.3) * height;
        const int slats = std::uniform_int_distribution(2, 4)(random);
        const double step = (right - left) / (slats + 0.5), slat = between(0.4, 0.5) * step;
        for (int i = 0; i < slats; ++i) {
            const double x = left + (i + 0.5) * step;
            add("BackPost", {x, back - thin, seat}, {x + slat, back, crest});
        }
        across(crest, top - 0.02);
    }
    chair.surface = shapes::join(blocks, 0.015);
    const double slope = between(0, 0.2);
    for (Vec3& point : chair.surface.mesh.positions) point.y() += slope * std::max(0.0, point.z() - seat);
    return chair;
}

class RandomChairs : public testing::TestWithParam<Back> {};

TEST_P(RandomChairs, HaveTheirPartsNamed) {
    std::mt19937 random(61 + static_cast<unsigned>(GetParam()));
    double sum = 0;
    constexpr int chairs = 8;
    for (int n = 0; n < chairs; ++n) {
        SCOPED_TRACE("seed " + std::to_string(61 + static_cast<int>(GetParam())) + ", chair " + std::to_string(n));
        const NamedChair chair = random_chair(GetParam(), random);
        const Annotation annotation = Furniture::get().annotate(chair.surface.mesh);
        const std::vector<double> areas = compute_geometry(chair.surface.mesh).areas;
        EXPECT_EQ(annotation.classes, std::vector<std::string>{"Chair"});
        double right = 0, all = 0;
        for (std::size_t t = 0; t < annotation.labels.size(); ++t) {
            all += areas[t];
            if (annotation.labels[t] == chair.names[static_cast<std::size_t>(chair.surface.parts[t])])
                right += areas[t];
        }
        EXPECT_GT(right / all, 0.8);
        sum += right / all;
    }
    EXPECT_GT(sum / chairs, GetParam() == Back::slats ? 0.92 : 0.97);  // slats may stay with their rail
}

std::string name_of(const testing::TestParamInfo<Back>& back) {
    return std::array{"Panel", "Crest", "Ladder", "Slats"}[static_cast<std::size_t>(back.param)];
}

INSTANTIATE_TEST_SUITE_P(Backs, RandomChairs, testing::Values(Back::panel, Back::crest, Back::ladder, Back::slats),
                         name_of);

}  // namespace
}  // namespace partonomy
