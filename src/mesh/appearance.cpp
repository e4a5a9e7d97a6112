#include "mesh/appearance.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "base/errors.h"
#include "base/files.h"
#include "mesh/companions.h"

// From what the file says of its polygons' corners to what holds at the corners of the mesh's triangles. Cleaning
// welds, cuts and turns polygons, but moves nothing: a triangle's corner lies where a corner of its polygon lies, so it
// takes that one's colour and place in the image.

namespace partonomy {
namespace {

/// Corners of a polygon by their place.
class Corners {
public:
    Corners(const PolygonSoup& soup, std::size_t face)
        : soup_(soup),
          begin_(static_cast<std::size_t>(soup.face_starts[face])),
          order_(static_cast<std::size_t>(soup.face_starts[face + 1]) - begin_) {
        std::iota(order_.begin(), order_.end(), begin_);
        if (order_.size() > few)
            std::stable_sort(order_.begin(), order_.end(),
                             [&](std::size_t a, std::size_t b) { return before(at(a), at(b)); });
    }

    /// Two corners between which a place lies, and its share of the way: where a T-junction was cut.
    struct Between {
        std::size_t from, to;
        double share;
    };
    /// `nearest` twice where `place` lies there, or on no side.
    [[nodiscard]] Between find_between(const Vec3& place, std::size_t nearest) const {
        if (at(nearest) == place) return {nearest, nearest, 0};
        const std::size_t count = order_.size();
        for (std::size_t i = 0; i < count; ++i) {
            const Between side{begin_ + i, begin_ + (i + 1) % count, 0};
            const Vec3 way = at(side.to) - at(side.from), there = place - at(side.from);
            const double share = there.dot(way) / std::max(way.squaredNorm(), 1e-300);
            if (share > 1e-3 && share < 1 - 1e-3 && (there - share * way).norm() < 1e-3 * way.norm())
                return {side.from, side.to, share};
        }
        return {nearest, nearest, 0};
    }

    /// The corner that lies at `place`, or, where welding took another vertex for it, nearest to it.
    [[nodiscard]] std::size_t find(const Vec3& place) const {
        std::size_t first = 0, last = order_.size();
        if (order_.size() > few) {
            const auto found = std::lower_bound(order_.begin(), order_.end(), place,
                                                [&](std::size_t a, const Vec3& p) { return before(at(a), p); });
            const auto middle = static_cast<std::size_t>(found - order_.begin());
            first = middle - std::min(middle, few / 2);
            last = std::min(order_.size(), middle + few / 2);
        }
        std::size_t best = order_[first];
        for (std::size_t i = first; i < last; ++i)
            if ((at(order_[i]) - place).squaredNorm() < (at(best) - place).squaredNorm()) best = order_[i];
        return best;
    }

private:
    static constexpr std::size_t few = 32;
    [[nodiscard]] const Vec3& at(std::size_t corner) const {
        return soup_.positions[static_cast<std::size_t>(soup_.corners[corner])];
    }
    static bool before(const Vec3& a, const Vec3& b) {
        return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end());
    }

    const PolygonSoup& soup_;
    std::size_t begin_;
    std::vector<std::size_t> order_;
};

/// A coordinate of a texture point in [0, 1).
float wrapped(float x, Wrap wrap) {
    if (!std::isfinite(x)) return 0;
    switch (wrap) {
        case Wrap::repeat:
            return x - std::floor(x);
        case Wrap::mirror: {
            const float period = x - 2 * std::floor(x / 2);
            return period < 1 ? period : 2 - period;
        }
        case Wrap::clamp:
            break;
    }
    return std::clamp(x, 0.0F, 1.0F);
}

}  // namespace

Color Image::color_at(const TexturePoint& point, Wrap u, Wrap v) const {
    const auto pixel = [](float x, int size) {
        return std::clamp(static_cast<int>(x * static_cast<float>(size)), 0, size - 1);
    };
    const auto x = static_cast<std::size_t>(pixel(wrapped(point.x(), u), width));
    const auto y = static_cast<std::size_t>(pixel(wrapped(point.y(), v), height));
    const std::uint8_t* bytes = rgb.data() + 3 * (y * static_cast<std::size_t>(width) + x);
    static const std::array<float, 256> linear = [] {
        std::array<float, 256> table{};
        for (std::size_t i = 0; i < table.size(); ++i)
            table[i] = linear_from_srgb(Color::Constant(static_cast<float>(i) / 255)).x();
        return table;
    }();
    return {linear[bytes[0]], linear[bytes[1]], linear[bytes[2]]};
}

bool SoupAppearance::is_empty() const {
    const auto any_known = [](const std::vector<Color>& colors) { return std::ranges::any_of(colors, is_known); };
    return std::ranges::all_of(face_materials, [](std::int32_t m) { return m < 0; }) && !any_known(vertex_colors) &&
           !any_known(face_colors);
}

void from_srgb(std::vector<Color>& colors) {
    const bool is_bytes = std::ranges::any_of(colors, [](const Color& c) { return is_known(c) && c.maxCoeff() > 1; });
    for (Color& color : colors) color = linear_from_srgb(is_bytes ? Color(color / 255) : color);
}

const Material* Appearance::material_of(std::size_t t) const {
    if (face_materials.empty() || face_materials[t] < 0) return nullptr;
    return &materials[static_cast<std::size_t>(face_materials[t])];
}

Color Appearance::color_at(std::size_t t, const Eigen::Vector3f& weights) const {
    const Material* material = material_of(t);
    Color color = material ? material->color : unknown_color();
    if (material && material->image >= 0 && !corner_points.empty()) {
        const auto& points = corner_points[t];
        const TexturePoint point = weights[0] * points[0] + weights[1] * points[1] + weights[2] * points[2];
        color = color.cwiseProduct(
            images[static_cast<std::size_t>(material->image)].color_at(point, material->wrap_u, material->wrap_v));
    }
    if (corner_colors.empty()) return color;
    const auto& corners = corner_colors[t];
    const Color own = weights[0] * corners[0] + weights[1] * corners[1] + weights[2] * corners[2];
    if (!is_known(own)) return color;
    return material ? Color(color.cwiseProduct(own)) : own;
}

bool Appearance::is_plain(std::size_t t) const {
    const Material* material = material_of(t);
    if (material && material->image >= 0 && !corner_points.empty()) return false;
    return corner_colors.empty() || !is_known(corner_colors[t][0]) ||
           (corner_colors[t][0] == corner_colors[t][1] && corner_colors[t][1] == corner_colors[t][2]);
}

Appearance bind_appearance(SoupAppearance colors, const PolygonSoup& soup, const TriangleMesh& mesh) {
    Appearance appearance;
    const std::size_t count = mesh.triangles.size();
    if (!colors.vertex_colors.empty() || !colors.face_colors.empty()) appearance.corner_colors.resize(count);
    if (!colors.corner_points.empty()) appearance.corner_points.resize(count);
    if (!colors.face_materials.empty()) appearance.face_materials.resize(count);
    std::optional<Corners> corners;
    std::int32_t last_face = -1;
    for (std::size_t t = 0; t < count; ++t) {
        const std::int32_t face = mesh.input_faces[t];
        const auto f = static_cast<std::size_t>(face);
        if (!appearance.face_materials.empty()) appearance.face_materials[t] = colors.face_materials[f];
        const bool by_face = !colors.face_colors.empty() && is_known(colors.face_colors[f]);
        if (by_face) appearance.corner_colors[t].fill(colors.face_colors[f]);
        if (colors.corner_points.empty() && (by_face || colors.vertex_colors.empty())) {
            if (!by_face && !appearance.corner_colors.empty()) appearance.corner_colors[t].fill(unknown_color());
            continue;
        }
        if (face != last_face) corners.emplace(soup, f);
        last_face = face;
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec3& place = mesh.positions[static_cast<std::size_t>(mesh.triangles[t][i])];
            const auto between = corners->find_between(place, corners->find(place));
            const auto share = static_cast<float>(between.share);
            if (!appearance.corner_points.empty())
                appearance.corner_points[t][i] =
                    (1 - share) * colors.corner_points[between.from] + share * colors.corner_points[between.to];
            if (by_face || appearance.corner_colors.empty()) continue;
            const auto color_of = [&](std::size_t at) {
                return colors.vertex_colors[static_cast<std::size_t>(soup.corners[at])];
            };
            appearance.corner_colors[t][i] =
                colors.vertex_colors.empty()
                    ? unknown_color()
                    : Color((1 - share) * color_of(between.from) + share * color_of(between.to));
        }
    }
    appearance.materials = std::move(colors.materials);
    appearance.images = std::move(colors.images);
    return appearance;
}

std::shared_ptr<const Appearance> read_appearance(const std::filesystem::path& path,
                                                  const std::string& sha256_when_read, const TriangleMesh& mesh) {
    const std::string bytes = read_file(path);
    if (sha256(bytes) != sha256_when_read)
        throw MeshError(at(path.string(), 0, "was changed while it was read; start again when nothing writes to it"));
    SoupAppearance colors;
    const PolygonSoup soup = parse_mesh(bytes, path.string(), Companions(path), &colors);
    if (colors.is_empty()) return nullptr;
    return std::make_shared<const Appearance>(bind_appearance(std::move(colors), soup, mesh));
}

}  // namespace partonomy
