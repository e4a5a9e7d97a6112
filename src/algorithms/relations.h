#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "algorithms/upright.h"
#include "knowledge/domain.h"

namespace partonomy {

/// From `low` to `high`, both included.
struct Interval {
    double low, high;
};

/// Where the boxes of some regions lie, and how large the regions are: lower and upper ends of each number. Of one
/// region both ends are the same.
struct Surround {
    Vec3 low_from, low_to, high_from, high_to;  ///< corners of the upright boxes
    Vec3 size_from, size_to;                    ///< logarithms of the sides l0 >= l1 >= l2 of the smallest boxes
};
[[nodiscard]] Surround surround_of(const RegionPlace& place);
void enclose(Surround& one, const Surround& other);

/// One measurement between regions, by the name that core:measure gives it. The first region is the target.
struct RelationMeasure {
    using Regions = std::span<const RegionPlace* const>;
    std::string name;
    std::size_t arity;
    std::string unit;
    std::string description;
    /// nullopt when nothing can tell.
    std::function<std::optional<double>(const Scene&, Regions)> value;
    /// Between which numbers `value` lies for all regions within these surrounds, however roughly; so that most tuples
    /// need not be measured. Both ends infinite: anywhere, or nothing can tell. Empty: the same for all regions.
    std::function<Interval(const Scene&, std::span<const Surround* const>)> range = nullptr;
    bool by_size = false;  ///< the range looks at the sizes of regions, not at where they lie
};
[[nodiscard]] std::span<const RelationMeasure> all_relation_measures();
/// Puts a measure of a new name at the end, as plugins do; before any ontology is compiled.
void add_relation_measure(RelationMeasure measure);
[[nodiscard]] const RelationMeasure* find_relation_measure(const std::string& name);

/// One relation, ready to be asked of many regions. The criteria must outlive it.
class RelationTest {
public:
    explicit RelationTest(std::span<const knowledge::Criterion> criteria);

    /// What surrounds tell of all regions within them: the score of each is 0, 1, or must be measured.
    enum class Prospect { none, open, sure };
    [[nodiscard]] Prospect prospect(const Scene& scene, std::span<const Surround* const> surrounds) const;
    /// As relation_score(); `surrounds` are those of the regions.
    [[nodiscard]] std::optional<double> score(const Scene& scene, RelationMeasure::Regions regions,
                                              std::span<const Surround* const> surrounds) const;
    [[nodiscard]] std::optional<double> score(const Scene& scene, RelationMeasure::Regions regions) const;
    /// Whether the boxes of regions tell nothing of the relation.
    [[nodiscard]] bool looks_at_sizes_only() const;

private:
    struct Part {
        const knowledge::Criterion* criterion;
        std::shared_ptr<const RelationMeasure> measure;  ///< or a combination; null: there is none of that name
    };
    std::vector<Part> parts_;
};

/// T: score in [0, 1] of "these regions are in the relation", the lowest of its trapezoids; >= 0.5 means yes. nullopt
/// when nothing can tell: no criterion, a measure of another number of regions, or one that has no answer for them.
[[nodiscard]] std::optional<double> relation_score(std::span<const knowledge::Criterion> criteria, const Scene& scene,
                                                   RelationMeasure::Regions regions);

/// The trapezoid of "they touch", for an ontology that does not say it itself (core:Connected).
[[nodiscard]] const knowledge::Criterion& touching();

}  // namespace partonomy
