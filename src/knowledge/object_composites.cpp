/* The composite parts of an object as clauses.

   Composite parts are largest connected sets of regions that belong to a group (groups.cpp), and which regions belong
   follows from their features, which are literals here. So is whether two of them are joined by a chain of regions that
   touch: with T(a, b) for "a and b belong and touch", one region k after the other may lie on the chain,

       T(a, b)  or  (T(a, k) and T(k, b)),

   as Floyd and Warshall have it; gates are made only where they are not constants. Regions of a known mesh touch few
   others, but for some, such as a table's top; those that are joined to fewest so far come first, which keeps chains
   short in coming. The first region of each connected set stands for it: a composite part for each region, there when
   the region belongs and is joined to none before it. Its concepts are literals as those of a region are.

   Where there may be further parts, known composite parts may be larger than they look, or one where they seem to be
   two. What an object counts of them is open then, but for three things. A composite part that has grown has no fewer
   regions of any class, so there is one that is what it is however it grows; this is not told of composite parts of
   composite parts, since these may change as they grow, and belong no more. Further parts make composite parts of their
   own, which count. And what no composite part can be is none of them.

   Cost: regions^3 gates for each group at worst, where all of them hang together; n^2 for n that do. */

#include "knowledge/object_clauses.h"

namespace partonomy::knowledge {
namespace {

constexpr std::size_t most_further = 24;  // beside known ones: each two may touch

}  // namespace

std::size_t ObjectClauses::region_count() const {
    return known_ > 0 && parts_.size() - known_ > most_further ? known_ : parts_.size();
}

int ObjectClauses::touching(std::size_t a, std::size_t b) {
    int& literal = touching_[std::minmax(a, b)];
    if (literal == 0) literal = std::min(a, b) < known_ ? clauses.never() : clauses.add_variable();
    return literal;
}

ObjectClauses::Composites& ObjectClauses::composites(std::size_t g) {
    Composites& made = composites_[g];
    const std::size_t count = region_count();
    if (made.members.size() == count) return made;
    const Group& group = theory_.groups[g];
    std::vector<int> belongs;
    for (std::size_t r = 0; r < count; ++r) {
        std::vector<int> ways{literal(parts_[r], group.regions)};
        for (const int h : group.inner) {
            Composites& inner = composites(static_cast<std::size_t>(h));
            for (std::size_t first = 0; first <= r; ++first)
                ways.push_back(
                    clauses.all_of({inner.holds[first][r], literal(inner.members[first], group.composites)}));
        }
        belongs.push_back(clauses.all_of({parts_[r].present, clauses.any_of(ways)}));
    }
    std::vector<std::vector<int>> joined(count, std::vector<int>(count, clauses.never()));
    for (std::size_t a = 0; a < count; ++a)
        for (std::size_t b = a + 1; b < count; ++b)
            joined[a][b] = joined[b][a] = clauses.all_of({touching(a, b), belongs[a], belongs[b]});
    const int never = clauses.never();
    std::vector<std::size_t> degrees, waiting, near;  // near: those that may be joined to k
    for (std::size_t a = 0; a < count; ++a) {
        degrees.push_back(count - static_cast<std::size_t>(std::ranges::count(joined[a], never)));
        waiting.push_back(a);
    }
    while (!waiting.empty()) {
        const auto next = std::ranges::min_element(waiting, {}, [&](std::size_t a) { return degrees[a]; });
        const std::size_t k = *next;
        waiting.erase(next);
        near.clear();
        for (std::size_t a = 0; a < count; ++a)
            if (joined[a][k] != never) near.push_back(a);
        for (std::size_t i = 0; i < near.size(); ++i)
            for (std::size_t j = i + 1; j < near.size(); ++j) {
                const std::size_t a = near[i], b = near[j];
                const int way = clauses.all_of({joined[a][k], joined[k][b]});
                if (joined[a][b] == never) {
                    ++degrees[a];
                    ++degrees[b];
                }
                joined[a][b] = joined[b][a] = clauses.any_of({joined[a][b], way});
            }
    }
    made.holds.assign(count, std::vector<int>(count, clauses.never()));
    for (std::size_t first = 0; first < count; ++first) {
        std::vector<int> conditions{belongs[first]};
        for (std::size_t before = 0; before < first; ++before) conditions.push_back(-joined[before][first]);
        const int present = clauses.all_of(conditions);
        made.holds[first][first] = present;
        for (std::size_t r = first + 1; r < count; ++r)
            made.holds[first][r] = clauses.all_of({present, joined[first][r]});
        Member member = make_member(present);
        member.group = static_cast<int>(g);
        member.first = first;
        if (group.inner.empty() && first < known_ && region_count() > known_) {
            made.grown.push_back(member);
            made.grown.back().is_grown = true;
        }
        made.members.push_back(std::move(member));
    }
    return made;
}

int ObjectClauses::lies_within(const Member& whole, const Composites& inner, const Member& part) {
    std::vector<int> conditions{part.present};
    if (whole.group >= 0) {
        const std::vector<int>& held = composites(static_cast<std::size_t>(whole.group)).holds[whole.first];
        for (std::size_t r = 0; r < held.size(); ++r)
            conditions.push_back(clauses.any_of({-inner.holds[part.first][r], held[r]}));
    }
    return clauses.all_of(conditions);
}

int ObjectClauses::composite_count(const Member& whole, const Formula& formula) {
    std::vector<int> members, further, grown;
    for (std::size_t g = 0; g < composites_.size(); ++g) {
        if (whole.group >= 0 &&
            std::ranges::count(theory_.groups[static_cast<std::size_t>(whole.group)].inner, static_cast<int>(g)) == 0)
            continue;
        Composites& inner = composites(g);
        for (Member& part : inner.members) {
            const bool is_known = whole.group >= 0 || known_ == 0 || part.first < known_;
            (is_known ? members : further)
                .push_back(clauses.all_of({lies_within(whole, inner, part), literal(part, formula.index)}));
        }
        for (std::size_t i = 0; whole.group < 0 && i < inner.grown.size(); ++i)
            grown.push_back(clauses.all_of({inner.grown[i].present, literal(inner.grown[i], formula.index)}));
    }
    const int exact = clauses.at_least(members, formula.threshold);
    if (whole.group >= 0 || known_ == 0 || known_ == parts_.size()) return exact;
    const int open = clauses.add_variable();
    clauses.add({-no_further_parts(), -open, exact});
    clauses.add({-no_further_parts(), open, -exact});
    if (region_count() < parts_.size()) return open;
    clauses.add({-clauses.at_least(further, formula.threshold), open});
    if (formula.threshold == 1) clauses.add({-clauses.any_of(grown), open});
    clauses.add({-open, exact, clauses.any_of(further)});
    return open;
}

int ObjectClauses::grown_count(const Member& whole, const Formula& formula) {
    const int open = clauses.add_variable();
    if (formula.part_level == Level::composite) return open;  // of those within it two may be one, too
    const int known = region_count_in(whole, formula);
    std::vector<int> further;
    for (std::size_t part = known_; part < parts_.size(); ++part)
        further.push_back(clauses.all_of({parts_[part].present, literal(parts_[part], formula.index)}));
    clauses.add({-known, open});
    clauses.add({-open, known, clauses.any_of(further)});
    return open;
}

int ObjectClauses::composite(std::size_t group, std::size_t first) { return composites(group).members[first].present; }

int ObjectClauses::composite_has(std::size_t group, std::size_t first, std::size_t region) {
    return composites(group).holds[first][region];
}

int ObjectClauses::composite_has(std::size_t group, std::size_t first, std::size_t inner_group,
                                 std::size_t inner_first) {
    const Composites& inner = composites(inner_group);
    const int is_there = composite(group, first);
    return clauses.all_of({is_there, lies_within(composites(group).members[first], inner, inner.members[inner_first])});
}

int ObjectClauses::composite(std::size_t group, const std::vector<std::size_t>& regions) {
    const Composites& all = composites(group);
    const Member& part = all.members[regions[0]];
    std::vector<int> conditions{part.present};
    for (std::size_t r = 0; r < region_count(); ++r) {
        const int held = all.holds[part.first][r];
        conditions.push_back(std::ranges::binary_search(regions, r) ? held : -held);
    }
    return clauses.all_of(conditions);
}

int ObjectClauses::composite_concept(std::size_t group, const std::vector<std::size_t>& regions, int id) {
    const int is_there = composite(group, regions);
    return clauses.all_of({is_there, concept_literal(composites(group).members[regions[0]], id)});
}

int ObjectClauses::some_composite(int id) {
    std::vector<int> members;
    for (std::size_t g = 0; g < composites_.size(); ++g)
        for (Member& part : composites(g).members)
            members.push_back(clauses.all_of({part.present, concept_literal(part, id)}));
    return clauses.any_of(members);
}

}  // namespace partonomy::knowledge
