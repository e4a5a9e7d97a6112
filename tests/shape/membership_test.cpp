#include "shape/membership.h"

#include <gtest/gtest.h>

#include <cmath>

namespace partonomy {
namespace {

constexpr double inf = std::numeric_limits<double>::infinity();

TEST(Trapezoid, RisesStaysAndFalls) {
    const Trapezoid t{1, 2, 4, 8};
    EXPECT_EQ(t(0.5), 0);
    EXPECT_EQ(t(1), 0);
    EXPECT_DOUBLE_EQ(t(1.25), 0.25);
    EXPECT_EQ(t(2), 1);
    EXPECT_EQ(t(3), 1);
    EXPECT_EQ(t(4), 1);
    EXPECT_DOUBLE_EQ(t(7), 0.25);
    EXPECT_EQ(t(8), 0);
    EXPECT_EQ(t(9), 0);
}

TEST(Trapezoid, OpenSides) {
    const Trapezoid up{1.5, 2.5, inf, inf}, down{-inf, -inf, 1.5, 2.5};
    EXPECT_EQ(up(1.5), 0);
    EXPECT_DOUBLE_EQ(up(2), 0.5);
    EXPECT_EQ(up(1e300), 1);
    EXPECT_EQ(up(inf), 1);
    EXPECT_EQ(down(-1e300), 1);
    EXPECT_EQ(down(-inf), 1);
    EXPECT_DOUBLE_EQ(down(2), 0.5);
    EXPECT_EQ(down(inf), 0);
}

TEST(Trapezoid, StepsAndNonsense) {
    const Trapezoid step{1, 1, 2, 2};
    EXPECT_EQ(step(1), 1);
    EXPECT_EQ(step(2), 1);
    EXPECT_EQ(step(0.999), 0);
    EXPECT_EQ(step(std::nan("")), 0);
    EXPECT_TRUE(step.is_ordered());
    EXPECT_FALSE((Trapezoid{2, 1, 3, 4}).is_ordered());
}

}  // namespace
}  // namespace partonomy
