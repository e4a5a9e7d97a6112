#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "base/errors.h"
#include "base/files.h"
#include "report/evaluate.h"
#include "report/write.h"
#include "zoo.h"

namespace partonomy {
namespace {

using Names = std::vector<std::string>;

class ReadTruth : public testing::Test {
protected:
    ~ReadTruth() override { std::filesystem::remove(path_); }

    Names read(const std::string& bytes, std::int64_t faces, const std::map<std::string, std::string>& names = {}) {
        write_file(path_, bytes);
        return read_truth(path_, faces, names);
    }

    /// The sentence of the error that reading gives, without the file's name.
    std::string error(const std::string& bytes, std::int64_t faces) {
        try {
            (void)read(bytes, faces);
        } catch (const UsageError& e) {
            const std::string text = e.what();
            EXPECT_TRUE(text.starts_with(path_)) << text;
            return text.substr(path_.size());
        }
        return "no error";
    }

    std::string path_ = testing::TempDir() + "partonomy_truth_" + std::to_string(::getpid());
};

TEST_F(ReadTruth, NameALine) {
    EXPECT_EQ(read("Seat\nLeg\n-\n", 3), (Names{"Seat", "Leg", "-"}));
    EXPECT_EQ(read("\xEF\xBB\xBFSeat\r\nLeg\r\n-", 3, {{"Leg", "Foot"}}), (Names{"Seat", "Foot", "-"}));
    EXPECT_EQ(read("a", 1), (Names{"a"}));
    EXPECT_NE(error("Seat\nLeg\n", 3).find("2 lines of truth, one a face, but the mesh has 3 faces"),
              std::string::npos);
    EXPECT_NE(error("", 3).find("is empty"), std::string::npos);
    EXPECT_THROW((void)read_truth(path_ + "-is-not-there", 3), FileError);
}

TEST_F(ReadTruth, SegmentNumberALine) {
    EXPECT_EQ(read("0\n1\n10\n1\n", 4, {{"10", "Leg"}}), (Names{"0", "1", "Leg", "1"}));
    EXPECT_NE(error("0\n1\n", 4), "no error");
}

TEST_F(ReadTruth, LabeledPsb) {
    const std::string text = "support\r\n1 3 \r\n\r\nleg\r\n2 5\r\n";
    EXPECT_EQ(read(text, 5, {{"support", "Seat"}}), (Names{"Seat", "leg", "Seat", "", "leg"}));
    EXPECT_NE(error(text, 4).find(":5: face 5 is not one of the mesh's faces 1 to 4"), std::string::npos);
    EXPECT_NE(error("a\n0\n", 4).find(":2: face 0"), std::string::npos);
    EXPECT_NE(error("a\n1 2\nb\n2\n", 4).find(":4: face 2 is given to b, but it was given to a before"),
              std::string::npos);
    EXPECT_NE(error("a\n99999999999999999999999\n", 4).find(":2: face 9999"), std::string::npos);
}

TEST_F(ReadTruth, ByteAFace) {
    EXPECT_EQ(read(std::string("\0\1\2\1", 4), 4, {{"2", "Stick"}}), (Names{"0", "1", "Stick", "1"}));
}

TEST_F(ReadTruth, Ply) {
    const std::string ascii =
        "ply\r\nformat ascii 1.0\r\nelement vertex 1\r\nproperty float x\r\nelement face 2\r\n"
        "property list uchar int vertex_indices\r\nproperty uchar label\r\nend_header\r\n0.5\r\n3 0 0 0 7\r\n4 0 0 0 0 "
        "9\r\n";
    EXPECT_EQ(read(ascii, 2, {{"7", "Leg"}}), (Names{"Leg", "9"}));
    EXPECT_NE(error(ascii, 3).find("2 labelled faces, but the mesh has 3 faces"), std::string::npos);
    EXPECT_NE(error(ascii.substr(0, ascii.size() - 4), 2).find("the data end at face 1 of 2"), std::string::npos);
    EXPECT_NE(
        error("ply\nformat ascii 1.0\nelement face 1\nproperty float label\nend_header\n1\n", 1).find("integer type"),
        std::string::npos);
    EXPECT_NE(error("ply\nformat ascii 1.0\n", 1).find("no end_header"), std::string::npos);
    std::string big = "ply\nformat binary_big_endian 1.0\nelement face 2\nproperty int label\nend_header\n";
    big += std::string("\0\0\1\2\xFF\xFF\xFF\xFF", 8);
    EXPECT_EQ(read(big, 2), (Names{"258", "-1"}));
    EXPECT_NE(error("ply\nformat ascii 1.0\nelement face 99999999999\nproperty int label\nend_header\n1\n", 1)
                  .find("data end"),
              std::string::npos);
}

TEST_F(ReadTruth, OurOwnOutputsAreTruthAgain) {
    const zoo::Annotated object = zoo::broken_bench();
    EXPECT_EQ(read(to_labels(object.annotation), 30), object.annotation.labels);
    EXPECT_EQ(read(to_ply(object.mesh, object.annotation), 30), object.annotation.labels);
}

TEST(SharedTruth, EveryBenchmarkFileIsRead) {
    const std::filesystem::path data = PARTONOMY_SHARED_DATA;
    if (!std::filesystem::exists(data / "lpsb")) GTEST_SKIP() << "no test data at " << data;
    const auto faces_of = [](const std::filesystem::path& off) {
        std::ifstream file(off);
        std::string word;
        std::int64_t vertices = 0, faces = 0;
        file >> word >> vertices >> faces;
        return faces;
    };
    int files = 0;
    for (const char* kind : {"chair", "table"})
        for (const auto& entry : std::filesystem::directory_iterator(data / "lpsb" / kind)) {
            if (entry.path().extension() != ".off") continue;
            const std::string stem = entry.path().stem();
            const auto truth = read_truth(entry.path().parent_path() / (stem + "_labels.txt"), faces_of(entry.path()),
                                          {{"support", "Seat"}});
            EXPECT_EQ(std::ranges::count(truth, ""), 0) << stem;
            EXPECT_GT(std::ranges::count(truth, "Seat"), 100) << stem;
            ++files;
        }
    EXPECT_EQ(files, 20);
    const auto lab = read_truth(data / "fig16" / "fig16_75k.lab", 75520, {{"3", "Stick"}});
    EXPECT_GT(std::ranges::count(lab, "Stick"), 1000);
}

}  // namespace
}  // namespace partonomy
