#include <algorithm>
#include <stdexcept>

#include "knowledge/assembly.h"

// Answers cut the set of each region; the sets of the regions cut what the object can be. The second step is exact and
// cheap: the parts of an object only matter by their types, so each region adds one of the types that it may still have
// to the vectors of counts reached so far (object_space.cpp). Regions whose type is known come first and keep that set
// at one vector. Where the ontology has composite parts, regions are put together first (put_together.cpp); while more
// regions may turn up, or there are too many ways, composite parts stay open.

namespace partonomy::knowledge {

Conclusions conclude(const Domain& domain, const Knowledge& knowledge) {
    if (!domain.grounding) throw std::invalid_argument("conclude: the domain was not compiled");
    Conclusions conclusions;
    conclusions.regions.assign(static_cast<std::size_t>(std::max(0, knowledge.region_count)), domain.regions.all());
    for (const Answer& answer : knowledge.answers) {
        if (answer.region < 0 || answer.region >= knowledge.region_count)
            throw std::invalid_argument("conclude: an answer is about region " + std::to_string(answer.region));
        const auto variable = static_cast<std::size_t>(answer.question.variable);
        if (variable >= domain.regions.variables.size() ||
            static_cast<std::size_t>(answer.question.value) >= domain.regions.variables[variable].values.size())
            throw std::invalid_argument("conclude: an answer is to a question that there is not");
        ConfigurationSet& set = conclusions.regions[answer.region];
        if (answer.yes)
            set &= yes_set(domain.regions, answer.question);
        else
            set -= yes_set(domain.regions, answer.question);
    }
    return conclude_object(domain, knowledge, std::move(conclusions.regions));
}

Conclusions conclude_object(const Domain& domain, const Knowledge& knowledge, std::vector<ConfigurationSet> regions) {
    if (!domain.grounding) throw std::invalid_argument("conclude_object: the domain was not compiled");
    Conclusions conclusions;
    conclusions.regions = std::move(regions);
    const Grounding& grounding = *domain.grounding;
    const Parts& parts = grounding.assembly.parts;
    const ObjectLayer& objects = grounding.objects;
    if (grounding.assembly.has_composites()) {
        std::optional<Assembled> assembled;
        if (knowledge.complete)
            assembled = put_together(grounding.theory, grounding.assembly, domain.regions.all(), conclusions.regions,
                                     knowledge.connected);
        conclusions.object = objects.of(assembled ? assembled->counts
                                                  : with_any_composites(parts, objects.counts,
                                                                        reachable_counts(parts, conclusions.regions),
                                                                        !knowledge.complete));
        if (assembled) conclusions.composites = std::move(assembled->composites);
    } else {
        const std::vector<Counts> counts = reachable_counts(parts, conclusions.regions);
        conclusions.object = knowledge.complete ? objects.of(counts) : with_more_parts(parts, objects, counts);
    }

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
    for (const ConceptId id : entailed(domain.objects, conclusions.object))
        if (domain.objects.concepts[id].incompatible) conclusions.diagnoses.push_back(domain.objects.concepts[id].iri);
    std::ranges::sort(conclusions.diagnoses);
    conclusions.diagnoses.erase(std::unique(conclusions.diagnoses.begin(), conclusions.diagnoses.end()),
                                conclusions.diagnoses.end());
    return conclusions;
}

std::vector<ConceptId> entailed(const Space& space, const ConfigurationSet& set) {
    std::vector<ConceptId> ids;
    if (set.is_empty()) return ids;
    for (std::size_t id = 0; id < space.concepts.size(); ++id)
        if (set.is_subset_of(space.concepts[id].where)) ids.push_back(static_cast<ConceptId>(id));
    return ids;
}

}  // namespace partonomy::knowledge
