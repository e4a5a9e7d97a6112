#include "report/eval_pictures.h"

#include <algorithm>
#include <cstdio>
#include <set>

#include "base/errors.h"
#include "report/canvas.h"
#include "report/draw_object.h"
#include "report/font.h"

namespace partonomy {
namespace {

constexpr Color black{30, 30, 34}, grey{120, 120, 126}, line{205, 205, 210};
constexpr int margin = 10, line_height = 16, swatch = 10;

std::string percent(double share) {
    std::array<char, 40> text{};
    std::snprintf(text.data(), text.size(), "%.1f", 100 * share);
    return text.data();
}

/// White at 0, the colour at 1.
Color tint(const Color& color, double share) {
    Color mixed;
    for (std::size_t k = 0; k < 3; ++k) mixed[k] = static_cast<std::uint8_t>(255 - share * (255 - color[k]) + 0.5);
    return mixed;
}

/// The characters of `text` that fit into `width` pixels.
std::string fitting(const std::string& text, int width) {
    return to_font(text).substr(0, static_cast<std::size_t>(std::max(0, width / glyph_advance)));
}

void centred(Canvas& canvas, int middle, int y, const std::string& text, Color color) {
    canvas.text(middle - Canvas::text_width(text) / 2, y, text, color);
}

/// Labels with a number each, one colour a number.
using Legend = std::map<std::string, int>;

/// The mesh with one part a label.
Annotation labelled(const TriangleMesh& mesh, const std::vector<std::string>& labels, const Legend& legend) {
    Annotation annotation;
    for (const auto& [label, number] : legend) {
        AnnotatedPart& part = annotation.parts.emplace_back();
        part.id = number + 1;
        part.concepts = {label};
    }
    std::sort(annotation.parts.begin(), annotation.parts.end(),
              [](const AnnotatedPart& a, const AnnotatedPart& b) { return a.id < b.id; });
    for (const std::int32_t face : mesh.input_faces) {
        const auto found = legend.find(labels[static_cast<std::size_t>(face)]);
        annotation.part_of_triangle.push_back(found == legend.end() ? -1 : found->second);
    }
    return annotation;
}

}  // namespace

std::string confusion_picture(const std::map<std::string, std::map<std::string, double>>& confusion) {
    constexpr int cell_width = 76, cell_height = 34, label_width = 130;
    constexpr Color right{60, 140, 80}, wrong{200, 70, 60};
    std::vector<std::string> rows, columns;
    std::set<std::string> answers;
    for (const auto& [truth, row] : confusion) {
        rows.push_back(truth);
        for (const auto& [answer, area] : row) answers.insert(answer);
    }
    columns = rows;
    for (const std::string& answer : answers)
        if (!confusion.contains(answer)) columns.push_back(answer);
    const int left = margin + label_width, top = margin + 2 * line_height;
    Canvas canvas(left + static_cast<int>(columns.size()) * cell_width + margin,
                  top + static_cast<int>(rows.size()) * cell_height + margin);
    canvas.text(margin, margin, "percent of the true label's area", grey);
    for (std::size_t c = 0; c < columns.size(); ++c)
        centred(canvas, left + static_cast<int>(c) * cell_width + cell_width / 2, margin + line_height,
                fitting(columns[c], cell_width - 4), black);
    for (std::size_t r = 0; r < rows.size(); ++r) {
        const int y = top + static_cast<int>(r) * cell_height;
        canvas.text(margin, y + cell_height / 2 - 4, fitting(rows[r], label_width - 8), black);
        const auto& row = confusion.at(rows[r]);
        double whole = 0;
        for (const auto& [answer, area] : row) whole += area;
        for (std::size_t c = 0; c < columns.size(); ++c) {
            const int x = left + static_cast<int>(c) * cell_width;
            const auto found = row.find(columns[c]);
            const double share = found == row.end() || !(whole > 0) ? 0 : found->second / whole;
            canvas.fill(x, y, cell_width, cell_height, line);
            canvas.fill(x + 1, y + 1, cell_width - 2, cell_height - 2,
                        tint(rows[r] == columns[c] ? right : wrong, 0.15 * (share > 0) + 0.65 * share));
            centred(canvas, x + cell_width / 2, y + cell_height / 2 - 4, share > 0 ? percent(share) : "-",
                    share > 0 ? black : grey);
        }
    }
    return encode_png(canvas);
}

std::string contact_sheet(const std::vector<SheetEntry>& entries, int threads) {
    constexpr int width = 250, height = 200, pairs_a_row = 2;
    if (entries.empty()) throw UsageError("a contact sheet needs at least one mesh");
    Legend legend;
    for (const SheetEntry& entry : entries)
        for (const auto& labels : {entry.labels, entry.truth}) {
            if (labels.size() != static_cast<std::size_t>(entry.mesh.input_face_count))
                throw UsageError(entry.title + ": " + std::to_string(labels.size()) + " labels for " +
                                 std::to_string(entry.mesh.input_face_count) + " faces");
            for (const std::string& label : labels)
                if (!label.empty() && label != "-") legend.emplace(label, 0);
        }
    int number = 0;
    for (auto& [label, index] : legend) index = number++;
    const int columns = std::min(pairs_a_row, static_cast<int>(entries.size()));
    const int rows = (static_cast<int>(entries.size()) + columns - 1) / columns;
    const int row_height = line_height + height + margin;
    Canvas canvas(margin + columns * (2 * width + 2 * margin), margin + line_height + rows * row_height);
    int x = margin;
    for (const auto& [label, index] : legend) {
        AnnotatedPart part;
        part.id = index + 1;
        canvas.fill(x, margin, swatch, swatch, color_of(part));
        canvas.text(x + swatch + 4, margin + 1, to_font(label), black);
        x += swatch + 4 + Canvas::text_width(to_font(label)) + 2 * margin;
    }
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const SheetEntry& entry = entries[i];
        const int left = margin + static_cast<int>(i % static_cast<std::size_t>(columns)) * (2 * width + 2 * margin);
        const int top = margin + line_height + static_cast<int>(i / static_cast<std::size_t>(columns)) * row_height;
        canvas.text(left, top, fitting(entry.title + "  truth", width), black);
        canvas.text(left + width, top, "labelled", grey);
        const Annotation truth = labelled(entry.mesh, entry.truth, legend);
        const Frame frame{left, top + line_height, width - margin, height - margin};
        const PreviewOptions options{.threads = threads};
        draw_object(canvas, frame, entry.mesh, truth, truth, entry.up, options);
        const Frame beside{left + width, frame.top, frame.width, frame.height};
        draw_object(canvas, beside, entry.mesh, labelled(entry.mesh, entry.labels, legend), truth, entry.up, options);
    }
    return encode_png(canvas);
}

}  // namespace partonomy
