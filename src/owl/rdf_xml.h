#pragma once

#include <memory>

#include "owl/xml_parser.h"

namespace partonomy::owl {

/// Fills `graph` from RDF/XML.
[[nodiscard]] std::unique_ptr<XmlHandler> make_rdf_xml_handler(const XmlParser& parser, const std::string& base,
                                                               Graph& graph);

}  // namespace partonomy::owl
