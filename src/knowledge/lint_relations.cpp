/* What is wrong with relations between regions.

   Names wait for each other when each is defined by a relation to the other: what a name awaits is closed under what
   those names await, and a name that awaits itself is in a circle. A relation that says twice what the part itself is
   says nothing of what it lies to; one that names no other side at all may mean that. */

#include "knowledge/lint_relations.h"

#include <algorithm>
#include <map>
#include <set>

#include "knowledge/assembly.h"
#include "knowledge/relations.h"
#include "knowledge/theory.h"

namespace partonomy::knowledge {
namespace {

class RelationLinter {
public:
    RelationLinter(const Domain& domain, const std::function<owl::Source(const Iri&)>& place_of)
        : domain_(domain), theory_(domain.grounding->theory), place_of_(place_of) {}

    std::vector<Finding> run() {
        look_at_silent_relations();
        look_at_waiting_names();
        look_at_sides();
        return std::move(findings_);
    }

private:
    void add(FindingKind kind, std::vector<Iri> concepts, owl::Source where, std::string what, std::string advice,
             bool is_wrong = true) {
        findings_.push_back(
            {kind, is_wrong, std::move(concepts), std::move(where), std::move(what), std::move(advice), {}});
    }

    /// Relations that no algorithm tells.
    void look_at_silent_relations() {
        for (const Variable& variable : domain_.regions.variables) {
            if (variable.kind != VariableKind::relation || variable.answerable) continue;
            std::vector<Iri> silent;
            const NodeTest& test = domain_.relational[static_cast<std::size_t>(variable.index)].test;
            for (std::size_t r = 0; r < domain_.relations.size(); ++r)
                if (domain_.relations[r].criteria.empty() && may_pass(test, domain_.relations, r))
                    silent.push_back(domain_.relations[r].iri);
            add(FindingKind::unanswerable, silent, place_of_(silent.front()),
                list_of(local_names(silent)) + (silent.size() == 1 ? " has" : " have") +
                    " no core:criterion, so no algorithm answers \"" + to_manchester(*variable.part_class) +
                    "\" and it stays open",
                "give it a measure between regions of partonomy catalogue and a trapezoid");
        }
    }

    /// What a definition speaks of: relations to others, and names; and what those names speak of that are defined.
    struct Rests {
        std::set<int> names, relations;
    };
    void collect(FormulaId id, Rests& rests) const {
        const Formula& formula = theory_.formulas[id];
        for (const FormulaId operand : formula.operands) collect(operand, rests);
        const int relation = formula.index - static_cast<int>(theory_.ranges.size() + theory_.numbers.size());
        if (formula.kind == Formula::Kind::choice && relation >= 0) rests.relations.insert(relation);
        if (formula.kind != Formula::Kind::named || !rests.names.insert(formula.index).second) return;
        if (const FormulaId definition = theory_.concepts[formula.index].definition; definition >= 0)
            collect(definition, rests);
    }

    /// Names each of which is defined by a relation to one that waits for it.
    void look_at_waiting_names() {
        if (theory_.relational.empty()) return;
        const std::size_t count = theory_.concepts.size();
        std::vector<Rests> own(count);
        std::vector<std::set<int>> awaited(
            count);  // names that a relation in the definition speaks of, then all theirs
        for (std::size_t c = 0; c < count; ++c) {
            const NamedConcept& named = theory_.concepts[c];
            if (named.level != Level::region || named.definition < 0) continue;
            collect(named.definition, own[c]);
            for (const int relation : own[c].relations)
                for (const FormulaId each : theory_.relational_classes[relation]) {
                    Rests others;
                    collect(each, others);
                    awaited[c].insert(others.names.begin(), others.names.end());
                }
        }
        for (bool grown = true; grown;) {
            grown = false;
            for (std::set<int>& each : awaited) {
                const std::size_t before = each.size();
                for (const int other : std::set<int>(each)) each.insert(awaited[other].begin(), awaited[other].end());
                grown |= each.size() > before;
            }
        }
        std::set<int> told;
        for (int c = 0; c < static_cast<int>(count); ++c) {
            if (!awaited[c].contains(c) || told.contains(c)) continue;
            std::vector<Iri> circle;
            std::string places;
            for (const int other : awaited[c])
                if (awaited[other].contains(c) && told.insert(other).second) {
                    circle.push_back(theory_.concepts[other].iri);
                    const owl::Source place = place_of_(circle.back());
                    places += (places.empty() ? "" : ", ") + owl::local_name(circle.back()) + " in line " +
                              std::to_string(place.line);
                }
            const bool is_alone = circle.size() == 1;
            add(FindingKind::unanswerable, circle, place_of_(circle.front()),
                list_of(local_names(circle)) + (is_alone ? " waits for itself (" : " wait for each other (") + places +
                    "): " + (is_alone ? "it is" : "each is") + " known by a relation to " +
                    (is_alone ? "itself" : "the other") + ", so what hangs on it stays open",
                "let one of them be known without it, and put the relation into a name of its own, such as "
                "Attached" +
                    owl::local_name(circle.back()));
        }
    }

    /// Whether a test of a relation speaks of the side on which the part itself is: what it says is said of the part.
    [[nodiscard]] bool speaks_of_own_side(const NodeTest& test, const RelationalFeature& feature) const {
        if (feature.of_target) {
            if (test.kind == NodeTest::Kind::target) return true;
        } else if (test.kind == NodeTest::Kind::references) {
            for (std::size_t r = 0; r < domain_.relations.size(); ++r)
                if (domain_.relations[r].arity > 2 && may_pass(feature.test, domain_.relations, r)) return false;
            return true;
        }
        return std::ranges::any_of(test.operands,
                                   [&](const NodeTest& operand) { return speaks_of_own_side(operand, feature); });
    }

    static bool speaks_of_a_side(const NodeTest& test) {
        return test.kind == NodeTest::Kind::target || test.kind == NodeTest::Kind::references ||
               std::ranges::any_of(test.operands, speaks_of_a_side);
    }

    /// Relations that a formula speaks of outside of names, and whether it asks for any of them to hold.
    void collect_sides(FormulaId id, bool holds, std::map<int, bool>& relations) const {
        const Formula& formula = theory_.formulas[id];
        for (const FormulaId operand : formula.operands)
            collect_sides(operand, holds != (formula.kind == Formula::Kind::negation), relations);
        if (formula.kind == Formula::Kind::parts) collect_sides(formula.index, holds, relations);
        const int relation = formula.index - static_cast<int>(theory_.ranges.size() + theory_.numbers.size());
        if (formula.kind != Formula::Kind::choice || relation < 0) return;
        relations[relation] |= holds == formula.values.has(0);
        for (const FormulaId other : theory_.relational_classes[relation]) collect_sides(other, true, relations);
    }

    /// Relations whose other side is never named: "isTargetRegion some (LongerThan and inverse isTargetRegion some
    /// Leg)", "isTargetRegion some Connected". That nothing is connected, or three parts are, may well be meant.
    void look_at_sides() {
        if (theory_.relational.empty()) return;
        for (const NamedConcept& named : theory_.concepts) {
            if (named.open || named.definition < 0 || named.iri.starts_with(owl::core_prefix)) continue;
            std::map<int, bool> relations;
            collect_sides(named.definition, true, relations);
            for (const auto& [relation, holds] : relations) {
                const RelationalFeature& feature = theory_.relational[relation];
                const std::string side = feature.of_target ? "isTargetRegion" : "isReferenceRegion";
                const std::string other = feature.of_target ? "isReferenceRegion" : "isTargetRegion";
                const std::string written = "in \"" + to_manchester(*feature.as_written) + "\" ";
                if (speaks_of_own_side(feature.test, feature))
                    add(FindingKind::own_side, {named.iri}, place_of_(named.iri),
                        written + "inverse (" + side +
                            ") is the part itself once more, so nothing is said of what it lies to",
                        "write inverse (" + other +
                            ") for the other side, and what the part itself is outside of the relation");
                else if (holds && feature.threshold == 1 && !speaks_of_a_side(feature.test))
                    add(FindingKind::own_side, {named.iri}, place_of_(named.iri),
                        written + "the other side is not named, so any part whatever will do",
                        "name it by and (inverse (" + other + ") some …) if that is not meant", false);
            }
        }
    }

    const Domain& domain_;
    const Theory& theory_;
    const std::function<owl::Source(const Iri&)>& place_of_;
    std::vector<Finding> findings_;
};

}  // namespace

std::vector<Finding> lint_relations(const Domain& domain, const std::function<owl::Source(const Iri&)>& place_of) {
    return RelationLinter(domain, place_of).run();
}

std::string list_of(const std::vector<std::string>& names, std::size_t most, const std::string& last) {
    std::string text;
    const std::size_t shown = names.size() > most + 1 ? most : names.size();
    for (std::size_t i = 0; i < shown; ++i) text += (i == 0 ? "" : i + 1 == names.size() ? last : ", ") + names[i];
    if (shown < names.size()) text += " and " + std::to_string(names.size() - shown) + " more";
    return text;
}

std::vector<std::string> local_names(const std::vector<Iri>& iris) {
    std::vector<std::string> names;
    for (const Iri& iri : iris) names.push_back(owl::local_name(iri));
    return names;
}

}  // namespace partonomy::knowledge
