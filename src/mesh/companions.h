#pragma once

#include <filesystem>
#include <string>

namespace partonomy {

/// The files that a model file may name: those in its own folder and below. A name that leads out of it is refused,
/// whichever way: "..", an absolute path, a drive, a scheme such as http:, a link.
class Companions {
public:
    /// None at all, for models that are no files.
    Companions() = default;
    explicit Companions(const std::filesystem::path& model);

    /// The bytes of a file, at most `largest`. `asker` begins the error sentence: "chair.obj:3: the material library".
    /// Throws MeshError: outside the folder, missing, no ordinary file, too large.
    [[nodiscard]] std::string read(const std::string& reference, const std::string& asker,
                                   std::uintmax_t largest) const;

    /// Whether `reference` names a file that may be read.
    [[nodiscard]] bool has(const std::string& reference) const;

private:
    [[nodiscard]] std::string find(const std::string& reference, std::filesystem::path& found) const;
    std::filesystem::path folder_;
    bool has_folder_ = false;
};

}  // namespace partonomy
