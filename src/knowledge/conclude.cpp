#include <algorithm>
#include <stdexcept>

#include "base/errors.h"
#include "knowledge/assembly.h"
#include "knowledge/mesh_world.h"

// Answers cut the set of each region; the sets of the regions cut what the object can be. The second step is exact and
// cheap: the parts of an object only matter by their types, so each region adds one of the types that it may still have
// to the vectors of counts reached so far (object_space.cpp). Regions whose type is known come first and keep that set
// at one vector. Only these vectors become configurations: what the object can be is a small space of its own for each
// mesh. Where the ontology has composite parts, regions are put together first (put_together.cpp); while more
// regions may turn up, or there are too many ways, composite parts stay open. Where the ontology says more than these
// spaces do, the closed world of the mesh narrows both steps once all regions are known (mesh_world.h).

namespace partonomy::knowledge {
namespace {

/// The configurations with one of these counts; those that only have others than `possible` are impossible.
std::shared_ptr<const Space> objects_with(const Grounding& grounding, std::vector<Counts> counts,
                                          const std::optional<std::vector<Counts>>& possible) {
    const Theory& theory = grounding.theory;
    ObjectLayer objects = build_objects(theory, grounding.scope, {}, grounding.assembly.parts, std::move(counts),
                                        grounding.options.configuration_limit);
    auto space = std::make_shared<Space>(std::move(objects.layer.space));
    space->possible = possible ? objects.of(*possible) : space->all();
    for (std::size_t id = 0; id < theory.concepts.size(); ++id) {
        const NamedConcept& named = theory.concepts[id];
        if (named.level != Level::object || named.open) continue;
        ConfigurationSet& where = objects.layer.concepts[id];
        if (named.incompatible) space->possible -= where;
        space->concepts.push_back({named.iri, std::move(where), named.incompatible, named.definition >= 0, false});
    }
    return space;
}

/// What regions in these sets make up, and any others unless all are known; where that cannot be counted, as a solver
/// tells.
std::shared_ptr<const Space> objects_of(const Grounding& grounding, const Knowledge& knowledge,
                                        const std::vector<ConfigurationSet>& regions) {
    const Parts& parts = grounding.assembly.parts;
    const auto counts_within = [&](const std::vector<ConfigurationSet>& sets, const ConfigurationSet& others) {
        std::vector<Counts> counts = reachable_counts(parts, sets);
        return knowledge.complete
                   ? counts
                   : with_any_more(parts, counts, types_within(parts, others), grounding.options.configuration_limit);
    };
    try {
        if (!parts.fits) throw OntologyError(too_many_classes(parts));
        std::optional<std::vector<Counts>> possible;
        if (grounding.possible_regions != grounding.regions) {
            std::vector<ConfigurationSet> sets = regions;
            bool is_any = true;
            for (ConfigurationSet& set : sets) is_any &= !(set &= grounding.possible_regions).is_empty();
            possible = is_any ? counts_within(sets, grounding.possible_regions) : std::vector<Counts>{};
        }
        return objects_with(grounding, counts_within(regions, grounding.regions), possible);
    } catch (const OntologyError& limit_reached) {
        return std::make_shared<const Space>(objects_by_solver(grounding.theory, grounding.scope, parts, regions,
                                                               knowledge.complete, limit_reached.what()));
    }
}

/// Null where configuration spaces say all, where a region contradicts itself, and where the mesh is too large, which
/// `left_aside` says then.
std::unique_ptr<MeshReasoner> reasoner_for(const Domain& domain, const Knowledge& knowledge,
                                           const std::vector<ConfigurationSet>& regions,
                                           const std::optional<Assembled>& assembled, std::string& left_aside) {
    const Grounding& grounding = *domain.grounding;
    if (!knowledge.complete || !grounding.theory.needs_world() ||
        std::ranges::any_of(regions, [](const ConfigurationSet& region) { return region.is_empty(); }))
        return nullptr;
    if (grounding.assembly.has_composites() && (!assembled || !assembled->is_certain)) return nullptr;
    try {
        return std::make_unique<MeshReasoner>(domain, knowledge,
                                              assembled ? assembled->composites : std::vector<CompositePart>{});
    } catch (const OntologyError& error) {  // too many clauses: what else cannot be grounded, compile() has refused
        left_aside = error.what();
        return nullptr;
    }
}

/// What the answers leave of each region.
std::vector<ConfigurationSet> told_regions(const Domain& domain, const Knowledge& knowledge) {
    if (!domain.grounding) throw std::invalid_argument("conclude: the domain was not compiled");
    std::vector<ConfigurationSet> regions(static_cast<std::size_t>(std::max(0, knowledge.region_count)),
                                          domain.regions.all());
    for (const Answer& answer : knowledge.answers) {
        if (answer.region < 0 || answer.region >= knowledge.region_count)
            throw std::invalid_argument("conclude: an answer is about region " + std::to_string(answer.region));
        const auto variable = static_cast<std::size_t>(answer.question.variable);
        if (variable >= domain.regions.variables.size() ||
            static_cast<std::size_t>(answer.question.value) >= domain.regions.variables[variable].values.size())
            throw std::invalid_argument("conclude: an answer is to a question that there is not");
        ConfigurationSet& set = regions[static_cast<std::size_t>(answer.region)];
        if (answer.yes)
            set &= yes_set(domain.regions, answer.question);
        else
            set -= yes_set(domain.regions, answer.question);
    }
    return regions;
}

/// The composite parts of regions that are all known; nullopt where there are too many ways.
std::optional<Assembled> composites_of(const Domain& domain, const Knowledge& knowledge,
                                       const std::vector<ConfigurationSet>& regions) {
    if (!knowledge.complete) return std::nullopt;
    return put_together(domain.grounding->theory, domain.grounding->assembly, domain.grounding->contributions(),
                        regions, knowledge.connected);
}

Conclusions conclude_with(const Domain& domain, const Knowledge& knowledge, std::vector<ConfigurationSet> regions,
                          bool looks_at_world) {
    if (!domain.grounding) throw std::invalid_argument("conclude_object: the domain was not compiled");
    Conclusions conclusions;
    conclusions.regions = std::move(regions);
    bool is_contradicted = false;
    const Grounding& grounding = *domain.grounding;
    std::optional<Assembled> assembled;
    if (grounding.assembly.has_composites()) assembled = composites_of(domain, knowledge, conclusions.regions);
    std::unique_ptr<MeshReasoner> reasoner;
    if (looks_at_world)
        reasoner = reasoner_for(domain, knowledge, conclusions.regions, assembled, conclusions.left_aside);
    if (reasoner) is_contradicted = !reasoner->narrow(conclusions.regions);
    const Parts& parts = grounding.assembly.parts;
    if (grounding.assembly.has_composites()) {
        const Grounding::Listing& all = grounding.objects();
        if (reasoner && !is_contradicted) {  // the same ones, of which more is known
            assembled = composites_of(domain, knowledge, conclusions.regions);
            reasoner->narrow(assembled->composites);
        }
        conclusions.objects = {domain.grounding, &all.space};
        conclusions.object = all.layer.of(assembled ? assembled->counts
                                                    : with_any_composites(parts, all.layer.counts,
                                                                          reachable_counts(parts, conclusions.regions),
                                                                          !knowledge.complete));
        if (assembled) conclusions.composites = std::move(assembled->composites);
    } else {
        conclusions.objects = objects_of(grounding, knowledge, conclusions.regions);
        conclusions.object = conclusions.objects->all();
    }
    if (reasoner && !is_contradicted)
        is_contradicted = !reasoner->narrow(conclusions.regions, *conclusions.objects, conclusions.object);
    if (is_contradicted) conclusions.object = conclusions.objects->none();

    conclusions.contradiction = conclusions.object.is_empty();
    for (const ConfigurationSet& region : conclusions.regions) {
        conclusions.contradiction |= region.is_empty();
        for (const ConceptId id : entailed(domain.regions, region))
            if (domain.regions.concepts[id].incompatible)
                conclusions.diagnoses.push_back(domain.regions.concepts[id].iri);
    }
    for (const CompositePart& composite : conclusions.composites) {
        const Space& space = domain.composites[static_cast<std::size_t>(composite.group)].space;
        for (const ConceptId id : entailed(space, composite.possible))
            if (space.concepts[id].incompatible) conclusions.diagnoses.push_back(space.concepts[id].iri);
    }
    for (const ConceptId id : entailed(*conclusions.objects, conclusions.object))
        if (conclusions.objects->concepts[id].incompatible)
            conclusions.diagnoses.push_back(conclusions.objects->concepts[id].iri);
    std::ranges::sort(conclusions.diagnoses);
    conclusions.diagnoses.erase(std::unique(conclusions.diagnoses.begin(), conclusions.diagnoses.end()),
                                conclusions.diagnoses.end());
    return conclusions;
}

}  // namespace

Conclusions conclude(const Domain& domain, const Knowledge& knowledge) {
    return conclude_with(domain, knowledge, told_regions(domain, knowledge), true);
}

Conclusions conclude_object(const Domain& domain, const Knowledge& knowledge, std::vector<ConfigurationSet> regions) {
    return conclude_with(domain, knowledge, std::move(regions), true);
}

Conclusions conclude_by_spaces(const Domain& domain, const Knowledge& knowledge) {
    return conclude_with(domain, knowledge, told_regions(domain, knowledge), false);
}

std::optional<std::vector<CompositePart>> certain_composites(const Domain& domain, const Knowledge& knowledge) {
    std::optional<Assembled> assembled = composites_of(domain, knowledge, told_regions(domain, knowledge));
    if (!assembled || !assembled->is_certain) return std::nullopt;
    return std::move(assembled->composites);
}

std::vector<ConceptId> entailed(const Space& space, const ConfigurationSet& set) {
    std::vector<ConceptId> ids;
    if (set.is_empty()) return ids;
    for (std::size_t id = 0; id < space.concepts.size(); ++id)
        if (set.is_subset_of(space.concepts[id].where)) ids.push_back(static_cast<ConceptId>(id));
    return ids;
}

}  // namespace partonomy::knowledge
