#include "expert/rule_questions.h"

#include <algorithm>
#include <set>

#include "owl/signature.h"

namespace partonomy {
namespace {

using knowledge::ConfigurationSet;
using knowledge::Question;
using owl::Iri;

/// The definition of a rule, and those of the concepts of parts that it names, and so on.
std::vector<const owl::Axiom*> definitions_behind(const knowledge::Domain& domain, const Iri& rule) {
    std::vector<const owl::Axiom*> axioms;
    std::vector<Iri> reached{rule};
    std::set<Iri> known{rule};
    for (std::size_t next = 0; next < reached.size(); ++next)
        for (const owl::Axiom* axiom : definitions_of(domain, Iri(reached[next]))) {
            if (std::ranges::find(axioms, axiom) != axioms.end()) continue;
            axioms.push_back(axiom);
            owl::for_each_name(*axiom, [&](const Iri& name) {
                if (!name.starts_with(owl::core_prefix) && domain.regions.find(name) && known.insert(name).second)
                    reached.push_back(name);
            });
        }
    return axioms;
}

/// Asks which value a region has, as long as several are possible.
void ask_about(Session& session, int region, int variable) {
    const knowledge::Space& space = session.domain().regions;
    const knowledge::Variable& asked = space.variables[static_cast<std::size_t>(variable)];
    const bool is_choice =
        asked.kind == knowledge::VariableKind::range || asked.kind == knowledge::VariableKind::number;
    if (!is_choice && asked.kind != knowledge::VariableKind::relation) return;
    for (std::size_t value = 0; value < (is_choice ? asked.values.size() : 1); ++value) {
        const Question question{variable, static_cast<knowledge::ValueId>(value)};
        const ConfigurationSet yes = yes_set(space, question);
        const ConfigurationSet& possible = session.possible(region);
        if (possible.intersects(yes) && !possible.is_subset_of(yes) && session.is_a_cost(question))
            static_cast<void>(session.ask(region, question));
    }
}

}  // namespace

std::vector<const owl::Axiom*> definitions_of(const knowledge::Domain& domain, const Iri& iri) {
    std::vector<const owl::Axiom*> found;
    for (const owl::Axiom& axiom : domain.ontology.axioms)
        if (std::ranges::any_of(axiom.classes, [&](const owl::ClassPointer& each) {
                return each->kind == owl::ClassKind::named && each->iri == iri;
            }))
            found.push_back(&axiom);
    return found;
}

bool is_named_in(const std::vector<const owl::Axiom*>& axioms, const knowledge::Variable& variable) {
    return std::ranges::any_of(axioms, [&](const owl::Axiom* axiom) {
        std::set<Iri> names;
        owl::for_each_name(*axiom, [&](const Iri& name) { names.insert(name); });
        if (variable.part_class) {  // however often: "max 1" is asked as "min 2"
            bool are_all_named = true;
            owl::for_each_name(*variable.part_class,
                               [&](const Iri& name) { are_all_named = are_all_named && names.contains(name); });
            return are_all_named;
        }
        return std::ranges::any_of(names, [&](const Iri& name) {
            return name == variable.iri ||
                   std::ranges::find(variable.values, owl::local_name(name)) != variable.values.end();
        });
    });
}

void ask_what_rules_rest_on(Session& session) {
    if (!session.is_told_in_numbers()) return;
    const knowledge::Domain& domain = session.domain();
    const knowledge::Knowledge knowledge = session.knowledge();
    const knowledge::Conclusions known = conclude(domain, knowledge);
    if (known.contradiction) return;
    for (const Iri& rule : known.diagnoses) {
        if (rule.starts_with(owl::core_prefix)) continue;
        const std::vector<const owl::Axiom*> axioms = definitions_behind(domain, rule);
        std::vector<int> variables;
        for (std::size_t v = 0; v < domain.regions.variables.size(); ++v)
            if (is_named_in(axioms, domain.regions.variables[v])) variables.push_back(static_cast<int>(v));
        for (const int region : culprits(domain, knowledge, rule))
            for (const int variable : variables) ask_about(session, region, variable);
    }
}

}  // namespace partonomy
