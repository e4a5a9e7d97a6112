#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <set>

#include "base/errors.h"
#include "report/write.h"
#include "zoo.h"

namespace partonomy {
namespace {

using Json = nlohmann::json;

std::uint32_t u32_at(const std::string& bytes, std::size_t offset) {
    std::uint32_t value = 0;
    std::memcpy(&value, bytes.data() + offset, 4);
    return value;
}

struct Glb {
    Json json;
    std::string binary;
};

/// Takes a GLB apart and checks what the glTF 2.0 specification demands of our kind of file.
Glb open_glb(const std::string& bytes) {
    Glb glb;
    EXPECT_EQ(bytes.substr(0, 4), "glTF");
    EXPECT_EQ(u32_at(bytes, 4), 2U);
    EXPECT_EQ(u32_at(bytes, 8), bytes.size());
    const std::uint32_t json_size = u32_at(bytes, 12);
    EXPECT_EQ(json_size % 4, 0U);
    EXPECT_EQ(bytes.substr(16, 4), "JSON");
    glb.json = Json::parse(bytes.substr(20, json_size));
    EXPECT_EQ(glb.json["asset"]["version"], "2.0");
    if (bytes.size() > 20 + json_size) {
        const std::uint32_t binary_size = u32_at(bytes, 20 + json_size);
        EXPECT_EQ(binary_size % 4, 0U);
        EXPECT_EQ(bytes.substr(24 + json_size, 4), std::string("BIN\0", 4));
        glb.binary = bytes.substr(28 + json_size);
        EXPECT_EQ(glb.binary.size(), binary_size);
        EXPECT_EQ(glb.json["buffers"][0]["byteLength"], binary_size);
    }
    return glb;
}

std::vector<Eigen::Vector3f> vectors(const Glb& glb, const Json& accessor_number) {
    const Json& accessor = glb.json["accessors"].at(accessor_number.get<std::size_t>());
    EXPECT_EQ(accessor["componentType"], 5126);
    EXPECT_EQ(accessor["type"], "VEC3");
    const Json& view = glb.json["bufferViews"].at(accessor["bufferView"].get<std::size_t>());
    const std::size_t offset = view["byteOffset"], length = view["byteLength"], count = accessor["count"];
    EXPECT_EQ(offset % 4, 0U);
    EXPECT_EQ(length, count * 12);
    EXPECT_LE(offset + length, glb.binary.size());
    std::vector<Eigen::Vector3f> values(count);
    std::memcpy(values.data(), glb.binary.data() + offset, length);
    return values;
}

struct Node {
    std::string name;
    Json extras;
    std::vector<Vec3> corners;  ///< in the world, metres
    std::vector<Eigen::Vector3f> normals;
};

/// The nodes with meshes, their corners taken through the root's transformation.
std::vector<Node> open_nodes(const Glb& glb) {
    const Json& root = glb.json["nodes"].at(glb.json["scenes"][0]["nodes"][0].get<std::size_t>());
    Vec3 translation = Vec3::Zero(), scale = Vec3::Ones();
    for (int axis = 0; axis < 3; ++axis) {
        if (root.contains("translation")) translation[axis] = root["translation"][static_cast<std::size_t>(axis)];
        if (root.contains("scale")) scale[axis] = root["scale"][static_cast<std::size_t>(axis)];
    }
    std::vector<Node> nodes;
    for (const Json& child : root["children"]) {
        const Json& node = glb.json["nodes"].at(child.get<std::size_t>());
        const Json& mesh = glb.json["meshes"].at(node["mesh"].get<std::size_t>());
        EXPECT_EQ(mesh["name"], node["name"]);
        EXPECT_EQ(mesh["primitives"].size(), 1U);
        const Json& primitive = mesh["primitives"][0];
        EXPECT_EQ(glb.json["materials"].at(primitive["material"].get<std::size_t>())["name"], node["name"]);
        const std::vector<Eigen::Vector3f> positions = vectors(glb, primitive["attributes"]["POSITION"]);
        Node opened{node["name"], node.value("extras", Json()), {}, vectors(glb, primitive["attributes"]["NORMAL"])};
        EXPECT_EQ(positions.size() % 3, 0U);
        EXPECT_EQ(positions.size(), opened.normals.size());
        const Json& accessor = glb.json["accessors"][primitive["attributes"]["POSITION"].get<std::size_t>()];
        Eigen::Vector3f low = positions[0], high = positions[0];
        for (const Eigen::Vector3f& position : positions) {
            low = low.cwiseMin(position);
            high = high.cwiseMax(position);
            opened.corners.push_back(scale.cwiseProduct(position.cast<double>()) + translation);
        }
        for (int axis = 0; axis < 3; ++axis) {
            EXPECT_EQ(accessor["min"][static_cast<std::size_t>(axis)].get<float>(), low[axis]);
            EXPECT_EQ(accessor["max"][static_cast<std::size_t>(axis)].get<float>(), high[axis]);
        }
        for (std::size_t t = 0; t < positions.size(); t += 3) {
            const Eigen::Vector3f normal =
                (positions[t + 1] - positions[t]).cross(positions[t + 2] - positions[t]).normalized();
            for (std::size_t i = t; i < t + 3; ++i) EXPECT_LT((opened.normals[i] - normal).norm(), 1e-4F);
        }
        nodes.push_back(opened);
    }
    return nodes;
}

TEST(Glb, OneNamedNodeAPart) {
    const zoo::Annotated object = zoo::broken_bench();
    const Glb glb = open_glb(to_glb(object.mesh, object.annotation, Vec3::UnitZ()));
    const std::vector<Node> nodes = open_nodes(glb);
    ASSERT_EQ(nodes.size(), 5U);
    const std::vector<std::string> names{"Seat", "Backrest", "Leg 1", "Leg 2", "unlabelled"};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_EQ(nodes[i].name, names[i]);
        EXPECT_EQ(nodes[i].corners.size(), 36U);
    }
    EXPECT_EQ(nodes[0].extras["score"], 0.99);
    EXPECT_EQ(nodes[0].extras["concepts"], (std::vector<std::string>{"Seat", "Support"}));
    EXPECT_EQ(glb.json["nodes"][0]["name"], "Bench, FootIncompatibleFurnitures");
    // z up became y up, and y (where the backrest is) became -z: what glTF calls front faces the viewer
    for (std::size_t i = 0; i < 36; ++i) {
        const Vec3& point = object.mesh.positions[static_cast<std::size_t>(object.mesh.triangles[i / 3][i % 3])];
        EXPECT_LT((nodes[0].corners[i] - Vec3(point.x(), point.z(), -point.y())).norm(), 1e-6);
    }
}

TEST(Glb, CompositePartsAreNodesThatHoldTheirPieces) {
    const zoo::Annotated object = zoo::made_up_bench();
    const Glb glb = open_glb(to_glb(object.mesh, object.annotation, Vec3::UnitZ()));
    const auto& nodes = glb.json["nodes"];
    const auto children_of = [&](std::string_view name) {
        std::set<std::string> names;
        for (const auto& node : nodes)
            if (node["name"] == name)
                for (const auto& child : node["children"]) names.insert(nodes[child.get<std::size_t>()]["name"]);
        return names;
    };
    using Names = std::set<std::string>;
    EXPECT_EQ(children_of("Bench"), (Names{"LegPair", "Top"}));
    EXPECT_EQ(children_of("LegPair"), (Names{"Leg 1", "Leg 2"}));
    EXPECT_EQ(children_of("Top"), (Names{"Seat", "Back"}));
    EXPECT_EQ(children_of("Back"), (Names{"Backrest"}));
    EXPECT_EQ(nodes.size(), 8U);
    EXPECT_EQ(nodes.back()["extras"]["concepts"], (std::vector<std::string>{"Top", "Upper"}));
}

TEST(Glb, EveryUpIsTurnedToYWithoutMirroring) {
    const unsigned seed = 20240611;
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<Vec3> ups{Vec3::UnitX(), -Vec3::UnitX(), Vec3::UnitY(),      -Vec3::UnitY(),
                          Vec3::UnitZ(), -Vec3::UnitZ(), Vec3(1e-12, -1, 0), Vec3(0, -5, 1e-7)};
    for (int i = 0; i < 20; ++i) ups.emplace_back(normal(random), normal(random), normal(random));
    const zoo::Annotated object = zoo::bench();
    for (const Vec3& up : ups) {
        const std::vector<Node> nodes = open_nodes(open_glb(to_glb(object.mesh, object.annotation, up)));
        ASSERT_EQ(nodes.size(), 4U);
        double volume = 0;
        for (const Node& node : nodes)
            for (std::size_t t = 0; t < node.corners.size(); t += 3)
                volume += node.corners[t].dot(node.corners[t + 1].cross(node.corners[t + 2])) / 6;
        EXPECT_NEAR(volume, 1.2 * 0.4 * 0.05 + 1.2 * 0.05 * 0.45 + 2 * 0.06 * 0.4 * 0.4, 1e-6) << up.transpose();
        for (std::size_t i = 0; i < 36; ++i) {
            const Vec3& point = object.mesh.positions[static_cast<std::size_t>(object.mesh.triangles[i / 3][i % 3])];
            EXPECT_NEAR(nodes[0].corners[i].y(), point.dot(up.normalized()), 1e-6) << up.transpose();
        }
    }
    EXPECT_THROW((void)to_glb(object.mesh, object.annotation, Vec3::Zero()), UsageError);
    EXPECT_THROW((void)to_glb(object.mesh, object.annotation, Vec3(0, 0, std::nan(""))), UsageError);
}

TEST(Glb, StaysExactFarFromTheOrigin) {
    const Vec3 shift(6e8, -4e8, 1e7);
    const zoo::Annotated near = zoo::bench(), far = zoo::bench(shift);
    const std::vector<Node> a = open_nodes(open_glb(to_glb(near.mesh, near.annotation, Vec3::UnitZ())));
    const std::vector<Node> b = open_nodes(open_glb(to_glb(far.mesh, far.annotation, Vec3::UnitZ())));
    for (std::size_t n = 0; n < a.size(); ++n)
        for (std::size_t i = 0; i < a[n].corners.size(); ++i) {
            const Vec3 back = b[n].corners[i] - Vec3(shift.x(), shift.z(), -shift.y());
            EXPECT_LT((back - a[n].corners[i]).norm(), 1e-6);
        }
}

TEST(Glb, IsInMetresWhenTheUnitIsKnown) {
    zoo::Annotated object = zoo::bench(Vec3(3, 0, 0));
    for (const auto& [unit, metres] :
         {std::pair{"mm", 0.001}, {"cm", 0.01}, {"in", 0.0254}, {"m", 1.0}, {"unknown", 1.0}}) {
        object.annotation.unit = unit;
        const std::vector<Node> nodes = open_nodes(open_glb(to_glb(object.mesh, object.annotation, Vec3::UnitY())));
        EXPECT_NEAR((nodes[0].corners[0] - metres * Vec3(3, 0, 0.4)).norm(), 0, 1e-7) << unit;
    }
}

TEST(Glb, OfNoTrianglesAndOfPartsWithoutTriangles) {
    Annotation annotation;
    annotation.parts.resize(1);
    const Glb glb = open_glb(to_glb(TriangleMesh{}, annotation, Vec3::UnitZ()));
    EXPECT_FALSE(glb.json.contains("meshes"));
    EXPECT_EQ(glb.json["nodes"].size(), 1U);
    EXPECT_TRUE(glb.binary.empty());
}

TEST(Glb, DegenerateTrianglesHaveUnitNormals) {
    zoo::Annotated object = zoo::bench();
    object.mesh.triangles[0] = {0, 0, 1};
    const Glb glb = open_glb(to_glb(object.mesh, object.annotation, Vec3::UnitZ()));
    for (const Eigen::Vector3f& normal : vectors(glb, glb.json["meshes"][0]["primitives"][0]["attributes"]["NORMAL"]))
        EXPECT_NEAR(normal.norm(), 1, 1e-5);
}

}  // namespace
}  // namespace partonomy
