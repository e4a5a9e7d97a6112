#pragma once

#include <string>
#include <string_view>

namespace partonomy::owl {

enum class TurtleToken {
    end,
    iri,       ///< text: between the brackets, escapes resolved
    name,      ///< prefix:local; text: the prefix, local: the local part, escapes resolved
    blank,     ///< _:label; text: the label
    string,    ///< text: the value, escapes resolved
    language,  ///< @en; text: "en"
    integer,
    decimal,
    floating,
    keyword,    ///< a bare word: a, true, false, PREFIX, BASE
    directive,  ///< @prefix, @base; text without '@'
    datatype,   ///< ^^
    mark,       ///< one of . ; , [ ] ( )
};

/// Cuts Turtle text (valid UTF-8) into tokens. Throws OntologyError at the line of a token that is none.
class TurtleLexer {
public:
    TurtleLexer(std::string_view document, const std::string& file) : text_(document), file_(file) {}

    void next();

    TurtleToken kind = TurtleToken::end;
    std::string text;
    std::string local;
    long line = 1;  ///< where the token begins

    [[nodiscard]] bool is_mark(char c) const { return kind == TurtleToken::mark && text[0] == c; }
    /// How an error sentence names the present token.
    [[nodiscard]] std::string shown() const;
    [[noreturn]] void fail(long where, const std::string& sentence) const;

private:
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }
    void read_iri();
    void read_string(char quote);
    void read_escape();
    void read_code_point(std::size_t digits);
    void read_at_word();
    void read_number();
    void read_word();
    [[nodiscard]] std::size_t name_end(std::size_t from, bool is_local) const;
    [[nodiscard]] std::string unescaped_local(std::string_view raw) const;

    std::string_view text_;
    const std::string& file_;
    std::size_t at_ = 0;
    std::size_t begin_ = 0;
    long at_line_ = 1;
};

}  // namespace partonomy::owl
