// Turtle (W3C Recommendation, 25 February 2014) by recursive descent, one token ahead. What we add to the grammar is
// the line of each triple: a person looks for `rdfs:subClassOf`, not for the dot that ends the block, so a triple
// stands at its predicate, and the second and later values of a comma list at the value. Linear in the length of the
// text.

#include <map>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "base/errors.h"
#include "base/spelling.h"
#include "owl/rdf_graph.h"
#include "owl/turtle_lexer.h"

namespace partonomy::owl {
namespace {

using Kind = TurtleToken;

class TurtleReader {
public:
    TurtleReader(const std::string& text, std::string base, Graph& graph)
        : lexer_(text, graph.file), base_(std::move(base)), graph_(graph) {}

    void read() {
        lexer_.next();
        while (lexer_.kind != Kind::end) statement();
    }

private:
    static constexpr int max_depth = 500;  ///< of [ and (: each costs stack, and no person nests deeper

    void statement();
    void prefix(bool is_sparql);
    void base(bool is_sparql);
    void end_statement(const std::string& after);
    void predicates(Node subject);
    void objects(Node subject, Node predicate, long line);
    Node verb();
    Node term();
    Node named();
    Node bracket();
    Node collection();
    Node string_literal();
    [[nodiscard]] bool is_word(std::string_view word) const;
    std::string expanded();

    /// Counts open brackets, so that the stack stays bounded.
    struct Nested {
        explicit Nested(TurtleReader& reader) : owner(reader) {
            if (++owner.depth_ > max_depth) {
                owner.lexer_.fail(owner.lexer_.line,
                                  "brackets are nested more than " + std::to_string(max_depth) + " deep");
            }
        }
        ~Nested() { --owner.depth_; }
        Nested(const Nested&) = delete;
        Nested& operator=(const Nested&) = delete;
        TurtleReader& owner;
    };

    TurtleLexer lexer_;
    std::string base_;
    Graph& graph_;
    std::map<std::string, std::string, std::less<>> prefixes_;
    std::unordered_map<std::string, Node> names_;  ///< nodes of prefixed names, as the prefixes are now
    std::string name_;                             ///< the one that is looked up
    int depth_ = 0;
};

/// SPARQL's PREFIX and BASE in any case of letters.
bool TurtleReader::is_word(std::string_view word) const {
    if (lexer_.kind != Kind::keyword || lexer_.text.size() != word.size()) return false;
    for (std::size_t i = 0; i < word.size(); ++i) {
        if ((lexer_.text[i] & ~0x20) != word[i]) return false;
    }
    return true;
}

void TurtleReader::statement() {
    if (lexer_.kind == Kind::directive || is_word("PREFIX") || is_word("BASE")) {
        const bool is_sparql = lexer_.kind == Kind::keyword;
        const bool is_prefix = (lexer_.text[0] | 0x20) == 'p';
        lexer_.next();
        is_prefix ? prefix(is_sparql) : base(is_sparql);
        return;
    }
    const bool is_bracket = lexer_.is_mark('[');
    if (lexer_.kind == Kind::string || lexer_.kind == Kind::integer || lexer_.kind == Kind::decimal ||
        lexer_.kind == Kind::floating) {
        lexer_.fail(lexer_.line,
                    "a statement begins with an IRI or a blank node, not with the literal " + lexer_.shown());
    }
    if (lexer_.kind == Kind::keyword) {
        lexer_.fail(lexer_.line, lexer_.shown() + " begins no statement of Turtle, which would be an IRI such as :" +
                                     lexer_.text + " or <https://…>");
    }
    const Node subject = term();
    if (is_bracket && lexer_.is_mark('.')) {  // [ … ] . says all inside the brackets
        lexer_.next();
        return;
    }
    predicates(subject);
    end_statement("the statement");
}

void TurtleReader::end_statement(const std::string& after) {
    if (!lexer_.is_mark('.')) {
        lexer_.fail(lexer_.line, "syntax error before " + lexer_.shown() + ": " + after +
                                     " before it should end with '.'" +
                                     (after == "the statement" ? ", or go on with ';' or ','" : ""));
    }
    lexer_.next();
}

void TurtleReader::prefix(bool is_sparql) {
    if (lexer_.kind != Kind::name || !lexer_.local.empty()) {
        lexer_.fail(lexer_.line,
                    "a prefix is declared as '@prefix name: <https://…> .', here stands " + lexer_.shown());
    }
    const std::string name = lexer_.text;
    lexer_.next();
    if (lexer_.kind != Kind::iri) {
        lexer_.fail(lexer_.line, "the prefix '" + name + ":' wants an IRI in < >, here stands " + lexer_.shown());
    }
    prefixes_[name] = resolve_iri(base_, lexer_.text);
    names_.clear();
    lexer_.next();
    if (!is_sparql) end_statement("the declaration of the prefix '" + name + ":'");
}

void TurtleReader::base(bool is_sparql) {
    if (lexer_.kind != Kind::iri) {
        lexer_.fail(lexer_.line, "the base is declared as '@base <https://…> .', here stands " + lexer_.shown());
    }
    base_ = resolve_iri(base_, lexer_.text);
    lexer_.next();
    if (!is_sparql) end_statement("the declaration of the base");
}

void TurtleReader::predicates(Node subject) {
    for (;;) {
        const long line = lexer_.line;
        const Node predicate = verb();
        objects(subject, predicate, line);
        if (!lexer_.is_mark(';')) return;
        while (lexer_.is_mark(';')) lexer_.next();
        if (lexer_.is_mark('.') || lexer_.is_mark(']')) return;
    }
}

Node TurtleReader::verb() {
    if (lexer_.kind == Kind::keyword && lexer_.text == "a") {
        lexer_.next();
        return graph_.word(Word::rdf_type);
    }
    if (lexer_.kind != Kind::iri && lexer_.kind != Kind::name) {
        lexer_.fail(lexer_.line, "syntax error: a property should stand where " + lexer_.shown() + " stands");
    }
    return named();
}

void TurtleReader::objects(Node subject, Node predicate, long line) {
    for (;;) {
        const Node object = term();
        graph_.add(subject, predicate, object, line);
        if (!lexer_.is_mark(',')) return;
        lexer_.next();
        line = lexer_.line;
    }
}

Node TurtleReader::term() {
    switch (lexer_.kind) {
        case Kind::iri:
        case Kind::name:
            return named();
        case Kind::blank: {
            const Node node = graph_.blank(lexer_.text);
            lexer_.next();
            return node;
        }
        case Kind::string:
            return string_literal();
        case Kind::integer:
        case Kind::decimal:
        case Kind::floating: {
            const char* type = lexer_.kind == Kind::integer   ? "integer"
                               : lexer_.kind == Kind::decimal ? "decimal"
                                                              : "double";
            const Node node = graph_.literal(lexer_.text, std::string(xsd_prefix) + type);
            lexer_.next();
            return node;
        }
        case Kind::keyword:
            if (lexer_.text == "true" || lexer_.text == "false") {
                const Node node = graph_.literal(lexer_.text, std::string(xsd_prefix) + "boolean");
                lexer_.next();
                return node;
            }
            break;
        case Kind::mark:
            if (lexer_.is_mark('[')) return bracket();
            if (lexer_.is_mark('(')) return collection();
            break;
        default:
            break;
    }
    lexer_.fail(lexer_.line, "syntax error: a value should stand where " + lexer_.shown() + " stands");
}

/// The IRI of prefix:local.
std::string TurtleReader::expanded() {
    const auto found = prefixes_.find(lexer_.text);
    if (found != prefixes_.end()) return found->second + lexer_.local;
    std::string iri = "https://…";
    if (lexer_.text == "owl") iri = owl_prefix;
    if (lexer_.text == "rdf") iri = rdf_prefix;
    if (lexer_.text == "rdfs") iri = rdfs_prefix;
    if (lexer_.text == "xsd") iri = xsd_prefix;
    if (lexer_.text == "core") iri = core_prefix;
    std::vector<std::string> names;
    for (const auto& [name, meaning] : prefixes_) names.push_back(name + ":");
    const std::string meant = iri == "https://…" ? did_you_mean({lexer_.text + ":"}, names) : "";
    if (!meant.empty()) lexer_.fail(lexer_.line, "the prefix of " + lexer_.shown() + " is not declared" + meant);
    lexer_.fail(lexer_.line, "the prefix of " + lexer_.shown() + " is not declared; add '@prefix " + lexer_.text +
                                 ": <" + iri + "> .' above");
}

Node TurtleReader::named() {
    if (lexer_.kind != Kind::name) {
        const Node node = graph_.iri(resolve_iri(base_, lexer_.text), lexer_.line);
        lexer_.next();
        return node;
    }
    name_.assign(lexer_.text).append(1, ':').append(lexer_.local);  // a prefix holds no ':'
    const auto [known, is_new] = names_.try_emplace(name_, 0);
    if (is_new) known->second = graph_.iri(expanded(), lexer_.line);
    lexer_.next();
    return known->second;
}

Node TurtleReader::string_literal() {
    const std::string value = lexer_.text;
    lexer_.next();
    if (lexer_.kind == Kind::language) {
        const Node node = graph_.literal(value, std::string(rdf_prefix) + "langString", lexer_.text);
        lexer_.next();
        return node;
    }
    if (lexer_.kind != Kind::datatype) return graph_.literal(value, std::string(xsd_prefix) + "string");
    lexer_.next();
    if (lexer_.kind != Kind::iri && lexer_.kind != Kind::name) {
        lexer_.fail(lexer_.line, "a datatype such as xsd:double should stand where " + lexer_.shown() + " stands");
    }
    const Node datatype = named();
    return graph_.literal(value, std::string(graph_.terms[datatype].value));
}

Node TurtleReader::bracket() {
    const Nested nested(*this);
    const long line = lexer_.line;
    const Node node = graph_.blank();
    lexer_.next();
    if (!lexer_.is_mark(']')) predicates(node);
    if (!lexer_.is_mark(']')) {
        lexer_.fail(lexer_.line, "syntax error before " + lexer_.shown() + ": the '[' of line " + std::to_string(line) +
                                     " should be closed by ']', or go on with ';' or ','");
    }
    lexer_.next();
    return node;
}

Node TurtleReader::collection() {
    const Nested nested(*this);
    const long line = lexer_.line;
    const Node nil = graph_.word(Word::rdf_nil);
    Node head = nil;
    Node last = nil;
    lexer_.next();
    while (!lexer_.is_mark(')')) {
        const long member_line = lexer_.line;
        if (lexer_.kind == Kind::end || lexer_.is_mark('.') || lexer_.is_mark(']') || lexer_.is_mark(';')) {
            lexer_.fail(member_line, "syntax error before " + lexer_.shown() + ": the '(' of line " +
                                         std::to_string(line) + " should be closed by ')'");
        }
        const Node member = term();
        const Node cell = graph_.blank();
        if (last == nil) {
            head = cell;
        } else {
            graph_.add(last, graph_.word(Word::rdf_rest), cell, member_line);
        }
        graph_.add(cell, graph_.word(Word::rdf_first), member, member_line);
        last = cell;
    }
    if (last != nil) graph_.add(last, graph_.word(Word::rdf_rest), nil, lexer_.line);
    lexer_.next();
    return head;
}

}  // namespace

void read_turtle(const std::string& text, const std::string& base, Graph& graph) {
    TurtleReader(text, base, graph).read();
}

}  // namespace partonomy::owl
