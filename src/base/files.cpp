#include "base/files.h"

#include <nettle/sha2.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>

#include "base/errors.h"

namespace partonomy {
namespace {

struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
};
using File = std::unique_ptr<std::FILE, Close>;

}  // namespace

std::string read_file(const std::filesystem::path& path) {
    std::error_code error;
    const auto status = std::filesystem::status(path, error);
    if (!std::filesystem::exists(status)) throw FileError(at(path.string(), 0, "no such file"));
    if (std::filesystem::is_directory(status)) throw FileError(at(path.string(), 0, "is a folder, not a file"));
    const File file(std::fopen(path.c_str(), "rb"));
    if (!file) throw FileError(at(path.string(), 0, std::string("cannot be opened: ") + std::strerror(errno)));
    std::string bytes;
    const auto size = std::filesystem::file_size(path, error);
    if (!error) bytes.reserve(size);
    std::array<char, 1 << 16> block{};
    while (const std::size_t n = std::fread(block.data(), 1, block.size(), file.get())) bytes.append(block.data(), n);
    if (std::ferror(file.get())) throw FileError(at(path.string(), 0, "cannot be read to its end"));
    return bytes;
}

void write_file(const std::filesystem::path& path, std::string_view bytes) {
    const std::filesystem::path temporary = path.string() + ".part" + std::to_string(::getpid());
    {
        File file(std::fopen(temporary.c_str(), "wb"));
        if (!file) throw FileError(at(path.string(), 0, std::string("cannot be written: ") + std::strerror(errno)));
        const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file.get()) == bytes.size();
        if (!written || std::fflush(file.get()) != 0) {
            file.reset();
            std::remove(temporary.c_str());
            throw FileError(at(path.string(), 0, std::string("cannot be written: ") + std::strerror(errno)));
        }
    }
    std::error_code error;
    std::filesystem::rename(temporary, path, error);
    if (error) {
        std::remove(temporary.c_str());
        throw FileError(at(path.string(), 0, "cannot be written: " + error.message()));
    }
}

std::string sha256(std::string_view bytes) {
    sha256_ctx context;
    sha256_init(&context);
    sha256_update(&context, bytes.size(), reinterpret_cast<const std::uint8_t*>(bytes.data()));
    std::array<std::uint8_t, SHA256_DIGEST_SIZE> digest{};
    sha256_digest(&context, digest.size(), digest.data());
    std::string hex;
    for (const std::uint8_t byte : digest) {
        constexpr char digits[] = "0123456789abcdef";
        hex += digits[byte >> 4];
        hex += digits[byte & 15];
    }
    return hex;
}

}  // namespace partonomy
