#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>

#include "base/errors.h"
#include "base/spelling.h"
#include "mesh/appearance.h"
#include "mesh/decode_image.h"
#include "mesh/material_library.h"
#include "mesh/readers.h"
#include "mesh/text_cursor.h"

// Wavefront OBJ: of its many statements only "v x y z" and "f a b c ..." matter here. A corner is written v, v/vt,
// v//vn or v/vt/vn; indices start at 1, negative ones count back from the latest vertex. A backslash at the end of a
// line continues it. Faces may name vertices that come later in the file, so the upper bound is checked at the end.
//
// Where colours are wanted, so do "mtllib FILE", "usemtl NAME", "vt u v", and three numbers behind a vertex: its
// colour. Of the materials only those that faces use are looked up, and only their images are decoded.

namespace partonomy {
namespace {

/// The largest index so far and where it was first used.
struct LargestIndex {
    std::int64_t index = 0;
    const char* place = nullptr;
};

/// What is gathered of colours while the file is read; all of it is resolved at the end.
struct ColorNotes {
    struct Named {
        std::string name;
        const char* place;
    };
    std::vector<Named> libraries, materials;  ///< materials in the order of their first use
    std::map<std::string, std::int32_t, std::less<>> number_of;
    std::int32_t current = -1;
    std::vector<TexturePoint> points;
    std::vector<std::int64_t> corner_points;  ///< per corner: index from 1, 0 for none
    LargestIndex largest_point;
};

/// The rest of the statement as one name; blanks inside it count.
std::string read_name(TextCursor& cursor, const char* of_what) {
    if (cursor.at_line_end()) cursor.fail_here(fmt::format("the name of {} was expected", of_what));
    const char* begin = cursor.position();
    std::string_view last;
    while (!cursor.at_line_end()) last = cursor.word();
    return {begin, last.data() + last.size()};
}

/// Like TextCursor::at_line_end, but steps over a backslash that continues the line.
bool at_statement_end(TextCursor& cursor) {
    while (!cursor.at_line_end()) {
        if (*cursor.position() != '\\') return false;
        const char* place = cursor.position();
        static_cast<void>(cursor.word());
        if (!cursor.at_line_end()) cursor.fail_at(place, "a backslash continues a line only when it is the last on it");
        cursor.next_line();
    }
    return true;
}

/// The vt of a corner written as v/vt or v/vt/vn, whose v ends at `slash`.
std::int64_t read_texture_index(TextCursor& cursor, const char* slash, const char* end, const char* place,
                                ColorNotes& colors) {
    std::int64_t index = 0;
    if (slash == end || slash + 1 == end || slash[1] == '/') return 0;
    const char* stop = TextCursor::parse_number(slash + 1, end, index);
    const auto points = static_cast<std::int64_t>(colors.points.size());
    if (stop == nullptr || (stop != end && *stop != '/') || index == 0 || index < -points)
        cursor.fail_at(place, "the texture point of a corner v/vt is a whole number: 1 is the first, -1 the latest");
    if (index < 0) index += points + 1;
    if (index > colors.largest_point.index) colors.largest_point = {index, place};
    return index;
}

void read_face(TextCursor& cursor, PolygonSoup& soup, LargestIndex& largest, ColorNotes* colors) {
    const auto vertices = static_cast<std::int64_t>(soup.positions.size());
    while (!at_statement_end(cursor)) {
        const char* place = cursor.position();
        std::string_view word = cursor.word();
        const bool continued = word.ends_with('\\');
        if (continued) word.remove_suffix(1);
        std::int64_t index = 0;
        const char* stop = TextCursor::parse_number(word.data(), word.data() + word.size(), index);
        if (stop == nullptr || (stop != word.data() + word.size() && *stop != '/'))
            cursor.fail_at(place, "a face needs corners written as v, v/vt, v//vn or v/vt/vn with whole numbers");
        if (index == 0) cursor.fail_at(place, "a face refers to vertex 0; the first vertex of an OBJ file is number 1");
        if (index < 0) {
            if (index < -vertices)
                cursor.fail_at(place,
                               fmt::format("a face refers to vertex {}, counted back from the latest, but only {} "
                                           "vertices stand before it",
                                           index, vertices));
            index += vertices + 1;
        }
        if (index > largest.index) largest = {index, place};
        if (index <= largest_count) soup.corners.push_back(static_cast<std::int32_t>(index - 1));
        if (colors)
            colors->corner_points.push_back(
                read_texture_index(cursor, stop, word.data() + word.size(), place, *colors));
        if (continued && cursor.at_line_end()) cursor.next_line();
    }
    soup.face_starts.push_back(static_cast<std::int64_t>(soup.corners.size()));
}

/// The colour of a vertex: three numbers behind its place, when there are exactly three.
Color read_vertex_color(TextCursor& cursor) {
    Color color;
    for (int i = 0; i < 3; ++i)
        if (at_statement_end(cursor) || !cursor.read(color[i])) return unknown_color();
    return at_statement_end(cursor) ? color : unknown_color();
}

/// mtllib, usemtl and vt; true when it was one of them.
bool read_color_statement(TextCursor& cursor, std::string_view statement, ColorNotes& colors) {
    const char* place = cursor.position();
    if (statement == "mtllib") {
        colors.libraries.push_back({read_name(cursor, "a material library"), place});
    } else if (statement == "usemtl") {
        const std::string name = read_name(cursor, "a material");
        const auto [found, is_new] = colors.number_of.emplace(name, static_cast<std::int32_t>(colors.materials.size()));
        if (is_new) colors.materials.push_back({name, place});
        colors.current = found->second;
    } else if (statement == "vt") {
        TexturePoint point(0, 0);
        if (at_statement_end(cursor) || !cursor.read(point.x()))
            cursor.fail_here(fmt::format("texture point {} needs numbers u v", colors.points.size() + 1));
        if (!at_statement_end(cursor) && !cursor.read(point.y()))
            cursor.fail_here(fmt::format("texture point {} needs numbers u v", colors.points.size() + 1));
        colors.points.emplace_back(point.x(), 1 - point.y());  // v runs upwards in OBJ files
    } else {
        return false;
    }
    return true;
}

/// The materials of all libraries by name; of two with one name the first.
std::map<std::string, LibraryMaterial> read_libraries(const TextCursor& cursor, const Companions& companions,
                                                      const std::vector<ColorNotes::Named>& libraries) {
    std::map<std::string, LibraryMaterial> materials;
    for (const auto& [name, place] : libraries) {
        std::vector<std::string> files;
        if (companions.has(name) || name.find(' ') == std::string::npos) {
            files.push_back(name);  // one file, which may have blanks in its name
        } else {
            for (std::size_t begin = 0; begin < name.size();) {
                const std::size_t end = std::min(name.find_first_of(" \t", begin), name.size());
                if (end > begin) files.push_back(name.substr(begin, end - begin));
                begin = end + 1;
            }
        }
        for (const std::string& file : files) {
            const std::string asker = at(cursor.name(), cursor.line_of(place), "the material library");
            for (LibraryMaterial& material : parse_mtl(companions.read(file, asker, largest_library_bytes), file)) {
                const std::size_t slash = file.find_last_of("/\\");
                material.folder = slash == std::string::npos ? "" : file.substr(0, slash + 1);
                materials.try_emplace(material.material.name, std::move(material));
            }
        }
    }
    return materials;
}

void resolve_colors(const TextCursor& cursor, const PolygonSoup& soup, const Companions& companions, ColorNotes& colors,
                    SoupAppearance& appearance) {
    if (colors.largest_point.index > static_cast<std::int64_t>(colors.points.size()))
        cursor.fail_at(colors.largest_point.place, fmt::format("a face refers to texture point {}, but the file has {}",
                                                               colors.largest_point.index, colors.points.size()));
    if (!appearance.vertex_colors.empty()) appearance.vertex_colors.resize(soup.positions.size(), unknown_color());
    from_srgb(appearance.vertex_colors);
    std::map<std::string, LibraryMaterial> materials = read_libraries(cursor, companions, colors.libraries);
    std::map<std::string, int> images;
    std::vector<LibraryMaterial> used;
    for (const auto& [name, place] : colors.materials) {
        const auto found = materials.find(name);
        if (found == materials.end()) {
            std::vector<std::string> names;
            for (const auto& [other, each] : materials) names.push_back(other);
            cursor.fail_at(place, fmt::format("there is no material '{}' in the material libraries{}", name,
                                              names.empty() ? "; name them with mtllib"
                                                            : did_you_mean({name}, names, Nearness::any)));
        }
        LibraryMaterial& material = used.emplace_back(found->second);
        if (!material.image.empty()) {
            const auto [image, is_new] =
                images.try_emplace(material.image_path(), static_cast<int>(appearance.images.size()));
            if (is_new) {
                const std::string asker = at(material.library, material.image_line, "the image");
                appearance.images.push_back(decode_image(
                    companions.read(image->first, asker, largest_image_bytes),
                    at(material.library, material.image_line, fmt::format("the image '{}'", material.image))));
            }
            material.material.image = image->second;
        }
        appearance.materials.push_back(material.material);
    }
    if (appearance.images.empty()) return;
    for (std::size_t f = 0; f + 1 < soup.face_starts.size(); ++f) {
        const std::int32_t number = appearance.face_materials[f];
        for (auto c = static_cast<std::size_t>(soup.face_starts[f]);
             c < static_cast<std::size_t>(soup.face_starts[f + 1]); ++c) {
            const std::int64_t index = colors.corner_points[c];
            TexturePoint point = index == 0 ? TexturePoint(0, 0) : colors.points[static_cast<std::size_t>(index - 1)];
            if (number >= 0) {
                const LibraryMaterial& material = used[static_cast<std::size_t>(number)];
                point = {material.scale.x() * point.x() + material.offset.x(),
                         1 - (material.scale.y() * (1 - point.y()) + material.offset.y())};
            }
            appearance.corner_points.push_back(point);
        }
    }
}

}  // namespace

PolygonSoup parse_obj(std::string_view bytes, const std::string& name, const Companions& companions,
                      SoupAppearance* appearance) {
    TextCursor cursor(bytes, name, '#');
    PolygonSoup soup;
    soup.face_starts.push_back(0);
    LargestIndex largest;
    std::optional<ColorNotes> colors;
    if (appearance) colors.emplace();
    std::int64_t lines_and_points = 0, surfaces = 0;
    for (; cursor.find_content(); cursor.next_line()) {
        const std::string_view statement = cursor.word();
        if (statement == "v") {
            Vec3 point;
            for (int axis = 0; axis < 3; ++axis)
                if (at_statement_end(cursor) || !cursor.read(point[axis]))
                    cursor.fail_here(fmt::format("vertex {} needs three numbers x y z", soup.positions.size() + 1));
            if (!is_usable(point))
                cursor.fail(what_is_wrong_with(point, static_cast<std::int64_t>(soup.positions.size()) + 1));
            soup.positions.push_back(point);
            if (appearance && !at_statement_end(cursor))
                if (const Color color = read_vertex_color(cursor); is_known(color)) {
                    appearance->vertex_colors.resize(soup.positions.size() - 1, unknown_color());
                    appearance->vertex_colors.push_back(color);
                }
            continue;
        }
        if (statement == "f" || statement == "fo") {
            read_face(cursor, soup, largest, colors ? &*colors : nullptr);
            if (colors) appearance->face_materials.push_back(colors->current);
            continue;
        }
        if (colors && read_color_statement(cursor, statement, *colors)) continue;
        lines_and_points += statement == "l" || statement == "p";
        surfaces += statement == "surf" || statement == "curv";
        // Only a text statement may end its line in a backslash that means nothing; all others continue.
        while (!cursor.at_line_end()) {
            const std::string_view word = cursor.word();
            if (word.ends_with('\\') && cursor.at_line_end()) cursor.next_line();
        }
    }
    const auto vertices = static_cast<std::int64_t>(soup.positions.size());
    if (largest.index > vertices)
        cursor.fail_at(largest.place, fmt::format("a face refers to vertex {}, but the file has {} vertices",
                                                  largest.index, vertices));
    if (colors) resolve_colors(cursor, soup, companions, *colors, *appearance);
    if (lines_and_points > 0)
        soup.notes.push_back(fmt::format("{} lines and points were passed over.", lines_and_points));
    if (surfaces > 0) soup.notes.push_back(fmt::format("{} curves and free-form surfaces were passed over.", surfaces));
    return soup;
}

}  // namespace partonomy
