// Reads one property of a PLY file and skips over all others, so that truth can come from meshes that the mesh reader
// would clean first.

#include "report/ply_labels.h"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cstring>
#include <sstream>

#include "base/errors.h"

namespace partonomy {
namespace {

enum class Type { i8, u8, i16, u16, i32, u32, f32, f64 };

struct Property {
    std::string name;
    Type type = Type::i32;
    bool is_list = false;
    Type count_type = Type::u8;
};

struct Element {
    std::string name;
    std::int64_t count = 0;
    std::vector<Property> properties;
};

struct Header {
    enum class Format { ascii, little, big } format = Format::ascii;
    std::vector<Element> elements;
    std::vector<std::string> names;
    std::size_t size = 0;  ///< bytes up to the data
    long lines = 0;
};

bool is_integer(Type type) { return type != Type::f32 && type != Type::f64; }

std::size_t size_of(Type type) {
    constexpr std::array<std::size_t, 8> sizes{1, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<std::size_t>(type)];
}

bool parse_type(const std::string& word, Type& type) {
    constexpr std::array<std::array<std::string_view, 2>, 8> names{{{"char", "int8"},
                                                                    {"uchar", "uint8"},
                                                                    {"short", "int16"},
                                                                    {"ushort", "uint16"},
                                                                    {"int", "int32"},
                                                                    {"uint", "uint32"},
                                                                    {"float", "float32"},
                                                                    {"double", "float64"}}};
    for (std::size_t i = 0; i < names.size(); ++i)
        if (word == names[i][0] || word == names[i][1]) {
            type = static_cast<Type>(i);
            return true;
        }
    return false;
}

Property parse_property(std::istringstream& words, const std::string& file, long line) {
    Property property;
    std::string word;
    words >> word;
    if (word == "list") {
        property.is_list = true;
        words >> word;
        if (!parse_type(word, property.count_type) || !is_integer(property.count_type))
            throw UsageError(at(file, line, "\"" + word + "\" is not an integer type for the length of a list"));
        words >> word;
    }
    if (!parse_type(word, property.type)) throw UsageError(at(file, line, "\"" + word + "\" is not a PLY type"));
    words >> property.name;
    return property;
}

Header parse_header(std::string_view bytes, const std::string& file) {
    Header header;
    while (true) {
        const std::size_t end = bytes.find('\n', header.size);
        ++header.lines;
        if (end == std::string_view::npos)
            throw UsageError(at(file, header.lines, "the PLY header has no end_header line"));
        std::string text(bytes.substr(header.size, end - header.size));
        if (text.ends_with('\r')) text.pop_back();
        header.size = end + 1;
        std::istringstream words(text);
        std::string word;
        words >> word;
        if (word == "end_header") return header;
        if (word == "format") {
            words >> word;
            if (word != "ascii" && word != "binary_little_endian" && word != "binary_big_endian")
                throw UsageError(at(file, header.lines, "\"" + word + "\" is not a PLY format"));
            header.format = word == "ascii"                  ? Header::Format::ascii
                            : word == "binary_little_endian" ? Header::Format::little
                                                             : Header::Format::big;
        } else if (word == "element") {
            Element element;
            words >> element.name >> element.count;
            if (!words || element.count < 0)
                throw UsageError(at(file, header.lines, "an element needs a name and a count of at least 0"));
            header.elements.push_back(element);
        } else if (word == "property") {
            if (header.elements.empty()) throw UsageError(at(file, header.lines, "a property must follow its element"));
            header.elements.back().properties.push_back(parse_property(words, file, header.lines));
        } else if (word == "comment") {
            std::int64_t index = 0;
            if (!(words >> word) || word != "label" || !(words >> index) || index < 0 || index > 1000000) continue;
            std::string label;
            std::getline(words >> std::ws, label);
            if (static_cast<std::size_t>(index) >= header.names.size())
                header.names.resize(static_cast<std::size_t>(index) + 1);
            header.names[static_cast<std::size_t>(index)] = label;
        }
    }
}

/// Takes values off the data one by one, as double: exact for all PLY integers.
class Values {
public:
    Values(std::string_view bytes, const Header& header, const std::string& file)
        : here_(bytes.substr(header.size)), format_(header.format), file_(file) {}

    double next(Type type, const Element& element, std::int64_t row) {
        if (format_ == Header::Format::ascii) return next_word(element, row);
        const std::size_t size = size_of(type);
        if (here_.size() < size) fail("the data end", element, row);
        std::array<char, 8> raw{};
        std::copy_n(here_.begin(), size, raw.begin());
        here_.remove_prefix(size);
        const bool is_native = (format_ == Header::Format::little) == (std::endian::native == std::endian::little);
        if (!is_native) std::reverse(raw.begin(), raw.begin() + static_cast<std::ptrdiff_t>(size));
        switch (type) {
            case Type::i8:
                return load<std::int8_t>(raw);
            case Type::u8:
                return load<std::uint8_t>(raw);
            case Type::i16:
                return load<std::int16_t>(raw);
            case Type::u16:
                return load<std::uint16_t>(raw);
            case Type::i32:
                return load<std::int32_t>(raw);
            case Type::u32:
                return load<std::uint32_t>(raw);
            case Type::f32:
                return static_cast<double>(load<float>(raw));
            case Type::f64:
                break;
        }
        return load<double>(raw);
    }

    [[noreturn]] void fail(const std::string& what, const Element& element, std::int64_t row) const {
        throw UsageError(
            at(file_, 0,
               what + " at " + element.name + " " + std::to_string(row) + " of " + std::to_string(element.count)));
    }

private:
    template <class Value>
    static Value load(const std::array<char, 8>& raw) {
        Value value;
        std::memcpy(&value, raw.data(), sizeof(Value));
        return value;
    }

    double next_word(const Element& element, std::int64_t row) {
        const std::size_t begin = here_.find_first_not_of(" \t\r\n");
        if (begin == std::string_view::npos) fail("the data end", element, row);
        here_.remove_prefix(begin);
        const std::string_view word = here_.substr(0, here_.find_first_of(" \t\r\n"));
        double value = 0;
        const auto [stop, error] = std::from_chars(word.data(), word.data() + word.size(), value);
        if (error != std::errc() || stop != word.data() + word.size())
            fail("\"" + std::string(word) + "\" is not a number", element, row);
        here_.remove_prefix(word.size());
        return value;
    }

    std::string_view here_;
    Header::Format format_;
    const std::string& file_;
};

const Property* find_label(const Header& header) {
    for (const Element& element : header.elements)
        for (const Property& property : element.properties)
            if (element.name == "face" && property.name == "label" && !property.is_list && is_integer(property.type))
                return &property;
    return nullptr;
}

}  // namespace

PlyLabels read_ply_labels(std::string_view bytes, const std::string& name) {
    const Header header = parse_header(bytes, name);
    if (find_label(header) == nullptr)
        throw UsageError(at(name, 0, "truth in a PLY file needs a face property \"label\" of an integer type"));
    PlyLabels result;
    result.names = header.names;
    Values values(bytes, header, name);
    for (const Element& element : header.elements) {
        if (element.properties.empty()) continue;
        for (std::int64_t row = 0; row < element.count; ++row)
            for (const Property& property : element.properties) {
                if (property.is_list) {
                    const double count = values.next(property.count_type, element, row);
                    if (!(count >= 0)) values.fail("a list of negative length", element, row);
                    for (double i = 0; i < count; ++i) (void)values.next(property.type, element, row);
                    continue;
                }
                const double value = values.next(property.type, element, row);
                if (element.name != "face" || !is_integer(property.type)) continue;
                if (property.name != "label" && property.name != "input_face") continue;
                if (!(value >= -2147483648.0 && value <= 4294967295.0))
                    values.fail("a number out of range", element, row);
                (property.name == "label" ? result.labels : result.input_faces)
                    .push_back(static_cast<std::int64_t>(value));
            }
    }
    return result;
}

}  // namespace partonomy
