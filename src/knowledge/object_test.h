#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "knowledge/assembly.h"

namespace partonomy::knowledge {

/// What objects may be, asked again and again while what is known of their regions changes: without a list of the
/// object's configurations, from the counts that the regions reach. It remembers what it has found out, so threads do
/// not share one.
class ObjectTest {
public:
    using Types = std::uint64_t;  ///< the types of parts that a region may still be of, a bit for each
    struct Outcome {
        bool any = false;    ///< there is an object that obeys the axioms
        bool other = false;  ///< ... and is none of the goals
    };

    /// About some concepts of objects (of the theory). nullopt where concepts without definition or composite parts
    /// come in, or too many counts: then only conclude() can tell. The domain must outlive it.
    [[nodiscard]] static std::optional<ObjectTest> about(const Domain& domain, std::span<const int> goals);

    /// An empty set (a contradiction) tells nothing about its region.
    [[nodiscard]] Types types_of(const ConfigurationSet& region) const;
    /// Of objects that consist of these regions, and of any others unless `complete`.
    [[nodiscard]] Outcome ask(std::vector<Types> regions, bool complete) const;

private:
    ObjectTest(const Domain& domain, std::span<const int> goals);
    [[nodiscard]] bool holds(FormulaId formula, Counts counts) const;
    [[nodiscard]] bool is_member(int concept_id, Counts counts) const;
    [[nodiscard]] Outcome judge(Counts counts) const;
    /// Adds a part of one of `types` to each of `reached_`; false when that changes nothing.
    bool add_part(Types types) const;

    enum class Judgement : std::uint8_t { none, impossible, goal, other };

    const Theory* theory_;
    std::vector<int> goals_;
    Parts parts_;  ///< that the goals and the constraints count
    struct Step {
        Counts mask, full, one;
    };
    std::vector<std::vector<Step>> steps_;    ///< by type: what one more part adds
    mutable std::vector<Judgement> judged_;   ///< by counts
    mutable std::vector<std::uint32_t> met_;  ///< by counts: in which step last
    mutable std::uint32_t step_ = 0;
    mutable std::vector<Counts> reached_, next_;
};

}  // namespace partonomy::knowledge
