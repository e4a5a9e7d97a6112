/* What stayed open, in words that tell what to do about it.
 *
 * A name is assumed when a question that would decide it has no answer. The questions named are those whose answers
 * change how likely the name is: for a measured feature, why it cannot be measured; for a relation, that it hangs on
 * what other parts are. An incompatible concept that follows from assumed names is told with the fewest of them that it
 * needs (found by leaving one out at a time). A composite part is open when there would be one if all the parts that
 * may belong to it did. */

#include "expert/open_questions.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "algorithms/appearance.h"
#include "base/spelling.h"

namespace partonomy {
namespace {

using knowledge::CompositePart;
using knowledge::ConceptId;
using knowledge::Conclusions;
using knowledge::ConfigurationSet;
using knowledge::Domain;
using knowledge::Question;
using knowledge::Variable;
using knowledge::VariableKind;
using owl::Iri;

constexpr std::size_t most_left_out = 32;  // assumed names that are left out one by one: each takes a conclusion

const ConfigurationSet& where(const Domain& domain, const Iri& iri) {
    return domain.regions.concepts[static_cast<std::size_t>(*domain.regions.find(iri))].where;
}

std::string numbered(const std::vector<int>& regions) {
    std::vector<int> ids;
    for (const int region : regions) ids.push_back(region + 1);
    return fmt::format("part{} {}", ids.size() == 1 ? "" : "s", fmt::join(ids, ", "));
}

/// "Size cannot be measured while the unit is unknown"; empty when it can be measured, or when it is no measurement.
std::string why_not_measured(const Session& session, int region, int variable) {
    const Variable& about = session.domain().regions.variables[static_cast<std::size_t>(variable)];
    if (about.kind != VariableKind::range && about.kind != VariableKind::number) return {};
    const std::string name = owl::local_name(about.iri);
    bool has_algorithm = false;
    for (int i = 0; i < static_cast<int>(about.values.size()); ++i) {
        const Question question{variable, i};
        const ElementaryAlgorithm* algorithm = session.catalogue().find(Signature::is_a, question);
        if (algorithm == nullptr) continue;
        has_algorithm = true;
        if (algorithm->needs_metres && !session.object().placement.metres_per_unit)
            return name + " cannot be measured while the unit is unknown";
        if (!tells(session.object(), algorithm->look))
            return name + " cannot be measured, since the mesh has no colours";
        const RegionMeasurements& measured = session.measurements(region);
        if (is_a(session.domain(), session.catalogue(), question, session.object(), measured)) return {};
        constexpr double flat = 1e-9;
        if (measured.lengths[2] <= flat * measured.lengths[0])
            return name + " cannot be measured, since it is a sheet without thickness";
        for (const Formula& formula : algorithm->formulas)
            if (!evaluate(formula, session.object(), measured))
                return fmt::format("{} cannot be measured, since it has no {}", name, formula.text);
    }
    return has_algorithm ? std::string{} : "no algorithm tells its " + name;
}

/// Whether some answer about a variable makes a name more or less likely.
bool matters(const knowledge::Space& space, int variable, const ConfigurationSet& possible,
             const ConfigurationSet& name) {
    const double before = possible.share(name);
    return std::ranges::any_of(space.holds[static_cast<std::size_t>(variable)], [&](const ConfigurationSet& holds) {
        if (!possible.intersects(holds) || possible.is_subset_of(holds)) return false;
        ConfigurationSet then = possible;
        then &= holds;
        return std::abs(then.share(name) - before) > 1e-12;
    });
}

/// "its Section cannot be measured, since …; whether it touches … hangs on what other parts are".
std::string what_would_decide(const Session& session, int region, const ConfigurationSet& possible,
                              const ConfigurationSet& name) {
    const Domain& domain = session.domain();
    std::vector<std::string> reasons, relations;
    for (int v = 0; v < static_cast<int>(domain.regions.variables.size()); ++v) {
        if (!matters(domain.regions, v, possible, name)) continue;
        const Variable& variable = domain.regions.variables[static_cast<std::size_t>(v)];
        if (variable.kind == VariableKind::relation)
            relations.push_back(to_text(domain.regions, {v, 0}, domain));
        else if (std::string why = why_not_measured(session, region, v); !why.empty())
            reasons.push_back(why.starts_with("no algorithm") ? std::move(why) : "its " + why);
    }
    if (reasons.empty() && !relations.empty())
        return fmt::format("open: {}? That hangs on what other parts are", relations.front());
    if (reasons.empty()) return "what would decide it cannot be asked";
    return fmt::format("{}", fmt::join(reasons, "; "));
}

/// The fewest parts whose assumed names make the concept hold.
std::vector<int> assumptions_of(const Domain& domain, const knowledge::Knowledge& knowledge, const Conclusions& known,
                                const std::vector<Naming>& namings, const Iri& concept_) {
    std::vector<int> needed;
    for (std::size_t r = 0; r < namings.size(); ++r)
        if (namings[r].certainty < 1) needed.push_back(static_cast<int>(r));
    if (needed.size() > most_left_out) return needed;
    for (std::size_t i = 0; i < needed.size();) {
        std::vector<int> fewer = needed;
        fewer.erase(fewer.begin() + static_cast<std::ptrdiff_t>(i));
        const Conclusions without = conclude_assuming(domain, knowledge, known, namings, &fewer);
        if (std::ranges::binary_search(without.diagnoses, concept_))
            needed = std::move(fewer);
        else
            ++i;
    }
    return needed;
}

/// "a Weight", where a region may be one and one would belong to the composite part; else "one of its parts".
std::string what_it_may_be(const Session& session, const ConfigurationSet& possible,
                           const ConfigurationSet& belonging) {
    for (const ConceptId c : session.wanted()) {
        const knowledge::Concept& each = session.domain().regions.concepts[static_cast<std::size_t>(c)];
        if (possible.intersects(each.where) && !possible.is_subset_of(each.where) && each.where.is_subset_of(belonging))
            return with_article(owl::local_name(each.iri));
    }
    return "one of its parts";
}

/// Sets of regions that hang together by touching, of those in `members`; each ascending.
std::vector<std::vector<int>> connected_sets(std::vector<int> members, const std::vector<std::pair<int, int>>& pairs) {
    std::vector<std::vector<int>> sets;
    while (!members.empty()) {
        std::vector<int> set{members.front()};
        members.erase(members.begin());
        for (std::size_t i = 0; i < set.size(); ++i)
            for (const auto& [a, b] : pairs) {
                if (a != set[i] && b != set[i]) continue;
                const auto other = std::ranges::find(members, a == set[i] ? b : a);
                if (other == members.end()) continue;
                set.push_back(*other);
                members.erase(other);
            }
        std::ranges::sort(set);
        sets.push_back(std::move(set));
    }
    return sets;
}

/// Concepts of a composite part of one group that some composite part of `set` is.
std::vector<std::string> composites_within(const Domain& domain, const Conclusions& conclusions, int group,
                                           const std::vector<int>& set) {
    const knowledge::Space& space = domain.composites[static_cast<std::size_t>(group)].space;
    std::vector<std::string> names;
    for (const CompositePart& part : conclusions.composites) {
        if (part.group != group || !std::ranges::includes(set, part.regions)) continue;
        for (const ConceptId c : entailed(space, part.possible))
            if (const Iri& iri = space.concepts[static_cast<std::size_t>(c)].iri; !iri.starts_with(owl::core_prefix))
                names.push_back(owl::local_name(iri));
    }
    return names;
}

/// "WeightSide: open, because part 1 may be a Weight": composite parts that there are, or are larger, once the parts
/// that may belong to them do.
void add_composites(const Session& session, const knowledge::Knowledge& knowledge, const Conclusions& assumed,
                    std::vector<std::string>& open) {
    const Domain& domain = session.domain();
    if (assumed.contradiction || !knowledge.complete) return;
    for (int group = 0; group < static_cast<int>(domain.composites.size()); ++group) {
        const ConfigurationSet& belonging = domain.composites[static_cast<std::size_t>(group)].regions;
        std::vector<int> members;
        for (int region = 0; region < session.region_count(); ++region)
            if (assumed.regions[static_cast<std::size_t>(region)].intersects(belonging)) members.push_back(region);
        for (const std::vector<int>& set : connected_sets(members, knowledge.connected)) {
            std::vector<ConfigurationSet> regions = assumed.regions;
            std::map<std::string, std::vector<int>> reasons;
            for (const int region : set) {
                ConfigurationSet& possible = regions[static_cast<std::size_t>(region)];
                if (possible.is_subset_of(belonging)) continue;
                reasons[what_it_may_be(session, possible, belonging)].push_back(region);
                possible &= belonging;
            }
            if (reasons.empty()) continue;
            const Conclusions then = conclude_object(domain, knowledge, std::move(regions));
            std::vector<std::string> names = composites_within(domain, then, group, set);
            for (const std::string& name : composites_within(domain, assumed, group, set)) std::erase(names, name);
            if (names.empty()) continue;
            std::ranges::sort(names);
            names.erase(std::unique(names.begin(), names.end()), names.end());
            std::vector<std::string> texts;
            for (const auto& [what, which] : reasons)
                texts.push_back(fmt::format("{} may be {}", numbered(which), what));
            open.push_back(fmt::format("{}: open, because {}", fmt::join(names, ", "), fmt::join(texts, " and ")));
        }
    }
}

}  // namespace

Conclusions conclude_assuming(const Domain& domain, const knowledge::Knowledge& knowledge, const Conclusions& known,
                              const std::vector<Naming>& namings, const std::vector<int>* regions) {
    std::vector<ConfigurationSet> sets = known.regions;
    for (std::size_t r = 0; r < sets.size(); ++r)
        if (namings[r].certainty < 1 &&
            (regions == nullptr || std::ranges::find(*regions, static_cast<int>(r)) != regions->end()))
            sets[r] &= where(domain, namings[r].concepts.front());
    return conclude_object(domain, knowledge, std::move(sets));
}

std::vector<std::string> open_questions(const Session& session, const knowledge::Knowledge& knowledge,
                                        const std::vector<Naming>& namings, const Conclusions& known,
                                        const Conclusions& assumed, const std::vector<Iri>& perhaps) {
    const Domain& domain = session.domain();
    std::vector<std::string> open;
    if (!known.left_aside.empty()) open.push_back("what only the whole mesh tells stays open: " + known.left_aside);
    if (needs_appearance(session.catalogue()) && !session.object().appearance)
        open.emplace_back("the mesh has no colours, so what hangs on them stays open");
    const auto assumption = [&](int region) {
        return with_article(owl::local_name(namings[static_cast<std::size_t>(region)].concepts.front()));
    };
    for (const Iri& iri : perhaps) {
        std::vector<std::string> conditions;
        for (const int region : assumptions_of(domain, knowledge, known, namings, iri))
            conditions.push_back(fmt::format("part {} is {}", region + 1, assumption(region)));
        open.push_back(fmt::format("perhaps {}, if {}", owl::local_name(iri), fmt::join(conditions, " and ")));
    }
    const auto is_in_a_whole = [&](int region) {
        return std::ranges::any_of(assumed.composites, [&](const knowledge::CompositePart& whole) {
            return std::ranges::binary_search(whole.regions, region);
        });
    };
    for (int region = 0; region < session.region_count(); ++region) {
        const Naming& naming = namings[static_cast<std::size_t>(region)];
        const ConfigurationSet& possible = known.regions[static_cast<std::size_t>(region)];
        if (naming.certainty < 1)
            open.push_back(
                fmt::format("part {} is assumed to be {}: {}", region + 1, assumption(region),
                            what_would_decide(session, region, possible, where(domain, naming.concepts.front()))));
        else if (session.possible(region).is_empty())
            open.push_back(fmt::format("part {}: its answers contradict the axioms", region + 1));
        else if (naming.concepts.empty() && !is_in_a_whole(region))
            open.push_back(fmt::format("part {} is nothing that the ontology names", region + 1));
    }
    add_composites(session, knowledge, assumed, open);
    if (const double fraction = session.uncovered_fraction(); fraction > 0.005)
        open.push_back(fmt::format("{:.1f} % of the surface is in no part", 100 * fraction));
    return open;
}

}  // namespace partonomy
