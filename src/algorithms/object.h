#pragma once

#include <optional>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "shape/find_parts.h"

namespace partonomy {

/// Up direction and unit of a mesh file, as a user gives them.
struct Placement {
    Vec3 up = Vec3::UnitZ();
    /// Metres per file unit; nullopt when unknown: questions that need metres then stay unanswered.
    std::optional<double> metres_per_unit = 1.0;
};

/// "x", "-x" … "-z" -> unit vector. Throws UsageError for another word.
[[nodiscard]] Vec3 parse_up(const std::string& word);

/// "m", "cm", "mm", "in" -> metres per unit; "auto" -> nullopt. Throws UsageError for another word.
[[nodiscard]] std::optional<double> parse_unit(const std::string& word);

/// A mesh ready to be asked about.
struct Object {
    TriangleMesh mesh;
    TriangleGeometry geometry;
    Placement placement;
    double low = 0, high = 0;            ///< extent along up, in file units
    std::vector<PartRegion> candidates;  ///< box-like regions of find_parts: what every `find all` chooses from
    StageTimes times;                    ///< of finding them
};

/// Measures the mesh and cuts it into candidate regions. Needs no ontology. threads <= 0: all cores.
[[nodiscard]] Object make_object(TriangleMesh mesh, const Placement& placement, int threads = 1);

/// What is measured on one region, once; all questions read from it.
struct RegionMeasurements {
    Vec3 lengths;              ///< l0 >= l1 >= l2 of the box, in file units
    double inclination = 0;    ///< degrees in [0, 90], see docs/elementary-algorithms.md
    double low = 0, high = 0;  ///< extent along up, in file units; a stray hundredth of the area does not count
    double area = 0;           ///< squared file units
};

[[nodiscard]] RegionMeasurements measure_region(const Object& object, const PartRegion& part);

}  // namespace partonomy
