#include "examples/solid.h"

#include <algorithm>

#include "mesh/triangulate.h"

namespace partonomy {
namespace {

double turn(const Vec3& a, const Vec3& b, const Vec3& c) {
    return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Whether two segments meet elsewhere than at common ends.
bool cross(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    if (a == c || a == d || b == c || b == d) return false;
    return (turn(a, b, c) > 0) != (turn(a, b, d) > 0) && (turn(c, d, a) > 0) != (turn(c, d, b) > 0);
}

/// Whether the way from corner `at` to `target` begins inside of a counter-clockwise polygon.
bool begins_inside(const Vec3& before, const Vec3& at, const Vec3& after, const Vec3& target) {
    const bool left_of_way_in = turn(before, at, target) > 0, left_of_way_out = turn(at, after, target) > 0;
    return turn(before, at, after) > 0 ? left_of_way_in && left_of_way_out : left_of_way_in || left_of_way_out;
}

}  // namespace

Solid::Vertex Solid::at(double x, double y, double z) {
    const auto [place, added] = places_.try_emplace({x, y, z}, static_cast<Vertex>(object_.mesh.positions.size()));
    if (added) object_.mesh.positions.emplace_back(x, y, z);
    return place->second;
}

void Solid::begin_part(const std::string& label) {
    label_ = label;
    ++object_.part_count;
}

void Solid::face(std::vector<Vertex> corners, bool reversed) {
    if (reversed) std::reverse(corners.begin(), corners.end());
    TriangleMesh& mesh = object_.mesh;
    triangulate_polygon(mesh.positions, corners, mesh.triangles);
    object_.labels.resize(mesh.triangles.size(), label_);
    object_.parts.resize(mesh.triangles.size(), object_.part_count - 1);
}

void Solid::face_with_holes(std::vector<Vertex> border, std::vector<std::vector<Vertex>> holes, bool reversed) {
    // Each hole is joined to the border by a slit to the nearest corner that it sees, the rightmost hole first.
    const auto rightmost = [&](std::vector<Vertex>& hole) {
        return std::ranges::max_element(hole, {}, [&](Vertex v) { return position(v).x(); });
    };
    for (std::vector<Vertex>& hole : holes) {
        std::ranges::reverse(hole);
        std::ranges::rotate(hole, rightmost(hole));
    }
    std::ranges::sort(holes, {}, [&](const std::vector<Vertex>& hole) { return -position(hole.front()).x(); });
    for (std::size_t h = 0; h < holes.size(); ++h) {
        const Vec3 from = position(holes[h].front());
        const auto is_free = [&](const std::vector<Vertex>& ring, const Vec3& to) {
            for (std::size_t i = 0; i < ring.size(); ++i)
                if (cross(from, to, position(ring[i]), position(ring[(i + 1) % ring.size()]))) return false;
            return true;
        };
        std::size_t best = border.size();
        for (std::size_t i = 0; i < border.size(); ++i) {
            const Vec3& to = position(border[i]);
            if (best < border.size() && (to - from).norm() >= (position(border[best]) - from).norm()) continue;
            const Vec3& before = position(border[(i + border.size() - 1) % border.size()]);
            const Vec3& after = position(border[(i + 1) % border.size()]);
            if (!begins_inside(before, to, after, from) || !is_free(border, to)) continue;
            if (std::all_of(holes.begin() + static_cast<std::ptrdiff_t>(h), holes.end(),
                            [&](const auto& ring) { return is_free(ring, to); }))
                best = i;
        }
        std::vector<Vertex> slit = holes[h];
        slit.push_back(slit.front());
        slit.push_back(border.at(best));
        border.insert(border.begin() + static_cast<std::ptrdiff_t>(best) + 1, slit.begin(), slit.end());
    }
    face(border, reversed);
}

void Solid::prism(const std::vector<Vertex>& base, double z) {
    const bool down = z < position(base.front()).z();
    std::vector<Vertex> lid;
    for (const Vertex v : base) {
        const Vec3 p = position(v);
        lid.push_back(at(p.x(), p.y(), z));
    }
    for (std::size_t i = 0; i < base.size(); ++i) {
        const std::size_t j = (i + 1) % base.size();
        face({base[i], base[j], lid[j], lid[i]}, down);
    }
    face(lid, down);
}

ExampleObject Solid::finish(std::string name, std::string object_class, std::string incompatibility) && {
    TriangleMesh& mesh = object_.mesh;
    mesh.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    for (std::int32_t t = 0; t < mesh.input_face_count; ++t) mesh.input_faces.push_back(t);
    object_.name = std::move(name);
    object_.object_class = std::move(object_class);
    object_.incompatibility = std::move(incompatibility);
    return std::move(object_);
}

}  // namespace partonomy
