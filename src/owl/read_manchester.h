#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "owl/owl_lexer.h"
#include "owl/statements.h"

namespace partonomy::owl {

/// Names, literals, expressions, annotations and atoms of Manchester syntax, said as triples. Whether `p some X` is
/// about things or data the text does not tell; it is left open, and follows from p once all declarations are known.
class ManchesterExpressions {
public:
    ManchesterExpressions(const std::string& text, const std::string& base, Graph& graph)
        : lexer_(text, graph.file), prefixes_(base), graph_(graph), say_(graph) {}

protected:
    [[nodiscard]] Node description();
    [[nodiscard]] Node primary();
    [[nodiscard]] Node property();    ///< a name, or `inverse` and a name
    [[nodiscard]] Node individual();  ///< a name, or _:label
    [[nodiscard]] Node name(const char* wanted);
    /// The present literal; a bare number takes the datatype `context` if that is a datatype of numbers.
    [[nodiscard]] Node literal(const Iri& context = {});
    [[nodiscard]] bool is_literal() const;
    [[nodiscard]] bool begins_primary() const;
    /// A word that can be no name, since it begins a section or frame.
    [[nodiscard]] bool is_keyword() const { return lexer_.kind == OwlToken::word && lexer_.text.ends_with(':'); }
    /// The annotations that stand here, if any.
    [[nodiscard]] std::vector<Note> annotations(int depth = 0);
    [[nodiscard]] std::vector<Node> atoms();  ///< of a rule's body or head
    bool section(const char* keyword);        ///< takes the keyword if it stands here
    bool take_mark(std::string_view mark);
    void want_mark(std::string_view mark, const char* after);

    OwlLexer lexer_;
    OwlPrefixes prefixes_;
    Graph& graph_;
    Statements say_;

private:
    struct Nested;
    [[nodiscard]] Node conjunction();
    [[nodiscard]] Node restriction(Node on, long line);
    [[noreturn]] void refuse_bare_comparison(Node property, long line);
    [[nodiscard]] Node one_of();
    [[nodiscard]] Node facets(Node datatype, long line);
    [[nodiscard]] Node atom();
    [[nodiscard]] std::vector<Node> arguments();

    int depth_ = 0;
};

}  // namespace partonomy::owl
