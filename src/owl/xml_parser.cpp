// XML on top of expat. Safety: an entity that lives elsewhere, or an external DTD, is refused, since nothing but the
// bytes given is ever read; internal entities (Protégé declares its namespaces so) are expanded by expat, which stops
// entity bombs. Which of the two XML syntaxes a document has, its root element says.

#include "owl/xml_parser.h"

#include <expat.h>

#include <algorithm>

#include "base/errors.h"
#include "owl/owl_xml.h"
#include "owl/rdf_xml.h"

namespace partonomy::owl {
namespace {

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

/// RDF/XML or OWL/XML.
class OntologyParser final : public XmlParser {
public:
    OntologyParser(const std::string& text, std::string base, Graph& graph)
        : XmlParser(text, graph.file), base_(std::move(base)), graph_(graph) {}

private:
    std::unique_ptr<XmlHandler> handler_for(const std::string& root, const char** attributes) override {
        bool has_about = false;
        for (const char** pair = attributes; *pair != nullptr; pair += 2)
            has_about |= pair[0] == std::string(rdf_prefix) + "about";
        if (root == std::string(owl_prefix) + "Ontology" && !has_about)
            return make_owl_xml_handler(*this, base_, graph_);
        if (root.find(':') == std::string::npos) {
            fail("the root element '" + root + "' is neither RDF/XML, which begins with rdf:RDF, nor OWL/XML");
        }
        return make_rdf_xml_handler(*this, base_, graph_);
    }

    std::string base_;
    Graph& graph_;
};

}  // namespace

XmlParser::XmlParser(const std::string& text, const std::string& file)
    : text_(text), file_(file), parser_(XML_ParserCreateNS(nullptr, '\0'), &XML_ParserFree) {
    if (!parser_) throw std::bad_alloc();
    connect();
}

std::size_t XmlParser::offset() const { return static_cast<std::size_t>(XML_GetCurrentByteIndex(parser_.get())); }

std::size_t XmlParser::end_offset() const {
    return offset() + static_cast<std::size_t>(XML_GetCurrentByteCount(parser_.get()));
}

long XmlParser::line() const { return static_cast<long>(XML_GetCurrentLineNumber(parser_.get())); }

void XmlParser::fail(const std::string& sentence) const { throw OntologyError(at(file_, line(), sentence)); }

template <typename Handler>
void XmlParser::guarded(Handler handler) {
    if (error_) return;
    try {
        handler();
    } catch (...) {
        error_ = std::current_exception();
        XML_StopParser(parser_.get(), XML_FALSE);
    }
}

void XmlParser::connect() {
    XML_Parser parser = parser_.get();
    XML_SetUserData(parser, this);
    XML_SetElementHandler(
        parser,
        [](void* data, const char* name, const char** pairs) {
            XmlParser& owner = self(data);
            owner.guarded([&] {
                if (!owner.handler_) owner.handler_ = owner.handler_for(name, pairs);
                owner.open_lines_.push_back(owner.line());
                owner.handler_->start(name, pairs);
            });
        },
        [](void* data, const char*) {
            XmlParser& owner = self(data);
            owner.guarded([&] {
                owner.open_lines_.pop_back();
                owner.handler_->end();
            });
        });
    XML_SetCharacterDataHandler(parser, [](void* data, const char* text, int length) {
        XmlParser& owner = self(data);
        owner.guarded([&] { owner.handler_->characters(text, static_cast<std::size_t>(length)); });
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

void XmlParser::read() {
    constexpr std::size_t block = std::size_t{1} << 28;
    for (std::size_t from = 0;; from += block) {
        const std::size_t size = std::min(block, text_.size() - from);
        const bool is_last = from + size == text_.size();
        const XML_Status status = XML_Parse(parser_.get(), text_.data() + from, static_cast<int>(size), is_last);
        if (error_) std::rethrow_exception(error_);
        if (status != XML_STATUS_OK) {
            const XML_Error code = XML_GetErrorCode(parser_.get());
            if (is_last && !open_lines_.empty() && code == XML_ERROR_NO_ELEMENTS) {
                fail("the XML ends before the tag of line " + std::to_string(open_lines_.back()) +
                     " is closed; is the file cut off?");
            }
            fail(syntax_sentence(code));
        }
        if (is_last) return;
    }
}

void read_xml_document(const std::string& text, const std::string& base, Graph& graph) {
    OntologyParser(text, base, graph).read();
}

}  // namespace partonomy::owl
