// Annotations and the atoms of rules in Manchester syntax. The W3C note has no rules; their form is the one that
// Protégé writes: A(?x), p(?x, ?y), swrlb:lessThan(?y, 5) -> (p some B)(?x).

#include "owl/read_manchester.h"

namespace partonomy::owl {
namespace {

constexpr int max_annotation_depth = 100;

}  // namespace

bool ManchesterExpressions::section(const char* keyword) {
    if (!lexer_.is_word(keyword)) return false;
    lexer_.next();
    return true;
}

std::vector<Note> ManchesterExpressions::annotations(int depth) {
    if (depth > max_annotation_depth)
        lexer_.fail(lexer_.line, "annotations are nested more than " + std::to_string(max_annotation_depth) + " deep");
    std::vector<Note> notes;
    if (!section("Annotations:")) return notes;
    do {
        Note note;
        note.notes = annotations(depth + 1);
        note.line = lexer_.line;
        note.property = name("an annotation property");
        note.value = is_literal() ? literal() : individual();
        notes.push_back(std::move(note));
    } while (take_mark(","));
    return notes;
}

std::vector<Node> ManchesterExpressions::atoms() {
    std::vector<Node> members;
    if (lexer_.is_mark("->") || lexer_.kind == OwlToken::end || is_keyword()) return members;
    do members.push_back(atom());
    while (take_mark(","));
    return members;
}

/// Whether a name with one argument is a class or a datatype, and one with two a property over things or over data, is
/// settled once declarations are known.
Node ManchesterExpressions::atom() {
    const long line = lexer_.line;
    const bool is_same = lexer_.is_word("SameAs") || lexer_.is_word("sameAs");
    if (is_same || lexer_.is_word("DifferentFrom") || lexer_.is_word("differentFrom")) {
        lexer_.next();
        return say_.atom(is_same ? Word::swrl_SameIndividualAtom : Word::swrl_DifferentIndividualsAtom, Word::none, 0,
                         arguments(), line);
    }
    const bool is_inverse = lexer_.is_word("inverse");
    const Node predicate = is_inverse ? property() : primary();
    const std::vector<Node> given = arguments();
    const Iri& iri = graph_.terms[predicate].value;
    if (given.size() > 2 || (graph_.terms[predicate].kind == TermKind::iri && iri.starts_with(swrlb_prefix)))
        return say_.built_in(predicate, given, line);
    if (given.size() == 1 && !is_inverse)
        return say_.atom(Word::swrl_ClassAtom, Word::swrl_classPredicate, predicate, given, line);
    return say_.atom(Word::swrl_IndividualPropertyAtom, Word::swrl_propertyPredicate, predicate, given, line);
}

std::vector<Node> ManchesterExpressions::arguments() {
    want_mark("(", "the predicate of an atom");
    std::vector<Node> given;
    do {
        const long line = lexer_.line;
        if (take_mark("?")) {
            const bool is_word = lexer_.kind == OwlToken::word && lexer_.text.find(':') == std::string::npos;
            if (lexer_.kind != OwlToken::iri && lexer_.kind != OwlToken::word)
                lexer_.fail(line, "'?' begins a variable such as ?x");
            const Iri iri = is_word ? variable_iri(lexer_.text) : prefixes_.expand(lexer_);
            lexer_.next();
            given.push_back(say_.variable(iri, line));
        } else {
            given.push_back(is_literal() ? literal() : individual());
        }
    } while (take_mark(","));
    want_mark(")", "the arguments of an atom");
    return given;
}

}  // namespace partonomy::owl
