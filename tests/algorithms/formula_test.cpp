#include "algorithms/formula.h"

#include <gtest/gtest.h>

#include "base/errors.h"

namespace partonomy {
namespace {

/// An object from 1 to 3 with a region of 4 x 2 x 0.5 from 1.5 to 2, in units of `metres` each.
struct Case {
    Object object;
    RegionMeasurements region;
    explicit Case(std::optional<double> metres = 1.0) {
        object.low = 1;
        object.high = 3;
        object.placement.metres_per_unit = metres;
        region.lengths = Vec3(4, 2, 0.5);
        region.low = 1.5;
        region.high = 2;
        region.area = 3;
        region.inclination = 30;
    }
    [[nodiscard]] std::optional<double> value(const std::string& text) const {
        return evaluate(parse_formula(text), object, region);
    }
};

std::string error_of(const std::string& text) {
    try {
        static_cast<void>(parse_formula(text));
    } catch (const OntologyError& error) {
        return error.what();
    }
    ADD_FAILURE() << text << " was accepted";
    return {};
}

void expect_error(const std::string& text, const std::string& words) {
    EXPECT_NE(error_of(text).find(words), std::string::npos) << error_of(text);
}

TEST(Formula, SumsDifferencesProductsAndRatios) {
    const Case c;
    EXPECT_DOUBLE_EQ(*c.value("top height"), 1);
    EXPECT_DOUBLE_EQ(*c.value("top height - bottom height"), 0.5);
    EXPECT_DOUBLE_EQ(*c.value("top height-bottom height"), 0.5);
    EXPECT_DOUBLE_EQ(*c.value("area / l0"), 0.75);
    EXPECT_DOUBLE_EQ(*c.value("length * width + area"), 11);
    EXPECT_DOUBLE_EQ(*c.value("2 * (length + width) / thickness"), 24);
    EXPECT_DOUBLE_EQ(*c.value("-length + width - 1"), -3);
    EXPECT_DOUBLE_EQ(*c.value("8 / 4 / 2"), 1);
    EXPECT_DOUBLE_EQ(*c.value("8 - 4 - 2"), 2);
    EXPECT_DOUBLE_EQ(*c.value("1e-1 * 2"), 0.2);
}

/// The sign in "l0/l1" belongs to the name; with blanks it is an operation, and the value the same.
TEST(Formula, NamesWithSignsInThem) {
    const Case c;
    EXPECT_EQ(parse_formula("l0/l1").steps.size(), 1U);
    EXPECT_EQ(parse_formula("l0 / l1").steps.size(), 3U);
    for (const char* text : {"l0/l1", "l0 / l1", "length/width", "l0/l1*l1/l2/(l1/l2)"})
        EXPECT_DOUBLE_EQ(*c.value(text), 2) << text;
}

TEST(Formula, UnitsAreThoseOfTheResult) {
    EXPECT_EQ(parse_formula("top height - bottom height").unit, "m");
    EXPECT_EQ(parse_formula("area * length").unit, "m3");
    EXPECT_EQ(parse_formula("length / area").unit, "1/m");
    EXPECT_EQ(parse_formula("inclination / length").unit, "degrees/m");
    EXPECT_EQ(parse_formula("length / width").unit, "1");
    EXPECT_EQ(parse_formula("length + 0.1").unit, "m");
}

TEST(Formula, RatiosOfLengthsNeedNoUnit) {
    const Case unknown(std::nullopt), centimetres(0.01);
    EXPECT_DOUBLE_EQ(*unknown.value("length / width"), 2);
    EXPECT_DOUBLE_EQ(*centimetres.value("length / width"), 2);
    EXPECT_DOUBLE_EQ(*unknown.value("inclination - 10"), 20);
    EXPECT_EQ(unknown.value("length - width"), std::nullopt);
    EXPECT_EQ(unknown.value("area / length"), std::nullopt);
    EXPECT_EQ(unknown.value("(length - 0.01) / width"), std::nullopt);  // 0.01 m
    EXPECT_DOUBLE_EQ(*centimetres.value("(length - 0.01) / width"), 1.5);
    EXPECT_DOUBLE_EQ(*centimetres.value("area"), 3e-4);
}

TEST(Formula, DividingByNothingTellsNothing) {
    const Case c;
    EXPECT_EQ(c.value("length / (width - 2)"), std::nullopt);
    EXPECT_EQ(c.value("1 / 0"), std::nullopt);
}

TEST(Formula, WhatWasCombinedIsKept) {
    const Case c;
    EXPECT_TRUE(c.region.asked.empty());
    static_cast<void>(c.value("top height - bottom height"));
    EXPECT_DOUBLE_EQ(c.region.asked.at("top height - bottom height"), 0.5);
}

TEST(Formula, ErrorsNameWhatIsWrong) {
    expect_error("top heigth - bottom height", "no measure \"top heigth\"; did you mean \"top height\"?");
    expect_error("gap", "\"gap\" is measured between 2 regions");
    expect_error("inclinatoin", "did you mean \"inclination\"?");
    expect_error("l0/l3", "did you mean \"l0/l1\" or \"l0/l2\"");
    // A hyphen for a blank, alone and within a combination.
    expect_error("length-share", "did you mean \"length share\"?");
    expect_error("2 * length-share / extent", "did you mean \"length share\"?");
    // A name that begins with another: a missing sign only where what follows is a measure, too.
    expect_error("length inclinaton",
                 "there is no measure \"length inclinaton\"; did you mean \"length inclination\"?");
    expect_error("90 - length inclinaton",
                 "there is no measure \"length inclinaton\"; did you mean \"length inclination\"?");
    expect_error("(length  inclinaton ) / 2", "did you mean \"length inclination\"?");
    expect_error("length Inclination", "did you mean \"length inclination\"?");
    expect_error("length width", "there should be + - * / before \"width\"");
    expect_error("length widht", "there should be + - * / before \"widht\"");
    expect_error("(length width", "a ) is missing");
    expect_error("length 2", "there should be + - * / before \"2\"");
    expect_error("Level_Height", "did you mean \"level height\"?");
    expect_error("top height - inclination", "it subtracts m and degrees");
    expect_error("area + length", "it adds m2 and m");
    expect_error("length + l0/l1", "it adds m and 1");
    expect_error("length -", "ends where a measure or a number should stand");
    expect_error("", "ends where a measure or a number should stand");
    expect_error("length * * 2", "should stand before \"* 2\"");
    expect_error("(length + width", "a ) is missing");
    expect_error("length) + width", "there should be + - * / before \")");
    expect_error("length 2", "there should be + - * / before \"2\"");
    expect_error("nan", "no measure \"nan\"");
    expect_error(std::string(1000, '('), "nested too deeply");
}

}  // namespace
}  // namespace partonomy
