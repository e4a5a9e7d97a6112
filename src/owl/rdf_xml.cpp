// RDF/XML (W3C Recommendation, 25 February 2014) on top of expat. The grammar stripes node elements and property
// elements; a stack of open elements says which comes next, so the nesting of the file costs memory, never stack. A
// triple stands on the line where the tag of its property element begins.
//
// Safety: an entity that lives elsewhere, or an external DTD, is refused, since nothing but the bytes given is ever
// read; internal entities (Protégé declares its namespaces so) are expanded by expat, which stops entity bombs. rdf:ID
// on a property (reification) and rdf:bagID are refused: OWL 2 has no use for them. An XML literal is kept as it is
// written, not canonicalised. Linear in the length of the text after entities are expanded.

#include <expat.h>

#include <algorithm>
#include <cstring>
#include <map>
#include <memory>
#include <optional>

#include "base/errors.h"
#include "owl/rdf_graph.h"

namespace partonomy::owl {
namespace {

constexpr const char* xml_prefix = "http://www.w3.org/XML/1998/namespace";

enum class Place { document, rdf, node, property, collection, markup };

/// An open element.
struct Open {
    Place place = Place::document;
    long line = 0;
    std::string base, language;
    Node subject = 0;              ///< of a node; of the node around a property
    Node predicate = 0;            ///< of a property
    std::optional<Node> object;    ///< of a property, once known; in a collection the last cell
    std::string text, datatype;    ///< of a property
    bool is_closed = false;        ///< a property that may hold neither text nor elements
    int members = 0;               ///< rdf:li seen so far
    int depth = 0;                 ///< open tags inside an XML literal
    std::size_t markup_begin = 0;  ///< offset of an XML literal
};

/// The attributes of an element, sorted by what RDF makes of them.
struct Attributes {
    std::optional<std::string> about, id, node_id, resource, parse_type, datatype;
    std::vector<std::pair<std::string, std::string>> properties;
};

class XmlReader {
public:
    XmlReader(const std::string& text, const std::string& base, Graph& graph)
        : text_(text), graph_(graph), parser_(XML_ParserCreateNS(nullptr, '\0'), &XML_ParserFree), rdf_(rdf_prefix) {
        Open document;
        document.base = base;
        open_.push_back(document);
    }

    void read();

private:
    static XmlReader& self(void* data) { return *static_cast<XmlReader*>(data); }
    void connect();
    void start(const std::string& name, const char** pairs);
    void end();
    void characters(const char* text, std::size_t length);
    void start_node(Open& element, const std::string& name, const Attributes& attributes);
    void start_property(Open& element, const std::string& name, const Attributes& attributes);
    void end_property(const Open& element);
    void attach(Node node);
    void property_attributes(Node subject, const Attributes& attributes, const Open& element);
    Attributes sort_attributes(const char** pairs, Open& element);
    void check_root(const std::string& name, const char** pairs);
    Node labelled(const std::string& label);
    Node iri(const std::string& reference, const Open& element) {
        return graph_.iri(resolve_iri(element.base, reference), element.line);
    }
    [[nodiscard]] std::size_t offset() const {
        return static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get()));
    }
    [[nodiscard]] long line() const { return static_cast<long>(XML_GetCurrentLineNumber(parser_.get())); }
    [[noreturn]] void fail(const std::string& sentence) const {
        throw OntologyError(at(graph_.file, line(), sentence));
    }

    /// Runs a handler. An exception must not pass through expat, which is C: it waits until XML_Parse has returned.
    template <typename Handler>
    void guarded(Handler handler) {
        if (error_) return;
        try {
            handler();
        } catch (...) {
            error_ = std::current_exception();
            XML_StopParser(parser_.get(), XML_FALSE);
        }
    }

    const std::string& text_;
    Graph& graph_;
    std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser_;
    const std::string rdf_;
    std::vector<Open> open_;
    std::map<std::string, Node> labels_;
    std::exception_ptr error_;
};

void XmlReader::connect() {
    XML_Parser parser = parser_.get();
    XML_SetUserData(parser, this);
    XML_SetElementHandler(
        parser,
        [](void* data, const char* name, const char** pairs) {
            self(data).guarded([&] { self(data).start(name, pairs); });
        },
        [](void* data, const char*) { self(data).guarded([&] { self(data).end(); }); });
    XML_SetCharacterDataHandler(parser, [](void* data, const char* text, int length) {
        self(data).guarded([&] { self(data).characters(text, static_cast<std::size_t>(length)); });
    });
    XML_SetDoctypeDeclHandler(
        parser,
        [](void* data, const char*, const char* system, const char* open, int) {
            self(data).guarded([&] {
                if (system != nullptr || open != nullptr) {
                    self(data).fail(
                        "the document type lives in another file, which is never read; remove it or write its entities "
                        "into this file");
                }
            });
        },
        nullptr);
    XML_SetEntityDeclHandler(parser, [](void* data, const char* name, int, const char*, int, const char*,
                                        const char* system, const char*, const char*) {
        self(data).guarded([&] {
            if (system != nullptr) {
                self(data).fail("the entity '" + std::string(name) +
                                "' lives in another file, which is never read; write its text into this file");
            }
        });
    });
    XML_SetSkippedEntityHandler(parser, [](void* data, const char* name, int) {
        self(data).guarded([&] {
            self(data).fail("the entity '" + std::string(name) +
                            "' is not declared in this file, and no other is read");
        });
    });
}

std::string syntax_sentence(XML_Error code) {
    switch (code) {
        case XML_ERROR_NO_ELEMENTS:
            return "the XML ends before its first element is complete; is the file cut off?";
        case XML_ERROR_TAG_MISMATCH:
            return "an XML tag is closed by another name than it was opened with";
        case XML_ERROR_UNCLOSED_TOKEN:
            return "the XML ends inside a tag, comment or entity; is the file cut off?";
        case XML_ERROR_UNCLOSED_CDATA_SECTION:
            return "a CDATA section is never closed";
        case XML_ERROR_UNBOUND_PREFIX:
            return "the prefix of an XML name has no xmlns declaration";
        case XML_ERROR_UNDEFINED_ENTITY:
            return "an XML entity (&name;) is used but not declared";
        case XML_ERROR_RECURSIVE_ENTITY_REF:
            return "an XML entity contains itself";
        case XML_ERROR_AMPLIFICATION_LIMIT_BREACH:
            return "the entities of this file blow up to a size that no ontology needs";
        case XML_ERROR_JUNK_AFTER_DOC_ELEMENT:
            return "text follows the end of the XML document";
        case XML_ERROR_DUPLICATE_ATTRIBUTE:
            return "an XML attribute occurs twice in one tag";
        case XML_ERROR_UNKNOWN_ENCODING:
            return "the encoding that the XML declares is unknown; save the file as UTF-8";
        default:
            return std::string("XML syntax error (") + XML_ErrorString(code) + ")";
    }
}

void XmlReader::read() {
    if (!parser_) throw std::bad_alloc();
    connect();
    constexpr std::size_t block = std::size_t{1} << 28;
    for (std::size_t from = 0;; from += block) {
        const std::size_t size = std::min(block, text_.size() - from);
        const bool is_last = from + size == text_.size();
        const XML_Status status = XML_Parse(parser_.get(), text_.data() + from, static_cast<int>(size), is_last);
        if (error_) std::rethrow_exception(error_);
        if (status != XML_STATUS_OK) {
            const XML_Error code = XML_GetErrorCode(parser_.get());
            if (is_last && open_.size() > 1 && code == XML_ERROR_NO_ELEMENTS) {
                fail("the XML ends before the tag of line " + std::to_string(open_.back().line) +
                     " is closed; is the file cut off?");
            }
            fail(syntax_sentence(code));
        }
        if (is_last) return;
    }
}

Node XmlReader::labelled(const std::string& label) {
    const auto [entry, is_new] = labels_.try_emplace(label, 0);
    if (is_new) entry->second = graph_.blank();
    return entry->second;
}

void XmlReader::check_root(const std::string& name, const char** pairs) {
    if (name == rdf_ + "RDF") return;
    bool has_about = false;
    for (const char** pair = pairs; *pair != nullptr; pair += 2) has_about |= pair[0] == rdf_ + "about";
    if (name == std::string(owl_prefix) + "Ontology" && !has_about) {
        fail("OWL/XML is not read; save the ontology as Turtle or RDF/XML (in Protégé: File > Save as)");
    }
    if (name.find(':') == std::string::npos) {
        fail("the root element '" + name + "' is not RDF/XML, which begins with rdf:RDF");
    }
}

Attributes XmlReader::sort_attributes(const char** pairs, Open& element) {
    Attributes sorted;
    std::vector<std::pair<std::string, std::string>> list;
    for (const char** pair = pairs; *pair != nullptr; pair += 2) list.emplace_back(pair[0], pair[1]);
    for (auto& [name, value] : list) {
        if (name.starts_with(xml_prefix)) {
            const std::string local = name.substr(std::strlen(xml_prefix));
            if (local == "base") element.base = resolve_iri(element.base, value);
            if (local == "lang") element.language = value;
        } else if (name.starts_with(rdf_)) {
            const std::string local = name.substr(rdf_.size());
            if (local == "about")
                sorted.about = value;
            else if (local == "ID")
                sorted.id = value;
            else if (local == "nodeID")
                sorted.node_id = value;
            else if (local == "resource")
                sorted.resource = value;
            else if (local == "parseType")
                sorted.parse_type = value;
            else if (local == "datatype")
                sorted.datatype = value;
            else if (local == "bagID" || local == "aboutEach" || local == "aboutEachPrefix" || local == "li" ||
                     local == "RDF" || local == "Description") {
                fail("rdf:" + local + " is no attribute of RDF/XML");
            } else
                sorted.properties.emplace_back(std::move(name), std::move(value));
        } else if (name.find(':') == std::string::npos) {
            fail("the attribute '" + name + "' has no namespace; rdf:" + name + " may be meant");
        } else {
            sorted.properties.emplace_back(std::move(name), std::move(value));
        }
    }
    return sorted;
}

/// Triples from attributes that are properties.
void XmlReader::property_attributes(Node subject, const Attributes& attributes, const Open& element) {
    for (const auto& [name, value] : attributes.properties) {
        const Node predicate = graph_.iri(name, element.line);
        const bool is_type = predicate == graph_.word(Word::rdf_type);
        const Node object = is_type                    ? iri(value, element)
                            : element.language.empty() ? graph_.literal(value, std::string(xsd_prefix) + "string")
                                                       : graph_.literal(value, rdf_ + "langString", element.language);
        graph_.add(subject, predicate, object, element.line);
    }
}

/// A node has become the value of the property around it, or the next member of its collection.
void XmlReader::attach(Node node) {
    Open& parent = open_.back();
    if (parent.place == Place::property) {
        if (parent.object || parent.is_closed) fail("a property element holds one value; a second one begins here");
        parent.object = node;
        graph_.add(parent.subject, parent.predicate, node, parent.line);
    } else if (parent.place == Place::collection) {
        const Node cell = graph_.blank();
        if (parent.object) {
            graph_.add(*parent.object, graph_.word(Word::rdf_rest), cell, line());
        } else {
            graph_.add(parent.subject, parent.predicate, cell, parent.line);
        }
        graph_.add(cell, graph_.word(Word::rdf_first), node, line());
        parent.object = cell;
    }
}

void XmlReader::start_node(Open& element, const std::string& name, const Attributes& attributes) {
    if ((attributes.about.has_value() + attributes.id.has_value() + attributes.node_id.has_value()) > 1) {
        fail("an element is named by one of rdf:about, rdf:ID and rdf:nodeID, not by several");
    }
    if (attributes.resource || attributes.parse_type || attributes.datatype) {
        fail("rdf:resource, rdf:parseType and rdf:datatype belong to properties; " + short_name(name) +
             " stands for a thing, named by rdf:about");
    }
    element.place = Place::node;
    element.subject = attributes.about     ? iri(*attributes.about, element)
                      : attributes.id      ? iri("#" + *attributes.id, element)
                      : attributes.node_id ? labelled(*attributes.node_id)
                                           : graph_.blank();
    attach(element.subject);
    if (name != rdf_ + "Description") {
        graph_.add(element.subject, graph_.word(Word::rdf_type), graph_.iri(name, element.line), element.line);
    }
    property_attributes(element.subject, attributes, element);
}

void XmlReader::start_property(Open& element, const std::string& name, const Attributes& attributes) {
    Open& parent = open_.back();
    if (attributes.about) {
        fail(short_name(name) + " stands where a property is expected, which has rdf:resource instead of rdf:about");
    }
    if (name == rdf_ + "Description" || name == rdf_ + "RDF") {
        fail(short_name(name) + " stands where a property is expected");
    }
    if (attributes.id) fail("rdf:ID on a property reifies its statement, which OWL 2 does with owl:Axiom");
    element.subject = parent.subject;
    element.predicate =
        graph_.iri(name == rdf_ + "li" ? rdf_ + "_" + std::to_string(++parent.members) : name, element.line);
    element.place = Place::property;

    const bool has_value = attributes.resource || attributes.node_id;
    if (attributes.resource && attributes.node_id) fail("a property has rdf:resource or rdf:nodeID, not both");
    if (attributes.parse_type) {
        if (has_value || attributes.datatype || !attributes.properties.empty()) {
            fail("rdf:parseType stands alone in its tag");
        }
        if (*attributes.parse_type == "Resource") {
            const Node node = graph_.blank();
            graph_.add(element.subject, element.predicate, node, element.line);
            element.place = Place::node;
            element.subject = node;
        } else if (*attributes.parse_type == "Collection") {
            element.place = Place::collection;
        } else {
            element.place = Place::markup;
            element.markup_begin = offset() + static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get()));
        }
    } else if (has_value || !attributes.properties.empty()) {
        if (attributes.datatype) fail("a property has a value or rdf:datatype, not both");
        const Node object = attributes.resource  ? iri(*attributes.resource, element)
                            : attributes.node_id ? labelled(*attributes.node_id)
                                                 : graph_.blank();
        graph_.add(element.subject, element.predicate, object, element.line);
        property_attributes(object, attributes, element);
        element.is_closed = true;
    } else if (attributes.datatype) {
        element.datatype = graph_.terms[iri(*attributes.datatype, element)].value;
    }
}

void XmlReader::start(const std::string& name, const char** pairs) {
    Open& parent = open_.back();
    if (parent.place == Place::markup) {
        ++parent.depth;
        return;
    }
    if (parent.place == Place::document) check_root(name, pairs);
    if (name.find(':') == std::string::npos) {
        fail("the element '" + name + "' has no namespace, so it is no name of RDF; add an xmlns declaration");
    }
    Open element;
    element.line = line();
    element.base = parent.base;
    element.language = parent.language;
    const Attributes attributes = sort_attributes(pairs, element);
    if (parent.place == Place::document && name == rdf_ + "RDF") {
        element.place = Place::rdf;
    } else if (parent.place == Place::node) {
        start_property(element, name, attributes);
    } else {
        if (parent.place == Place::property && parent.text.find_first_not_of(" \t\r\n") != std::string::npos) {
            fail("a property holds text or an element, not both");
        }
        start_node(element, name, attributes);
    }
    open_.push_back(std::move(element));
}

void XmlReader::end_property(const Open& element) {
    if (element.place == Place::collection) {
        const Node nil = graph_.word(Word::rdf_nil);
        if (element.object) {
            graph_.add(*element.object, graph_.word(Word::rdf_rest), nil, line());
        } else {
            graph_.add(element.subject, element.predicate, nil, element.line);
        }
        return;
    }
    if (element.object || element.is_closed) return;
    const Node value = element.place == Place::markup ? graph_.literal(element.text, rdf_ + "XMLLiteral")
                       : !element.datatype.empty()    ? graph_.literal(element.text, element.datatype)
                       : element.language.empty()     ? graph_.literal(element.text, std::string(xsd_prefix) + "string")
                                                  : graph_.literal(element.text, rdf_ + "langString", element.language);
    graph_.add(element.subject, element.predicate, value, element.line);
}

void XmlReader::end() {
    Open& element = open_.back();
    if (element.place == Place::markup && element.depth > 0) {
        --element.depth;
        return;
    }
    if (element.place == Place::markup && offset() > element.markup_begin && offset() <= text_.size()) {
        element.text = text_.substr(element.markup_begin, offset() - element.markup_begin);
        if (!is_utf8(element.text)) fail("an XML literal is read from files in UTF-8 only; save the file as UTF-8");
    }
    const Open closed = std::move(element);
    open_.pop_back();
    if (closed.place == Place::property || closed.place == Place::collection || closed.place == Place::markup) {
        end_property(closed);
    }
}

void XmlReader::characters(const char* text, std::size_t length) {
    Open& element = open_.back();
    if (element.place == Place::markup) return;  // cut out whole at its end
    const bool is_blank = std::all_of(text, text + length, [](char c) { return std::strchr(" \t\r\n", c) != nullptr; });
    if (element.place == Place::property && !element.object && !element.is_closed) {
        element.text.append(text, length);
    } else if (!is_blank) {
        fail("text stands where an element is expected");
    }
}

}  // namespace

void read_rdf_xml(const std::string& text, const std::string& base, Graph& graph) {
    XmlReader(text, base, graph).read();
}

}  // namespace partonomy::owl
