#include <gtest/gtest.h>
#include <unistd.h>

#include "base/errors.h"
#include "base/files.h"
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
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1) << "a temporary file was left";
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

TEST(Spelling, Distance) {
    EXPECT_EQ(edit_distance("", ""), 0U);
    EXPECT_EQ(edit_distance("seat", ""), 4U);
    EXPECT_EQ(edit_distance("inclinatoin", "inclination"), 2U);
    EXPECT_EQ(edit_distance("leg", "legs"), 1U);
    EXPECT_EQ(edit_distance("kitten", "sitting"), edit_distance("sitting", "kitten"));
}

}  // namespace
}  // namespace partonomy
