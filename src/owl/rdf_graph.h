#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

#include "owl/ontology.h"
#include "owl/words.h"

namespace partonomy::owl {

enum class TermKind : std::uint8_t { iri, blank, literal };

/// A node of an RDF graph. A blank node's value is "_:" and a number.
struct Term {
    TermKind kind = TermKind::iri;
    Word word = Word::none;  ///< of an IRI of OWL's own vocabulary
    std::string value;       ///< IRI, blank node name, or lexical form
    std::string datatype;    ///< of a literal, never empty then
    std::string language;    ///< lower case, empty when there is none
};

/// Index into Graph::terms.
using Node = std::uint32_t;

struct Triple {
    Node subject = 0;
    Node predicate = 0;
    Node object = 0;
    long line = 0;  ///< 1-based, where a person looks for it: the predicate; for later values of a list, the value
};

/// What one RDF document says, and on which line. Equal IRIs and literals are one node.
struct Graph {
    std::string file;
    std::vector<Term> terms;
    std::vector<Triple> triples;  ///< by line, once read

    /// Throws OntologyError for an IRI of more than `max_iri` bytes: short text with a long prefix could fill the
    /// memory.
    Node iri(const std::string& value, long line);
    Node literal(const std::string& value, const std::string& datatype, const std::string& language = {});
    /// A new blank node; its name is unique among documents that have different `number`.
    Node blank();
    void add(Node subject, Node predicate, Node object, long line) {
        triples.push_back({subject, predicate, object, line});
    }
    Node word(Word word);  ///< the node of an OWL word

    std::size_t number = 0;  ///< of the document among those read together
    static constexpr std::size_t max_iri = 4096;

private:
    Node intern(const std::string& key, Term&& term);
    std::unordered_map<std::string, Node> nodes_;
    std::vector<std::int64_t> words_;
    std::size_t blanks_ = 0;
};

/// Reads Turtle, N-Triples or RDF/XML, recognised by content. `name` is what error sentences call the document.
/// Never opens another file or the network. Throws OntologyError: syntax, encoding, a format that is neither.
[[nodiscard]] Graph read_rdf(const std::string& bytes, const std::string& name, std::size_t number = 0);

/// Fills `graph` from Turtle text; N-Triples is Turtle too. `base` resolves relative IRIs.
void read_turtle(const std::string& text, const std::string& base, Graph& graph);

/// Fills `graph` from RDF/XML text.
void read_rdf_xml(const std::string& text, const std::string& base, Graph& graph);

/// `reference` made absolute, as RFC 3986 section 5.2 says.
[[nodiscard]] std::string resolve_iri(const std::string& base, const std::string& reference);

/// Whether the bytes are UTF-8: no overlong forms, no surrogates.
[[nodiscard]] bool is_utf8(const std::string& bytes);

/// Appends a code point in UTF-8; false for surrogates and beyond U+10FFFF.
bool append_utf8(std::string& text, std::uint32_t code_point);

}  // namespace partonomy::owl
