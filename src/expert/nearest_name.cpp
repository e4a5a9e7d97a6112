#include "expert/nearest_name.h"

#include <algorithm>

namespace partonomy {
namespace {

/// Compares regions with names.
class Comparison {
public:
    Comparison(const Session& session, const knowledge::Knowledge& knowledge)
        : session_(session), knowledge_(knowledge) {}

    /// Answers about the region, the surest first.
    [[nodiscard]] std::vector<std::size_t> answers_about(int region) const {
        std::vector<std::size_t> own;
        for (std::size_t i = 0; i < knowledge_.answers.size(); ++i)
            if (knowledge_.answers[i].region == region) own.push_back(i);
        std::ranges::stable_sort(own, std::greater<>{}, [&](std::size_t i) { return sureness(i); });
        return own;
    }

    [[nodiscard]] NearestName compare(const std::vector<std::size_t>& own, const owl::Iri& name) const {
        const knowledge::Space& space = session_.domain().regions;
        const knowledge::ConfigurationSet& where = space.concepts[static_cast<std::size_t>(*space.find(name))].where;
        knowledge::ConfigurationSet possible = where;
        NearestName found{name, {}};
        double in_favour = 0, against = 0;
        for (const std::size_t i : own) {
            const knowledge::Answer& answer = knowledge_.answers[i];
            knowledge::ConfigurationSet next = session_.narrowed(possible, answer);
            if (next.is_empty()) {
                found.refused_by.push_back(i);
                against += sureness(i) - 0.5;
                continue;
            }
            const knowledge::ConfigurationSet yes = yes_set(space, answer.question);
            if (answer.yes ? where.is_subset_of(yes) : !where.intersects(yes)) in_favour += sureness(i) - 0.5;
            possible = std::move(next);
        }
        found.likeness = in_favour + against > 0 ? in_favour / (in_favour + against) : 1;
        return found;
    }

private:
    [[nodiscard]] double sureness(std::size_t i) const {
        return session_.is_accepted(knowledge_.answers[i]) ? 2 : session_.answer_scores()[i];
    }

    const Session& session_;
    const knowledge::Knowledge& knowledge_;
};

}  // namespace

std::optional<NearestName> nearest_name(const Session& session, const knowledge::Knowledge& knowledge, int region,
                                        const std::vector<owl::Iri>& names) {
    const Comparison comparison(session, knowledge);
    const std::vector<std::size_t> own = comparison.answers_about(region);
    std::optional<NearestName> nearest;
    for (const owl::Iri& name : names)
        if (NearestName each = comparison.compare(own, name);
            !each.refused_by.empty() && (!nearest || each.likeness > nearest->likeness))
            nearest = std::move(each);
    return nearest;
}

std::vector<NearestRegion> nearest_regions(const Session& session, const knowledge::Knowledge& knowledge,
                                           const owl::Iri& name, std::size_t most) {
    const auto id = session.domain().regions.find(name);
    if (!id || session.domain().regions.concepts[static_cast<std::size_t>(*id)].where.is_empty()) return {};
    const Comparison comparison(session, knowledge);
    std::vector<NearestRegion> found;
    for (int region = 0; region < session.region_count(); ++region) {
        NearestName refused = comparison.compare(comparison.answers_about(region), name);
        if (!refused.refused_by.empty() && refused.likeness >= 0.5) found.push_back({region, std::move(refused)});
    }
    std::ranges::stable_sort(found, std::greater<>{}, [](const NearestRegion& each) { return each.refused.likeness; });
    if (found.size() > most) found.resize(most);
    return found;
}

}  // namespace partonomy
