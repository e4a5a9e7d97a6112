/* One question about an object, many times over.

   To explain or to mend, the same question is put with answers taken away or turned round: is there still an object
   that is no such thing? Of all that objects count, only what the question rests on matters (its cone): part classes
   beyond it are forgotten, those that remain are counted to the thresholds that remain, and types of parts that differ
   in nothing else become one. A few dozen vectors of counts are left of thousands; each is judged once, by walking
   the formulas, and remembered. Mostly there is such an object, and one of the first few ways to choose a type for each
   open region is one; only when a hundred of them are not, all vectors are reached, one region after the other. Cost
   then: (vectors reached) x (types) for each region that is open, and next to nothing for one that is sure. */

#include "knowledge/object_test.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <utility>

namespace partonomy::knowledge {
namespace {

constexpr std::size_t most_types = 63;    // a bit for each
constexpr unsigned most_free = 8;         // concepts without definition: each doubles what is to be judged
constexpr Counts no_counts = ~Counts{0};  // no count is as high as that in all classes
constexpr std::size_t slots_in_the_beginning = 256;
constexpr int most_tries = 100;

/// The `parts` formulas that the goals and the constraints of objects rest on; nullopt when what is needed to judge
/// them is more than part counts.
class Cone {
public:
    explicit Cone(const Theory& theory) : theory_(theory), seen_(theory.concepts.size(), 0) {}

    void look_at_concept(int id) {
        const auto at = static_cast<std::size_t>(id);
        if (seen_[at]) return;
        seen_[at] = 1;
        if (theory_.concepts[at].definition < 0)
            is_plain = false;
        else
            look_at(theory_.concepts[at].definition);
    }
    void look_at(FormulaId id) {
        const Formula& formula = theory_.formulas[static_cast<std::size_t>(id)];
        if (formula.kind == Formula::Kind::parts) atoms.push_back(id);
        if (formula.kind == Formula::Kind::named) look_at_concept(formula.index);
        for (const FormulaId operand : formula.operands) look_at(operand);
    }

    std::vector<FormulaId> atoms;
    bool is_plain = true;

private:
    const Theory& theory_;
    std::vector<char> seen_;
};

/// What is left of `whole` when only some of its atoms are looked at.
Parts restricted(const Parts& whole, const std::vector<FormulaId>& formulas) {
    constexpr auto none = std::numeric_limits<std::size_t>::max();
    Parts parts;
    parts.atom_of.assign(whole.atom_of.size(), -1);
    std::vector<std::size_t> class_of(whole.classes.size(), none);
    std::vector<int> atom_of(whole.atoms.size(), -1);
    for (const FormulaId id : formulas) {
        const int old = whole.atom_of[static_cast<std::size_t>(id)];
        if (old < 0) continue;
        int& atom = atom_of[static_cast<std::size_t>(old)];
        if (atom < 0) {
            Parts::Atom copy = whole.atoms[static_cast<std::size_t>(old)];
            std::size_t& part = class_of[copy.part];
            if (part == none) {
                part = parts.classes.size();
                parts.classes.push_back({{}, {}, 0, 0});
            }
            copy.part = part;
            parts.classes[part].cap = std::max(parts.classes[part].cap, copy.threshold);
            atom = static_cast<int>(parts.atoms.size());
            parts.atoms.push_back(std::move(copy));
        }
        parts.atom_of[static_cast<std::size_t>(id)] = atom;
    }
    unsigned shift = 0;
    for (Parts::PartClass& part : parts.classes) {
        part.shift = shift;
        shift += static_cast<unsigned>(std::bit_width(part.cap));
    }
    for (const Parts::Type& type : whole.types) {
        std::vector<std::size_t> classes;
        for (const std::size_t c : type.classes)
            if (class_of[c] != none) classes.push_back(class_of[c]);
        std::ranges::sort(classes);
        const auto same = std::ranges::find(parts.types, classes, &Parts::Type::classes);
        if (same == parts.types.end())
            parts.types.push_back({std::move(classes), type.where});
        else
            same->where |= type.where;
    }
    return parts;
}

}  // namespace

std::optional<ObjectTest> ObjectTest::about(const Domain& domain, std::span<const int> goals) {
    const Grounding& grounding = *domain.grounding;
    if (domain.regions.diagram || grounding.assembly.has_composites()) return std::nullopt;
    Cone cone(grounding.theory);
    for (const int goal : goals) cone.look_at_concept(goal);
    for (const Constraint& constraint : grounding.theory.constraints)
        if (constraint.level == Level::object) cone.look_at(constraint.formula);
    if (!cone.is_plain) return std::nullopt;
    Parts parts = restricted(grounding.assembly.parts, cone.atoms);
    if (parts.types.size() > most_types) return std::nullopt;
    return ObjectTest(grounding.theory, grounding.scope, std::move(parts), goals);
}

std::optional<ObjectTest> ObjectTest::within(const Theory& theory, const Scope& scope, Parts parts,
                                             std::span<const int> goals) {
    if (!parts.fits || parts.types.size() > most_types) return std::nullopt;
    ObjectTest test(theory, scope, std::move(parts), goals);
    for (std::size_t id = 0; id < theory.concepts.size(); ++id)
        if (theory.concepts[id].level == Level::object && scope.concepts[id] && test.definitions_[id] < 0)
            test.free_bits_[id] = test.free_count_++;
    if (test.free_count_ > most_free) return std::nullopt;
    return test;
}

ObjectTest::ObjectTest(const Theory& theory, const Scope& scope, Parts parts, std::span<const int> goals)
    : theory_(&theory),
      goals_(goals.begin(), goals.end()),
      free_bits_(theory.concepts.size(), 0),
      parts_(std::move(parts)),
      slots_(slots_in_the_beginning, {no_counts}) {
    for (const Constraint& constraint : theory.constraints)
        if (constraint.level == Level::object && scope.axioms[constraint.axiom])
            constraints_.push_back(constraint.formula);
    for (const NamedConcept& named : theory.concepts)
        definitions_.push_back(named.definition >= 0 && scope.axioms[named.axiom] ? named.definition : -1);
    for (const Parts::Type& type : parts_.types) {
        std::vector<Step>& steps = steps_.emplace_back();
        for (const std::size_t c : type.classes) {
            const Parts::PartClass& part = parts_.classes[c];
            const Counts mask = (Counts{1} << std::bit_width(part.cap)) - 1;
            steps.push_back({mask << part.shift, Counts{part.cap} << part.shift, Counts{1} << part.shift});
        }
    }
}

ObjectTest::Types ObjectTest::types_of(const ConfigurationSet& region) const {
    Types types = 0;
    const bool is_any = region.is_empty();
    for (std::size_t t = 0; t < parts_.types.size(); ++t)
        if (is_any || parts_.types[t].where.intersects(region)) types |= Types{1} << t;
    return types;
}

bool ObjectTest::is_member(int concept_id, Counts counts) const {
    const auto at = static_cast<std::size_t>(concept_id);
    if (definitions_[at] < 0) return (free_ >> free_bits_[at] & 1U) != 0;
    return holds(definitions_[at], counts);
}

bool ObjectTest::holds(FormulaId id, Counts counts) const {
    const Formula& formula = theory_->formulas[static_cast<std::size_t>(id)];
    const auto holds_here = [&](FormulaId operand) { return holds(operand, counts); };
    switch (formula.kind) {
        case Formula::Kind::truth:
            return true;
        case Formula::Kind::conjunction:
            return std::ranges::all_of(formula.operands, holds_here);
        case Formula::Kind::disjunction:
            return std::ranges::any_of(formula.operands, holds_here);
        case Formula::Kind::negation:
            return !holds_here(formula.operands[0]);
        case Formula::Kind::named:
            return is_member(formula.index, counts);
        case Formula::Kind::parts: {
            const int atom = parts_.atom_of[static_cast<std::size_t>(id)];
            return atom >= 0 && parts_.holds(counts, parts_.atoms[static_cast<std::size_t>(atom)]);
        }
        case Formula::Kind::falsity:
        case Formula::Kind::choice:
            break;
    }
    return false;
}

bool ObjectTest::is_possible(Counts counts) const {
    return std::ranges::all_of(constraints_, [&](FormulaId constraint) { return holds(constraint, counts); });
}

ObjectTest::Outcome ObjectTest::judge(Counts counts) const {
    Judgement& judged = slot_of(counts).judged;
    if (judged == Judgement::none) {
        judged = Judgement::impossible;
        for (free_ = 0; free_ < 1U << free_count_ && judged != Judgement::other; ++free_) {
            if (!is_possible(counts)) continue;
            const bool is_goal = std::ranges::any_of(goals_, [&](int goal) { return is_member(goal, counts); });
            judged = is_goal ? Judgement::goal : Judgement::other;
        }
    }
    return {judged != Judgement::impossible, judged == Judgement::other};
}

Counts ObjectTest::add(Counts counts, const std::vector<Step>& steps) {
    Counts more = counts;
    for (const Step& step : steps)
        if ((counts & step.mask) != step.full) more += step.one;
    return more;
}

ObjectTest::Slot& ObjectTest::slot_of(Counts counts) const {
    const auto place = [&](Counts each) -> Slot& {
        const int shift = 64 - std::countr_zero(slots_.size());
        auto at = static_cast<std::size_t>(each * 0x9E3779B97F4A7C15U >> shift);
        while (slots_[at].counts != each && slots_[at].counts != no_counts) at = (at + 1) % slots_.size();
        return slots_[at];
    };
    if (2 * known_ > slots_.size()) {
        const std::vector<Slot> old = std::exchange(slots_, std::vector<Slot>(2 * slots_.size(), Slot{no_counts}));
        for (const Slot& slot : old)
            if (slot.counts != no_counts) place(slot.counts) = slot;
    }
    Slot& slot = place(counts);
    if (slot.counts == no_counts) {
        slot.counts = counts;
        ++known_;
    }
    return slot;
}

bool ObjectTest::is_new(Counts counts) const { return std::exchange(slot_of(counts).met, step_) != step_; }

bool ObjectTest::add_part(Types types) const {
    ++step_;
    next_.clear();
    for (; types != 0; types &= types - 1) {
        const std::vector<Step>& steps = steps_[static_cast<std::size_t>(std::countr_zero(types))];
        for (const Counts each : reached_) {
            const Counts more = add(each, steps);
            if (is_new(more)) next_.push_back(more);
        }
    }
    const bool is_more = next_.size() != reached_.size() ||
                         std::ranges::any_of(reached_, [&](Counts each) { return slot_of(each).met != step_; });
    std::swap(reached_, next_);
    return is_more;
}

template <typename GoOn>
void ObjectTest::add_parts(const GoOn& go_on) const {
    ++step_;
    for (const Counts each : reached_) static_cast<void>(is_new(each));
    for (std::size_t next = 0; next < reached_.size() && go_on(reached_[next]); ++next)
        for (const std::vector<Step>& steps : steps_)
            if (const Counts more = add(reached_[next], steps); is_new(more)) reached_.push_back(more);
}

bool ObjectTest::is_below(int sub, int super) const {
    bool result = true;
    reached_.assign(1, 0);
    add_parts([&](Counts counts) {
        return result = !is_member(sub, counts) || is_member(super, counts) || !is_possible(counts);
    });
    return result;
}

bool ObjectTest::finds_other(std::span<const Types> regions, Counts counts, int& tries) const {
    if (regions.empty()) {
        --tries;
        return judge(counts).other;
    }
    for (Types types = regions.front(); types != 0 && tries > 0; types &= types - 1)
        if (finds_other(regions.subspan(1), add(counts, steps_[static_cast<std::size_t>(std::countr_zero(types))]),
                        tries))
            return true;
    return false;
}

ObjectTest::Outcome ObjectTest::ask(std::vector<Types> regions, bool complete) const {
    std::ranges::sort(regions, [](Types a, Types b) {  // the sure ones keep the set small
        const int a_count = std::popcount(a), b_count = std::popcount(b);
        return a_count != b_count ? a_count < b_count : a < b;
    });
    std::size_t next = 0;
    Counts sure = 0;
    for (; next < regions.size() && std::has_single_bit(regions[next]); ++next)
        sure = add(sure, steps_[static_cast<std::size_t>(std::countr_zero(regions[next]))]);
    if (int tries = most_tries; finds_other(std::span(regions).subspan(next), sure, tries)) return {true, true};
    reached_.assign(1, sure);
    for (; next < regions.size(); ++next)
        if (!add_part(regions[next]))  // nor would another such part change anything
            while (next + 1 < regions.size() && regions[next + 1] == regions[next]) ++next;
    Outcome outcome;
    const auto look_at = [&](Counts counts) {
        const Outcome one = judge(counts);
        outcome.any |= one.any;
        outcome.other |= one.other;
        return !outcome.other;
    };
    if (complete)
        static_cast<void>(std::ranges::all_of(reached_, look_at));
    else
        add_parts(look_at);
    return outcome;
}

}  // namespace partonomy::knowledge
