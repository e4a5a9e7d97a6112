#include "knowledge/groups.h"

#include <algorithm>
#include <map>
#include <numeric>

#include "knowledge/choices.h"
#include "knowledge/formula_clauses.h"
#include "knowledge/solver.h"

// Which composite parts there are. A definition such as
//
//     Back EquivalentTo: CompositePart and hasPart exactly 1 Backrest and hasPart max 1 Headrest
//
// tells what to look for: regions that are a Backrest or a Headrest, all that touch one another in one group. So a
// concept's *mentions*, the classes behind its hasPart, say what its groups consist of, whether they are wanted (some),
// limited (max) or optional (min 0). Concepts speak of the same groups when one is told to be below the other (a
// ReclinerBack is a Back), or when they mention the same classes. A concept that mentions nothing of its own
// (Cushioned: Back or SeatPad) is evaluated on whatever groups the others make.
//
// Groups of groups follow from mentions of composite concepts, and the layers from who mentions whom.
//
// What belongs to a group must be known of a region once its features are: a mention that hangs on a restriction which
// is no question (open_restrictions.cpp) is refused, since nobody could ever say which composite parts there are. It
// hangs on one when two things with the same features, of which one belongs, can differ in what is open alone.

namespace partonomy::knowledge {
namespace {

bool are_alike(const Theory& theory, FormulaId a, FormulaId b) {
    if (a == b) return true;
    const Formula &x = theory.formulas[a], &y = theory.formulas[b];
    const bool same_node = x.kind == y.kind && x.threshold == y.threshold && x.part_level == y.part_level &&
                           x.operands.size() == y.operands.size();
    if (!same_node) return false;
    if (x.kind == Formula::Kind::parts) return are_alike(theory, x.index, y.index);
    if (x.index != y.index) return false;
    if (x.kind == Formula::Kind::choice && x.values != y.values) return false;
    for (std::size_t i = 0; i < x.operands.size(); ++i)
        if (!are_alike(theory, x.operands[i], y.operands[i])) return false;
    return true;
}

/// Every mention of `a` is one of `b`.
bool mentions_all(const Theory& theory, const Mentions& a, const Mentions& b) {
    return std::ranges::all_of(a.parts, [&](const auto& x) {
        return std::ranges::any_of(b.parts, [&](const auto& y) { return are_alike(theory, x.first, y.first); });
    });
}

/// Composite concepts that must hold wherever the formula does.
void find_conjuncts(const Theory& theory, FormulaId id, std::vector<int>& found) {
    const Formula& formula = theory.formulas[id];
    if (formula.kind == Formula::Kind::named) found.push_back(formula.index);
    if (formula.kind == Formula::Kind::conjunction)
        for (const FormulaId operand : formula.operands) find_conjuncts(theory, operand, found);
}

/// Concepts that are united when they speak of the same groups.
class Union {
public:
    explicit Union(std::size_t size) : parents_(size) { std::iota(parents_.begin(), parents_.end(), 0); }
    [[nodiscard]] int find(int id) const {
        while (parents_[static_cast<std::size_t>(id)] != id) id = parents_[static_cast<std::size_t>(id)];
        return id;
    }
    void unite(int a, int b) {
        const int x = find(a), y = find(b);
        parents_[static_cast<std::size_t>(std::max(x, y))] = std::min(x, y);
    }

private:
    std::vector<int> parents_;
};

/// Groups that the concepts in a composite formula belong to.
void find_inner(const Theory& theory, FormulaId id, std::vector<char>& seen, std::vector<int>& groups) {
    const Formula& formula = theory.formulas[id];
    for (const FormulaId operand : formula.operands) find_inner(theory, operand, seen, groups);
    if (formula.kind != Formula::Kind::named || seen[static_cast<std::size_t>(formula.index)]) return;
    seen[static_cast<std::size_t>(formula.index)] = 1;
    const NamedConcept& named = theory.concepts[static_cast<std::size_t>(formula.index)];
    if (named.group >= 0)
        groups.push_back(named.group);
    else if (named.definition >= 0)
        find_inner(theory, named.definition, seen, groups);
}

/// A restriction that is no question and on which the formula hangs; null when there is none.
owl::ClassPointer hangs_on(const Theory& theory, FormulaId whole) {
    owl::ClassPointer open;
    Clauses clauses;
    std::map<std::size_t, std::vector<int>> features;
    std::map<int, int> concepts;                          // without definition
    std::map<FormulaId, int> counts;                      // of the parts of a composite part
    std::array<std::map<int, int>, 2> open_in, named_in;  // of either thing
    const auto literal = [&](const auto& self, std::size_t thing, FormulaId id) -> int {
        const auto is_concept = [&](int c) {
            const NamedConcept& named = theory.concepts[static_cast<std::size_t>(c)];
            const auto [known, is_new] = (named.open             ? open_in[thing]
                                          : named.definition < 0 ? concepts
                                                                 : named_in[thing])
                                             .try_emplace(c, 0);
            if (!is_new) return known->second;
            if (named.open && !open) open = named.open;
            const int made = named.definition < 0 ? clauses.add_variable() : self(self, thing, named.definition);
            return known->second = made;
        };
        const auto values = [&](std::size_t feature) -> const std::vector<int>& {
            std::vector<int>& made = features[feature];
            if (made.empty()) made = add_choice(clauses, theory.value_count(feature));
            return made;
        };
        const auto count = [&](const Formula&) {
            int& made = counts[id];
            return made = made == 0 ? clauses.add_variable() : made;
        };
        return formula_literal(
            clauses, theory.formulas[static_cast<std::size_t>(id)],
            [&](FormulaId operand) { return self(self, thing, operand); }, values, is_concept, count);
    };
    clauses.add({literal(literal, 0, whole)});
    if (!open) return nullptr;
    clauses.add({-literal(literal, 1, whole)});
    return Solver(clauses).solve() == Verdict::satisfiable ? open : nullptr;
}

void refuse_open_groups(const Theory& theory, std::span<const Mentions> mentions, const owl::Ontology& ontology) {
    for (std::size_t g = 0; g < theory.groups.size(); ++g)
        for (const FormulaId whole : {theory.groups[g].regions, theory.groups[g].composites}) {
            if (!hangs_on(theory, whole)) continue;
            for (const Mentions& each : mentions) {
                const NamedConcept& named = theory.concepts[static_cast<std::size_t>(each.concept_id)];
                if (named.group != static_cast<int>(g)) continue;
                for (const auto& [formula, level] : each.parts)
                    if (const owl::ClassPointer open = hangs_on(theory, formula))
                        refuse(ontology.axioms[named.axiom],
                               "what belongs to " + with_article(owl::local_name(named.iri)) + " hangs on \"" +
                                   to_manchester(*open) + "\", which no question is about",
                               "name what belongs to it by features, and let a concept below it say the rest");
            }
        }
}

}  // namespace

void find_groups(Theory& theory, Grounder& grounder, std::span<const Mentions> mentions,
                 std::span<const std::pair<int, int>> told, const owl::Ontology& ontology) {
    if (mentions.empty()) return;
    const std::size_t count = theory.concepts.size();
    Union same(count);
    std::vector<char> speaks(count, 0);
    for (const Mentions& each : mentions) speaks[static_cast<std::size_t>(each.concept_id)] = 1;
    for (bool grown = true; grown;) {  // what is a Back, and more, speaks of a Back's groups
        grown = false;
        for (std::size_t id = 0; id < count; ++id) {
            const NamedConcept& named = theory.concepts[id];
            if (named.level != Level::composite || named.definition < 0) continue;
            std::vector<int> conjuncts;
            find_conjuncts(theory, named.definition, conjuncts);
            for (const int other : conjuncts) {
                if (!speaks[static_cast<std::size_t>(other)]) continue;
                grown |= speaks[id] == 0;
                speaks[id] = 1;
                same.unite(static_cast<int>(id), other);
            }
        }
    }
    for (const auto& [sub, super] : told)
        if (speaks[static_cast<std::size_t>(sub)] && speaks[static_cast<std::size_t>(super)]) same.unite(sub, super);
    for (const Mentions& a : mentions)
        for (const Mentions& b : mentions)
            if (mentions_all(theory, a, b) && mentions_all(theory, b, a)) same.unite(a.concept_id, b.concept_id);

    std::vector<int> roots;  // one concept of each kind of group
    for (std::size_t id = 0; id < count; ++id)
        if (speaks[id] && same.find(static_cast<int>(id)) == static_cast<int>(id))
            roots.push_back(static_cast<int>(id));
    for (std::size_t id = 0; id < count; ++id)
        if (speaks[id])
            theory.concepts[id].group =
                static_cast<int>(std::ranges::find(roots, same.find(static_cast<int>(id))) - roots.begin());
    std::vector<Group> groups(roots.size());
    for (std::size_t g = 0; g < groups.size(); ++g) {
        std::vector<FormulaId> regions, composites;
        for (const Mentions& each : mentions)
            if (theory.concepts[static_cast<std::size_t>(each.concept_id)].group == static_cast<int>(g))
                for (const auto& [formula, level] : each.parts)
                    (level == Level::region ? regions : composites).push_back(formula);
        groups[g].regions = grounder.disjoin(std::move(regions));
        groups[g].composites = grounder.disjoin(std::move(composites));
        std::vector<char> seen(count, 0);
        find_inner(theory, groups[g].composites, seen, groups[g].inner);
    }

    // Each after those that it is made of.
    std::vector<int> order, path;
    std::vector<char> done(groups.size(), 0);
    const auto visit = [&](const auto& self, int g) -> void {
        const auto at = static_cast<std::size_t>(g);
        if (std::ranges::find(path, g) != path.end()) {
            const NamedConcept& named = theory.concepts[static_cast<std::size_t>(roots[at])];
            refuse(ontology.axioms[named.axiom],
                   owl::local_name(named.iri) + " is made of composite parts that are made of it again",
                   "let each composite part consist of regions, or of composite parts of layers below");
        }
        if (done[at]) return;
        path.push_back(g);
        for (const int inner : groups[at].inner) self(self, inner);
        path.pop_back();
        done[at] = 1;
        order.push_back(g);
    };
    for (std::size_t g = 0; g < groups.size(); ++g) visit(visit, static_cast<int>(g));
    const auto place = [&](int g) { return static_cast<int>(std::ranges::find(order, g) - order.begin()); };
    for (NamedConcept& named : theory.concepts)
        if (named.group >= 0) named.group = place(named.group);
    for (const int g : order) {
        Group group = std::move(groups[static_cast<std::size_t>(g)]);
        for (int& inner : group.inner) inner = place(inner);
        std::vector<int> all = group.inner;  // and what those are made of
        for (const int inner : group.inner)
            std::ranges::copy(theory.groups[static_cast<std::size_t>(inner)].inner, std::back_inserter(all));
        std::ranges::sort(all);
        all.erase(std::unique(all.begin(), all.end()), all.end());
        group.inner = std::move(all);
        Formula marker;  // so that a compiled layer of regions has a literal for it
        marker.kind = Formula::Kind::parts;
        marker.index = group.regions;
        marker.threshold = 1;
        theory.formulas.push_back(std::move(marker));
        theory.groups.push_back(std::move(group));
    }
    refuse_open_groups(theory, mentions, ontology);
}

}  // namespace partonomy::knowledge
