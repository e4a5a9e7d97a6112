#include "owl/write_names.h"

#include <algorithm>

#include "owl/words.h"

namespace partonomy::owl {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

/// A local name or prefix that every reader takes as it is.
bool is_plain_name(std::string_view name) {
    if (name.empty() || !is_letter(name[0])) return false;
    return std::ranges::all_of(name, [](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '-'; });
}

/// "https://e.org/furniture#" of "https://e.org/furniture#Seat".
std::string_view space_of(const Iri& iri) {
    const std::size_t cut = iri.find_last_of("#/");
    return cut == std::string::npos ? std::string_view() : std::string_view(iri).substr(0, cut + 1);
}

/// `text` between quotation marks.
std::string quoted(const std::string& text, const char* mark) {
    std::string out = mark;
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + mark;
}

}  // namespace

WriteNames::WriteNames(const Ontology& ontology, const WriteOptions& options) {
    if (!options.merge_imports) {
        for (const auto& [iri, file] : ontology.imports) {
            foreign_files_.insert(file);
            imports_.push_back(iri);
        }
    }
    add("owl:", owl_prefix);
    add("rdf:", rdf_prefix);
    add("rdfs:", rdfs_prefix);
    add("xsd:", xsd_prefix);
    add("swrl:", swrl_prefix);
    add("swrlb:", swrlb_prefix);
    if (!ontology.iri.empty()) {
        const bool has_end = ontology.iri.ends_with('#') || ontology.iri.ends_with('/');
        add(":", has_end ? ontology.iri : ontology.iri + "#");
    }
    std::set<std::string> taken;
    for (const auto& [space, prefix] : prefix_of_) taken.insert(prefix);
    for (const Entity& entity : ontology.entities) {  // sorted by IRI
        const std::string space(space_of(entity.iri));
        if (space.size() < 2 || prefix_of_.contains(space)) continue;
        const std::string path = space.substr(0, space.size() - 1);
        std::string word = path.substr(path.find_last_of("/#:") + 1);
        if (!is_plain_name(word) || word[0] == '_') word = "ns";
        std::string prefix = word + ":";
        for (int i = 2; !taken.insert(prefix).second; ++i) prefix = word + std::to_string(i) + ":";
        add(prefix, space);
    }
}

void WriteNames::add(const std::string& prefix, const std::string& space) { prefix_of_.emplace(space, prefix); }

std::string WriteNames::operator()(const Iri& iri) {
    if (iri.starts_with("_:")) {
        anonymous_.insert(iri);
        return iri;
    }
    const std::string_view space = space_of(iri);
    if (!space.empty() && is_plain_name(std::string_view(iri).substr(space.size()))) {
        const auto found = prefix_of_.find(std::string(space));
        if (found != prefix_of_.end()) {
            used_.insert(found->first);
            return found->second + iri.substr(space.size());
        }
    }
    return between("<", iri, ">");
}

bool WriteNames::has_label_with(const std::string& beginning) const {
    const auto found = anonymous_.lower_bound(beginning);
    return found != anonymous_.end() && found->starts_with(beginning);
}

std::vector<std::pair<std::string, std::string>> WriteNames::used_prefixes() const {
    std::vector<std::pair<std::string, std::string>> list;
    for (const auto& [space, prefix] : prefix_of_) {
        if (used_.contains(space)) list.emplace_back(prefix, space);
    }
    std::ranges::sort(list);
    return list;
}

std::string literal_text(const Literal& literal, WriteNames& names, bool is_turtle) {
    const bool is_long = is_turtle && literal.value.find_first_of("\r\n") != std::string::npos;
    const std::string text = quoted(literal.value, is_long ? "\"\"\"" : "\"");
    if (!literal.language.empty()) return text + "@" + literal.language;
    if (literal.datatype.empty() || literal.datatype == std::string(xsd_prefix) + "string") return text;
    return text + "^^" + names(literal.datatype);
}

bool is_version(const Annotation& annotation) {
    return !annotation.iri.empty() && annotation.property == std::string(owl_prefix) + "versionIRI";
}

Iri version_of(const Ontology& ontology) {
    const auto notes = ontology.annotations.find(ontology.iri);
    if (notes == ontology.annotations.end() || ontology.iri.empty()) return {};
    const auto version = std::ranges::find_if(notes->second, is_version);
    return version == notes->second.end() ? Iri() : version->iri;
}

std::set<Iri> variables_of(const Ontology& ontology, const WriteNames& names) {
    std::set<Iri> variables;
    for (const Axiom& axiom : ontology.axioms) {
        if (axiom.kind != AxiomKind::rule || !names.is_ours(axiom.source)) continue;
        for (const auto* atoms : {&axiom.rule->body, &axiom.rule->head}) {
            for (const RuleAtom& atom : *atoms) {
                for (const RuleTerm& term : atom.arguments) {
                    if (term.kind == RuleTerm::Kind::variable) variables.insert(term.iri);
                }
            }
        }
    }
    return variables;
}

}  // namespace partonomy::owl
