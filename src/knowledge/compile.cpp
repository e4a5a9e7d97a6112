#include <algorithm>

#include "base/errors.h"
#include "knowledge/assembly.h"
#include "knowledge/causes.h"
#include "knowledge/concept_relations.h"
#include "knowledge/mesh_world.h"
#include "knowledge/plain.h"

// The road from an ontology to its configuration spaces: levels and formulas (theory.cpp), the space of one region
// (region_space.cpp), what composite parts there are and what objects count (assembly.cpp); then what the expert should
// know about it. A space only holds what the axioms allow; what an Incompatible concept forbids stays in it and is left
// out of `possible`, so that an impossible object can be recognised and explained. The space of one object
// (object_space.cpp) is a product of everything that objects count, and one mesh reaches little of it: it is listed
// when somebody wants to see it, while conclude() makes the part that it needs. Furniture takes about half a
// millisecond.

namespace partonomy::knowledge {
namespace {

/// The file that was asked for: its axioms come last.
std::string main_file(const owl::Ontology& ontology) {
    return ontology.axioms.empty() ? ontology.iri : ontology.axioms.back().source.file;
}

std::string quoted(const owl::Axiom& axiom) {
    std::string text(1, '"');
    return text.append(to_manchester(axiom)).append(1, '"');
}

/// Names axioms that together leave nothing.
[[noreturn]] void refuse_inconsistent(const owl::Ontology& ontology, const Theory& theory, Level level) {
    const std::string what = level == Level::region ? "region" : "object";
    const std::vector<Cause> causes = causes_of_nothing(theory, level, 1);
    if (causes.empty())
        throw OntologyError(
            at(main_file(ontology), 0, "its axioms leave no " + what + " possible; weaken one of them."));
    const owl::Axiom& last = ontology.axioms[causes[0].back()];
    std::string others;
    for (std::size_t i = 0; i + 1 < causes[0].size(); ++i) {
        const owl::Axiom& other = ontology.axioms[causes[0][i]];
        others.append(i == 0 ? ", together with " : " and ");
        others.append(at(other.source.file, other.source.line, quoted(other)));
    }
    const std::string sentence = quoted(last).append(" leaves no ").append(what).append(" possible").append(others);
    throw OntologyError(at(last.source.file, last.source.line, sentence + "; weaken one of them."));
}

/// The configurations of which some twin, that differs in primitive concepts only, lies in `set`.
ConfigurationSet blurred(const Space& space, const ConfigurationSet& set) {
    ConfigurationSet starts(space.size);  // primitive variables vary fastest: twins are neighbours
    if (space.size > 0) starts.insert(0);
    for (std::size_t v = 0; v < space.variables.size(); ++v) {
        if (space.variables[v].kind == VariableKind::primitive) continue;
        for (const ConfigurationSet& value : space.holds[v])
            value.for_each([&](std::size_t i) {
                if (i > 0 && !value.has(i - 1)) starts.insert(i);
            });
    }
    ConfigurationSet result(space.size);
    std::size_t start = 0;
    const auto close = [&](std::size_t end) {
        bool any = false;
        for (std::size_t i = start; i < end; ++i) any |= set.has(i);
        for (std::size_t i = start; any && i < end; ++i) result.insert(i);
        start = end;
    };
    starts.for_each(close);
    close(space.size);
    return result;
}

/// Whether the definition of a concept of regions speaks of relations to other regions.
bool rests_on_relations(const Theory& theory, int id) {
    std::vector<char> seen(theory.concepts.size(), 0);
    const auto visit = [&](const auto& self, FormulaId formula_id) -> bool {
        const Formula& formula = theory.formulas[formula_id];
        if (formula.kind == Formula::Kind::choice)
            return static_cast<std::size_t>(formula.index) >= theory.ranges.size() + theory.numbers.size();
        if (formula.kind == Formula::Kind::named && !seen[formula.index]) {
            seen[formula.index] = 1;
            const FormulaId definition = theory.concepts[formula.index].definition;
            return definition >= 0 && self(self, definition);
        }
        return std::ranges::any_of(formula.operands, [&](FormulaId operand) { return self(self, operand); });
    };
    return !theory.relational.empty() && theory.concepts[id].definition >= 0 &&
           visit(visit, theory.concepts[id].definition);
}

void finish_space(const Theory& theory, const Scope& scope, Subject subject, const Layer& layer, Space& space) {
    space = layer.space;
    space.possible = space.all();
    const bool has_primitives = std::ranges::any_of(
        space.variables, [](const Variable& variable) { return variable.kind == VariableKind::primitive; });
    const bool are_few = theory.concepts.size() <= most_compared;
    std::vector<char> proved;
    if (has_primitives && space.diagram && are_few) proved = provable_regions(theory, scope);
    for (std::size_t id = 0; id < theory.concepts.size(); ++id) {
        const NamedConcept& named = theory.concepts[id];
        if (!subject.has(named) || named.open) continue;
        const ConfigurationSet& where = layer.concepts[id];
        bool provable = where.is_empty() ? named.definition >= 0 : true;
        if (has_primitives && provable && !are_few)
            provable = named.definition >= 0;
        else if (has_primitives && provable && space.diagram)
            provable = proved[id] != 0;
        else if (has_primitives && provable)
            provable = !(where - blurred(space, where.complement())).is_empty();
        if (named.incompatible) space.possible -= where;
        space.concepts.push_back(
            {named.iri, where, named.incompatible, provable, rests_on_relations(theory, static_cast<int>(id))});
    }
}

constexpr std::size_t most_concepts = 10'000;  // memory grows with their square: 8,000 take 1.1 GB

/// Runs `work`; an error without a place gets the file's.
template <typename Work>
void placed_in(const std::string& file, const Work& work) {
    try {
        work();
    } catch (const OntologyError& error) {
        const std::string sentence = error.what();
        const bool placed = sentence.find(": ") != std::string::npos;
        throw OntologyError(placed ? sentence : at(file, 0, sentence + "."));
    }
}

/// Whether an object of no part or of one obeys the axioms; most ontologies allow something as simple.
bool allows_simple_objects(const Grounding& grounding) {
    if (std::ranges::none_of(grounding.theory.constraints,
                             [](const Constraint& constraint) { return constraint.level == Level::object; }))
        return true;
    const Parts& parts = grounding.assembly.parts;
    if (!parts.fits) return false;
    std::vector<Counts> counts{0};
    if (!grounding.assembly.has_composites()) {
        counts = with_one_more(parts, counts, types_within(parts, grounding.regions));
        counts.insert(counts.begin(), 0);
        counts.erase(std::unique(counts.begin(), counts.end()), counts.end());
    }
    return build_objects(grounding.theory, grounding.scope, {}, parts, std::move(counts),
                         grounding.options.configuration_limit)
               .layer.space.size > 0;
}

/// What a user of one layer should know, in the expert's words; lint.h tells an expert more.
void lint(const owl::Ontology& ontology, const Theory& theory, const Space& space, const std::string& what,
          std::vector<std::string>& warnings) {
    for (const Concept& each : space.concepts) {
        const std::string name = owl::local_name(each.iri);
        const bool defined = theory.concepts[theory.find(each.iri)].definition >= 0;
        if (each.where.is_empty())
            warnings.push_back("No " + what + " can be " + with_article(name) + ": its axioms contradict each other.");
        else if (is_told_by_rule(ontology, each.iri))
            continue;
        else if (!each.provable && !defined)
            warnings.push_back(name + " has only necessary conditions, so no " + what + " can ever be proved to be " +
                               with_article(name) + "; did you mean EquivalentTo?");
        else if (!each.provable)
            warnings.push_back("No " + what + " can ever be proved to be " + with_article(name) +
                               ", because its definition rests on a concept that has none.");
    }
}

void finish_composites(const Grounding& grounding, Domain& domain) {
    for (std::size_t g = 0; g < domain.composites.size(); ++g) {
        const CompositeLayer& made = grounding.assembly.composites[g];
        CompositeSpace& composite = domain.composites[g];
        composite.regions = made.regions;
        for (const int inner : grounding.theory.groups[g].inner)
            composite.layer = std::max(composite.layer, domain.composites[static_cast<std::size_t>(inner)].layer + 1);
        std::vector<const ConfigurationSet*> conditions{&made.regions};
        for (const Parts::PartClass& part : made.parts.classes) conditions.push_back(&part.where);
        for (const ConfigurationSet* condition : conditions)
            if (!condition->is_empty() &&
                std::ranges::find(domain.composite_conditions, *condition) == domain.composite_conditions.end())
                domain.composite_conditions.push_back(*condition);
    }
}

/// Concepts that say what they consist of in their own space; the others once, for all spaces together.
void lint_composites(const owl::Ontology& ontology, const Theory& theory, Domain& domain) {
    for (const CompositeSpace& composite : domain.composites) {
        Space own = composite.space;
        std::erase_if(own.concepts,
                      [&](const Concept& each) { return theory.concepts[theory.find(each.iri)].group < 0; });
        lint(ontology, theory, own, "composite part", domain.warnings);
    }
    const auto is_unsatisfiable = [&](const Iri& iri) {
        return std::ranges::all_of(domain.composites, [&](const CompositeSpace& composite) {
            const std::optional<ConceptId> id = composite.space.find(iri);
            return !id || composite.space.concepts[*id].where.is_empty();
        });
    };
    for (const NamedConcept& named : theory.concepts) {
        if (named.level != Level::composite || named.group >= 0 || named.open) continue;
        const std::string name = owl::local_name(named.iri);
        if (named.definition < 0)
            domain.warnings.push_back(name +
                                      " has only necessary conditions, so no composite part can ever be proved to be " +
                                      with_article(name) + "; did you mean EquivalentTo?");
        else if (is_unsatisfiable(named.iri))
            domain.warnings.push_back("No composite part can be " + with_article(name) +
                                      ": no hasPart says what it consists of, or its axioms contradict each other.");
    }
}

}  // namespace

const Grounding::Listing& Grounding::objects() const {
    std::call_once(once_, [&] {
        placed_in(file, [&] {
            const std::size_t limit = options.configuration_limit;
            Listing made;
            try {
                if (!assembly.parts.fits) throw OntologyError(too_many_classes(assembly.parts));
                made.layer = build_objects(theory, scope, {}, assembly.parts,
                                           possible_counts(theory, assembly, regions, false, limit), limit);
            } catch (const OntologyError& limit_reached) {
                if (assembly.has_composites()) throw;
                made.space = objects_by_solver(theory, scope, assembly.parts, {}, false, limit_reached.what());
                listing_ = std::move(made);
                return;
            }
            finish_space(theory, scope, {}, made.layer.layer, made.space);
            if (possible_regions != regions || assembly.has_composites())
                made.space.possible &= made.layer.of(possible_counts(theory, assembly, possible_regions, true, limit));
            listing_ = std::move(made);
        });
    });
    return listing_;
}

const Contributions& Grounding::contributions() const {
    std::call_once(contributions_once_, [&] { contributions_ = find_contributions(assembly, regions); });
    return *contributions_;
}

const Space& Domain::objects() const { return grounding->objects().space; }

std::vector<std::string> Domain::object_warnings() const {
    std::vector<std::string> found;
    lint(ontology, grounding->theory, objects(), "object", found);
    return found;
}

Domain compile(owl::Ontology ontology, const CompileOptions& options) {
    auto grounding = std::make_shared<Grounding>();
    Domain domain;
    grounding->options = options;
    grounding->theory = read_theory(ontology);
    const Theory& theory = grounding->theory;
    const std::string& file = grounding->file = main_file(ontology);
    if (std::ranges::none_of(theory.concepts, [](const NamedConcept& named) { return named.level == Level::object; }))
        throw OntologyError(
            at(file, 0, "no concept describes an object; put at least one below core:Object, with its hasPart."));
    if (theory.concepts.size() > most_concepts)
        throw OntologyError(
            at(file, 0,
               "these are " + std::to_string(theory.concepts.size()) + " concepts, and more than " +
                   std::to_string(most_concepts) +
                   " cannot be compiled together; part the ontology, or leave out what no axiom uses."));
    Layer regions;
    placed_in(file, [&] {
        const Scope& scope = grounding->scope = whole_scope(theory, ontology.axioms.size());
        regions = build_regions(theory, scope, options);
        if (regions.space.size == 0) refuse_inconsistent(ontology, theory, Level::region);
        finish_space(theory, scope, {Level::region, -1}, regions, domain.regions);
        grounding->regions = domain.regions.all();
        grounding->possible_regions = domain.regions.possible;
        grounding->assembly = assemble(theory, scope, regions, options.configuration_limit);
        const Assembly& assembly = grounding->assembly;
        for (std::size_t g = 0; g < assembly.composites.size(); ++g)
            finish_space(theory, scope, {Level::composite, static_cast<int>(g)}, assembly.composites[g].objects.layer,
                         domain.composites.emplace_back().space);
        if (!allows_simple_objects(*grounding) && grounding->objects().space.size == 0)
            refuse_inconsistent(ontology, theory, Level::object);
    });
    const Parts& parts = grounding->assembly.parts;
    for (const Parts::Atom& atom : parts.atoms) domain.part_conditions.push_back(parts.classes[atom.part].where);
    for (const NamedConcept& named : theory.concepts)
        if (named.level == Level::object && named.definition < 0)
            domain.part_conditions.push_back(domain.regions.none());
    finish_composites(*grounding, domain);
    domain.ranges = theory.ranges;
    domain.numbers = theory.numbers;
    domain.typical_heights = find_typical_heights(ontology);
    domain.is_about_scenes = is_about_scenes(ontology);
    domain.warnings = theory.warnings;
    domain.relations = theory.relations;
    domain.relational = theory.relational;
    for (std::size_t i = 0; i < theory.relational.size(); ++i)
        for (const FormulaId formula : theory.relational_classes[i])
            domain.relational[i].classes.push_back(evaluate(theory, regions, formula));
    for (const Variable& variable : domain.regions.variables)
        if (variable.kind == VariableKind::relation && !variable.answerable)
            domain.warnings.push_back("No criterion tells whether \"" + to_manchester(*variable.part_class) +
                                      "\" holds, so nothing can answer it and it stays open.");
    for (const MeasuredProperty& number : theory.numbers)
        if (number.measure.empty())
            domain.warnings.push_back(owl::local_name(number.iri) +
                                      " has no core:measure, so nothing can answer it and its restrictions stay open.");
    for (const RangeConcept& range : theory.ranges)
        if (range.values.empty())
            domain.warnings.push_back(owl::local_name(range.iri) + " has no values; put classes below it.");
    if (const std::string why = why_not_counted(domain.regions); !why.empty()) domain.warnings.push_back(why + ".");
    lint(ontology, theory, domain.regions, "region", domain.warnings);
    lint_composites(ontology, theory, domain);
    domain.ontology = std::move(ontology);
    domain.grounding = std::move(grounding);
    if (domain.grounding->theory.needs_world()) MeshReasoner(domain, {1, true, {}, {}});  // refused now, not later
    return domain;
}

}  // namespace partonomy::knowledge
