#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace partonomy {

/// The bytes of a file. Throws FileError when it is missing, a folder, or unreadable.
[[nodiscard]] std::string read_file(const std::filesystem::path& path);

/// Writes a file so that a reader sees the old bytes or the new ones, never a part of them: a temporary file beside it
/// is renamed over it. Throws FileError.
void write_file(const std::filesystem::path& path, std::string_view bytes);

/// The SHA-256 of `bytes` as 64 lower-case hexadecimal digits.
[[nodiscard]] std::string sha256(std::string_view bytes);

}  // namespace partonomy
