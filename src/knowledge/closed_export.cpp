/* The closed knowledge base in plain OWL 2, so that any reasoner can be asked the same questions. "There are no other
   individuals" is owl:Thing EquivalentTo {…}; that data properties may have any literal is what OWL says anyway. */

#include <algorithm>
#include <map>
#include <set>

#include "base/errors.h"
#include "knowledge/closed_world.h"
#include "knowledge/data_cells.h"
#include "owl/make_class.h"
#include "owl/words.h"

namespace partonomy::knowledge {
namespace {

using owl::ClassExpression;
using owl::ClassPointer;

bool is_anonymous(const Iri& iri) { return iri.starts_with("_:"); }

/// owl:oneOf wants names.
Iri name_of(const Iri& iri) { return is_anonymous(iri) ? "urn:anonymous:" + iri.substr(2) : iri; }

class Closer {
public:
    [[nodiscard]] owl::Axiom closed(owl::Axiom axiom) const {
        for (ClassPointer& expression : axiom.classes) expression = closed(expression);
        for (Iri& iri : axiom.individuals) iri = name_of(iri);
        axiom.range = range_of(axiom.range);
        if (axiom.rule != nullptr) {
            auto rule = std::make_shared<owl::Rule>(*axiom.rule);
            for (auto* side : {&rule->body, &rule->head})
                for (owl::RuleAtom& atom : *side) close(atom);
            axiom.rule = std::move(rule);
        }
        return axiom;
    }

private:
    [[nodiscard]] static owl::DataRange range_of(const owl::DataRange& range) {
        try {
            return closed::with_typed_facets(range);
        } catch (const closed::CannotGround&) {
            return range;  // to export is not to judge
        }
    }

    void close(owl::RuleAtom& atom) const {
        if (atom.klass != nullptr) atom.klass = closed(atom.klass);
        atom.range = range_of(atom.range);
        for (owl::RuleTerm& term : atom.arguments)
            if (term.kind == owl::RuleTerm::Kind::individual) term.iri = name_of(term.iri);
    }

    [[nodiscard]] ClassPointer closed(const ClassPointer& expression) const {
        auto result = std::make_shared<ClassExpression>(*expression);
        for (ClassPointer& operand : result->operands) operand = closed(operand);
        for (Iri& iri : result->individuals) iri = name_of(iri);
        result->range = range_of(result->range);
        return result;
    }
};

/// Whether an axiom says nothing: what is left where names were replaced by what they stand for.
bool is_idle(const owl::Axiom& axiom) {
    const Iri thing = owl::thing()->iri;
    switch (axiom.kind) {
        case owl::AxiomKind::sub_class_of:
            return axiom.classes[0]->iri == thing && axiom.classes[1]->iri == thing;
        case owl::AxiomKind::equivalent_object_properties:
        case owl::AxiomKind::equivalent_data_properties:
            return std::ranges::all_of(axiom.properties, [&](const auto& each) { return each == axiom.properties[0]; });
        case owl::AxiomKind::inverse_object_properties:
            return axiom.properties[0].iri == axiom.properties[1].iri &&
                   axiom.properties[0].inverse != axiom.properties[1].inverse;
        default:
            return false;
    }
}

/// The same in axioms that OWL has: a disjoint union is of a name there.
std::vector<owl::Axiom> in_owl(const owl::Axiom& axiom) {
    if (is_idle(axiom)) return {};
    if (axiom.kind != owl::AxiomKind::disjoint_union || axiom.classes[0]->kind == owl::ClassKind::named) return {axiom};
    std::vector<ClassPointer> members(axiom.classes.begin() + 1, axiom.classes.end());
    owl::Axiom whole = axiom, apart = axiom;
    whole.kind = owl::AxiomKind::equivalent_classes;
    whole.classes = {axiom.classes[0],
                     members.size() == 1 ? members[0] : owl::combined(owl::ClassKind::union_of, members)};
    apart.kind = owl::AxiomKind::disjoint_classes;
    apart.classes = members;
    if (members.size() < 2) return {whole};
    return {whole, apart};
}

ClassPointer one_of(std::vector<Iri> individuals) {
    auto result = std::make_shared<ClassExpression>();
    result->kind = owl::ClassKind::one_of;
    result->individuals = std::move(individuals);
    return result;
}

/// "x: p only {…}" for who has values of the (inverse) property, "{…} SubClassOf: p max 0" for the others.
void close_property(const ClosedWorld::Known& known, bool inverse, owl::Ontology& result) {
    std::map<Iri, std::vector<Iri>> related;
    for (const auto& [subject, object] : known.possible)
        related[name_of(inverse ? object : subject)].push_back(name_of(inverse ? subject : object));
    std::vector<Iri> others;
    for (const Iri& iri : known.among) {
        const auto found = related.find(name_of(iri));
        if (found == related.end()) {
            others.push_back(name_of(iri));
            continue;
        }
        auto only = std::make_shared<ClassExpression>();
        only->kind = owl::ClassKind::all_values_from;
        only->property = {known.property, inverse};
        only->operands = {one_of(found->second)};
        owl::Axiom axiom{};
        axiom.kind = owl::AxiomKind::class_assertion;
        axiom.classes = {only};
        axiom.individuals = {found->first};
        result.axioms.push_back(std::move(axiom));
    }
    if (others.empty()) return;
    auto none = std::make_shared<ClassExpression>();
    none->kind = owl::ClassKind::all_values_from;
    none->property = {known.property, inverse};
    none->operands = {owl::named_class(std::string(owl::owl_prefix) + "Nothing")};
    owl::Axiom axiom{};
    axiom.kind = owl::AxiomKind::sub_class_of;
    axiom.classes = {one_of(std::move(others)), none};
    result.axioms.push_back(std::move(axiom));
}

}  // namespace

owl::Ontology closed_ontology(const ClosedWorld& world) {
    std::set<Iri> everybody(world.individuals.begin(), world.individuals.end());
    for (const Iri& iri : individuals_of(world.ontology)) everybody.insert(name_of(iri));
    if (everybody.empty())
        throw UsageError("a closed world needs at least one individual, and the ontology names none; add one");

    owl::Ontology result = world.ontology;
    result.axioms.clear();
    for (const owl::Axiom& axiom : world.ontology.axioms)
        for (owl::Axiom& each : in_owl(axiom)) result.axioms.push_back(Closer().closed(std::move(each)));
    std::erase_if(result.entities, [](const owl::Entity& entity) { return is_anonymous(entity.iri); });
    result.annotations.clear();
    for (const auto& [iri, annotations] : world.ontology.annotations) {
        std::vector<owl::Annotation>& copies = result.annotations[name_of(iri)] = annotations;
        for (owl::Annotation& annotation : copies) annotation.iri = name_of(annotation.iri);
    }
    for (const Iri& iri : everybody)
        if (result.find(iri, owl::EntityKind::individual) == nullptr) {
            const auto place =
                std::ranges::lower_bound(result.entities, std::tuple(iri, owl::EntityKind::individual), {},
                                         [](const owl::Entity& entity) { return std::tuple(entity.iri, entity.kind); });
            result.entities.insert(place, {owl::EntityKind::individual, iri, {}});
        }

    const ClassPointer all = one_of({everybody.begin(), everybody.end()});
    owl::Axiom closure{};
    closure.kind = owl::AxiomKind::equivalent_classes;
    closure.classes = {owl::thing(), all};
    result.axioms.push_back(std::move(closure));

    for (const ClosedWorld::Known& known : world.known)
        for (const bool inverse : {false, true}) close_property(known, inverse, result);

    std::set<Iri> different;
    for (const Iri& iri : world.individuals) different.insert(name_of(iri));
    if (different.size() > 1) {
        owl::Axiom axiom{};
        axiom.kind = owl::AxiomKind::different_individuals;
        axiom.individuals.assign(different.begin(), different.end());
        result.axioms.push_back(std::move(axiom));
    }
    return result;
}

}  // namespace partonomy::knowledge
