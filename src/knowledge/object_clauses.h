#pragma once

#include <algorithm>
#include <map>
#include <utility>
#include <vector>

#include "knowledge/clauses.h"
#include "knowledge/explain.h"
#include "knowledge/theory.h"

namespace partonomy::knowledge {

/// One object and its parts as clauses, in which every axiom can be switched off. Models are objects: each part has a
/// value of every feature that was asked for, the object counts its parts, and what an axiom says holds when its
/// selector is true. Needs no list of configurations, so the size of a layer does not matter.
///
/// First add the parts, then ask for literals; constraints come last or in between. All throw nothing.
class ObjectClauses {
public:
    /// With `switchable` false every axiom holds, and no selectors are made.
    explicit ObjectClauses(const Theory& theory, bool switchable = true);

    /// A part that is there; its number.
    std::size_t add_region();
    /// Parts that may be there or not; earlier ones first.
    void add_further_parts(std::size_t count);
    [[nodiscard]] std::size_t part_count() const { return parts_.size(); }
    /// Two known parts touch; those of which nobody says so do not. Whether further parts touch each other is open.
    void touch(std::size_t a, std::size_t b) { touching_[std::minmax(a, b)] = clauses.always(); }

    /// True when the feature of the part has this value (one up to this value).
    [[nodiscard]] int value(std::size_t part, std::size_t feature, ValueId value);
    [[nodiscard]] int up_to(std::size_t part, std::size_t feature, ValueId value);
    /// Whether the part, or the object, is a member of the concept.
    [[nodiscard]] int region_concept(std::size_t part, int id);
    [[nodiscard]] int object_concept(int id);
    /// Whether some composite part is a member of the concept.
    [[nodiscard]] int some_composite(int id);
    /// Composite parts go by their group and their first region. Whether there is that one, has this region, has that
    /// one of another group.
    [[nodiscard]] int composite(std::size_t group, std::size_t first);
    [[nodiscard]] int composite_has(std::size_t group, std::size_t first, std::size_t region);
    [[nodiscard]] int composite_has(std::size_t group, std::size_t first, std::size_t inner_group,
                                    std::size_t inner_first);
    /// Whether there is a composite part of just these regions (ascending).
    [[nodiscard]] int composite(std::size_t group, const std::vector<std::size_t>& regions);
    /// The same, and it is a member of the concept.
    [[nodiscard]] int composite_concept(std::size_t group, const std::vector<std::size_t>& regions, int id);
    /// True when none of the further parts is there.
    [[nodiscard]] int no_further_parts();

    /// Adds the constraints of regions for each part that is there, those of composite parts, or those of objects.
    void require_constraints(Level level);

    /// The literal that switches an axiom on: 0 when nothing that was asked for rests on it.
    [[nodiscard]] int selector(std::size_t axiom) const;
    /// Axioms that have a selector, ascending.
    [[nodiscard]] std::vector<std::size_t> axioms() const;

    Clauses clauses;

private:
    /// The literals of one part, of a composite part, or of the object.
    struct Member {
        int group = -1;                          ///< of a composite part
        std::size_t first = 0;                   ///< of a composite part: its first region
        bool is_grown = false;                   ///< it may have further parts beside the known ones
        int present = 0;                         ///< literal
        std::vector<std::vector<int>> features;  ///< [feature][value], empty until asked for
        std::vector<int> concepts, formulas;     ///< 0 until asked for
    };
    /// The composite parts of one group. Each goes by its first region: there are as many as regions, most of which
    /// are never there.
    struct Composites {
        std::vector<Member> members;
        std::vector<Member>
            grown;  ///< the same for known regions, of groups of regions alone, when there may be others
        std::vector<std::vector<int>> holds;  ///< [first region][region]: this composite part has it
    };
    [[nodiscard]] Composites& composites(std::size_t group);
    /// How many of the parts make composite parts: all of them, or only the known ones where there are too many.
    [[nodiscard]] std::size_t region_count() const;
    [[nodiscard]] int touching(std::size_t a, std::size_t b);
    /// Whether a composite part lies within the object, or within another composite part.
    [[nodiscard]] int lies_within(const Member& whole, const Composites& inner, const Member& part);
    [[nodiscard]] int region_count_in(const Member& whole, const Formula& formula);
    [[nodiscard]] int composite_count(const Member& whole, const Formula& formula);
    [[nodiscard]] int grown_count(const Member& whole, const Formula& formula);
    [[nodiscard]] Member make_member(int present) const;
    [[nodiscard]] const std::vector<int>& feature(Member& member, std::size_t feature);
    [[nodiscard]] int concept_literal(Member& member, int id);
    [[nodiscard]] int literal(Member& member, FormulaId id);
    [[nodiscard]] int make(Member& member, FormulaId id);
    /// The selector of an axiom as a premise: nothing when every axiom holds.
    [[nodiscard]] std::vector<int> unless_off(std::size_t axiom);

    const Theory& theory_;
    bool switchable_;
    std::vector<Member> parts_;
    std::size_t known_ = 0;
    Member object_;
    std::vector<Composites> composites_;                           ///< by group; empty until asked for
    std::map<std::pair<std::size_t, std::size_t>, int> touching_;  ///< by regions, the lower first
    std::map<std::size_t, int> selectors_;
};

/// How many further parts can make a difference to whether an object can be none of `goals` (concepts) within the
/// constraints: enough to witness each "at least k" that helps.
[[nodiscard]] std::size_t parts_that_help(const Theory& theory, const std::vector<int>& goals);

/// The same when it, or a composite part, is to be a member of `goal`.
[[nodiscard]] std::size_t parts_for(const Theory& theory, int goal);

}  // namespace partonomy::knowledge
