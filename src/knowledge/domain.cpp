#include "knowledge/domain.h"

#include <algorithm>
#include <limits>

#include "knowledge/theory.h"

namespace partonomy::knowledge {
namespace {

const Concept* find_concept(const Domain& domain, const Iri& iri) {
    for (const Space* space : {&domain.regions, &domain.objects})
        if (const std::optional<ConceptId> id = space->find(iri)) return &space->concepts[*id];
    return nullptr;
}

/// Whether every `a` is a `b`, for different names.
bool is_below(const Domain& domain, const Iri& a, const Iri& b) {
    const int layer = domain.layer(a);
    const Concept *sub = find_concept(domain, a), *super = find_concept(domain, b);
    if (sub != nullptr && super != nullptr) return layer == domain.layer(b) && sub->where.is_subset_of(super->where);
    const Space& space = layer == 1 ? domain.regions : domain.objects;
    if (sub != nullptr) {
        if (b == core_term("Incompatible")) {
            ConfigurationSet rest = sub->where;
            for (const Concept& each : space.concepts)
                if (each.incompatible) rest -= each.where;
            return rest.is_empty();
        }
        return (layer == 1 && b == core_term("Region")) || (layer == 2 && b == core_term("Object"));
    }
    if (super != nullptr) {
        const bool about_same =
            (a == core_term("Region") && domain.layer(b) == 1) || (a == core_term("Object") && domain.layer(b) == 2);
        const Space& about = domain.layer(b) == 1 ? domain.regions : domain.objects;
        return about_same && about.all().is_subset_of(super->where);
    }
    for (const RangeConcept& range : domain.ranges) {
        const bool is_value = std::ranges::any_of(range.values, [&](const auto& value) { return value.iri == a; });
        if (is_value && (b == range.iri || b == core_term("Feature"))) return true;
        if (a == range.iri && b == core_term("Feature")) return true;
    }
    return false;
}

}  // namespace

ConfigurationSet Space::all() const { return diagram ? ConfigurationSet(diagram, {}) : ConfigurationSet(size, true); }

std::string Space::product_text() const {
    std::string digits = "1";  // decimal, last digit first
    for (const Variable& variable : variables) {
        std::size_t carry = 0;
        for (char& digit : digits) {
            carry += static_cast<std::size_t>(digit - '0') * variable.values.size();
            digit = static_cast<char>('0' + carry % 10);
            carry /= 10;
        }
        for (; carry > 0; carry /= 10) digits += static_cast<char>('0' + carry % 10);
    }
    return product < std::numeric_limits<std::size_t>::max() ? std::to_string(product)
                                                             : std::string(digits.rbegin(), digits.rend());
}

std::optional<ConceptId> Space::find(const Iri& iri) const {
    const auto found = std::ranges::lower_bound(concepts, iri, {}, &Concept::iri);
    if (found == concepts.end() || found->iri != iri) return std::nullopt;
    return static_cast<ConceptId>(found - concepts.begin());
}

std::optional<VariableId> Space::find_variable(const Iri& iri) const {
    if (iri.empty()) return std::nullopt;
    for (std::size_t v = 0; v < variables.size(); ++v)
        if (variables[v].iri == iri) return static_cast<VariableId>(v);
    return std::nullopt;
}

int Domain::layer(const Iri& iri) const {
    if (regions.find(iri)) return 1;
    if (objects.find(iri)) return 2;
    for (const RangeConcept& range : ranges)
        if (range.iri == iri || std::ranges::any_of(range.values, [&](const auto& value) { return value.iri == iri; }))
            return 0;
    return -1;
}

std::vector<Iri> Domain::most_specific(const std::vector<Iri>& iris) const {
    const auto is_diagnosis = [&](const Iri& iri) {
        const Concept* found = find_concept(*this, iri);
        return iri == core_term("Incompatible") || (found != nullptr && found->incompatible);
    };
    std::vector<Iri> kept;
    for (const Iri& iri : iris) {
        const bool hidden = std::ranges::any_of(iris, [&](const Iri& other) {
            return other != iri && is_below(*this, other, iri) && !is_below(*this, iri, other) &&
                   is_diagnosis(other) == is_diagnosis(iri);
        });
        if (!hidden) kept.push_back(iri);
    }
    return kept;
}

std::vector<std::pair<Iri, Iri>> Domain::hierarchy() const {
    std::vector<std::pair<Iri, Iri>> pairs;
    for (const RangeConcept& range : ranges) {
        pairs.emplace_back(range.iri, core_term("Feature"));
        for (const ElementaryConcept& value : range.values) {
            pairs.emplace_back(value.iri, range.iri);
            pairs.emplace_back(value.iri, core_term("Feature"));
        }
    }
    for (const Space* space : {&regions, &objects}) {
        const Iri top = core_term(space == &regions ? "Region" : "Object");
        const ConfigurationSet all = space->all();
        for (const Concept& a : space->concepts) {
            if (a.where.is_empty()) continue;
            pairs.emplace_back(a.iri, top);
            if (all.is_subset_of(a.where)) pairs.emplace_back(top, a.iri);
            if (is_below(*this, a.iri, core_term("Incompatible"))) pairs.emplace_back(a.iri, core_term("Incompatible"));
            for (const Concept& b : space->concepts)
                if (a.iri != b.iri && a.where.is_subset_of(b.where)) pairs.emplace_back(a.iri, b.iri);
        }
    }
    std::ranges::sort(pairs);
    return pairs;
}

std::vector<Iri> Domain::unsatisfiable() const {
    std::vector<Iri> names;
    for (const Space* space : {&regions, &objects})
        for (const Concept& each : space->concepts)
            if (each.where.is_empty()) names.push_back(each.iri);
    std::ranges::sort(names);
    return names;
}

}  // namespace partonomy::knowledge
