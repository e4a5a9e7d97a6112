#include "mesh/read_mesh.h"

#include <algorithm>
#include <array>
#include <cctype>

#include "base/errors.h"
#include "base/files.h"
#include "mesh/companions.h"
#include "mesh/readers.h"
#include "mesh/text_cursor.h"

namespace partonomy {
namespace {

constexpr std::array obj_words{"v",        "vt",       "vn",   "vp",         "f",        "fo",     "l",      "p",
                               "g",        "o",        "s",    "mg",         "mtllib",   "usemtl", "maplib", "usemap",
                               "cstype",   "deg",      "bmat", "step",       "curv",     "curv2",  "surf",   "bevel",
                               "c_interp", "d_interp", "lod",  "shadow_obj", "trace_obj"};

bool equal_ignoring_case(std::string_view a, std::string_view lower) {
    return a.size() == lower.size() && std::equal(a.begin(), a.end(), lower.begin(), [](char x, char y) {
               return std::tolower(static_cast<unsigned char>(x)) == y;
           });
}

}  // namespace

std::optional<MeshFormat> detect_mesh_format(std::string_view bytes) {
    if (looks_like_binary_stl(bytes)) return MeshFormat::stl_binary;
    const std::string name;
    TextCursor cursor(bytes, name, '#');
    if (bytes.starts_with("glTF")) return MeshFormat::gltf;
    if (!cursor.find_content()) return std::nullopt;
    if (*cursor.position() == '{') return MeshFormat::gltf;
    const std::string_view first = cursor.word();
    if (first == "ply") return MeshFormat::ply;
    if (is_off_header(first)) return MeshFormat::off;
    if (equal_ignoring_case(first, "solid")) return MeshFormat::stl_ascii;
    if (std::find(obj_words.begin(), obj_words.end(), first) != obj_words.end()) return MeshFormat::obj;
    return std::nullopt;
}

PolygonSoup parse_mesh(std::string_view bytes, const std::string& name) { return parse_mesh(bytes, name, {}, nullptr); }

PolygonSoup parse_mesh(std::string_view bytes, const std::string& name, const Companions& companions,
                       SoupAppearance* appearance) {
    const auto read = [&]() -> PolygonSoup {
        const std::optional<MeshFormat> format = detect_mesh_format(bytes);
        if (!format) {
            const bool blank = std::all_of(bytes.begin(), bytes.end(),
                                           [](char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; });
            throw MeshError(at(name, 0,
                               blank ? "is empty; an OFF, OBJ, STL, PLY or glTF mesh was expected"
                                     : "is not a mesh that can be read; OFF, OBJ, STL, PLY, glTF and GLB files can"));
        }
        switch (*format) {
            case MeshFormat::off:
                return parse_off(bytes, name, appearance);
            case MeshFormat::obj:
                return parse_obj(bytes, name, companions, appearance);
            case MeshFormat::stl_ascii:
                return parse_stl_ascii(bytes, name);
            case MeshFormat::stl_binary:
                return parse_stl_binary(bytes, name);
            case MeshFormat::gltf:
                return parse_gltf(bytes, name, companions, appearance);
            case MeshFormat::ply:
                break;
        }
        return parse_ply(bytes, name, appearance);
    };
    PolygonSoup soup = read();
    if (soup.face_count() == 0)
        throw MeshError(at(name, 0,
                           soup.positions.empty() ? "holds no vertices and no faces; a mesh needs at least one face"
                                                  : "holds vertices but no faces; a mesh needs at least one face"));
    if (soup.face_count() > largest_count || static_cast<std::int64_t>(soup.positions.size()) > largest_count)
        throw MeshError(at(name, 0, "has more than 2147483647 vertices or faces; cut it into several files"));
    return soup;
}

LoadedMesh read_mesh(const std::filesystem::path& path, const CleanOptions& options) {
    const std::string bytes = read_file(path);
    LoadedMesh loaded;
    loaded.is_gltf = detect_mesh_format(bytes) == MeshFormat::gltf;
    const PolygonSoup soup = parse_mesh(bytes, path.string(), Companions(path), nullptr);
    loaded.mesh = clean_mesh(soup, path.string(), loaded.report, options);
    loaded.sha256 = sha256(bytes);
    return loaded;
}

}  // namespace partonomy
