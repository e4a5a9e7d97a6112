#include "examples/solid.h"

#include <algorithm>

#include "mesh/triangulate.h"

namespace partonomy {

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
