// Writes trace.txt: what the paper's Fig. 13 and 14 show, as text. First the questions with their answers and what
// followed from them, then the conclusion, the parts, and, when the object is incompatible, the diagnosis. UTF-8 passes
// through; columns are aligned by counting characters, not bytes.

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "report/part_names.h"
#include "report/write.h"

namespace partonomy {
namespace {

std::size_t width_of(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

std::string padded(std::string text, std::size_t width) {
    const std::size_t have = width_of(text);
    if (have < width) text.append(width - have, ' ');
    return text;
}

std::string right(const std::string& text, std::size_t width) {
    const std::size_t have = width_of(text);
    return have < width ? std::string(width - have, ' ') + text : text;
}

std::string number(double value, int digits) {
    if (!std::isfinite(value)) return "?";
    std::array<char, 400> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.*f", digits, value);
    return buffer.data();
}

/// Three significant digits, so that a bench in metres and one in millimetres both read well.
std::string measure(double value) {
    if (!std::isfinite(value)) return "?";
    std::array<char, 64> buffer{};
    std::snprintf(buffer.data(), buffer.size(), "%.3g", value);
    return buffer.data();
}

using Row = std::vector<std::string>;

/// The cells of each column below each other, two blanks between columns; `numeric` columns are flush right.
std::string table(const std::vector<Row>& rows, const std::vector<bool>& numeric) {
    std::vector<std::size_t> widths(numeric.size(), 0);
    for (const Row& row : rows)
        for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
    std::string text;
    for (const Row& row : rows) {
        std::string line = " ";
        for (std::size_t i = 0; i < row.size(); ++i)
            line.append(" ").append(numeric[i] ? right(row[i], widths[i]) : padded(row[i], widths[i])).append(" ");
        line.erase(line.find_last_not_of(' ') + 1);
        text += line + "\n";
    }
    return text;
}

std::string questions(const Annotation& annotation) {
    if (annotation.trace.empty()) return "  none was asked\n";
    std::vector<Row> rows{{"#", "kind", "question", "asked of", "answer", "score", "ms"}};
    for (std::size_t i = 0; i < annotation.trace.size(); ++i) {
        const TraceEntry& entry = annotation.trace[i];
        rows.push_back({std::to_string(i + 1), one_line(entry.kind), one_line(entry.question), one_line(entry.region),
                        one_line(entry.answer), number(entry.score, 2), number(entry.ms, 2)});
    }
    const std::string lines = table(rows, {true, false, false, false, false, true, true});
    std::string text;
    std::size_t begin = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {  // what followed stands below its question
        const std::size_t end = lines.find('\n', begin) + 1;
        text += lines.substr(begin, end - begin);
        begin = end;
        if (i == 0) continue;
        const TraceEntry& entry = annotation.trace[i - 1];
        if (!entry.measured.empty()) text += "          [" + one_line(entry.measured) + "]\n";
        for (const std::string& fact : entry.inferred) text += "          => " + one_line(fact) + "\n";
    }
    return text;
}

std::string counts(const Annotation& annotation) {
    std::vector<std::string> words;
    for (const auto& [kind, count] : annotation.questions) words.push_back(kind + " " + std::to_string(count));
    return words.empty() ? "" : " (" + join(words) + ")";
}

std::string parts(const Annotation& annotation) {
    if (annotation.parts.empty()) return "  none\n";
    std::vector<Row> rows{{"part", "name", "also", "faces", "area", "score", "features", "measurements"}};
    for (const AnnotatedPart& part : annotation.parts) {
        std::vector<std::string> also, features, measurements;
        if (part.concepts.size() > 1) also.assign(part.concepts.begin() + 1, part.concepts.end());
        for (const auto& [range, value] : part.features) features.push_back(range + "=" + value);
        for (const auto& [name, value] : part.measurements) measurements.push_back(name + "=" + measure(value));
        rows.push_back({std::to_string(part.id), one_line(concept_of(part)), one_line(join(also)),
                        std::to_string(part.faces), measure(part.area), number(part.score, 2),
                        one_line(join(features, " ")), one_line(join(measurements, " "))});
    }
    return table(rows, {true, false, false, true, true, true, false, false});
}

/// "part 3 (Handle)".
std::string part_in_words(const Annotation& annotation, int id) {
    const AnnotatedPart* part = find_part(annotation, id);
    const bool is_named = part != nullptr && !part->concepts.empty();
    return "part " + std::to_string(id) + (is_named ? " (" + one_line(concept_of(*part)) + ")" : "");
}

std::string composites(const Annotation& annotation) {
    std::string text;
    const std::vector<std::string> names = composite_names(annotation);
    for (std::size_t k = 0; k < names.size(); ++k) {
        const AnnotatedComposite& composite = annotation.composites[k];
        std::vector<std::string> pieces, also(composite.concepts.begin() + 1, composite.concepts.end());
        for (const int id : composite.parts) pieces.push_back(part_in_words(annotation, id));
        text += "  " + one_line(names[k]) + (also.empty() ? "" : ", also " + one_line(join(also))) + ": " +
                join(pieces) + "\n";
    }
    return text;
}

std::string list(const std::string& title, const std::vector<std::string>& lines, bool numbered) {
    if (lines.empty()) return "";
    std::string text = "    " + title + "\n";
    for (std::size_t i = 0; i < lines.size(); ++i)
        text += "      " + (numbered ? std::to_string(i + 1) + ". " : "- ") + one_line(lines[i]) + "\n";
    return text;
}

std::string culprits(const Annotation& annotation, const Diagnosis& diagnosis) {
    std::vector<std::string> words;
    for (const int id : diagnosis.parts) words.push_back(part_in_words(annotation, id));
    return words.empty() ? "the object as a whole" : join(words);
}

std::string diagnoses(const Annotation& annotation) {
    std::string text;
    for (const Diagnosis& diagnosis : annotation.diagnosis) {
        text += "  " + one_line(diagnosis.concept_name) + ", because of " + culprits(annotation, diagnosis) + "\n";
        text += list("from these answers:", diagnosis.answers, false);
        text += list("and these axioms:", diagnosis.axioms, false);
        text += list("What would repair it:", diagnosis.corrections, true);
    }
    return text;
}

}  // namespace

std::string to_trace(const Annotation& annotation) {
    const Annotation& a = annotation;
    std::string text = "Mesh      " + one_line(a.mesh_file) + ", " + std::to_string(a.mesh_faces) + " faces, up " +
                       one_line(a.up) + ", unit " + one_line(a.unit) + "\n";
    for (const std::string& note : a.mesh_notes) text += "          " + one_line(note) + "\n";
    text += "Ontology  " + one_line(a.ontology_iri) + "\n";
    if (!a.strategy.empty()) text += "Strategy  " + one_line(a.strategy) + "\n";
    text += "\nQuestions" + counts(a) + "\n" + questions(a);
    text += "\nConclusion: " + (a.classes.empty() ? "not recognised" : one_line(join(a.classes))) + ", score " +
            number(a.score, 2) + (a.consistent ? ", consistent\n" : ", INCOMPATIBLE\n");
    for (const NearClass& near : a.nearest) text += "  near: " + one_line(in_words(near)) + "\n";
    text += "\nParts\n" + parts(a);
    if (!a.composites.empty()) text += "\nComposite parts\n" + composites(a);
    if (!a.diagnosis.empty()) text += "\nDiagnosis\n" + diagnoses(a);
    if (!a.open_questions.empty()) {
        text += "\nStill open\n";
        for (const std::string& question : a.open_questions) text += "  - " + one_line(question) + "\n";
    }
    if (!a.timings_ms.empty()) {
        std::vector<Row> rows;
        for (const auto& [stage, ms] : a.timings_ms) rows.push_back({one_line(stage), number(ms, 2) + " ms"});
        text += "\nTimings\n" + table(rows, {false, true});
    }
    return text;
}

}  // namespace partonomy
