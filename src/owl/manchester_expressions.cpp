// Class expressions and data ranges of Manchester syntax (W3C Working Group Note, 11 December 2012) by recursive
// descent, one token ahead. Both have the same grammar here, since `p some (X or not Y)` reads alike over things and
// over data. Beyond the note, as Protégé writes: `p some Self`.

#include <algorithm>
#include <charconv>
#include <optional>

#include "owl/read_manchester.h"

namespace partonomy::owl {
namespace {

constexpr int max_depth = 500;

bool is_reserved_word(std::string_view word) {
    for (const char* reserved : {"and", "or", "not", "that", "some", "only", "value", "Self", "min", "max", "exactly",
                                 "inverse", "o", "true", "false"}) {
        if (word == reserved) return true;
    }
    return false;
}

/// Datatypes that have a short name of their own.
const char* short_datatype(std::string_view word) {
    for (const char* name : {"integer", "decimal", "float", "string"}) {
        if (word == name) return name;
    }
    return nullptr;
}

Iri facet_iri(std::string_view word) {
    const std::string xsd = xsd_prefix;
    if (word == ">=") return xsd + "minInclusive";
    if (word == "<=") return xsd + "maxInclusive";
    if (word == ">") return xsd + "minExclusive";
    if (word == "<") return xsd + "maxExclusive";
    for (const char* name : {"length", "minLength", "maxLength", "pattern", "totalDigits", "fractionDigits"}) {
        if (word == name) return xsd + name;
    }
    return word == "langRange" ? std::string(rdf_prefix) + "langRange" : Iri();
}

/// The datatype that a bare number has by itself; `text` loses the f that marks a float. Nothing for no number.
std::optional<Iri> number_type(std::string& text) {
    const std::string xsd = xsd_prefix;
    const bool is_float = text.ends_with('f') || text.ends_with('F');
    if (is_float) text.pop_back();
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* end = text.data() + text.size();
    double value = 0;
    const auto result = std::from_chars(begin, end, value);
    if (result.ptr != end || begin == end || result.ec == std::errc::invalid_argument) return std::nullopt;
    if (is_float) return xsd + "float";
    if (text.find_first_of("eE") != std::string::npos) return xsd + "double";
    return xsd + (text.find('.') == std::string::npos ? "integer" : "decimal");
}

bool takes_number(const Iri& datatype, bool is_whole) {
    const std::string xsd = xsd_prefix;
    if (datatype == xsd + "double" || datatype == xsd + "float" || datatype == xsd + "decimal") return true;
    return is_whole && std::ranges::any_of(numeric_datatypes, [&](const char* name) { return datatype == xsd + name; });
}

}  // namespace

struct ManchesterExpressions::Nested {
    explicit Nested(ManchesterExpressions& reader) : owner(reader) {
        if (++owner.depth_ > max_depth) {
            owner.lexer_.fail(owner.lexer_.line, "class expressions are nested more than " + std::to_string(max_depth) +
                                                     " deep; give inner ones names of their own");
        }
    }
    ~Nested() { --owner.depth_; }
    Nested(const Nested&) = delete;
    Nested& operator=(const Nested&) = delete;
    ManchesterExpressions& owner;
};

bool ManchesterExpressions::take_mark(std::string_view mark) {
    if (!lexer_.is_mark(mark)) return false;
    lexer_.next();
    return true;
}

void ManchesterExpressions::want_mark(std::string_view mark, const char* after) {
    if (take_mark(mark)) return;
    lexer_.fail(lexer_.line,
                between("'", std::string(mark), "' is expected after ") + after + ", here stands " + lexer_.shown());
}

bool ManchesterExpressions::begins_primary() const {
    if (lexer_.kind == OwlToken::word) {
        return !is_keyword() && !is_number_word(lexer_.text) &&
               (!is_reserved_word(lexer_.text) || lexer_.text == "not" || lexer_.text == "inverse");
    }
    return lexer_.kind == OwlToken::iri || lexer_.is_mark("(") || lexer_.is_mark("{");
}

Node ManchesterExpressions::name(const char* wanted) {
    const bool is_name = lexer_.kind == OwlToken::iri ||
                         (lexer_.kind == OwlToken::word && !is_reserved_word(lexer_.text) &&
                          !is_number_word(lexer_.text) && !lexer_.text.starts_with("_:") && !is_keyword());
    if (!is_name) lexer_.fail(lexer_.line, std::string(wanted) + " is expected where " + lexer_.shown() + " stands");
    const Node node = graph_.iri(prefixes_.expand(lexer_), lexer_.line);
    lexer_.next();
    return node;
}

Node ManchesterExpressions::individual() {
    if (lexer_.kind != OwlToken::word || !lexer_.text.starts_with("_:")) return name("an individual");
    const Node node = graph_.blank(lexer_.text.substr(2));
    lexer_.next();
    return node;
}

Node ManchesterExpressions::property() {
    if (!lexer_.is_word("inverse")) return name("a property");
    const long line = lexer_.line;
    lexer_.next();
    const bool is_bracketed = take_mark("(");
    const Node inverse = say_.inverse(name("an object property"), line);
    if (is_bracketed) want_mark(")", "the property after 'inverse ('");
    return inverse;
}

bool ManchesterExpressions::is_literal() const {
    return lexer_.kind == OwlToken::string || lexer_.is_word("true") || lexer_.is_word("false") ||
           (lexer_.kind == OwlToken::word && is_number_word(lexer_.text));
}

Node ManchesterExpressions::literal(const Iri& context) {
    if (!is_literal()) lexer_.fail(lexer_.line, "a literal is expected where " + lexer_.shown() + " stands");
    std::string value = lexer_.text;
    if (lexer_.kind == OwlToken::word) {
        std::optional<Iri> type = std::string(xsd_prefix) + "boolean";
        if (value != "true" && value != "false") type = number_type(value);
        if (!type) lexer_.fail(lexer_.line, lexer_.shown() + " is no number");
        const bool is_whole = value.find_first_of(".eE") == std::string::npos;
        if (!type->ends_with("boolean") && takes_number(context, is_whole)) type = context;
        lexer_.next();
        return graph_.literal(value, *type);
    }
    lexer_.next();
    if (lexer_.kind == OwlToken::language) {
        const std::string language = lexer_.text;
        lexer_.next();
        return say_.literal(value, {}, language);
    }
    if (!take_mark("^^")) return say_.literal(value, {}, {});
    if (const char* type = lexer_.kind == OwlToken::word ? short_datatype(lexer_.text) : nullptr) {
        lexer_.next();
        return graph_.literal(value, std::string(xsd_prefix) + type);
    }
    return say_.literal(value, std::string(graph_.terms[name("a datatype")].value), {});
}

Node ManchesterExpressions::description() {
    const long line = lexer_.line;
    std::vector<Node> members = {conjunction()};
    while (lexer_.is_word("or")) {
        lexer_.next();
        members.push_back(conjunction());
    }
    return members.size() == 1 ? members[0] : say_.connective(Word::none, Word::owl_unionOf, members, line);
}

Node ManchesterExpressions::conjunction() {
    const long line = lexer_.line;
    std::vector<Node> members = {primary()};
    while (lexer_.is_word("and") || lexer_.is_word("that")) {
        lexer_.next();
        members.push_back(primary());
    }
    return members.size() == 1 ? members[0] : say_.connective(Word::none, Word::owl_intersectionOf, members, line);
}

Node ManchesterExpressions::primary() {
    const Nested nested(*this);
    const long line = lexer_.line;
    if (lexer_.is_word("not")) {
        lexer_.next();
        return say_.complement(Word::none, Word::owl_complementOf, primary(), line);
    }
    if (lexer_.is_mark("{")) return one_of();
    if (take_mark("(")) {
        const Node inner = description();
        want_mark(")", between("a class expression that begins with '(' in line ", std::to_string(line), "").c_str());
        return inner;
    }
    if (lexer_.is_word("inverse")) return restriction(property(), line);
    Node node = 0;
    if (const char* type = lexer_.kind == OwlToken::word ? short_datatype(lexer_.text) : nullptr) {
        node = graph_.iri(std::string(xsd_prefix) + type, line);
        lexer_.next();
    } else {
        node = name("a class, property or datatype");
    }
    if (lexer_.is_mark("[")) return facets(node, line);
    for (const char* mark : {"<", "<=", ">", ">="}) {
        if (lexer_.is_mark(mark)) refuse_bare_comparison(node, line);
    }
    for (const char* word : {"some", "only", "value", "Self", "min", "max", "exactly"}) {
        if (lexer_.is_word(word)) return restriction(node, line);
    }
    return node;
}

void ManchesterExpressions::refuse_bare_comparison(Node property, long line) {
    const std::string mark = lexer_.text;
    lexer_.next();
    const std::string number = lexer_.kind == OwlToken::word && is_number_word(lexer_.text) ? lexer_.text : "0.5";
    lexer_.fail(line, "a restriction to numbers names the datatype and puts the bounds in square brackets: " +
                          local_name(graph_.terms[property].value) + " some xsd:double[" + mark + " " + number + "]");
}

Node ManchesterExpressions::restriction(Node on, long line) {
    const std::string word = lexer_.kind == OwlToken::word ? lexer_.text : std::string();
    if (word.empty() || !is_reserved_word(word))
        lexer_.fail(lexer_.line,
                    "some, only, value, min, max or exactly is expected where " + lexer_.shown() + " stands");
    lexer_.next();
    const bool is_some = word == "some";
    if (word == "Self" || (is_some && lexer_.is_word("Self"))) {
        if (is_some) lexer_.next();
        return say_.restriction(on, Word::owl_hasSelf, graph_.literal("true", std::string(xsd_prefix) + "boolean"),
                                line);
    }
    if (is_some || word == "only")
        return say_.restriction(on, is_some ? Word::owl_someValuesFrom : Word::owl_allValuesFrom, primary(), line);
    if (word == "value") return say_.restriction(on, Word::owl_hasValue, is_literal() ? literal() : individual(), line);
    const Word kind = word == "min"       ? Word::owl_minCardinality
                      : word == "max"     ? Word::owl_maxCardinality
                      : word == "exactly" ? Word::owl_cardinality
                                          : Word::none;
    if (kind == Word::none)
        lexer_.fail(line, "some, only, value, min, max or exactly is expected after a property, not '" + word + "'");
    if (lexer_.kind != OwlToken::word || !is_number_word(lexer_.text))
        lexer_.fail(lexer_.line, "a whole number is expected after '" + word + "', here stands " + lexer_.shown());
    const std::string number = lexer_.text;
    lexer_.next();
    const bool is_qualified = begins_primary();
    return say_.cardinality(on, kind, number, is_qualified ? Word::owl_onClass : Word::none,
                            is_qualified ? primary() : 0, line);
}

Node ManchesterExpressions::one_of() {
    const long line = lexer_.line;
    lexer_.next();
    std::vector<Node> members;
    do {
        members.push_back(is_literal() ? literal() : individual());
    } while (take_mark(","));
    want_mark("}", "the members of '{'");
    return say_.connective(Word::none, Word::owl_oneOf, members, line);
}

Node ManchesterExpressions::facets(Node datatype, long line) {
    lexer_.next();
    std::vector<std::pair<Node, Node>> facets;
    std::string number;  // the last one
    do {
        if (!number.empty() && number.find('.') == std::string::npos && lexer_.kind == OwlToken::word &&
            is_number_word(lexer_.text))
            lexer_.fail(lexer_.line, "numbers take a decimal point: write " + number + "." + lexer_.text + " for " +
                                         number + "," + lexer_.text);
        const Iri facet =
            lexer_.kind == OwlToken::word || lexer_.kind == OwlToken::mark ? facet_iri(lexer_.text) : Iri();
        if (facet.empty())
            lexer_.fail(lexer_.line,
                        "a facet such as '>=' or 'maxLength' is expected where " + lexer_.shown() + " stands");
        lexer_.next();
        number = lexer_.kind == OwlToken::word ? lexer_.text : std::string();
        const Iri context = facet.ends_with("clusive") ? graph_.terms[datatype].value : Iri();
        facets.emplace_back(graph_.iri(facet, line), literal(context));
    } while (take_mark(","));
    want_mark("]", "the facets of a datatype");
    return say_.datatype_restriction(datatype, facets, line);
}

}  // namespace partonomy::owl
