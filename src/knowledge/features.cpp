#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <set>

#include "base/errors.h"
#include "knowledge/theory.h"

// What can be measured, read off the axioms alone: a functional object property whose range is a class below
// core:Feature leads to a range concept, and the union of that class says its values. Data properties are cut into
// intervals at the numbers that class expressions mention: no axiom can tell two lengths of one interval apart.

namespace partonomy::knowledge {
namespace {

using owl::Axiom;
using owl::AxiomKind;
using owl::ClassKind;

constexpr double infinity = std::numeric_limits<double>::infinity();

bool is_named(const owl::ClassPointer& expression) { return expression->kind == ClassKind::named; }

/// The class, and all that is told to be below it.
std::set<Iri> told_below(const owl::Ontology& ontology, const Iri& top) {
    std::set<Iri> found{top};
    for (bool grown = true; grown;) {
        grown = false;
        for (const Axiom& axiom : ontology.axioms) {
            if (axiom.kind != AxiomKind::sub_class_of || !is_named(axiom.classes[0]) || !is_named(axiom.classes[1]))
                continue;
            if (found.contains(axiom.classes[1]->iri)) grown |= found.insert(axiom.classes[0]->iri).second;
        }
    }
    return found;
}

std::optional<double> to_number(std::string_view text) {
    if (text.starts_with('+')) text.remove_prefix(1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size() || std::isnan(value)) return std::nullopt;
    return value;
}

[[noreturn]] void refuse_knob(const owl::Annotation& annotation, const Iri& entity, const std::string& problem) {
    throw OntologyError(at(annotation.source.file, annotation.source.line,
                           owl::local_name(annotation.property) + " \"" + annotation.literal.value + "\" of " +
                               owl::local_name(entity) + " " + problem));
}

/// The last four words of the annotation as a trapezoid; what precedes them is the measure.
Criterion to_criterion(const owl::Annotation& annotation, const Iri& entity, const std::string& measure) {
    std::vector<std::string_view> words;
    for (std::string_view rest = annotation.literal.value;;) {
        constexpr const char* blanks = " \t\r\n";
        rest.remove_prefix(std::min(rest.find_first_not_of(blanks), rest.size()));
        if (rest.empty()) break;
        words.push_back(rest.substr(0, rest.find_first_of(blanks)));
        rest.remove_prefix(words.back().size());
    }
    const std::string wanted = measure.empty()
                                   ? "should be a measurement and four numbers, such as \"l0/l1 1.5 2.5 inf inf\""
                                   : "should be four numbers, such as \"0.06 0.1 0.78 0.86\"";
    if (words.size() < 4 || (words.size() == 4) == measure.empty()) refuse_knob(annotation, entity, wanted);
    if (!measure.empty() && words.size() > 4) refuse_knob(annotation, entity, wanted);
    double a[4];
    for (std::size_t i = 0; i < 4; ++i) {
        const std::optional<double> number = to_number(words[words.size() - 4 + i]);
        if (!number) refuse_knob(annotation, entity, wanted);
        a[i] = *number;
    }
    if (!(a[0] <= a[1] && a[1] <= a[2] && a[2] <= a[3]))
        refuse_knob(annotation, entity, "has its numbers out of order; they should ascend");
    std::string name = measure;
    for (std::size_t i = 0; i + 4 < words.size(); ++i) name.append(i > 0 ? " " : "").append(words[i]);
    return {name, a[0], a[1], a[2], a[3]};
}

std::string text_of(const owl::Ontology& ontology, const Iri& iri, const char* knob) {
    const auto found = ontology.annotations.find(iri);
    if (found == ontology.annotations.end()) return {};
    for (const owl::Annotation& annotation : found->second)
        if (is_core_term(annotation.property, knob)) return annotation.literal.value;
    return {};
}

/// A measurement and its trapezoid are one pair; a second one would leave open which belongs to which.
void refuse_second(const std::vector<owl::Annotation>& annotations, const Iri& iri, const char* knob) {
    const owl::Annotation* first = nullptr;
    for (const owl::Annotation& annotation : annotations) {
        if (!is_core_term(annotation.property, knob)) continue;
        if (first != nullptr && first->literal.value != annotation.literal.value)
            refuse_knob(annotation, iri,
                        "is a second one beside \"" + first->literal.value +
                            "\"; keep one, or write each measurement with its numbers as a core:criterion");
        first = &annotation;
    }
}

ElementaryConcept read_value(const owl::Ontology& ontology, const Iri& iri) {
    ElementaryConcept value{iri, {}, std::nullopt, text_of(ontology, iri, "question")};
    const auto found = ontology.annotations.find(iri);
    if (found == ontology.annotations.end()) return value;
    for (const char* knob : {"measure", "membership"}) refuse_second(found->second, iri, knob);
    const std::string measure = text_of(ontology, iri, "measure");
    bool has_membership = false;
    for (const owl::Annotation& annotation : found->second) {
        if (is_core_term(annotation.property, "criterion")) {
            value.criteria.push_back(to_criterion(annotation, iri, {}));
        } else if (is_core_term(annotation.property, "membership")) {
            if (measure.empty()) refuse_knob(annotation, iri, "has no core:measure beside it; say what it measures");
            value.criteria.push_back(to_criterion(annotation, iri, measure));
            has_membership = true;
        } else if (is_core_term(annotation.property, "cost")) {
            value.cost = to_number(annotation.literal.value);
            if (!value.cost || !(*value.cost >= 0) || std::isinf(*value.cost))
                refuse_knob(annotation, iri, "should be a number above 0, or 0 for what is read off");
        }
    }
    if (!measure.empty() && !has_membership)
        for (const owl::Annotation& annotation : found->second)
            if (is_core_term(annotation.property, "measure"))
                refuse_knob(annotation, iri, "has no core:membership beside it; say which of its values count");
    return value;
}

/// The values of a range concept: operands of its (disjoint) union, else its direct subclasses that have no definition.
std::vector<Iri> values_of(const owl::Ontology& ontology, const Iri& range, bool& covered) {
    std::vector<Iri> values;
    for (const Axiom& axiom : ontology.axioms) {
        if (axiom.kind == AxiomKind::disjoint_union && is_named(axiom.classes[0]) && axiom.classes[0]->iri == range) {
            for (std::size_t i = 1; i < axiom.classes.size(); ++i) {
                if (!is_named(axiom.classes[i]))
                    refuse(axiom, "a value of a range concept needs a name",
                           "name " + to_manchester(*axiom.classes[i]));
                values.push_back(axiom.classes[i]->iri);
            }
            covered = !values.empty();
            return values;
        }
        if (axiom.kind != AxiomKind::equivalent_classes) continue;
        const bool about =
            std::ranges::any_of(axiom.classes, [&](const auto& c) { return is_named(c) && c->iri == range; });
        for (const owl::ClassPointer& other : axiom.classes) {
            if (!about || other->kind != ClassKind::union_of || !std::ranges::all_of(other->operands, is_named))
                continue;
            for (const owl::ClassPointer& operand : other->operands) values.push_back(operand->iri);
            covered = true;
            return values;
        }
    }
    for (const Axiom& axiom : ontology.axioms) {
        if (axiom.kind != AxiomKind::sub_class_of || !is_named(axiom.classes[0]) || !is_named(axiom.classes[1]))
            continue;
        const Iri& value = axiom.classes[0]->iri;
        if (axiom.classes[1]->iri != range) continue;
        const bool defined = std::ranges::any_of(ontology.axioms, [&](const Axiom& other) {
            return other.kind == AxiomKind::equivalent_classes &&
                   std::ranges::any_of(other.classes, [&](const auto& c) { return is_named(c) && c->iri == value; });
        });
        if (!defined) values.push_back(value);
    }
    std::ranges::sort(values);
    values.erase(std::unique(values.begin(), values.end()), values.end());
    return values;
}

bool is_functional(const owl::Ontology& ontology, const Iri& property) {
    return std::ranges::any_of(ontology.axioms, [&](const Axiom& axiom) {
        return (axiom.kind == AxiomKind::functional_object_property ||
                axiom.kind == AxiomKind::functional_data_property) &&
               axiom.properties[0] == owl::PropertyExpression{property, false};
    });
}

/// A place on the number line between two numbers that touch: just below x, or just above it.
using Cut = std::pair<double, bool>;

/// Skips what `leaves_out` says of a property and the axiom.
void collect_cuts(const owl::ClassExpression& expression, const Axiom& axiom, std::map<Iri, std::set<Cut>>& cuts,
                  const auto& leaves_out) {
    switch (expression.kind) {
        case ClassKind::data_some_values_from:
        case ClassKind::data_all_values_from:
        case ClassKind::data_has_value:
        case ClassKind::data_min_cardinality:
        case ClassKind::data_max_cardinality:
        case ClassKind::data_exact_cardinality:
            if (leaves_out(expression, axiom)) break;
            for (const MeasuredProperty::Interval& part : number_range(expression.range, axiom)) {
                if (part.low != -infinity) cuts[expression.property.iri].insert({part.low, !part.low_closed});
                if (part.high != infinity) cuts[expression.property.iri].insert({part.high, part.high_closed});
            }
            break;
        default:
            for (const owl::ClassPointer& operand : expression.operands)
                collect_cuts(*operand, axiom, cuts, leaves_out);
    }
}

bool is_number_type(const Iri& datatype) {
    static const std::set<std::string> names{"double", "float", "decimal", "real", "rational", "Literal"};
    return datatype.empty() || names.contains(owl::local_name(datatype));
}

using Intervals = std::vector<MeasuredProperty::Interval>;

constexpr MeasuredProperty::Interval whole_line{-infinity, infinity, false, false};

bool is_empty(const MeasuredProperty::Interval& part) {
    return part.low > part.high || (part.low == part.high && !(part.low_closed && part.high_closed));
}

/// Of ascending, disjoint intervals.
Intervals complement(const Intervals& parts) {
    Intervals gaps;
    MeasuredProperty::Interval gap = whole_line;
    for (const MeasuredProperty::Interval& part : parts) {
        gap.high = part.low;
        gap.high_closed = !part.low_closed && part.low != -infinity;
        if (part.low != -infinity && !is_empty(gap)) gaps.push_back(gap);
        gap = {part.high, infinity, !part.high_closed, false};
    }
    if (parts.empty() || parts.back().high != infinity) gaps.push_back(gap);
    return gaps;
}

Intervals intersection(const Intervals& a, const Intervals& b) {
    Intervals common;
    for (const MeasuredProperty::Interval& x : a)
        for (const MeasuredProperty::Interval& y : b) {
            MeasuredProperty::Interval part = x;
            if (y.low > x.low || (y.low == x.low && !y.low_closed)) part.low = y.low, part.low_closed = y.low_closed;
            if (y.high < x.high || (y.high == x.high && !y.high_closed))
                part.high = y.high, part.high_closed = y.high_closed;
            if (!is_empty(part)) common.push_back(part);
        }
    return common;
}

bool is_number_range(const owl::DataRange& range, const Axiom& axiom) {
    try {
        (void)number_range(range, axiom);
        return true;
    } catch (const OntologyError&) {
        return false;
    }
}

}  // namespace

bool MeasuredProperty::Interval::has(double x) const {
    return (low_closed ? x >= low : x > low) && (high_closed ? x <= high : x < high);
}

std::vector<MeasuredProperty::Interval> number_range(const owl::DataRange& range, const owl::Axiom& axiom) {
    const std::string hint = "only numbers can be measured: write xsd:double[>= 0.4, <= 0.48]";
    const auto parse = [&](const owl::Literal& literal) {
        const std::optional<double> number = to_number(literal.value);
        if (!number) refuse(axiom, "\"" + literal.value + "\" is no number", hint);
        return *number == 0 ? 0.0 : *number;  // -0 and 0 are one place
    };
    switch (range.kind) {
        case owl::DataRangeKind::one_of: {
            Intervals parts;
            std::set<double> points;
            for (const owl::Literal& literal : range.values) points.insert(parse(literal));
            for (const double x : points) parts.push_back({x, x, true, true});
            return parts;
        }
        case owl::DataRangeKind::complement_of:
            return complement(number_range(range.operands[0], axiom));
        case owl::DataRangeKind::union_of:
        case owl::DataRangeKind::intersection_of: {  // a or b: not (not a and not b)
            const bool is_union = range.kind == owl::DataRangeKind::union_of;
            Intervals common{whole_line};
            for (const owl::DataRange& operand : range.operands) {
                const Intervals allowed = number_range(operand, axiom);
                common = intersection(common, is_union ? complement(allowed) : allowed);
            }
            return is_union ? complement(common) : common;
        }
        default:
            break;
    }
    if (!is_number_type(range.datatype))
        refuse(axiom, owl::local_name(range.datatype) + " is no type of measurements", hint);
    MeasuredProperty::Interval part = whole_line;
    for (const auto& [facet, literal] : range.facets) {
        const double x = parse(literal);
        const std::string name = owl::local_name(facet);
        const bool closed = name.ends_with("Inclusive");
        if (name == "minInclusive" || name == "minExclusive") {
            if (x > part.low || (x == part.low && !closed)) part.low = x, part.low_closed = closed;
        } else if (name == "maxInclusive" || name == "maxExclusive") {
            if (x < part.high || (x == part.high && !closed)) part.high = x, part.high_closed = closed;
        } else {
            refuse(axiom, name + " is no bound of a number", hint);
        }
    }
    return is_empty(part) ? Intervals{} : Intervals{part};
}

std::vector<RangeConcept> find_ranges(const owl::Ontology& ontology) {
    const std::set<Iri> features = told_below(ontology, core_term("Feature"));
    std::vector<RangeConcept> ranges;
    std::map<Iri, Iri> range_of_value;
    for (const Axiom& axiom : ontology.axioms) {
        if (axiom.kind != AxiomKind::object_property_range || axiom.properties[0].inverse ||
            !is_named(axiom.classes[0]))
            continue;
        const Iri &range = axiom.classes[0]->iri, &property = axiom.properties[0].iri;
        if (!features.contains(range) || is_core_term(range, "Feature") || !is_functional(ontology, property)) continue;
        for (const RangeConcept& other : ranges)
            if (other.iri == range || other.property == property)
                refuse(axiom,
                       "a range concept has one property, and " + owl::local_name(other.property) + " leads to " +
                           owl::local_name(other.iri),
                       "give each property its own range concept");
        RangeConcept found{range, property, {}, false};
        for (const Iri& value : values_of(ontology, range, found.covered)) {
            const auto [place, added] = range_of_value.emplace(value, range);
            if (!added)
                refuse(axiom, owl::local_name(value) + " is also a value of " + owl::local_name(place->second),
                       "keep the values of range concepts apart");
            found.values.push_back(read_value(ontology, value));
        }
        ranges.push_back(std::move(found));
    }
    return ranges;
}

std::vector<std::pair<Iri, Iri>> told_relations(const owl::Ontology& ontology) {
    const std::set<Iri> relations = told_below(ontology, core_term("Relation"));
    std::set<std::pair<Iri, Iri>> pairs;
    if (relations.size() == 1) return {};
    for (const Axiom& axiom : ontology.axioms)
        if (axiom.kind == AxiomKind::sub_class_of && is_named(axiom.classes[0]) && is_named(axiom.classes[1]) &&
            relations.contains(axiom.classes[1]->iri))
            pairs.emplace(axiom.classes[0]->iri, axiom.classes[1]->iri);
    for (bool grown = true; grown;) {  // what is below is below all that is above
        grown = false;
        for (const auto& [sub, super] : std::vector(pairs.begin(), pairs.end()))
            for (const Iri& top : relations)
                if (pairs.contains({super, top})) grown |= pairs.emplace(sub, top).second;
    }
    std::erase_if(pairs, [](const auto& pair) { return pair.first == pair.second; });
    return {pairs.begin(), pairs.end()};
}

std::vector<Relation> find_relations(const owl::Ontology& ontology) {
    const std::vector<std::pair<Iri, Iri>> told = told_relations(ontology);
    std::vector<Relation> relations;
    for (const auto& [sub, super] : told) {
        if (!is_core_term(super, "Relation")) continue;
        ElementaryConcept value = read_value(ontology, sub);
        const bool is_parent = std::ranges::any_of(told, [&](const auto& pair) { return pair.second == sub; });
        if (is_parent && value.criteria.empty()) continue;
        Relation relation{sub, 2, std::move(value.criteria), value.cost, std::move(value.question)};
        if (const auto found = ontology.annotations.find(sub); found != ontology.annotations.end())
            for (const owl::Annotation& annotation : found->second) {
                if (!is_core_term(annotation.property, "arity")) continue;
                const std::optional<double> arity = to_number(annotation.literal.value);
                if (!arity || (*arity != 2 && *arity != 3))
                    refuse_knob(annotation, sub, "should be 2 or 3: the number of regions that it links");
                relation.arity = static_cast<std::size_t>(*arity);
            }
        relations.push_back(std::move(relation));
    }
    return relations;
}

std::vector<TypicalHeight> find_typical_heights(const owl::Ontology& ontology) {
    std::vector<TypicalHeight> heights;
    for (const auto& [iri, annotations] : ontology.annotations)
        for (const owl::Annotation& annotation : annotations)
            if (is_core_term(annotation.property, "typicalHeight"))
                heights.push_back({iri, to_criterion(annotation, iri, "height of the object")});
    return heights;
}

bool is_about_scenes(const owl::Ontology& ontology) {
    const Iri property = core_term("isScene");
    return std::ranges::any_of(ontology.annotations, [&](const auto& entry) {
        return std::ranges::any_of(entry.second, [&](const owl::Annotation& annotation) {
            return annotation.property == property && annotation.literal.value == "true";
        });
    });
}

std::vector<MeasuredProperty> find_numbers(const owl::Ontology& ontology, std::set<Iri>& no_numbers) {
    std::map<Iri, std::set<Cut>> cuts;
    std::set<Iri> of_others;  // with a domain that is about anything but regions
    const std::set<Iri> regions = told_below(ontology, core_term("Region"));
    for (const Axiom& axiom : ontology.axioms)
        if (axiom.kind == AxiomKind::data_property_domain &&
            !(is_named(axiom.classes[0]) && regions.contains(axiom.classes[0]->iri)))
            of_others.insert(axiom.properties[0].iri);
    const auto leaves_out = [&](const owl::ClassExpression& expression, const Axiom& axiom) {
        const Iri& property = expression.property.iri;
        if (no_numbers.contains(property)) return true;
        if (!text_of(ontology, property, "measure").empty()) return false;
        if (!of_others.contains(property) && is_functional(ontology, property) &&
            is_number_range(expression.range, axiom))
            return false;
        no_numbers.insert(property);
        return true;
    };
    for (const Axiom& axiom : ontology.axioms) {
        for (const owl::ClassPointer& expression : axiom.classes) collect_cuts(*expression, axiom, cuts, leaves_out);
        if (axiom.kind != AxiomKind::data_property_range || axiom.range.facets.empty()) continue;
        owl::ClassExpression expression;
        expression.kind = ClassKind::data_all_values_from;
        expression.property = axiom.properties[0];
        expression.range = axiom.range;
        collect_cuts(expression, axiom, cuts, leaves_out);
    }
    std::vector<MeasuredProperty> numbers;
    for (const auto& [property, places] : cuts) {
        if (no_numbers.contains(property)) continue;
        MeasuredProperty number{property, text_of(ontology, property, "measure"), {}};
        double low = -infinity;
        bool low_closed = false;
        for (const auto& [x, above] : places) {
            number.intervals.push_back({low, x, low_closed, above});
            low = x;
            low_closed = !above;
        }
        number.intervals.push_back({low, infinity, low_closed, false});
        numbers.push_back(std::move(number));
    }
    return numbers;
}

}  // namespace partonomy::knowledge
