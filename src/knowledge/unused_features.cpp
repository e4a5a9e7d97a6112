/* Core knows far more kinds of features than one domain needs. A range concept that is left in multiplies the
   configurations of a region by its number of values and would be asked about, so what a domain does not speak of is no
   feature of its regions. Core's axioms form groups: a range concept with its property and its values, a relation, a
   measured property; a group is used as soon as an axiom of another file names one of its members.
   O(names in axioms x log). */

#include "knowledge/unused_features.h"

#include <algorithm>
#include <map>
#include <vector>

#include "knowledge/theory.h"
#include "owl/signature.h"

namespace partonomy::knowledge {
namespace {

using owl::Axiom;
using owl::AxiomKind;
using owl::ClassKind;

/// Groups of names of core's file, by their first member.
class Groups {
public:
    Groups(const owl::Ontology& ontology, const std::string& file) {
        for (const Axiom& axiom : ontology.axioms)
            if (axiom.source.file == file) add(axiom);
        for (const Axiom& axiom : ontology.axioms)  // values that are told by their parents alone
            if (axiom.source.file == file && axiom.kind == AxiomKind::sub_class_of && are_named(axiom))
                if (const auto parent = groups_.find(axiom.classes[1]->iri); parent != groups_.end())
                    groups_.emplace(axiom.classes[0]->iri, parent->second);
    }

    void use(const Iri& name) {
        if (const auto found = groups_.find(name); found != groups_.end()) used_.insert(found->second);
    }

    [[nodiscard]] std::set<Iri> unused() const {
        std::set<Iri> names;
        for (const auto& [name, group] : groups_)
            if (!used_.contains(group)) names.insert(name);
        return names;
    }

private:
    static bool are_named(const Axiom& axiom) {
        return std::ranges::all_of(axiom.classes, [](const auto& c) { return c->kind == ClassKind::named; });
    }

    void add(const Axiom& axiom) {
        switch (axiom.kind) {
            case AxiomKind::object_property_range:
                if (!is_core_term(axiom.classes[0]->iri, "Relation") && are_named(axiom)) {
                    groups_.emplace(axiom.classes[0]->iri, axiom.classes[0]->iri);
                    groups_.emplace(axiom.properties[0].iri, axiom.classes[0]->iri);
                }
                return;
            case AxiomKind::disjoint_union:
                if (are_named(axiom))
                    for (const auto& each : axiom.classes) groups_.emplace(each->iri, axiom.classes[0]->iri);
                return;
            case AxiomKind::sub_class_of:
                if (are_named(axiom) && is_core_term(axiom.classes[1]->iri, "Relation"))
                    groups_.emplace(axiom.classes[0]->iri, axiom.classes[0]->iri);
                return;
            case AxiomKind::data_property_domain:
                groups_.emplace(axiom.properties[0].iri, axiom.properties[0].iri);
                return;
            default:
                return;
        }
    }

    std::map<Iri, Iri> groups_;  ///< name -> the group's own name
    std::set<Iri> used_;
};

}  // namespace

std::set<Iri> unused_features(const owl::Ontology& ontology) {
    const auto core = std::ranges::find(ontology.imports, Iri(owl::core_iri), &std::pair<Iri, std::string>::first);
    if (core == ontology.imports.end()) return {};
    const std::string& file = core->second;
    Groups groups(ontology, file);
    groups.use(core_term("Connected"));
    for (const Axiom& axiom : ontology.axioms)
        if (axiom.source.file != file) owl::for_each_name(axiom, [&](const Iri& name) { groups.use(name); });
    return groups.unused();
}

}  // namespace partonomy::knowledge
