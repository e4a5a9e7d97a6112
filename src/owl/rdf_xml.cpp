// RDF/XML (W3C Recommendation, 25 February 2014). The grammar stripes node elements and property elements; a stack of
// open elements says which comes next, so the nesting of the file costs memory, never stack. A triple stands on the
// line where the tag of its property element begins. rdf:ID on a property (reification) and rdf:bagID are refused: OWL
// 2 has no use for them. An XML literal is kept as it is written, not canonicalised. Linear in the length of the text
// after entities are expanded.

#include "owl/rdf_xml.h"

#include <algorithm>
#include <cstring>
#include <optional>

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

class RdfXmlReader final : public XmlHandler {
public:
    RdfXmlReader(const XmlParser& parser, const std::string& base, Graph& graph)
        : parser_(parser), graph_(graph), rdf_(rdf_prefix) {
        Open document;
        document.base = base;
        open_.push_back(document);
    }

    void start(const std::string& name, const char** pairs) override;
    void end() override;
    void characters(const char* text, std::size_t length) override;

private:
    void start_node(Open& element, const std::string& name, const Attributes& attributes);
    void start_property(Open& element, const std::string& name, const Attributes& attributes);
    void end_property(const Open& element);
    void attach(Node node);
    void property_attributes(Node subject, const Attributes& attributes, const Open& element);
    Attributes sort_attributes(const char** pairs, Open& element);
    Node iri(const std::string& reference, const Open& element) {
        return graph_.iri(resolve_iri(element.base, reference), element.line);
    }
    [[nodiscard]] long line() const { return parser_.line(); }
    [[noreturn]] void fail(const std::string& sentence) const { parser_.fail(sentence); }

    const XmlParser& parser_;
    Graph& graph_;
    const std::string rdf_;
    std::vector<Open> open_;
};

Attributes RdfXmlReader::sort_attributes(const char** pairs, Open& element) {
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
void RdfXmlReader::property_attributes(Node subject, const Attributes& attributes, const Open& element) {
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
void RdfXmlReader::attach(Node node) {
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

void RdfXmlReader::start_node(Open& element, const std::string& name, const Attributes& attributes) {
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
                      : attributes.node_id ? graph_.blank(*attributes.node_id)
                                           : graph_.blank();
    attach(element.subject);
    if (name != rdf_ + "Description") {
        graph_.add(element.subject, graph_.word(Word::rdf_type), graph_.iri(name, element.line), element.line);
    }
    property_attributes(element.subject, attributes, element);
}

void RdfXmlReader::start_property(Open& element, const std::string& name, const Attributes& attributes) {
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
            element.markup_begin = parser_.end_offset();
        }
    } else if (has_value || !attributes.properties.empty()) {
        if (attributes.datatype) fail("a property has a value or rdf:datatype, not both");
        const Node object = attributes.resource  ? iri(*attributes.resource, element)
                            : attributes.node_id ? graph_.blank(*attributes.node_id)
                                                 : graph_.blank();
        graph_.add(element.subject, element.predicate, object, element.line);
        property_attributes(object, attributes, element);
        element.is_closed = true;
    } else if (attributes.datatype) {
        element.datatype = graph_.terms[iri(*attributes.datatype, element)].value;
    }
}

void RdfXmlReader::start(const std::string& name, const char** pairs) {
    Open& parent = open_.back();
    if (parent.place == Place::markup) {
        ++parent.depth;
        return;
    }
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

void RdfXmlReader::end_property(const Open& element) {
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

void RdfXmlReader::end() {
    Open& element = open_.back();
    if (element.place == Place::markup && element.depth > 0) {
        --element.depth;
        return;
    }
    if (element.place == Place::markup && parser_.offset() > element.markup_begin &&
        parser_.offset() <= parser_.text().size()) {
        element.text = parser_.text().substr(element.markup_begin, parser_.offset() - element.markup_begin);
        if (!is_utf8(element.text)) fail("an XML literal is read from files in UTF-8 only; save the file as UTF-8");
    }
    const Open closed = std::move(element);
    open_.pop_back();
    if (closed.place == Place::property || closed.place == Place::collection || closed.place == Place::markup) {
        end_property(closed);
    }
}

void RdfXmlReader::characters(const char* text, std::size_t length) {
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

std::unique_ptr<XmlHandler> make_rdf_xml_handler(const XmlParser& parser, const std::string& base, Graph& graph) {
    return std::make_unique<RdfXmlReader>(parser, base, graph);
}

}  // namespace partonomy::owl
