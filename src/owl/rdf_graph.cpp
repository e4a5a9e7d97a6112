#include "owl/rdf_graph.h"

#include <algorithm>
#include <string_view>

#include "base/errors.h"

namespace partonomy::owl {
namespace {

struct WordEntry {
    Word word;
    std::string iri;
};

const std::vector<WordEntry>& word_entries() {
    static const std::vector<WordEntry> entries = [] {
        const std::string owl = owl_prefix;
        const std::string rdf = rdf_prefix;
        const std::string rdfs = rdfs_prefix;
        const std::string swrl = swrl_prefix;
        std::vector<WordEntry> list;
#define PARTONOMY_OWL_WORD(prefix, name) list.push_back({Word::prefix##_##name, prefix + #name});
        PARTONOMY_OWL_WORDS(PARTONOMY_OWL_WORD)
#undef PARTONOMY_OWL_WORD
        return list;
    }();
    return entries;
}

}  // namespace

Word word_of(const std::string& iri) {
    static const std::unordered_map<std::string_view, Word> words = [] {
        std::unordered_map<std::string_view, Word> map;
        for (const WordEntry& entry : word_entries()) map.emplace(entry.iri, entry.word);
        return map;
    }();
    if (!iri.starts_with("http://www.w3.org/")) return Word::none;
    const auto found = words.find(iri);
    return found == words.end() ? Word::none : found->second;
}

std::string between(const char* open, const std::string& text, const char* close) {
    std::string out = open;
    out += text;
    out += close;
    return out;
}

std::string short_name(const std::string& iri) {
    using Pair = std::pair<const char*, const char*>;
    for (const auto& [prefix, space] :
         {Pair{"owl:", owl_prefix}, Pair{"rdf:", rdf_prefix}, Pair{"rdfs:", rdfs_prefix}, Pair{"xsd:", xsd_prefix},
          Pair{"swrl:", swrl_prefix}, Pair{"swrlb:", swrlb_prefix}}) {
        if (iri.starts_with(space)) return prefix + iri.substr(std::string_view(space).size());
    }
    const std::string local = local_name(iri);
    return local.empty() ? between("<", iri, ">") : local;
}

Node Graph::intern(const std::string& key, Term&& term) {
    const auto [entry, is_new] = others_.try_emplace(key, static_cast<Node>(terms.size()));
    if (is_new) terms.push_back(std::move(term));
    return entry->second;
}

Node Graph::iri(const std::string& value, long line) {
    if (value.size() > max_iri) {
        throw OntologyError(at(file, line,
                               "an IRI of " + std::to_string(value.size()) + " bytes is too long; at most " +
                                   std::to_string(max_iri) + " are read"));
    }
    const auto found = iris_.find(value);
    if (found != iris_.end()) return found->second;
    if (!value.empty() && !((value[0] | 0x20) >= 'a' && (value[0] | 0x20) <= 'z'))
        throw OntologyError(
            at(file, line,
               between("the IRI '", value.substr(0, 40), "' begins with no letter; https: or urn: may be missing")));
    for (const char c : value) {
        const bool is_control = static_cast<unsigned char>(c) <= ' ' || c == 127;
        if (!is_control && std::string_view("<>\"{}|\\^`").find(c) == std::string_view::npos) continue;
        const std::string what = c == ' ' ? "a space" : is_control ? "a control character" : between("'", {c}, "'");
        throw OntologyError(at(file, line, "an IRI cannot hold " + what + (c == ' ' ? "; write %20" : "")));
    }
    terms.push_back({TermKind::iri, word_of(value), value, {}, {}});
    return iris_.emplace(value, static_cast<Node>(terms.size() - 1)).first->second;
}

Node Graph::literal(const std::string& value, const std::string& datatype, const std::string& language) {
    std::string tag = language;
    std::ranges::transform(tag, tag.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    const auto is_part = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'; };
    const bool begins_well = !tag.empty() && tag.front() >= 'a' && tag.front() <= 'z';
    if (!tag.empty() && (!std::ranges::all_of(tag, is_part) || !begins_well || tag.back() == '-')) {
        throw OntologyError(
            at(file, 0, between("'", language.substr(0, 40), "' is no language, which would be en or fr-CA")));
    }
    // Neither a datatype nor a language tag can hold a line break, so that the key is unambiguous.
    const std::string key = "\"" + datatype + "\n" + tag + "\n" + value;
    return intern(key, {TermKind::literal, Word::none, value, datatype, tag});
}

Node Graph::blank() {
    terms.push_back({TermKind::blank, Word::none, {}, {}, {}});
    return static_cast<Node>(terms.size() - 1);
}

Node Graph::blank(const std::string& label) {
    return intern("_" + label, {TermKind::blank, Word::none, label, {}, {}});
}

Node Graph::word(Word word) {
    const std::vector<WordEntry>& entries = word_entries();
    if (words_.empty()) words_.assign(entries.size() + 1, -1);
    std::int64_t& node = words_[static_cast<std::size_t>(word)];
    if (node < 0) node = iri(entries[static_cast<std::size_t>(word) - 1].iri, 0);
    return static_cast<Node>(node);
}

}  // namespace partonomy::owl
