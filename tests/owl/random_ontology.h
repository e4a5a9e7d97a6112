#pragma once

// A random ontology over a small signature, with axioms of every kind; the same seed gives the same ontology. No axiom
// and no annotation of the same thing is there twice: triples could not tell which of them has annotations.

#include <algorithm>
#include <random>
#include <set>

#include "owl/ontology.h"
#include "owl/write.h"

namespace partonomy::owl {

class RandomOntology {
public:
    /// `is_plain`: without what version 3 of the OWL API misreads, in functional syntax anonymous individuals of rules, in
    /// RDF annotations of annotations and of data ranges, inverses in keys, and properties disjoint with themselves.
    explicit RandomOntology(unsigned seed, bool is_plain = false) : random_(seed), is_plain_(is_plain) {}

    Ontology make(std::size_t axioms) {
        Ontology ontology;
        ontology.iri = "https://example.org/random";
        const auto declare = [&](EntityKind kind, const char* stem, int count) {
            for (int i = 0; i < count; ++i) ontology.entities.push_back({kind, name(stem, i), {}});
        };
        declare(EntityKind::klass, "C", 5);
        declare(EntityKind::individual, "a", 4);
        declare(EntityKind::data_property, "d", 3);
        declare(EntityKind::annotation_property, "n", 2);
        declare(EntityKind::object_property, "p", 4);
        declare(EntityKind::datatype, "t", 2);
        std::set<std::string> texts;
        for (std::size_t i = 0; i < axioms; ++i) {
            // Each kind in turn, so that no ontology misses one.
            Axiom made = axiom(static_cast<AxiomKind>(i % (static_cast<std::size_t>(AxiomKind::rule) + 1)));
            if (texts.insert(functional_text(made)).second) ontology.axioms.push_back(std::move(made));
        }
        add_annotations(ontology.annotations[name("C", below(5))], below(5), 2);
        add_annotations(ontology.annotations[ontology.iri], below(3), 2);
        std::ranges::sort(ontology.entities, {}, [](const Entity& entity) { return entity.iri; });
        return ontology;
    }

private:
    int below(int bound) { return static_cast<int>(random_() % static_cast<unsigned>(bound)); }
    bool chance(int percent) { return below(100) < percent; }
    static Iri name(const char* stem, int i) { return "https://example.org/random#" + (stem + std::to_string(i)); }
    static Iri xsd(const std::string& local) { return "http://www.w3.org/2001/XMLSchema#" + local; }

    Iri individual() {
        if (chance(20)) return "_:x" + std::to_string(below(3));
        return name("a", below(4));
    }
    PropertyExpression object_property() { return {name("p", below(4)), chance(30)}; }
    PropertyExpression data_property() { return {name("d", below(3)), false}; }

    Literal literal() {
        static const std::vector<Literal> some = {
            {"0.5", xsd("double"), {}},
            {"-7", xsd("integer"), {}},
            {"true", xsd("boolean"), {}},
            {"plain", xsd("string"), {}},
            {"", xsd("string"), {}},
            {"say \"hi\" \\ and\n\tgo é 日本", xsd("string"), {}},
            {"ends with \\", xsd("string"), {}},
            {"chaise", "http://www.w3.org/1999/02/22-rdf-syntax-ns#langString", "fr"},
            {"a@b", xsd("anyURI"), {}},
            {"own", name("t", 0), {}},
        };
        return some[static_cast<std::size_t>(below(static_cast<int>(some.size())))];
    }

    DataRange data_range(int depth) {
        DataRange range;
        range.kind = depth == 0 ? DataRangeKind::datatype : static_cast<DataRangeKind>(below(5));
        switch (range.kind) {
            case DataRangeKind::datatype:
                range.datatype = chance(20) ? name("t", below(2)) : xsd(chance(50) ? "double" : "string");
                if (range.datatype == xsd("double") && chance(50)) {
                    range.facets.emplace_back(xsd("minInclusive"), Literal{"0.25", xsd("double"), {}});
                    if (chance(50)) range.facets.emplace_back(xsd("maxExclusive"), Literal{"1.0E3", xsd("double"), {}});
                }
                break;
            case DataRangeKind::one_of:
                for (int i = 1 + below(3); i > 0; --i) range.values.push_back(literal());
                break;
            case DataRangeKind::complement_of:
                range.operands = {data_range(depth - 1)};
                break;
            default:
                for (int i = 2 + below(2); i > 0; --i) range.operands.push_back(data_range(depth - 1));
        }
        return range;
    }

    ClassPointer class_expression(int depth) {
        ClassExpression made;
        made.kind = depth == 0 ? ClassKind::named
                               : static_cast<ClassKind>(below(static_cast<int>(ClassKind::data_exact_cardinality) + 1));
        const bool over_data = made.kind >= ClassKind::data_some_values_from;
        made.number = static_cast<std::uint32_t>(below(4));
        switch (made.kind) {
            case ClassKind::named:
                made.iri = chance(10) ? "http://www.w3.org/2002/07/owl#Thing" : name("C", below(5));
                break;
            case ClassKind::intersection_of:
            case ClassKind::union_of:
                for (int i = 2 + below(2); i > 0; --i) made.operands.push_back(class_expression(depth - 1));
                break;
            case ClassKind::complement_of:
                made.operands = {class_expression(depth - 1)};
                break;
            case ClassKind::one_of:
                for (int i = 1 + below(3); i > 0; --i) made.individuals.push_back(individual());
                break;
            case ClassKind::has_value:
                made.property = object_property();
                made.individuals = {individual()};
                break;
            case ClassKind::has_self:
                made.property = object_property();
                break;
            case ClassKind::data_has_value:
                made.property = data_property();
                made.range.kind = DataRangeKind::one_of;
                made.range.values = {literal()};
                break;
            default:
                made.property = over_data ? data_property() : object_property();
                if (over_data)
                    made.range = data_range(2);
                else
                    made.operands = {class_expression(depth - 1)};
        }
        return std::make_shared<const ClassExpression>(std::move(made));
    }

    Annotation annotation(int depth) {
        Annotation note;
        note.property = chance(50) ? "http://www.w3.org/2000/01/rdf-schema#comment" : name("n", below(2));
        if (chance(30))
            note.iri = chance(50) ? individual() : Iri("https://elsewhere.org/page?x=1");
        else
            note.literal = literal();
        if (!is_plain_ && depth > 0 && chance(30)) add_annotations(note.annotations, 1 + below(2), depth - 1);
        return note;
    }

    void add_annotations(std::vector<Annotation>& list, int count, int depth) {
        for (; count > 0; --count) {
            Annotation note = annotation(depth);
            const bool is_there = std::ranges::any_of(list, [&](const Annotation& other) {
                return other.property == note.property && other.iri == note.iri && other.literal == note.literal;
            });
            if (!is_there) list.push_back(std::move(note));
        }
    }

    RuleTerm term(bool over_data) {
        RuleTerm made;
        if (chance(60)) {
            made.iri = "urn:swrl#v" + std::to_string(below(3)) + (over_data ? "d" : "");
        } else if (over_data) {
            made.kind = RuleTerm::Kind::literal;
            made.literal = literal();
        } else {
            made.kind = RuleTerm::Kind::individual;
            made.iri = is_plain_ ? name("a", below(4)) : individual();
        }
        return made;
    }

    RuleAtom atom() {
        RuleAtom made;
        made.kind = static_cast<RuleAtom::Kind>(below(7));
        switch (made.kind) {
            case RuleAtom::Kind::of_class:
                made.klass = class_expression(1);
                made.arguments = {term(false)};
                break;
            case RuleAtom::Kind::of_data_range:
                made.range = data_range(1);
                made.arguments = {term(true)};
                break;
            case RuleAtom::Kind::data_property:
                made.property = data_property();
                made.arguments = {term(false), term(true)};
                break;
            case RuleAtom::Kind::built_in:
                made.iri = "http://www.w3.org/2003/11/swrlb#lessThan";
                made.arguments = {term(true), term(true)};
                break;
            default:
                if (made.kind == RuleAtom::Kind::object_property) made.property = object_property();
                made.arguments = {term(false), term(false)};
        }
        return made;
    }

    std::vector<Iri> different_individuals(int count) {
        std::vector<Iri> all = {name("a", 0), name("a", 1), name("a", 2), name("a", 3), "_:x0", "_:other"};
        std::ranges::shuffle(all, random_);
        all.resize(static_cast<std::size_t>(count));
        return all;
    }

    Axiom axiom(AxiomKind kind) {
        Axiom made;
        made.kind = kind;
        const auto some_classes = [&](int count) {
            for (int i = 0; i < count; ++i) made.classes.push_back(class_expression(2));
        };
        const auto object_properties = [&](int count) {
            for (int i = 0; i < count; ++i) made.properties.push_back(object_property());
        };
        const auto data_properties = [&](int count) {
            for (int i = 0; i < count; ++i) made.properties.push_back(data_property());
        };
        switch (kind) {
            case AxiomKind::sub_class_of:
            case AxiomKind::equivalent_classes:
                some_classes(2);
                break;
            case AxiomKind::disjoint_classes:
            case AxiomKind::disjoint_union:
                if (kind == AxiomKind::disjoint_union) made.classes.push_back(class_expression(0));
                some_classes(2 + below(2));
                break;
            case AxiomKind::sub_object_property_of:
                object_properties(2 + below(3));
                break;
            case AxiomKind::equivalent_object_properties:
                object_properties(2);
                break;
            case AxiomKind::inverse_object_properties:
                object_properties(2);
                made.properties[0].inverse = false;  // as triples both sides cannot be inverse
                break;
            case AxiomKind::disjoint_object_properties:
                object_properties(2 + below(2));
                break;
            case AxiomKind::object_property_domain:
            case AxiomKind::object_property_range:
                object_properties(1);
                some_classes(1);
                break;
            case AxiomKind::sub_data_property_of:
            case AxiomKind::equivalent_data_properties:
                data_properties(2);
                break;
            case AxiomKind::disjoint_data_properties:
                data_properties(2 + below(2));
                break;
            case AxiomKind::data_property_domain:
                data_properties(1);
                some_classes(1);
                break;
            case AxiomKind::data_property_range:
                data_properties(1);
                made.range = data_range(3);
                break;
            case AxiomKind::functional_data_property:
                data_properties(1);
                break;
            case AxiomKind::class_assertion:
                some_classes(1);
                made.individuals = {individual()};
                break;
            case AxiomKind::object_property_assertion:
            case AxiomKind::negative_object_property_assertion:
                object_properties(1);
                if (kind == AxiomKind::object_property_assertion) made.properties[0].inverse = false;
                made.individuals = {individual(), individual()};
                break;
            case AxiomKind::data_property_assertion:
            case AxiomKind::negative_data_property_assertion:
                data_properties(1);
                made.individuals = {individual()};
                made.literal = literal();
                break;
            case AxiomKind::same_individual:
                made.individuals = different_individuals(2);
                break;
            case AxiomKind::different_individuals:
                made.individuals = different_individuals(2 + below(3));
                break;
            case AxiomKind::has_key:
                some_classes(1);
                if (chance(70)) object_properties(1 + below(2));
                if (chance(50) || made.properties.empty()) data_properties(1);
                for (PropertyExpression& property : made.properties) property.inverse &= !is_plain_;
                break;
            case AxiomKind::datatype_definition:
                made.datatype = name("t", 1);
                made.range = data_range(2);
                break;
            case AxiomKind::rule: {
                Rule rule;
                for (int i = below(4); i > 0; --i) rule.body.push_back(atom());
                for (int i = 1 + below(2); i > 0; --i) rule.head.push_back(atom());
                made.rule = std::make_shared<const Rule>(std::move(rule));
                break;
            }
            default:  // a characteristic of an object property
                object_properties(1);
        }
        if (!is_plain_ && chance(25)) add_annotations(made.annotations, 1 + below(2), 2);
        return made;
    }

    std::mt19937 random_;
    bool is_plain_;
};

}  // namespace partonomy::owl
