#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>

#include "base/errors.h"
#include "mesh/gltf_materials.h"
#include "mesh/readers.h"
#include "mesh/text_cursor.h"

// The surface of a glTF scene. Its nodes are walked in their order, a node before its children, each mesh stands where
// the matrices above it put it, and the triangles of its primitives become faces in file order: triangle i of the walk
// is input face i. Points and lines are passed over, and so are skins, morph targets and animations: what is read is
// the model at rest. A matrix that mirrors turns its triangles over, so that they keep their outside.
//
// A few bytes of nodes may show one mesh any number of times. What repeated meshes add is bounded, the rest is bounded
// by the bytes of the file.

namespace partonomy {
namespace {

using Mat4 = Eigen::Matrix4d;

constexpr std::size_t largest_repetition = 10'000'000;  // triangles, and vertices

Mat4 matrix_of(const GltfValue& node) {
    Mat4 matrix = Mat4::Identity();
    if (node["matrix"]) {
        const std::vector<double> numbers = node["matrix"].numbers(std::vector<double>(16, 0));
        for (int i = 0; i < 16; ++i) matrix(i % 4, i / 4) = numbers[static_cast<std::size_t>(i)];
        return matrix;
    }
    const std::vector<double> t = node["translation"].numbers({0, 0, 0}), r = node["rotation"].numbers({0, 0, 0, 1}),
                              s = node["scale"].numbers({1, 1, 1});
    const Eigen::Quaterniond rotation(r[3], r[0], r[1], r[2]);
    if (!(rotation.norm() > 1e-6)) node["rotation"].fail("is no rotation: its four numbers are zero");
    matrix.topLeftCorner<3, 3>() = rotation.normalized().toRotationMatrix() * Vec3(s[0], s[1], s[2]).asDiagonal();
    matrix.topRightCorner<3, 1>() = Vec3(t[0], t[1], t[2]);
    return matrix;
}

class Scene {
public:
    Scene(GltfFile& file, SoupAppearance* appearance) : file_(file), appearance_(appearance) {
        if (appearance) materials_.emplace(file, *appearance);
        soup_.face_starts.push_back(0);
    }

    PolygonSoup read() {
        const GltfValue root = file_.root(), scenes = root["scenes"];
        if (scenes.size() > 0) {
            const std::size_t chosen = root["scene"].count();
            walk(file_.item("scenes", chosen, root["scene"])["nodes"]);
        } else {  // no scene: everything that is no child
            walk_all(root["nodes"]);
        }
        if (soup_.face_count() == 0 && root["meshes"].size() > 0 && passed_over_ == 0 && root["nodes"].size() == 0) {
            const GltfValue meshes = root["meshes"];  // meshes without nodes, as some programs write them
            for (std::size_t i = 0; i < meshes.size(); ++i) add_mesh(meshes[i], Mat4::Identity());
        }
        if (passed_over_ > 0)
            soup_.notes.push_back(fmt::format("{} sets of points and lines were passed over.", passed_over_));
        if (has_skins_) soup_.notes.push_back("Skins and morph targets were passed over: the model is read at rest.");
        if (appearance_ && !appearance_->vertex_colors.empty())
            appearance_->vertex_colors.resize(soup_.positions.size(), unknown_color());
        return std::move(soup_);
    }

private:
    struct Visit {
        std::size_t node;
        Mat4 parent;
    };

    void push(const GltfValue& children, const Mat4& matrix) {
        for (std::size_t i = children.size(); i-- > 0;) {
            const GltfValue child = children[i];
            const std::size_t index = child.count();
            static_cast<void>(file_.item("nodes", index, child));
            if (seen_.size() <= index) seen_.resize(index + 1, false);
            if (seen_[index]) child.fail(fmt::format("reaches node {} a second time; nodes form a tree", index));
            seen_[index] = true;
            open_.push_back({index, matrix});
        }
    }

    void walk(const GltfValue& roots) {
        push(roots, Mat4::Identity());
        while (!open_.empty()) {
            const Visit visit = open_.back();
            open_.pop_back();
            const GltfValue node = file_.root()["nodes"][visit.node];
            const Mat4 matrix = visit.parent * matrix_of(node);
            has_skins_ |= static_cast<bool>(node["skin"]);
            if (const auto mesh = node["mesh"].index()) add_mesh(file_.item("meshes", *mesh, node["mesh"]), matrix);
            push(node["children"], matrix);
        }
    }

    void walk_all(const GltfValue& nodes) {
        std::vector<bool> is_child(nodes.size(), false);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const GltfValue children = nodes[i]["children"];
            for (std::size_t k = 0; k < children.size(); ++k)
                if (const std::size_t child = children[k].count(); child < is_child.size()) is_child[child] = true;
        }
        nlohmann::json roots = nlohmann::json::array();
        for (std::size_t i = 0; i < is_child.size(); ++i)
            if (!is_child[i]) roots.push_back(i);
        walk(GltfValue(&roots, "nodes", file_.name()));
    }

    void add_mesh(const GltfValue& mesh, const Mat4& matrix) {
        has_skins_ |= static_cast<bool>(mesh["weights"]);
        const GltfValue primitives = mesh["primitives"];
        std::map<std::pair<std::size_t, std::size_t>, std::size_t> placed;  // positions and colours -> first vertex
        for (std::size_t i = 0; i < primitives.size(); ++i) add_primitive(primitives[i], matrix, placed);
    }

    void add_primitive(const GltfValue& primitive, const Mat4& matrix,
                       std::map<std::pair<std::size_t, std::size_t>, std::size_t>& placed) {
        const std::uint64_t mode = primitive["mode"].count(4);
        if (mode > 6) primitive["mode"].fail("must be a number from 0 to 6");
        if (mode < 4) {
            ++passed_over_;
            return;
        }
        const GltfValue attributes = primitive["attributes"];
        const auto position = attributes["POSITION"].index();
        if (!position) primitive.fail("has no positions: attributes.POSITION is missing");
        const GltfNumbers positions = file_.numbers(*position, {"VEC3"}, attributes["POSITION"]);
        std::optional<std::size_t> color;
        if (appearance_) color = attributes["COLOR_0"].index();
        constexpr auto none = static_cast<std::size_t>(-1);
        const auto [found, is_new] = placed.try_emplace({*position, color.value_or(none)}, soup_.positions.size());
        if (is_new) add_vertices(positions, matrix, attributes["POSITION"]);
        if (is_new && color) add_colors(*color, positions.count, attributes["COLOR_0"]);

        std::optional<GltfNumbers> indices;
        if (const auto accessor = primitive["indices"].index()) {
            indices = file_.numbers(*accessor, {"SCALAR"}, primitive["indices"]);
            if (indices->type != 5121 && indices->type != 5123 && indices->type != 5125)
                primitive["indices"].fail("must be whole numbers without sign (5121, 5123 or 5125)");
        }
        const std::size_t corners = indices ? indices->count : positions.count;
        const std::size_t triangles = mode == 4 ? corners / 3 : corners < 3 ? 0 : corners - 2;
        if (mode == 4 && corners % 3 != 0)
            primitive.fail(fmt::format("has {} corners, which is no multiple of 3; triangles have 3", corners));
        count_up(triangles_, triangles, primitive);
        std::optional<MaterialMaps::Use> use;
        if (materials_) use = materials_->use(primitive, positions.count);
        const bool is_mirrored = matrix.topLeftCorner<3, 3>().determinant() < 0;
        for (std::size_t t = 0; t < triangles; ++t) {
            std::array<std::size_t, 3> triangle{3 * t, 3 * t + 1, 3 * t + 2};
            if (mode == 5) triangle = t % 2 == 0 ? std::array{t, t + 1, t + 2} : std::array{t + 1, t, t + 2};
            if (mode == 6) triangle = {t + 1, t + 2, 0};
            if (is_mirrored) std::swap(triangle[1], triangle[2]);
            for (std::size_t corner : triangle) {
                if (indices) corner = indices->whole(corner);
                if (corner >= positions.count)
                    primitive["indices"].fail(
                        fmt::format("refers to vertex {} in triangle {}; indices run from 0 to {}", corner, t,
                                    static_cast<std::int64_t>(positions.count) - 1));
                soup_.corners.push_back(static_cast<std::int32_t>(found->second + corner));
                if (use) materials_->add_corner(*use, corner);
            }
            soup_.face_starts.push_back(static_cast<std::int64_t>(soup_.corners.size()));
            if (use) materials_->add_face(*use);
        }
    }

    /// Each vertex and triangle of an honest file takes a byte of its buffers at least; what is more is repetition.
    void count_up(std::size_t& all, std::size_t added, const GltfValue& asker) const {
        all += added;
        if (all > largest_repetition + file_.bytes_held())
            asker.fail(fmt::format("is one repetition too many: more than {} vertices or triangles repeat others",
                                   largest_repetition));
    }

    void add_vertices(const GltfNumbers& positions, const Mat4& matrix, const GltfValue& asker) {
        count_up(vertices_, positions.count, asker);
        if (soup_.positions.size() + positions.count > static_cast<std::size_t>(largest_count))
            asker.fail("brings the model to more than 2147483647 vertices; cut it into several files");
        for (std::size_t k = 0; k < positions.count; ++k) {
            const Vec3 local(positions.number(k, 0), positions.number(k, 1), positions.number(k, 2));
            const Vec3 point = matrix.topLeftCorner<3, 3>() * local + matrix.topRightCorner<3, 1>();
            if (!is_usable(point)) asker.fail(": " + what_is_wrong_with(point, static_cast<std::int64_t>(k)));
            soup_.positions.push_back(point);
        }
    }

    void add_colors(std::size_t accessor, std::size_t count, const GltfValue& asker) {
        const GltfNumbers numbers = file_.numbers(accessor, {"VEC3", "VEC4"}, asker);
        if (numbers.count != count) asker.fail(fmt::format("has {} colours for {} vertices", numbers.count, count));
        std::vector<Color>& colors = appearance_->vertex_colors;
        colors.resize(soup_.positions.size() - count, unknown_color());
        for (std::size_t k = 0; k < count; ++k) {
            Color color;
            for (int i = 0; i < 3; ++i)
                color[i] = static_cast<float>(std::clamp(numbers.number(k, static_cast<std::size_t>(i)), 0.0, 1.0));
            colors.push_back(color);
        }
    }

    GltfFile& file_;
    SoupAppearance* appearance_;
    std::optional<MaterialMaps> materials_;
    PolygonSoup soup_;
    std::vector<bool> seen_;
    std::vector<Visit> open_;
    std::size_t vertices_ = 0, triangles_ = 0, passed_over_ = 0;
    bool has_skins_ = false;
};

}  // namespace

PolygonSoup parse_gltf(std::string_view bytes, const std::string& name, const Companions& companions,
                       SoupAppearance* appearance) {
    GltfFile file(bytes, name, companions);
    return Scene(file, appearance).read();
}

}  // namespace partonomy
