// Class expressions out of triples: the reverse of "Mapping to RDF Graphs" (W3C OWL 2, 2012, tables 11 to 15). A blank
// node is an expression; its triples say which. Where OWL 2 insists on a type (owl:Class, owl:Restriction) for the
// blank node we do not, since the other triples leave no doubt. A shared blank node is read once; the size that it
// would have when written out is bounded, so that no reader downstream meets an exponential expression. Restrictions
// are in restrictions.cpp, data ranges in data_ranges.cpp.

#include "owl/expressions.h"

#include <algorithm>

#include "base/errors.h"

namespace partonomy::owl {
namespace {

constexpr std::size_t max_size = 100'000;

}  // namespace

Expressions::Nested::Nested(Expressions& reader, Node at_node, long line, const char* what)
    : owner(reader), node(at_node) {
    constexpr int max_depth = 500;
    if (owner.open_[node] != 0) owner.fail(line, std::string(what) + " contains itself; it must end in names");
    if (owner.depth_ >= max_depth) {
        owner.fail(line, "class expressions are nested more than " + std::to_string(max_depth) +
                             " deep; give inner ones names of their own");
    }
    ++owner.depth_;
    owner.open_[node] = 1;
}

Expressions::Expressions(const Graph& graph, const Declarations& declarations, AnonymousNames& names)
    : used(graph.triples.size()),
      graph_(graph),
      declarations_(declarations),
      names_(names),
      by_subject_(graph.terms.size()),
      open_(graph.terms.size()) {
    for (std::uint32_t i = 0; i < graph.triples.size(); ++i) by_subject_[graph.triples[i].subject].push_back(i);
}

void Expressions::fail(long line, const std::string& sentence) const {
    throw OntologyError(at(graph_.file, line, sentence));
}

std::string Expressions::shown(Node node) const {
    const Term& value = term(node);
    if (value.kind == TermKind::blank) return "a blank node";
    if (value.kind == TermKind::iri) return short_name(value.value);
    std::size_t length = std::min<std::size_t>(value.value.size(), 40);
    while (length < value.value.size() && length > 0 && (value.value[length] & 0xC0) == 0x80) --length;
    return between("\"", value.value.substr(0, length), length < value.value.size() ? "…\"" : "\"");
}

std::string Expressions::numbers_of_core(EntityKind kind) const {
    if (kind != EntityKind::object_property && kind != EntityKind::data_property) return {};
    std::string names;
    for (const Iri& iri : declarations_.names_of_core(EntityKind::data_property))
        names += (names.empty() ? "" : ", ") + local_name(iri);
    return "; its numbers are " + names +
           "; for another measure declare a functional data property of your own with core:measure";
}

void Expressions::reject_undeclared(Node node, EntityKind kind, long line) const {
    if (term(node).kind == TermKind::literal)
        fail(line, "the literal " + shown(node) + " stands where a name is expected");
    const Iri& iri = term(node).value;
    const auto [what, type] =
        kind == EntityKind::klass                 ? std::pair{"a class", "owl:Class"}
        : kind == EntityKind::object_property     ? std::pair{"an object property", "owl:ObjectProperty"}
        : kind == EntityKind::data_property       ? std::pair{"a data property", "owl:DatatypeProperty"}
        : kind == EntityKind::annotation_property ? std::pair{"an annotation property", "owl:AnnotationProperty"}
                                                  : std::pair{"a datatype", "rdfs:Datatype"};
    for (const EntityKind other : {EntityKind::klass, EntityKind::object_property, EntityKind::data_property,
                                   EntityKind::annotation_property, EntityKind::datatype}) {
        if (!declarations_.has(iri, other)) continue;
        constexpr const char* names[] = {"a class",         "an object property",
                                         "a data property", "an annotation property",
                                         "an individual",   "a datatype"};
        const bool is_class_as_property = other == EntityKind::klass && kind == EntityKind::object_property;
        fail(line, shown(node) + " is " + names[static_cast<int>(other)] + ", but stands where " + what +
                       " is expected" +
                       (is_class_as_property ? "; a relation to a Body, say, is written isTargetRegion some (" +
                                                   local_name(iri) + " and (inverse (isReferenceRegion) some Body))"
                                             : ""));
    }
    if (iri.starts_with(core_prefix)) {
        const bool is_imported = declarations_.has(std::string(core_prefix) + "Region", EntityKind::klass);
        fail(line, is_imported
                       ? shown(node) + " is used as " + what + ", but the core ontology has no such; mend its name" +
                             declarations_.suggestion(iri, kind) + numbers_of_core(kind)
                       : shown(node) + " is a name of the core ontology, which is not imported; import <" + core_iri +
                             "> (in Protégé: Active ontology > Direct imports)");
    }
    fail(line, shown(node) + " is used as " + what + " but not declared; declare it as " + type + " or mend its name" +
                   declarations_.suggestion(iri, kind));
}

bool Expressions::is_structure(Node node) const {
    if (term(node).kind != TermKind::blank) return false;
    for (const std::uint32_t i : about(node)) {
        switch (term(graph_.triples[i].predicate).word) {
            case Word::owl_onProperty:
            case Word::owl_onProperties:
            case Word::owl_intersectionOf:
            case Word::owl_unionOf:
            case Word::owl_complementOf:
            case Word::owl_oneOf:
            case Word::owl_onDatatype:
            case Word::owl_datatypeComplementOf:
            case Word::owl_inverseOf:
            case Word::rdf_first:
            case Word::rdf_rest:
                return true;
            case Word::rdf_type:
                switch (term(graph_.triples[i].object).word) {
                    case Word::owl_Class:
                    case Word::owl_Restriction:
                    case Word::owl_DataRange:
                    case Word::rdfs_Class:
                    case Word::rdfs_Datatype:
                    case Word::rdf_List:
                        return true;
                    default:
                        break;
                }
                break;
            default:
                break;
        }
    }
    return false;
}

std::vector<Node> Expressions::list(Node head, long line) {
    std::vector<Node> members;
    std::vector<Node> cells;
    Node cell = head;
    while (term(cell).word != Word::rdf_nil) {
        if (term(cell).kind == TermKind::literal)
            fail(line, "a list of RDF is expected where " + shown(cell) + " stands");
        if (open_[cell] != 0) fail(line, "a list contains itself; it must end in rdf:nil");
        const bool is_cell = std::ranges::any_of(about(cell), [&](std::uint32_t i) {
            const Word word = term(graph_.triples[i].predicate).word;
            return word == Word::rdf_first || word == Word::rdf_rest;
        });
        if (!is_cell) fail(line, "a list of RDF is expected where " + shown(cell) + " stands");
        const Triple* first = nullptr;
        const Triple* rest = nullptr;
        for (const std::uint32_t i : about(cell)) {
            const Triple& triple = graph_.triples[i];
            const Word word = term(triple.predicate).word;
            used[i] = 1;
            if (word == Word::rdf_first) {
                if (first != nullptr) fail(triple.line, "a cell of a list has two values of rdf:first; one is right");
                first = &triple;
            } else if (word == Word::rdf_rest) {
                if (rest != nullptr) fail(triple.line, "a cell of a list has two values of rdf:rest; one is right");
                rest = &triple;
            } else if (word != Word::rdf_type || (term(triple.object).word != Word::rdf_List &&
                                                  term(triple.object).word != Word::swrl_AtomList)) {
                fail(triple.line, "a cell of a list has no property but rdf:first and rdf:rest, here stands " +
                                      shown(triple.predicate));
            }
        }
        if (first == nullptr || rest == nullptr) {
            fail(line, "a list is broken: a cell needs one rdf:first and one rdf:rest");
        }
        members.push_back(first->object);
        cells.push_back(cell);
        open_[cell] = 1;
        cell = rest->object;
    }
    for (const Node closed : cells) open_[closed] = 0;
    return members;
}

bool Expressions::is_data_property(Node node, long line) const {
    if (term(node).kind == TermKind::blank) return false;
    const Iri& iri = term(node).value;
    if (term(node).kind == TermKind::iri && declarations_.has(iri, EntityKind::data_property)) return true;
    if (term(node).kind != TermKind::iri || !declarations_.has(iri, EntityKind::object_property)) {
        reject_undeclared(node, EntityKind::object_property, line);
    }
    return false;
}

PropertyExpression Expressions::object_property(Node node, long line) {
    if (term(node).kind != TermKind::blank) {
        if (term(node).kind != TermKind::iri || !declarations_.has(term(node).value, EntityKind::object_property)) {
            reject_undeclared(node, EntityKind::object_property, line);
        }
        return {term(node).value, false};
    }
    const Triple* inverse = nullptr;
    for (const std::uint32_t i : about(node)) {
        const Triple& triple = graph_.triples[i];
        const Word word = term(triple.predicate).word;
        if (word == Word::owl_inverseOf) {
            if (inverse != nullptr)
                fail(triple.line, "an inverse property has two values of owl:inverseOf; one is right");
            inverse = &triple;
            used[i] = 1;
        } else if (word == Word::rdf_type && term(triple.object).word == Word::owl_ObjectProperty) {
            used[i] = 1;
        }
    }
    if (inverse == nullptr)
        fail(line, "a property is expected, or [ owl:inverseOf property ], where a blank node stands");
    if (term(inverse->object).kind != TermKind::iri)
        fail(inverse->line, "owl:inverseOf wants the name of an object property");
    return {object_property(inverse->object, inverse->line).iri, true};
}

PropertyExpression Expressions::data_property(Node node, long line) {
    if (term(node).kind != TermKind::iri || !declarations_.has(term(node).value, EntityKind::data_property)) {
        reject_undeclared(node, EntityKind::data_property, line);
    }
    return {term(node).value, false};
}

Iri Expressions::individual(Node node, long line) const {
    if (term(node).kind == TermKind::literal)
        fail(line, "an individual is expected where the literal " + shown(node) + " stands");
    if (is_structure(node)) fail(line, "an individual is expected where a class expression or list stands");
    return term(node).kind == TermKind::blank ? names_.name(graph_, node) : term(node).value;
}

Literal Expressions::literal(Node node) const { return {term(node).value, term(node).datatype, term(node).language}; }

ClassPointer Expressions::class_expression(Node node, long line) { return make(node, line).expression; }

ClassPointer Expressions::described_by(const Triple& triple) {
    const Nested nested(*this, triple.subject, triple.line, "a class expression");
    return connective(triple).expression;
}

Expressions::Made Expressions::sized(ClassExpression&& expression, std::size_t size, long line) const {
    if (size > max_size) {
        fail(line, "a class expression has more than " + std::to_string(max_size) +
                       " members when written out; give parts of it names");
    }
    return {std::make_shared<const ClassExpression>(std::move(expression)), size};
}

Expressions::Made Expressions::make(Node node, long line) {
    const auto known = made_.find(node);
    if (known != made_.end()) return known->second;
    Made result;
    if (term(node).kind != TermKind::blank) {
        if (term(node).kind != TermKind::iri || !declarations_.has(term(node).value, EntityKind::klass)) {
            reject_undeclared(node, EntityKind::klass, line);
        }
        ClassExpression expression;
        expression.iri = term(node).value;
        result = sized(std::move(expression), 1, line);
    } else {
        const Nested nested(*this, node, line, "a class expression");
        const Triple* described = nullptr;
        const Triple* other = nullptr;  // of a restriction, or out of place
        bool is_restriction = false;
        for (const std::uint32_t i : about(node)) {
            const Triple& triple = graph_.triples[i];
            switch (term(triple.predicate).word) {
                case Word::owl_intersectionOf:
                case Word::owl_unionOf:
                case Word::owl_complementOf:
                case Word::owl_oneOf:
                    if (described != nullptr) {
                        fail(triple.line, "a class expression has both " + shown(described->predicate) + " and " +
                                              shown(triple.predicate) + "; one is right");
                    }
                    described = &triple;
                    used[i] = 1;
                    break;
                case Word::rdf_type: {
                    const Word type = term(triple.object).word;
                    if (type != Word::owl_Class && type != Word::rdfs_Class && type != Word::owl_Restriction) {
                        fail(triple.line,
                             "a class expression is expected, not a blank node of type " + shown(triple.object));
                    }
                    is_restriction |= type == Word::owl_Restriction;
                    used[i] = 1;
                    break;
                }
                case Word::rdfs_subClassOf:
                case Word::owl_equivalentClass:
                case Word::owl_disjointWith:
                case Word::owl_hasKey:
                    break;  // axioms about the expression
                default:
                    other = &triple;
            }
        }
        if (described != nullptr && (is_restriction || other != nullptr)) {
            fail(described->line, "a class expression with " + shown(described->predicate) +
                                      " cannot also be a restriction" +
                                      (other != nullptr ? " or have " + shown(other->predicate) : ""));
        }
        if (described == nullptr && other == nullptr && !is_restriction) {
            fail(line, "a class expression is expected where a blank node stands that says nothing");
        }
        result = described != nullptr ? connective(*described) : restriction(node, line);
    }
    made_.emplace(node, result);
    return result;
}

Expressions::Made Expressions::connective(const Triple& triple) {
    ClassExpression expression;
    std::size_t size = 1;
    const Word word = term(triple.predicate).word;
    std::vector<Node> members;
    if (word == Word::owl_complementOf) {
        members.push_back(triple.object);
    } else {
        members = list(triple.object, triple.line);
        if (members.empty())
            fail(triple.line, shown(triple.predicate) + " has an empty list; it needs at least one member");
    }
    if (word == Word::owl_oneOf) {
        expression.kind = ClassKind::one_of;
        for (const Node member : members) expression.individuals.push_back(individual(member, triple.line));
        size += members.size();
    } else {
        expression.kind = word == Word::owl_intersectionOf ? ClassKind::intersection_of
                          : word == Word::owl_unionOf      ? ClassKind::union_of
                                                           : ClassKind::complement_of;
        for (const Node member : members) {
            const Made made = make(member, triple.line);
            size += made.size;
            expression.operands.push_back(made.expression);
        }
    }
    return sized(std::move(expression), size, triple.line);
}

}  // namespace partonomy::owl
