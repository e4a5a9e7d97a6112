// Relative IRIs, by the algorithm of RFC 3986 section 5.2: split both into scheme, authority, path, query and fragment,
// take what the reference has and the rest from the base, and let "." and ".." walk the path. Linear in the length.

#include <algorithm>
#include <optional>

#include "owl/rdf_graph.h"

namespace partonomy::owl {
namespace {

struct Parts {
    std::optional<std::string> scheme, authority, query, fragment;
    std::string path;
};

bool is_scheme(const std::string& text) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    if (text.empty() || !is_letter(text[0])) return false;
    return std::ranges::all_of(
        text, [&](char c) { return is_letter(c) || (c >= '0' && c <= '9') || c == '+' || c == '-' || c == '.'; });
}

Parts split(std::string rest) {
    Parts parts;
    const auto cut = [&rest](std::size_t where) {
        std::string tail = rest.substr(where + 1);
        rest.resize(where);
        return tail;
    };
    if (const auto hash = rest.find('#'); hash != std::string::npos) parts.fragment = cut(hash);
    if (const auto mark = rest.find('?'); mark != std::string::npos) parts.query = cut(mark);
    if (const auto colon = rest.find(':'); colon != std::string::npos && is_scheme(rest.substr(0, colon))) {
        parts.scheme = rest.substr(0, colon);
        rest.erase(0, colon + 1);
    }
    if (rest.starts_with("//")) {
        const auto slash = std::min(rest.find('/', 2), rest.size());
        parts.authority = rest.substr(2, slash - 2);
        rest.erase(0, slash);
    }
    parts.path = rest;
    return parts;
}

std::string without_dots(const std::string& path) {
    std::string out;
    std::size_t i = 0;
    while (i < path.size()) {
        const std::size_t begin = i;
        const bool slash = path[i] == '/';
        const std::size_t end = std::min(path.find('/', i + (slash ? 1 : 0)), path.size());
        const std::string segment = path.substr(begin + (slash ? 1 : 0), end - begin - (slash ? 1 : 0));
        const bool is_last = end == path.size();
        if (segment == "." || segment == "..") {
            if (segment == "..") out.resize(std::min(out.rfind('/'), out.size()) == out.size() ? 0 : out.rfind('/'));
            if (is_last) out += '/';
        } else {
            out.append(path, begin, end - begin);
        }
        i = end;
    }
    return out;
}

}  // namespace

std::string resolve_iri(const std::string& base, const std::string& reference) {
    // An absolute IRI stays as it is written: OWL compares IRIs letter by letter.
    Parts target = split(reference);
    if (target.scheme) return reference;
    const Parts from = split(base);
    target.scheme = from.scheme;
    if (!target.authority) {
        target.authority = from.authority;
        if (target.path.empty()) {
            target.path = from.path;
            if (!target.query) target.query = from.query;
        } else if (target.path[0] == '/') {
            target.path = without_dots(target.path);
        } else {
            const auto slash = from.path.rfind('/');
            const std::string folder =
                slash == std::string::npos ? (from.authority ? "/" : "") : from.path.substr(0, slash + 1);
            target.path = without_dots(folder + target.path);
        }
    }
    std::string iri = target.scheme ? *target.scheme + ":" : std::string();
    if (target.authority) iri += "//" + *target.authority;
    iri += target.path;
    if (target.query) iri += "?" + *target.query;
    if (target.fragment) iri += "#" + *target.fragment;
    return iri;
}

}  // namespace partonomy::owl
