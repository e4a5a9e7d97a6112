// Restrictions: the part of the mapping where it matters whether a property leads to things or to data.

#include <charconv>
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
            word == Word::owl_disjointWith || word == Word::owl_hasKey) {
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
                 "a restriction on several properties (owl:onProperties) wants a data range of several values, and OWL "
                 "2 "
                 "has none; use owl:onProperty");
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
    Made made;
    made.size = 1;
    if (filler.is_cardinality)
        bound(*on_property, *value, qualifier, over_data, made, expression);
    else
        this->filler(*on_property, *value, over_data, made, expression);
    return sized(std::move(expression), made.size, value->line);
}

/// The number and what is counted.
void Expressions::bound(const Triple& on_property, const Triple& value, const Triple* qualifier, bool over_data,
                        Made& made, ClassExpression& expression) {
    expression.number = count(value);
    if (qualifier != nullptr && !graph_.kinds_are_open &&
        over_data != (term(qualifier->predicate).word == Word::owl_onDataRange)) {
        fail(qualifier->line,
             shown(on_property.object) + (over_data ? " is a data property, which goes with owl:onDataRange"
                                                    : " is an object property, which goes with owl:onClass"));
    }
    if (over_data) {
        if (qualifier != nullptr)
            expression.range = data_range(qualifier->object, qualifier->line);
        else
            expression.range.datatype = std::string(rdfs_prefix) + "Literal";
    } else if (qualifier != nullptr) {
        take_class(qualifier->object, qualifier->line, made, expression);
    } else {
        ClassExpression thing;
        thing.iri = std::string(owl_prefix) + "Thing";
        expression.operands.push_back(std::make_shared<const ClassExpression>(std::move(thing)));
        ++made.size;
    }
}

/// What a restriction that does not count says of the property's values.
void Expressions::filler(const Triple& on_property, const Triple& value, bool over_data, Made& made,
                         ClassExpression& expression) {
    if (expression.kind == ClassKind::has_self) {
        const Term& truth = term(value.object);
        if (over_data)
            fail(value.line, "owl:hasSelf wants an object property; " + shown(on_property.object) + " leads to data");
        if (truth.kind != TermKind::literal || (truth.value != "true" && truth.value != "1")) {
            fail(value.line, "owl:hasSelf has the value true, not " + shown(value.object));
        }
    } else if (expression.kind == ClassKind::has_value || expression.kind == ClassKind::data_has_value) {
        const bool is_literal = term(value.object).kind == TermKind::literal;
        if (is_literal != over_data) {
            fail(value.line, shown(on_property.object) +
                                 (over_data ? " is a data property; its owl:hasValue is a literal, not "
                                            : " is an object property; its owl:hasValue is an individual, not ") +
                                 shown(value.object));
        }
        if (over_data) {
            expression.range.datatype = term(value.object).datatype;
            expression.range.kind = DataRangeKind::one_of;
            expression.range.values.push_back(literal(value.object));
        } else {
            expression.individuals.push_back(individual(value.object, value.line));
        }
    } else if (over_data) {
        expression.range = data_range(value.object, value.line);
    } else {
        take_class(value.object, value.line, made, expression);
    }
}

void Expressions::take_class(Node node, long line, Made& made, ClassExpression& expression) {
    const Made operand = make(node, line);
    made.size += operand.size;
    expression.operands.push_back(operand.expression);
}

}  // namespace partonomy::owl
