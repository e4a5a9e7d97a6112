#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <cstring>

#include "base/errors.h"
#include "mesh/readers.h"
#include "mesh/text_cursor.h"

// STL, a list of triangles without shared vertices. The readers number equal points once, as they come: a binary file
// of five million triangles would otherwise need 15 million positions of which five in six are copies. The normals in
// the file are not used; too many programs write wrong ones.

namespace partonomy {
namespace {

constexpr std::size_t header_size = 84, record_size = 50;

/// Numbers points in order of first appearance. Open addressing, at most half full.
class PointNumbers {
public:
    explicit PointNumbers(std::vector<Vec3>& points) : points_(points), slots_(1024, -1) {}

    std::int32_t number(const Vec3& point) {
        for (std::size_t slot = hash(point);; ++slot) {
            std::int32_t& entry = slots_[slot & (slots_.size() - 1)];
            if (entry >= 0 && points_[static_cast<std::size_t>(entry)] != point) continue;
            if (entry >= 0) return entry;
            const auto added = entry = static_cast<std::int32_t>(points_.size());
            points_.push_back(point);
            if (2 * points_.size() > slots_.size()) grow();
            return added;
        }
    }

private:
    static std::size_t hash(const Vec3& point) {
        std::uint64_t mixed = 0;
        for (int axis = 0; axis < 3; ++axis)  // + 0.0 makes -0 and 0 one
            mixed = (std::rotl(mixed, 23) ^ std::bit_cast<std::uint64_t>(point[axis] + 0.0)) * 0x9E3779B97F4A7C15U;
        return static_cast<std::size_t>(mixed ^ (mixed >> 32));
    }
    void grow() {
        slots_.assign(2 * slots_.size(), -1);
        for (std::size_t i = 0; i < points_.size(); ++i) {
            std::size_t slot = hash(points_[i]);
            while (slots_[slot & (slots_.size() - 1)] >= 0) ++slot;
            slots_[slot & (slots_.size() - 1)] = static_cast<std::int32_t>(i);
        }
    }

    std::vector<Vec3>& points_;
    std::vector<std::int32_t> slots_;
};

float little_endian_float(const char* bytes) {
    std::uint32_t bits = 0;
    for (int i = 3; i >= 0; --i) bits = bits << 8 | static_cast<unsigned char>(bytes[i]);
    return std::bit_cast<float>(bits);
}

std::uint64_t announced_triangles(std::string_view bytes) {
    std::uint64_t count = 0;
    for (std::size_t i = header_size; i-- > 80;) count = count << 8 | static_cast<unsigned char>(bytes[i]);
    return count;
}

/// The keyword that a line begins with, in lower case; long words are cut, they are no keywords.
std::string keyword(TextCursor& cursor) {
    std::string word(cursor.word().substr(0, 16));
    for (char& c : word) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return word;
}

}  // namespace

bool looks_like_binary_stl(std::string_view bytes) {
    if (bytes.size() < header_size || bytes.starts_with("ply")) return false;
    if (bytes.size() == header_size + record_size * announced_triangles(bytes)) return true;
    // Cut off or with a tail: a header of text and zeros. Other binary formats have control characters there.
    const std::string_view header = bytes.substr(0, 80);
    const bool clean = std::all_of(header.begin(), header.end(), [](char c) {
        return c == '\0' || c == '\t' || c == '\n' || c == '\r' || static_cast<unsigned char>(c) >= ' ';
    });
    return clean && bytes.substr(0, header_size).find('\0') != std::string_view::npos;
}

PolygonSoup parse_stl_binary(std::string_view bytes, const std::string& name) {
    const auto fail = [&](const std::string& sentence) { throw MeshError(at(name, 0, sentence)); };
    const std::uint64_t count = announced_triangles(bytes), needed = header_size + record_size * count;
    if (bytes.size() < needed)
        fail(fmt::format("is cut off: a binary STL file of {} triangles has {} bytes, this one {}", count, needed,
                         bytes.size()));
    PolygonSoup soup;
    if (bytes.size() > needed)
        soup.notes.push_back(fmt::format("{} bytes after the last of the {} announced triangles were not read.",
                                         bytes.size() - needed, count));
    soup.corners.reserve(3 * count);
    soup.face_starts.reserve(count + 1);
    soup.face_starts.push_back(0);
    PointNumbers numbers(soup.positions);
    for (std::uint64_t t = 0; t < count; ++t) {
        const char* record = bytes.data() + header_size + record_size * t + 12;
        for (int corner = 0; corner < 3; ++corner, record += 12) {
            const Vec3 point(little_endian_float(record), little_endian_float(record + 4),
                             little_endian_float(record + 8));
            if (!is_usable(point)) fail(fmt::format("triangle {}: {}", t + 1, what_is_wrong_with(point, corner + 1)));
            soup.corners.push_back(numbers.number(point));
        }
        soup.face_starts.push_back(static_cast<std::int64_t>(soup.corners.size()));
    }
    return soup;
}

PolygonSoup parse_stl_ascii(std::string_view bytes, const std::string& name) {
    TextCursor cursor(bytes, name, '\0');
    PolygonSoup soup;
    soup.face_starts.push_back(0);
    PointNumbers numbers(soup.positions);
    bool in_solid = false, in_facet = false;
    std::int64_t corners = 0;
    for (; cursor.find_content(); cursor.next_line()) {
        const char* place = cursor.position();
        const std::string word = keyword(cursor);
        if (word == "vertex") {
            if (!in_facet) cursor.fail_at(place, "a vertex stands outside of a facet");
            soup.corners.push_back(numbers.number(read_point(cursor, ++corners)));
        } else if (word == "facet") {
            if (in_facet) cursor.fail_at(place, "a facet begins before the last one has ended; 'endfacet' is missing");
            in_facet = true;
            corners = 0;
        } else if (word == "endfacet") {
            if (!in_facet) cursor.fail_at(place, "'endfacet' without a facet");
            if (corners < 3) cursor.fail_at(place, fmt::format("a facet has {} vertices; three are needed", corners));
            in_facet = false;
            soup.face_starts.push_back(static_cast<std::int64_t>(soup.corners.size()));
        } else if (word == "solid" || word == "endsolid") {
            if (in_facet) cursor.fail_at(place, "a solid begins or ends inside a facet; 'endfacet' is missing");
            in_solid = word == "solid";
        } else if (word != "outer" && word != "endloop") {
            cursor.go_to(place);
            cursor.fail_here(
                "a line of an ASCII STL file begins with solid, facet, outer, vertex, endloop, endfacet or "
                "endsolid");
        }
    }
    if (in_facet || in_solid) cursor.fail("the file ends before 'endsolid'; it seems to be cut off");
    return soup;
}

}  // namespace partonomy
