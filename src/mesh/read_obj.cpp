#include <fmt/format.h>

#include "mesh/readers.h"
#include "mesh/text_cursor.h"

// Wavefront OBJ: of its many statements only "v x y z" and "f a b c ..." matter here. A corner is written v, v/vt,
// v//vn or v/vt/vn; indices start at 1, negative ones count back from the latest vertex. A backslash at the end of a
// line continues it. Faces may name vertices that come later in the file, so the upper bound is checked at the end.

namespace partonomy {
namespace {

/// The largest index so far and where it was first used.
struct LargestIndex {
    std::int64_t index = 0;
    const char* place = nullptr;
};

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

void read_face(TextCursor& cursor, PolygonSoup& soup, LargestIndex& largest) {
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
        if (continued && cursor.at_line_end()) cursor.next_line();
    }
    soup.face_starts.push_back(static_cast<std::int64_t>(soup.corners.size()));
}

}  // namespace

PolygonSoup parse_obj(std::string_view bytes, const std::string& name) {
    TextCursor cursor(bytes, name, '#');
    PolygonSoup soup;
    soup.face_starts.push_back(0);
    LargestIndex largest;
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
            continue;
        }
        if (statement == "f" || statement == "fo") {
            read_face(cursor, soup, largest);
            continue;
        }
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
    if (lines_and_points > 0)
        soup.notes.push_back(fmt::format("{} lines and points were passed over.", lines_and_points));
    if (surfaces > 0) soup.notes.push_back(fmt::format("{} curves and free-form surfaces were passed over.", surfaces));
    return soup;
}

}  // namespace partonomy
