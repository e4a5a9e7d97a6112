// Tells five formats of truth apart by their content, in this order:
//     PLY            begins with "ply" and a line break
//     one byte a face   as many bytes as faces, and something that text never holds, or no line break at all
//     Labeled PSB    a line that is not a number, then a line of whole numbers only: "leg", "12039 12342 …"
//     PSB .seg       a whole number a line; the number is the name
//     labels.txt     a name a line

#include <algorithm>
#include <charconv>
#include <map>

#include "base/errors.h"
#include "base/files.h"
#include "report/evaluate.h"
#include "report/ply_labels.h"

namespace partonomy {
namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") - begin + 1);
}

std::vector<std::string_view> lines_of(std::string_view bytes) {
    if (bytes.starts_with("\xEF\xBB\xBF")) bytes.remove_prefix(3);
    std::vector<std::string_view> lines;
    while (!bytes.empty()) {
        const std::size_t end = std::min(bytes.find('\n'), bytes.size());
        lines.push_back(trimmed(bytes.substr(0, end)));
        bytes.remove_prefix(std::min(end + 1, bytes.size()));
    }
    while (!lines.empty() && lines.back().empty()) lines.pop_back();
    return lines;
}

bool has_numbers_only(std::string_view line) {
    return !line.empty() && line.find_first_not_of("0123456789 \t") == std::string_view::npos;
}

bool is_byte_per_face(std::string_view bytes, std::int64_t face_count) {
    const bool has_control = std::ranges::any_of(bytes, [](char c) {
        const auto byte = static_cast<unsigned char>(c);
        return byte < 32 && byte != '\t' && byte != '\n' && byte != '\r';
    });
    const bool fits = face_count > 1 && static_cast<std::int64_t>(bytes.size()) == face_count;
    return has_control || (fits && bytes.find('\n') == std::string_view::npos);
}

std::string counted(std::size_t have, std::int64_t want, const std::string& what) {
    return std::to_string(have) + " " + what + ", but the mesh has " + std::to_string(want) + " faces";
}

std::vector<std::string> from_bytes(std::string_view bytes, const std::string& path, std::int64_t face_count) {
    if (static_cast<std::int64_t>(bytes.size()) != face_count)
        throw UsageError(at(path, 0, "holds " + counted(bytes.size(), face_count, "bytes of truth, one a face")));
    std::vector<std::string> truth;
    truth.reserve(bytes.size());
    for (const char byte : bytes) truth.push_back(std::to_string(static_cast<unsigned char>(byte)));
    return truth;
}

std::vector<std::string> from_ply(std::string_view bytes, const std::string& path, std::int64_t face_count) {
    const PlyLabels ply = read_ply_labels(bytes, path);
    const auto name_of = [&](std::int64_t label) -> std::string {
        if (ply.names.empty()) return std::to_string(label);
        if (label == 0) return "-";
        const bool is_named = label > 0 && static_cast<std::size_t>(label) < ply.names.size();
        return is_named ? ply.names[static_cast<std::size_t>(label)] : std::to_string(label);
    };
    const bool has_input_faces = !ply.names.empty() && ply.input_faces.size() == ply.labels.size();
    if (!has_input_faces && static_cast<std::int64_t>(ply.labels.size()) != face_count)
        throw UsageError(at(path, 0, "holds " + counted(ply.labels.size(), face_count, "labelled faces")));
    std::vector<std::string> truth(static_cast<std::size_t>(face_count), "-");
    for (std::size_t i = 0; i < ply.labels.size(); ++i) {
        const std::int64_t face = has_input_faces ? ply.input_faces[i] : static_cast<std::int64_t>(i);
        if (face < 0 || face >= face_count)
            throw UsageError(at(path, 0,
                                "face " + std::to_string(i) + " has input_face " + std::to_string(face) +
                                    ", but the mesh has faces 0 to " + std::to_string(face_count - 1)));
        truth[static_cast<std::size_t>(face)] = name_of(ply.labels[i]);
    }
    return truth;
}

std::vector<std::string> from_labeled_psb(const std::vector<std::string_view>& lines, const std::string& path,
                                          std::int64_t face_count) {
    std::vector<std::string> truth(static_cast<std::size_t>(face_count));
    std::string name;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const long line = static_cast<long>(i) + 1;
        if (!has_numbers_only(lines[i])) {
            if (!lines[i].empty()) name = lines[i];
            continue;
        }
        const char* here = lines[i].data();
        const char* const end = here + lines[i].size();
        while (here < end) {
            if (*here == ' ' || *here == '\t') {
                ++here;
                continue;
            }
            std::int64_t face = 0;
            const auto [stop, error] = std::from_chars(here, end, face);
            if (error != std::errc() || face < 1 || face > face_count)
                throw UsageError(at(path, line,
                                    "face " + std::string(here, stop) + " is not one of the mesh's faces 1 to " +
                                        std::to_string(face_count)));
            here = stop;
            std::string& label = truth[static_cast<std::size_t>(face - 1)];
            if (!label.empty() && label != name)
                throw UsageError(at(path, line,
                                    "face " + std::to_string(face) + " is given to " + name + ", but it was given to " +
                                        label + " before"));
            label = name;
        }
    }
    return truth;
}

std::vector<std::string> from_lines(const std::vector<std::string_view>& lines, const std::string& path,
                                    std::int64_t face_count) {
    if (static_cast<std::int64_t>(lines.size()) != face_count)
        throw UsageError(at(path, static_cast<long>(std::min(lines.size(), static_cast<std::size_t>(face_count))),
                            "holds " + counted(lines.size(), face_count, "lines of truth, one a face")));
    return {lines.begin(), lines.end()};
}

std::vector<std::string> parse_truth(std::string_view bytes, const std::string& path, std::int64_t face_count) {
    if (bytes.starts_with("ply\n") || bytes.starts_with("ply\r")) return from_ply(bytes, path, face_count);
    if (is_byte_per_face(bytes, face_count)) return from_bytes(bytes, path, face_count);
    const std::vector<std::string_view> lines = lines_of(bytes);
    if (lines.empty()) throw UsageError(at(path, 0, "is empty; truth needs a label for each face"));
    if (lines.size() > 1 && !has_numbers_only(lines[0]) && has_numbers_only(lines[1]))
        return from_labeled_psb(lines, path, face_count);
    return from_lines(lines, path, face_count);
}

}  // namespace

std::vector<std::string> read_truth(const std::string& path, std::int64_t face_count,
                                    const std::map<std::string, std::string>& names) {
    std::vector<std::string> truth = parse_truth(read_file(path), path, face_count);
    for (std::string& label : truth)
        if (const auto renamed = names.find(label); renamed != names.end()) label = renamed->second;
    return truth;
}

}  // namespace partonomy
