// The frames of Manchester syntax (W3C Working Group Note, 11 December 2012), and what Protégé writes beyond it: rules
// (Rule:), SuperClassOf:, SuperPropertyOf:, Individuals: of a class, Inverses:, and a class expression as the subject
// of Class:. An axiom stands on the line where its own part of the list begins. Linear in the length of the text.

#include "owl/read_manchester.h"

#include <algorithm>
#include <array>

#include "base/spelling.h"

namespace partonomy::owl {
namespace {

constexpr std::array keywords = {"Annotations:",
                                 "AnnotationProperty:",
                                 "Characteristics:",
                                 "Class:",
                                 "DataProperty:",
                                 "Datatype:",
                                 "DifferentFrom:",
                                 "DisjointClasses:",
                                 "DisjointUnionOf:",
                                 "DisjointWith:",
                                 "Domain:",
                                 "DisjointProperties:",
                                 "EquivalentTo:",
                                 "EquivalentClasses:",
                                 "EquivalentProperties:",
                                 "Facts:",
                                 "HasKey:",
                                 "Import:",
                                 "Individual:",
                                 "Individuals:",
                                 "InverseOf:",
                                 "Inverses:",
                                 "ObjectProperty:",
                                 "Ontology:",
                                 "Prefix:",
                                 "Range:",
                                 "Rule:",
                                 "SameAs:",
                                 "SameIndividual:",
                                 "SubClassOf:",
                                 "SubPropertyOf:",
                                 "SubPropertyChain:",
                                 "SuperClassOf:",
                                 "SuperPropertyOf:",
                                 "Types:",
                                 "DifferentIndividuals:"};

class ManchesterReader : private ManchesterExpressions {
public:
    using ManchesterExpressions::ManchesterExpressions;
    void read();

private:
    void prefix();
    void header();
    void frame();
    void class_frame();
    void object_property_frame();
    void data_property_frame();
    void annotation_property_frame();
    void datatype_frame();
    void individual_frame();
    void misc_frame(const std::string& keyword);
    void end_frame(const char* frame) const;
    void facts(Node subject);
    void characteristics(Node subject, bool over_data);
    void chains(Node subject);
    void has_key(Node subject);
    void rule();
    void entity_annotations(Node subject);

    /// Calls `say` for each item of a comma list, with the item's line and annotations.
    template <typename Say>
    void items(Say say) {
        do {
            const std::vector<Note> notes = annotations();
            const long line = lexer_.line;
            say(line, notes);
        } while (take_mark(","));
    }
    /// A section whose items become `subject predicate item`.
    template <typename Read>
    void pairs(Node subject, Word predicate, Read read) {
        items([&](long line, const std::vector<Note>& notes) { say_.axiom(subject, predicate, read(), line, notes); });
    }
    Node object_property() {
        const long line = lexer_.line;
        const Node node = property();
        say_.expect(node, EntityKind::object_property, line);
        return node;
    }
    Node data_property() {
        const long line = lexer_.line;
        const Node node = name("a data property");
        say_.expect(node, EntityKind::data_property, line);
        return node;
    }
    Node plain_iri() { return name("an IRI"); }
};

/// What follows the sections of a frame has to begin another frame.
void ManchesterReader::end_frame(const char* frame) const {
    if (lexer_.kind == OwlToken::end) return;
    if (is_keyword() && std::ranges::find(keywords, lexer_.text) != keywords.end()) return;
    if (!is_keyword())
        lexer_.fail(lexer_.line, "a keyword such as SubClassOf: or Class:, or a comma, is expected in " +
                                     std::string(frame) + " where " + lexer_.shown() + " stands");
    std::string nearest;
    std::size_t best = lexer_.text.size() / 3 + 1;
    for (const char* keyword : keywords) {
        if (lexer_.text.size() > 100) break;
        const std::size_t distance = edit_distance(lexer_.text, keyword);
        if (distance >= best) continue;
        best = distance;
        nearest = keyword;
    }
    lexer_.fail(lexer_.line, lexer_.shown() + " is no keyword of Manchester syntax" +
                                 (nearest.empty() ? "" : " (did you mean " + nearest + "?)"));
}

void ManchesterReader::prefix() {
    if (lexer_.kind != OwlToken::word || !lexer_.text.ends_with(':'))
        lexer_.fail(lexer_.line, "a prefix is declared as 'Prefix: name: <https://…>', here stands " + lexer_.shown());
    const std::string declared = lexer_.text;
    lexer_.next();
    if (lexer_.kind != OwlToken::iri)
        lexer_.fail(lexer_.line, "the prefix '" + declared + "' wants an IRI in < >, here stands " + lexer_.shown());
    prefixes_.declare(declared, lexer_.text);
    lexer_.next();
}

void ManchesterReader::header() {
    const long line = lexer_.line;
    const bool is_declared = section("Ontology:");
    const auto is_name = [&] {
        return is_declared && (lexer_.kind == OwlToken::iri || (lexer_.kind == OwlToken::word && !is_keyword()));
    };
    const Node ontology = is_name() ? plain_iri() : graph_.blank();
    say_.say(ontology, Word::rdf_type, Word::owl_Ontology, line);
    if (is_name()) say_.say(ontology, Word::owl_versionIRI, plain_iri(), line);
    for (;;) {
        const long at_line = lexer_.line;
        if (section("Import:")) {
            say_.say(ontology, Word::owl_imports, plain_iri(), at_line);
        } else if (lexer_.is_word("Annotations:")) {
            say_.annotate(ontology, annotations());
        } else {
            return end_frame("the head of the ontology");
        }
    }
}

void ManchesterReader::entity_annotations(Node subject) {
    for (const Note& note : annotations()) say_.axiom(subject, note.property, note.value, note.line, note.notes);
}

void ManchesterReader::frame() {
    const std::string keyword = lexer_.text;
    if (section("Class:")) return class_frame();
    if (section("ObjectProperty:")) return object_property_frame();
    if (section("DataProperty:")) return data_property_frame();
    if (section("AnnotationProperty:")) return annotation_property_frame();
    if (section("Datatype:")) return datatype_frame();
    if (section("Individual:")) return individual_frame();
    if (section("Rule:")) return rule();
    if (section("Prefix:")) return prefix();
    for (const char* misc : {"EquivalentClasses:", "DisjointClasses:", "EquivalentProperties:", "DisjointProperties:",
                             "SameIndividual:", "DifferentIndividuals:"}) {
        if (section(misc)) return misc_frame(keyword);
    }
    if (is_keyword() && std::ranges::find(keywords, keyword) != keywords.end())
        lexer_.fail(lexer_.line,
                    "'" + keyword + "' does not belong here; it stands inside the frame of an entity that has it");
    end_frame("the ontology");
}

void ManchesterReader::class_frame() {
    const long line = lexer_.line;
    const Node subject = description();
    if (graph_.terms[subject].kind == TermKind::iri) say_.say(subject, Word::rdf_type, Word::owl_Class, line);
    for (;;) {
        if (section("SubClassOf:")) {
            pairs(subject, Word::rdfs_subClassOf, [&] { return description(); });
        } else if (section("EquivalentTo:")) {
            pairs(subject, Word::owl_equivalentClass, [&] { return description(); });
        } else if (section("DisjointWith:")) {
            pairs(subject, Word::owl_disjointWith, [&] { return description(); });
        } else if (section("SuperClassOf:")) {
            items([&](long at_line, const std::vector<Note>& notes) {
                say_.axiom(description(), Word::rdfs_subClassOf, subject, at_line, notes);
            });
        } else if (section("DisjointUnionOf:")) {
            const std::vector<Note> notes = annotations();
            const long at_line = lexer_.line;
            std::vector<Node> members;
            do members.push_back(description());
            while (take_mark(","));
            say_.axiom(subject, Word::owl_disjointUnionOf, say_.list(members, at_line), at_line, notes);
        } else if (section("HasKey:")) {
            has_key(subject);
        } else if (section("Individuals:")) {
            items([&](long at_line, const std::vector<Note>& notes) {
                say_.axiom(individual(), Word::rdf_type, subject, at_line, notes);
            });
        } else if (lexer_.is_word("Annotations:")) {
            entity_annotations(subject);
        } else {
            return end_frame("a Class frame");
        }
    }
}

void ManchesterReader::has_key(Node subject) {
    const std::vector<Note> notes = annotations();
    const long line = lexer_.line;
    std::vector<Node> properties = {property()};
    while (take_mark(",") || begins_primary()) properties.push_back(property());
    say_.axiom(subject, Word::owl_hasKey, say_.list(properties, line), line, notes);
}

void ManchesterReader::characteristics(Node subject, bool over_data) {
    items([&](long line, const std::vector<Note>& notes) {
        constexpr std::pair<const char*, Word> known[] = {
            {"Functional", Word::owl_FunctionalProperty}, {"InverseFunctional", Word::owl_InverseFunctionalProperty},
            {"Reflexive", Word::owl_ReflexiveProperty},   {"Irreflexive", Word::owl_IrreflexiveProperty},
            {"Symmetric", Word::owl_SymmetricProperty},   {"Asymmetric", Word::owl_AsymmetricProperty},
            {"Transitive", Word::owl_TransitiveProperty},
        };
        const auto* const found =
            std::ranges::find_if(known, [&](const auto& entry) { return lexer_.is_word(entry.first); });
        if (found == std::end(known) || (over_data && found != std::begin(known)))
            lexer_.fail(line, lexer_.shown() + " is no characteristic of " +
                                  (over_data ? "a data property, which can be Functional"
                                             : "an object property, such as Functional or Transitive"));
        lexer_.next();
        say_.axiom(subject, Word::rdf_type, graph_.word(found->second), line, notes);
    });
}

void ManchesterReader::chains(Node subject) {
    items([&](long line, const std::vector<Note>& notes) {
        std::vector<Node> chain = {object_property()};
        while (lexer_.is_word("o")) {
            lexer_.next();
            chain.push_back(object_property());
        }
        say_.axiom(subject, Word::owl_propertyChainAxiom, say_.list(chain, line), line, notes);
    });
}

void ManchesterReader::object_property_frame() {
    const long line = lexer_.line;
    const Node subject = property();
    if (graph_.terms[subject].kind == TermKind::iri) say_.say(subject, Word::rdf_type, Word::owl_ObjectProperty, line);
    for (;;) {
        if (section("Domain:")) {
            pairs(subject, Word::rdfs_domain, [&] { return description(); });
        } else if (section("Range:")) {
            pairs(subject, Word::rdfs_range, [&] { return description(); });
        } else if (section("Characteristics:")) {
            characteristics(subject, false);
        } else if (section("SubPropertyOf:")) {
            pairs(subject, Word::rdfs_subPropertyOf, [&] { return object_property(); });
        } else if (section("SuperPropertyOf:")) {
            items([&](long at_line, const std::vector<Note>& notes) {
                say_.axiom(object_property(), Word::rdfs_subPropertyOf, subject, at_line, notes);
            });
        } else if (section("EquivalentTo:")) {
            pairs(subject, Word::owl_equivalentProperty, [&] { return object_property(); });
        } else if (section("DisjointWith:")) {
            pairs(subject, Word::owl_propertyDisjointWith, [&] { return object_property(); });
        } else if (section("InverseOf:") || section("Inverses:")) {
            pairs(subject, Word::owl_inverseOf, [&] { return object_property(); });
        } else if (section("SubPropertyChain:")) {
            chains(subject);
        } else if (lexer_.is_word("Annotations:")) {
            entity_annotations(subject);
        } else {
            return end_frame("an ObjectProperty frame");
        }
    }
}

void ManchesterReader::data_property_frame() {
    const long line = lexer_.line;
    const Node subject = name("a data property");
    say_.say(subject, Word::rdf_type, Word::owl_DatatypeProperty, line);
    for (;;) {
        if (section("Domain:")) {
            pairs(subject, Word::rdfs_domain, [&] { return description(); });
        } else if (section("Range:")) {
            pairs(subject, Word::rdfs_range, [&] { return description(); });
        } else if (section("Characteristics:")) {
            characteristics(subject, true);
        } else if (section("SubPropertyOf:")) {
            pairs(subject, Word::rdfs_subPropertyOf, [&] { return data_property(); });
        } else if (section("SuperPropertyOf:")) {
            items([&](long at_line, const std::vector<Note>& notes) {
                say_.axiom(data_property(), Word::rdfs_subPropertyOf, subject, at_line, notes);
            });
        } else if (section("EquivalentTo:")) {
            pairs(subject, Word::owl_equivalentProperty, [&] { return data_property(); });
        } else if (section("DisjointWith:")) {
            pairs(subject, Word::owl_propertyDisjointWith, [&] { return data_property(); });
        } else if (lexer_.is_word("Annotations:")) {
            entity_annotations(subject);
        } else {
            return end_frame("a DataProperty frame");
        }
    }
}

void ManchesterReader::annotation_property_frame() {
    const long line = lexer_.line;
    const Node subject = name("an annotation property");
    say_.say(subject, Word::rdf_type, Word::owl_AnnotationProperty, line);
    for (;;) {
        if (section("Domain:")) {
            pairs(subject, Word::rdfs_domain, [&] { return plain_iri(); });
        } else if (section("Range:")) {
            pairs(subject, Word::rdfs_range, [&] { return plain_iri(); });
        } else if (section("SubPropertyOf:")) {
            pairs(subject, Word::rdfs_subPropertyOf, [&] { return plain_iri(); });
        } else if (lexer_.is_word("Annotations:")) {
            entity_annotations(subject);
        } else {
            return end_frame("an AnnotationProperty frame");
        }
    }
}

void ManchesterReader::datatype_frame() {
    const long line = lexer_.line;
    const bool is_short =
        lexer_.is_word("integer") || lexer_.is_word("decimal") || lexer_.is_word("float") || lexer_.is_word("string");
    const Node subject = is_short ? primary() : name("a datatype");
    say_.say(subject, Word::rdf_type, Word::rdfs_Datatype, line);
    for (;;) {
        if (section("EquivalentTo:")) {
            pairs(subject, Word::owl_equivalentClass, [&] { return description(); });
        } else if (lexer_.is_word("Annotations:")) {
            entity_annotations(subject);
        } else {
            return end_frame("a Datatype frame");
        }
    }
}

void ManchesterReader::facts(Node subject) {
    items([&](long line, const std::vector<Note>& notes) {
        const bool is_negative = lexer_.is_word("not");
        if (is_negative) lexer_.next();
        const Node on = property();
        const bool over_data = is_literal();
        const Node value = over_data ? literal() : individual();
        say_.expect(on, over_data ? EntityKind::data_property : EntityKind::object_property, line);
        if (is_negative) {
            return say_.negative_assertion(subject, on, over_data ? Word::owl_targetValue : Word::owl_targetIndividual,
                                           value, line, notes);
        }
        if (graph_.terms[on].kind == TermKind::blank)
            lexer_.fail(line, "a fact names a property, not an inverse; write it from the other side");
        say_.axiom(subject, on, value, line, notes);
    });
}

void ManchesterReader::individual_frame() {
    const long line = lexer_.line;
    const Node subject = individual();
    if (graph_.terms[subject].kind == TermKind::iri) say_.say(subject, Word::rdf_type, Word::owl_NamedIndividual, line);
    for (;;) {
        if (section("Types:")) {
            pairs(subject, Word::rdf_type, [&] { return description(); });
        } else if (section("Facts:")) {
            facts(subject);
        } else if (section("SameAs:")) {
            pairs(subject, Word::owl_sameAs, [&] { return individual(); });
        } else if (section("DifferentFrom:")) {
            pairs(subject, Word::owl_differentFrom, [&] { return individual(); });
        } else if (lexer_.is_word("Annotations:")) {
            entity_annotations(subject);
        } else {
            return end_frame("an Individual frame");
        }
    }
}

void ManchesterReader::misc_frame(const std::string& keyword) {
    const std::vector<Note> notes = annotations();
    const long line = lexer_.line;
    const bool over_classes = keyword.ends_with("Classes:");
    const bool over_individuals = keyword.find("Individual") != std::string::npos;
    std::vector<Node> members;
    do members.push_back(over_classes ? description() : over_individuals ? individual() : property());
    while (take_mark(","));
    if (members.size() < 2) lexer_.fail(line, keyword + " wants at least two members, with commas between them");
    if (keyword == "EquivalentClasses:") say_.chain(Word::owl_equivalentClass, members, line, notes);
    if (keyword == "EquivalentProperties:") say_.chain(Word::owl_equivalentProperty, members, line, notes);
    if (keyword == "SameIndividual:") say_.chain(Word::owl_sameAs, members, line, notes);
    if (keyword == "DisjointClasses:")
        say_.pairwise(Word::owl_disjointWith, Word::owl_AllDisjointClasses, Word::owl_members, members, line, notes);
    if (keyword == "DisjointProperties:")
        say_.pairwise(Word::owl_propertyDisjointWith, Word::owl_AllDisjointProperties, Word::owl_members, members, line,
                      notes);
    if (keyword == "DifferentIndividuals:")
        say_.pairwise(Word::owl_differentFrom, Word::owl_AllDifferent, Word::owl_members, members, line, notes);
    end_frame("the ontology");
}

void ManchesterReader::rule() {
    const std::vector<Note> notes = annotations();
    const long line = lexer_.line;
    const std::vector<Node> body = atoms();
    want_mark("->", "the body of a rule");
    say_.rule(body, atoms(), line, notes);
    end_frame("a Rule");
}

void ManchesterReader::read() {
    graph_.kinds_are_open = true;
    lexer_.next();
    while (section("Prefix:")) prefix();
    header();
    while (lexer_.kind != OwlToken::end) frame();
}

}  // namespace

void read_manchester(const std::string& text, const std::string& base, Graph& graph) {
    ManchesterReader(text, base, graph).read();
}

}  // namespace partonomy::owl
