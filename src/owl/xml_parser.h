#pragma once

#include <exception>
#include <memory>
#include <string>
#include <vector>

#include "owl/rdf_graph.h"

struct XML_ParserStruct;

namespace partonomy::owl {

/// What hears the elements of an XML document. Names are namespace and local name in one; attributes are pairs of name
/// and value that a null pointer ends.
class XmlHandler {
public:
    virtual ~XmlHandler() = default;
    virtual void start(const std::string& name, const char** attributes) = 0;
    virtual void end() = 0;
    virtual void characters(const char* text, std::size_t length) = 0;
};

/// Expat, made safe: entities and document types that live elsewhere are refused, and every error is an OntologyError
/// with its line.
class XmlParser {
public:
    /// `text` and `file` are not copied.
    XmlParser(const std::string& text, const std::string& file);

    virtual ~XmlParser() = default;

    /// Reads the whole text. The handler is made for the root element, which it hears as its first.
    void read();

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] std::size_t offset() const;      ///< where the present event begins
    [[nodiscard]] std::size_t end_offset() const;  ///< where it ends
    [[nodiscard]] long line() const;
    [[noreturn]] void fail(const std::string& sentence) const;

protected:
    [[nodiscard]] virtual std::unique_ptr<XmlHandler> handler_for(const std::string& root, const char** attributes) = 0;

private:
    static XmlParser& self(void* data) { return *static_cast<XmlParser*>(data); }
    void connect();

    /// Runs a handler. An exception must not pass through expat, which is C: it waits until XML_Parse has returned.
    template <typename Handler>
    void guarded(Handler handler);

    const std::string& text_;
    const std::string& file_;
    std::unique_ptr<XML_ParserStruct, void (*)(XML_ParserStruct*)> parser_;
    std::unique_ptr<XmlHandler> handler_;
    std::vector<long> open_lines_;
    std::exception_ptr error_;
};

}  // namespace partonomy::owl
