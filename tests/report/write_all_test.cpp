#include "report/write_all.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <csignal>
#include <filesystem>

#include "base/errors.h"
#include "base/files.h"
#include "report/write.h"
#include "zoo.h"

namespace partonomy {
namespace {

namespace fs = std::filesystem;

const std::set<std::string> everything{"labels", "json", "ply", "glb", "png", "trace"};

class WriteOutputs : public testing::Test {
protected:
    void SetUp() override {
        fs::remove_all(base_);
        fs::create_directories(base_);
    }
    ~WriteOutputs() override { fs::remove_all(base_); }

    void write(const fs::path& folder, const std::set<std::string>& formats = everything) {
        write_outputs(folder, formats, object_.mesh, object_.annotation, Vec3::UnitZ(), {.threads = 2});
    }

    std::string error(const fs::path& folder, const std::set<std::string>& formats = everything) {
        try {
            write(folder, formats);
        } catch (const FileError& e) {
            return e.what();
        }
        return "no error";
    }

    static std::set<std::string> names_in(const fs::path& folder) {
        std::set<std::string> names;
        for (const auto& entry : fs::directory_iterator(folder)) names.insert(entry.path().filename());
        return names;
    }

    fs::path base_ = fs::path(testing::TempDir()) / ("partonomy_write_" + std::to_string(::getpid()));
    zoo::Annotated object_ = zoo::bench();
};

TEST_F(WriteOutputs, MakesTheFolderWithEveryFormat) {
    const fs::path folder = base_ / "a" / "b" / "bench";
    write(folder);
    EXPECT_EQ(names_in(folder), (std::set<std::string>{"labels.txt", "annotation.json", "annotation.ply",
                                                       "annotation.glb", "preview.png", "trace.txt"}));
    EXPECT_EQ(names_in(base_ / "a" / "b"), (std::set<std::string>{"bench"})) << "nothing temporary is left";
    EXPECT_EQ(read_file(folder / "labels.txt"), to_labels(object_.annotation));
    EXPECT_EQ(read_file(folder / "annotation.json"), to_json(object_.annotation));
    EXPECT_EQ(read_file(folder / "annotation.ply"), to_ply(object_.mesh, object_.annotation));
    EXPECT_EQ(read_file(folder / "annotation.glb"), to_glb(object_.mesh, object_.annotation, Vec3::UnitZ()));
    EXPECT_EQ(read_file(folder / "preview.png"), to_png(object_.mesh, object_.annotation, Vec3::UnitZ()));
    EXPECT_EQ(read_file(folder / "trace.txt"), to_trace(object_.annotation));
}

TEST_F(WriteOutputs, ReplacesItsOwnFilesAndLeavesOthersAlone) {
    const fs::path folder = base_ / "bench";
    fs::create_directories(folder / "sub");
    write_file(folder / "notes.txt", "mine");
    write_file(folder / "labels.txt", "old");
    write_file(folder / "trace.txt", "old");
    write(fs::path(folder.string() + "/"), {"labels", "json"});
    EXPECT_EQ(names_in(folder),
              (std::set<std::string>{"labels.txt", "annotation.json", "notes.txt", "trace.txt", "sub"}));
    EXPECT_EQ(read_file(folder / "notes.txt"), "mine");
    EXPECT_EQ(read_file(folder / "trace.txt"), "old");
    EXPECT_EQ(read_file(folder / "labels.txt"), to_labels(object_.annotation));
}

TEST_F(WriteOutputs, WorksThroughALinkAndInTheCurrentFolder) {
    fs::create_directories(base_ / "real");
    fs::create_directory_symlink(base_ / "real", base_ / "link");
    write(base_ / "link", {"labels"});
    EXPECT_TRUE(fs::exists(base_ / "real" / "labels.txt"));
    EXPECT_TRUE(fs::is_symlink(base_ / "link"));
    const fs::path before = fs::current_path();
    fs::current_path(base_);
    write("fresh", {"labels"});
    write(".", {"trace"});
    fs::current_path(before);
    EXPECT_TRUE(fs::exists(base_ / "fresh" / "labels.txt"));
    EXPECT_TRUE(fs::exists(base_ / "trace.txt"));
}

TEST_F(WriteOutputs, UnknownFormatListsTheKnownOnes) {
    try {
        write(base_ / "x", {"labels", "docx"});
        FAIL() << "no error";
    } catch (const UsageError& e) {
        EXPECT_STREQ(e.what(),
                     "\"docx\" is not a format that can be written; known are glb, json, labels, ply, png, trace");
    }
    EXPECT_FALSE(fs::exists(base_ / "x"));
    EXPECT_EQ(output_formats().size(), everything.size());
    EXPECT_THROW(write(""), UsageError);
}

TEST_F(WriteOutputs, AFileInThePlaceOfTheFolder) {
    write_file(base_ / "bench", "a file");
    EXPECT_NE(error(base_ / "bench").find("bench: cannot be written: it is a file, and a folder is needed"),
              std::string::npos);
    EXPECT_NE(error(base_ / "bench" / "deeper").find("cannot be written"), std::string::npos);
    EXPECT_EQ(read_file(base_ / "bench"), "a file");
    EXPECT_EQ(names_in(base_), (std::set<std::string>{"bench"}));
}

TEST_F(WriteOutputs, AFolderInThePlaceOfAFileLeavesTheOldResults) {
    const fs::path folder = base_ / "bench";
    fs::create_directories(folder / "trace.txt");
    write_file(folder / "annotation.json", "old");
    EXPECT_NE(error(folder).find("trace.txt: cannot be written: a folder is in its place"), std::string::npos);
    EXPECT_EQ(names_in(folder), (std::set<std::string>{"annotation.json", "trace.txt"}));
    EXPECT_EQ(read_file(folder / "annotation.json"), "old");
}

TEST_F(WriteOutputs, WhereNoFolderCanBe) {
    EXPECT_NE(error("/proc/partonomy/bench").find("cannot be written"), std::string::npos);
}

TEST_F(WriteOutputs, AFolderThatIsReadOnly) {
    if (::geteuid() == 0) GTEST_SKIP() << "the superuser may write everywhere; this test needs another user";
    const fs::path folder = base_ / "bench";
    fs::create_directories(folder);
    write_file(folder / "labels.txt", "old");
    fs::permissions(folder, fs::perms::owner_read | fs::perms::owner_exec);
    const std::string sentence = error(folder);
    fs::permissions(folder, fs::perms::owner_all);
    EXPECT_NE(sentence.find("Permission denied"), std::string::npos);
    EXPECT_EQ(read_file(folder / "labels.txt"), "old");
}

/// While it lives, no file can grow beyond `bytes`: what a full disk looks like to a writer.
class FullDisk {
public:
    explicit FullDisk(rlim_t bytes) : old_handler_(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &old_);
        rlimit limit = old_;
        limit.rlim_cur = bytes;
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FullDisk() {
        ::setrlimit(RLIMIT_FSIZE, &old_);
        std::signal(SIGXFSZ, old_handler_);
    }
    FullDisk(const FullDisk&) = delete;
    FullDisk& operator=(const FullDisk&) = delete;

private:
    rlimit old_{};
    void (*old_handler_)(int);
};

TEST_F(WriteOutputs, AFullDiskLeavesTheOldResults) {
    const fs::path folder = base_ / "bench";
    fs::create_directories(folder);
    write_file(folder / "labels.txt", "old");
    std::string existing, fresh;
    {
        const FullDisk full(1500);  // labels fit, the geometry does not
        existing = error(folder, {"labels", "ply"});
        fresh = error(base_ / "new", {"labels", "ply"});
    }
    EXPECT_NE(existing.find("annotation.ply: cannot be written"), std::string::npos) << existing;
    EXPECT_NE(fresh.find("annotation.ply: cannot be written"), std::string::npos) << fresh;
    EXPECT_EQ(read_file(folder / "labels.txt"), "old");
    EXPECT_EQ(names_in(folder), (std::set<std::string>{"labels.txt"}));
    EXPECT_EQ(names_in(base_), (std::set<std::string>{"bench"})) << "the new folder does not appear";
}

TEST_F(WriteOutputs, AnAnnotationOfAnotherMeshWritesNothing) {
    object_.annotation.part_of_triangle.pop_back();
    EXPECT_THROW(write(base_ / "bench"), UsageError);
    EXPECT_FALSE(fs::exists(base_ / "bench"));
}

}  // namespace
}  // namespace partonomy
