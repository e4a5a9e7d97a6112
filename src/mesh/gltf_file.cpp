#include "mesh/gltf_file.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <limits>

#include "base/errors.h"
#include "mesh/decode_image.h"

// glTF 2.0: a JSON object whose lists refer to each other by index, and buffers of packed little-endian numbers, in the
// same file (GLB), in base64, or beside it. Read by hand on top of a JSON reader. tinygltf 2.7 was tried and left: it
// reads "../" and any other path, a file of 200 bytes whose buffer view begins behind its buffer makes it crash, and
// loading the library takes a start of the program more than a millisecond.

namespace partonomy {
namespace {

constexpr std::uintmax_t largest_buffer = std::uintmax_t{1} << 34;
constexpr std::size_t largest_json = std::size_t{1} << 29;
constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

std::uint32_t little_32(const char* data) {
    const auto byte = [&](int i) { return static_cast<std::uint32_t>(static_cast<unsigned char>(data[i])); };
    return byte(0) | byte(1) << 8 | byte(2) << 16 | byte(3) << 24;
}

/// Extensions that may be required: those that we know, and those that leave geometry and base colour as they are.
bool is_harmless(const std::string& extension) {
    return extension.starts_with("KHR_materials_") || extension == "KHR_texture_transform" ||
           extension == "KHR_mesh_quantization" || extension == "KHR_lights_punctual" || extension == "KHR_xmp_json_ld";
}

std::size_t size_of_type(int type) {
    switch (type) {
        case 5120:
        case 5121:
            return 1;
        case 5122:
        case 5123:
            return 2;
        case 5125:
        case 5126:
            return 4;
        default:
            return 0;
    }
}

std::size_t width_of(const std::string& type) {
    if (type == "SCALAR") return 1;
    if (type == "VEC2") return 2;
    if (type == "VEC3") return 3;
    return type == "VEC4" ? 4 : 0;
}

/// What %41 and the like mean; nullopt when it is broken.
std::optional<std::string> percent_decoded(const std::string& text) {
    std::string decoded;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] != '%') {
            decoded += text[i];
            continue;
        }
        unsigned value = 0;
        if (i + 2 >= text.size()) return std::nullopt;
        const auto [stop, error] = std::from_chars(text.data() + i + 1, text.data() + i + 3, value, 16);
        if (error != std::errc() || stop != text.data() + i + 3) return std::nullopt;
        decoded += static_cast<char>(value);
        i += 2;
    }
    return decoded;
}

std::optional<std::string> base64_decoded(std::string_view text) {
    while (text.ends_with('=')) text.remove_suffix(1);
    std::string decoded;
    decoded.reserve(text.size() / 4 * 3 + 3);
    std::uint32_t bits = 0;
    int have = 0;
    for (const char c : text) {
        int value = 0;
        if (c >= 'A' && c <= 'Z')
            value = c - 'A';
        else if (c >= 'a' && c <= 'z')
            value = c - 'a' + 26;
        else if (c >= '0' && c <= '9')
            value = c - '0' + 52;
        else if (c == '+' || c == '-')
            value = 62;
        else if (c == '/' || c == '_')
            value = 63;
        else
            return std::nullopt;
        bits = bits << 6 | static_cast<std::uint32_t>(value);
        if ((have += 6) < 8) continue;
        have -= 8;
        decoded += static_cast<char>(bits >> have & 0xff);
    }
    return decoded;
}

}  // namespace

GltfValue GltfValue::operator[](const char* key) const {
    std::string path = path_.empty() ? key : path_ + "." + key;
    if (value_ == nullptr) return {nullptr, std::move(path), *file_};
    if (!value_->is_object()) fail("is no JSON object");
    const auto found = value_->find(key);
    return {found == value_->end() ? nullptr : &*found, std::move(path), *file_};
}

GltfValue GltfValue::operator[](std::size_t index) const {
    return {&(*value_)[index], fmt::format("{}[{}]", path_, index), *file_};
}

std::size_t GltfValue::size() const {
    if (value_ == nullptr) return 0;
    if (!value_->is_array()) fail("is no JSON array");
    return value_->size();
}

std::uint64_t GltfValue::count(std::uint64_t fallback) const {
    if (value_ == nullptr) return fallback;
    if (value_->is_number_unsigned()) return value_->get<std::uint64_t>();
    if (value_->is_number_float()) {  // some programs write 3.0
        const double number = value_->get<double>();
        if (number >= 0 && number <= 9e15 && number == std::floor(number)) return static_cast<std::uint64_t>(number);
    }
    fail("must be a whole number, not negative");
}

std::optional<std::size_t> GltfValue::index() const {
    if (value_ == nullptr) return std::nullopt;
    return count();
}

double GltfValue::number(double fallback) const {
    if (value_ == nullptr) return fallback;
    if (!value_->is_number()) fail("must be a number");
    const double number = value_->get<double>();
    if (!std::isfinite(number)) fail("must be a finite number");
    return number;
}

bool GltfValue::boolean(bool fallback) const {
    if (value_ == nullptr) return fallback;
    if (!value_->is_boolean()) fail("must be true or false");
    return value_->get<bool>();
}

std::string GltfValue::text() const {
    if (value_ == nullptr) return {};
    if (!value_->is_string()) fail("must be a text in quotes");
    return value_->get<std::string>();
}

std::vector<double> GltfValue::numbers(std::vector<double> fallback) const {
    if (value_ == nullptr) return fallback;
    if (size() != fallback.size()) fail(fmt::format("must be {} numbers", fallback.size()));
    for (std::size_t i = 0; i < fallback.size(); ++i) fallback[i] = (*this)[i].number(0);
    return fallback;
}

void GltfValue::fail(const std::string& what) const {
    throw MeshError(at(*file_, 0, path_.empty() ? what : path_ + " " + what));
}

double GltfNumbers::number(std::size_t k, std::size_t i) const {
    const char* place = data + k * stride + i * size_of_type(type);
    const auto scaled = [&](double value, double largest) {
        return normalized ? std::max(value / largest, -1.0) : value;
    };
    switch (type) {
        case 5120:
            return scaled(static_cast<signed char>(*place), 127);
        case 5121:
            return scaled(static_cast<unsigned char>(*place), 255);
        case 5122:
            return scaled(static_cast<std::int16_t>(static_cast<unsigned char>(place[0]) | place[1] << 8), 32767);
        case 5123:
            return scaled(static_cast<unsigned char>(place[0]) | static_cast<unsigned char>(place[1]) << 8, 65535);
        case 5125:
            return scaled(little_32(place), 4294967295.0);
        default:
            return std::bit_cast<float>(little_32(place));
    }
}

std::uint32_t GltfNumbers::whole(std::size_t k) const {
    const char* place = data + k * stride;
    if (type == 5125) return little_32(place);
    const auto low = static_cast<std::uint32_t>(static_cast<unsigned char>(place[0]));
    return type == 5121 ? low : low | static_cast<std::uint32_t>(static_cast<unsigned char>(place[1])) << 8;
}

GltfFile::GltfFile(std::string_view bytes, const std::string& name, const Companions& companions)
    : name_(name), companions_(companions) {
    const auto fail = [&](const std::string& sentence) { throw MeshError(at(name, 0, sentence)); };
    std::string_view text = bytes;
    if (bytes.starts_with("glTF")) {
        if (bytes.size() < 20) fail("is cut off: a GLB file begins with 12 bytes of head and a JSON chunk");
        const std::uint32_t version = little_32(bytes.data() + 4), length = little_32(bytes.data() + 8);
        if (version != 2) fail(fmt::format("is GLB version {}; only version 2 can be read", version));
        if (length > bytes.size())
            fail(fmt::format("is cut off: its head announces {} bytes, it has {}", length, bytes.size()));
        std::size_t place = 12;
        text = {};
        while (place + 8 <= length) {
            const std::size_t size = little_32(bytes.data() + place);
            const std::uint32_t kind = little_32(bytes.data() + place + 4);
            if (size > length - place - 8)
                fail(fmt::format("is broken: the chunk at byte {} runs beyond its end", place));
            const std::string_view chunk = bytes.substr(place + 8, size);
            if (place == 12 && kind != json_chunk) fail("is broken: the first chunk of a GLB file is its JSON");
            if (place == 12) text = chunk;
            if (kind == binary_chunk && !std::exchange(has_binary_, true)) {
                binary_ = chunk;
                bytes_held_ += chunk.size();
            }
            place += 8 + (size + 3) / 4 * 4;
        }
    }
    if (text.size() > largest_json)
        fail(fmt::format("has {} bytes of JSON; at most {} are read", text.size(), largest_json));
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    try {
        json_ = nlohmann::json::parse(text);
    } catch (const nlohmann::json::parse_error& error) {
        const auto place = static_cast<std::ptrdiff_t>(std::min(error.byte, text.size()));
        throw MeshError(at(name,
                           bytes.starts_with("glTF") ? 0 : 1 + std::count(text.begin(), text.begin() + place, '\n'),
                           fmt::format("is no valid JSON at byte {}; a glTF file is one JSON object", error.byte)));
    } catch (const nlohmann::json::exception&) {
        fail("holds a number in its JSON that is too large to be read");
    }
    if (!json_.is_object() || !json_.contains("asset"))
        fail("is not a mesh that can be read: a glTF file is a JSON object with the member asset");
    const std::string version = root()["asset"]["version"].text();
    if (!version.starts_with("2.")) {
        const bool is_plain = version.size() <= 8 && version.find_first_not_of("0123456789.") == std::string::npos;
        fail(fmt::format("is glTF {}; only version 2 can be read",
                         version.empty() || !is_plain ? "of an unknown version" : "version " + version));
    }
    const GltfValue required = root()["extensionsRequired"];
    for (std::size_t i = 0; i < required.size(); ++i)
        if (!is_harmless(required[i].text()))
            required[i].fail(
                "needs an extension that cannot be read; save the model without compression and extensions");
}

GltfValue GltfFile::item(const char* list, std::size_t index, const GltfValue& asker) const {
    const GltfValue items = root()[list];
    if (index >= items.size())
        asker.fail(fmt::format("refers to number {} of {}, but there are {}", index, list, items.size()));
    return items[index];
}

std::string GltfFile::resource(const GltfValue& uri, const char* what, std::uintmax_t largest) const {
    const std::string text = uri.text();
    if (!text.starts_with("data:")) {
        const std::optional<std::string> reference = percent_decoded(text);
        if (!reference) uri.fail("holds a % that two hexadecimal digits do not follow");
        return companions_.read(*reference, at(name_, 0, fmt::format("{}: {}", uri.path(), what)), largest);
    }
    const std::size_t comma = text.find(',');
    if (comma == std::string::npos || !text.substr(0, comma).ends_with(";base64"))
        uri.fail("must be a file beside the model, or data in base64");
    std::optional<std::string> bytes = base64_decoded(std::string_view(text).substr(comma + 1));
    if (!bytes) uri.fail("is broken base64");
    return std::move(*bytes);
}

std::string_view GltfFile::buffer(std::size_t index, const GltfValue& asker) {
    const GltfValue buffer = item("buffers", index, asker);
    buffers_.resize(std::max(buffers_.size(), index + 1));
    const std::uint64_t length = buffer["byteLength"].count();
    std::string_view bytes;
    if (!buffer["uri"]) {
        if (index != 0 || !has_binary_) buffer.fail("has no uri, and the file has no binary chunk for it");
        bytes = binary_;
    } else {
        std::optional<std::string>& kept = buffers_[index];
        if (!kept) {
            kept = resource(buffer["uri"], "the buffer", largest_buffer);
            bytes_held_ += kept->size();
        }
        bytes = *kept;
    }
    if (bytes.size() < length) buffer.fail(fmt::format("announces {} bytes, but {} are there", length, bytes.size()));
    return bytes.substr(0, length);
}

std::string_view GltfFile::view(std::size_t index, const GltfValue& asker, std::size_t& stride) {
    const GltfValue view = item("bufferViews", index, asker);
    if (!view["buffer"]) view.fail("needs the member buffer");
    const std::string_view bytes = buffer(view["buffer"].count(), view["buffer"]);
    const std::uint64_t offset = view["byteOffset"].count(), length = view["byteLength"].count();
    if (offset > bytes.size() || length > bytes.size() - offset)
        view.fail(fmt::format("runs to byte {} + {} of a buffer that has {}", offset, length, bytes.size()));
    stride = view["byteStride"].count();
    if (stride > 255) view["byteStride"].fail("is too large; a stride is at most 252");
    return bytes.substr(offset, length);
}

/// Sets where the numbers lie that `holder` (an accessor, or half of a sparse one) announces by view and offset.
void GltfFile::locate(const GltfValue& holder, GltfNumbers& numbers) {
    if (!holder["bufferView"]) holder.fail("has no bufferView; compressed or empty ones cannot be read");
    const std::size_t size = size_of_type(numbers.type), element = size * numbers.width;
    const std::uint64_t offset = holder["byteOffset"].count();
    const std::string_view bytes = view(holder["bufferView"].count(), holder["bufferView"], numbers.stride);
    if (numbers.stride == 0) numbers.stride = element;
    const bool fits = numbers.count == 0 || (offset <= bytes.size() && element <= bytes.size() - offset &&
                                             (numbers.count - 1) <= (bytes.size() - offset - element) / numbers.stride);
    if (!fits || numbers.stride < element)
        holder.fail(fmt::format("announces {} elements of {} bytes, more than its view of {} bytes holds",
                                numbers.count, element, bytes.size()));
    numbers.data = bytes.data() + (numbers.count == 0 ? 0 : offset);
}

/// Copies the numbers, zeros where there are none, and puts the replacements of a sparse accessor into them.
void GltfFile::fill_in(const GltfValue& sparse, std::string& filled, GltfNumbers& numbers) {
    GltfNumbers places, values;
    places.count = values.count = sparse["count"].count();
    if (places.count > numbers.count)
        sparse["count"].fail(fmt::format("is more than the {} elements of the accessor", numbers.count));
    places.type = static_cast<int>(std::min<std::uint64_t>(sparse["indices"]["componentType"].count(), 1 << 20));
    if (places.type != 5121 && places.type != 5123 && places.type != 5125)
        sparse["indices"]["componentType"].fail("must be one of 5121, 5123 and 5125");
    values.width = numbers.width;
    values.type = numbers.type;
    locate(sparse["indices"], places);
    locate(sparse["values"], values);
    const std::size_t element = size_of_type(numbers.type) * numbers.width;
    filled.assign(numbers.count * element, '\0');
    for (std::size_t k = 0; numbers.data != nullptr && k < numbers.count; ++k)
        std::memcpy(filled.data() + k * element, numbers.data + k * numbers.stride, element);
    for (std::size_t i = 0; i < places.count; ++i) {
        const std::uint32_t k = places.whole(i);
        if (k >= numbers.count)
            sparse["indices"].fail(fmt::format("names element {} of an accessor that has {}", k, numbers.count));
        std::memcpy(filled.data() + k * element, values.data + i * values.stride, element);
    }
    bytes_held_ += filled.size();
}

GltfNumbers GltfFile::numbers(std::size_t index, std::initializer_list<const char*> types, const GltfValue& asker) {
    constexpr std::uint64_t most_zeros = std::uint64_t{1} << 22;  // elements that no byte of the file stands for
    const GltfValue accessor = item("accessors", index, asker), sparse = accessor["sparse"];
    const std::string type = accessor["type"].text();
    if (std::ranges::none_of(types, [&](const char* word) { return type == word; }))
        accessor["type"].fail(fmt::format("must be {} for {}", fmt::join(types, " or "), asker.path()));
    GltfNumbers numbers;
    numbers.width = width_of(type);
    numbers.type = static_cast<int>(std::min<std::uint64_t>(accessor["componentType"].count(), 1 << 20));
    if (size_of_type(numbers.type) == 0)
        accessor["componentType"].fail("must be one of 5120, 5121, 5122, 5123, 5125 and 5126");
    numbers.normalized = accessor["normalized"].boolean(false);
    numbers.count = accessor["count"].count();
    if (!sparse || accessor["bufferView"]) locate(accessor, numbers);
    if (!sparse) return numbers;
    if (numbers.data == nullptr && numbers.count > most_zeros)
        accessor.fail(
            fmt::format("announces {} elements without a bufferView; at most {} are read", numbers.count, most_zeros));
    std::string& filled = filled_[index];
    if (filled.empty()) fill_in(sparse, filled, numbers);
    numbers.data = filled.data();
    numbers.stride = size_of_type(numbers.type) * numbers.width;
    return numbers;
}

std::string GltfFile::image_bytes(const GltfValue& image) {
    if (image["uri"]) return resource(image["uri"], "the image", largest_image_bytes);
    if (!image["bufferView"]) image.fail("has neither uri nor bufferView");
    std::size_t stride = 0;
    return std::string(view(image["bufferView"].count(), image["bufferView"], stride));
}

}  // namespace partonomy
