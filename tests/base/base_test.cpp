#include <gtest/gtest.h>
#include <unistd.h>

#include <random>

#include "base/errors.h"
#include "base/files.h"
#include "base/quantile.h"
#include "base/spelling.h"

namespace partonomy {
namespace {

namespace fs = std::filesystem;

TEST(Errors, NameThePlace) {
    EXPECT_EQ(at("a.off", 7, "is wrong"), "a.off:7: is wrong");
    EXPECT_EQ(at("a.off", 0, "is wrong"), "a.off: is wrong");
}

TEST(Files, RoundTripAndReplace) {
    const fs::path folder = fs::temp_directory_path() / ("partonomy-base-" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const std::string bytes("a\0b\r\n\xff", 6);
    write_file(folder / "f", "old and longer");
    write_file(folder / "f", bytes);
    EXPECT_EQ(read_file(folder / "f"), bytes);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1)
        << "a temporary file was left";
    EXPECT_THROW(static_cast<void>(read_file(folder)), FileError);
    EXPECT_THROW(static_cast<void>(read_file(folder / "none")), FileError);
    EXPECT_THROW(write_file(folder / "none" / "f", "x"), FileError);
    fs::remove_all(folder);
}

/// Test vectors of FIPS 180-4.
TEST(Files, Sha256) {
    EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
    EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
}

/// Beside a sorted list that is gone through; weights are whole, so that sums are exact.
TEST(Quantile, AsInASortedList) {
    std::mt19937 random(7);
    const auto up_to = [&](int most) { return std::uniform_int_distribution(0, most)(random); };
    for (int round = 0; round < 2000; ++round) {
        std::vector<Weighted> values(static_cast<std::size_t>(1 + up_to(40)));
        for (auto& [value, weight] : values) value = up_to(15), weight = up_to(3);
        std::vector<Weighted> sorted = values;
        std::ranges::sort(sorted);
        double total = 0, sum = 0;
        for (const auto& [value, weight] : sorted) total += weight;
        const double share = up_to(8) / 8.0;
        double expected = sorted.back().first;
        for (const auto& [value, weight] : sorted)
            if ((sum += weight) >= share * total) {
                expected = value;
                break;
            }
        EXPECT_EQ(quantile(values, share), expected) << "round " << round;
    }
}

TEST(Spelling, Distance) {
    EXPECT_EQ(edit_distance("", ""), 0U);
    EXPECT_EQ(edit_distance("seat", ""), 4U);
    EXPECT_EQ(edit_distance("inclinatoin", "inclination"), 2U);
    EXPECT_EQ(edit_distance("leg", "legs"), 1U);
    EXPECT_EQ(edit_distance("kitten", "sitting"), edit_distance("sitting", "kitten"));
}

TEST(Spelling, DidYouMean) {
    const std::vector<std::string> names{"length share", "area share", "l0/l1", "l0/l2", "length"};
    EXPECT_EQ(did_you_mean({"area shar"}, names), "; did you mean \"area share\"?");
    EXPECT_EQ(did_you_mean({"share", "length-share"}, names), "; did you mean \"length share\"?");
    EXPECT_EQ(did_you_mean({"AreaShare"}, names), "; did you mean \"area share\"?");
    EXPECT_EQ(did_you_mean({"l0/l3"}, names), "; did you mean \"l0/l1\" or \"l0/l2\"?");
    EXPECT_EQ(did_you_mean({"weight of it all"}, names), "");
    EXPECT_NE(did_you_mean({"weight of it all"}, names, Nearness::any), "");
    EXPECT_EQ(did_you_mean({""}, names), "");
    EXPECT_EQ(did_you_mean({"x"}, {}), "");
    std::vector<std::string> many{std::string(100, 'a') + "b", std::string(1'000'000, 'a')};
    many.resize(50'000, std::string(100, 'b'));  // all of them would take minutes
    EXPECT_EQ(did_you_mean({std::string(101, 'a')}, many), "; did you mean \"" + many.front() + "\"?");
    EXPECT_TRUE(is_spelled_alike("length-share", "Length_share"));
    EXPECT_FALSE(is_spelled_alike("length", "lengths"));
}

}  // namespace
}  // namespace partonomy
