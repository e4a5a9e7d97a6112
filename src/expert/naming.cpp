/* What things are called.
 *
 * A part is called by the most specific concept that is entailed for it. Where a question that would decide cannot be
 * answered (no unit, no algorithm), several names stay possible: then the part gets the name that holds in most of the
 * configurations that are left, and the share of these is its certainty. A part for which nothing can hold stays
 * unnamed; what it is nearest to is told. A part that is nothing but a helper is called by the smallest composite part
 * that it belongs to. */

#include "expert/naming.h"

#include <algorithm>

#include "expert/annotate.h"
#include "expert/nearest_name.h"
#include "knowledge/near_miss.h"

namespace partonomy {

using knowledge::ConceptId;
using knowledge::Conclusions;
using knowledge::ConfigurationSet;
using knowledge::Domain;
using knowledge::Space;
using owl::Iri;

std::string annotation_of(const Domain& domain, const Iri& iri, const char* name) {
    const auto found = domain.ontology.annotations.find(iri);
    if (found == domain.ontology.annotations.end()) return {};
    for (const owl::Annotation& annotation : found->second)
        if (annotation.property == std::string(owl::core_prefix) + name) return annotation.literal.value;
    return {};
}

bool is_helper(const Domain& domain, const Iri& iri) { return annotation_of(domain, iri, "helper") == "true"; }

Naming name_region(const Session& session, const ConfigurationSet& possible) {
    const Space& space = session.domain().regions;
    Naming naming;
    if (possible.is_empty()) return naming;  // of a contradiction everything follows
    for (const ConceptId c : session.wanted())
        if (const auto& concept_ = space.concepts[static_cast<std::size_t>(c)];
            possible.is_subset_of(concept_.where) && !is_helper(session.domain(), concept_.iri))
            naming.concepts.push_back(concept_.iri);
    if (!naming.concepts.empty()) return naming;
    double most = 0;
    for (const ConceptId c : session.wanted()) {
        const auto& concept_ = space.concepts[static_cast<std::size_t>(c)];
        if (concept_.incompatible || is_helper(session.domain(), concept_.iri)) continue;
        if (const double share = possible.share(concept_.where); share > most) {
            most = share;
            naming.concepts = {concept_.iri};
        }
    }
    if (most > 0) naming.certainty = most;
    return naming;
}

std::vector<std::string> local_names(const std::vector<Iri>& iris) {
    std::vector<std::string> names;
    for (const Iri& iri : iris) names.push_back(owl::local_name(iri));
    return names;
}

std::vector<Iri> specific_first(const Domain& domain, const std::vector<Iri>& iris) {
    std::vector<Iri> sorted = domain.most_specific(iris);
    for (const Iri& iri : iris)
        if (std::find(sorted.begin(), sorted.end(), iri) == sorted.end()) sorted.push_back(iri);
    return sorted;
}

std::vector<std::string> names_among(const Domain& domain, const Space& space, std::vector<Iri> iris) {
    std::erase_if(
        iris, [&](const Iri& iri) { return space.concepts[static_cast<std::size_t>(*space.find(iri))].incompatible; });
    return local_names(domain.most_specific(iris));
}

std::vector<AnnotatedComposite> composite_parts(const Session& session, const Conclusions& known,
                                                const std::vector<Iri>& perhaps) {
    const Domain& domain = session.domain();
    std::vector<AnnotatedComposite> composites;
    std::vector<const knowledge::CompositePart*> kept;
    for (const knowledge::CompositePart& part : known.composites) {
        const Space& space = domain.composites[static_cast<std::size_t>(part.group)].space;
        std::vector<Iri> names;
        for (const ConceptId c : entailed(space, part.possible)) {
            const Iri& iri = space.concepts[static_cast<std::size_t>(c)].iri;
            if (!iri.starts_with(owl::core_prefix) && std::ranges::find(perhaps, iri) == perhaps.end())
                names.push_back(iri);
        }
        if (names.empty()) continue;
        AnnotatedComposite& composite = composites.emplace_back();
        composite.id = static_cast<int>(composites.size());
        composite.concepts = local_names(specific_first(domain, names));
        composite.names = names_among(domain, space, names);
        for (const int region : part.regions) composite.parts.push_back(region + 1);
        for (std::size_t k = 0; k < kept.size(); ++k)
            if (kept[k]->group < part.group && std::ranges::includes(part.regions, kept[k]->regions))
                composite.composites.push_back(static_cast<int>(k) + 1);
        kept.push_back(&part);
    }
    return composites;
}

std::vector<Iri> names_of_whole(const Domain& domain, const Conclusions& known, int region) {
    const knowledge::CompositePart* smallest = nullptr;
    std::vector<Iri> names;
    for (const knowledge::CompositePart& part : known.composites) {
        if (!std::ranges::binary_search(part.regions, region)) continue;
        if (smallest && part.regions.size() >= smallest->regions.size()) continue;
        const Space& space = domain.composites[static_cast<std::size_t>(part.group)].space;
        std::vector<Iri> found;
        for (const ConceptId c : entailed(space, part.possible)) {
            const knowledge::Concept& concept_ = space.concepts[static_cast<std::size_t>(c)];
            if (!concept_.incompatible && !concept_.iri.starts_with(owl::core_prefix) &&
                !is_helper(domain, concept_.iri))
                found.push_back(concept_.iri);
        }
        if (found.empty()) continue;
        smallest = &part;
        names = domain.most_specific(found);
    }
    return names;
}

void name_by_wholes(const Domain& domain, const Conclusions& known, Annotation& annotation) {
    for (AnnotatedPart& part : annotation.parts) {
        if (!part.concepts.empty()) continue;
        const std::vector<Iri> names = names_of_whole(domain, known, part.id - 1);
        if (names.empty()) continue;
        part.concepts = part.names = local_names(names);
        part.color = annotation_of(domain, names.front(), "color");
        part.is_piece = true;
    }
}

void tell_nearest_names(const Session& session, const knowledge::Knowledge& knowledge, Annotation& annotation) {
    if (!session.is_told_in_numbers()) return;
    const Domain& domain = session.domain();
    std::vector<Iri> names;
    for (const ConceptId c : session.wanted())
        if (const auto& concept_ = domain.regions.concepts[static_cast<std::size_t>(c)];
            !concept_.incompatible && !is_helper(domain, concept_.iri) && !concept_.where.is_empty())
            names.push_back(concept_.iri);
    for (AnnotatedPart& part : annotation.parts) {
        if (!part.concepts.empty()) continue;
        const auto nearest = nearest_name(session, knowledge, part.id - 1, names);
        if (!nearest) continue;
        part.nearest = owl::local_name(nearest->iri);
        for (const std::size_t i : nearest->refused_by)
            part.refusals.push_back(what_was_answered(domain, knowledge.answers[i], annotation.answers[i]));
    }
}

bool is_recognised(const Conclusions& known) {
    return std::ranges::any_of(entailed(*known.objects, known.object), [&](ConceptId c) {
        const auto& concept_ = known.objects->concepts[static_cast<std::size_t>(c)];
        return !concept_.incompatible && !concept_.iri.starts_with(owl::core_prefix);
    });
}

std::vector<NearClass> nearest_classes(const Domain& domain, const Conclusions& assumed,
                                       const std::vector<Iri>& classes) {
    constexpr std::size_t most = 3;
    std::vector<NearClass> nearest;
    const knowledge::Space& objects = *assumed.objects;
    if (assumed.contradiction || std::ranges::any_of(classes, [&](const Iri& iri) {
            return !objects.concepts[static_cast<std::size_t>(*objects.find(iri))].incompatible;
        }))
        return nearest;
    std::vector<Iri> helpers;
    for (const knowledge::Concept& concept_ : objects.concepts)
        if (is_helper(domain, concept_.iri)) helpers.push_back(concept_.iri);
    for (knowledge::NearMiss& miss : near_misses(domain, assumed, helpers)) {
        if (nearest.size() == most) break;
        nearest.push_back({owl::local_name(miss.iri), std::move(miss.lacks), std::move(miss.too_many)});
    }
    return nearest;
}

}  // namespace partonomy
