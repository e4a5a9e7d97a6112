/* Kinds of furniture as model libraries have them, each of separate closed boxes that touch: what furniture.ttl must
 * say of a bar stool, of a bed under its cover, of a bedside table … One mesh for each rule that real models asked for.
 */

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "expert/furniture.h"

namespace partonomy {
namespace {

struct Box {
    Vec3 low, high;
};

/// Closed boxes, none of which shares a vertex with another.
TriangleMesh boxes(const std::vector<Box>& all) {
    TriangleMesh mesh;
    for (const Box& box : all) {
        const auto first = static_cast<std::int32_t>(mesh.positions.size());
        for (int k = 0; k < 8; ++k)
            mesh.positions.emplace_back((k & 1 ? box.high : box.low).x(), (k & 2 ? box.high : box.low).y(),
                                        (k & 4 ? box.high : box.low).z());
        for (const auto& [a, b, c, d] : {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
                                         std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}}) {
            mesh.triangles.push_back({first + a, first + b, first + c});
            mesh.triangles.push_back({first + a, first + c, first + d});
        }
    }
    mesh.input_faces.resize(mesh.triangles.size());
    std::iota(mesh.input_faces.begin(), mesh.input_faces.end(), 0);
    mesh.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    return mesh;
}

/// Four legs, `thick` wide, under a rectangle of x by y at height z.
std::vector<Box> on_legs(double x, double y, double z, double thick, std::vector<Box> rest) {
    for (const double left : {0.0, x - thick})
        for (const double front : {0.0, y - thick})
            rest.push_back({Vec3(left, front, 0), Vec3(left + thick, front + thick, z)});
    return rest;
}

struct Kind {
    const char* name;
    const char* object_class;
    std::vector<Box> parts;
};

class FurnitureKinds : public testing::TestWithParam<Kind> {};

TEST_P(FurnitureKinds, AreToldApart) {
    const Annotation annotation = Furniture::get().annotate(boxes(GetParam().parts), {Vec3::UnitZ(), 1.0});
    std::string said;
    for (const std::string& word : annotation.classes) said += word + " ";
    for (const AnnotatedPart& part : annotation.parts) {
        said += "| ";
        for (const std::string& word : part.concepts) said += word + " ";
    }
    EXPECT_TRUE(std::ranges::count(annotation.classes, GetParam().object_class)) << said;
}

INSTANTIATE_TEST_SUITE_P(
    All, FurnitureKinds,
    testing::Values(
        Kind{"BarStool", "Stool", on_legs(0.36, 0.36, 0.74, 0.04, {{Vec3(0, 0, 0.74), Vec3(0.36, 0.36, 0.78)}})},
        Kind{"CoffeeTable", "Table", on_legs(1.2, 0.51, 0.43, 0.03, {{Vec3(0, 0, 0.43), Vec3(1.2, 0.51, 0.48)}})},
        Kind{"BenchWithoutABack", "Bench", on_legs(1.2, 0.4, 0.41, 0.04, {{Vec3(0, 0, 0.41), Vec3(1.2, 0.4, 0.45)}})},
        Kind{
            "BedUnderItsCover", "Bed", {{Vec3(0, 0, 0.05), Vec3(1.6, 2, 0.55)}, {Vec3(0, 2, 0), Vec3(1.6, 2.06, 1.1)}}},
        Kind{"BedsideTable",
             "Table",
             {{Vec3(0, 0, 0), Vec3(0.45, 0.42, 0.46)}, {Vec3(0.03, -0.02, 0.05), Vec3(0.42, 0, 0.4)}}},
        Kind{"FilingCabinet",
             "Shelf",
             {{Vec3(0, 0, 0), Vec3(0.4, 0.52, 0.66)}, {Vec3(0.03, -0.02, 0.05), Vec3(0.37, 0, 0.6)}}},
        Kind{"CoffeeTableOnABody",
             "Table",
             {{Vec3(0.02, 0.02, 0), Vec3(1.18, 0.58, 0.36)}, {Vec3(0, 0, 0.36), Vec3(1.2, 0.6, 0.4)}}},
        Kind{"LowThickTable", "Table", on_legs(2, 1.5, 0.24, 0.2, {{Vec3(0, 0, 0.24), Vec3(2, 1.5, 0.4)}})},
        Kind{"DressingTable", "Table",
             on_legs(0.86, 0.48, 0.73, 0.04,
                     {{Vec3(0, 0, 0.73), Vec3(0.86, 0.48, 0.76)}, {Vec3(0.1, 0.44, 0.76), Vec3(0.76, 0.46, 1.36)}})},
        Kind{"CabinetWithATap",
             "Shelf",
             {{Vec3(0, 0, 0), Vec3(0.6, 0.6, 0.84)},
              {Vec3(0, 0, 0.84), Vec3(0.6, 0.6, 0.88)},
              {Vec3(0.28, 0.5, 0.88), Vec3(0.32, 0.54, 1.2)}}},
        Kind{"ArmchairWithBroadArms", "Chair",
             on_legs(0.8, 0.66, 0.3, 0.05,
                     {{Vec3(0.13, 0, 0.3), Vec3(0.67, 0.6, 0.42)},
                      {Vec3(0, 0.1, 0.45), Vec3(0.13, 0.3, 0.57)},
                      {Vec3(0.67, 0.1, 0.45), Vec3(0.8, 0.3, 0.57)},
                      {Vec3(0.1, 0.6, 0.3), Vec3(0.7, 0.66, 0.95)}})},
        Kind{"SofaWithCushions", "Couch",
             on_legs(1.7, 0.7, 0.08, 0.08,
                     {{Vec3(0.15, 0, 0.08), Vec3(1.55, 0.55, 0.25)},
                      {Vec3(0.15, 0, 0.25), Vec3(0.85, 0.55, 0.42)},
                      {Vec3(0.85, 0, 0.25), Vec3(1.55, 0.55, 0.42)},
                      {Vec3(0.15, 0.25, 0.42), Vec3(0.85, 0.55, 0.95)},
                      {Vec3(0.85, 0.25, 0.42), Vec3(1.55, 0.55, 0.95)},
                      {Vec3(0, 0.55, 0.08), Vec3(1.7, 0.7, 0.75)},
                      {Vec3(0, 0, 0.08), Vec3(0.15, 0.55, 0.6)},
                      {Vec3(1.55, 0, 0.08), Vec3(1.7, 0.55, 0.6)}})},
        Kind{"BenchOfPlanks", "Bench",
             on_legs(1.4, 0.42, 0.37, 0.06,
                     {{Vec3(0, 0, 0.37), Vec3(1.4, 0.13, 0.4)},
                      {Vec3(0, 0.145, 0.37), Vec3(1.4, 0.275, 0.4)},
                      {Vec3(0, 0.29, 0.37), Vec3(1.4, 0.42, 0.4)},
                      {Vec3(0, 0.44, 0.45), Vec3(1.4, 0.47, 0.6)},
                      {Vec3(0, 0.44, 0.65), Vec3(1.4, 0.47, 0.8)}})}),
    [](const auto& kind) { return std::string(kind.param.name); });

/// A chair whose back is `back` between two posts; the names of the parts of the back, as they come.
std::vector<std::string> names_of_back(std::vector<Box> back) {
    std::vector<Box> all = on_legs(0.44, 0.44, 0.42, 0.04, {{Vec3(0, 0, 0.42), Vec3(0.44, 0.44, 0.47)}});
    for (const double left : {0.0, 0.4}) all.push_back({Vec3(left, 0.4, 0.47), Vec3(left + 0.04, 0.44, 0.95)});
    all.insert(all.end(), back.begin(), back.end());
    const Annotation annotation = Furniture::get().annotate(boxes(all));
    EXPECT_TRUE(std::ranges::count(annotation.all_classes, "Chair"));
    std::vector<std::string> names;
    for (std::size_t box = all.size() - back.size(); box < all.size(); ++box)
        names.push_back(annotation.labels[12 * box]);
    return names;
}

TEST(FurnitureParts, ARailBetweenTwoPostsIsOfTheBack) {
    EXPECT_EQ(
        names_of_back({{Vec3(0.04, 0.4, 0.66), Vec3(0.4, 0.44, 0.71)}, {Vec3(0, 0.4, 0.95), Vec3(0.44, 0.44, 1.05)}}),
        (std::vector<std::string>{"Backrest", "Backrest"}));
}

TEST(FurnitureParts, ACrestMayBeABlock) {
    EXPECT_EQ(names_of_back({{Vec3(0.06, 0.28, 0.95), Vec3(0.38, 0.48, 1.14)}}), std::vector<std::string>{"Backrest"});
}

TEST(FurnitureParts, ArmrestsHaveNothingAboveThem) {
    EXPECT_EQ(names_of_back({{Vec3(0, 0.02, 0.64), Vec3(0.04, 0.4, 0.68)},
                             {Vec3(0.4, 0.02, 0.64), Vec3(0.44, 0.4, 0.68)},
                             {Vec3(0.04, 0.4, 0.8), Vec3(0.4, 0.44, 0.95)}}),
              (std::vector<std::string>{"Armrest", "Armrest", "Backrest"}));
}

TEST(FurnitureParts, AColumnOnAFootIsALeg) {
    const Annotation annotation = Furniture::get().annotate(boxes({{Vec3(0.2, 0.2, 0), Vec3(0.7, 0.6, 0.04)},
                                                                   {Vec3(0.4, 0.35, 0.04), Vec3(0.5, 0.45, 0.7)},
                                                                   {Vec3(0, 0, 0.7), Vec3(0.9, 0.8, 0.74)}}));
    EXPECT_TRUE(std::ranges::count(annotation.all_classes, "Table"));
    EXPECT_EQ(annotation.labels[0], "Leg");
    EXPECT_EQ(annotation.labels[12], "Leg");
}

TEST(FurnitureParts, StretchersBelongToTheLegs) {
    for (const double outside : {0.0, 0.1}) {  // legs that lean outward carry their stretchers in the open
        SCOPED_TRACE(outside);
        std::vector<Box> all{{Vec3(0, 0, 0.43), Vec3(0.44, 0.44, 0.47)}, {Vec3(0, 0.42, 0.47), Vec3(0.44, 0.44, 0.9)}};
        const double low = 0.02 - outside, high = 0.38 + outside;
        for (const double x : {low, high})
            for (const double y : {low, high}) all.push_back({Vec3(x, y, 0), Vec3(x + 0.04, y + 0.04, 0.43)});
        const std::size_t legs = all.size();
        for (const double x : {low, high}) all.push_back({Vec3(x + 0.01, low + 0.04, 0.2), Vec3(x + 0.03, high, 0.22)});
        for (const double y : {low, high}) all.push_back({Vec3(low + 0.04, y + 0.01, 0.3), Vec3(high, y + 0.03, 0.33)});
        const Annotation annotation = Furniture::get().annotate(boxes(all));
        EXPECT_EQ(annotation.classes, std::vector<std::string>{"Chair"});
        for (std::size_t box = legs; box < all.size(); ++box) EXPECT_EQ(annotation.labels[12 * box], "Leg") << box;
    }
}

TEST(FurnitureParts, LeaningRailsAreNoArmrests) {
    // No rail is below another one: the back leans.
    EXPECT_EQ(names_of_back({{Vec3(0.04, 0.40, 0.58), Vec3(0.4, 0.42, 0.66)},
                             {Vec3(0.04, 0.43, 0.72), Vec3(0.4, 0.45, 0.8)},
                             {Vec3(0.04, 0.46, 0.86), Vec3(0.4, 0.48, 0.95)}}),
              (std::vector<std::string>{"Backrest", "Backrest", "Backrest"}));
}

TEST(FurnitureParts, SlatsBelowACrestCarryIt) {
    EXPECT_EQ(names_of_back({{Vec3(0.1, 0.41, 0.47), Vec3(0.16, 0.43, 0.82)},
                             {Vec3(0.28, 0.41, 0.47), Vec3(0.34, 0.43, 0.82)},
                             {Vec3(0.04, 0.41, 0.82), Vec3(0.4, 0.43, 0.95)}}),
              (std::vector<std::string>{"BackPost", "BackPost", "Backrest"}));
}

}  // namespace
}  // namespace partonomy
