// From bytes to triples: which syntax is it, is it text at all, and the sentence for formats that we do not read. All
// six syntaxes of OWL 2 end as triples, and only triples are mapped to axioms: so the same ontology gives the same
// axioms, checks and error sentences, whatever syntax it was saved in. The road from functional, OWL/XML and Manchester
// syntax to triples is the one that "Mapping to RDF Graphs" (W3C, 2012) defines.
//
// Turtle and RDF/XML are read by parsers of our own, not by raptor2. Measured (2 shared cores, raptor2 2.0.15): linking
// raptor2 alone costs each process 7 ms for its 36 libraries (curl, kerberos, ICU …) and its world another 4 ms, half
// of what a whole run may take; and it knows the line of a Turtle triple only as that of the closing bracket or dot.
// Our tests still ask it for a second opinion.

#include <algorithm>
#include <cstdint>
#include <cstring>

#include "base/errors.h"
#include "owl/rdf_graph.h"

namespace partonomy::owl {
namespace {

/// Offset of the first byte that is not UTF-8, npos when all is well. Overlong forms and surrogates are not UTF-8.
std::size_t find_bad_utf8(const std::string& text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(i < text.size() ? text[i] : 0); };
    for (std::size_t i = 0; i < text.size();) {
        std::uint64_t eight = 0;
        if (i + sizeof eight <= text.size()) std::memcpy(&eight, text.data() + i, sizeof eight);
        if (i + sizeof eight <= text.size() && (eight & 0x8080808080808080U) == 0) {
            i += sizeof eight;
            continue;
        }
        const unsigned char c = byte(i);
        if (c < 0x80) {
            ++i;
            continue;
        }
        const int more = c >= 0xC2 && c <= 0xDF ? 1 : c >= 0xE0 && c <= 0xEF ? 2 : c >= 0xF0 && c <= 0xF4 ? 3 : 0;
        if (more == 0) return i;
        for (int k = 1; k <= more; ++k) {
            if ((byte(i + k) & 0xC0) != 0x80) return i;
        }
        const unsigned char next = byte(i + 1);
        if ((c == 0xE0 && next < 0xA0) || (c == 0xED && next > 0x9F) || (c == 0xF0 && next < 0x90) ||
            (c == 0xF4 && next > 0x8F)) {
            return i;
        }
        i += more + 1;
    }
    return std::string::npos;
}

long line_at(const std::string& text, std::size_t offset) {
    return 1 +
           std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(std::min(offset, text.size())), '\n');
}

/// Where the first word stands: after a byte order mark, white space and lines that begin with '#'.
std::size_t first_word(const std::string& text) {
    std::size_t i = text.starts_with("\xEF\xBB\xBF") ? 3 : 0;
    while (i < text.size()) {
        if (std::strchr(" \t\r\n", text[i]) != nullptr && text[i] != '\0') {
            ++i;
        } else if (text[i] == '#') {
            i = std::min(text.find('\n', i), text.size());
        } else {
            break;
        }
    }
    return i;
}

/// XML begins with '<' and, unlike an IRI of Turtle, goes on with '?', '!' or a name that a space or line break ends;
/// or with a name and '>', and then a tag of that name ends it. An IRI has a ':' or '#', and no end tag.
bool looks_like_xml(std::string_view text) {
    if (text.size() < 2 || text[0] != '<') return false;
    if (text[1] == '?' || text[1] == '!') return true;
    const std::size_t end = text.find_first_of("<> \t\r\n", 1);
    if (end == std::string_view::npos || end == 1) return false;
    if (text[end] != '>') return text[end] != '<';
    const std::string_view name = text.substr(1, end - 1);
    return name.find_first_of(":#") == std::string_view::npos ||
           text.find(between("</", std::string(name), ">")) != std::string_view::npos;
}

bool is_utf16(const std::string& bytes) { return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"); }

/// The word before `mark`, when `text` begins with a word of letters, perhaps white space, and then `mark`.
std::string_view word_before(std::string_view text, char mark) {
    std::size_t end = 0;
    while (end < text.size() && ((text[end] >= 'A' && text[end] <= 'Z') || (text[end] >= 'a' && text[end] <= 'z')))
        ++end;
    const std::size_t next = text.find_first_not_of(" \t\r\n", end);
    return next != std::string_view::npos && text[next] == mark ? text.substr(0, end) : std::string_view();
}

/// "Class:" and the like: what a document in Manchester syntax may begin with.
bool looks_like_manchester(std::string_view text) {
    const std::string_view word = word_before(text, ':');
    if (word.empty() || text.size() <= word.size() || text[word.size()] != ':') return false;
    const std::size_t after = word.size() + 1;
    if (after < text.size() && std::strchr(" \t\r\n", text[after]) == nullptr && text[after] != '<') return false;
    for (const char* first :
         {"Prefix", "Ontology", "Import", "Annotations", "Datatype", "Class", "ObjectProperty", "DataProperty",
          "AnnotationProperty", "Individual", "Rule", "EquivalentClasses", "DisjointClasses", "EquivalentProperties",
          "DisjointProperties", "SameIndividual", "DifferentIndividuals"}) {
        if (word == first) return true;
    }
    return false;
}

/// Whether a Turtle document may begin so: with a directive, an IRI or a blank node. A prefixed name is a slip of one
/// who meant Turtle, since nothing above has declared its prefix; ordinary words are not.
bool may_be_turtle(std::string_view text) {
    if (text.empty() || std::strchr("@<[(_:", text[0]) != nullptr) return true;
    const std::size_t end = std::min(text.find_first_of(" \t\r\n"), text.size());
    std::string word(text.substr(0, end));
    const std::size_t colon = word.find(':');
    if (colon != std::string::npos && colon + 1 < word.size()) return true;
    for (char& c : word)
        if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return word == "PREFIX" || word == "BASE";
}

void read_text(const std::string& text, std::size_t start, const std::string& base, Graph& graph) {
    if (const std::size_t zero = text.find('\0'); zero != std::string::npos) {
        throw OntologyError(
            at(graph.file, line_at(text, zero), "holds a zero byte, so it is no text; an ontology is expected"));
    }
    if (const std::size_t bad = find_bad_utf8(text); bad != std::string::npos) {
        throw OntologyError(
            at(graph.file, line_at(text, bad), "holds bytes that are not UTF-8; save the file as UTF-8"));
    }
    const std::string_view rest = std::string_view(text).substr(start);
    const std::string_view call = word_before(rest, '(');
    if (call == "Prefix" || call == "Ontology") return read_functional(text, base, graph);
    if (looks_like_manchester(rest)) return read_manchester(text, base, graph);
    for (const auto& [begin, format] : {std::pair{"{", "JSON"}, std::pair{"format-version:", "OBO"}}) {
        if (!rest.starts_with(begin)) continue;
        throw OntologyError(at(graph.file, line_at(text, start),
                               std::string(format) + " is not read; save the ontology in a syntax of OWL 2, such as "
                                                     "Turtle (in Protégé: File > Save as)"));
    }
    if (!may_be_turtle(rest))
        throw OntologyError(at(graph.file, line_at(text, start),
                               "is no ontology; one in Turtle, N-Triples, RDF/XML, OWL/XML, functional or Manchester "
                               "syntax is expected (in Protégé: File > Save as)"));
    read_turtle(text, base, graph);
}

}  // namespace

bool is_utf8(const std::string& bytes) { return find_bad_utf8(bytes) == std::string::npos; }

bool append_utf8(std::string& text, std::uint32_t code_point) {
    if (code_point > 0x10FFFF || (code_point >= 0xD800 && code_point <= 0xDFFF)) return false;
    const auto put = [&text](std::uint32_t byte) { text += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (code_point < 0x80) {
        put(code_point);
    } else if (code_point < 0x800) {
        put(0xC0 | code_point >> 6);
        put(0x80 | (code_point & 0x3F));
    } else if (code_point < 0x10000) {
        put(0xE0 | code_point >> 12);
        put(0x80 | (code_point >> 6 & 0x3F));
        put(0x80 | (code_point & 0x3F));
    } else {
        put(0xF0 | code_point >> 18);
        put(0x80 | (code_point >> 12 & 0x3F));
        put(0x80 | (code_point >> 6 & 0x3F));
        put(0x80 | (code_point & 0x3F));
    }
    return true;
}

Graph read_document(const std::string& bytes, const std::string& name) {
    if (bytes.size() > max_document)
        throw OntologyError(at(name, 0,
                               "holds " + std::to_string(bytes.size() >> 20) + " MB; at most " +
                                   std::to_string(max_document >> 20) +
                                   " MB are read, so split it into ontologies that import each other"));
    Graph graph;
    graph.file = name;
    const std::size_t slash = name.find_last_of("/\\");
    const std::string base = "file:///" + (slash == std::string::npos ? name : name.substr(slash + 1));

    const std::size_t start = first_word(bytes);
    if (start < bytes.size()) {
        if (is_utf16(bytes) || looks_like_xml(std::string_view(bytes).substr(start))) {
            read_xml_document(bytes, base, graph);  // expat knows the encodings of XML
        } else {
            read_text(bytes, start, base, graph);
        }
    }
    if (graph.triples.empty()) {
        throw OntologyError(at(name, 0, "holds no statement; an ontology in a syntax of OWL 2 is expected"));
    }
    std::ranges::stable_sort(graph.triples, {}, &Triple::line);
    return graph;
}

}  // namespace partonomy::owl
