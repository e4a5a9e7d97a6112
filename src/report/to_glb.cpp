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
#include <nlohmann/json.hpp>

#include "base/errors.h"
#include "report/part_names.h"
#include "report/write.h"

namespace partonomy {
namespace {

using Json = nlohmann::ordered_json;
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

/// The file while it grows: the arrays of the JSON chunk and the bytes of the binary one.
struct Builder {
    Json nodes = Json::array(), meshes = Json::array(), materials = Json::array();
    Json accessors = Json::array(), views = Json::array();
    std::string binary;
};

/// Appends floats, three by three, as one buffer view with its accessor; the accessor's number.
std::size_t add_vectors(Builder& builder, const std::vector<float>& values, bool with_bounds) {
    const std::size_t offset = builder.binary.size();
    if constexpr (std::endian::native == std::endian::little) {
        builder.binary.append(reinterpret_cast<const char*>(values.data()), values.size() * sizeof(float));
    } else {
        for (const float value : values) {
            const auto bits = std::bit_cast<std::uint32_t>(value);
            for (int shift = 0; shift < 32; shift += 8) builder.binary += static_cast<char>(bits >> shift & 255);
        }
    }
    constexpr int array_buffer = 34962, float_component = 5126;
    builder.views.push_back({{"buffer", 0},
                             {"byteOffset", offset},
                             {"byteLength", values.size() * sizeof(float)},
                             {"target", array_buffer}});
    Json accessor = {{"bufferView", builder.views.size() - 1},
                     {"componentType", float_component},
                     {"count", values.size() / 3},
                     {"type", "VEC3"}};
    if (with_bounds) {
        std::array<float, 3> low{values[0], values[1], values[2]}, high = low;
        for (std::size_t i = 0; i < values.size(); ++i) {
            low[i % 3] = std::min(low[i % 3], values[i]);
            high[i % 3] = std::max(high[i % 3], values[i]);
        }
        accessor["min"] = low;
        accessor["max"] = high;
    }
    builder.accessors.push_back(accessor);
    return builder.accessors.size() - 1;
}

/// Adds material, mesh and node for some triangles; `place` takes a point of the mesh to the root node's frame.
void add_node(Builder& builder, const TriangleMesh& mesh, const std::vector<std::int32_t>& triangles, const auto& place,
              const std::string& name, std::array<std::uint8_t, 3> color, const Json& extras) {
    std::vector<float> positions, normals;
    positions.resize(triangles.size() * 9);
    normals.resize(triangles.size() * 9);
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
    builder.materials.push_back(
        {{"name", name},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {linear_of(color[0]), linear_of(color[1]), linear_of(color[2]), 1.0}},
           {"metallicFactor", 0.0},
           {"roughnessFactor", 0.8}}},
         {"doubleSided", true}});
    const std::size_t position = add_vectors(builder, positions, true);
    const std::size_t normal = add_vectors(builder, normals, false);
    Json primitive;
    primitive["attributes"] = {{"POSITION", position}, {"NORMAL", normal}};
    primitive["material"] = builder.materials.size() - 1;
    builder.meshes.push_back({{"name", name}, {"primitives", Json::array({primitive})}});
    Json node = {{"name", name}, {"mesh", builder.meshes.size() - 1}};
    if (!extras.is_null()) node["extras"] = extras;
    builder.nodes.push_back(std::move(node));
}

void append_u32(std::string& bytes, std::size_t value) {
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 255);
}

/// Header and chunks, each padded to a multiple of four bytes.
std::string pack(const Json& json, std::string binary) {
    std::string text = json.dump(-1, ' ', false, Json::error_handler_t::replace);
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
    Builder builder;
    builder.nodes.push_back(Json::object());  // the root, filled in below
    const std::vector<std::string> names = part_names(annotation);
    for (std::size_t i = 0; i < names.size(); ++i) {
        const AnnotatedPart& part = annotation.parts[i];
        const Json extras = {{"part", part.id}, {"score", part.score}, {"concepts", part.concepts}};
        if (!groups[i].empty()) add_node(builder, mesh, groups[i], place, names[i], color_of(part), extras);
    }
    if (!groups.back().empty()) add_node(builder, mesh, groups.back(), place, "unlabelled", unlabelled_color, Json());

    const double scale = metres_per(annotation.unit);
    const Vec3 translation = scale * (turn * middle);
    Json& root = builder.nodes[0];
    root["name"] = annotation.classes.empty() ? std::string("object") : join(annotation.classes);
    if (!translation.isZero(0)) root["translation"] = {translation.x(), translation.y(), translation.z()};
    if (scale != 1) root["scale"] = {scale, scale, scale};
    for (std::size_t i = 1; i < builder.nodes.size(); ++i) root["children"].push_back(i);
    root["extras"] = {
        {"classes", annotation.classes}, {"consistent", annotation.consistent}, {"score", annotation.score}};

    Json json;
    json["asset"] = {{"version", "2.0"}, {"generator", "Partonomy"}};
    json["scene"] = 0;
    json["scenes"] = Json::array({{{"nodes", {0}}}});
    json["nodes"] = std::move(builder.nodes);
    if (!builder.meshes.empty()) {
        json["meshes"] = std::move(builder.meshes);
        json["materials"] = std::move(builder.materials);
        json["accessors"] = std::move(builder.accessors);
        json["bufferViews"] = std::move(builder.views);
        json["buffers"] = Json::array({{{"byteLength", (builder.binary.size() + 3) / 4 * 4}}});
    }
    return pack(json, std::move(builder.binary));
}

}  // namespace partonomy
