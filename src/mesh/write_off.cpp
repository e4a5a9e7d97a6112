#include "mesh/write_off.h"

#include <fmt/format.h>

#include <iterator>

namespace partonomy {

std::string to_off(const TriangleMesh& mesh) {
    std::string text = fmt::format("OFF\n{} {} 0\n", mesh.positions.size(), mesh.triangles.size());
    text.reserve(text.size() + mesh.positions.size() * 40 + mesh.triangles.size() * 20);
    for (const Vec3& p : mesh.positions) fmt::format_to(std::back_inserter(text), "{} {} {}\n", p.x(), p.y(), p.z());
    for (const auto& [a, b, c] : mesh.triangles) fmt::format_to(std::back_inserter(text), "3 {} {} {}\n", a, b, c);
    return text;
}

}  // namespace partonomy
