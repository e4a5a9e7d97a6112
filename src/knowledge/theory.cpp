#include "knowledge/theory.h"

#include <algorithm>

#include "base/errors.h"
#include "base/spelling.h"
#include "knowledge/groups.h"
#include "knowledge/lint.h"
#include "knowledge/plain.h"

// From axioms to definitions and constraints. A named class is defined by its first EquivalentTo with an expression,
// else by a synonym, else by its DisjointUnion; what is left of these axioms, and every other one, is a constraint: a
// formula that holds in each configuration. A class without definition is primitive. Definitions must not run in
// circles, so that every class can be evaluated from features and part counts upwards.

namespace partonomy::knowledge {
namespace {

using owl::Axiom;
using owl::AxiomKind;
using owl::ClassKind;
using owl::ClassPointer;

constexpr std::size_t deepest_definition = 500;  ///< definitions that rest on each other, one in the next

class TheoryReader {
public:
    explicit TheoryReader(owl::Ontology plain)
        : ontology_(std::move(plain)),
          theory_(start(ontology_)),
          levels_(find_levels(ontology_, theory_.ranges)),
          grounder_(ontology_, levels_, theory_) {
        for (const auto& [iri, level] : levels_)
            if (level > Level::relation && !is_core_term(iri, "Region") && !is_core_term(iri, "CompositePart") &&
                !is_core_term(iri, "Object"))
                theory_.concepts.push_back({iri, level, false, -1, 0, -1});
    }

    Theory run() {
        for (std::size_t i = 0; i < ontology_.axioms.size(); ++i) read(i);
        for (const std::size_t i : synonyms_) read_synonyms(i);
        for (const std::size_t i : unions_) read_union(i);
        return run_on();
    }

    /// What comes when all axioms are read.
    Theory run_on() {
        refuse_circles();
        spread_incompatible();
        find_groups(theory_, grounder_, mentions_, told_, ontology_);
        for (const owl::Entity& entity : ontology_.entities)
            if (entity.kind == owl::EntityKind::klass && is_left_aside(theory_, ontology_, levels_, entity.iri))
                theory_.warnings.push_back(owl::local_name(entity.iri) +
                                           " is neither below core:Region nor below core:Object, so it is left aside.");
        return std::move(theory_);
    }

    /// What run() would refuse, axiom by axiom; a refused definition leaves its name without one.
    std::vector<std::string> refusals() {
        std::vector<std::string> found;
        const auto attempt = [&](const auto& step) {
            try {
                step();
            } catch (const OntologyError& error) {
                if (std::ranges::find(found, error.what()) == found.end()) found.emplace_back(error.what());
                grounder_.start_over();
            }
        };
        for (std::size_t i = 0; i < ontology_.axioms.size(); ++i) attempt([&] { read(i); });
        for (const std::size_t i : synonyms_) attempt([&] { read_synonyms(i); });
        for (const std::size_t i : unions_) attempt([&] { read_union(i); });
        if (found.empty()) attempt([&] { static_cast<void>(run_on()); });
        return found;
    }

private:
    static Theory start(const owl::Ontology& ontology) {
        Theory theory;
        theory.ranges = find_ranges(ontology);
        theory.numbers = find_numbers(ontology, theory.no_numbers);
        theory.relations = find_relations(ontology);
        return theory;
    }

    void read(std::size_t index) {
        const Axiom& axiom = ontology_.axioms[index];
        switch (axiom.kind) {
            case AxiomKind::sub_class_of:
            case AxiomKind::equivalent_classes:
            case AxiomKind::disjoint_classes:
            case AxiomKind::disjoint_union:
                return read_classes(index);
            case AxiomKind::class_assertion:
            case AxiomKind::object_property_assertion:
            case AxiomKind::negative_object_property_assertion:
            case AxiomKind::data_property_assertion:
            case AxiomKind::negative_data_property_assertion:
            case AxiomKind::same_individual:
            case AxiomKind::has_key:
            case AxiomKind::rule:
                theory_.beyond.push_back(index);
                return;
            case AxiomKind::different_individuals:  // as all names are
            case AxiomKind::datatype_definition:    // known to plain_ontology
                return;
            default:
                return read_property(index);
        }
    }

    /// hasPart, a property that leads to a range concept, or a measured one. No other property links anything.
    [[nodiscard]] bool is_known(const Iri& property) const {
        return is_core_term(property, "hasPart") ||
               std::ranges::any_of(theory_.ranges, [&](const auto& r) { return r.property == property; }) ||
               std::ranges::any_of(theory_.numbers, [&](const auto& n) { return n.iri == property; });
    }

    /// Axioms about properties that say nothing of a mesh's features and parts are left to its closed world.
    void read_property(std::size_t index) {
        const Axiom& axiom = ontology_.axioms[index];
        const Iri& property = axiom.properties[0].iri;
        const bool of_parts = is_core_term(property, "hasPart");
        const bool all_known = std::ranges::all_of(axiom.properties, [&](const auto& p) { return is_known(p.iri); });
        const bool all_same = std::ranges::all_of(axiom.properties, [&](const auto& p) { return p.iri == property; });
        const bool one_known = is_known(property);
        switch (axiom.kind) {
            case AxiomKind::object_property_domain:
            case AxiomKind::data_property_domain:
            case AxiomKind::object_property_range:
                if (one_known) read_domain_or_range(index);
                return;
            case AxiomKind::data_property_range: {
                if (!one_known) return;
                auto only = std::make_shared<owl::ClassExpression>();
                only->kind = ClassKind::data_all_values_from;
                only->property = axiom.properties[0];
                only->range = axiom.range;
                return constrain(Level::region, index, grounder_.ground(only, Level::region, axiom));
            }
            case AxiomKind::functional_object_property:
                if (!of_parts || axiom.properties[0].inverse) return;
                return constrain(Level::object, index, at_most_one_part(axiom));
            case AxiomKind::inverse_functional_object_property:
                if (of_parts && std::ranges::any_of(theory_.concepts, [](const NamedConcept& each) {
                        return each.level == Level::composite && !is_core_term(each.iri, "CompositePart");
                    }))
                    refuse(axiom, "a part of a composite part is a part of the object, too", "take it away");
                return;  // there is one object, and each region has values of its own
            case AxiomKind::equivalent_object_properties:
            case AxiomKind::equivalent_data_properties:
                if (all_known && !all_same) break;
                return;
            case AxiomKind::inverse_object_properties:
                if (all_known && !(all_same && axiom.properties[0].inverse != axiom.properties[1].inverse)) break;
                return;
            case AxiomKind::sub_object_property_of:
            case AxiomKind::sub_data_property_of:
                if (axiom.properties.size() > 2 && is_known(axiom.properties.back().iri) && !is_transitivity(axiom))
                    theory_.beyond.push_back(index);
                if (axiom.properties.size() == 2 && all_known && !all_same) break;
                return;  // one implies the other (open_restrictions.cpp)
            case AxiomKind::symmetric_object_property:
            case AxiomKind::reflexive_object_property:
                if (one_known) break;
                return;
            case AxiomKind::transitive_object_property:
                if (one_known && !of_parts) break;
                return;  // parts of parts are parts, and so hasPart is read
            default:
                return;
        }
        refuse(axiom, "features and parts are linked by one property each", "use that property itself");
    }

    [[nodiscard]] static bool is_transitivity(const Axiom& axiom) {
        return axiom.properties.size() == 3 &&
               std::ranges::all_of(axiom.properties, [&](const auto& p) { return p == axiom.properties[0]; });
    }

    [[nodiscard]] FormulaId at_most_one_part(const Axiom& axiom) {
        auto one = std::make_shared<owl::ClassExpression>();
        one->kind = ClassKind::max_cardinality;
        one->property = axiom.properties[0];
        one->number = 1;
        return grounder_.ground(one, Level::object, axiom);
    }

    /// Every region is a part, and has every feature.
    void read_domain_or_range(std::size_t index) {
        const Axiom& axiom = ontology_.axioms[index];
        const Iri& property = axiom.properties[0].iri;
        const bool is_domain = axiom.kind != AxiomKind::object_property_range;
        if (is_core_term(property, "hasPart")) {
            if (!is_domain)
                return constrain(Level::region, index, grounder_.ground_within(axiom.classes[0], Level::region, axiom));
            auto has_parts = std::make_shared<owl::ClassExpression>();
            has_parts->kind = ClassKind::min_cardinality;
            has_parts->property = axiom.properties[0];
            has_parts->number = 1;
            const FormulaId whole = grounder_.ground_within(axiom.classes[0], Level::object, axiom);
            if (whole != 0)
                constrain(Level::object, index, implies(grounder_.ground(has_parts, Level::object, axiom), whole));
            return;
        }
        if (is_domain)
            return constrain(Level::region, index, grounder_.ground_within(axiom.classes[0], Level::region, axiom));
        for (std::size_t r = 0; r < theory_.ranges.size(); ++r)
            if (theory_.ranges[r].property == property &&
                grounder_.values(*axiom.classes[0], r, axiom, true).count() != theory_.value_count(r))
                refuse(axiom, "it takes values from " + owl::local_name(theory_.ranges[r].iri),
                       "leave them out of its disjoint union");
    }

    [[nodiscard]] int concept_of(const ClassPointer& expression) const {
        return expression->kind == ClassKind::named ? theory_.find(expression->iri) : -1;
    }

    [[nodiscard]] Level level_of_axiom(const Axiom& axiom) const {
        return decided(level_of_all(axiom.classes, levels_, theory_.ranges));
    }

    /// What merely has parts, and is told by no name, is the object.
    [[nodiscard]] static Level decided(Level level) { return level == Level::whole ? Level::object : level; }

    void constrain(Level level, std::size_t axiom, FormulaId formula) {
        if (formula != 0) theory_.constraints.push_back({level, axiom, formula});
    }

    [[nodiscard]] FormulaId implies(FormulaId a, FormulaId b) { return grounder_.disjoin({grounder_.negate(a), b}); }
    [[nodiscard]] FormulaId same(FormulaId a, FormulaId b) { return grounder_.conjoin({implies(a, b), implies(b, a)}); }

    void read_classes(std::size_t index) {
        const Axiom& axiom = ontology_.axioms[index];
        const Level level = level_of_axiom(axiom);
        if (axiom.kind == AxiomKind::disjoint_classes) return read_disjoint(index, 0);
        if (level == Level::feature) return check_features(axiom);
        if (level == Level::relation) {
            if (axiom.kind == AxiomKind::sub_class_of && axiom.classes[0]->kind == ClassKind::named &&
                axiom.classes[1]->kind == ClassKind::named)
                return;
            refuse(axiom, "a relation has no definition, but an algorithm",
                   "put it below core:Relation, and give it core:criterion");
        }
        if (axiom.kind == AxiomKind::sub_class_of) return read_sub_class(index, level);
        if (level == Level::unknown) return;  // about neither regions nor objects
        if (axiom.kind == AxiomKind::disjoint_union) {
            unions_.push_back(index);
            return read_disjoint(index, 1);
        }
        const bool all_named =
            std::ranges::all_of(axiom.classes, [](const auto& c) { return c->kind == ClassKind::named; });
        if (all_named) {
            synonyms_.push_back(index);
            return;
        }
        // The first expression is the definition of each name; the others must agree with it.
        const ClassPointer& meaning =
            *std::ranges::find_if(axiom.classes, [](const auto& c) { return c->kind != ClassKind::named; });
        (void)grounder_.take_mentions();
        const FormulaId formula = grounder_.ground(meaning, level, axiom);
        const std::vector<std::pair<FormulaId, Level>> mentions = grounder_.take_mentions();
        for (const ClassPointer& expression : axiom.classes) {
            if (expression == meaning) continue;
            const int id = concept_of(expression);
            if (id >= 0 && theory_.concepts[id].definition < 0) {
                define(id, formula, index);
                if (!mentions.empty()) mentions_.push_back({id, mentions});
            } else
                constrain(level, index, same(grounder_.ground(expression, level, axiom), formula));
        }
    }

    void define(int id, FormulaId formula, std::size_t axiom) {
        theory_.concepts[id].definition = formula;
        theory_.concepts[id].axiom = axiom;
    }

    void read_sub_class(std::size_t index, Level level) {
        const Axiom& axiom = ontology_.axioms[index];
        const ClassPointer &sub = axiom.classes[0], &super = axiom.classes[1];
        if (super->kind == ClassKind::named && is_thing(super->iri)) return;
        std::vector<ClassPointer> rest;
        bool incompatible = false;
        const auto split = [&](const auto& self, const ClassPointer& part) -> void {
            if (part->kind == ClassKind::intersection_of)
                for (const ClassPointer& operand : part->operands) self(self, operand);
            else if (part->kind == ClassKind::named && is_core_term(part->iri, "Incompatible"))
                incompatible = true;
            else
                rest.push_back(part);
        };
        split(split, super);
        if (incompatible) {
            const int id = concept_of(sub);
            if (id < 0)
                refuse(axiom,
                       sub->kind == ClassKind::named ? "no axiom says whether it is about a region or an object"
                                                     : "an incompatibility needs a name to be reported by",
                       "define a named class EquivalentTo the combination, and put that below core:Incompatible");
            theory_.concepts[id].incompatible = true;
            if (rest.empty()) return;
        }
        if (level == Level::unknown) return;
        const FormulaId premise = grounder_.ground(sub, level, axiom);
        std::vector<FormulaId> conclusions;
        for (const ClassPointer& part : rest) conclusions.push_back(grounder_.ground(part, level, axiom));
        if (concept_of(sub) >= 0 && rest.size() == 1 && concept_of(rest[0]) >= 0)
            told_.emplace_back(concept_of(sub), concept_of(rest[0]));
        constrain(level, index, implies(premise, grounder_.conjoin(std::move(conclusions))));
    }

    /// Pairs of classes that speak of different things are disjoint anyway.
    void read_disjoint(std::size_t index, std::size_t first) {
        const Axiom& axiom = ontology_.axioms[index];
        for (std::size_t i = first; i < axiom.classes.size(); ++i)
            for (std::size_t j = i + 1; j < axiom.classes.size(); ++j) {
                Level a = level_of(*axiom.classes[i], levels_, theory_.ranges);
                Level b = level_of(*axiom.classes[j], levels_, theory_.ranges);
                if (a == Level::whole) a = decided(b == Level::composite ? b : a);
                if (b == Level::whole) b = decided(a == Level::composite ? a : b);
                if (a == Level::unknown || a != b) continue;
                if (a == Level::relation) continue;  // a node is of one relation anyway
                if (a == Level::feature) {
                    check_values(axiom,
                                 [&](std::size_t r) { return !values(axiom, i, r).intersects(values(axiom, j, r)); });
                    continue;
                }
                constrain(a, index,
                          grounder_.negate(grounder_.conjoin({grounder_.ground(axiom.classes[i], a, axiom),
                                                              grounder_.ground(axiom.classes[j], a, axiom)})));
            }
    }

    [[nodiscard]] ConfigurationSet values(const Axiom& axiom, std::size_t i, std::size_t range) {
        return grounder_.values(*axiom.classes[i], range, axiom, false);
    }

    template <typename Check>
    void check_values(const Axiom& axiom, const Check& check) {
        for (std::size_t r = 0; r < theory_.ranges.size(); ++r)
            if (!check(r))
                refuse(axiom, "it takes values away from " + owl::local_name(theory_.ranges[r].iri),
                       "list its values in one disjoint union");
    }

    /// Axioms about features set the structure, which is already read; they must say nothing else.
    void check_features(const Axiom& axiom) {
        if (!is_made_of_names(axiom.classes)) return;  // it says more than structure
        check_values(axiom, [&](std::size_t r) {
            const ConfigurationSet first = values(axiom, 0, r);
            if (axiom.kind == AxiomKind::sub_class_of) return first.is_subset_of(values(axiom, 1, r));
            ConfigurationSet united(first.size());
            for (std::size_t i = 1; i < axiom.classes.size(); ++i) {
                const ConfigurationSet other = values(axiom, i, r);
                if (axiom.kind == AxiomKind::equivalent_classes && other != first) return false;
                if (axiom.kind == AxiomKind::disjoint_union && united.intersects(other)) return false;
                united |= other;
            }
            return axiom.kind == AxiomKind::equivalent_classes || united == first;
        });
    }

    /// Whether the definition of `from` rests on `target`; true as well when that is too deep to tell.
    [[nodiscard]] bool rests_on(int from, int target) const {
        std::vector<char> seen(theory_.concepts.size(), 0);
        std::size_t depth = 0;
        const auto visit = [&](const auto& self, FormulaId id) -> bool {
            const Formula& formula = theory_.formulas[id];
            if (formula.kind == Formula::Kind::named) {
                if (formula.index == target || depth == deepest_definition) return true;
                if (seen[formula.index]) return false;
                seen[formula.index] = 1;
                const FormulaId definition = theory_.concepts[formula.index].definition;
                ++depth;
                const bool rests = definition >= 0 && self(self, definition);
                --depth;
                return rests;
            }
            if (formula.kind == Formula::Kind::parts) return self(self, formula.index);
            return std::ranges::any_of(formula.operands, [&](FormulaId operand) { return self(self, operand); });
        };
        const FormulaId definition = theory_.concepts[from].definition;
        return from == target || (definition >= 0 && visit(visit, definition));
    }

    void read_synonyms(std::size_t index) {
        const Axiom& axiom = ontology_.axioms[index];
        const Level level = level_of_axiom(axiom);
        for (std::size_t i = 1; i < axiom.classes.size(); ++i) {
            const int a = concept_of(axiom.classes[i - 1]), b = concept_of(axiom.classes[i]);
            const FormulaId left = grounder_.ground(axiom.classes[i - 1], level, axiom);
            const FormulaId right = grounder_.ground(axiom.classes[i], level, axiom);
            if (a >= 0 && theory_.concepts[a].definition < 0 && (b < 0 || !rests_on(b, a)))
                define(a, right, index);
            else if (b >= 0 && theory_.concepts[b].definition < 0 && (a < 0 || !rests_on(a, b)))
                define(b, left, index);
            else
                constrain(level, index, same(left, right));
            if (a >= 0 && b >= 0) {
                told_.emplace_back(a, b);
                told_.emplace_back(b, a);
            }
        }
    }

    void read_union(std::size_t index) {
        const Axiom& axiom = ontology_.axioms[index];
        const Level level = level_of_axiom(axiom);
        const int whole = concept_of(axiom.classes[0]);
        std::vector<FormulaId> operands;
        bool circular = whole < 0 || theory_.concepts[whole].definition >= 0;
        for (std::size_t i = 1; i < axiom.classes.size(); ++i) {
            operands.push_back(grounder_.ground(axiom.classes[i], level, axiom));
            const int part = concept_of(axiom.classes[i]);
            if (part < 0)
                circular = true;
            else if (!circular)
                circular = rests_on(part, whole);
            if (part >= 0 && whole >= 0) told_.emplace_back(part, whole);
        }
        const FormulaId united = grounder_.disjoin(std::move(operands));
        if (circular)
            constrain(level, index, same(grounder_.ground(axiom.classes[0], level, axiom), united));
        else
            define(whole, united, index);
    }

    void refuse_circles() const {
        std::vector<int> path;
        std::vector<char> done(theory_.concepts.size(), 0);
        const auto visit = [&](const auto& self, int id) -> void {
            if (done[id]) return;
            if (const auto start = std::ranges::find(path, id); start != path.end()) {
                std::string others;
                for (auto i = start + 1; i != path.end(); ++i) {
                    if (i - start > 4) {
                        others += " and others";
                        break;
                    }
                    const Axiom& other = ontology_.axioms[theory_.concepts[*i].axiom];
                    others += " and " + at(other.source.file, other.source.line, to_manchester(other));
                }
                refuse(ontology_.axioms[theory_.concepts[id].axiom],
                       owl::local_name(theory_.concepts[id].iri) + " is defined by itself" +
                           (others.empty() ? "" : " through" + others.substr(4)),
                       "let definitions rest on features or parts only");
            }
            if (path.size() > deepest_definition)
                refuse(ontology_.axioms[theory_.concepts[id].axiom],
                       "definitions rest on each other more than " + std::to_string(deepest_definition) +
                           " deep, perhaps in a circle",
                       "let them rest on features or parts directly");
            path.push_back(id);
            const auto descend = [&](const auto& down, FormulaId f) -> void {
                const Formula& formula = theory_.formulas[f];
                if (formula.kind == Formula::Kind::named) self(self, formula.index);
                if (formula.kind == Formula::Kind::parts) down(down, formula.index);
                for (const FormulaId operand : formula.operands) down(down, operand);
            };
            if (theory_.concepts[id].definition >= 0) descend(descend, theory_.concepts[id].definition);
            path.pop_back();
            done[id] = 1;
        };
        for (std::size_t id = 0; id < theory_.concepts.size(); ++id) visit(visit, static_cast<int>(id));
    }

    /// What is told to be below an incompatible concept is incompatible too.
    void spread_incompatible() {
        for (std::size_t id = 0; id < theory_.concepts.size(); ++id) {
            const auto conjuncts = [&](const auto& self, FormulaId f) -> void {
                const Formula& formula = theory_.formulas[f];
                if (formula.kind == Formula::Kind::named) told_.emplace_back(static_cast<int>(id), formula.index);
                if (formula.kind == Formula::Kind::conjunction)
                    for (const FormulaId operand : formula.operands) self(self, operand);
            };
            if (theory_.concepts[id].definition >= 0) conjuncts(conjuncts, theory_.concepts[id].definition);
        }
        for (bool grown = true; grown;) {
            grown = false;
            for (const auto& [sub, super] : told_) {
                if (!theory_.concepts[super].incompatible || theory_.concepts[sub].incompatible) continue;
                theory_.concepts[sub].incompatible = true;
                grown = true;
            }
        }
    }

    const owl::Ontology ontology_;
    Theory theory_;
    std::map<Iri, Level> levels_;
    Grounder grounder_;
    std::vector<std::size_t> synonyms_, unions_;
    std::vector<std::pair<int, int>> told_;  ///< sub, super
    std::vector<Mentions> mentions_;
};

}  // namespace

bool is_left_aside(const Theory& theory, const owl::Ontology& ontology, const std::map<Iri, Level>& levels,
                   const Iri& iri) {
    if (levels.contains(iri) || is_thing(iri) || is_nothing(iri) || is_core_term(iri, "Incompatible")) return false;
    const auto is_it = [&](const ClassPointer& c) { return c->kind == ClassKind::named && c->iri == iri; };
    const bool is_asked = std::ranges::any_of(
        theory.concepts, [&](const NamedConcept& named) { return named.open != nullptr && is_it(named.open); });
    // A name for something else: what an open restriction leads to, what an individual is, and what these are below.
    const auto is_filler = [&](const auto& self, const ClassPointer& c, bool is_behind) -> bool {
        if (is_behind && is_it(c)) return true;
        return std::ranges::any_of(c->operands, [&](const ClassPointer& operand) {
            return self(self, operand, is_behind || c->kind >= ClassKind::some_values_from);
        });
    };
    bool is_defined = false, is_beside = false;
    for (const Axiom& axiom : ontology.axioms) {
        const bool is_member = std::ranges::any_of(axiom.classes, is_it);
        is_defined |= is_member && axiom.kind == AxiomKind::equivalent_classes;
        is_beside |=
            is_member &&
            (axiom.kind == AxiomKind::object_property_range || axiom.kind == AxiomKind::object_property_domain ||
             axiom.kind == AxiomKind::data_property_domain || axiom.kind == AxiomKind::class_assertion ||
             (axiom.kind == AxiomKind::sub_class_of &&
              level_of_all(axiom.classes, levels, theory.ranges) == Level::unknown));
        is_beside |=
            std::ranges::any_of(axiom.classes, [&](const ClassPointer& c) { return is_filler(is_filler, c, false); });
    }
    return is_asked ? !is_defined : !is_beside;
}

Iri core_term(const char* name) { return std::string(owl::core_prefix) + name; }

bool is_core_term(const Iri& iri, std::string_view name) {
    constexpr std::string_view prefix = owl::core_prefix;
    return iri.size() == prefix.size() + name.size() && iri.ends_with(name) && iri.starts_with(prefix);
}

bool is_thing(const Iri& iri) { return iri == "http://www.w3.org/2002/07/owl#Thing"; }
bool is_nothing(const Iri& iri) { return iri == "http://www.w3.org/2002/07/owl#Nothing"; }

void refuse(const owl::Axiom& axiom, const std::string& why, const std::string& right) {
    throw OntologyError(at(axiom.source.file, axiom.source.line,
                           "\"" + to_manchester(axiom) + "\" cannot be grounded: " + why + "; " + right + "."));
}

std::string with_article(const std::string& name) { return partonomy::with_article(name); }

std::size_t Theory::value_count(std::size_t feature) const {
    if (feature >= ranges.size() + numbers.size()) return 2;
    if (feature >= ranges.size()) return numbers[feature - ranges.size()].intervals.size();
    return ranges[feature].values.size() + (ranges[feature].covered ? 0 : 1);
}

int Theory::find(const Iri& iri) const {
    const auto found = std::ranges::lower_bound(concepts, iri, {}, &NamedConcept::iri);
    return found != concepts.end() && found->iri == iri ? static_cast<int>(found - concepts.begin()) : -1;
}

bool Theory::needs_world() const {
    return !beyond.empty() ||
           std::ranges::any_of(concepts, [](const NamedConcept& named) { return named.open != nullptr; });
}

Theory read_theory(const owl::Ontology& ontology) { return TheoryReader(plain_ontology(ontology)).run(); }

std::vector<std::string> all_refusals(const owl::Ontology& ontology) {
    try {
        return TheoryReader(plain_ontology(ontology)).refusals();
    } catch (const OntologyError& error) {  // before any axiom was read
        return {error.what()};
    }
}

}  // namespace partonomy::knowledge
