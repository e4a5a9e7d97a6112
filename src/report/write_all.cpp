// All or nothing, in two steps: every file is made in memory and written into a temporary folder; then all of them are
// renamed into place. The temporary folder of a folder that exists is made inside of it, so that both are on
// one file system even when the folder is a mount point; a new folder is made beside its place and appears by one
// rename. Files that are replaced wait in the temporary folder until the last rename has succeeded, and go back when
// one fails.

#include "report/write_all.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <iterator>
#include <string_view>
#include <system_error>

#include "base/errors.h"
#include "base/ranges.h"
#include "report/part_names.h"
#include "report/write.h"

namespace partonomy {
namespace {

namespace fs = std::filesystem;

struct Format {
    std::string_view name, file;
};
constexpr std::array<Format, 6> known_formats{{{"glb", "annotation.glb"},
                                               {"json", "annotation.json"},
                                               {"labels", "labels.txt"},
                                               {"ply", "annotation.ply"},
                                               {"png", "preview.png"},
                                               {"trace", "trace.txt"}}};

std::string render(std::string_view format, const TriangleMesh& mesh, const Annotation& annotation, const Vec3& up,
                   const PreviewOptions& preview) {
    if (format == "glb") return to_glb(mesh, annotation, up);
    if (format == "json") return to_json(annotation);
    if (format == "labels") return to_labels(annotation);
    if (format == "ply") return to_ply(mesh, annotation);
    if (format == "png") return to_png(mesh, annotation, up, preview);
    return to_trace(annotation);
}

[[noreturn]] void fail(const fs::path& path, const std::string& reason) {
    throw FileError(at(path.string(), 0, "cannot be written: " + reason));
}

/// A folder that is gone with all that is in it when this goes.
class TemporaryFolder {
public:
    explicit TemporaryFolder(fs::path path, const fs::path& meant) : path_(std::move(path)) {
        std::error_code error;
        fs::create_directory(path_, error);
        if (error) fail(meant, error.message());
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const fs::path& path() const { return path_; }

private:
    fs::path path_;
};

/// `meant` is what the error names.
void write_bytes(const fs::path& path, const std::string& bytes, const fs::path& meant) {
    std::FILE* file = std::fopen(path.c_str(), "wb");
    if (file == nullptr) fail(meant, std::strerror(errno));
    errno = 0;
    const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size() && std::fflush(file) == 0;
    const int reason = errno;
    const bool closed = std::fclose(file) == 0;
    if (!written) fail(meant, std::strerror(reason));
    if (!closed) fail(meant, std::strerror(errno));
}

/// The files that are asked for, and what they tell.
struct Files {
    std::vector<Format> formats;
    const TriangleMesh& mesh;
    const Annotation& annotation;
    const Vec3& up;
    const PreviewOptions& preview;

    /// Makes them in `temporary`, each as soon as a thread is free; `meant` is the folder that errors name.
    void write_into(const fs::path& temporary, const fs::path& meant) const {
        for_each_range(
            formats.size(), preview.threads,
            [&](std::size_t begin, std::size_t end) {
                for (std::size_t i = begin; i < end; ++i)
                    write_bytes(temporary / formats[i].file, render(formats[i].name, mesh, annotation, up, preview),
                                meant / formats[i].file);
            },
            1);
    }
};

/// Renames that can be taken back.
class Renames {
public:
    void rename(const fs::path& from, const fs::path& to, const fs::path& meant) {
        std::error_code error;
        fs::rename(from, to, error);
        if (error) {
            take_back();
            fail(meant, error.message());
        }
        done_.emplace_back(from, to);
    }

private:
    void take_back() {
        for (auto step = done_.rbegin(); step != done_.rend(); ++step) {
            std::error_code ignored;
            fs::rename(step->second, step->first, ignored);
        }
        done_.clear();
    }
    std::vector<std::pair<fs::path, fs::path>> done_;
};

std::string temporary_name() {
    static std::atomic<unsigned> counter = 0;
    return ".part" + std::to_string(::getpid()) + "-" + std::to_string(counter++);
}

void replace_in(const fs::path& folder, const Files& files) {
    for (const Format& format : files.formats) {
        std::error_code ignored;
        if (fs::is_directory(folder / format.file, ignored)) fail(folder / format.file, "a folder is in its place");
    }
    const TemporaryFolder temporary(folder / temporary_name(), folder);
    const TemporaryFolder old(temporary.path() / "old", folder);
    files.write_into(temporary.path(), folder);
    Renames renames;
    for (const Format& format : files.formats) {
        const fs::path place = folder / format.file;
        std::error_code ignored;
        if (fs::exists(fs::symlink_status(place, ignored))) renames.rename(place, old.path() / format.file, place);
        renames.rename(temporary.path() / format.file, place, place);
    }
}

void make_new(const fs::path& folder, const Files& files) {
    const fs::path parent = folder.has_parent_path() ? folder.parent_path() : fs::path(".");
    std::error_code error;
    fs::create_directories(parent, error);
    if (error) fail(folder, "its parent folder cannot be made: " + error.message());
    const TemporaryFolder temporary(folder.string() + temporary_name(), folder);
    files.write_into(temporary.path(), folder);
    fs::rename(temporary.path(), folder, error);
    if (error) fail(folder, error.message());
}

}  // namespace

std::vector<std::string> output_formats() {
    std::vector<std::string> names;
    for (const Format& format : known_formats) names.emplace_back(format.name);
    return names;
}

void check_formats(const std::set<std::string>& formats) {
    for (const std::string& name : formats)
        if (std::ranges::find(known_formats, name, &Format::name) == known_formats.end())
            throw UsageError("\"" + name + "\" is not a format that can be written; known are " +
                             join(output_formats()));
}

void write_outputs(const fs::path& folder, const std::set<std::string>& formats, const TriangleMesh& mesh,
                   const Annotation& annotation, const Vec3& up, const PreviewOptions& preview) {
    check_formats(formats);
    if (folder.empty()) throw UsageError("the output folder has no name");
    Files files{{}, mesh, annotation, up, preview};
    std::ranges::copy_if(known_formats, std::back_inserter(files.formats),
                         [&](const Format& format) { return formats.contains(std::string(format.name)); });
    const fs::path place = folder.has_filename() ? folder : folder.parent_path();
    std::error_code error;
    const fs::file_status status = fs::status(place, error);
    if (fs::is_directory(status)) return replace_in(place, files);
    if (fs::exists(status)) fail(place, "it is a file, and a folder is needed");
    make_new(place, files);
}

}  // namespace partonomy
