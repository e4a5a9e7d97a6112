#include "knowledge/domain.h"

#include <algorithm>
#include <limits>

#include "knowledge/assembly.h"
#include "knowledge/object_test.h"
#include "knowledge/sampled_models.h"

namespace partonomy::knowledge {
namespace {

/// What concepts are about.
enum class Sort { region, composite, object };

const char* top_of(Sort sort) {
    return sort == Sort::region ? "Region" : sort == Sort::composite ? "CompositePart" : "Object";
}

std::vector<const Space*> spaces_of(const Domain& domain, Sort sort) {
    if (sort == Sort::region) return {&domain.regions};
    if (sort == Sort::object) return {&domain.objects()};
    std::vector<const Space*> spaces;
    for (const CompositeSpace& composite : domain.composites) spaces.push_back(&composite.space);
    return spaces;
}

constexpr Sort all_sorts[] = {Sort::region, Sort::composite, Sort::object};

bool is_object_concept(const Domain& domain, const Iri& iri) {
    const Theory& theory = domain.grounding->theory;
    const int id = theory.find(iri);
    return id >= 0 && theory.concepts[id].level == Level::object;
}

/// Whether the definition of concept `a` says that it is a `b`, directly or through those that it names.
bool is_told_below(const Theory& theory, int a, int b) {
    const auto says = [&](const auto& self, FormulaId id) -> bool {
        const Formula& formula = theory.formulas[id];
        if (formula.kind == Formula::Kind::named) return formula.index == b || is_told_below(theory, formula.index, b);
        return formula.kind == Formula::Kind::conjunction &&
               std::ranges::any_of(formula.operands, [&](FormulaId operand) { return self(self, operand); });
    };
    return theory.concepts[a].definition >= 0 && says(says, theory.concepts[a].definition);
}

std::optional<Sort> sort_of(const Domain& domain, const Iri& iri) {
    if (is_object_concept(domain, iri)) return Sort::object;
    for (const Sort sort : {Sort::region, Sort::composite})
        for (const Space* space : spaces_of(domain, sort))
            if (space->find(iri)) return sort;
    return std::nullopt;
}

/// Where the concept holds, in a space of its sort; nothing where the space has not heard of it.
ConfigurationSet where_in(const Space& space, const Iri& iri) {
    const std::optional<ConceptId> id = space.find(iri);
    return id ? space.concepts[*id].where : space.none();
}

bool is_incompatible(const Domain& domain, const Iri& iri) {
    const int id = domain.grounding->theory.find(iri);
    return id >= 0 && domain.grounding->theory.concepts[id].incompatible;
}

/// Whether every `a` is a `b`, for different names.
bool is_below(const Domain& domain, const Iri& a, const Iri& b) {
    const std::optional<Sort> sub = sort_of(domain, a), super = sort_of(domain, b);
    if (sub == Sort::object && super == Sort::object) {
        const Theory& theory = domain.grounding->theory;
        const std::vector<int> pair{theory.find(a), theory.find(b)};
        if (is_told_below(theory, pair[0], pair[1])) return true;
        if (const auto test = ObjectTest::about(domain, pair)) return test->is_below(pair[0], pair[1]);
    }
    if (sub && super)
        return *sub == *super && std::ranges::all_of(spaces_of(domain, *sub), [&](const Space* space) {
            return where_in(*space, a).is_subset_of(where_in(*space, b));
        });
    if (sub) {
        if (!is_core_term(b, "Incompatible")) return b == core_term(top_of(*sub));
        return std::ranges::all_of(spaces_of(domain, *sub), [&](const Space* space) {
            ConfigurationSet rest = where_in(*space, a);
            for (const Concept& each : space->concepts)
                if (each.incompatible) rest -= each.where;
            return rest.is_empty();
        });
    }
    if (super)
        return a == core_term(top_of(*super)) &&
               std::ranges::all_of(spaces_of(domain, *super),
                                   [&](const Space* space) { return space->all().is_subset_of(where_in(*space, b)); });
    const std::vector<std::pair<Iri, Iri>> relations = told_relations(domain.ontology);
    if (std::ranges::binary_search(relations, std::pair(a, b))) return true;
    for (const RangeConcept& range : domain.ranges) {
        const bool is_value = std::ranges::any_of(range.values, [&](const auto& value) { return value.iri == a; });
        if (is_value && (b == range.iri || is_core_term(b, "Feature"))) return true;
        if (a == range.iri && is_core_term(b, "Feature")) return true;
    }
    return false;
}

/// Every name that the spaces of a sort know, sorted.
std::vector<Iri> names_of(const Domain& domain, Sort sort) {
    std::vector<Iri> names;
    for (const Space* space : spaces_of(domain, sort))
        for (const Concept& each : space->concepts) names.push_back(each.iri);
    std::ranges::sort(names);
    names.erase(std::unique(names.begin(), names.end()), names.end());
    return names;
}

bool is_unsatisfiable(const Domain& domain, Sort sort, const Iri& iri) {
    return std::ranges::all_of(spaces_of(domain, sort),
                               [&](const Space* space) { return where_in(*space, iri).is_empty(); });
}

}  // namespace

std::string why_not_counted(const Space& space) {
    if (!space.diagram || space.diagram->sample() == nullptr) return {};
    std::string why = space.diagram->sample()->why();
    if (const std::size_t end = why.find(';'); end != std::string::npos) why.resize(end);
    return "the configurations of a region are not counted, since " + why +
           "; a solver tells what is possible and what follows, and questions are chosen by samples";
}

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
    for (const CompositeSpace& composite : composites)
        if (composite.space.find(iri)) return composite.layer;
    if (is_object_concept(*this, iri)) return object_layer();
    for (const RangeConcept& range : ranges)
        if (range.iri == iri || std::ranges::any_of(range.values, [&](const auto& value) { return value.iri == iri; }))
            return 0;
    if (std::ranges::any_of(relations, [&](const Relation& relation) { return relation.iri == iri; })) return 0;
    return -1;
}

int Domain::object_layer() const {
    int highest = 1;
    for (const CompositeSpace& composite : composites) highest = std::max(highest, composite.layer);
    return highest + 1;
}

std::vector<Iri> Domain::most_specific(const std::vector<Iri>& iris) const {
    const auto is_diagnosis = [&](const Iri& iri) {
        return is_core_term(iri, "Incompatible") || is_incompatible(*this, iri);
    };
    std::vector<Iri> kept;
    for (const Iri& iri : iris) {
        const bool hidden = std::ranges::any_of(iris, [&](const Iri& other) {
            return other != iri && is_diagnosis(other) == is_diagnosis(iri) && is_below(*this, other, iri) &&
                   !is_below(*this, iri, other);
        });
        if (!hidden) kept.push_back(iri);
    }
    return kept;
}

std::vector<std::pair<Iri, Iri>> Domain::hierarchy() const {
    std::vector<std::pair<Iri, Iri>> pairs = told_relations(ontology);
    for (const RangeConcept& range : find_ranges(ontology)) {  // those that the domain does not speak of, too
        pairs.emplace_back(range.iri, core_term("Feature"));
        for (const ElementaryConcept& value : range.values) {
            pairs.emplace_back(value.iri, range.iri);
            pairs.emplace_back(value.iri, core_term("Feature"));
        }
    }
    for (const Sort sort : all_sorts) {
        const Iri top = core_term(top_of(sort));
        const std::vector<const Space*> spaces = spaces_of(*this, sort);
        const auto is_everywhere_below = [&](const auto& below) { return std::ranges::all_of(spaces, below); };
        const std::vector<Iri> names = names_of(*this, sort);
        for (const Iri& a : names) {
            if (is_unsatisfiable(*this, sort, a)) continue;
            pairs.emplace_back(a, top);
            if (is_everywhere_below([&](const Space* space) { return space->all().is_subset_of(where_in(*space, a)); }))
                pairs.emplace_back(top, a);
            if (is_below(*this, a, core_term("Incompatible"))) pairs.emplace_back(a, core_term("Incompatible"));
            for (const Iri& b : names)
                if (a != b && is_everywhere_below([&](const Space* space) {
                        return where_in(*space, a).is_subset_of(where_in(*space, b));
                    }))
                    pairs.emplace_back(a, b);
        }
    }
    std::ranges::sort(pairs);
    return pairs;
}

std::vector<Iri> Domain::unsatisfiable() const {
    std::vector<Iri> names;
    for (const Sort sort : all_sorts)
        for (const Iri& iri : names_of(*this, sort))
            if (is_unsatisfiable(*this, sort, iri)) names.push_back(iri);
    std::ranges::sort(names);
    return names;
}

}  // namespace partonomy::knowledge
