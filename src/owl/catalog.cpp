// Protégé's catalog-v001.xml: an OASIS XML catalog of which only <uri name="IRI" uri="file"/> matters, inside groups
// that may move the base. Paths are relative to the catalog; addresses on the network are passed over.

#include <expat.h>

#include <cstring>
#include <memory>

#include "base/errors.h"
#include "base/files.h"
#include "owl/imports.h"

namespace partonomy::owl {
namespace {

struct Search {
    std::string wanted;
    std::vector<std::string> bases{""};
    std::optional<std::string> found;
};

/// "%20" and the like as bytes; "file:" taken off. Empty for an address on the network.
std::string path_of(std::string uri) {
    if (uri.starts_with("file://"))
        uri.erase(0, 7);
    else if (uri.starts_with("file:"))
        uri.erase(0, 5);
    else if (uri.find("://") != std::string::npos)
        return {};
    std::string path;
    const auto digit = [](char c) {
        return c >= '0' && c <= '9'   ? c - '0'
               : c >= 'A' && c <= 'F' ? c - 'A' + 10
               : c >= 'a' && c <= 'f' ? c - 'a' + 10
                                      : -1;
    };
    for (std::size_t i = 0; i < uri.size(); ++i) {
        if (uri[i] == '%' && i + 2 < uri.size() && digit(uri[i + 1]) >= 0 && digit(uri[i + 2]) >= 0) {
            path += static_cast<char>(digit(uri[i + 1]) * 16 + digit(uri[i + 2]));
            i += 2;
        } else {
            path += uri[i];
        }
    }
    return path.find('\0') == std::string::npos ? path : std::string();
}

void start(void* data, const char* name, const char** pairs) {
    Search& search = *static_cast<Search*>(data);
    std::string base = search.bases.back();
    std::string iri;
    std::string uri;
    for (; *pairs != nullptr; pairs += 2) {
        if (std::strcmp(pairs[0], "xml:base") == 0) base = pairs[1];
        if (std::strcmp(pairs[0], "name") == 0) iri = pairs[1];
        if (std::strcmp(pairs[0], "uri") == 0) uri = pairs[1];
    }
    if (!base.empty() && base.back() != '/') base += '/';
    const char* colon = std::strrchr(name, ':');
    if (!search.found && iri == search.wanted && std::strcmp(colon != nullptr ? colon + 1 : name, "uri") == 0) {
        const bool is_absolute = uri.starts_with('/') || uri.find(':') != std::string::npos;
        const std::string path = path_of(is_absolute ? uri : base + uri);
        if (!path.empty()) search.found = path;
    }
    search.bases.push_back(base);
}

}  // namespace

std::optional<std::filesystem::path> look_up_catalog(const std::filesystem::path& folder, const Iri& iri) {
    const std::filesystem::path file = folder / "catalog-v001.xml";
    std::error_code error;
    if (!std::filesystem::is_regular_file(file, error)) return std::nullopt;
    const std::string bytes = read_file(file);
    const std::unique_ptr<XML_ParserStruct, decltype(&XML_ParserFree)> parser(XML_ParserCreate(nullptr),
                                                                              &XML_ParserFree);
    if (!parser) throw std::bad_alloc();
    Search search;
    search.wanted = iri;
    XML_SetUserData(parser.get(), &search);
    XML_SetElementHandler(parser.get(), &start,
                          [](void* data, const char*) { static_cast<Search*>(data)->bases.pop_back(); });
    if (bytes.size() > (std::size_t{1} << 28)) throw OntologyError(at(file.string(), 0, "is too large for a catalog"));
    if (XML_Parse(parser.get(), bytes.data(), static_cast<int>(bytes.size()), 1) != XML_STATUS_OK) {
        throw OntologyError(at(file.string(), static_cast<long>(XML_GetCurrentLineNumber(parser.get())),
                               std::string("the catalog is no well-formed XML (") +
                                   XML_ErrorString(XML_GetErrorCode(parser.get())) + "); mend or delete it"));
    }
    if (!search.found) return std::nullopt;
    return (folder / *search.found).lexically_normal();
}

}  // namespace partonomy::owl
