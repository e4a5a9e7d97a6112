// Data ranges out of triples (W3C OWL 2 "Mapping to RDF Graphs", table 12): datatypes with facets, enumerations, and
// what is made of other ranges. A range is a value, copied where it is used; a shared node is read once for each use,
// so the number of ranges read is bounded.

#include <algorithm>
#include <charconv>
#include <cmath>

#include "owl/expressions.h"

namespace partonomy::owl {
namespace {

constexpr std::size_t max_data_ranges = 1'000'000;

bool is_number(const std::string& text) {
    double value = 0;
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* end = text.data() + text.size();
    if (text == "INF" || text == "-INF" || text == "+INF") return true;
    const auto result = std::from_chars(begin, end, value);
    return result.ptr == end && result.ec == std::errc() && std::isfinite(value);
}

bool is_numeric_type(const Iri& datatype) {
    for (const char* name : numeric_datatypes) {
        if (datatype == std::string(xsd_prefix) + name) return true;
    }
    return false;
}

}  // namespace

Iri Expressions::datatype(Node node, long line) const {
    if (term(node).kind != TermKind::iri || !declarations_.has(term(node).value, EntityKind::datatype))
        reject_undeclared(node, EntityKind::datatype, line);
    return term(node).value;
}

bool Expressions::is_data_range(Node node) const {
    // Down the first operands, as far as expressions may nest.
    for (int depth = 0; depth < 500; ++depth) {
        if (term(node).kind == TermKind::literal) return true;
        if (term(node).kind == TermKind::iri) return declarations_.has(term(node).value, EntityKind::datatype);
        const Triple* inner = nullptr;
        for (const std::uint32_t i : about(node)) {
            switch (term(graph_.triples[i].predicate).word) {
                case Word::owl_onDatatype:
                case Word::owl_datatypeComplementOf:
                    return true;
                case Word::owl_complementOf:
                case Word::owl_intersectionOf:
                case Word::owl_unionOf:
                case Word::owl_oneOf:
                case Word::rdf_first:
                    inner = &graph_.triples[i];
                    break;
                default:
                    break;
            }
        }
        if (inner == nullptr) return false;
        node = inner->object;
    }
    return false;
}

DataRange Expressions::data_range(Node node, long line) {
    if (++data_ranges_ > max_data_ranges + graph_.triples.size()) {
        fail(line, "data ranges have more than " + std::to_string(max_data_ranges) +
                       " members when written out; give parts of them names");
    }
    if (term(node).kind != TermKind::blank) {
        DataRange range;
        range.datatype = datatype(node, line);
        return range;
    }
    const Nested nested(*this, node, line, "a data range");
    const Triple* on_datatype = nullptr;
    const Triple* facets = nullptr;
    const Triple* made_of = nullptr;
    const auto take = [&](const Triple*& slot, const Triple& triple) {
        if (slot != nullptr)
            fail(triple.line, "a data range has two values of " + shown(triple.predicate) + "; one is right");
        slot = &triple;
    };
    for (const std::uint32_t i : about(node)) {
        const Triple& triple = graph_.triples[i];
        const Word word = term(triple.predicate).word;
        used[i] = 1;
        if (word == Word::owl_onDatatype) {
            take(on_datatype, triple);
        } else if (word == Word::owl_withRestrictions) {
            take(facets, triple);
        } else if (word == Word::owl_oneOf || word == Word::owl_intersectionOf || word == Word::owl_unionOf ||
                   word == Word::owl_datatypeComplementOf ||
                   (word == Word::owl_complementOf && graph_.kinds_are_open)) {
            take(made_of, triple);
        } else if (word != Word::rdf_type || (term(triple.object).word != Word::rdfs_Datatype &&
                                              term(triple.object).word != Word::owl_DataRange)) {
            fail(triple.line, shown(word == Word::rdf_type ? triple.object : triple.predicate) +
                                  " has no place in a data range, which a data property wants here");
        }
    }
    if (made_of != nullptr && on_datatype == nullptr && facets == nullptr)
        return term(made_of->predicate).word == Word::owl_oneOf ? data_one_of(*made_of) : data_connective(*made_of);
    if (made_of != nullptr || on_datatype == nullptr || facets == nullptr) {
        fail(line,
             "a data range is a datatype, owl:onDatatype with owl:withRestrictions, owl:oneOf, or made of others by "
             "owl:intersectionOf, owl:unionOf or owl:datatypeComplementOf");
    }
    return datatype_restriction(*on_datatype, *facets);
}

DataRange Expressions::data_connective(const Triple& triple) {
    const Word word = term(triple.predicate).word;
    DataRange range;
    range.kind = word == Word::owl_intersectionOf ? DataRangeKind::intersection_of
                 : word == Word::owl_unionOf      ? DataRangeKind::union_of
                                                  : DataRangeKind::complement_of;
    if (range.kind == DataRangeKind::complement_of) {
        range.operands.push_back(data_range(triple.object, triple.line));
    } else {
        for (const Node member : list(triple.object, triple.line))
            range.operands.push_back(data_range(member, triple.line));
        if (range.operands.empty())
            fail(triple.line, shown(triple.predicate) + " has an empty list; it needs at least one member");
    }
    return range;
}

DataRange Expressions::data_one_of(const Triple& triple) {
    DataRange range;
    for (const Node member : list(triple.object, triple.line)) {
        if (term(member).kind != TermKind::literal) {
            fail(triple.line, "owl:oneOf of a data range lists literals, not " + shown(member));
        }
        range.values.push_back(literal(member));
    }
    if (range.values.empty()) fail(triple.line, "owl:oneOf has an empty list; it needs at least one member");
    range.kind = DataRangeKind::one_of;
    range.datatype = range.values.front().datatype;
    for (const Literal& value : range.values) {
        if (value.datatype != range.datatype) range.datatype = std::string(rdfs_prefix) + "Literal";
    }
    return range;
}

DataRange Expressions::datatype_restriction(const Triple& on_datatype, const Triple& facets) {
    DataRange range;
    range.datatype = datatype(on_datatype.object, on_datatype.line);
    for (const Node facet : list(facets.object, facets.line)) add_facet(facet, facets.line, range);
    return range;
}

void Expressions::add_facet(Node node, long line, DataRange& range) {
    if (term(node).kind != TermKind::blank || about(node).empty()) {
        fail(line, "owl:withRestrictions lists facets such as [ xsd:minInclusive 0.4 ], not " + shown(node));
    }
    for (const std::uint32_t i : about(node)) {
        const Triple& triple = graph_.triples[i];
        used[i] = 1;
        const Iri& facet = term(triple.predicate).value;
        bool is_known = facet == std::string(rdf_prefix) + "langRange";
        bool is_bound = false;
        for (const char* name : {"minInclusive", "maxInclusive", "minExclusive", "maxExclusive", "length", "minLength",
                                 "maxLength", "pattern", "totalDigits", "fractionDigits"}) {
            if (facet != std::string(xsd_prefix) + name) continue;
            is_known = true;
            is_bound = std::string_view(name).ends_with("clusive");
        }
        if (!is_known)
            fail(triple.line,
                 shown(triple.predicate) + " is no facet; xsd:minInclusive and xsd:maxInclusive are, for example");
        if (term(triple.object).kind != TermKind::literal)
            fail(triple.line, shown(triple.predicate) + " wants a literal, not " + shown(triple.object));
        if (is_bound && is_numeric_type(range.datatype) && !is_number(term(triple.object).value)) {
            fail(triple.line, shown(triple.predicate) + " of " + short_name(range.datatype) + " wants a number, not " +
                                  shown(triple.object));
        }
        range.facets.emplace_back(facet, literal(triple.object));
    }
}

}  // namespace partonomy::owl
