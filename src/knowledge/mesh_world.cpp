/* From a domain and what is known of a mesh to a closed world (closed_world.h).

   Everything that a mesh is made of gets a name. Parts and features are known: who is a part of whom, and which value
   node is whose, is told pair by pair, and that there are no other pairs. What class a value belongs to is what answers
   tell, "part1 is in (hasShape some Board)"; before, it is open. Nothing else is closed: of each property that nothing
   measures we only know what the ontology says. Since a closed world has no others than those named, some nameless
   "things" are added that such properties may lead to, one for each restriction that wants one (16 at most): else
   "designedBy some Designer" would make a chair impossible, where nobody has named a designer.

   A range concept that is not covered has disjoint values. A name stands for one thing, unless SameIndividual says
   otherwise. */

#include "knowledge/mesh_world.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "knowledge/assembly.h"
#include "knowledge/mesh_words.h"
#include "knowledge/plain.h"
#include "owl/make_class.h"
#include "owl/words.h"

namespace partonomy::knowledge {
namespace {

using owl::Axiom;
using owl::AxiomKind;
using owl::ClassExpression;
using owl::ClassKind;
using owl::ClassPointer;

constexpr std::size_t most_things = 16;

ClassPointer some(const Iri& property, const ClassPointer& filler) {
    auto expression = std::make_shared<ClassExpression>();
    expression->kind = ClassKind::some_values_from;
    expression->property.iri = property;
    expression->operands = {filler};
    return expression;
}

std::string number_text(double x) {
    char buffer[32];
    return {buffer, std::to_chars(buffer, buffer + sizeof buffer, x).ptr};
}

class Builder {
public:
    Builder(const Domain& domain, const Knowledge& knowledge, const std::vector<CompositePart>& composites)
        : domain_(domain),
          result_{{plain_ontology(domain.ontology), {}}, {}, {}, {}, {}, 0, {}},
          rewrite_(domain, result_.world.ontology) {
        for (Axiom& axiom : axioms()) axiom = rewrite_(std::move(axiom));
        result_.object = add("object");
        for (int region = 0; region < knowledge.region_count; ++region)
            result_.regions.push_back(add("part" + std::to_string(region + 1)));
        for (std::size_t i = 0; i < composites.size(); ++i)
            result_.composites.push_back(add("composite" + std::to_string(i + 1)));
        result_.first_answer = axioms().size();
        for (const Answer& answer : knowledge.answers) {
            const ClassPointer said = rewrite_(in_words(answer.question));
            is_a(result_.regions[static_cast<std::size_t>(answer.region)],
                 answer.yes ? said : owl::complement_of(said));
        }
        declare(mesh_class(), owl::EntityKind::klass);
        for (const Iri& iri : std::vector(result_.world.individuals)) is_a(iri, owl::named_class(mesh_class()));
        tell_parts(composites);
        for (const RangeConcept& range : domain.ranges) tell_feature(range);
        for (const MeasuredProperty& number : domain.numbers) {
            auto any = std::make_shared<ClassExpression>();
            any->kind = ClassKind::data_some_values_from;
            any->property.iri = number.iri;
            any->range.datatype = std::string(owl::xsd_prefix) + "double";
            for (const Iri& region : result_.regions) is_a(region, any);
        }
        for (std::size_t i = 0; i < domain.relational.size(); ++i) declare(relation_class(i), owl::EntityKind::klass);
        add_things();
        for (ClosedWorld::Known& known : result_.world.known) known.among = result_.world.individuals;
        keep_from_values();
        add_names();
    }

    MeshWorld run() {
        for (const NamedConcept& each : domain_.grounding->theory.concepts)
            result_.open.push_back(each.open ? rewrite_(each.open) : nullptr);
        return std::move(result_);
    }

private:
    [[nodiscard]] std::vector<Axiom>& axioms() { return result_.world.ontology.axioms; }

    Iri add(const std::string& name) {
        Iri iri = mesh_prefix + name;
        result_.world.individuals.push_back(iri);
        declare(iri, owl::EntityKind::individual);
        return iri;
    }

    void declare(const Iri& iri, owl::EntityKind kind) {
        std::vector<owl::Entity>& entities = result_.world.ontology.entities;
        const auto place = std::ranges::lower_bound(entities, iri, {}, &owl::Entity::iri);
        if (place == entities.end() || place->iri != iri || place->kind != kind)
            entities.insert(place, {kind, iri, {}});
    }

    void is_a(const Iri& individual, const ClassPointer& expression) {
        Axiom axiom{};
        axiom.kind = AxiomKind::class_assertion;
        axiom.classes = {expression};
        axiom.individuals = {individual};
        axioms().push_back(std::move(axiom));
    }

    void relate(const Iri& subject, const Iri& property, const Iri& object) {
        Axiom axiom{};
        axiom.kind = AxiomKind::object_property_assertion;
        axiom.properties = {{property, false}};
        axiom.individuals = {subject, object};
        axioms().push_back(std::move(axiom));
        result_.world.known.back().possible.emplace_back(subject, object);
    }

    /// What "yes" to a question says of a region; see yes_set.
    [[nodiscard]] ClassPointer in_words(Question question) const {
        const Variable& variable = domain_.regions.variables[static_cast<std::size_t>(question.variable)];
        const auto value = static_cast<std::size_t>(question.value);
        ClassPointer said = variable.part_class;
        if (variable.kind == VariableKind::range) {
            const RangeConcept& range = domain_.ranges[static_cast<std::size_t>(variable.index)];
            if (value < range.values.size()) return some(range.property, owl::named_class(range.values[value].iri));
            std::vector<ClassPointer> others;
            for (const ElementaryConcept& each : range.values) others.push_back(owl::named_class(each.iri));
            return owl::complement_of(some(range.property, owl::combined(ClassKind::union_of, std::move(others))));
        }
        if (variable.kind == VariableKind::number) {
            const MeasuredProperty& number = domain_.numbers[static_cast<std::size_t>(variable.index)];
            const MeasuredProperty::Interval& interval = number.intervals[value];
            const std::string xsd = owl::xsd_prefix;
            auto up_to = std::make_shared<ClassExpression>();
            up_to->kind = ClassKind::data_some_values_from;
            up_to->property.iri = number.iri;
            up_to->range.datatype = xsd + "double";
            if (value + 1 < number.intervals.size())
                up_to->range.facets = {{xsd + (interval.high_closed ? "maxInclusive" : "maxExclusive"),
                                        {number_text(interval.high), xsd + "double", {}}}};
            return up_to;
        }
        if (variable.kind == VariableKind::primitive) said = owl::named_class(variable.iri);
        return value == 0 ? said : owl::complement_of(said);
    }

    void tell_parts(const std::vector<CompositePart>& composites) {
        is_a(result_.object, owl::named_class(core_term("Object")));
        for (const Iri& region : result_.regions) is_a(region, owl::named_class(core_term("Region")));
        const Iri has_part = core_term("hasPart");
        result_.world.known.push_back({has_part, {}, {}});
        for (const Iri& region : result_.regions) relate(result_.object, has_part, region);
        const std::vector<Group>& groups = domain_.grounding->theory.groups;
        tell_groups();
        for (std::size_t i = 0; i < composites.size(); ++i) {
            const Iri& composite = result_.composites[i];
            for (const char* layer : {"Object", "Region", "Feature"})  // even one that is not there (mesh_reasoner.cpp)
                is_a(composite, owl::complement_of(owl::named_class(core_term(layer))));
            const auto told = [&](int region, int inner) {
                result_.told_composites.push_back({axioms().size() - 1, i, region, inner});
            };
            is_a(composite, owl::named_class(core_term("CompositePart")));
            told(-1, -1);
            for (int g = 0; g < static_cast<int>(groups.size()); ++g) {
                const ClassPointer group = owl::named_class(group_class(g));
                is_a(composite, g == composites[i].group ? group : owl::complement_of(group));
                told(-1, -1);
            }
            relate(result_.object, has_part, composite);
            told(-1, -1);
            for (const int region : composites[i].regions) {
                relate(composite, has_part, result_.regions[static_cast<std::size_t>(region)]);
                told(region, -1);
            }
            for (std::size_t inner = 0; inner < i; ++inner)
                if (std::ranges::binary_search(groups[static_cast<std::size_t>(composites[i].group)].inner,
                                               composites[inner].group) &&
                    std::ranges::includes(composites[i].regions, composites[inner].regions)) {
                    relate(composite, has_part, result_.composites[inner]);
                    told(-1, static_cast<int>(inner));
                }
        }
    }

    /// A region is no composite part, and a concept of composite parts holds of those of its own groups only.
    void tell_groups() {
        const Theory& theory = domain_.grounding->theory;
        if (theory.groups.empty()) return;
        Axiom disjoint{};
        disjoint.kind = AxiomKind::disjoint_classes;
        for (const char* layer : {"Object", "Region", "CompositePart"})
            disjoint.classes.push_back(owl::named_class(core_term(layer)));
        axioms().push_back(std::move(disjoint));
        for (int g = 0; g < static_cast<int>(theory.groups.size()); ++g)
            declare(group_class(g), owl::EntityKind::klass);
        for (const NamedConcept& named : theory.concepts) {
            if (named.group < 0 || named.open) continue;
            Axiom axiom{};
            axiom.kind = AxiomKind::sub_class_of;
            axiom.classes = {owl::named_class(named.iri), owl::named_class(group_class(named.group))};
            axioms().push_back(std::move(axiom));
        }
    }

    void tell_feature(const RangeConcept& range) {
        result_.world.known.push_back({range.property, {}, {}});
        const std::string name = owl::local_name(range.iri);
        for (const Iri& region : result_.regions) {
            const Iri value = add(owl::local_name(region) + "." + name);
            values_.push_back(value);
            is_a(value, owl::named_class(range.iri));
            relate(region, range.property, value);
        }
        if (range.values.size() < 2) return;
        Axiom disjoint{};
        disjoint.kind = AxiomKind::disjoint_classes;
        for (const ElementaryConcept& value : range.values) disjoint.classes.push_back(owl::named_class(value.iri));
        if (!range.covered || std::ranges::any_of(range.values, [&](const ElementaryConcept& value) {
                return domain_.ontology.find(value.iri, owl::EntityKind::klass) == nullptr;
            }))
            axioms().push_back(std::move(disjoint));
    }

    /// How many different things properties that are not known may be wanted to lead to.
    [[nodiscard]] std::size_t things_wanted() const {
        std::set<Iri> known{std::string(owl::owl_prefix) + "topObjectProperty"};
        for (const ClosedWorld::Known& each : result_.world.known) known.insert(each.property);
        std::set<std::string> wanted;
        const auto look = [&](const auto& self, const ClassPointer& expression) -> void {
            for (const ClassPointer& operand : expression->operands) self(self, operand);
            if (expression->kind < ClassKind::some_values_from || is_data(expression->kind) ||
                expression->kind == ClassKind::has_value || expression->kind == ClassKind::has_self ||
                known.contains(expression->property.iri))
                return;
            for (unsigned i = 0; i < std::clamp<unsigned>(expression->number, 1, most_things); ++i)
                wanted.insert(key_of(*expression) + std::to_string(i));
        };
        for (const Axiom& axiom : result_.world.ontology.axioms)
            for (const ClassPointer& expression : axiom.classes) look(look, expression);
        return std::min(wanted.size(), most_things);
    }

    void add_things() {
        const std::size_t count = things_wanted();
        std::vector<ClassPointer> parts_of_a_mesh;
        for (const char* term : {"Object", "Region", "CompositePart", "Feature"})
            parts_of_a_mesh.push_back(owl::named_class(core_term(term)));
        const ClassPointer part_of_a_mesh = owl::combined(ClassKind::union_of, std::move(parts_of_a_mesh));
        for (std::size_t i = 0; i < count; ++i)
            is_a(add("thing" + std::to_string(i + 1)), owl::complement_of(part_of_a_mesh));
    }

    /// Nothing leads to a value of a feature, or from it, but what an axiom may lead there: properties above those of
    /// features, conclusions of chains and rules, what relates everything to itself, and what axioms about features ask
    /// for.
    void keep_from_values() {
        const owl::Ontology& ontology = result_.world.ontology;
        std::set<Iri> free{std::string(owl::owl_prefix) + "topObjectProperty",
                           std::string(owl::owl_prefix) + "bottomObjectProperty"};
        for (const ClosedWorld::Known& known : result_.world.known) free.insert(known.property);
        for (const Axiom& axiom : axioms()) {
            if ((axiom.kind == AxiomKind::sub_object_property_of && axiom.properties.size() > 2) ||
                axiom.kind == AxiomKind::reflexive_object_property)
                free.insert(axiom.properties.back().iri);
            if (axiom.kind == AxiomKind::rule)
                for (const owl::RuleAtom& atom : axiom.rule->head) free.insert(atom.property.iri);
            const Level level = rewrite_.level_of_axiom(axiom);
            if (level > Level::relation || (level == Level::unknown && !axiom.properties.empty())) continue;
            const auto look = [&](const auto& self, const ClassExpression& expression) -> void {
                free.insert(expression.property.iri);
                for (const ClassPointer& operand : expression.operands) self(self, *operand);
            };
            for (const ClassPointer& expression : axiom.classes) look(look, *expression);
            for (const owl::PropertyExpression& property : axiom.properties)
                if (!axiom.classes.empty()) free.insert(property.iri);
        }
        const PropertyHierarchy hierarchy(ontology);
        for (const Iri& property : std::vector(free.begin(), free.end()))
            for (const auto& [above, axiom] : hierarchy.above({property, false})) free.insert(above.iri);
        for (const owl::Entity& entity : ontology.entities)
            if (entity.kind == owl::EntityKind::object_property && !free.contains(entity.iri))
                result_.world.known.push_back({entity.iri, values_, {}});
    }

    /// The ontology's own names, one for each thing that several are told to be.
    void add_names() {
        std::map<Iri, Iri> first;
        const auto find = [&](Iri iri) {
            for (auto up = first.find(iri); up != first.end(); up = first.find(iri)) iri = up->second;
            return iri;
        };
        for (const Axiom& axiom : axioms())
            if (axiom.kind == AxiomKind::same_individual)
                for (std::size_t i = 1; i < axiom.individuals.size(); ++i) {
                    const Iri a = find(axiom.individuals[i - 1]), b = find(axiom.individuals[i]);
                    if (a != b) first[std::max(a, b)] = std::min(a, b);
                }
        std::set<Iri> own(result_.world.individuals.begin(), result_.world.individuals.end());
        for (const Iri& iri : individuals_of(result_.world.ontology))
            if (find(iri) == iri && own.insert(iri).second) result_.world.individuals.push_back(iri);
    }

    const Domain& domain_;
    std::vector<Iri> values_;  ///< of features
    MeshWorld result_;
    MeshWords rewrite_;
};

}  // namespace

MeshWorld make_mesh_world(const Domain& domain, const Knowledge& knowledge,
                          const std::vector<CompositePart>& composites) {
    return Builder(domain, knowledge, composites).run();
}

std::optional<std::vector<CompositePart>> composites_for_world(const Domain& domain, const Knowledge& knowledge) {
    if (!domain.grounding->assembly.has_composites()) return std::vector<CompositePart>{};
    return certain_composites(domain, knowledge);
}

std::vector<CompositePart> candidate_composites(const Domain& domain, const Knowledge& knowledge) {
    std::vector<std::vector<int>> beside(static_cast<std::size_t>(knowledge.region_count));
    for (const auto& [a, b] : knowledge.connected) {
        beside[static_cast<std::size_t>(a)].push_back(b);
        beside[static_cast<std::size_t>(b)].push_back(a);
    }
    std::vector<CompositePart> candidates;
    for (int group = 0; group < static_cast<int>(domain.composites.size()); ++group)
        for (int first = 0; first < knowledge.region_count; ++first) {
            std::vector<int> reached{first};
            for (std::size_t at = 0; at < reached.size(); ++at)
                for (const int next : beside[static_cast<std::size_t>(reached[at])])
                    if (next > first && std::ranges::count(reached, next) == 0) reached.push_back(next);
            std::ranges::sort(reached);
            candidates.push_back({group, std::move(reached), {}});
        }
    return candidates;
}

bool needs_mesh_world(const Domain& domain, const Knowledge& knowledge) {
    return knowledge.complete && domain.grounding->theory.needs_world() &&
           composites_for_world(domain, knowledge).has_value();
}

}  // namespace partonomy::knowledge
