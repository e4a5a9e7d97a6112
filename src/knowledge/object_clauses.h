#pragma once

#include <map>
#include <vector>

#include "knowledge/clauses.h"
#include "knowledge/explain.h"
#include "knowledge/theory.h"

namespace partonomy::knowledge {

/// Whether ObjectClauses knows what the theory speaks of: regions and objects, features and part counts.
[[nodiscard]] bool can_express(const Theory& theory);

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

    /// True when the feature of the part has this value (one up to this value).
    [[nodiscard]] int value(std::size_t part, std::size_t feature, ValueId value);
    [[nodiscard]] int up_to(std::size_t part, std::size_t feature, ValueId value);
    /// Whether the part, or the object, is a member of the concept.
    [[nodiscard]] int region_concept(std::size_t part, int id);
    [[nodiscard]] int object_concept(int id);
    /// True when none of the further parts is there.
    [[nodiscard]] int no_further_parts();

    /// Adds the constraints of regions for each part that is there, and those of objects.
    void require_constraints(Level level);

    /// The literal that switches an axiom on: 0 when nothing that was asked for rests on it.
    [[nodiscard]] int selector(std::size_t axiom) const;
    /// Axioms that have a selector, ascending.
    [[nodiscard]] std::vector<std::size_t> axioms() const;

    Clauses clauses;

private:
    /// The literals of one part, or of the object.
    struct Member {
        int present = 0;                         ///< literal
        std::vector<std::vector<int>> features;  ///< [feature][value], empty until asked for
        std::vector<int> concepts, formulas;     ///< 0 until asked for
    };
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
    std::map<std::size_t, int> selectors_;
};

/// How many further parts can make a difference to whether an object can be none of `goals` (concepts) within the
/// constraints: enough to witness each "at least k" that helps.
[[nodiscard]] std::size_t parts_that_help(const Theory& theory, const std::vector<int>& goals);

/// The same when it is to be a member of `goal`.
[[nodiscard]] std::size_t parts_for(const Theory& theory, int goal);

}  // namespace partonomy::knowledge
