#include <algorithm>
#include <cctype>
#include <set>

#include "base/spelling.h"
#include "knowledge/lint.h"
#include "owl/signature.h"

// Spelling of core terms. Every name that an axiom or annotation uses is looked up among the terms that the core
// ontology declares; a name in another namespace counts as meant for the core one when the namespace is nearly spelled
// like it and the rest is a core term, such as "http://w3id.org/partonomy/core#Board".

namespace partonomy::knowledge {
namespace {

/// "line 12", "lines 12, 14", "no axiom": where axioms outside core name a term; the first three of more.
std::string lines_with(const owl::Ontology& ontology, const Iri& term) {
    constexpr std::size_t shown = 3;
    std::set<long> lines;
    for (const owl::Axiom& axiom : ontology.axioms)
        owl::for_each_name(axiom, [&](const Iri& iri) {
            if (iri == term && !axiom.source.file.ends_with("core.ttl")) lines.insert(axiom.source.line);
        });
    if (lines.empty()) return "no axiom";
    std::string text = lines.size() > 1 ? "lines " : "line ";
    std::size_t told = 0;
    for (const long line : lines) {
        if (told == shown) return text + " …";
        text += (told++ > 0 ? ", " : "") + std::to_string(line);
    }
    return text;
}

}  // namespace

std::vector<Finding> unknown_terms(const owl::Ontology& ontology) {
    static const owl::Ontology core = owl::parse_ontology(owl::core_ontology_text(), "core.ttl");
    std::set<Iri> terms;
    for (const owl::Entity& entity : core.entities) terms.insert(entity.iri);
    const std::string prefix = owl::core_prefix;
    const auto nearest = [&](const std::string& name) {
        const Iri* best = nullptr;
        std::size_t least = 0;
        for (const Iri& term : terms) {
            if (!term.starts_with(prefix)) continue;
            const std::string word = owl::local_name(term);
            // Of two as near the one of the same kind: classes begin with a capital letter, properties do not.
            const bool same_kind = !name.empty() && (std::isupper(static_cast<unsigned char>(name[0])) != 0) ==
                                                        (std::isupper(static_cast<unsigned char>(word[0])) != 0);
            const std::size_t distance = 2 * edit_distance(name, word) + !same_kind;
            if (best == nullptr || distance < least) {
                best = &term;
                least = distance;
            }
        }
        return owl::local_name(*best);
    };
    std::vector<Finding> findings;
    std::set<Iri> seen;
    const auto look_at = [&](const Iri& iri, const owl::Source& where) {
        if (terms.contains(iri) || iri.empty() || !seen.insert(iri).second) return;
        const std::string name = owl::local_name(iri);
        const std::string space = iri.substr(0, iri.size() - name.size());
        if (space == prefix) {
            if (name.empty()) return;
            findings.push_back({FindingKind::unknown_term,
                                true,
                                {iri},
                                where,
                                "core:" + name + " is no term of the core ontology",
                                "did you mean core:" + nearest(name) + "?",
                                {}});
        } else if (terms.contains(prefix + name) && edit_distance(space, prefix) <= 3) {
            findings.push_back({FindingKind::unknown_term,
                                true,
                                {iri},
                                where,
                                "<" + iri + "> is not in the namespace of the core ontology",
                                "did you mean <" + prefix + name + ">?",
                                {}});
        }
    };
    for (const owl::Axiom& axiom : ontology.axioms)
        owl::for_each_name(axiom, [&](const Iri& iri) { look_at(iri, axiom.source); });
    std::set<Iri> namesakes;  // annotations named like a knob of core, and not in its namespace
    for (const auto& [entity, annotations] : ontology.annotations)
        for (const owl::Annotation& annotation : annotations) {
            const std::size_t before = findings.size();
            look_at(annotation.property, annotation.source);
            const std::string name = owl::local_name(annotation.property);
            if (findings.size() != before || annotation.property.starts_with(prefix) ||
                core.find(prefix + name, owl::EntityKind::annotation_property) == nullptr ||
                !namesakes.insert(annotation.property).second)
                continue;
            findings.push_back({FindingKind::unknown_term,
                                false,
                                {annotation.property},
                                annotation.source,
                                "\"" + name + "\" of " + owl::local_name(entity) + " is <" + annotation.property +
                                    ">, which nothing here reads",
                                "write core:" + name + " if that is meant",
                                {}});
        }
    for (const owl::Entity& entity : ontology.entities) {
        if (namesakes.contains(entity.iri)) continue;
        const std::size_t before = findings.size();
        look_at(entity.iri, entity.source);
        const std::string name = owl::local_name(entity.iri);
        const bool is_twin = !entity.iri.starts_with(prefix) && terms.contains(prefix + name);
        if (is_twin && findings.size() == before)
            findings.push_back(
                {FindingKind::unknown_term,
                 false,
                 {entity.iri},
                 entity.source,
                 name + " of this ontology and core:" + name + " are two things of one name: yours is meant in " +
                     lines_with(ontology, entity.iri) + ", core's in " + lines_with(ontology, prefix + name),
                 "name yours otherwise, or mean core:" + name,
                 {}});
    }
    return findings;
}

}  // namespace partonomy::knowledge
