#include "mesh/companions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "base/errors.h"
#include "base/files.h"

// Two gates, since a model may come from anywhere. The words of the name are looked at first, with both kinds of
// slashes, so that the answer is the same on every system; then links are followed, and what they lead to must lie in
// the folder, too.

namespace partonomy {
namespace {

namespace fs = std::filesystem;

bool has_scheme(const std::string& name) {
    const std::size_t colon = name.find(':');
    if (colon == std::string::npos || colon == 0) return false;
    for (std::size_t i = 0; i < colon; ++i)
        if (!std::isalnum(static_cast<unsigned char>(name[i])) && name[i] != '+' && name[i] != '.' && name[i] != '-')
            return false;
    return true;
}

/// Why the words of a name lead out of the folder; empty when they do not.
std::string leads_out(const std::string& name) {
    if (name.empty()) return "has no name";
    if (name.find('\0') != std::string::npos) return "has a zero byte in its name";
    if (has_scheme(name)) return "is an address, and only files in the model's folder are read";
    if (name.front() == '/' || name.front() == '\\')
        return "is an absolute path, and only files in the model's folder are read";
    for (std::size_t begin = 0; begin <= name.size();) {
        const std::size_t end = std::min(name.find_first_of("/\\", begin), name.size());
        if (name.substr(begin, end - begin) == "..")
            return "lies outside the model's folder, and only files in it are read";
        begin = end + 1;
    }
    return {};
}

/// A name as an error sentence can show it.
std::string shown(const std::string& name) {
    std::string text;
    for (const char c : name.substr(0, 80)) text += c >= ' ' && c != '\x7f' ? c : '?';
    return name.size() > 80 ? text + "..." : text;
}

}  // namespace

Companions::Companions(const fs::path& model) : has_folder_(true) {
    std::error_code error;
    folder_ = fs::canonical(model.has_parent_path() ? model.parent_path() : fs::path("."), error);
    if (error) has_folder_ = false;
}

std::string Companions::find(const std::string& reference, fs::path& found) const {
    if (std::string why = leads_out(reference); !why.empty()) return why;
    if (!has_folder_) return "cannot be read, since the model has no folder";
    std::string name = reference;
    std::replace(name.begin(), name.end(), '\\', '/');
    std::error_code error;
    const fs::path path = fs::canonical(folder_ / name, error);
    if (error) return "is missing; it must lie beside the model";
    const fs::path inside = path.lexically_relative(folder_);
    if (inside.empty() || *inside.begin() == "..")
        return "is a link that leads outside the model's folder, and only files in it are read";
    if (!fs::is_regular_file(path, error) || error) return "is no ordinary file";
    found = path;
    return {};
}

bool Companions::has(const std::string& reference) const {
    fs::path found;
    return find(reference, found).empty();
}

std::string Companions::read(const std::string& reference, const std::string& asker, std::uintmax_t largest) const {
    fs::path path;
    if (const std::string why = find(reference, path); !why.empty())
        throw MeshError(fmt::format("{} '{}' {}", asker, shown(reference), why));
    std::error_code error;
    const std::uintmax_t size = fs::file_size(path, error);
    if (!error && size > largest)
        throw MeshError(
            fmt::format("{} '{}' has {} bytes; at most {} are read", asker, shown(reference), size, largest));
    return read_file(path);
}

}  // namespace partonomy
