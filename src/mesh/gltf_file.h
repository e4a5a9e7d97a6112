#pragma once

#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "mesh/companions.h"

namespace partonomy {

/// A value in the JSON of a glTF file that knows where it stands, so that an error can say "accessors[3].count".
class GltfValue {
public:
    GltfValue(const nlohmann::json* value, std::string path, const std::string& file)
        : value_(value), path_(std::move(path)), file_(&file) {}

    /// Whether it is there at all; all that follows gives the fallback where it is not.
    explicit operator bool() const { return value_ != nullptr; }
    [[nodiscard]] GltfValue operator[](const char* key) const;
    [[nodiscard]] GltfValue operator[](std::size_t index) const;
    [[nodiscard]] std::size_t size() const;  ///< elements of an array; 0 when it is missing
    [[nodiscard]] std::uint64_t count(std::uint64_t fallback = 0) const;  ///< a whole number, not negative
    [[nodiscard]] std::optional<std::size_t> index() const;               ///< the same, of a list; nullopt when missing
    [[nodiscard]] double number(double fallback) const;                   ///< finite
    [[nodiscard]] bool boolean(bool fallback) const;
    [[nodiscard]] std::string text() const;
    /// As many numbers as `fallback` has.
    [[nodiscard]] std::vector<double> numbers(std::vector<double> fallback) const;
    [[nodiscard]] const std::string& path() const { return path_; }
    /// Throws a MeshError: "file: path what".
    [[noreturn]] void fail(const std::string& what) const;

private:
    const nlohmann::json* value_;
    std::string path_;
    const std::string* file_;
};

/// The numbers of an accessor, checked to lie inside their buffer.
struct GltfNumbers {
    std::size_t count = 0, width = 1;  ///< elements, numbers of each
    /// Number i of element k; whole numbers that are marked so as fractions of the largest of their type.
    [[nodiscard]] double number(std::size_t k, std::size_t i) const;
    [[nodiscard]] std::uint32_t whole(std::size_t k) const;

    const char* data = nullptr;
    std::size_t stride = 0;
    int type = 0;  ///< as in glTF: 5120 byte to 5126 float
    bool normalized = false;
};

/// A glTF or GLB file: its JSON, and the bytes that its lists of numbers and images lie in. No number of the file is
/// trusted: each is compared with the bytes that are there before anything is read or made room for.
class GltfFile {
public:
    /// All three must outlive it. Throws MeshError: no JSON, a broken container, a version other than 2, a required
    /// extension that changes what the numbers mean.
    GltfFile(std::string_view bytes, const std::string& name, const Companions& companions);

    [[nodiscard]] GltfValue root() const { return {&json_, "", name_}; }
    /// The object number `index` of a list of the root. Throws when there is none; `asker` refers to it.
    [[nodiscard]] GltfValue item(const char* list, std::size_t index, const GltfValue& asker) const;

    /// Of a sparse accessor the numbers with its replacements. Throws MeshError: compressed, another type than one of
    /// `types` ("VEC3"), beyond its buffer.
    [[nodiscard]] GltfNumbers numbers(std::size_t accessor, std::initializer_list<const char*> types,
                                      const GltfValue& asker);

    /// The bytes of an image, from a file beside the model, from the file itself, or from its buffers.
    [[nodiscard]] std::string image_bytes(const GltfValue& image);

    /// Bytes of all buffers that were opened so far.
    [[nodiscard]] std::size_t bytes_held() const { return bytes_held_; }

    [[nodiscard]] const std::string& name() const { return name_; }

private:
    [[nodiscard]] std::string_view buffer(std::size_t index, const GltfValue& asker);
    [[nodiscard]] std::string_view view(std::size_t index, const GltfValue& asker, std::size_t& stride);
    void locate(const GltfValue& holder, GltfNumbers& numbers);
    void fill_in(const GltfValue& sparse, std::string& filled, GltfNumbers& numbers);
    [[nodiscard]] std::string resource(const GltfValue& uri, const char* what, std::uintmax_t largest) const;

    const std::string& name_;
    const Companions& companions_;
    nlohmann::json json_;
    std::string_view binary_;  ///< chunk of a GLB file
    bool has_binary_ = false;
    std::size_t bytes_held_ = 0;
    std::vector<std::optional<std::string>> buffers_;
    std::map<std::size_t, std::string> filled_;  ///< by sparse accessor: its numbers
};

}  // namespace partonomy
