#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "mesh/read_mesh.h"

namespace partonomy::test {

/// A soup from points and polygons, as the readers give it.
inline PolygonSoup soup_of(std::vector<Vec3> points, const std::vector<std::vector<std::int32_t>>& faces) {
    PolygonSoup soup;
    soup.positions = std::move(points);
    soup.face_starts.push_back(0);
    for (const auto& face : faces) {
        soup.corners.insert(soup.corners.end(), face.begin(), face.end());
        soup.face_starts.push_back(static_cast<std::int64_t>(soup.corners.size()));
    }
    return soup;
}

/// The box [low, high] as 8 points and 6 quads that face outward.
inline PolygonSoup box(const Vec3& low = Vec3(0, 0, 0), const Vec3& high = Vec3(1, 1, 1)) {
    std::vector<Vec3> points;
    for (int i = 0; i < 8; ++i)
        points.emplace_back(i & 1 ? high.x() : low.x(), i & 2 ? high.y() : low.y(), i & 4 ? high.z() : low.z());
    return soup_of(std::move(points),
                   {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

/// The second soup appended to the first, its faces turned over when `reversed`.
inline PolygonSoup joined(PolygonSoup a, const PolygonSoup& b, bool reversed = false) {
    const auto offset = static_cast<std::int32_t>(a.positions.size());
    a.positions.insert(a.positions.end(), b.positions.begin(), b.positions.end());
    for (std::size_t f = 0; f + 1 < b.face_starts.size(); ++f) {
        std::vector<std::int32_t> face(b.corners.begin() + b.face_starts[f], b.corners.begin() + b.face_starts[f + 1]);
        if (reversed) std::reverse(face.begin(), face.end());
        for (const std::int32_t v : face) a.corners.push_back(v + offset);
        a.face_starts.push_back(static_cast<std::int64_t>(a.corners.size()));
    }
    return a;
}

inline TriangleMesh cleaned(const PolygonSoup& soup, MeshReport& report) { return clean_mesh(soup, "test", report); }

/// What `parse_mesh` and `clean_mesh` throw for these bytes; "no error" when they accept them.
inline std::string error_of(const std::string& bytes, const std::string& name = "mesh") {
    try {
        MeshReport report;
        static_cast<void>(clean_mesh(parse_mesh(bytes, name), name, report));
    } catch (const std::exception& error) {
        return error.what();
    }
    return "no error";
}

}  // namespace partonomy::test
