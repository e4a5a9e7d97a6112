#pragma once

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "examples/objects.h"

namespace partonomy {

/// Puts a polyhedron together face by face; every face belongs to a part.
class Solid {
public:
    using Vertex = std::int32_t;

    /// The vertex at a place; asking twice for one place gives one vertex.
    Vertex at(double x, double y, double z);
    Vertex at(const Vec3& p) { return at(p.x(), p.y(), p.z()); }
    [[nodiscard]] const Vec3& position(Vertex v) const { return object_.mesh.positions[static_cast<std::size_t>(v)]; }

    /// Faces from now on belong to a new part.
    void begin_part(const std::string& label);
    /// A polygon, counter-clockwise from outside, or from inside when `reversed`.
    void face(std::vector<Vertex> corners, bool reversed = false);
    /// A level polygon, counter-clockwise from above, with holes in it, each counter-clockwise from above, too. It
    /// faces up, or down when `reversed`. Holes may not touch each other or the border.
    void face_with_holes(std::vector<Vertex> border, std::vector<std::vector<Vertex>> holes, bool reversed = false);
    /// The walls and the lid of a prism that stands on `base` (counter-clockwise from above) and ends at height z,
    /// which is above the base, or below it. The base itself stays open: it is where the part joins the next one.
    void prism(const std::vector<Vertex>& base, double z);

    [[nodiscard]] ExampleObject finish(std::string name, std::string object_class, std::string incompatibility = {}) &&;

private:
    ExampleObject object_;
    std::map<std::array<double, 3>, Vertex> places_;
    std::string label_;
};

}  // namespace partonomy
