// SWRL rules out of triples (SWRL submission to W3C, 2004, section 5, as Protégé writes it): a swrl:Imp with a body and
// a head, which are lists of atoms. A variable is an IRI of type swrl:Variable. Where the document leaves open whether
// an atom is about things or about data (Manchester syntax), the declarations of its predicate tell.

#include "owl/axiom_reader.h"

namespace partonomy::owl {

void AxiomReader::rule(const Triple& triple) {
    const Triple& body = only(triple, Word::swrl_body, "swrl:body");
    const Triple& head = only(triple, Word::swrl_head, "swrl:head");
    Rule rule;
    rule.body = atoms(body);
    rule.head = atoms(head);
    axiom_of_node_[triple.subject] = ontology_.axioms.size();
    add(AxiomKind::rule, triple).rule = std::make_shared<const Rule>(std::move(rule));
}

std::vector<RuleAtom> AxiomReader::atoms(const Triple& triple) {
    std::vector<RuleAtom> atoms;
    for (const Node node : read_.list(triple.object, triple.line)) atoms.push_back(atom(node, triple.line));
    return atoms;
}

RuleAtom AxiomReader::atom(Node node, long line) {
    const Triple* type = nullptr;
    for (const std::uint32_t i : read_.about(node)) {
        const Triple& triple = graph_.triples[i];
        if (word(triple.predicate) != Word::rdf_type) continue;
        read_.used[i] = 1;
        type = &triple;
    }
    if (type == nullptr)
        read_.fail(line, "an atom of a rule has a type such as swrl:ClassAtom, " + read_.shown(node) + " has none");
    RuleAtom atom;
    const Word kind = word(type->object);
    switch (kind) {
        case Word::swrl_ClassAtom:
            atom_predicate(atom, only(*type, Word::swrl_classPredicate, "swrl:classPredicate"), kind);
            break;
        case Word::swrl_DataRangeAtom:
            atom_predicate(atom, only(*type, Word::swrl_dataRange, "swrl:dataRange"), kind);
            break;
        case Word::swrl_IndividualPropertyAtom:
        case Word::swrl_DatavaluedPropertyAtom:
            atom_predicate(atom, only(*type, Word::swrl_propertyPredicate, "swrl:propertyPredicate"), kind);
            break;
        case Word::swrl_SameIndividualAtom:
            atom.kind = RuleAtom::Kind::same_as;
            break;
        case Word::swrl_DifferentIndividualsAtom:
            atom.kind = RuleAtom::Kind::different_from;
            break;
        case Word::swrl_BuiltinAtom: {
            const Triple& built_in = only(*type, Word::swrl_builtin, "swrl:builtin");
            if (term(built_in.object).kind != TermKind::iri)
                read_.fail(built_in.line,
                           "swrl:builtin wants the IRI of a built-in, not " + read_.shown(built_in.object));
            atom.kind = RuleAtom::Kind::built_in;
            atom.iri = term(built_in.object).value;
            break;
        }
        default:
            read_.fail(type->line, read_.shown(type->object) + " is no atom of a rule; swrl:ClassAtom is, for example");
    }
    atom_arguments(atom, *type, atom.kind == RuleAtom::Kind::built_in);
    check_arguments(atom, type->line);
    return atom;
}

void AxiomReader::atom_predicate(RuleAtom& atom, const Triple& predicate, Word type) {
    const Node node = predicate.object;
    const long line = predicate.line;
    if (type == Word::swrl_ClassAtom || type == Word::swrl_DataRangeAtom) {
        const bool is_range = type == Word::swrl_DataRangeAtom || (graph_.kinds_are_open && read_.is_data_range(node));
        atom.kind = is_range ? RuleAtom::Kind::of_data_range : RuleAtom::Kind::of_class;
        if (is_range)
            atom.range = read_.data_range(node, line);
        else
            atom.klass = read_.class_expression(node, line);
        return;
    }
    const bool over_data =
        type == Word::swrl_DatavaluedPropertyAtom || (graph_.kinds_are_open && read_.is_data_property(node, line));
    atom.kind = over_data ? RuleAtom::Kind::data_property : RuleAtom::Kind::object_property;
    atom.property = over_data ? read_.data_property(node, line) : read_.object_property(node, line);
}

void AxiomReader::atom_arguments(RuleAtom& atom, const Triple& type, bool takes_list) {
    if (takes_list) {
        const Triple& list = only(type, Word::swrl_arguments, "swrl:arguments");
        for (const Node node : read_.list(list.object, list.line)) atom.arguments.push_back(rule_term(node, list.line));
        return;
    }
    const Triple& first = only(type, Word::swrl_argument1, "swrl:argument1");
    atom.arguments.push_back(rule_term(first.object, first.line));
    const Triple* second = find_only(type, Word::swrl_argument2);
    if (second != nullptr) atom.arguments.push_back(rule_term(second->object, second->line));
}

RuleTerm AxiomReader::rule_term(Node node, long line) {
    RuleTerm result;
    if (term(node).kind == TermKind::literal) {
        result.kind = RuleTerm::Kind::literal;
        result.literal = read_.literal(node);
    } else if (variables_.contains(node)) {
        result.kind = RuleTerm::Kind::variable;
        // The OWL API has two ways to write ?x in full.
        constexpr std::string_view newer = "urn:swrl:var#";
        const Iri& iri = term(node).kind == TermKind::iri ? term(node).value : names_.name(graph_, node);
        result.iri = iri.starts_with(newer) ? "urn:swrl#" + iri.substr(newer.size()) : iri;
    } else {
        result.kind = RuleTerm::Kind::individual;
        result.iri = individual(node, line);
    }
    return result;
}

void AxiomReader::check_arguments(const RuleAtom& atom, long line) const {
    using Kind = RuleAtom::Kind;
    const std::size_t count = atom.arguments.size();
    const bool is_unary = atom.kind == Kind::of_class || atom.kind == Kind::of_data_range;
    if (atom.kind == Kind::built_in) {
        if (count == 0) read_.fail(line, "a built-in of a rule has no arguments; it needs at least one");
        return;
    }
    if (count != (is_unary ? 1U : 2U))
        read_.fail(line, std::string("an atom of a rule has ") + (count == 1 ? "one argument" : "two arguments") +
                             ", but its kind takes " + (is_unary ? "one" : "two"));
    const auto refuse = [&](std::size_t i, RuleTerm::Kind kind, const char* sentence) {
        if (atom.arguments[i].kind == kind) read_.fail(line, sentence);
    };
    if (atom.kind != Kind::of_data_range)
        refuse(0, RuleTerm::Kind::literal, "a literal stands where an atom of a rule wants a thing");
    if (atom.kind == Kind::object_property || atom.kind == Kind::same_as || atom.kind == Kind::different_from)
        refuse(1, RuleTerm::Kind::literal, "a literal stands where an atom of a rule wants a thing");
    if (atom.kind == Kind::of_data_range)
        refuse(0, RuleTerm::Kind::individual, "an individual stands where an atom of a rule wants a value");
    if (atom.kind == Kind::data_property)
        refuse(1, RuleTerm::Kind::individual, "an individual stands where an atom of a rule wants a value");
}

}  // namespace partonomy::owl
