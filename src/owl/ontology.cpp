#include "owl/ontology.h"

#include <algorithm>
#include <tuple>

#include "base/errors.h"
#include "base/files.h"
#include "owl/declarations.h"
#include "owl/expressions.h"
#include "owl/imports.h"

namespace partonomy::owl {
namespace {

bool declares_ontology(const Graph& graph) {
    return std::ranges::any_of(graph.triples, [&](const Triple& triple) {
        return graph.terms[triple.predicate].word == Word::rdf_type &&
               graph.terms[triple.object].word == Word::owl_Ontology;
    });
}

}  // namespace

Ontology merge(Documents&& documents) {
    Ontology ontology;
    ontology.iri = documents.iri;
    ontology.imports = std::move(documents.imports);
    Declarations declarations;
    for (const Graph& graph : documents.graphs) declarations.collect(graph, ontology.entities);
    AnonymousNames names;
    for (auto graph = documents.graphs.rbegin(); graph != documents.graphs.rend(); ++graph) names.reserve(*graph);
    for (const Graph& graph : documents.graphs) map_axioms(graph, declarations, names, ontology);

    std::ranges::stable_sort(ontology.entities, [](const Entity& a, const Entity& b) {
        return std::tie(a.iri, a.kind) < std::tie(b.iri, b.kind);
    });
    const auto is_repeated = [](const Entity& a, const Entity& b) { return a.iri == b.iri && a.kind == b.kind; };
    ontology.entities.erase(std::unique(ontology.entities.begin(), ontology.entities.end(), is_repeated),
                            ontology.entities.end());
    if (!declares_ontology(documents.graphs.back()) && ontology.entities.empty() && ontology.axioms.empty()) {
        throw OntologyError(at(documents.graphs.back().file, 0,
                               "holds statements but no ontology; declare owl:Ontology, or classes as owl:Class"));
    }
    return ontology;
}

std::string local_name(const Iri& iri) {
    const std::size_t cut = iri.find_last_of("#/");
    return cut == std::string::npos ? iri : iri.substr(cut + 1);
}

std::strong_ordering DataRange::operator<=>(const DataRange& other) const {
    const auto own = std::tie(kind, datatype, facets, values);
    if (const auto order = own <=> std::tie(other.kind, other.datatype, other.facets, other.values); order != 0)
        return order;
    for (std::size_t i = 0; i < operands.size() && i < other.operands.size(); ++i) {
        if (const auto order = operands[i] <=> other.operands[i]; order != 0) return order;
    }
    return operands.size() <=> other.operands.size();
}

const Entity* Ontology::find(const Iri& wanted, EntityKind kind) const {
    const auto found = std::ranges::lower_bound(entities, std::tie(wanted, kind), {},
                                                [](const Entity& entity) { return std::tie(entity.iri, entity.kind); });
    return found != entities.end() && found->iri == wanted && found->kind == kind ? &*found : nullptr;
}

std::string Ontology::label(const Iri& subject, const std::string& language) const {
    const auto found = annotations.find(subject);
    if (found == annotations.end()) return local_name(subject);
    const std::string* plain = nullptr;
    for (const Annotation& annotation : found->second) {
        if (annotation.property != "http://www.w3.org/2000/01/rdf-schema#label" || !annotation.iri.empty()) continue;
        if (annotation.literal.language == language) return annotation.literal.value;
        if (annotation.literal.language.empty() && plain == nullptr) plain = &annotation.literal.value;
    }
    return plain != nullptr ? *plain : local_name(subject);
}

Ontology load_ontology(const std::filesystem::path& path, const LoadOptions& options) {
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : std::filesystem::path(".");
    const std::string bytes = read_file(path);
    const auto read = [&](const LoadOptions& how) {
        return merge(read_with_imports(bytes, path.string(), folder, how));
    };
    Ontology ontology;
    try {
        ontology = read(options);
    } catch (const OntologyError&) {
        if (options.whole_core) throw;
        LoadOptions whole = options;  // what a misspelt name may mean is told by all names of core
        whole.whole_core = true;
        ontology = read(whole);
    }
    ontology.sha256 = sha256(bytes);
    return ontology;
}

Ontology parse_ontology(const std::string& bytes, const std::string& name) {
    return merge(read_with_imports(bytes, name, std::nullopt, {}));
}

}  // namespace partonomy::owl
