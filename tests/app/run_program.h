#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace partonomy {

struct ProgramResult {
    int exit_code = -1;  ///< -1 when it was ended by a signal
    std::string out, err;
};

/// Runs build/partonomy with these arguments, in `folder`.
[[nodiscard]] ProgramResult run_partonomy(const std::vector<std::string>& arguments, const std::filesystem::path& folder);

/// An empty folder that is gone with the object.
class TemporaryFolder {
public:
    TemporaryFolder();
    ~TemporaryFolder();
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    [[nodiscard]] const std::filesystem::path& path() const { return path_; }
    /// Writes a file into the folder and returns its path.
    std::string write(const std::string& name, const std::string& bytes) const;

private:
    std::filesystem::path path_;
};

/// Path of ontologies/furniture.ttl.
[[nodiscard]] std::string furniture_path();

}  // namespace partonomy
