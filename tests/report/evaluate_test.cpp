#include "report/evaluate.h"

#include <gtest/gtest.h>

#include <random>

#include "base/errors.h"
#include "zoo.h"

namespace partonomy {
namespace {

using Names = std::vector<std::string>;

TEST(Evaluate, WorkedByHand) {
    // areas 1 2 3 4; the third is wrong, the fifth has no truth
    const Evaluation e =
        evaluate_labels({"Seat", "Leg", "Leg", "Seat", "Leg"}, {"Seat", "Leg", "Seat", "Seat", "-"}, {1, 2, 3, 4, 9});
    EXPECT_EQ(e.faces, 4);
    EXPECT_DOUBLE_EQ(e.face_accuracy, 0.75);
    EXPECT_DOUBLE_EQ(e.area_accuracy, 0.7);
    EXPECT_DOUBLE_EQ(e.iou.at("Seat"), 5.0 / 8);
    EXPECT_DOUBLE_EQ(e.iou.at("Leg"), 2.0 / 5);
    EXPECT_DOUBLE_EQ(e.confusion.at("Seat").at("Leg"), 0.3);
    EXPECT_DOUBLE_EQ(e.confusion.at("Seat").at("Seat"), 0.5);
    // pairs 1-2 2, 1-3 3*, 1-4 4, 2-3 6*, 2-4 8, 3-4 12*: starred ones disagree, of 35
    EXPECT_DOUBLE_EQ(e.rand_index_error, 21.0 / 35);
}

TEST(Evaluate, PerfectEmptyAndSingle) {
    const Evaluation perfect = evaluate_labels({"a", "b", "a"}, {"a", "b", "a"}, {1, 2, 3});
    EXPECT_EQ(perfect.area_accuracy, 1);
    EXPECT_EQ(perfect.rand_index_error, 0);
    EXPECT_EQ(perfect.iou.at("a"), 1);
    EXPECT_EQ(evaluate_labels({}, {}, {}).faces, 0);
    EXPECT_EQ(evaluate_labels({"a"}, {""}, {1}).faces, 0);
    EXPECT_EQ(evaluate_labels({"b"}, {"a"}, {1}).rand_index_error, 0);
    EXPECT_EQ(evaluate_labels({"a", "b"}, {"a", "a"}, {0, 0}).faces, 0);
    const Evaluation some_without_area = evaluate_labels({"a", "", "b"}, {"a", "a", "a"}, {1, 0, 1});
    EXPECT_EQ(some_without_area.faces, 2);
    EXPECT_EQ(some_without_area.face_accuracy, 0.5);
    EXPECT_THROW((void)evaluate_labels({"a"}, {"a", "b"}, {1, 2}), UsageError);
    EXPECT_THROW((void)evaluate_labels({"a"}, {"a"}, {}), UsageError);
}

TEST(Evaluate, AgreesWithBruteForce) {
    for (unsigned seed = 1; seed <= 60; ++seed) {
        SCOPED_TRACE("seed " + std::to_string(seed));
        std::mt19937 random(seed);
        const std::size_t n = 2 + random() % 60;
        const std::size_t kinds = 1 + random() % 5;
        const Names names{"-", "a", "b", "c", "d", "e"};
        Names labels, truth;
        std::vector<double> areas;
        for (std::size_t i = 0; i < n; ++i) {
            labels.push_back(names[random() % (kinds + 1)]);
            truth.push_back(names[random() % (kinds + 1)]);
            areas.push_back(static_cast<double>(random() % 1000) / 100);
        }
        double all = 0, apart = 0, area = 0, right = 0;
        for (std::size_t i = 0; i < n; ++i) {
            if (truth[i] == "-") continue;
            area += areas[i];
            if (labels[i] == truth[i]) right += areas[i];
            for (std::size_t j = 0; j < i; ++j) {
                if (truth[j] == "-") continue;
                all += areas[i] * areas[j];
                if ((labels[i] == labels[j]) != (truth[i] == truth[j])) apart += areas[i] * areas[j];
            }
        }
        const Evaluation e = evaluate_labels(labels, truth, areas);
        if (all > 0) {
            EXPECT_NEAR(e.rand_index_error, apart / all, 1e-9);
        }
        if (area > 0) {
            EXPECT_NEAR(e.area_accuracy, right / area, 1e-12);
        }
        double whole = 0, diagonal = 0;
        for (const auto& [t, answers] : e.confusion)
            for (const auto& [answer, part] : answers) {
                whole += part;
                if (t == answer) diagonal += part;
            }
        if (area > 0) {
            EXPECT_NEAR(whole, 1, 1e-12);
        }
        EXPECT_NEAR(diagonal, e.area_accuracy, 1e-12);
        for (const auto& [name, iou] : e.iou) {
            double both = 0, either = 0;
            for (std::size_t i = 0; i < n; ++i) {
                if (truth[i] == "-") continue;
                if (truth[i] == name && labels[i] == name) both += areas[i];
                if (truth[i] == name || labels[i] == name) either += areas[i];
            }
            EXPECT_NEAR(iou, both / either, 1e-12) << name;
        }
    }
}

TEST(Evaluate, AreasOfInputFacesAreThoseOfTheirTriangles) {
    const zoo::Annotated object = zoo::bench();
    const std::vector<double> areas = input_face_areas(object.mesh);
    ASSERT_EQ(areas.size(), 24U);
    EXPECT_NEAR(areas[0], 1.2 * 0.4, 1e-12);   // the seat's underside, one quad of two triangles
    EXPECT_NEAR(areas[2], 1.2 * 0.05, 1e-12);  // its front
}

}  // namespace
}  // namespace partonomy
