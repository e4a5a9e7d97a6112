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

/// A node of an RDF graph.
struct Term {
    TermKind kind = TermKind::iri;
    Word word = Word::none;  ///< of an IRI of OWL's own vocabulary
    std::string value;       ///< IRI, label of a blank node (empty when it has none), or lexical form
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
    Node blank();                          ///< a new one, without label
    Node blank(const std::string& label);  ///< the one of that label
    void add(Node subject, Node predicate, Node object, long line) {
        triples.push_back({subject, predicate, object, line});
    }
    Node word(Word word);  ///< the node of an OWL word

    /// A name used in a role that its triples alone do not tell: a property in functional syntax, say.
    struct Use {
        Node node = 0;
        EntityKind kind = EntityKind::klass;
        long line = 0;
    };
    std::vector<Use> uses;
    /// In Manchester syntax `p min 2 X` and `not X` look the same over things and over data: what X is follows from p.
    bool kinds_are_open = false;

    static constexpr std::size_t max_iri = 4096;

private:
    Node intern(const std::string& key, Term&& term);  ///< no IRI
    std::unordered_map<std::string, Node> iris_, others_;
    std::vector<std::int64_t> words_;
};

/// A larger document is refused: what is made of it takes up to 25 times its size in memory.
inline constexpr std::size_t max_document = std::size_t{32} << 20;

/// Reads an ontology in any of the syntaxes of OWL 2, recognised by content, as triples. `name` is what error sentences
/// call the document. Never opens another file or the network. Throws OntologyError: syntax, encoding, another format,
/// more than `max_document` bytes.
[[nodiscard]] Graph read_document(const std::string& bytes, const std::string& name);

/// Each fills `graph` from text in one syntax (UTF-8, but for XML, which says its encoding). `base` resolves relative
/// IRIs. N-Triples is Turtle too; XML is RDF/XML or OWL/XML, as its root element says.
void read_turtle(const std::string& text, const std::string& base, Graph& graph);
void read_xml_document(const std::string& text, const std::string& base, Graph& graph);
void read_functional(const std::string& text, const std::string& base, Graph& graph);
void read_manchester(const std::string& text, const std::string& base, Graph& graph);

/// `reference` made absolute, as RFC 3986 section 5.2 says.
[[nodiscard]] std::string resolve_iri(const std::string& base, const std::string& reference);

/// Whether the bytes are UTF-8: no overlong forms, no surrogates.
[[nodiscard]] bool is_utf8(const std::string& bytes);

/// Appends a code point in UTF-8; false for surrogates and beyond U+10FFFF.
bool append_utf8(std::string& text, std::uint32_t code_point);

}  // namespace partonomy::owl
