/* What is wrong with an ontology, in the words of the expert who wrote it.

   Most of it is read off the configuration spaces: a concept without configurations is unsatisfiable, two with the same
   ones cannot be told apart, two that share some but not all overlap (concept_relations.cpp). Causes are minimal
   conflicts (causes.cpp). */

#include "knowledge/lint.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/errors.h"
#include "knowledge/assembly.h"
#include "knowledge/causes.h"
#include "knowledge/concept_relations.h"
#include "knowledge/lint_gaps.h"
#include "knowledge/lint_relations.h"
#include "knowledge/plain.h"
#include "knowledge/theory.h"
#include "owl/signature.h"

namespace partonomy::knowledge {
namespace {

bool is_core(const Iri& iri) { return iri.starts_with(owl::core_prefix); }

class Linter {
public:
    Linter(const Domain& domain, const LintOptions& options)
        : domain_(domain), theory_(domain.grounding->theory), options_(options) {
        for (std::size_t i = 0; i < domain.ontology.axioms.size(); ++i)
            owl::for_each_name(domain.ontology.axioms[i], [&](const Iri& iri) {
                std::vector<std::size_t>& axioms = uses_[iri];
                if (axioms.empty() || axioms.back() != i) axioms.push_back(i);
            });
    }

    std::vector<Finding> run() {
        if (const std::string why = why_not_counted(domain_.regions); !why.empty())
            add(FindingKind::uncounted, false, {}, {}, why,
                "raise the limit, or let rules tie fewer concepts together");
        look_at_space(domain_.regions, "region");
        for (const CompositeSpace& composite : domain_.composites) {
            Space own = composite.space;  // without the concepts that speak of every composite part
            std::erase_if(own.concepts,
                          [&](const Concept& each) { return theory_.concepts[theory_.find(each.iri)].group < 0; });
            look_at_space(own, "composite part");
        }
        look_at_space(domain_.objects(), "object");
        look_at_features();
        look_at_numbers();
        for (Finding& finding : lint_relations(domain_, [this](const Iri& iri) { return place_of(iri); }))
            findings_.push_back(std::move(finding));
        look_at_open_restrictions();
        look_at_declarations();
        std::ranges::stable_sort(findings_, {}, [](const Finding& f) {
            return std::tuple(!f.is_wrong, f.kind, std::cref(f.where.file).get(), f.where.line);
        });
        return std::move(findings_);
    }

private:
    Finding& add(FindingKind kind, bool is_wrong, std::vector<Iri> concepts, owl::Source where, std::string what,
                 std::string advice) {
        findings_.push_back(
            {kind, is_wrong, std::move(concepts), std::move(where), std::move(what), std::move(advice), {}});
        return findings_.back();
    }

    /// Of its definition, else of the first axiom that is about it, else of its declaration.
    [[nodiscard]] owl::Source place_of(const Iri& iri) const {
        const int id = theory_.find(iri);
        if (id >= 0 && theory_.concepts[id].definition >= 0)
            return domain_.ontology.axioms[theory_.concepts[id].axiom].source;
        for (const owl::EntityKind kind :
             {owl::EntityKind::klass, owl::EntityKind::object_property, owl::EntityKind::data_property})
            if (const owl::Entity* entity = domain_.ontology.find(iri, kind)) return entity->source;
        const auto found = uses_.find(iri);
        return found == uses_.end() ? owl::Source{} : domain_.ontology.axioms[found->second.front()].source;
    }

    void look_at_space(const Space& space, const std::string& what) {
        if (space.concepts.size() > most_compared)
            add(FindingKind::uncounted, false, {}, {},
                std::to_string(space.concepts.size()) + " concepts of a " + what +
                    " are too many to compare: which of them are alike or overlap was not looked at",
                "check the ontology in smaller files");
        look_at_concepts(space, what);
        look_at_relations(space, what);
    }

    void look_at_concepts(const Space& space, const std::string& what) {
        for (const Concept& each : space.concepts) {
            if (is_core(each.iri)) continue;
            const std::string name = owl::local_name(each.iri);
            const NamedConcept& named = theory_.concepts[theory_.find(each.iri)];
            if (each.where.is_empty()) {
                Finding& finding =
                    add(FindingKind::unsatisfiable, true, {each.iri}, place_of(each.iri),
                        "no " + what + " can ever be " + with_article(name), "weaken one of these axioms");
                if (explained_++ < options_.explained)
                    finding.causes = causes_of_unsatisfiable(theory_, theory_.find(each.iri), options_.causes);
            } else if (!each.provable && named.definition < 0) {
                if (is_told_by_rule(domain_.ontology, each.iri)) continue;
                add(FindingKind::unprovable, true, {each.iri}, place_of(each.iri),
                    name + " has only necessary conditions, so no " + what + " can ever be proved to be " +
                        with_article(name),
                    "did you mean EquivalentTo?");
            } else if (!each.provable) {
                const std::vector<std::string> open = concepts_without_definition(named.definition);
                if (open.empty() && !theory_.beyond.empty()) continue;  // rules may tell it
                add(FindingKind::unprovable, true, {each.iri}, place_of(each.iri),
                    "no " + what + " can ever be proved to be " + with_article(name) +
                        ", because its definition rests on " + (open.empty() ? "concepts" : list_of(open)) +
                        " without a definition",
                    "give " + std::string(open.size() == 1 ? open[0] : "them") + " an EquivalentTo");
            }
        }
    }

    [[nodiscard]] std::vector<std::string> concepts_without_definition(FormulaId from) const {
        std::set<FormulaId> seen;
        std::vector<Iri> found;
        const auto visit = [&](const auto& self, FormulaId id) -> void {
            if (!seen.insert(id).second) return;
            const Formula& formula = theory_.formulas[id];
            if (formula.kind == Formula::Kind::parts) self(self, formula.index);
            for (const FormulaId operand : formula.operands) self(self, operand);
            if (formula.kind != Formula::Kind::named) return;
            const NamedConcept& named = theory_.concepts[formula.index];
            if (named.definition >= 0)
                self(self, named.definition);
            else if (!named.open && std::ranges::find(found, named.iri) == found.end() &&
                     !is_told_by_rule(domain_.ontology, named.iri))
                found.push_back(named.iri);
        };
        visit(visit, from);
        return local_names(found);
    }

    void look_at_relations(const Space& space, const std::string& what) {
        std::vector<std::size_t> concepts;
        for (std::size_t c = 0; c < space.concepts.size(); ++c)
            if (!is_core(space.concepts[c].iri) && !space.concepts[c].where.is_empty()) concepts.push_back(c);
        ConceptRelations relations = relate(theory_, space, what == "object" ? Level::object : Level::region, concepts);
        // A composite part is there by what its concept asks for, so "every one is a Stem" is as it should be.
        if (what == "composite part") relations.universal.clear();
        for (const std::size_t c : relations.universal)
            add(FindingKind::universal, false, {space.concepts[c].iri}, place_of(space.concepts[c].iri),
                "every " + what + " is " + with_article(owl::local_name(space.concepts[c].iri)),
                "narrow its definition if that is not meant");
        for (const std::vector<std::size_t>& group : relations.alike) {
            std::vector<Iri> iris;
            for (const std::size_t c : group) iris.push_back(space.concepts[c].iri);
            const bool is_told = are_told_equivalent(iris);
            add(FindingKind::indistinguishable, !is_told, iris, place_of(iris.back()),
                "nothing can tell " + list_of(local_names(iris)) + " apart" +
                    (is_told ? ", as an EquivalentTo says" : ""),
                is_told ? "keep one of the names if that is not meant"
                        : "add what distinguishes them, or keep one of the names");
        }
        std::size_t told = 0;
        for (const auto& [c, others] : relations.overlapping) {
            const auto is_plain = [&](std::size_t i) {
                return !space.concepts[i].incompatible && space.concepts[i].provable &&
                       !is_helper(space.concepts[i].iri);
            };
            std::vector<Iri> iris{space.concepts[c].iri};
            for (const std::size_t other : others)
                if (is_plain(other)) iris.push_back(space.concepts[other].iri);
            if (!is_plain(c) || iris.size() < 2 || told++ >= options_.overlapping) continue;
            std::vector<std::string> names = local_names(iris);
            const std::string first = names.front();
            names.erase(names.begin());
            add(FindingKind::overlapping, false, iris, place_of(iris.front()),
                with_article(first) + " may also be " + list_of(names), "make them disjoint if that is not meant");
        }
    }

    /// core:helper: nothing is called by it, so it may hold beside any name.
    [[nodiscard]] bool is_helper(const Iri& iri) const {
        const auto found = domain_.ontology.annotations.find(iri);
        return found != domain_.ontology.annotations.end() &&
               std::ranges::any_of(found->second, [](const owl::Annotation& annotation) {
                   return is_core_term(annotation.property, "helper") && annotation.literal.value == "true";
               });
    }

    [[nodiscard]] bool are_told_equivalent(const std::vector<Iri>& iris) const {
        return std::ranges::any_of(domain_.ontology.axioms, [&](const owl::Axiom& axiom) {
            return axiom.kind == owl::AxiomKind::equivalent_classes && std::ranges::all_of(iris, [&](const Iri& iri) {
                       return std::ranges::any_of(axiom.classes, [&](const owl::ClassPointer& each) {
                           return each->kind == owl::ClassKind::named && each->iri == iri;
                       });
                   });
        });
    }

    /// Axioms that use the name and are not about it alone.
    [[nodiscard]] std::vector<std::size_t> users_of(const Iri& iri) const {
        const auto found = uses_.find(iri);
        std::vector<std::size_t> users;
        if (found == uses_.end()) return users;
        for (const std::size_t i : found->second) {
            const owl::Axiom& axiom = domain_.ontology.axioms[i];
            const bool is_structure = axiom.kind != owl::AxiomKind::sub_class_of &&
                                      axiom.kind != owl::AxiomKind::equivalent_classes &&
                                      axiom.kind != owl::AxiomKind::rule;
            const bool is_its_own = !axiom.classes.empty() && axiom.classes[0]->iri == iri && mentions(axiom, iri) == 1;
            if (!is_structure && !is_its_own) users.push_back(i);
        }
        return users;
    }
    [[nodiscard]] static std::size_t mentions(const owl::Axiom& axiom, const Iri& iri) {
        std::size_t count = 0;
        owl::for_each_name(axiom, [&](const Iri& each) { count += each == iri; });
        return count;
    }
    /// "Seat and Table" that some of the axioms are about.
    [[nodiscard]] std::string about(const std::vector<std::size_t>& axioms) const {
        std::vector<std::string> names;
        for (const std::size_t i : axioms) {
            const owl::Axiom& axiom = domain_.ontology.axioms[i];
            if (axiom.classes.empty() || axiom.classes[0]->kind != owl::ClassKind::named) continue;
            std::string name = owl::local_name(axiom.classes[0]->iri);
            if (std::ranges::find(names, name) == names.end()) names.push_back(std::move(name));
        }
        return list_of(names, 4);
    }

    void look_at_features() {
        for (std::size_t r = 0; r < domain_.ranges.size(); ++r) {
            const RangeConcept& range = domain_.ranges[r];
            const std::string name = owl::local_name(range.iri);
            if (range.values.empty())
                add(FindingKind::unused, true, {range.iri}, place_of(range.iri), name + " has no values",
                    "put classes below it");
            if (const std::string gap = is_core(range.iri) ? "" : gap_between_values(range); !gap.empty())
                add(FindingKind::gap, false, {range.iri}, place_of(range.iri),
                    gap + ", so a part there gets the one that is left when the others are denied",
                    "let their memberships meet");
            look_at_values_that_both_fit(range);
            std::vector<Iri> unused, unanswered;
            std::vector<std::size_t> users;
            for (std::size_t v = 0; v < range.values.size(); ++v) {
                const Iri& value = range.values[v].iri;
                const std::vector<std::size_t> own = users_of(value);
                if (own.empty()) unused.push_back(value);
                if (options_.can_answer && !options_.can_answer({static_cast<int>(r), static_cast<int>(v)})) {
                    unanswered.push_back(value);
                    users.insert(users.end(), own.begin(), own.end());
                }
            }
            // One value without an algorithm is known by exclusion.
            if (unanswered.size() + (range.covered ? 0 : 1) > 1) add_unanswerable(range, unanswered, users);
            // The other values of a covered range cannot be left out: they say what the one that is asked for is not.
            const bool is_needed = range.covered && unused.size() < range.values.size();
            if (unused.empty() || is_needed || is_core(range.iri)) continue;
            add(FindingKind::unused, false, unused, place_of(unused.front()),
                "no axiom asks for " + list_of(local_names(unused)) + " of " + name, "leave them out, or use them");
        }
    }

    void look_at_values_that_both_fit(const RangeConcept& range) {
        for (const auto& [one, other, where] : values_that_both_fit(range)) {
            const Iri &first = range.values[one].iri, &second = range.values[other].iri;
            if (is_core(first) && is_core(second)) continue;
            const long line = place_of(first).line;
            add(FindingKind::both_fit, true, {first, second}, place_of(second),
                where + " both " + owl::local_name(first) + (line > 0 ? " (line " + std::to_string(line) + ")" : "") +
                    " and " + owl::local_name(second) + " fit fully, though a part has one " +
                    owl::local_name(range.iri) + " only",
                "let their memberships meet, the one falling where the other rises: 4 7 inf inf beside -inf -inf 4 7");
        }
    }

    void add_unanswerable(const RangeConcept& range, const std::vector<Iri>& values, std::vector<std::size_t> users) {
        std::ranges::sort(users);
        users.erase(std::unique(users.begin(), users.end()), users.end());
        if (values.empty() || (users.empty() && is_core(range.iri))) return;
        const std::string whom = about(users);
        add(FindingKind::unanswerable, !users.empty(), values,
            users.empty() ? place_of(values.front()) : domain_.ontology.axioms[users.front()].source,
            "no algorithm can tell whether the " + owl::local_name(range.iri) + " of a region is " +
                list_of(local_names(values), 8, " or ") +
                (whom.empty() ? "" : ", so what " + whom + " asks of it stays open"),
            "give " + std::string(values.size() == 1 ? "it" : "them") +
                " a core:measure with core:membership, or a core:criterion");
    }

    void look_at_numbers() {
        for (std::size_t n = 0; n < domain_.numbers.size(); ++n) {
            const MeasuredProperty& number = domain_.numbers[n];
            const auto variable = static_cast<VariableId>(domain_.ranges.size() + n);
            const bool can = !number.measure.empty() && (!options_.can_answer || number.intervals.size() < 2 ||
                                                         options_.can_answer({variable, 0}));
            if (can) continue;
            const std::vector<std::size_t> users = users_of(number.iri);
            const std::string whom = about(users);
            add(FindingKind::unanswerable, true, {number.iri},
                users.empty() ? place_of(number.iri) : domain_.ontology.axioms[users.front()].source,
                owl::local_name(number.iri) + " has no core:measure, so nothing can answer it" +
                    (whom.empty() ? "" : " and what " + whom + " asks of it stays open"),
                "name a measurement of partonomy catalogue");
        }
    }

    [[nodiscard]] bool is_number(const Iri& property) const {
        return std::ranges::find(domain_.numbers, property, &MeasuredProperty::iri) != domain_.numbers.end();
    }

    /// Properties that nothing measures, and of which neither a rule nor another property says whom they relate.
    void look_at_open_restrictions() {
        const owl::Ontology plain = plain_ontology(domain_.ontology);
        std::set<Iri> told{core_term("hasPart"), core_term("isTargetRegion"), core_term("isReferenceRegion")};
        for (const RangeConcept& range : domain_.ranges) told.insert(range.property);
        for (const owl::Axiom& axiom : plain.axioms) {
            if (axiom.kind == owl::AxiomKind::rule)
                for (const owl::RuleAtom& atom : axiom.rule->head) told.insert(atom.property.iri);
            if ((axiom.kind == owl::AxiomKind::sub_object_property_of && axiom.properties.size() > 2) ||
                axiom.kind == owl::AxiomKind::reflexive_object_property)
                told.insert(axiom.properties.back().iri);
        }
        for (std::size_t before = 0; before != told.size();) {
            before = told.size();
            for (const owl::Axiom& axiom : plain.axioms)
                if ((axiom.kind == owl::AxiomKind::sub_object_property_of ||
                     axiom.kind == owl::AxiomKind::sub_data_property_of) &&
                    axiom.properties.size() == 2 && told.contains(axiom.properties[0].iri))
                    told.insert(axiom.properties[1].iri);
        }
        std::set<Iri> reported;
        for (const NamedConcept& named : theory_.concepts) {
            if (!named.open || named.open->property.iri.empty()) continue;
            const Iri& property = named.open->property.iri;
            if (told.contains(property) || is_number(property) || !reported.insert(property).second) continue;
            const std::vector<std::size_t> users = users_of(property);
            const std::string whom = about(users);
            const bool is_data = named.open->kind >= owl::ClassKind::data_some_values_from;
            add(FindingKind::unanswerable, true, {property},
                users.empty() ? place_of(property) : domain_.ontology.axioms[users.front()].source,
                "no algorithm tells " + owl::local_name(property) +
                    (whom.empty() ? "" : ", so what " + whom + " asks of it stays open"),
                is_data ? "name a measurement of partonomy catalogue, or let another axiom or a rule tell it"
                        : "let a rule tell it, or declare it functional with a class below core:Feature as its range");
        }
    }

    void look_at_declarations() {
        const owl::Ontology plain = plain_ontology(domain_.ontology);
        const std::map<Iri, Level> levels = find_levels(plain, domain_.ranges);
        for (const owl::Entity& entity : domain_.ontology.entities) {
            const Iri& iri = entity.iri;
            if (is_core(iri) || is_thing(iri) || is_nothing(iri)) continue;
            const std::string name = owl::local_name(iri);
            if (entity.kind == owl::EntityKind::klass && is_left_aside(theory_, plain, levels, iri))
                add(FindingKind::left_aside, true, {iri}, entity.source,
                    name + " is neither below core:Region nor below core:Object, so it is left aside",
                    "put it below one of them");
            else if (entity.kind == owl::EntityKind::klass && levels.contains(iri) && levels.at(iri) == Level::region &&
                     users_of(iri).empty() && is_nameable(iri))
                add(FindingKind::unused, false, {iri}, place_of(iri), "no object and no other concept asks for " + name,
                    is_helper(iri) ? "it is a helper that helps nobody; leave it out"
                                   : "a part can still be called by this name; leave it out if that is not meant");
            else if ((entity.kind == owl::EntityKind::object_property ||
                      entity.kind == owl::EntityKind::data_property) &&
                     users_of(iri).empty() &&
                     std::ranges::find(domain_.ranges, iri, &RangeConcept::property) == domain_.ranges.end())
                add(FindingKind::unused, false, {iri}, entity.source, "no axiom asks for " + name,
                    "leave it out, or use it");
        }
    }
    [[nodiscard]] bool is_nameable(const Iri& iri) const {
        const auto id = domain_.regions.find(iri);
        return id && !domain_.regions.concepts[*id].incompatible && !domain_.regions.concepts[*id].where.is_empty();
    }

    const Domain& domain_;
    const Theory& theory_;
    const LintOptions& options_;
    std::map<Iri, std::vector<std::size_t>> uses_;
    std::vector<Finding> findings_;
    std::size_t explained_ = 0;
};

}  // namespace

std::string to_text(FindingKind kind) {
    static const char* const words[]{"refused",           "contradiction", "unsatisfiable", "unprovable",
                                     "indistinguishable", "unanswerable",  "unknown term",  "left aside",
                                     "universal",         "gap",           "unused",        "uncounted",
                                     "overlapping",       "own side",      "both fit"};
    return words[static_cast<std::size_t>(kind)];
}

std::vector<Finding> lint(const Domain& domain, const LintOptions& options) { return Linter(domain, options).run(); }

std::vector<Finding> why_refused(const owl::Ontology& ontology, const std::string& error) {
    std::vector<std::string> errors = all_refusals(ontology);
    if (errors.empty()) {
        const Theory theory = read_theory(ontology);
        for (const Level level : {Level::region, Level::object}) {
            Finding finding{FindingKind::contradiction,      true, {}, {}, {}, "weaken one of these axioms",
                            causes_of_nothing(theory, level)};
            if (finding.causes.empty()) continue;
            finding.what =
                "the axioms leave no " + std::string(level == Level::region ? "region" : "object") + " possible";
            finding.where = ontology.axioms[finding.causes[0].back()].source;
            return {finding};
        }
    }
    if (std::ranges::find(errors, error) == errors.end()) errors.insert(errors.begin(), error);
    std::vector<Finding> findings;
    for (const std::string& text : errors) {
        Finding& finding = findings.emplace_back(Finding{FindingKind::refused, true, {}, {}, text, {}, {}});
        // The error names its place: "file:line: sentence".
        const std::size_t end = text.find(": ");
        const std::size_t colon = end == std::string::npos ? end : text.rfind(':', end - 1);
        const std::string line = colon == std::string::npos ? "" : text.substr(colon + 1, end - colon - 1);
        if (!line.empty() && std::ranges::all_of(line, [](char c) { return c >= '0' && c <= '9'; }) &&
            line.size() < 10) {
            finding.where = {text.substr(0, colon), std::stol(line)};
            finding.what = text.substr(end + 2);
        }
    }
    return findings;
}

}  // namespace partonomy::knowledge
