// Restrictions and data ranges: the part of the mapping where it matters whether a property leads to things or to data.

#include <charconv>
#include <cmath>
#include <optional>

#include "owl/expressions.h"

namespace partonomy::owl {
namespace {

struct Filler {
    ClassKind over_things, over_data;
    bool is_cardinality, is_qualified;
};

std::optional<Filler> filler_of(Word word) {
    using K = ClassKind;
    switch (word) {
        case Word::owl_someValuesFrom:
            return Filler{K::some_values_from, K::data_some_values_from, false, false};
        case Word::owl_allValuesFrom:
            return Filler{K::all_values_from, K::data_all_values_from, false, false};
        case Word::owl_hasValue:
            return Filler{K::has_value, K::data_has_value, false, false};
        case Word::owl_hasSelf:
            return Filler{K::has_self, K::has_self, false, false};
        case Word::owl_minCardinality:
            return Filler{K::min_cardinality, K::data_min_cardinality, true, false};
        case Word::owl_maxCardinality:
            return Filler{K::max_cardinality, K::data_max_cardinality, true, false};
        case Word::owl_cardinality:
            return Filler{K::exact_cardinality, K::data_exact_cardinality, true, false};
        case Word::owl_minQualifiedCardinality:
            return Filler{K::min_cardinality, K::data_min_cardinality, true, true};
        case Word::owl_maxQualifiedCardinality:
            return Filler{K::max_cardinality, K::data_max_cardinality, true, true};
        case Word::owl_qualifiedCardinality:
            return Filler{K::exact_cardinality, K::data_exact_cardinality, true, true};
        default:
            return std::nullopt;
    }
}

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

std::uint32_t Expressions::count(const Triple& triple) const {
    const Term& number = term(triple.object);
    const char* begin = number.value.data() + (number.value.starts_with('+') ? 1 : 0);
    const char* end = number.value.data() + number.value.size();
    std::uint32_t value = 0;
    const auto result = std::from_chars(begin, end, value);
    if (number.kind != TermKind::literal || result.ptr != end || result.ec != std::errc()) {
        fail(triple.line, shown(triple.predicate) +
                              " wants a whole number such as \"3\"^^xsd:nonNegativeInteger, not " +
                              shown(triple.object));
    }
    return value;
}

Expressions::Made Expressions::restriction(Node node, long line) {
    const Triple* on_property = nullptr;
    const Triple* value = nullptr;
    const Triple* qualifier = nullptr;
    const auto take = [&](const Triple*& slot, const Triple& triple) {
        if (slot != nullptr) {
            fail(triple.line, "a restriction has both " + shown(slot->predicate) + " and " + shown(triple.predicate) +
                                  "; write two restrictions");
        }
        slot = &triple;
    };
    for (const std::uint32_t i : about(node)) {
        const Triple& triple = graph_.triples[i];
        const Word word = term(triple.predicate).word;
        if (word == Word::rdf_type || word == Word::rdfs_subClassOf || word == Word::owl_equivalentClass ||
            word == Word::owl_disjointWith) {
            continue;
        }
        used[i] = 1;
        if (word == Word::owl_onProperty) {
            take(on_property, triple);
        } else if (filler_of(word)) {
            take(value, triple);
        } else if (word == Word::owl_onClass || word == Word::owl_onDataRange) {
            take(qualifier, triple);
        } else if (word == Word::owl_onProperties) {
            fail(triple.line,
                 "a restriction on several properties (owl:onProperties) is not covered; use owl:onProperty");
        } else {
            fail(triple.line, shown(triple.predicate) + " has no place in a restriction");
        }
    }
    if (on_property == nullptr) {
        fail(value != nullptr ? value->line : line,
             "a restriction has no owl:onProperty; add the property that it is about");
    }
    if (value == nullptr) {
        fail(on_property->line, "the restriction on " + shown(on_property->object) +
                                    " says nothing; add owl:someValuesFrom, owl:allValuesFrom, a cardinality …");
    }
    const Filler filler = *filler_of(term(value->predicate).word);
    if (filler.is_qualified != (qualifier != nullptr)) {
        fail(value->line, filler.is_qualified
                              ? shown(value->predicate) + " needs owl:onClass (or owl:onDataRange) beside it"
                              : shown(qualifier->predicate) + " goes with a qualified cardinality only, not with " +
                                    shown(value->predicate));
    }

    const bool over_data = is_data_property(on_property->object, on_property->line);
    ClassExpression expression;
    expression.kind = over_data ? filler.over_data : filler.over_things;
    expression.property = over_data ? data_property(on_property->object, on_property->line)
                                    : object_property(on_property->object, on_property->line);
    std::size_t size = 1;
    const auto take_class = [&](Node filler_node, long at_line) {
        const Made made = make(filler_node, at_line);
        size += made.size;
        expression.operands.push_back(made.expression);
    };
    if (filler.is_cardinality) {
        expression.number = count(*value);
        if (qualifier != nullptr && over_data != (term(qualifier->predicate).word == Word::owl_onDataRange)) {
            fail(qualifier->line,
                 shown(on_property->object) + (over_data ? " is a data property, which goes with owl:onDataRange"
                                                         : " is an object property, which goes with owl:onClass"));
        }
        if (over_data) {
            if (qualifier != nullptr)
                expression.range = data_range(qualifier->object, qualifier->line);
            else
                expression.range.datatype = std::string(rdfs_prefix) + "Literal";
        } else if (qualifier != nullptr) {
            take_class(qualifier->object, qualifier->line);
        } else {
            ClassExpression thing;
            thing.iri = std::string(owl_prefix) + "Thing";
            expression.operands.push_back(std::make_shared<const ClassExpression>(std::move(thing)));
            ++size;
        }
    } else if (filler.over_things == ClassKind::has_self) {
        const Term& truth = term(value->object);
        if (over_data)
            fail(value->line, "owl:hasSelf wants an object property; " + shown(on_property->object) + " leads to data");
        if (truth.kind != TermKind::literal || (truth.value != "true" && truth.value != "1")) {
            fail(value->line, "owl:hasSelf has the value true, not " + shown(value->object));
        }
    } else if (filler.over_things == ClassKind::has_value) {
        const bool is_literal = term(value->object).kind == TermKind::literal;
        if (is_literal != over_data) {
            fail(value->line, shown(on_property->object) +
                                  (over_data ? " is a data property; its owl:hasValue is a literal, not "
                                             : " is an object property; its owl:hasValue is an individual, not ") +
                                  shown(value->object));
        }
        if (over_data) {
            expression.range.datatype = term(value->object).datatype;
            expression.range.kind = DataRangeKind::one_of;
            expression.range.values.push_back(literal(value->object));
        } else {
            expression.individuals.push_back(individual(value->object, value->line));
        }
    } else if (over_data) {
        expression.range = data_range(value->object, value->line);
    } else {
        take_class(value->object, value->line);
    }
    return sized(std::move(expression), size, value->line);
}

DataRange Expressions::data_range(Node node, long line) {
    DataRange range;
    if (term(node).kind == TermKind::iri) {
        if (!declarations_.has(term(node).value, EntityKind::datatype))
            reject_undeclared(node, EntityKind::datatype, line);
        range.datatype = term(node).value;
        return range;
    }
    const Triple* on_datatype = nullptr;
    const Triple* facets = nullptr;
    const Triple* one_of = nullptr;
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
        } else if (word == Word::owl_oneOf) {
            take(one_of, triple);
        } else if (word == Word::owl_intersectionOf || word == Word::owl_unionOf ||
                   word == Word::owl_datatypeComplementOf) {
            fail(triple.line,
                 shown(triple.predicate) +
                     " of data ranges is not covered; use owl:withRestrictions, or combine the classes instead");
        } else if (word != Word::rdf_type || (term(triple.object).word != Word::rdfs_Datatype &&
                                              term(triple.object).word != Word::owl_DataRange)) {
            fail(triple.line, shown(word == Word::rdf_type ? triple.object : triple.predicate) +
                                  " has no place in a data range, which a data property wants here");
        }
    }
    if (one_of != nullptr && on_datatype == nullptr && facets == nullptr) {
        for (const Node member : list(one_of->object, one_of->line)) {
            if (term(member).kind != TermKind::literal) {
                fail(one_of->line, "owl:oneOf of a data range lists literals, not " + shown(member));
            }
            range.values.push_back(literal(member));
        }
        if (range.values.empty()) fail(one_of->line, "owl:oneOf has an empty list; it needs at least one member");
        range.kind = DataRangeKind::one_of;
        range.datatype = range.values.front().datatype;
        for (const Literal& value : range.values) {
            if (value.datatype != range.datatype) range.datatype = std::string(rdfs_prefix) + "Literal";
        }
        return range;
    }
    if (one_of != nullptr || on_datatype == nullptr || facets == nullptr) {
        fail(line, "a data range is a datatype, owl:onDatatype with owl:withRestrictions, or owl:oneOf");
    }
    range.datatype = term(on_datatype->object).value;
    if (term(on_datatype->object).kind != TermKind::iri || !declarations_.has(range.datatype, EntityKind::datatype)) {
        reject_undeclared(on_datatype->object, EntityKind::datatype, on_datatype->line);
    }
    for (const Node facet : list(facets->object, facets->line)) add_facet(facet, facets->line, range);
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
