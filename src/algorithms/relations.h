#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>

#include "algorithms/object.h"
#include "knowledge/domain.h"

namespace partonomy {

/// Axes as rows: the sides of the smallest upright box of the object, then up. They turn with the object.
[[nodiscard]] Eigen::Matrix3d upright_frame(const Object& object);

/// What relations look at in one region: T and TF read it, so it is made once.
struct RegionPlace {
    const PartRegion* part = nullptr;  ///< must outlive this
    Eigen::Matrix3d frame;             ///< of its coordinates
    Vec3 low, high;                    ///< box along the frame's axes; the third coordinate is along up
    Vec3 centre;                       ///< mean of the surface, in the same coordinates
};
/// `frame` is upright_frame(object).
[[nodiscard]] RegionPlace place_of(const Object& object, const PartRegion& part, const Eigen::Matrix3d& frame);

/// One measurement between regions, by the name that core:measure gives it. The first region is the target.
struct RelationMeasure {
    const char* name;
    std::size_t arity;
    const char* unit;
    const char* description;
    double (*value)(const Object&, std::span<const RegionPlace* const>);
};
[[nodiscard]] std::span<const RelationMeasure> all_relation_measures();
[[nodiscard]] const RelationMeasure* find_relation_measure(const std::string& name);

/// T: score in [0, 1] of "these regions are in the relation", the lowest of its trapezoids; >= 0.5 means yes. nullopt
/// when nothing can tell: no criterion, or a measure of another number of regions.
[[nodiscard]] std::optional<double> relation_score(std::span<const knowledge::Criterion> criteria, const Object& object,
                                                   std::span<const RegionPlace* const> regions);

/// The trapezoid of "they touch", for an ontology that does not say it itself (core:Connected).
[[nodiscard]] const knowledge::Criterion& touching();

}  // namespace partonomy
