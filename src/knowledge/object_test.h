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
    /// come in, or too many types of parts: then only conclude() can tell. The domain must outlive it.
    [[nodiscard]] static std::optional<ObjectTest> about(const Domain& domain, std::span<const int> goals);
    /// The same with those axioms only that the scope keeps; a concept of objects whose defining axiom is gone holds or
    /// not. `parts`: what objects count then (find_parts). nullopt where that is too much; only for theories without
    /// composite parts.
    [[nodiscard]] static std::optional<ObjectTest> within(const Theory& theory, const Scope& scope, Parts parts,
                                                          std::span<const int> goals);

    /// An empty set (a contradiction) tells nothing about its region.
    [[nodiscard]] Types types_of(const ConfigurationSet& region) const;
    /// Of objects that consist of these regions, and of any others unless `complete`.
    [[nodiscard]] Outcome ask(std::vector<Types> regions, bool complete) const;
    /// Whether every object that is one goal is the other, too.
    [[nodiscard]] bool is_below(int sub, int super) const;

private:
    ObjectTest(const Theory& theory, const Scope& scope, Parts parts, std::span<const int> goals);
    /// What one more part adds to the count of one class.
    struct Step {
        Counts mask, full, one;
    };
    enum class Judgement : std::uint8_t { none, impossible, goal, other };
    /// What is known of a vector of counts.
    struct Slot {
        Counts counts;
        std::uint32_t met = 0;  ///< in which step last
        Judgement judged = Judgement::none;
    };
    [[nodiscard]] Slot& slot_of(Counts counts) const;
    [[nodiscard]] bool is_new(Counts counts) const;  ///< to this step
    [[nodiscard]] static Counts add(Counts counts, const std::vector<Step>& steps);
    [[nodiscard]] bool holds(FormulaId formula, Counts counts) const;
    [[nodiscard]] bool is_member(int concept_id, Counts counts) const;
    [[nodiscard]] Outcome judge(Counts counts) const;
    [[nodiscard]] bool is_possible(Counts counts) const;
    /// Tries some of the choices of a type for each region; true when one of them leads to no goal.
    [[nodiscard]] bool finds_other(std::span<const Types> regions, Counts counts, int& tries) const;
    /// Adds a part of one of `types` to each of `reached_`; false when that changes nothing.
    bool add_part(Types types) const;
    /// Adds any number of parts, fewer first, as long as `go_on` says so of what was reached.
    template <typename GoOn>
    void add_parts(const GoOn& go_on) const;

    const Theory* theory_;
    std::vector<int> goals_;
    std::vector<FormulaId> constraints_;    ///< of objects
    std::vector<FormulaId> definitions_;    ///< by concept; -1: free
    std::vector<unsigned> free_bits_;       ///< by concept: its bit of `free_`
    unsigned free_count_ = 0;               ///< concepts of objects that hold or not
    mutable unsigned free_ = 0;             ///< which of them do, just now
    Parts parts_;                           ///< that the goals and the constraints count
    std::vector<std::vector<Step>> steps_;  ///< by type: what one more part adds
    mutable std::vector<Slot> slots_;       ///< a hash table
    mutable std::size_t known_ = 0;         ///< slots that are taken
    mutable std::uint32_t step_ = 0;
    mutable std::vector<Counts> reached_, next_;
};

}  // namespace partonomy::knowledge
