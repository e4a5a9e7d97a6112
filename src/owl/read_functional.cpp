// OWL 2 functional syntax (W3C "Structural Specification", 2012). The grammar is calls with parts, so the text is read
// into constructs without knowing what they mean; axiom by axiom they are then said as triples. A triple stands on the
// line where its axiom begins. Linear in the length of the text.

#include "owl/owl_lexer.h"
#include "owl/structural.h"

namespace partonomy::owl {
namespace {

class FunctionalReader {
public:
    FunctionalReader(const std::string& text, const std::string& base, Graph& graph)
        : lexer_(text, graph.file), prefixes_(base), reader_(graph) {}

    void read();

private:
    void prefix();
    Construct part(int depth);
    Construct name_or_call(int depth);
    Construct literal();
    void parts(Construct& construct, int depth);
    void take(const char* mark, const char* after);

    OwlLexer lexer_;
    OwlPrefixes prefixes_;
    StructuralReader reader_;
};

void FunctionalReader::take(const char* mark, const char* after) {
    if (!lexer_.is_mark(mark))
        lexer_.fail(lexer_.line,
                    "'" + std::string(mark) + "' is expected after " + after + ", here stands " + lexer_.shown());
    lexer_.next();
}

void FunctionalReader::prefix() {
    lexer_.next();
    take("(", "Prefix");
    if (lexer_.kind != OwlToken::word || !lexer_.text.ends_with(':'))
        lexer_.fail(lexer_.line, "a prefix is declared as Prefix(name:=<https://…>), here stands " + lexer_.shown());
    const std::string name = lexer_.text;
    lexer_.next();
    take("=", "the name of a prefix");
    if (lexer_.kind != OwlToken::iri)
        lexer_.fail(lexer_.line, "the prefix '" + name + "' wants an IRI in < >, here stands " + lexer_.shown());
    prefixes_.declare(name, lexer_.text);
    lexer_.next();
    take(")", "the IRI of a prefix");
}

Construct FunctionalReader::literal() {
    Construct construct;
    construct.kind = Construct::Kind::literal;
    construct.line = lexer_.line;
    construct.value = lexer_.text;
    const bool is_number = lexer_.kind == OwlToken::word;
    lexer_.next();
    if (is_number) return construct;
    if (lexer_.kind == OwlToken::language) {
        construct.language = lexer_.text;
        lexer_.next();
    } else if (lexer_.is_mark("^^")) {
        lexer_.next();
        if (lexer_.kind != OwlToken::iri && lexer_.kind != OwlToken::word)
            lexer_.fail(lexer_.line,
                        "a datatype such as xsd:double is expected after '^^', here stands " + lexer_.shown());
        construct.datatype = prefixes_.expand(lexer_);
        lexer_.next();
    }
    return construct;
}

void FunctionalReader::parts(Construct& construct, int depth) {
    const std::string what = construct.name.empty() ? "'('" : construct.name + "(";
    lexer_.next();
    while (!lexer_.is_mark(")")) {
        if (lexer_.kind == OwlToken::end)
            lexer_.fail(lexer_.line, "the file ends before the " + what + " of line " + std::to_string(construct.line) +
                                         " is closed; is it cut off?");
        construct.parts.push_back(part(depth + 1));
    }
    lexer_.next();
}

Construct FunctionalReader::name_or_call(int depth) {
    Construct construct;
    construct.line = lexer_.line;
    if (lexer_.kind == OwlToken::word && lexer_.text.starts_with("_:")) {
        construct.kind = Construct::Kind::anonymous;
        construct.value = lexer_.text.substr(2);
        lexer_.next();
        return construct;
    }
    if (lexer_.kind == OwlToken::iri || lexer_.text.find(':') != std::string::npos) {
        construct.kind = Construct::Kind::iri;
        construct.value = prefixes_.expand(lexer_);
        lexer_.next();
        return construct;
    }
    construct.name = lexer_.text;
    const std::string shown = lexer_.shown();
    lexer_.next();
    if (!lexer_.is_mark("("))
        lexer_.fail(construct.line, shown +
                                        " is no name, which would be prefix:name or <https://…>, and no construct, "
                                        "which would go on with '('");
    parts(construct, depth);
    if (is_typed_name(construct.name)) {
        if (construct.parts.size() != 1 || construct.parts[0].kind != Construct::Kind::iri ||
            !construct.parts[0].name.empty())
            lexer_.fail(construct.line, construct.name + " wants one name in its parentheses");
        construct.kind = Construct::Kind::iri;
        construct.value = construct.parts[0].value;
        construct.parts.clear();
    }
    return construct;
}

Construct FunctionalReader::part(int depth) {
    if (depth > max_construct_depth)
        lexer_.fail(lexer_.line, "parentheses are nested more than " + std::to_string(max_construct_depth) + " deep");
    if (lexer_.kind == OwlToken::string || (lexer_.kind == OwlToken::word && is_number_word(lexer_.text)))
        return literal();
    if (lexer_.kind == OwlToken::iri || lexer_.kind == OwlToken::word) return name_or_call(depth);
    if (!lexer_.is_mark("("))
        lexer_.fail(lexer_.line,
                    "syntax error: a name, literal or construct should stand where " + lexer_.shown() + " stands");
    Construct group;
    group.kind = Construct::Kind::group;
    group.line = lexer_.line;
    parts(group, depth);
    return group;
}

void FunctionalReader::read() {
    lexer_.next();
    while (lexer_.is_word("Prefix")) prefix();
    if (!lexer_.is_word("Ontology"))
        lexer_.fail(lexer_.line, "Prefix( or Ontology( is expected where " + lexer_.shown() + " stands");
    const long line = lexer_.line;
    lexer_.next();
    take("(", "Ontology");
    Iri names[2];
    for (Iri& name : names) {
        if (lexer_.kind != OwlToken::iri &&
            (lexer_.kind != OwlToken::word || lexer_.text.find(':') == std::string::npos))
            break;
        name = prefixes_.expand(lexer_);
        lexer_.next();
    }
    reader_.ontology(names[0], names[1], line);
    while (!lexer_.is_mark(")")) {
        if (lexer_.kind == OwlToken::end)
            lexer_.fail(lexer_.line, "the file ends before the Ontology( of line " + std::to_string(line) +
                                         " is closed; is it cut off?");
        reader_.read(part(1));
    }
    lexer_.next();
    if (lexer_.kind != OwlToken::end)
        lexer_.fail(lexer_.line, lexer_.shown() + " stands after the end of the ontology");
}

}  // namespace

void read_functional(const std::string& text, const std::string& base, Graph& graph) {
    FunctionalReader(text, base, graph).read();
}

}  // namespace partonomy::owl
