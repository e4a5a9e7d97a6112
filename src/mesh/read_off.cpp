#include <fmt/format.h>

#include <algorithm>

#include "mesh/appearance.h"
#include "mesh/readers.h"
#include "mesh/text_cursor.h"

// OFF, Geomview's object file format: a magic word, the counts of vertices, faces and edges, then one line a vertex and
// one line a face. What follows the coordinates (normal, colour, texture) and the corners (colour) on a line is
// skipped, but for colours where they are wanted: of vertices when the magic word has a C, of faces three or four
// numbers. Some programs count them from 0 to 1, others to 255: to 255 when any of the file is above 1. Faces with
// fewer than three corners are kept: cleaning counts them as degenerate.

namespace partonomy {
namespace {

struct Counts {
    std::int64_t vertices = 0, faces = 0;
    bool has_normals = false, has_colors = false;  ///< of vertices
};

std::int64_t read_count(TextCursor& cursor, const char* of_what) {
    const std::string needed =
        fmt::format("the number of {} was expected, an integer from 0 to {}", of_what, largest_count);
    if (!cursor.find_content()) cursor.fail_here(needed);
    const char* start = cursor.position();
    std::int64_t count = 0;
    if (!cursor.read(count)) cursor.fail_here(needed);
    if (count < 0 || count > largest_count)
        cursor.fail_at(start, fmt::format("the file announces {} {}; {}", count, of_what, needed));
    return count;
}

Counts read_header(TextCursor& cursor) {
    if (!cursor.find_content()) cursor.fail("the file is empty; an OFF file begins with the word OFF");
    const char* start = cursor.position();
    const std::string_view magic = cursor.word();
    if (!is_off_header(magic)) cursor.fail_at(start, "an OFF file begins with the word OFF, COFF, NOFF or STOFF");
    if (magic.find_first_of("4n") != std::string_view::npos)
        cursor.fail_at(start, "vertices of four or n dimensions cannot be read; only three-dimensional OFF files can");
    if (!cursor.at_line_end() && (*cursor.position() == 'B' || *cursor.position() == 'b'))
        cursor.fail("binary OFF cannot be read; save the mesh as ASCII OFF or as PLY");
    Counts counts;
    counts.has_normals = magic.find('N') != std::string_view::npos;
    counts.has_colors = magic.find('C') != std::string_view::npos;
    counts.vertices = read_count(cursor, "vertices");
    counts.faces = read_count(cursor, "faces");
    cursor.next_line();  // the number of edges is not needed, and often wrong
    return counts;
}

/// Three numbers of a colour from the rest of the line; unknown when there are fewer.
Color read_color(TextCursor& cursor) {
    Color color;
    for (int i = 0; i < 3; ++i)
        if (!cursor.read(color[i])) return unknown_color();
    return color;
}

void read_face(TextCursor& cursor, const Counts& counts, std::int64_t number, PolygonSoup& soup) {
    std::int64_t size = 0;
    const char* start = cursor.position();
    if (!cursor.read(size)) cursor.fail_here(fmt::format("face {} begins with its number of corners", number));
    if (size < 0)
        cursor.fail_at(start, fmt::format("face {} has {} corners; a count cannot be negative", number, size));
    for (std::int64_t i = 0; i < size; ++i) {
        std::int64_t index = 0;
        if (!cursor.read(index))
            cursor.fail_here(fmt::format("face {} needs the {} vertex indices that it announces", number, size));
        if (index < 0 || index >= counts.vertices)
            cursor.fail(fmt::format("face {} refers to vertex {}; indices run from 0 to {}", number, index,
                                    counts.vertices - 1));
        soup.corners.push_back(static_cast<std::int32_t>(index));
    }
    soup.face_starts.push_back(static_cast<std::int64_t>(soup.corners.size()));
}

}  // namespace

bool is_off_header(std::string_view word) {
    for (const std::string_view prefix : {"ST", "C", "N", "4", "n"})
        if (word.starts_with(prefix)) word.remove_prefix(prefix.size());
    return word == "OFF";
}

PolygonSoup parse_off(std::string_view bytes, const std::string& name, SoupAppearance* appearance) {
    TextCursor cursor(bytes, name, '#');
    const Counts counts = read_header(cursor);
    PolygonSoup soup;
    // The counts are claims: no line is shorter than "0 0 0\n" or "0\n", so the file's size bounds what they can mean.
    const auto left = static_cast<std::int64_t>(cursor.bytes_left());
    soup.positions.reserve(static_cast<std::size_t>(std::min(counts.vertices, left / 6 + 1)));
    soup.face_starts.reserve(static_cast<std::size_t>(std::min(counts.faces, left / 2 + 1) + 1));
    soup.corners.reserve(static_cast<std::size_t>(std::min(counts.faces * 3, left / 2 + 1)));
    for (std::int64_t i = 0; i < counts.vertices; ++i) {
        if (!cursor.find_content())
            cursor.fail(fmt::format("the file ends after {} of the {} vertices that it announces", i, counts.vertices));
        soup.positions.push_back(read_point(cursor, i));
        if (appearance && counts.has_colors) {
            if (counts.has_normals) static_cast<void>(read_color(cursor));
            appearance->vertex_colors.push_back(read_color(cursor));
        }
        cursor.next_line();
    }
    soup.face_starts.push_back(0);
    for (std::int64_t i = 0; i < counts.faces; ++i) {
        if (!cursor.find_content())
            cursor.fail(fmt::format("the file ends after {} of the {} faces that it announces", i, counts.faces));
        read_face(cursor, counts, i, soup);
        if (appearance) appearance->face_colors.push_back(read_color(cursor));
        cursor.next_line();
    }
    if (appearance) {
        from_srgb(appearance->vertex_colors);
        from_srgb(appearance->face_colors);
    }
    if (cursor.find_content())
        soup.notes.push_back(fmt::format("line {}: what follows the {} announced faces was not read",
                                         cursor.line_of(cursor.position()), counts.faces));
    return soup;
}

}  // namespace partonomy
