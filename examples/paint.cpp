#include "examples/paint.h"

#include <fmt/format.h>
#include <png.h>

#include <bit>
#include <cstring>

namespace partonomy {
namespace {

void append_32(std::string& bytes, std::uint32_t value) {
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> (8 * i));
}
void append_float(std::string& bytes, double value) {
    append_32(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(value)));
}

Color linear_of(const Paint& paint) { return linear_from_srgb(Color(paint.rgb[0], paint.rgb[1], paint.rgb[2]) / 255); }

/// The binary chunk of a GLB file and the JSON that speaks of it.
struct Glb {
    std::string binary;
    std::vector<std::string> views, accessors;

    std::size_t add_view(const std::string& bytes) {
        while (binary.size() % 4 != 0) binary += '\0';
        views.push_back(fmt::format(R"({{"buffer":0,"byteOffset":{},"byteLength":{}}})", binary.size(), bytes.size()));
        binary += bytes;
        return views.size() - 1;
    }
    std::size_t add_accessor(const std::string& bytes, int type, std::size_t count, const char* shape) {
        accessors.push_back(fmt::format(R"({{"bufferView":{},"componentType":{},"count":{},"type":"{}"}})",
                                        add_view(bytes), type, count, shape));
        return accessors.size() - 1;
    }
    [[nodiscard]] std::string file(const std::string& rest) const {
        std::string json = fmt::format(
            R"({{"asset":{{"version":"2.0"}},"buffers":[{{"byteLength":{}}}],"bufferViews":[{}],"accessors":[{}],{}}})",
            binary.size(), fmt::join(views, ","), fmt::join(accessors, ","), rest);
        while (json.size() % 4 != 0) json += ' ';
        std::string padded = binary;
        while (padded.size() % 4 != 0) padded += '\0';
        std::string bytes = "glTF";
        append_32(bytes, 2);
        append_32(bytes, static_cast<std::uint32_t>(28 + json.size() + padded.size()));
        append_32(bytes, static_cast<std::uint32_t>(json.size()));
        bytes += "JSON" + json;
        append_32(bytes, static_cast<std::uint32_t>(padded.size()));
        return bytes + std::string("BIN\0", 4) + padded;
    }
};

}  // namespace

std::string to_png(const Image& image) {
    png_image head{};
    head.version = PNG_IMAGE_VERSION;
    head.width = static_cast<png_uint_32>(image.width);
    head.height = static_cast<png_uint_32>(image.height);
    head.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(head);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&head, bytes.data(), &size, 0, image.rgb.data(), 0, nullptr) == 0)
        throw std::runtime_error(head.message);
    bytes.resize(size);
    return bytes;
}

std::string to_ply(const PaintedObject& painted) {
    const TriangleMesh& mesh = painted.object.mesh;
    std::string text = fmt::format(
        "ply\nformat ascii 1.0\nelement vertex {}\nproperty double x\nproperty double y\nproperty double z\nelement "
        "face "
        "{}\nproperty list uchar int vertex_indices\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
        "end_header\n",
        mesh.positions.size(), mesh.triangles.size());
    for (const Vec3& p : mesh.positions) text += fmt::format("{} {} {}\n", p.x(), p.y(), p.z());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const Paint& paint = painted.paints[static_cast<std::size_t>(painted.paint_of[t])];
        const auto& v = mesh.triangles[t];
        text += fmt::format("3 {} {} {} {} {} {}\n", v[0], v[1], v[2], paint.rgb[0], paint.rgb[1], paint.rgb[2]);
    }
    return text;
}

std::string to_glb(const PaintedObject& painted) {
    const TriangleMesh& mesh = painted.object.mesh;
    Glb glb;
    std::vector<std::string> primitives, materials, textures, images;
    std::vector<bool> has_image;
    for (const Paint& paint : painted.paints) {
        const Color color = linear_of(paint);
        std::string look = fmt::format(R"("metallicFactor":{},"roughnessFactor":{})", paint.metallic, paint.roughness);
        has_image.push_back(paint.image.has_value());
        if (paint.image) {
            images.push_back(
                fmt::format(R"({{"bufferView":{},"mimeType":"image/png"}})", glb.add_view(to_png(*paint.image))));
            look += fmt::format(R"(,"baseColorTexture":{{"index":{}}})", textures.size());
            textures.push_back(fmt::format(R"({{"source":{}}})", images.size() - 1));
        } else {
            look += fmt::format(R"(,"baseColorFactor":[{},{},{},1])", color.x(), color.y(), color.z());
        }
        materials.push_back(fmt::format(R"({{"name":"{}","pbrMetallicRoughness":{{{}}}}})", paint.name, look));
    }
    std::string shared;
    for (const Vec3& p : mesh.positions)
        for (const double x : {p.x(), p.z(), -p.y()}) append_float(shared, x);
    const std::size_t positions = glb.add_accessor(shared, 5126, mesh.positions.size(), "VEC3");
    for (std::size_t begin = 0; begin < mesh.triangles.size();) {
        std::size_t end = begin;
        const int paint = painted.paint_of[begin];
        while (end < mesh.triangles.size() && painted.paint_of[end] == paint) ++end;
        if (has_image[static_cast<std::size_t>(paint)]) {  // corners of their own, with their places in the image
            std::string own, points;
            for (std::size_t t = begin; t < end; ++t)
                for (std::size_t i = 0; i < 3; ++i) {
                    const Vec3& p = mesh.positions[static_cast<std::size_t>(mesh.triangles[t][i])];
                    for (const double x : {p.x(), p.z(), -p.y()}) append_float(own, x);
                    for (const float x : {painted.points[t][i].x(), painted.points[t][i].y()}) append_float(points, x);
                }
            const std::size_t count = 3 * (end - begin);
            const std::size_t a = glb.add_accessor(own, 5126, count, "VEC3"),
                              b = glb.add_accessor(points, 5126, count, "VEC2");
            primitives.push_back(
                fmt::format(R"({{"attributes":{{"POSITION":{},"TEXCOORD_0":{}}},"material":{}}})", a, b, paint));
        } else {
            std::string indices;
            for (std::size_t t = begin; t < end; ++t)
                for (const std::int32_t v : mesh.triangles[t]) append_32(indices, static_cast<std::uint32_t>(v));
            primitives.push_back(fmt::format(R"({{"attributes":{{"POSITION":{}}},"indices":{},"material":{}}})",
                                             positions, glb.add_accessor(indices, 5125, 3 * (end - begin), "SCALAR"),
                                             paint));
        }
        begin = end;
    }
    std::string rest = fmt::format(
        R"("scenes":[{{"nodes":[0]}}],"nodes":[{{"mesh":0}}],"meshes":[{{"primitives":[{}]}}],"materials":[{}])",
        fmt::join(primitives, ","), fmt::join(materials, ","));
    if (!images.empty())
        rest += fmt::format(R"(,"textures":[{}],"images":[{}])", fmt::join(textures, ","), fmt::join(images, ","));
    return glb.file(rest);
}

std::vector<std::pair<std::string, std::string>> to_obj(const PaintedObject& painted) {
    const TriangleMesh& mesh = painted.object.mesh;
    const std::string& name = painted.object.name;
    std::vector<std::pair<std::string, std::string>> files;
    std::string mtl;
    for (const Paint& paint : painted.paints) {
        mtl += fmt::format("newmtl {}\nPm {}\nPr {}\n", paint.name, paint.metallic, paint.roughness);
        if (paint.image) {
            const std::string file = fmt::format("{}-{}.png", name, files.size());
            mtl += fmt::format("Kd 1 1 1\nmap_Kd {}\n", file);
            files.emplace_back(file, to_png(*paint.image));
        } else {
            mtl += fmt::format("Kd {:.6f} {:.6f} {:.6f}\n", paint.rgb[0] / 255.0, paint.rgb[1] / 255.0,
                               paint.rgb[2] / 255.0);
        }
    }
    std::string obj = fmt::format("mtllib {}.mtl\n", name);
    for (const Vec3& p : mesh.positions) obj += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
    for (std::size_t t = 0; t < painted.points.size(); ++t)
        for (const TexturePoint& p : painted.points[t]) obj += fmt::format("vt {} {}\n", p.x(), 1 - p.y());
    int current = -1;
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        const auto& v = mesh.triangles[t];
        if (painted.paint_of[t] != current) {
            current = painted.paint_of[t];
            obj += "usemtl " + painted.paints[static_cast<std::size_t>(current)].name + '\n';
        }
        if (painted.points.empty())
            obj += fmt::format("f {} {} {}\n", v[0] + 1, v[1] + 1, v[2] + 1);
        else
            obj += fmt::format("f {}/{} {}/{} {}/{}\n", v[0] + 1, 3 * t + 1, v[1] + 1, 3 * t + 2, v[2] + 1, 3 * t + 3);
    }
    files.emplace_back(name + ".mtl", std::move(mtl));
    files.emplace_back(name + ".obj", std::move(obj));
    return files;
}

std::shared_ptr<const Appearance> appearance_of(const PaintedObject& painted) {
    Appearance appearance;
    for (const Paint& paint : painted.paints) {
        Material material;
        material.name = paint.name;
        material.metallic = static_cast<float>(paint.metallic);
        material.roughness = static_cast<float>(paint.roughness);
        if (paint.image) {
            material.image = static_cast<int>(appearance.images.size());
            appearance.images.push_back(*paint.image);
        } else {
            material.color = linear_of(paint);
        }
        appearance.materials.push_back(std::move(material));
    }
    appearance.face_materials.assign(painted.paint_of.begin(), painted.paint_of.end());
    appearance.corner_points = painted.points;
    return std::make_shared<const Appearance>(std::move(appearance));
}

}  // namespace partonomy
