#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "owl/rdf_graph.h"

namespace partonomy::owl {

/// The owl:Ontology statement of a document.
struct Header {
    Iri iri;                                    ///< empty when the document names no ontology
    Iri version;                                ///< owl:versionIRI
    std::vector<std::pair<Iri, long>> imports;  ///< with their lines
};

[[nodiscard]] Header header_of(const Graph& graph);

/// Documents in the order in which they are merged: what is imported comes first, the one asked for last.
struct Documents {
    std::vector<Graph> graphs;
    Iri iri;                                           ///< of the one asked for
    std::vector<std::pair<Iri, std::string>> imports;  ///< IRI as imported, and the file
};

/// The document in `bytes` and all that it imports, each once. `folder` is where its catalog and neighbours are looked
/// for; without one only the built-in core can be imported, which comes before all others. Throws FileError,
/// OntologyError.
[[nodiscard]] Documents read_with_imports(const std::string& bytes, const std::string& name,
                                          const std::optional<std::filesystem::path>& folder,
                                          const LoadOptions& options);

/// One ontology of documents that were read. Throws OntologyError for what is no OWL 2.
[[nodiscard]] Ontology merge(Documents&& documents);

/// The file that a catalog-v001.xml in `folder` gives for `iri`; nothing when there is no catalog or no entry.
/// Throws OntologyError when the catalog is broken.
[[nodiscard]] std::optional<std::filesystem::path> look_up_catalog(const std::filesystem::path& folder, const Iri& iri);

}  // namespace partonomy::owl
