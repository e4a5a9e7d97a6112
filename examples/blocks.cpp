// Scenes of boxes, cones and balls, each a closed surface with as many triangles as asked for.
//
// A union of boxes is made on the grid of all their sides, cut further where its lines are wider apart than `edge`:
// each cell belongs to the last box that holds it, and the sides between a full and an empty cell are the surface. So a
// building may have its windows carved into it, or a bench its legs grown onto it, as one surface without a seam.

#include "examples/blocks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <unordered_map>
#include <utility>

namespace partonomy {
namespace {

constexpr double two_pi = 2 * std::numbers::pi;

std::size_t steps(double length, double edge) {
    return std::max<std::size_t>(1, static_cast<std::size_t>(std::ceil(length / edge - 1e-9)));
}

/// Triangles of one surface, handed to the scene's mesh.
class Builder {
public:
    explicit Builder(ExampleObject& object) : object_(object) {}
    void begin(const Pose& pose, std::size_t parts) {
        pose_ = pose;
        first_part_ = object_.part_count;
        object_.part_count += static_cast<int>(parts);
    }
    std::int32_t vertex(const Vec3& p) {
        object_.mesh.positions.push_back(pose_(p));
        return static_cast<std::int32_t>(object_.mesh.positions.size()) - 1;
    }
    void triangle(std::int32_t a, std::int32_t b, std::int32_t c, const std::string& label, int part) {
        object_.mesh.triangles.push_back({a, b, c});
        object_.labels.push_back(label);
        object_.parts.push_back(first_part_ + part);
    }
    void quad(const std::array<std::int32_t, 4>& v, const std::string& label, int part) {
        triangle(v[0], v[1], v[2], label, part);
        triangle(v[0], v[2], v[3], label, part);
    }

private:
    ExampleObject& object_;
    Pose pose_;
    int first_part_ = 0;
};

/// The cells of a union of boxes.
class Grid {
public:
    Grid(const std::vector<Block>& blocks, double edge) : blocks_(blocks) {
        for (int axis = 0; axis < 3; ++axis) {
            std::vector<double> ends;
            for (const Block& block : blocks) ends.insert(ends.end(), {block.low[axis], block.high[axis]});
            std::ranges::sort(ends);
            auto& lines = lines_[static_cast<std::size_t>(axis)];
            for (const double end : ends) {
                if (!lines.empty() && end - lines.back() < 1e-9) continue;
                if (!lines.empty()) {
                    const double from = lines.back();
                    const std::size_t n = steps(end - from, edge);
                    for (std::size_t i = 1; i < n; ++i)
                        lines.push_back(from + (end - from) * static_cast<double>(i) / static_cast<double>(n));
                }
                lines.push_back(end);
            }
        }
        owner_.assign(cells(0) * cells(1) * cells(2), -1);
        for (std::size_t b = 0; b < blocks.size(); ++b) {
            std::array<std::pair<std::size_t, std::size_t>, 3> range;
            for (std::size_t axis = 0; axis < 3; ++axis)
                range[axis] = {line_at(axis, blocks[b].low[static_cast<int>(axis)]),
                               line_at(axis, blocks[b].high[static_cast<int>(axis)])};
            for (std::size_t k = range[2].first; k < range[2].second; ++k)
                for (std::size_t j = range[1].first; j < range[1].second; ++j)
                    for (std::size_t i = range[0].first; i < range[0].second; ++i)
                        owner_[cell(i, j, k)] = static_cast<int>(b);
        }
    }

    /// Calls visit(corners as line numbers, counter-clockwise from outside; block that the face belongs to).
    template <typename Visit>
    void for_each_face(const Visit& visit) const {
        using Place = std::array<std::size_t, 3>;
        for (std::size_t k = 0; k < cells(2); ++k)
            for (std::size_t j = 0; j < cells(1); ++j)
                for (std::size_t i = 0; i < cells(0); ++i) {
                    const int inside = owner_[cell(i, j, k)];
                    if (!is_full(inside)) continue;
                    for (std::size_t axis = 0; axis < 3; ++axis)
                        for (const bool forth : {false, true}) {
                            Place here{i, j, k}, next = here;
                            const bool at_end = forth ? here[axis] + 1 == cells(axis) : here[axis] == 0;
                            if (!at_end) next[axis] = forth ? next[axis] + 1 : next[axis] - 1;
                            const int outside = at_end ? -1 : owner_[cell(next[0], next[1], next[2])];
                            if (is_full(outside)) continue;
                            const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
                            std::array<Place, 4> corners{here, here, here, here};
                            for (Place& corner : corners) corner[axis] += forth ? 1 : 0;
                            ++corners[1][u], ++corners[2][u], ++corners[2][v], ++corners[3][v];
                            if (!forth) std::swap(corners[1], corners[3]);
                            Vec3 normal = Vec3::Zero();
                            normal[static_cast<int>(axis)] = forth ? 1 : -1;
                            const bool is_floor =
                                outside >= 0 && blocks_[static_cast<std::size_t>(outside)].facing.dot(normal) > 0.5;
                            visit(corners, blocks_[static_cast<std::size_t>(is_floor ? outside : inside)]);
                        }
                }
    }
    [[nodiscard]] Vec3 at(const std::array<std::size_t, 3>& place) const {
        return {lines_[0][place[0]], lines_[1][place[1]], lines_[2][place[2]]};
    }
    [[nodiscard]] std::uint64_t key(const std::array<std::size_t, 3>& place) const {
        return (place[2] * lines_[1].size() + place[1]) * lines_[0].size() + place[0];
    }

private:
    [[nodiscard]] std::size_t cells(std::size_t axis) const { return lines_[axis].size() - 1; }
    [[nodiscard]] std::size_t cell(std::size_t i, std::size_t j, std::size_t k) const {
        return (k * cells(1) + j) * cells(0) + i;
    }
    [[nodiscard]] std::size_t line_at(std::size_t axis, double where) const {
        const auto& lines = lines_[axis];
        return static_cast<std::size_t>(std::lower_bound(lines.begin(), lines.end(), where - 1e-8) - lines.begin());
    }
    [[nodiscard]] bool is_full(int owner) const {
        return owner >= 0 && !blocks_[static_cast<std::size_t>(owner)].is_cut;
    }

    const std::vector<Block>& blocks_;
    std::array<std::vector<double>, 3> lines_;
    std::vector<int> owner_;  ///< block of each cell, -1 for none
};

/// Of a gable the box's upper side is pressed together to the ridge, whose width of a hundredth stays.
Vec3 fold(const Shape& shape, Vec3 p) {
    if (shape.kind != Shape::Kind::gable) return p;
    const Block& box = shape.blocks.front();
    const double middle = (box.low.y() + box.high.y()) / 2;
    const double share = 1 - 0.99 * (p.z() - box.low.z()) / (box.high.z() - box.low.z());
    p.y() = middle + (p.y() - middle) * share;
    return p;
}

void add_blocks(const Shape& shape, double edge, Builder& builder) {
    const Grid grid(shape.blocks, edge);
    std::unordered_map<std::uint64_t, std::int32_t> vertices;
    grid.for_each_face([&](const auto& corners, const Block& block) {
        std::array<std::int32_t, 4> quad{};
        for (std::size_t c = 0; c < 4; ++c) {
            const auto [found, is_new] = vertices.try_emplace(grid.key(corners[c]), 0);
            if (is_new) found->second = builder.vertex(fold(shape, grid.at(corners[c])));
            quad[c] = found->second;
        }
        builder.quad(quad, block.label, block.part);
    });
}

bool is_grid(const Shape& shape) { return shape.kind == Shape::Kind::blocks || shape.kind == Shape::Kind::gable; }

/// A ring of as many points around the axis for each (radius, height); the ends are closed by a point on the axis.
struct Rings {
    std::vector<std::pair<double, double>> rings;
    std::size_t around = 0;
    double bottom = 0, top = 0;
};

Rings rings_of(const Shape& shape, double edge) {
    Rings result{
        {}, std::clamp<std::size_t>(steps(two_pi * shape.radius, edge), 8, 256), shape.low, shape.low + shape.height};
    if (shape.kind == Shape::Kind::cone) {
        const auto lid = [&](double radius, double z, bool inward) {
            const std::size_t n = steps(radius, edge);
            std::vector<std::pair<double, double>> circles;
            for (std::size_t i = 1; i < n; ++i)
                circles.emplace_back(radius * static_cast<double>(i) / static_cast<double>(n), z);
            if (inward) std::ranges::reverse(circles);
            result.rings.insert(result.rings.end(), circles.begin(), circles.end());
        };
        lid(shape.radius, result.bottom, false);
        const std::size_t n = steps(shape.height, edge);
        for (std::size_t i = 0; i <= n; ++i) {
            const double t = static_cast<double>(i) / static_cast<double>(n);
            result.rings.emplace_back(shape.radius + t * (shape.upper_radius - shape.radius),
                                      shape.low + t * shape.height);
        }
        lid(shape.upper_radius, result.top, true);
    } else {
        const std::size_t n = std::max<std::size_t>(6, steps(std::numbers::pi * shape.radius, edge));
        for (std::size_t i = 1; i < n; ++i) {
            const double angle = std::numbers::pi * static_cast<double>(i) / static_cast<double>(n);
            result.rings.emplace_back(shape.radius * std::sin(angle),
                                      shape.low + shape.height / 2 * (1 - std::cos(angle)));
        }
    }
    return result;
}

void add_round(const Shape& shape, double edge, Builder& builder) {
    const Rings rings = rings_of(shape, edge);
    const std::size_t n = rings.around;
    const std::int32_t foot = builder.vertex({0, 0, rings.bottom});
    std::vector<std::int32_t> last;
    for (const auto& [radius, z] : rings.rings) {
        std::vector<std::int32_t> ring;
        for (std::size_t i = 0; i < n; ++i) {
            const double angle = two_pi * static_cast<double>(i) / static_cast<double>(n);
            ring.push_back(builder.vertex({radius * std::cos(angle), radius * std::sin(angle), z}));
        }
        for (std::size_t i = 0; i < n; ++i) {
            const std::size_t j = (i + 1) % n;
            if (last.empty())
                builder.triangle(foot, ring[j], ring[i], shape.label, 0);
            else
                builder.quad({last[i], last[j], ring[j], ring[i]}, shape.label, 0);
        }
        last = std::move(ring);
    }
    const std::int32_t top = builder.vertex({0, 0, rings.top});
    for (std::size_t i = 0; i < n; ++i) builder.triangle(last[i], last[(i + 1) % n], top, shape.label, 0);
}

}  // namespace

Vec3 Pose::operator()(const Vec3& p) const {
    const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    return at + Vec3(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
}

std::size_t ShapeScene::triangle_count(double edge) const {
    std::size_t count = 0;
    for (const Shape& shape : shapes)
        if (is_grid(shape)) {
            Grid(shape.blocks, edge).for_each_face([&](const auto&, const Block&) { count += 2; });
        } else {
            const Rings rings = rings_of(shape, edge);
            count += 2 * rings.around * rings.rings.size();
        }
    return count;
}

double ShapeScene::edge_for(std::size_t triangles) const {
    double high = 100, low = high;
    while (triangle_count(low) < triangles) high = std::exchange(low, low / 2);
    while (high / low > 1.01) {
        const double middle = std::sqrt(low * high);
        (triangle_count(middle) >= triangles ? low : high) = middle;
    }
    return low;
}

ExampleObject ShapeScene::mesh(double edge) const {
    ExampleObject object;
    Builder builder(object);
    for (const Shape& shape : shapes) {
        int parts = 1;
        for (const Block& block : shape.blocks) parts = std::max(parts, block.part + 1);
        builder.begin(shape.pose, static_cast<std::size_t>(parts));
        if (is_grid(shape))
            add_blocks(shape, edge, builder);
        else
            add_round(shape, edge, builder);
    }
    TriangleMesh& mesh = object.mesh;
    mesh.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    for (std::int32_t t = 0; t < mesh.input_face_count; ++t) mesh.input_faces.push_back(t);
    return object;
}

}  // namespace partonomy
