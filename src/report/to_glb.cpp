// Writes annotation.glb: a binary glTF 2.0 file, that is a JSON chunk that describes and a binary chunk that holds
// numbers.
//
//     scene -> root node (translation to the mesh's place, scale to metres) -> one node a part: mesh -> primitive ->
//     material
//
// Every triangle has its own three corners with the triangle's normal, so that flat things look flat in every viewer.
// Floats carry 24 bits only: corners are written relative to the middle of the mesh, and the root node's translation
// puts them back, so a chair 600 km from its origin still has straight legs. glTF is in metres and has +y up: known
// units become the root's scale, and the mesh's up axis is turned to +y by a rotation (never a mirror image). Triangles
// without a part get a node "unlabelled". O(#T), 72 bytes a triangle.

#include <Eigen/Geometry>
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/errors.h"
#include "base/json_text.h"
#include "report/part_names.h"
#include "report/write.h"

namespace partonomy {
namespace {

using Mat3 = Eigen::Matrix3d;

/// The rotation that takes `up` to +y the short way; exact for axes.
Mat3 turn_up_to_y(const Vec3& up) {
    if (!up.allFinite() || up.stableNorm() == 0)
        throw UsageError("the up direction must be a finite vector other than zero");
    const Vec3 from = up.stableNormalized();
    const Vec3 axis = from.cross(Vec3::UnitY());
    const double cosine = from.y();
    if (cosine < -0.999999999) return Vec3(1, -1, -1).asDiagonal();
    Mat3 cross;
    cross << 0, -axis.z(), axis.y(), axis.z(), 0, -axis.x(), -axis.y(), axis.x(), 0;
    return Mat3::Identity() + cross + cross * cross / (1 + cosine);
}

double metres_per(const std::string& unit) {
    if (unit == "mm") return 0.001;
    if (unit == "cm") return 0.01;
    if (unit == "in") return 0.0254;
    return 1;
}

/// glTF colours are linear; ours are what a screen shows.
double linear_of(std::uint8_t channel) {
    const double s = channel / 255.0;
    const double linear = s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
    return std::round(linear * 1e6) / 1e6;
}

/// Three floats a point, and the box around them.
struct Vectors {
    std::size_t count = 0;
    std::array<float, 3> low{}, high{};
};

/// A material, a mesh and a node of the file.
struct Piece {
    const AnnotatedPart* part;  ///< null: unlabelled
    std::string name;
    std::array<std::uint8_t, 3> color;
    Vectors corners;
};

void append(std::string& binary, const std::vector<float>& values) {
    if constexpr (std::endian::native == std::endian::little) {
        binary.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    } else {
        for (const float value : values) {
            const auto bits = std::bit_cast<std::uint32_t>(value);
            for (int shift = 0; shift < 32; shift += 8) binary += static_cast<char>(bits >> shift & 255);
        }
    }
}

/// Appends corners, then normals of some triangles; `place` takes a point of the mesh to the root node's frame.
Vectors append_triangles(std::string& binary, const TriangleMesh& mesh, const std::vector<std::int32_t>& triangles,
                         const auto& place) {
    std::vector<float> positions(triangles.size() * 9), normals(triangles.size() * 9);
    std::size_t at = 0;
    for (const std::int32_t t : triangles) {
        std::array<Vec3, 3> corners;
        for (std::size_t i = 0; i < 3; ++i)
            corners[i] =
                place(mesh.positions[static_cast<std::size_t>(mesh.triangles[static_cast<std::size_t>(t)][i])]);
        const Vec3 cross =
            (corners[1] - corners[0]).stableNormalized().cross((corners[2] - corners[0]).stableNormalized());
        const double length = cross.stableNorm();
        const Vec3 normal = length > 0 ? Vec3(cross / length) : Vec3::UnitY();
        for (const Vec3& corner : corners)
            for (int axis = 0; axis < 3; ++axis, ++at) {
                positions[at] = static_cast<float>(corner[axis]);
                normals[at] = static_cast<float>(normal[axis]);
            }
    }
    append(binary, positions);
    append(binary, normals);
    Vectors made{positions.size() / 3, {positions[0], positions[1], positions[2]}, {}};
    made.high = made.low;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        made.low[i % 3] = std::min(made.low[i % 3], positions[i]);
        made.high[i % 3] = std::max(made.high[i % 3], positions[i]);
    }
    return made;
}

void append_u32(std::string& bytes, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255);
}

/// Header and chunks, each padded to a multiple of four bytes.
std::string pack(std::string text, std::string binary) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const std::size_t size = 12 + 8 + text.size() + (binary.empty() ? 0 : 8 + binary.size());
    if (size > 0xffffffffU)
        throw UsageError("the mesh is too large for a GLB file, which holds 4 GB; choose the format ply instead");
    std::string bytes = "glTF";
    bytes.reserve(size);
    append_u32(bytes, 2);
    append_u32(bytes, size);
    append_u32(bytes, text.size());
    bytes += "JSON" + text;
    if (!binary.empty()) {
        append_u32(bytes, binary.size());
        bytes += std::string("BIN\0", 4) + binary;
    }
    return bytes;
}

/// Which node each piece and then each composite part hangs on: 0 for the root, else a composite part's own node, of
/// the lowest layer that holds it (they come lower layers first).
std::vector<std::size_t> find_parents(const Annotation& annotation, const std::vector<Piece>& pieces) {
    const std::size_t first = pieces.size() + 1;  // node of the first composite part
    std::vector<std::size_t> parents(pieces.size() + annotation.composites.size(), 0);
    for (std::size_t k = annotation.composites.size(); k-- > 0;) {
        const AnnotatedComposite& composite = annotation.composites[k];
        for (std::size_t i = 0; i < pieces.size(); ++i)
            if (pieces[i].part != nullptr &&
                std::ranges::find(composite.parts, pieces[i].part->id) != composite.parts.end())
                parents[i] = first + k;
        for (std::size_t i = 0; i < k; ++i)
            if (std::ranges::find(composite.composites, annotation.composites[i].id) != composite.composites.end())
                parents[pieces.size() + i] = first + k;
    }
    return parents;
}

void write_children(JsonText& json, const std::vector<std::size_t>& parents, std::size_t parent) {
    if (std::ranges::find(parents, parent) == parents.end()) return;
    json.array("children");
    for (std::size_t i = 0; i < parents.size(); ++i)
        if (parents[i] == parent) json.item(i + 1);
    json.end();
}

/// Node 0 is the root; piece i is node i + 1, mesh i and material i, its corners are accessor and view 2 i, its normals
/// the one after. The nodes of composite parts follow.
void write_nodes(JsonText& json, const Annotation& annotation, const std::vector<Piece>& pieces,
                 const Vec3& translation, double scale) {
    json.array("nodes").object();
    json.member("name", annotation.classes.empty() ? std::string("object") : join(annotation.classes));
    if (!translation.isZero(0))
        json.array("translation").item(translation.x()).item(translation.y()).item(translation.z()).end();
    if (scale != 1) json.array("scale").item(scale).item(scale).item(scale).end();
    const std::vector<std::size_t> parents = find_parents(annotation, pieces);
    write_children(json, parents, 0);
    json.object("extras")
        .member("classes", annotation.classes)
        .member("consistent", annotation.consistent)
        .member("score", annotation.score)
        .end()
        .end();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        json.object().member("name", pieces[i].name).member("mesh", i);
        if (const AnnotatedPart* part = pieces[i].part; part != nullptr)
            json.object("extras")
                .member("part", part->id)
                .member("score", part->score)
                .member("concepts", part->concepts)
                .end();
        json.end();
    }
    const std::vector<std::string> names = composite_names(annotation);
    for (std::size_t k = 0; k < names.size(); ++k) {
        json.object().member("name", names[k]);
        write_children(json, parents, pieces.size() + 1 + k);
        json.object("extras")
            .member("composite", annotation.composites[k].id)
            .member("concepts", annotation.composites[k].concepts)
            .end()
            .end();
    }
    json.end();
}

void write_meshes(JsonText& json, const std::vector<Piece>& pieces) {
    json.array("meshes");
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        json.object().member("name", pieces[i].name).array("primitives").object().object("attributes");
        json.member("POSITION", 2 * i).member("NORMAL", 2 * i + 1).end().member("material", i).end().end().end();
    }
    json.end().array("materials");
    for (const Piece& piece : pieces) {
        json.object().member("name", piece.name).object("pbrMetallicRoughness").array("baseColorFactor");
        for (const std::uint8_t channel : piece.color) json.item(linear_of(channel));
        json.item(1.0).end().member("metallicFactor", 0.0).member("roughnessFactor", 0.8).end();
        json.member("doubleSided", true).end();
    }
    json.end();
}

void write_accessors(JsonText& json, const std::vector<Piece>& pieces) {
    constexpr int float_component = 5126;
    json.array("accessors");
    for (std::size_t i = 0; i < 2 * pieces.size(); ++i) {
        const Vectors& corners = pieces[i / 2].corners;
        json.object().member("bufferView", i).member("componentType", float_component).member("count", corners.count);
        json.member("type", "VEC3");
        if (i % 2 == 0) {  // the corners' bounds
            json.array("min").item(corners.low[0]).item(corners.low[1]).item(corners.low[2]).end();
            json.array("max").item(corners.high[0]).item(corners.high[1]).item(corners.high[2]).end();
        }
        json.end();
    }
    json.end();
}

/// The bytes of the binary chunk that each accessor reads.
void write_views(JsonText& json, const std::vector<Piece>& pieces) {
    constexpr int array_buffer = 34962;
    json.array("bufferViews");
    std::size_t offset = 0;
    for (std::size_t i = 0; i < 2 * pieces.size(); ++i) {
        const std::size_t length = pieces[i / 2].corners.count * 3 * sizeof(float);
        json.object().member("buffer", 0).member("byteOffset", offset).member("byteLength", length);
        json.member("target", array_buffer).end();
        offset += length;
    }
    json.end().array("buffers").object().member("byteLength", offset).end().end();
}

}  // namespace

std::string to_glb(const TriangleMesh& mesh, const Annotation& annotation, const Vec3& up) {
    check_belongs(mesh, annotation);
    const Mat3 turn = turn_up_to_y(up);
    const Vec3 middle = mesh.triangles.empty() ? Vec3(Vec3::Zero()) : compute_used_bounds(mesh).middle();
    const auto place = [&](const Vec3& point) -> Vec3 { return turn * (point - middle); };

    std::vector<std::vector<std::int32_t>> groups(annotation.parts.size() + 1);  // the last: without a part
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const std::int32_t part = annotation.part_of_triangle[t];
        groups[part < 0 ? annotation.parts.size() : static_cast<std::size_t>(part)].push_back(
            static_cast<std::int32_t>(t));
    }
    const std::vector<std::string> names = part_names(annotation);
    std::vector<Piece> pieces;
    std::string binary;
    for (std::size_t i = 0; i < groups.size(); ++i) {
        if (groups[i].empty()) continue;
        const AnnotatedPart* part = i < names.size() ? &annotation.parts[i] : nullptr;
        pieces.push_back({part, part != nullptr ? names[i] : "unlabelled",
                          part != nullptr ? color_of(*part) : unlabelled_color,
                          append_triangles(binary, mesh, groups[i], place)});
    }
    const double scale = metres_per(annotation.unit);
    JsonText json;
    json.object().object("asset").member("version", "2.0").member("generator", "Partonomy").end().member("scene", 0);
    json.array("scenes").object().array("nodes").item(0).end().end().end();
    write_nodes(json, annotation, pieces, scale * (turn * middle), scale);
    if (!pieces.empty()) {
        write_meshes(json, pieces);
        write_accessors(json, pieces);
        write_views(json, pieces);
    }
    return pack(json.end().text(), std::move(binary));
}

}  // namespace partonomy
