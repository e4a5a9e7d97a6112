// From bytes to triples: which syntax is it, is it text at all, and the sentence for formats that we do not read.
//
// Turtle and RDF/XML are read by parsers of our own, not by raptor2. Measured (2 shared cores, raptor2 2.0.15): linking
// raptor2 alone costs each process 7 ms for its 36 libraries (curl, kerberos, ICU …) and its world another 4 ms, half
// of what a whole run may take; and it knows the line of a Turtle triple only as that of the closing bracket or dot.
// Our tests still ask it for a second opinion.

#include <algorithm>
#include <cstring>

#include "base/errors.h"
#include "owl/rdf_graph.h"

namespace partonomy::owl {
namespace {

/// Offset of the first byte that is not UTF-8, npos when all is well. Overlong forms and surrogates are not UTF-8.
std::size_t find_bad_utf8(const std::string& text) {
    const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(i < text.size() ? text[i] : 0); };
    for (std::size_t i = 0; i < text.size();) {
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

/// XML begins with '<' and, unlike an IRI of Turtle, goes on with '?', '!' or a name that a space or line break ends.
bool looks_like_xml(std::string_view text) {
    if (text.size() < 2 || text[0] != '<') return false;
    if (text[1] == '?' || text[1] == '!') return true;
    const std::size_t end = text.find_first_of("<> \t\r\n", 1);
    if (end == std::string_view::npos || end == 1) return false;
    if (text[end] == '>') return text.substr(1, end - 1).find("//") == std::string_view::npos && text[1] != '#';
    return text[end] != '<';
}

bool is_utf16(const std::string& bytes) { return bytes.starts_with("\xFF\xFE") || bytes.starts_with("\xFE\xFF"); }

void refuse_other_formats(const std::string& text, std::size_t start, const std::string& name) {
    const std::string_view rest = std::string_view(text).substr(start);
    const auto refuse = [&](const std::string& format) {
        throw OntologyError(
            at(name, line_at(text, start),
               format + " is not read; save the ontology as Turtle or RDF/XML (in Protégé: File > Save as)"));
    };
    if (rest.starts_with("Prefix(") || rest.starts_with("Ontology(")) refuse("OWL functional syntax");
    if (rest.starts_with("Prefix:") || rest.starts_with("Ontology:")) refuse("Manchester syntax");
    if (rest.starts_with("{")) refuse("JSON");
    if (rest.starts_with("format-version:")) refuse("OBO");
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

Graph read_rdf(const std::string& bytes, const std::string& name, std::size_t number) {
    Graph graph;
    graph.file = name;
    graph.number = number;
    const std::size_t slash = name.find_last_of("/\\");
    const std::string base = "file:///" + (slash == std::string::npos ? name : name.substr(slash + 1));

    const std::size_t start = first_word(bytes);
    if (start == bytes.size()) {
        throw OntologyError(at(name, 0, "holds no statement; an ontology in Turtle or RDF/XML is expected"));
    }
    if (is_utf16(bytes) || looks_like_xml(std::string_view(bytes).substr(start))) {
        read_rdf_xml(bytes, base, graph);  // expat knows the encodings of XML
    } else {
        if (const std::size_t zero = bytes.find('\0'); zero != std::string::npos) {
            throw OntologyError(
                at(name, line_at(bytes, zero),
                   "holds a zero byte, so it is no text; an ontology in Turtle or RDF/XML is expected"));
        }
        if (const std::size_t bad = find_bad_utf8(bytes); bad != std::string::npos) {
            throw OntologyError(
                at(name, line_at(bytes, bad), "holds bytes that are not UTF-8; save the file as UTF-8"));
        }
        refuse_other_formats(bytes, start, name);
        read_turtle(bytes, base, graph);
    }
    if (graph.triples.empty()) {
        throw OntologyError(at(name, 0, "holds no statement; an ontology in Turtle or RDF/XML is expected"));
    }
    std::ranges::stable_sort(graph.triples, {}, &Triple::line);
    return graph;
}

}  // namespace partonomy::owl
