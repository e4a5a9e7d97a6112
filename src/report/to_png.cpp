// The preview: a title with the object's classes, the object, and a legend with one line a concept.
//
//     +--------------------------------------+
//     | Bench 0.97                           |
//     | incompatible: ...   (red, if so)     |
//     |                       # Seat 0.99    |
//     |      the object       # Leg x4 0.98  |
//     +--------------------------------------+
//
// Pictures too small to read words in hold the object only.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "base/errors.h"
#include "report/canvas.h"
#include "report/draw_object.h"
#include "report/font.h"
#include "report/part_names.h"
#include "report/write.h"

namespace partonomy {
namespace {

constexpr Color black{30, 30, 34}, grey{120, 120, 126}, red{190, 30, 30};
constexpr int margin = 10, line_height = 16, swatch = 10, most_swatches = 4;

std::string score_text(double score) {
    if (!std::isfinite(score)) return "?";
    std::array<char, 400> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.2f", score);
    return buffer.data();
}

/// What fits into `width` pixels; the last characters become dots when not all of it does.
std::string shortened(std::string text, int width, int scale = 1) {
    const auto room = static_cast<std::size_t>(std::max(0, width / (glyph_advance * scale)));
    if (text.size() <= room) return text;
    text.resize(room);
    for (std::size_t i = room - std::min<std::size_t>(room, 2); i < room; ++i) text[i] = '.';
    return text;
}

/// One line of the legend: the parts of one concept, or the composite parts of one.
struct Entry {
    std::string name, score = {};
    std::vector<Color> colors;
    int parts = 0;
    double score_sum = 0;

    [[nodiscard]] std::string label() const {
        return parts > 1 ? to_font(name) + " " + times_sign + std::to_string(parts) : to_font(name);
    }
    [[nodiscard]] int swatches_width() const {
        return std::min(static_cast<int>(colors.size()), most_swatches) * (swatch + 2) + 4;
    }
};

std::vector<Entry> make_entries(const Annotation& annotation) {
    std::vector<Entry> entries;
    for (const AnnotatedPart& part : annotation.parts) {
        if (part.is_piece) continue;  // its whole stands for it, below
        const std::string name = all_names_of(part);
        auto entry = std::ranges::find(entries, name, &Entry::name);
        if (entry == entries.end()) entry = entries.insert(entry, Entry{.name = name, .colors = {}});
        ++entry->parts;
        entry->score_sum += part.score;
        const Color color = color_of(part);
        if (std::ranges::find(entry->colors, color) == entry->colors.end()) entry->colors.push_back(color);
    }
    for (Entry& entry : entries) entry.score = score_text(entry.score_sum / entry.parts);
    if (std::ranges::find(annotation.part_of_triangle, -1) != annotation.part_of_triangle.end())
        entries.push_back({.name = "unlabelled", .colors = {unlabelled_color}, .parts = 1});
    const std::size_t of_parts = entries.size();
    for (const AnnotatedComposite& composite : annotation.composites) {
        const auto first = entries.begin() + static_cast<std::ptrdiff_t>(of_parts);
        const std::string name = all_names_of(composite);
        auto entry = std::find_if(first, entries.end(), [&](const Entry& e) { return e.name == name; });
        if (entry == entries.end()) entry = entries.insert(entry, Entry{.name = name, .colors = {}});
        ++entry->parts;
        for (const int id : composite.parts)
            if (const AnnotatedPart* part = find_part(annotation, id);
                part != nullptr && std::ranges::find(entry->colors, color_of(*part)) == entry->colors.end())
                entry->colors.push_back(color_of(*part));
    }
    return entries;
}

/// The classes that are not diagnoses; those are in the second line.
std::string title_of(const Annotation& annotation) {
    std::vector<std::string> names;
    for (const std::string& name : annotation.classes)
        if (std::ranges::find(annotation.diagnosis, name, &Diagnosis::concept_name) == annotation.diagnosis.end())
            names.push_back(name);
    return names.empty() ? "not recognised" : to_font(join(names));
}

/// Draws the title; the first row below it.
int draw_title(Canvas& canvas, const Annotation& annotation) {
    const int room = canvas.width - 2 * margin;
    const std::string title = title_of(annotation),
                      score = annotation.classes.empty() ? "" : score_text(annotation.score);
    const int score_width = Canvas::text_width(score) + 6;
    const int scale = Canvas::text_width(title, 2) + score_width <= room ? 2 : 1;
    const std::string shown = shortened(title, room - score_width, scale);
    canvas.text(margin, margin, shown, black, scale);
    canvas.text(margin + Canvas::text_width(shown, scale) + 6, margin + 7 * (scale - 1), score, grey);
    int below = margin + 10 * scale + 4;
    if (annotation.consistent) return below;
    std::vector<std::string> names;
    for (const Diagnosis& diagnosis : annotation.diagnosis) names.push_back(diagnosis.concept_name);
    const std::string text = names.empty() ? "incompatible" : "incompatible: " + to_font(join(names));
    canvas.text(margin, below, shortened(text, room), red);
    return below + line_height;
}

/// Draws the legend flush right; the first column it takes.
int draw_legend(Canvas& canvas, const Annotation& annotation, int top) {
    const std::vector<Entry> entries = make_entries(annotation);
    if (entries.empty()) return canvas.width;
    int name_end = 0, score_width = 0;
    for (const Entry& entry : entries) {
        name_end = std::max(name_end, entry.swatches_width() + Canvas::text_width(entry.label()));
        score_width = std::max(score_width, Canvas::text_width(entry.score) + (entry.score.empty() ? 0 : 6));
    }
    const int width = std::min(name_end + score_width, canvas.width * 45 / 100);
    const int left = canvas.width - margin - width;
    const int rows = std::max(1, (canvas.height - top - margin) / line_height);
    const bool all_fit = static_cast<int>(entries.size()) <= rows;
    const std::size_t shown = all_fit ? entries.size() : static_cast<std::size_t>(rows - 1);
    int y = top;
    for (std::size_t i = 0; i < shown; ++i, y += line_height) {
        const Entry& entry = entries[i];
        int x = left;
        for (std::size_t k = 0; k < entry.colors.size() && k < most_swatches; ++k, x += swatch + 2)
            canvas.fill(x, y, swatch, swatch, entry.colors[k]);
        const int room = width - entry.swatches_width() - score_width;
        canvas.text(left + entry.swatches_width(), y + 2, shortened(entry.label(), room), black);
        canvas.text(left + width - Canvas::text_width(entry.score) + 1, y + 2, entry.score, grey);
    }
    if (!all_fit) canvas.text(left, y + 2, "+ " + std::to_string(entries.size() - shown) + " more", grey);
    return left;
}

}  // namespace

std::string to_png(const TriangleMesh& mesh, const Annotation& annotation, const Vec3& up,
                   const PreviewOptions& options) {
    check_belongs(mesh, annotation);
    constexpr int largest = 8192;
    if (options.width < 1 || options.height < 1 || options.width > largest || options.height > largest)
        throw UsageError("a preview of " + std::to_string(options.width) + " x " + std::to_string(options.height) +
                         " pixels cannot be drawn; both must be from 1 to " + std::to_string(largest));
    if (!up.allFinite() || up.stableNorm() == 0)
        throw UsageError("the up direction must be a finite vector other than zero");
    Canvas canvas(options.width, options.height);
    Frame frame{0, 0, options.width, options.height};
    if (options.width >= 200 && options.height >= 120) {
        const int top = draw_title(canvas, annotation);
        const int right = draw_legend(canvas, annotation, top);
        frame = {margin, top, right - 2 * margin, options.height - top - margin};
    }
    draw_object(canvas, frame, mesh, annotation, annotation, up, options);
    return encode_png(canvas);
}

}  // namespace partonomy
