#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "owl/write.h"

namespace partonomy::owl {

/// How a document that is being written calls things: prefixes for the namespaces in it, and which statements are its
/// own.
class WriteNames {
public:
    WriteNames() = default;  ///< all names in full
    WriteNames(const Ontology& ontology, const WriteOptions& options);

    /// prefix:local, <https://…>, or _:label.
    [[nodiscard]] std::string operator()(const Iri& iri);
    /// The prefixes that were used, with ':', and their namespaces.
    [[nodiscard]] std::vector<std::pair<std::string, std::string>> used_prefixes() const;
    /// Whether an anonymous individual was called by a name that begins so.
    [[nodiscard]] bool has_label_with(const std::string& beginning) const;
    /// Whether a statement from `source` is to be written.
    [[nodiscard]] bool is_ours(const Source& source) const { return !foreign_files_.contains(source.file); }
    /// IRIs to import.
    [[nodiscard]] const std::vector<Iri>& imports() const { return imports_; }

private:
    void add(const std::string& prefix, const std::string& space);
    std::map<std::string, std::string> prefix_of_;  ///< by namespace
    std::set<std::string> used_;                    ///< namespaces
    std::set<Iri> anonymous_;                       ///< names of anonymous individuals that were asked for
    std::set<std::string> foreign_files_;
    std::vector<Iri> imports_;
};

/// A literal. Turtle wants three quotation marks around a text with line breaks.
[[nodiscard]] std::string literal_text(const Literal& literal, WriteNames& names, bool is_turtle);

/// The version IRI among the annotations of the ontology; empty for none.
[[nodiscard]] Iri version_of(const Ontology& ontology);

/// Whether `annotation` says the version IRI, which stands in the head of the document.
[[nodiscard]] bool is_version(const Annotation& annotation);

/// The variables of all rules that are written, sorted.
[[nodiscard]] std::set<Iri> variables_of(const Ontology& ontology, const WriteNames& names);

}  // namespace partonomy::owl
