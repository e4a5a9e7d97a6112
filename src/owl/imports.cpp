// Imports, resolved offline: the catalog beside the importing file, then files in its folder and in the import folders
// whose ontology IRI (else version IRI) is the one imported. Core is built in; only a catalog or an import folder can
// put another file in its place, not a file that happens to lie beside the importing one. Those are found by content: a
// file is read only when its bytes hold the IRI, or at least the IRI's last word and what stands before it, since
// prefixes and entities may split it. A file that cannot be read is no candidate; a file that is imported and broken is
// an error.

#include "owl/imports.h"

#include <algorithm>
#include <map>
#include <set>

#include "base/errors.h"
#include "base/files.h"
#include "owl/core_module.h"

namespace partonomy::owl {
namespace {

namespace fs = std::filesystem;

constexpr const char* built_in_name = "core.ttl (built in)";

/// IRIs that differ by a '#' at the end name the same ontology.
Iri without_hash(Iri iri) {
    if (iri.ends_with('#')) iri.pop_back();
    return iri;
}

class Importer {
public:
    explicit Importer(const LoadOptions& options) : options_(options) {}

    /// Reads a document and, before it, what it imports. An own stack instead of recursion: chains may be long.
    void read(Graph&& graph, const std::optional<fs::path>& folder);

    Documents documents;

private:
    struct Open {
        Graph graph;
        Header header;
        std::optional<fs::path> folder;
        std::size_t next = 0;
    };
    struct Found {
        Graph graph;
        std::optional<fs::path> folder;
    };
    void open(Graph&& graph, const std::optional<fs::path>& folder);
    /// The imported document; nothing when it is the built-in core, which is read at the end.
    std::optional<Found> resolve(const Iri& iri, long line, const Open& importer);
    std::optional<Found> search_folder(const fs::path& folder, const Iri& iri);
    void read_built_in_core();
    const LoadOptions& options_;
    bool wants_built_in_core_ = false;
    std::vector<Open> stack_;
    std::set<Iri> seen_;
    std::map<fs::path, std::string> bytes_;  ///< of the files in the folders searched
};

const std::string* stored(std::map<fs::path, std::string>& files, const fs::path& file) {
    const auto known = files.find(file);
    if (known != files.end()) return &known->second;
    try {
        return &files.emplace(file, read_file(file)).first->second;
    } catch (const FileError&) {
        return nullptr;
    }
}

std::optional<Importer::Found> Importer::search_folder(const fs::path& folder, const Iri& iri) {
    std::vector<fs::path> files;
    std::error_code error;
    for (fs::directory_iterator i(folder, error), end; !error && i != end; i.increment(error)) {
        const std::string type = i->path().extension().string();
        std::error_code ignored;
        constexpr std::string_view types[] = {".ttl", ".owl", ".rdf", ".xml", ".nt",
                                              ".owx", ".ofn", ".omn", ".fss", ".ows"};
        if (std::ranges::find(types, type) != std::end(types) && i->is_regular_file(ignored)) {
            files.push_back(i->path());
        }
    }
    std::ranges::sort(files);
    const std::size_t cut = iri.find_last_of("/#", iri.size() - 2);
    const std::string stem = cut == std::string::npos ? iri : iri.substr(0, cut + 1);
    const std::string last = cut == std::string::npos ? iri : iri.substr(cut + 1);
    std::optional<Found> by_version;
    for (const fs::path& file : files) {
        const std::string* bytes = stored(bytes_, file);
        if (bytes == nullptr || bytes->find(last) == std::string::npos || bytes->find(stem) == std::string::npos)
            continue;
        try {
            Graph graph = read_document(*bytes, file.string());
            const Header header = header_of(graph);
            if (without_hash(header.iri) == iri) return Found{std::move(graph), folder};
            if (!by_version && !header.version.empty() && without_hash(header.version) == iri) {
                by_version = Found{std::move(graph), folder};
            }
        } catch (const OntologyError&) {
            continue;
        }
    }
    return by_version;
}

std::optional<Importer::Found> Importer::resolve(const Iri& iri, long line, const Open& importer) {
    const bool is_core = iri == core_iri;
    if (importer.folder) {
        std::optional<fs::path> file = look_up_catalog(*importer.folder, iri);
        if (!file) file = look_up_catalog(*importer.folder, iri + "#");
        std::error_code error;
        if (file && fs::is_regular_file(*file, error)) {
            const fs::path folder = file->has_parent_path() ? file->parent_path() : fs::path(".");
            return Found{read_document(read_file(*file), file->string()), folder};
        }
        if (!is_core)
            if (std::optional<Found> found = search_folder(*importer.folder, iri)) return found;
    }
    for (const fs::path& folder : options_.import_folders) {
        std::error_code error;
        if (!fs::is_directory(folder, error)) {
            throw FileError(at(folder.string(), 0, "is no folder that imports can be looked for in"));
        }
        if (std::optional<Found> found = search_folder(folder, iri)) return found;
    }
    if (is_core) {
        wants_built_in_core_ = true;
        return std::nullopt;
    }
    throw OntologyError(
        at(importer.graph.file, line,
           "the imported ontology <" + iri + "> cannot be found, and nothing is fetched from the network; " +
               (importer.folder ? "put its file beside this one, name it in catalog-v001.xml, or give its "
                                  "folder with --import-dir"
                                : "here only <" + std::string(core_iri) + "> can be imported")));
}

void Importer::open(Graph&& graph, const std::optional<fs::path>& folder) {
    Header header = header_of(graph);
    if (!header.iri.empty()) seen_.insert(without_hash(header.iri));
    if (!header.version.empty()) seen_.insert(without_hash(header.version));
    stack_.push_back({std::move(graph), std::move(header), folder});
}

void Importer::read(Graph&& graph, const std::optional<fs::path>& folder) {
    open(std::move(graph), folder);
    documents.iri = stack_.back().header.iri;
    while (!stack_.empty()) {
        Open& top = stack_.back();
        if (top.next == top.header.imports.size()) {
            documents.graphs.push_back(std::move(top.graph));
            stack_.pop_back();
            continue;
        }
        const auto [written, line] = top.header.imports[top.next++];
        const Iri iri = without_hash(written);
        if (iri.empty() || !seen_.insert(iri).second) continue;
        std::optional<Found> found = resolve(iri, line, top);
        if (!found) {
            documents.imports.emplace_back(written, built_in_name);
            continue;
        }
        documents.imports.emplace_back(written, found->graph.file);
        const Header header = header_of(found->graph);
        // The catalog may lead to an ontology that is merged already, under its other name.
        if (!header.iri.empty() && without_hash(header.iri) != iri && seen_.contains(without_hash(header.iri)))
            continue;
        open(std::move(found->graph), found->folder);
    }
    if (wants_built_in_core_) read_built_in_core();
}

/// Once all others are read, since they say what of it they need; it imports nothing.
void Importer::read_built_in_core() {
    std::set<std::string> names;
    if (!options_.whole_core)
        for (const Graph& graph : documents.graphs)
            for (const Term& term : graph.terms)
                if (term.kind == TermKind::iri && term.value.starts_with(core_prefix)) names.insert(term.value);
    documents.graphs.insert(
        documents.graphs.begin(),
        read_document(options_.whole_core ? core_ontology_text() : core_module(names), built_in_name));
}

}  // namespace

Header header_of(const Graph& graph) {
    Header header;
    std::set<Node> imported;
    for (const Triple& triple : graph.triples) {
        if (graph.terms[triple.predicate].word != Word::owl_imports || graph.terms[triple.object].kind != TermKind::iri)
            continue;
        header.imports.emplace_back(graph.terms[triple.object].value, triple.line);
        imported.insert(triple.object);
    }
    // Several headers occur where tools merged files: the one that no other imports is the ontology's own.
    std::optional<Node> own;
    for (const Triple& triple : graph.triples) {
        if (graph.terms[triple.predicate].word != Word::rdf_type ||
            graph.terms[triple.object].word != Word::owl_Ontology ||
            graph.terms[triple.subject].kind != TermKind::iri) {
            continue;
        }
        if (!own || (imported.contains(*own) && !imported.contains(triple.subject))) own = triple.subject;
        const Iri& merged = graph.terms[triple.subject].value;
        std::erase_if(header.imports,
                      [&](const auto& import) { return without_hash(import.first) == without_hash(merged); });
    }
    if (!own) return header;
    header.iri = graph.terms[*own].value;
    for (const Triple& triple : graph.triples) {
        if (triple.subject == *own && graph.terms[triple.predicate].word == Word::owl_versionIRI) {
            header.version = graph.terms[triple.object].value;
        }
    }
    return header;
}

Documents read_with_imports(const std::string& bytes, const std::string& name, const std::optional<fs::path>& folder,
                            const LoadOptions& options) {
    Importer importer(options);
    importer.read(read_document(bytes, name), folder);
    return std::move(importer.documents);
}

}  // namespace partonomy::owl
