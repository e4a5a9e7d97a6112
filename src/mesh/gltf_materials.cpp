#include "mesh/gltf_materials.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "mesh/decode_image.h"

// glTF's factors and vertex colours are linear, its images are sRGB; they are multiplied. A material that says nothing
// is white, metallic and rough, as the standard has it; a primitive without a material has a colour only when its
// vertices have. Where an image tells the finish point by point, the finish stays untold: it is no single value of the
// part.

namespace partonomy {
namespace {

Wrap wrap_of(const GltfValue& mode) {
    const std::uint64_t word = mode.count(10497);
    return word == 33071 ? Wrap::clamp : word == 33648 ? Wrap::mirror : Wrap::repeat;
}

float fraction(const GltfValue& value) { return static_cast<float>(std::clamp(value.number(1), 0.0, 1.0)); }

}  // namespace

int MaterialMaps::read_image(const GltfValue& texture) {
    const auto source = texture["source"].index();
    if (!source) texture.fail("names no PNG or JPEG image (source); other kinds cannot be read");
    const GltfValue image = file_.item("images", *source, texture["source"]);
    const auto [found, is_new] = images_.try_emplace(*source, static_cast<int>(appearance_.images.size()));
    if (is_new) appearance_.images.push_back(decode_image(file_.image_bytes(image), at(file_.name(), 0, image.path())));
    return found->second;
}

MaterialMaps::Known MaterialMaps::read(const GltfValue& value) {
    Known known{static_cast<std::int32_t>(appearance_.materials.size())};
    Material material;
    material.name = value["name"].text();
    const GltfValue look = value["pbrMetallicRoughness"];
    const std::vector<double> factor = look["baseColorFactor"].numbers({1, 1, 1, 1});
    for (int i = 0; i < 3; ++i)
        material.color[i] = static_cast<float>(std::clamp(factor[static_cast<std::size_t>(i)], 0.0, 1.0));
    if (!look["metallicRoughnessTexture"]) {
        material.metallic = fraction(look["metallicFactor"]);
        material.roughness = fraction(look["roughnessFactor"]);
    }
    if (const GltfValue info = look["baseColorTexture"]) {
        const GltfValue texture = file_.item("textures", info["index"].count(), info["index"]);
        material.image = read_image(texture);
        if (const auto sampler = texture["sampler"].index()) {
            const GltfValue modes = file_.item("samplers", *sampler, texture["sampler"]);
            material.wrap_u = wrap_of(modes["wrapS"]);
            material.wrap_v = wrap_of(modes["wrapT"]);
        }
        const GltfValue moved = info["extensions"]["KHR_texture_transform"];
        known.points_set = moved["texCoord"].count(info["texCoord"].count());
        const std::vector<double> offset = moved["offset"].numbers({0, 0}), scale = moved["scale"].numbers({1, 1});
        const double angle = moved["rotation"].number(0), c = std::cos(angle), s = std::sin(angle);
        Eigen::Matrix<double, 2, 3> transform;
        transform << c * scale[0], s * scale[1], offset[0], -s * scale[0], c * scale[1], offset[1];
        known.transform = transform.cast<float>();
    }
    appearance_.materials.push_back(std::move(material));
    return known;
}

MaterialMaps::Use MaterialMaps::use(const GltfValue& primitive, std::size_t vertex_count) {
    Use use;
    const auto number = primitive["material"].index();
    if (!number) return use;
    auto found = materials_.find(*number);
    if (found == materials_.end())
        found = materials_.emplace(*number, read(file_.item("materials", *number, primitive["material"]))).first;
    const Known& known = found->second;
    use.material = known.number;
    use.transform = known.transform;
    if (appearance_.materials[static_cast<std::size_t>(known.number)].image < 0) return use;
    const std::string set = fmt::format("TEXCOORD_{}", known.points_set);
    const GltfValue accessor = primitive["attributes"][set.c_str()];
    if (!accessor) primitive.fail(fmt::format("has a material with an image, but no {} to place it", set));
    use.points = file_.numbers(accessor.count(), {"VEC2"}, accessor);
    if (use.points->count < vertex_count)
        accessor.fail(fmt::format("has {} texture points for {} vertices", use.points->count, vertex_count));
    return use;
}

void MaterialMaps::add_corner(const Use& use, std::size_t vertex) {
    ++corners_;
    if (!use.points) {
        if (!appearance_.corner_points.empty()) appearance_.corner_points.emplace_back(0, 0);
        return;
    }
    appearance_.corner_points.resize(corners_ - 1, TexturePoint(0, 0));
    const Eigen::Vector3f point(static_cast<float>(use.points->number(vertex, 0)),
                                static_cast<float>(use.points->number(vertex, 1)), 1);
    appearance_.corner_points.emplace_back(use.transform * point);
}

void MaterialMaps::add_face(const Use& use) { appearance_.face_materials.push_back(use.material); }

}  // namespace partonomy
