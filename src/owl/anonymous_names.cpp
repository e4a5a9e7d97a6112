#include "owl/expressions.h"

namespace partonomy::owl {
namespace {

/// "_:" and the label with nothing in it that a syntax of OWL 2 could not write.
Iri safe_name(const std::string& label) {
    Iri name = "_:";
    for (const char c : label) {
        const bool is_plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
                              static_cast<unsigned char>(c) >= 0x80 || ((c == '-' || c == '.') && name.size() > 2);
        name += is_plain ? c : '_';
    }
    if (name.ends_with('.')) name.back() = '_';
    return name;
}

}  // namespace

void AnonymousNames::reserve(const Graph& graph) {
    for (Node node = 0; node < graph.terms.size(); ++node) {
        const Term& term = graph.terms[node];
        if (term.kind == TermKind::blank && !term.value.empty())
            owners_.emplace(safe_name(term.value), Place(&graph, node));
    }
}

Iri AnonymousNames::name(const Graph& graph, Node node) {
    const auto [entry, is_new] = names_.try_emplace(Place(&graph, node));
    if (!is_new) return entry->second;
    const std::string& label = graph.terms[node].value;
    Iri name = label.empty() ? "_:g" + std::to_string(++count_) : safe_name(label);
    const Iri stem = name;
    for (int copy = 2;; ++copy) {
        const auto [owner, is_free] = owners_.emplace(name, Place(&graph, node));
        if (is_free || owner->second == Place(&graph, node)) break;
        name = label.empty() ? "_:g" + std::to_string(++count_) : stem + "." + std::to_string(copy);
    }
    entry->second = name;
    return name;
}

}  // namespace partonomy::owl
