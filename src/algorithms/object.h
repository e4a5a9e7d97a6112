#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "mesh/triangle_mesh.h"
#include "shape/find_parts.h"
#include "shape/patches.h"

namespace partonomy {

struct Appearance;
struct RegionColors;
struct RegionPattern;

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

/// Points spread evenly over a region, on the surface with noise taken out.
struct SurfaceSamples {
    std::vector<Vec3> points, normals;
    std::vector<Vec3> origins;  ///< the same points on the mesh as it is
    bool is_blurred = false;    ///< with the noise its edges and corners were rounded off

    /// Where to look for outlines, which averages keep free of noise: on what still has its edges and corners.
    [[nodiscard]] const std::vector<Vec3>& with_edges() const { return is_blurred ? origins : points; }
};

/// The surface of an object with noise taken out; the triangles are those of the mesh.
struct CalmSurface {
    TriangleMesh mesh;
    TriangleGeometry geometry;
    Adjacency adjacency;
    double noise = 0;         ///< how far it still is from the surface before the noise, about
    bool is_blurred = false;  ///< with the noise its edges and corners were rounded off
};

/// A mesh ready to be asked about.
struct Object {
    TriangleMesh mesh;
    TriangleGeometry geometry;
    Placement placement;
    Vec3 heights = Vec3::UnitZ();          ///< what heights are read along: up, but for scenes on a slope (slope.h)
    double low = 0, high = 0;              ///< extent along it, in file units
    double footprint = 0;                  ///< area of its shadow on the ground, without notches; squared file units
    bool is_scene = false;                 ///< cut as a scene (FindPartsOptions), as knowledge::Domain says
    std::vector<PartRegion> candidates;    ///< box-like regions of find_parts: what every `find all` chooses from
    bool is_noisy = false;                 ///< whether finding them met noise: boxes end at walls, not at points
    StageTimes times;                      ///< of finding them
    std::shared_ptr<const RayTree> tree;   ///< of the mesh
    mutable std::optional<double> length;  ///< of the smallest box around all of it, once a question needed it
    mutable std::optional<double> area;    ///< of its surface, the same
    mutable std::optional<Vec3> sideways;  ///< the same: sideways_of
    mutable std::optional<double> level;   ///< the same: main_level
    mutable std::shared_ptr<const CalmSurface> calm;   ///< once a question needed it: calm_surface
    mutable std::shared_ptr<const CalmSurface> sharp;  ///< the same: surface_of
    std::shared_ptr<const Appearance> appearance;      ///< null: no colours, or nothing asks for them; see paint
};

/// Measures the mesh and cuts it into candidate regions. Needs no ontology but for whether it is about scenes.
/// threads <= 0: all cores.
[[nodiscard]] Object make_object(TriangleMesh mesh, const Placement& placement, int threads = 1, bool is_scene = false);

/// Stands the object with another side up, or measures it in another unit, or after it was found to be a scene; its
/// regions stay as they were cut.
void place(Object& object, const Placement& placement);

/// Cuts the object into candidate regions again, after it was placed otherwise, or was found to be a scene. Up matters
/// in the corners of flush boards.
void cut(Object& object, int threads = 1);

/// What is above and below a region, seen from points spread evenly over its upper side.
struct Surroundings {
    double open_above = 0;  ///< share of the points that nothing of the object is above
    double room_above =
        0;  ///< share of the points that have room above them: a tenth of the object's height, or the sky
    double room_below = 0;  ///< how far down the object is empty below them: 0 filled to the ground, 1 nothing there
};

/// What is measured on one region, once; all questions read from it.
struct RegionMeasurements {
    Vec3 lengths;              ///< l0 >= l1 >= l2 of the box, in file units
    double inclination = 0;    ///< degrees in [0, 90], see docs/elementary-algorithms.md
    double low = 0, high = 0;  ///< extent along up, in file units; a stray hundredth of the area does not count
    double area = 0;           ///< squared file units
    double plan_area = 0;      ///< of the upper side, seen from above; squared file units
    std::span<const std::int32_t> triangles;                    ///< of the region; the object's candidates own them
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();         ///< of the box, as columns
    Vec3 centre = Vec3::Zero();                                 ///< of the box
    mutable std::optional<Surroundings> surroundings;           ///< once a question needed them: look_around
    mutable std::shared_ptr<const SurfaceSamples> samples;      ///< once a question needed them: samples_of
    mutable std::shared_ptr<const RegionColors> colors;         ///< the same: look_at_colors
    mutable std::shared_ptr<const RegionPattern> pattern;       ///< the same: look_at_pattern
    mutable std::shared_ptr<const std::vector<Patch>> patches;  ///< the same: patches_of
    mutable std::map<std::string, double> asked;  ///< values of measures and formulas that are taken on demand
};

/// `part` is one of the object's candidates, and must outlive the result.
[[nodiscard]] RegionMeasurements measure_region(const Object& object, const PartRegion& part);

/// Shoots some rays up and down, the first time that it is called for a region.
[[nodiscard]] const Surroundings& look_around(const Object& object, const RegionMeasurements& region);

}  // namespace partonomy
