#include "examples/transforms.h"

#include <cmath>
#include <map>
#include <numbers>
#include <random>
#include <utility>

namespace partonomy {

ExampleObject rotated_about_z(ExampleObject object, double degrees) {
    const double angle = degrees * std::numbers::pi / 180, c = std::cos(angle), s = std::sin(angle);
    for (Vec3& p : object.mesh.positions) p = Vec3(c * p.x() - s * p.y(), s * p.x() + c * p.y(), p.z());
    return object;
}

ExampleObject translated(ExampleObject object, const Vec3& by) {
    for (Vec3& p : object.mesh.positions) p += by;
    return object;
}

ExampleObject scaled(ExampleObject object, double factor) {
    for (Vec3& p : object.mesh.positions) p *= factor;
    return object;
}

ExampleObject mirrored(ExampleObject object) {
    for (Vec3& p : object.mesh.positions) p.x() = -p.x();
    for (auto& triangle : object.mesh.triangles) std::swap(triangle[1], triangle[2]);
    return object;
}

ExampleObject with_permuted_faces(ExampleObject object, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    for (std::size_t i = object.mesh.triangles.size(); i-- > 1;) {
        const std::size_t j = random() % (i + 1);
        std::swap(object.mesh.triangles[i], object.mesh.triangles[j]);
        std::swap(object.labels[i], object.labels[j]);
        std::swap(object.parts[i], object.parts[j]);
    }
    return object;
}

ExampleObject subdivided(const ExampleObject& object) {
    ExampleObject fine = object;
    TriangleMesh& mesh = fine.mesh;
    mesh.triangles.clear();
    mesh.input_faces.clear();
    fine.labels.clear();
    fine.parts.clear();
    std::map<std::pair<std::int32_t, std::int32_t>, std::int32_t> middles;
    const auto middle = [&](std::int32_t a, std::int32_t b) {
        const auto [place, added] =
            middles.try_emplace(std::minmax(a, b), static_cast<std::int32_t>(mesh.positions.size()));
        if (added)
            mesh.positions.push_back(
                (mesh.positions[static_cast<std::size_t>(a)] + mesh.positions[static_cast<std::size_t>(b)]) / 2);
        return place->second;
    };
    for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t) {
        const auto [a, b, c] = object.mesh.triangles[t];
        const std::int32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        mesh.triangles.insert(mesh.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        fine.labels.insert(fine.labels.end(), 4, object.labels[t]);
        fine.parts.insert(fine.parts.end(), 4, object.parts[t]);
    }
    mesh.input_face_count = static_cast<std::int32_t>(mesh.triangles.size());
    for (std::int32_t t = 0; t < mesh.input_face_count; ++t) mesh.input_faces.push_back(t);
    return fine;
}

}  // namespace partonomy
