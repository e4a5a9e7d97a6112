#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <optional>

#include "base/errors.h"
#include "mesh/appearance.h"
#include "mesh/readers.h"
#include "mesh/text_cursor.h"

// PLY, the Stanford polygon format: a header that declares elements and their properties, then the elements' rows as
// text or as packed numbers of either byte order. The elements `vertex` (x, y, z) and `face` (a list vertex_indices or
// vertex_index) are read, wherever they stand among others; every other element and property is stepped over,
// but for colours where they are wanted: red, green and blue of faces or vertices, as whole numbers up to the largest
// of their type, or as fractions.

namespace partonomy {
namespace {

enum class Type { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

struct Property {
    std::string name;
    Type type = Type::int32;
    std::optional<Type> count_type;  ///< of a list
};

struct Element {
    std::string name;
    std::int64_t count = 0;
    std::vector<Property> properties;
};

enum class Encoding { ascii, little, big };

struct Header {
    Encoding encoding = Encoding::ascii;
    std::vector<Element> elements;
    std::size_t size = 0;  ///< bytes up to the first row
};

std::size_t size_of(Type type) {
    switch (type) {
        case Type::int8:
        case Type::uint8:
            return 1;
        case Type::int16:
        case Type::uint16:
            return 2;
        case Type::int32:
        case Type::uint32:
        case Type::float32:
            return 4;
        case Type::float64:
            break;
    }
    return 8;
}

Type read_type(TextCursor& cursor, bool integer) {
    static constexpr std::pair<const char*, Type> names[] = {
        {"char", Type::int8},     {"int8", Type::int8},       {"uchar", Type::uint8},    {"uint8", Type::uint8},
        {"short", Type::int16},   {"int16", Type::int16},     {"ushort", Type::uint16},  {"uint16", Type::uint16},
        {"int", Type::int32},     {"int32", Type::int32},     {"uint", Type::uint32},    {"uint32", Type::uint32},
        {"float", Type::float32}, {"float32", Type::float32}, {"double", Type::float64}, {"float64", Type::float64}};
    static_cast<void>(cursor.at_line_end());
    const char* place = cursor.position();
    const std::string_view word = cursor.word();
    for (const auto& [name, type] : names)
        if (word == name && (!integer || size_of(type) < 4 || type == Type::int32 || type == Type::uint32)) return type;
    cursor.go_to(place);
    cursor.fail_here(integer ? "the type of a list's length was expected, such as uchar or int"
                             : "the type of a property was expected, such as float or int");
}

std::string read_name(TextCursor& cursor, const char* of_what) {
    const std::string_view word = cursor.word();
    if (word.empty()) cursor.fail_here(fmt::format("the name of {} was expected", of_what));
    return std::string(word);
}

Encoding read_encoding(TextCursor& cursor) {
    static_cast<void>(cursor.at_line_end());
    const char* place = cursor.position();
    const std::string_view word = cursor.word();
    if (word == "ascii") return Encoding::ascii;
    if (word == "binary_little_endian") return Encoding::little;
    if (word == "binary_big_endian") return Encoding::big;
    cursor.go_to(place);
    cursor.fail_here("the format is one of ascii, binary_little_endian and binary_big_endian");
}

Element read_element(TextCursor& cursor) {
    Element element;
    element.name = read_name(cursor, "an element");
    static_cast<void>(cursor.at_line_end());
    const char* place = cursor.position();
    if (!cursor.read(element.count))
        cursor.fail_here(fmt::format("the number of '{}' elements was expected", element.name));
    if (element.count < 0 || element.count > largest_count)
        cursor.fail_at(place, fmt::format("the file announces {} elements; a count runs from 0 to {}", element.count,
                                          largest_count));
    return element;
}

Property read_property(TextCursor& cursor) {
    Property property;
    static_cast<void>(cursor.at_line_end());
    const char* place = cursor.position();
    if (cursor.word() == "list")
        property.count_type = read_type(cursor, true);
    else
        cursor.go_to(place);
    property.type = read_type(cursor, false);
    property.name = read_name(cursor, "a property");
    return property;
}

/// Where the line `end_header` begins; throws when there is none.
std::size_t find_header_end(std::string_view bytes, const std::string& name) {
    constexpr std::string_view word = "end_header";
    for (std::size_t place = 0; (place = bytes.find(word, place)) != std::string_view::npos; ++place) {
        const std::size_t after = place + word.size();
        const auto is_break = [&](std::size_t i) { return bytes[i] == '\n' || bytes[i] == '\r'; };
        if (place > 0 && is_break(place - 1) && (after == bytes.size() || is_break(after) || bytes[after] == ' '))
            return place;
    }
    throw MeshError(at(name, 0, "is cut off or no PLY file: the line 'end_header' is missing"));
}

Header read_header(std::string_view bytes, const std::string& name) {
    const std::size_t end = find_header_end(bytes, name);
    TextCursor cursor(bytes.substr(0, end), name, '\0');  // without the rows, which may hold any byte
    Header header;
    bool has_format = false;
    for (cursor.next_line(); cursor.find_content(); cursor.next_line()) {
        const char* place = cursor.position();
        const std::string_view word = cursor.word();
        if (word == "format") {
            header.encoding = read_encoding(cursor);
            has_format = true;
        } else if (word == "element") {
            header.elements.push_back(read_element(cursor));
        } else if (word == "property") {
            if (header.elements.empty()) cursor.fail_at(place, "a property stands before the first element");
            header.elements.back().properties.push_back(read_property(cursor));
        } else if (word != "comment" && word != "obj_info") {
            cursor.go_to(place);
            cursor.fail_here(
                "a line of a PLY header begins with format, element, property, comment, obj_info or end_header");
        }
    }
    if (!has_format) cursor.fail("the PLY header has no line 'format ascii 1.0' or the like");
    header.size = std::min(bytes.size(), bytes.find_first_of("\r\n", end));
    const bool lines_end_in_return_only = bytes.substr(0, end).find('\n') == std::string_view::npos;
    if (bytes.substr(header.size).starts_with("\r\n") && !lines_end_in_return_only) ++header.size;
    header.size = std::min(bytes.size(), header.size + 1);
    return header;
}

/// Rows as text, one a line.
class AsciiRows {
public:
    AsciiRows(std::string_view bytes, const std::string& name, std::size_t start) : cursor_(bytes, name, '\0') {
        cursor_.go_to(bytes.data() + start);
    }
    void begin_row(const Element& element, std::int64_t row) {
        if (!cursor_.find_content()) {
            cursor_.fail(fmt::format("the file ends after {} of the {} '{}' elements that it announces", row,
                                     element.count, element.name));
        }
    }
    void end_row() { cursor_.next_line(); }
    double real(Type) {
        double value = 0;
        if (!cursor_.read(value)) cursor_.fail_here("a number was expected");
        return value;
    }
    std::int64_t whole(Type) {
        std::int64_t value = 0;
        if (!cursor_.read(value)) cursor_.fail_here("a whole number was expected");
        return value;
    }
    void skip(Type type, std::int64_t count) {
        for (; count > 0; --count) static_cast<void>(real(type));
    }
    [[noreturn]] void fail(const std::string& sentence) { cursor_.fail(sentence); }
    [[nodiscard]] std::size_t bytes_left() const { return cursor_.bytes_left(); }
    [[nodiscard]] bool only_blanks_left() { return !cursor_.find_content(); }

private:
    TextCursor cursor_;
};

/// Rows of packed numbers.
template <bool big_endian>
class BinaryRows {
public:
    BinaryRows(std::string_view bytes, const std::string& name, std::size_t start)
        : here_(bytes.data() + start), end_(bytes.data() + bytes.size()), name_(name) {}
    void begin_row(const Element& element, std::int64_t row) {
        element_ = &element;
        row_ = row;
    }
    void end_row() {}
    double real(Type type) {
        if (type == Type::float32) return std::bit_cast<float>(static_cast<std::uint32_t>(take(4)));
        if (type == Type::float64) return std::bit_cast<double>(take(8));
        return static_cast<double>(whole(type));
    }
    std::int64_t whole(Type type) {
        switch (type) {
            case Type::int8:
                return static_cast<std::int8_t>(take(1));
            case Type::uint8:
                return static_cast<std::uint8_t>(take(1));
            case Type::int16:
                return static_cast<std::int16_t>(take(2));
            case Type::uint16:
                return static_cast<std::uint16_t>(take(2));
            case Type::int32:
                return static_cast<std::int32_t>(take(4));
            case Type::uint32:
                return static_cast<std::uint32_t>(take(4));
            case Type::float32:
            case Type::float64:
                break;
        }
        const double value = real(type);  // some programs store indices so
        return std::abs(value) <= 1e15 ? static_cast<std::int64_t>(value) : -1;
    }
    void skip(Type type, std::int64_t count) {
        if (count <= 0) return;
        if (static_cast<std::size_t>(count) > bytes_left() / size_of(type)) cut_off();
        here_ += static_cast<std::size_t>(count) * size_of(type);
    }
    [[noreturn]] void fail(const std::string& sentence) { throw MeshError(at(name_, 0, sentence)); }
    [[nodiscard]] std::size_t bytes_left() const { return static_cast<std::size_t>(end_ - here_); }
    [[nodiscard]] bool only_blanks_left() const {
        return std::all_of(here_, end_, [](char c) { return c == '\n' || c == '\r' || c == ' ' || c == '\0'; });
    }

private:
    [[noreturn]] void cut_off() {
        fail(fmt::format("is cut off after {} of the {} '{}' elements that it announces", row_, element_->count,
                         element_->name));
    }
    std::uint64_t take(std::size_t size) {
        if (bytes_left() < size) cut_off();
        std::uint64_t value = 0;
        if constexpr (big_endian) {
            for (std::size_t i = 0; i < size; ++i) value = value << 8 | static_cast<unsigned char>(here_[i]);
        } else if constexpr (std::endian::native == std::endian::little) {
            std::memcpy(&value, here_, size);
        } else {
            for (std::size_t i = size; i-- > 0;) value = value << 8 | static_cast<unsigned char>(here_[i]);
        }
        here_ += size;
        return value;
    }

    const char* here_;
    const char* end_;
    const std::string& name_;
    const Element* element_ = nullptr;
    std::int64_t row_ = 0;
};

template <class Rows>
void skip_property(Rows& rows, const Property& property) {
    rows.skip(property.type, property.count_type ? rows.whole(*property.count_type) : 1);
}

/// The place of a property among an element's; nullopt when it has none of that name, or not of that kind.
std::optional<std::size_t> find_property(const Element& element, std::string_view name, bool list) {
    for (std::size_t i = 0; i < element.properties.size(); ++i)
        if (element.properties[i].name == name && element.properties[i].count_type.has_value() == list) return i;
    return std::nullopt;
}

/// Which channel each property of an element is, -1 for none; empty when it has no colours.
std::vector<int> find_channels(const Element& element) {
    static constexpr const char* names[][3] = {
        {"red", "green", "blue"}, {"r", "g", "b"}, {"diffuse_red", "diffuse_green", "diffuse_blue"}};
    for (const auto& channels : names) {
        std::vector<int> found(element.properties.size(), -1);
        int count = 0;
        for (int c = 0; c < 3; ++c)
            if (const auto place = find_property(element, channels[c], false)) {
                found[*place] = c;
                ++count;
            }
        if (count == 3) return found;
    }
    return {};
}

/// A channel as a fraction; what is stored in floating point stays as it is.
template <class Rows>
float read_channel(Rows& rows, Type type) {
    const double value = rows.real(type);
    if (type == Type::float32 || type == Type::float64) return static_cast<float>(value);
    const std::size_t bits = 8 * size_of(type) - (type == Type::int8 || type == Type::int16 || type == Type::int32);
    return static_cast<float>(value / static_cast<double>((std::uint64_t{1} << bits) - 1));
}

template <class Rows>
void read_vertices(Rows& rows, const Element& element, PolygonSoup& soup, SoupAppearance* appearance) {
    std::vector<int> axis_of(element.properties.size(), -1);
    for (int axis = 0; axis < 3; ++axis) {
        const auto place =
            find_property(element, std::string_view("xyz").substr(static_cast<std::size_t>(axis), 1), false);
        if (!place) rows.fail("the element 'vertex' of the PLY header needs the properties x, y and z");
        axis_of[*place] = axis;
    }
    const std::vector<int> channels = appearance ? find_channels(element) : std::vector<int>{};
    Color color = unknown_color();
    if (!channels.empty()) appearance->vertex_colors.resize(soup.positions.size(), color);
    soup.positions.reserve(std::min(static_cast<std::size_t>(element.count), rows.bytes_left() / 3 + 1));
    for (std::int64_t row = 0; row < element.count; ++row) {
        rows.begin_row(element, row);
        Vec3 point;
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            if (axis_of[i] >= 0)
                point[axis_of[i]] = rows.real(element.properties[i].type);
            else if (!channels.empty() && channels[i] >= 0)
                color[channels[i]] = read_channel(rows, element.properties[i].type);
            else
                skip_property(rows, element.properties[i]);
        }
        if (!channels.empty()) appearance->vertex_colors.push_back(color);
        if (!is_usable(point)) rows.fail(what_is_wrong_with(point, row));
        soup.positions.push_back(point);
        rows.end_row();
    }
}

template <class Rows>
void read_faces(Rows& rows, const Element& element, std::int64_t vertices, PolygonSoup& soup,
                SoupAppearance* appearance) {
    auto corners = find_property(element, "vertex_indices", true);
    if (!corners) corners = find_property(element, "vertex_index", true);
    if (!corners) rows.fail("the element 'face' of the PLY header needs a list property vertex_indices");
    const std::vector<int> channels = appearance ? find_channels(element) : std::vector<int>{};
    Color color = unknown_color();
    if (!channels.empty()) appearance->face_colors.resize(static_cast<std::size_t>(soup.face_count()), color);
    const auto count = static_cast<std::size_t>(element.count);
    soup.corners.reserve(std::min(3 * count, rows.bytes_left() / 2 + 1));
    soup.face_starts.reserve(std::min(count, rows.bytes_left()) + 2);
    if (soup.face_starts.empty()) soup.face_starts.push_back(0);
    for (std::int64_t row = 0; row < element.count; ++row) {
        rows.begin_row(element, row);
        for (std::size_t i = 0; i < element.properties.size(); ++i) {
            const Property& property = element.properties[i];
            if (i != *corners) {
                if (!channels.empty() && channels[i] >= 0)
                    color[channels[i]] = read_channel(rows, property.type);
                else
                    skip_property(rows, property);
                continue;
            }
            const std::int64_t size = rows.whole(*property.count_type);
            if (size < 0) rows.fail(fmt::format("face {} has {} corners; a count cannot be negative", row, size));
            for (std::int64_t k = 0; k < size; ++k) {
                const std::int64_t index = rows.whole(property.type);
                if (index < 0 || index >= vertices)
                    rows.fail(
                        fmt::format("face {} refers to vertex {}; indices run from 0 to {}", row, index, vertices - 1));
                soup.corners.push_back(static_cast<std::int32_t>(index));
            }
        }
        soup.face_starts.push_back(static_cast<std::int64_t>(soup.corners.size()));
        if (!channels.empty()) appearance->face_colors.push_back(color);
        rows.end_row();
    }
}

template <class Rows>
void skip_element(Rows& rows, const Element& element) {
    if (element.properties.empty()) return;
    for (std::int64_t row = 0; row < element.count; ++row) {
        rows.begin_row(element, row);
        for (const Property& property : element.properties) skip_property(rows, property);
        rows.end_row();
    }
}

template <class Rows>
PolygonSoup read_rows(Rows rows, const Header& header, SoupAppearance* appearance) {
    std::int64_t vertices = 0;
    for (const Element& element : header.elements)
        if (element.name == "vertex") vertices += element.count;
    PolygonSoup soup;
    for (const Element& element : header.elements) {
        if (element.name == "vertex")
            read_vertices(rows, element, soup, appearance);
        else if (element.name == "face")
            read_faces(rows, element, vertices, soup, appearance);
        else
            skip_element(rows, element);
    }
    if (appearance) {
        if (!appearance->vertex_colors.empty())
            appearance->vertex_colors.resize(soup.positions.size(), unknown_color());
        if (!appearance->face_colors.empty())
            appearance->face_colors.resize(static_cast<std::size_t>(soup.face_count()), unknown_color());
        from_srgb(appearance->vertex_colors);
        from_srgb(appearance->face_colors);
    }
    if (rows.bytes_left() > 0 && !rows.only_blanks_left())
        soup.notes.push_back("What follows the last announced element of the PLY file was not read.");
    return soup;
}

}  // namespace

PolygonSoup parse_ply(std::string_view bytes, const std::string& name, SoupAppearance* appearance) {
    const Header header = read_header(bytes, name);
    if (header.encoding == Encoding::ascii) return read_rows(AsciiRows(bytes, name, header.size), header, appearance);
    if (header.encoding == Encoding::little)
        return read_rows(BinaryRows<false>(bytes, name, header.size), header, appearance);
    return read_rows(BinaryRows<true>(bytes, name, header.size), header, appearance);
}

}  // namespace partonomy
