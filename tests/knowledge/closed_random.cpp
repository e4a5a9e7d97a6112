#include "closed_random.h"

#include <algorithm>
#include <set>
#include <utility>

#include "owl/words.h"

namespace closed_random {

namespace {

const std::string xsd = xsd_prefix;

constexpr int class_kinds = static_cast<int>(ClassKind::data_exact_cardinality) + 1;
constexpr int axiom_kinds = static_cast<int>(AxiomKind::rule) + 1;
constexpr int range_kinds = static_cast<int>(DataRangeKind::complement_of) + 1;
constexpr int atom_kinds = static_cast<int>(RuleAtom::Kind::built_in) + 1;
const char* const comparisons[] = {"equal",           "notEqual",    "lessThan",
                                   "lessThanOrEqual", "greaterThan", "greaterThanOrEqual"};
const char* const number_facets[] = {"minInclusive", "minExclusive", "maxInclusive", "maxExclusive"};
const char* const text_facets[] = {"length", "minLength", "maxLength", "pattern"};

template <class Kind>
std::string numbered(const char* what, Kind kind) {
    return std::string(what) + " " + std::to_string(static_cast<int>(kind));
}

template <class Kind>
ClassPointer make(Kind kind, auto fill) {
    auto expression = std::make_shared<ClassExpression>();
    expression->kind = kind;
    fill(*expression);
    return expression;
}

/// "…#a1". Appended piece by piece: in a chain of + GCC 12 sees an overlap that is not there.
template <class Number>
Iri numbered_iri(char letter, Number number) {
    Iri result = iri(std::string(1, letter));
    result += std::to_string(number);
    return result;
}

ClassPointer named(const Iri& name) {
    return make(ClassKind::named, [&](ClassExpression& e) { e.iri = name; });
}

}  // namespace

Iri iri(const std::string& name) { return "urn:kb#" + name; }

Generator::Generator(unsigned seed, Shape shape) : random_(seed), shape_(shape) {}

Iri Generator::individual() { return numbered_iri('a', (below(static_cast<unsigned>(shape_.individuals)))); }

Iri Generator::klass() { return numbered_iri('C', (below(static_cast<unsigned>(shape_.classes)))); }

PropertyExpression Generator::simple(bool with_inverse) {
    if (!shape_.small_data && chance(2)) return {std::string(owl_prefix) + "bottomObjectProperty", false};
    return {numbered_iri('p', (below(static_cast<unsigned>(shape_.properties)))), with_inverse && chance(25)};
}

PropertyExpression Generator::any_property() {
    if (shape_.small_data) return simple();
    if (chance(4)) return {std::string(owl_prefix) + "topObjectProperty", false};
    return chance(25) ? PropertyExpression{iri("t"), chance(25)} : simple();
}

PropertyExpression Generator::data_property() {
    return {numbered_iri('d', (below(static_cast<unsigned>(shape_.data_properties)))), false};
}

std::vector<Iri> Generator::some_individuals(unsigned least, unsigned most) {
    std::set<Iri> chosen;
    const unsigned wanted = std::min(least + below(most - least + 1), static_cast<unsigned>(shape_.individuals));
    while (chosen.size() < wanted) chosen.insert(individual());
    return {chosen.begin(), chosen.end()};
}

std::string Generator::numeric_datatype() {
    static const char* names[] = {"integer", "integer", "decimal", "double", "float"};
    return names[below(5)];
}

Literal Generator::number_literal(const std::string& datatype) {
    const std::string whole = std::to_string(below(shape_.small_data ? 2 : 4));
    if (datatype == "integer") return {whole, xsd + datatype, ""};
    // No whole decimals: HermiT 1.3.8 takes "1"^^xsd:decimal for another value than "1"^^xsd:integer.
    if (datatype == "decimal") return {whole + ".5", xsd + datatype, ""};
    return {whole + (chance(40) ? ".5" : ".0"), xsd + datatype, ""};
}

Literal Generator::literal() {
    static const char* texts[] = {"", "a", "ab", "b", "aab"};
    if (shape_.small_data) return number_literal("integer");
    switch (below(8)) {
        case 0:
            return {texts[below(5)], xsd + "string", ""};
        case 4:
            return {texts[below(5)], xsd + "string", ""};
        case 5:
            return {chance(50) ? "true" : "false", xsd + "boolean", ""};
        case 6:
            return {texts[below(5)], std::string(rdf_prefix) + "PlainLiteral", chance(70) ? "en" : "de"};
        default:
            return number_literal(numeric_datatype());
    }
}

DataRange Generator::datatype_with_facets() {
    // No xsd:double or xsd:float without facets: HermiT 1.3.8 takes them for rdfs:Literal ("a" is in its xsd:double).
    static const char* texts[] = {"string", "boolean", "token", "NCName", "anyURI"};
    static const char* numbers[] = {"integer", "nonNegativeInteger", "byte",
                                    "decimal", "negativeInteger",    "unsignedByte"};
    DataRange range;
    if (shape_.small_data) {
        range.datatype = xsd + "integer";
        while (chance(60)) range.facets.push_back({xsd + number_facets[below(4)], number_literal("integer")});
        return range;
    }
    if (has_definition_ && chance(15)) {
        range.datatype = iri("D");
        return range;
    }
    if (chance(12)) {
        range.datatype = chance(30)   ? std::string(owl_prefix) + "real"
                         : chance(30) ? std::string(owl_prefix) + "rational"
                         : chance(50) ? std::string(rdfs_prefix) + "Literal"
                                      : std::string(rdf_prefix) + "PlainLiteral";
        return range;
    }
    if (chance(30)) {
        range.datatype = xsd + (chance(50) ? texts[below(5)] : numbers[below(6)]);
        return range;
    }
    if (chance(30)) {
        static const char* patterns[] = {"a*", "[ab]{1,2}", "a.b?", "(a|b)c?", "[^a]*", "ab|b+"};
        range.datatype = xsd + "string";
        const char* facet = text_facets[below(4)];
        const bool is_pattern = std::string(facet) == "pattern";
        range.facets.push_back({xsd + facet, is_pattern ? Literal{patterns[below(6)], xsd + "string", ""}
                                                        : Literal{std::to_string(below(4)), xsd + "integer", ""}});
        return range;
    }
    const std::string datatype = numeric_datatype();
    range.datatype = xsd + datatype;
    range.facets.push_back({xsd + number_facets[below(2)], number_literal(datatype)});
    if (chance(60)) range.facets.push_back({xsd + number_facets[2 + below(2)], number_literal(datatype)});
    return range;
}

DataRange Generator::range(int depth) {
    DataRange result;
    if (depth == 0 || chance(55)) {
        if (chance(75)) return datatype_with_facets();
        result.kind = DataRangeKind::one_of;
        for (unsigned i = 1 + below(3); i > 0; --i) result.values.push_back(literal());
        return result;
    }
    result.kind = static_cast<DataRangeKind>(2 + below(3));
    const unsigned operands = result.kind == DataRangeKind::complement_of ? 1 : 2;
    for (unsigned i = 0; i < operands; ++i) result.operands.push_back(range(depth - 1));
    return result;
}

ClassPointer Generator::data_restriction() {
    const auto kind =
        static_cast<ClassKind>(static_cast<int>(ClassKind::data_some_values_from) + static_cast<int>(below(6)));
    return make(kind, [&](ClassExpression& e) {
        e.property = data_property();
        const bool is_minimum = kind == ClassKind::data_min_cardinality;
        const bool is_cardinality = kind >= ClassKind::data_min_cardinality;
        e.number = shape_.small_data ? below(is_minimum ? 2 : 1) : below(4);
        // No Boolean combinations under cardinalities: HermiT 1.3.8 counts all values then (two integers are too many
        // for "max 1 d (xsd:string or xsd:boolean)").
        const bool had_definition = std::exchange(has_definition_, has_definition_ && !is_cardinality);
        e.range = range(is_cardinality && !shape_.small_data ? 0 : 1);
        has_definition_ = had_definition;
        if (kind == ClassKind::data_has_value) {
            e.range = {DataRangeKind::one_of, {}, {}, {literal()}, {}};
        } else if (kind >= ClassKind::data_min_cardinality && chance(30)) {
            e.range = {DataRangeKind::datatype, std::string(rdfs_prefix) + "Literal", {}, {}, {}};
        }
    });
}

ClassPointer Generator::expression(int depth) {
    if (depth == 0) {
        const Iri builtin = std::string(owl_prefix) + (chance(70) ? "Thing" : "Nothing");
        return named(chance(6) ? builtin : klass());
    }
    const auto kind = static_cast<ClassKind>(below(chance(60) ? class_kinds : 2));
    if (kind >= ClassKind::data_some_values_from) return data_restriction();
    return make(kind, [&](ClassExpression& e) {
        const bool is_cardinality = kind >= ClassKind::min_cardinality && kind <= ClassKind::exact_cardinality;
        unsigned operands = kind >= ClassKind::some_values_from && kind <= ClassKind::exact_cardinality ? 1 : 0;
        if (kind == ClassKind::named) e.iri = klass();
        if (kind == ClassKind::intersection_of || kind == ClassKind::union_of) operands = 2 + below(2);
        if (kind == ClassKind::complement_of) operands = 1;
        if (kind == ClassKind::one_of) e.individuals = some_individuals(1, 2);
        if (kind == ClassKind::has_value) e.individuals = {individual()};
        if (kind == ClassKind::has_value || kind == ClassKind::has_self) operands = 0;
        if (kind >= ClassKind::some_values_from)
            e.property = is_cardinality || kind == ClassKind::has_self ? simple() : any_property();
        if (is_cardinality) e.number = below(4);
        for (unsigned i = 0; i < operands; ++i) {
            const bool is_unqualified = is_cardinality && chance(30);
            e.operands.push_back(is_unqualified ? named(std::string(owl_prefix) + "Thing") : expression(depth - 1));
        }
    });
}

std::vector<ClassPointer> Generator::expressions(unsigned count, int depth) {
    std::vector<ClassPointer> result;
    for (unsigned i = 0; i < count; ++i) result.push_back(expression(depth));
    return result;
}

void Generator::rule(Axiom& axiom) {
    auto made = std::make_shared<Rule>();
    bool has_data = false;
    const auto variable = [&](const char* name) { return RuleTerm{RuleTerm::Kind::variable, iri(name), {}}; };
    const auto thing = [&] {
        if (chance(15)) return RuleTerm{RuleTerm::Kind::individual, individual(), {}};
        return variable(chance(50) ? "x" : (chance(60) ? "y" : "z"));
    };
    const auto atom = [&](bool is_body) {
        RuleAtom result;
        for (;;) {
            result.kind = static_cast<RuleAtom::Kind>(below(shape_.built_ins ? 7 : 6));
            const bool wants_variable =
                result.kind == RuleAtom::Kind::of_data_range || result.kind == RuleAtom::Kind::built_in;
            if (!wants_variable || has_data) break;
        }
        switch (result.kind) {
            case RuleAtom::Kind::of_class:
                // HermiT 1.3.8 overlooks {c}(y) in the head beside differentFrom(x, c) in the body.
                result.klass = chance(70) || (!is_body && !shape_.small_data) ? named(klass()) : expression(1);
                result.arguments = {thing()};
                break;
            case RuleAtom::Kind::of_data_range:
                result.range = range(1);
                result.arguments = {variable("v")};
                break;
            case RuleAtom::Kind::object_property:
                do result.property = any_property();  // HermiT 1.3.8 overlooks owl:topObjectProperty in rules
                while (result.property.iri.ends_with("topObjectProperty"));
                result.property.inverse = false;
                result.arguments = {thing(), thing()};
                break;
            case RuleAtom::Kind::data_property:
                result.property = data_property();
                if (chance(70) && (is_body || has_data)) {
                    result.arguments = {thing(), variable("v")};
                    has_data = true;
                } else {
                    result.arguments = {thing(), {RuleTerm::Kind::literal, {}, literal()}};
                }
                break;
            case RuleAtom::Kind::same_as:
            case RuleAtom::Kind::different_from:
                result.arguments = {thing(), thing()};
                break;
            case RuleAtom::Kind::built_in:
                result.iri = std::string(swrlb_prefix) + comparisons[below(6)];
                result.arguments = {variable("v"), {RuleTerm::Kind::literal, {}, number_literal("integer")}};
                break;
        }
        return result;
    };
    if (shape_.built_ins && chance(80)) {  // "d(x, v) and v < 1"
        RuleAtom value, compared;
        value.kind = RuleAtom::Kind::data_property;
        value.property = data_property();
        value.arguments = {thing(), variable("v")};
        compared.kind = RuleAtom::Kind::built_in;
        compared.iri = std::string(swrlb_prefix) + comparisons[below(6)];
        compared.arguments = {variable("v"), {RuleTerm::Kind::literal, {}, number_literal("integer")}};
        if (chance(30)) std::swap(compared.arguments[0], compared.arguments[1]);
        made->body = {value, compared};
        has_data = true;
    }
    for (unsigned i = below(3) + (made->body.empty() ? 1 : 0); i > 0; --i) made->body.push_back(atom(true));
    made->head.push_back(atom(false));
    // Every variable has to be bound by a class or property atom of the body.
    std::set<Iri> bound;
    for (const RuleAtom& each : made->body)
        if (each.kind <= RuleAtom::Kind::data_property && each.kind != RuleAtom::Kind::of_data_range)
            for (const RuleTerm& term : each.arguments) bound.insert(term.iri);
    for (const auto* side : {&made->body, &made->head})
        for (std::size_t i = 0; i < side->size(); ++i)
            for (const RuleTerm& term : std::vector<RuleTerm>((*side)[i].arguments))
                if (term.kind == RuleTerm::Kind::variable && bound.insert(term.iri).second) {
                    RuleAtom binding;
                    binding.klass = named(klass());
                    binding.arguments = {term};
                    made->body.push_back(binding);
                }
    axiom.rule = std::move(made);
}

Axiom Generator::of_kind(AxiomKind kind) {
    Axiom axiom{};
    axiom.kind = kind;
    switch (kind) {
        case AxiomKind::sub_class_of:
            axiom.classes = expressions(2, 2);
            break;
        case AxiomKind::equivalent_classes:
            axiom.classes = {named(klass()), expression(2)};
            if (chance(20)) axiom.classes.push_back(expression(1));
            break;
        case AxiomKind::disjoint_classes:
            axiom.classes = expressions(2 + below(2), 1);
            break;
        case AxiomKind::disjoint_union:
            axiom.classes = {named(klass()), expression(1), expression(1)};
            break;
        case AxiomKind::sub_object_property_of:
            if (chance(50) || shape_.small_data) {
                axiom.properties = {simple(), simple()};
            } else if (chance(30)) {
                axiom.properties = {simple(), {iri("t"), false}};
            } else {
                const PropertyExpression t{iri("t"), false};
                switch (below(4)) {
                    case 0:
                        axiom.properties = {simple(), simple(), t};
                        break;
                    case 1:
                        axiom.properties = {simple(), t, t};
                        break;
                    case 2:
                        axiom.properties = {t, simple(), t};
                        break;
                    default:
                        axiom.properties = {simple(), simple(), simple(), t};
                        break;
                }
            }
            break;
        case AxiomKind::equivalent_object_properties:
        case AxiomKind::inverse_object_properties:
        case AxiomKind::disjoint_object_properties:
            axiom.properties = {simple(), simple()};
            break;
        case AxiomKind::object_property_domain:
        case AxiomKind::object_property_range:
            axiom.properties = {any_property()};
            axiom.classes = {expression(1)};
            break;
        case AxiomKind::functional_object_property:
        case AxiomKind::inverse_functional_object_property:
        case AxiomKind::asymmetric_object_property:
        case AxiomKind::irreflexive_object_property:
            axiom.properties = {simple()};
            break;
        case AxiomKind::symmetric_object_property:
        case AxiomKind::reflexive_object_property:
            axiom.properties = {any_property()};
            break;
        case AxiomKind::transitive_object_property:
            axiom.properties = {shape_.small_data ? simple() : PropertyExpression{iri("t"), chance(20)}};
            break;
        case AxiomKind::sub_data_property_of:
            axiom.properties = {data_property(), data_property()};
            if (chance(5)) axiom.properties[1].iri = std::string(owl_prefix) + "topDataProperty";
            break;
        case AxiomKind::equivalent_data_properties:
        case AxiomKind::disjoint_data_properties:
            axiom.properties = {data_property(), data_property()};
            break;
        case AxiomKind::data_property_domain:
            axiom.properties = {data_property()};
            axiom.classes = {expression(1)};
            break;
        case AxiomKind::data_property_range:
            axiom.properties = {data_property()};
            axiom.range = range(1);
            break;
        case AxiomKind::functional_data_property:
            axiom.properties = {data_property()};
            break;
        case AxiomKind::class_assertion:
            axiom.classes = {expression(2)};
            axiom.individuals = {individual()};
            break;
        case AxiomKind::object_property_assertion:
        case AxiomKind::negative_object_property_assertion:
            axiom.properties = {any_property()};
            axiom.individuals = {individual(), individual()};
            break;
        case AxiomKind::data_property_assertion:
        case AxiomKind::negative_data_property_assertion:
            axiom.properties = {data_property()};
            axiom.individuals = {individual()};
            axiom.literal = literal();
            break;
        case AxiomKind::same_individual:
        case AxiomKind::different_individuals:
            axiom.individuals = some_individuals(2, 3);
            break;
        case AxiomKind::has_key:
            axiom.classes = {chance(60) ? named(klass()) : expression(1)};
            if (chance(60)) axiom.properties.push_back(simple());
            if (axiom.properties.empty() || chance(40)) axiom.properties.push_back(data_property());
            break;
        case AxiomKind::datatype_definition:
            axiom.datatype = iri("D");
            axiom.range = range(1);
            break;
        case AxiomKind::rule:
            rule(axiom);
            break;
    }
    return axiom;
}

Axiom Generator::axiom() {
    for (;;) {
        auto kind = static_cast<AxiomKind>(below(axiom_kinds));
        if (chance(20)) kind = static_cast<AxiomKind>(below(4));
        if (shape_.built_ins && chance(20)) kind = AxiomKind::rule;
        if (chance(25))
            kind = static_cast<AxiomKind>(static_cast<int>(AxiomKind::class_assertion) + static_cast<int>(below(6)));
        const bool is_about_two = kind == AxiomKind::same_individual || kind == AxiomKind::different_individuals;
        if (kind == AxiomKind::datatype_definition || (is_about_two && shape_.individuals < 2)) continue;
        Axiom made = of_kind(kind);
        // One DisjointUnion for a class: with two, HermiT 1.3.8 calls consistent what it calls inconsistent with fewer
        // axioms.
        if (kind == AxiomKind::disjoint_union && !shape_.small_data && !unions_.insert(made.classes[0]->iri).second)
            continue;
        return made;
    }
}

Axiom Generator::fact(AxiomKind kind, const Iri& about) {
    Axiom made{};
    made.kind = kind;
    made.individuals = {about};
    return made;
}

/// A class with a key over numbers or text, and two members that have the same value of it, mostly.
void Generator::key_of_two(std::vector<Axiom>& axioms) {
    const Iri first = individual(), second = individual();
    Axiom key{};
    key.kind = AxiomKind::has_key;
    key.classes = {named(klass())};
    key.properties = {data_property()};
    static const char* texts[] = {"", "a", "ab"};
    const bool is_text = !shape_.small_data && chance(50);
    const auto value = [&] {
        return is_text ? Literal{texts[below(3)], xsd + "string", ""} : number_literal("integer");
    };
    const Literal shared = value();
    for (const Iri& each : {first, second}) {
        axioms.push_back(fact(AxiomKind::class_assertion, each));
        axioms.back().classes = key.classes;
        axioms.push_back(fact(AxiomKind::data_property_assertion, each));
        axioms.back().properties = key.properties;
        axioms.back().literal = chance(80) ? shared : value();
    }
    axioms.push_back(std::move(key));
}

/// The N-ary Relation pattern: what is the target (p0) of a node of which one or two other things are references (p1).
void Generator::relation(std::vector<Axiom>& axioms) {
    const PropertyExpression target{numbered_iri('p', 0), false}, reference{numbered_iri('p', 1), false};
    const Iri node = individual();
    const ClassPointer kind = named(klass());
    axioms.push_back(fact(AxiomKind::class_assertion, node));
    axioms.back().classes = {kind};
    const bool is_ternary = chance(50);
    for (int i = 0; i < (is_ternary ? 3 : 2); ++i) {
        axioms.push_back(fact(AxiomKind::object_property_assertion, individual()));
        axioms.back().properties = {i == 0 ? target : reference};
        axioms.back().individuals.push_back(node);
    }
    std::vector<ClassPointer> node_is{kind};
    const auto refers_to = [&](ClassKind how, unsigned number) {
        node_is.push_back(make(how, [&](ClassExpression& e) {
            e.property = {reference.iri, true};
            e.number = number;
            e.operands = {expression(1)};
        }));
    };
    if (is_ternary && chance(50)) {
        refers_to(ClassKind::min_cardinality, 2);
    } else {
        refers_to(ClassKind::some_values_from, 0);
        if (is_ternary) refers_to(ClassKind::some_values_from, 0);
    }
    Axiom definition{};
    definition.kind = AxiomKind::equivalent_classes;
    definition.classes = {
        named(klass()), make(ClassKind::some_values_from, [&](ClassExpression& e) {
            e.property = target;
            e.operands = {make(ClassKind::intersection_of, [&](ClassExpression& both) { both.operands = node_is; })};
        })};
    axioms.push_back(std::move(definition));
}

/// A thing whose parts (p0) are all told, of a class that counts them; and a class of what is a part of such a thing.
void Generator::whole(std::vector<Axiom>& axioms) {
    const PropertyExpression has_part{numbered_iri('p', 0), false};
    const Iri self = individual();
    const std::vector<Iri> parts = some_individuals(1, 3);
    for (const Iri& part : parts) {
        axioms.push_back(fact(AxiomKind::object_property_assertion, self));
        axioms.back().properties = {has_part};
        axioms.back().individuals.push_back(part);
    }
    if (parts.size() > 1 && chance(70)) {
        axioms.push_back(fact(AxiomKind::different_individuals, parts[0]));
        axioms.back().individuals = parts;
    }
    axioms.push_back(fact(AxiomKind::class_assertion, self));
    axioms.back().classes = {make(ClassKind::all_values_from, [&](ClassExpression& only) {
        only.property = has_part;
        only.operands = {make(ClassKind::one_of, [&](ClassExpression& e) { e.individuals = parts; })};
    })};
    const auto counted = [&](ClassKind kind, unsigned number) {
        return make(kind, [&](ClassExpression& e) {
            e.property = has_part;
            e.number = number;
            e.operands = {named(klass())};
        });
    };
    const Iri kind = klass();
    Axiom definition{};
    definition.kind = AxiomKind::equivalent_classes;
    definition.classes = {named(kind), make(ClassKind::intersection_of, [&](ClassExpression& e) {
                              e.operands = {counted(ClassKind::min_cardinality, below(3)),
                                            counted(ClassKind::max_cardinality, 1 + below(3))};
                          })};
    axioms.push_back(std::move(definition));
    Axiom part{};
    part.kind = AxiomKind::sub_class_of;
    part.classes = {make(ClassKind::some_values_from,
                         [&](ClassExpression& e) {
                             e.property = {has_part.iri, true};
                             e.operands = {named(kind)};
                         }),
                    expression(1)};
    axioms.push_back(std::move(part));
}

knowledge::ClosedWorld Generator::world() {
    knowledge::ClosedWorld result;
    Ontology& ontology = result.ontology;
    const auto declare = [&](EntityKind kind, const Iri& name) { ontology.entities.push_back({kind, name, {}}); };
    for (int i = 0; i < shape_.individuals; ++i) declare(EntityKind::individual, numbered_iri('a', i));
    for (int i = 0; i < shape_.classes; ++i) declare(EntityKind::klass, numbered_iri('C', i));
    for (int i = 0; i < shape_.properties; ++i) declare(EntityKind::object_property, numbered_iri('p', i));
    for (int i = 0; i < shape_.data_properties; ++i) declare(EntityKind::data_property, numbered_iri('d', i));
    if (!shape_.small_data) declare(EntityKind::object_property, iri("t"));
    if (!shape_.small_data && chance(25)) {
        ontology.axioms.push_back(of_kind(AxiomKind::datatype_definition));
        declare(EntityKind::datatype, iri("D"));
        has_definition_ = true;
    }
    std::ranges::sort(ontology.entities, {}, &Entity::iri);
    while (ontology.axioms.size() < shape_.axioms) ontology.axioms.push_back(axiom());
    if (chance(20)) key_of_two(ontology.axioms);
    if (!shape_.small_data && chance(20)) relation(ontology.axioms);
    if (!shape_.small_data && chance(20)) whole(ontology.axioms);
    for (std::size_t i = 0; i < ontology.axioms.size(); ++i)
        ontology.axioms[i].source = {"kb", static_cast<long>(i) + 1};
    const unsigned style = below(3);
    for (int i = 0; i < shape_.individuals; ++i)
        if (style == 0 || (style == 1 && chance(50))) result.individuals.push_back(numbered_iri('a', (i)));
    return result;
}

namespace {

void count(const DataRange& range, Census& census) {
    ++census[numbered("range", range.kind)];
    for (const auto& [facet, literal] : range.facets) ++census["facet " + local_name(facet)];
    for (const DataRange& operand : range.operands) count(operand, census);
}

/// How many things a class of nodes refers to: "Kind and (inverse p some A) and (inverse p min 2 B)" to three.
unsigned references(const ClassExpression& node) {
    unsigned sum = 0;
    if (node.kind == ClassKind::intersection_of)
        for (const ClassPointer& each : node.operands)
            if (each->property.inverse)
                sum += each->kind == ClassKind::some_values_from  ? 1
                       : each->kind == ClassKind::min_cardinality ? each->number
                                                                  : 0;
    return sum;
}

bool is_whole(const ClassExpression& expression) {
    return expression.kind == ClassKind::intersection_of && expression.operands.size() == 2 &&
           expression.operands[0]->kind == ClassKind::min_cardinality &&
           expression.operands[1]->kind == ClassKind::max_cardinality &&
           expression.operands[0]->property == expression.operands[1]->property;
}

/// Whether `key` binds two individuals that were told to be members, of which the same value was told.
bool binds(const Axiom& key, const Ontology& ontology, bool text) {
    std::map<std::string, std::set<Iri>> having;  // by value
    const auto is_member = [&](const Iri& who) {
        return std::ranges::any_of(ontology.axioms, [&](const Axiom& axiom) {
            return axiom.kind == AxiomKind::class_assertion && axiom.individuals[0] == who &&
                   axiom.classes[0]->kind == ClassKind::named && key.classes[0]->kind == ClassKind::named &&
                   axiom.classes[0]->iri == key.classes[0]->iri;
        });
    };
    for (const Axiom& axiom : ontology.axioms)
        if (axiom.kind == AxiomKind::data_property_assertion && key.properties.size() == 1 &&
            axiom.properties[0] == key.properties[0] && (axiom.literal.datatype == xsd + "string") == text &&
            is_member(axiom.individuals[0]))
            having[axiom.literal.value].insert(axiom.individuals[0]);
    return std::ranges::any_of(having, [](const auto& each) { return each.second.size() > 1; });
}

void count(const ClassExpression& expression, Census& census) {
    ++census[numbered("class", expression.kind)];
    if (expression.kind == ClassKind::some_values_from)
        if (const unsigned others = references(*expression.operands[0]); others == 1 || others == 2)
            ++census["relation of arity " + std::to_string(others + 1)];
    if (is_whole(expression)) ++census["whole"];
    if (expression.property.inverse) ++census["inverse"];
    for (const ClassPointer& operand : expression.operands) count(*operand, census);
    if (expression.kind >= ClassKind::data_some_values_from) count(expression.range, census);
}

}  // namespace

void count(const knowledge::ClosedWorld& world, Census& census) {
    for (const Axiom& axiom : world.ontology.axioms) {
        ++census[numbered("axiom", axiom.kind)];
        for (const ClassPointer& expression : axiom.classes) count(*expression, census);
        if (axiom.kind == AxiomKind::data_property_range || axiom.kind == AxiomKind::datatype_definition)
            count(axiom.range, census);
        if (axiom.kind == AxiomKind::sub_object_property_of && axiom.properties.size() > 2)
            ++census["chain of " + std::to_string(axiom.properties.size() - 1)];
        for (const bool text : {false, true})
            if (axiom.kind == AxiomKind::has_key && binds(axiom, world.ontology, text))
                ++census[text ? "key over text" : "key over numbers"];
        if (axiom.rule == nullptr) continue;
        for (const auto* side : {&axiom.rule->body, &axiom.rule->head})
            for (const RuleAtom& atom : *side) {
                ++census[numbered("atom", atom.kind)];
                if (atom.kind == RuleAtom::Kind::built_in) ++census["compare " + local_name(atom.iri)];
            }
    }
}

std::vector<std::string> all_constructs(bool built_ins) {
    std::vector<std::string> result{"inverse",       "chain of 2",          "chain of 3",          "key over numbers",
                                    "key over text", "relation of arity 2", "relation of arity 3", "whole"};
    for (int kind = 0; kind < class_kinds; ++kind) result.push_back(numbered("class", kind));
    for (int kind = 0; kind < axiom_kinds; ++kind) result.push_back(numbered("axiom", kind));
    for (int kind = 0; kind < range_kinds; ++kind) result.push_back(numbered("range", kind));
    for (int kind = 0; kind < atom_kinds - (built_ins ? 0 : 1); ++kind) result.push_back(numbered("atom", kind));
    for (const char* name : number_facets) result.push_back(std::string("facet ") + name);
    for (const char* name : text_facets) result.push_back(std::string("facet ") + name);
    if (built_ins)
        for (const char* name : comparisons) result.push_back(std::string("compare ") + name);
    return result;
}

}  // namespace closed_random
