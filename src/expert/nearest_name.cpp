#include "expert/nearest_name.h"

#include <algorithm>

namespace partonomy {

std::optional<NearestName> nearest_name(const Session& session, const knowledge::Knowledge& knowledge, int region,
                                        const std::vector<owl::Iri>& names) {
    const knowledge::Space& space = session.domain().regions;
    const auto sureness = [&](std::size_t i) {
        return session.is_accepted(knowledge.answers[i]) ? 2 : session.answer_scores()[i];
    };
    std::vector<std::size_t> own;
    for (std::size_t i = 0; i < knowledge.answers.size(); ++i)
        if (knowledge.answers[i].region == region) own.push_back(i);
    std::ranges::stable_sort(own, std::greater<>{}, sureness);
    std::optional<NearestName> nearest;
    double least = 0;
    for (const owl::Iri& name : names) {
        knowledge::ConfigurationSet possible = space.concepts[static_cast<std::size_t>(*space.find(name))].where;
        NearestName candidate{name, {}};
        double price = 0;
        for (const std::size_t i : own) {
            knowledge::ConfigurationSet next = session.narrowed(possible, knowledge.answers[i]);
            if (next.is_empty()) {
                candidate.refused_by.push_back(i);
                price += sureness(i) - 0.5;
            } else {
                possible = std::move(next);
            }
        }
        if (candidate.refused_by.empty() || (nearest && price >= least)) continue;
        least = price;
        nearest = std::move(candidate);
    }
    return nearest;
}

}  // namespace partonomy
